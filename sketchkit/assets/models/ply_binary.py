"""The tables of PLY files that are bytes.

Rows of one length are read at once, others one by one.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sketchkit.assets.models.data import broken
from sketchkit.assets.models.ply_header import Element, Header, Property
from sketchkit.assets.models.ply_table import Table, ends_early

Rows = np.ndarray[tuple[int], np.dtype[np.void]]


def read_binary_tables(path: Path, data: bytes, header: Header) -> dict[str, Table]:
    """Return the tables of a file by their names.

    Raises
    ------
    SketchError
        If the data ends too early.
    """
    tables = {}
    at = header.end
    for element in header.elements:
        tables[element.name], at = _table(path, data, at, element)
    return tables


def _table(path: Path, data: bytes, at: int, element: Element) -> tuple[Table, int]:
    """Return the table that begins at a byte, and where it ends."""
    row = _row_like_first(data, at, element)
    has_lists = any(wanted.count is not None for wanted in element.properties)
    if row is not None and (end := at + element.count * row.itemsize) <= len(data):
        if not row.itemsize:
            return Table(element.count), at
        rows = np.frombuffer(data, row, element.count, at)
        if _are_alike(rows, element):
            return _table_of_rows(rows, element), end
    if row is None or has_lists:
        return _table_row_by_row(path, data, at, element)
    raise ends_early(path, f"byte {len(data)}", element, (len(data) - at) // row.itemsize)


def _row_like_first(data: bytes, at: int, element: Element) -> np.dtype[np.void] | None:
    """Return the layout of rows whose lists are as long as those of the first row, if it is whole.

    Field `3` is property 3; if that is a list, field `n3` is its length.
    """
    fields: list[tuple[str, np.dtype[np.generic], tuple[int, ...]]] = []
    for number, wanted in enumerate(element.properties):
        if wanted.count is None:
            fields.append((str(number), wanted.type, ()))
            at += wanted.type.itemsize
            continue
        length = _list_length(data, at, wanted)
        at += wanted.count.itemsize + length * wanted.type.itemsize
        if length < 0 or at > len(data):
            return None
        fields.append((f"n{number}", wanted.count, ()))
        fields.append((str(number), wanted.type, (length,)))
    return np.dtype(fields)


def _list_length(data: bytes, at: int, wanted: Property) -> int:
    """Return the length that stands before a list; -1 where the file has ended."""
    kind = wanted.count
    if kind is None or at + kind.itemsize > len(data):
        return -1
    return int(np.frombuffer(data, kind, 1, at)[0])


def _are_alike(rows: Rows, element: Element) -> bool:
    """Return whether all lists of a property are as long as the layout has them."""
    return all(
        bool((rows[f"n{number}"] == rows[str(number)].shape[1]).all())
        for number, wanted in enumerate(element.properties)
        if wanted.count is not None
    )


def _table_of_rows(rows: Rows, element: Element) -> Table:
    table = Table(len(rows))
    for number, wanted in enumerate(element.properties):
        column = rows[str(number)]
        if wanted.count is None:
            table.scalars[wanted.name] = column
        else:
            lengths = np.full(len(rows), column.shape[1], np.int64)
            table.lists[wanted.name] = lengths, column.reshape(-1)
    return table


def _table_row_by_row(path: Path, data: bytes, at: int, element: Element) -> tuple[Table, int]:
    """Return a table whose rows differ in length; where one begins shows only in the one before."""
    pieces: list[list[bytes]] = [[] for _ in element.properties]
    lengths: list[list[int]] = [[] for _ in element.properties]
    for row in range(element.count):
        for number, wanted in enumerate(element.properties):
            length = 1
            if wanted.count is not None:
                length = _list_length(data, at, wanted)
                lengths[number].append(length)
                at += wanted.count.itemsize
            end = at + length * wanted.type.itemsize
            if max(at, end) > len(data):
                raise ends_early(path, f"byte {len(data)}", element, row)
            if length < 0:
                raise broken(path, f"byte {at}", "a list has a length below 0")
            pieces[number].append(data[at:end])
            at = end
    table = Table(element.count)
    for number, wanted in enumerate(element.properties):
        values = np.frombuffer(b"".join(pieces[number]), wanted.type)
        if wanted.count is None:
            table.scalars[wanted.name] = values
        else:
            table.lists[wanted.name] = np.array(lengths[number], np.int64), values
    return table, at
