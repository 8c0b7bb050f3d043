"""The tables of PLY files that are text."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.models.data import broken, starts
from sketchkit.assets.models.number_rows import is_number, not_a_number
from sketchkit.assets.models.ply_header import Element, Header
from sketchkit.assets.models.ply_table import Numbers, Table, ends_early

F64 = NDArray[np.float64]


def read_text_tables(path: Path, data: bytes, header: Header) -> dict[str, Table]:
    """Return the tables of a file by their names.

    Raises
    ------
    SketchError
        If the data ends too early, or holds something that is no number.
    """
    lines = data[header.end :].splitlines()
    last = header.lines + len(lines)
    numbered = enumerate(lines, header.lines + 1)
    filled = ((line, words) for line, text in numbered if (words := text.split()))
    return {element.name: _text_table(path, filled, element, last) for element in header.elements}


def _text_table(
    path: Path, filled: Iterator[tuple[int, list[bytes]]], element: Element, last: int
) -> Table:
    """Return a table from the next lines with words in them."""
    if not element.properties:
        return Table(element.count)
    rows = list(islice(filled, element.count))
    lines = [line for line, _ in rows]
    if len(rows) < element.count:
        raise ends_early(path, f"line {last}", element, len(rows))
    table = Table(len(rows), rows=lines)
    numbers = _numbers(path, rows)
    ends = starts([len(words) for _, words in rows])
    at, ends = ends[:-1].copy(), ends[1:]
    for wanted in element.properties:
        _check_lengths(path, lines, at < ends)
        if wanted.count is None:
            table.scalars[wanted.name] = _of_type(numbers[at], wanted.type)
            at += 1
            continue
        lengths = _of_type(numbers[at], np.dtype(np.int32)).astype(np.int64)
        at += 1
        _check_lengths(path, lines, (lengths >= 0) & (at + lengths <= ends))
        places = np.repeat(at - starts(lengths)[:-1], lengths) + np.arange(lengths.sum())
        table.lists[wanted.name] = lengths, _of_type(numbers[places], wanted.type)
        at += lengths
    return table


def _numbers(path: Path, rows: list[tuple[int, list[bytes]]]) -> F64:
    """Return all numbers of rows one after another."""
    try:
        return np.array([float(word) for _, words in rows for word in words], np.float64)
    except ValueError:
        for line, words in rows:
            for word in words:
                if not is_number(word):
                    raise not_a_number(path, line, word) from None
        raise


def _check_lengths(path: Path, lines: list[int], is_right: NDArray[np.bool_]) -> None:
    if not is_right.all():
        line = lines[int(np.argmin(is_right))]
        raise broken(path, f"line {line}", "there are fewer numbers than the header says")


def _of_type(numbers: F64, kind: np.dtype[np.generic]) -> Numbers:
    """Return numbers as the header says; what is too large for a whole number is its largest."""
    if kind.kind == "f":
        with np.errstate(over="ignore"):
            return numbers.astype(kind)
    limits = np.iinfo(kind.str)
    return np.clip(np.nan_to_num(numbers), limits.min, limits.max).astype(kind)
