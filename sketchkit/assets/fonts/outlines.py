"""Outlines of letters, for files that are drawn at any size."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.fonts.files import file_of
from sketchkit.geometry.curves import quadratic_to_cubic

F64 = NDArray[np.float64]
Steps = tuple[str, F64]  # letters M, L, C, Z, and the points that they take, (n, 2)


@lru_cache(maxsize=4096)
def letter_outline(path: str, character: str) -> Steps:
    """Return the outline of a letter of a face, whose size is 1; y runs down from the baseline.

    Returns
    -------
    str
        M begins at a point, L is a line to one, C a cubic curve by two control points to a third,
        Z goes back to the last M.
    (n, 2) float64
        The points.
    """
    font = _font(path)
    pen = _Pen()
    glyph = font.get_nominal_glyph(ord(character)) or 0
    font.draw_glyph(glyph, _draw_functions(), pen)
    points = np.array(pen.points, np.float64).reshape(-1, 2) / font.face.upem
    return "".join(pen.letters), points * (1, -1)


@lru_cache(maxsize=16384)
def exact_advance(path: str, character: str) -> tuple[int, int]:
    """Return how far a letter moves the pen, and the size of a letter, in the font's units."""
    font = _font(path)
    return font.get_glyph_h_advance(font.get_nominal_glyph(ord(character)) or 0), font.face.upem


@lru_cache(maxsize=16384)
def pair_kerning(path: str, first: str, second: str) -> float:
    """Return how much further apart two letters stand than their widths say, for a size of 1."""
    import uharfbuzz

    font = _font(path)
    buffer = uharfbuzz.Buffer()
    buffer.add_str(first + second)
    buffer.guess_segment_properties()
    uharfbuzz.shape(font, buffer, {"kern": True, "liga": False, "clig": False})
    if len(buffer.glyph_positions) != 2:
        return 0.0
    alone = font.get_glyph_h_advance(buffer.glyph_infos[0].codepoint)
    apart: int = buffer.glyph_positions[0].x_advance - alone
    return apart / int(font.face.upem)


class _Pen:
    """Takes down what HarfBuzz draws."""

    def __init__(self) -> None:
        self.letters: list[str] = []
        self.points: list[tuple[float, float]] = []

    def add(self, letter: str, *numbers: float) -> None:
        self.letters.append(letter)
        self.points += zip(numbers[::2], numbers[1::2], strict=True)

    def add_quadratic(self, *numbers: float) -> None:
        control, end = np.array(numbers).reshape(2, 2)
        cubic = quadratic_to_cubic(np.array(self.points[-1]), control, end)
        self.add("C", *cubic[1:].ravel().tolist())


@lru_cache(maxsize=1)
def _draw_functions() -> Any:  # noqa: ANN401 # HarfBuzz ships no types
    import uharfbuzz

    functions = uharfbuzz.DrawFuncs()
    functions.set_move_to_func(lambda x, y, pen: pen.add("M", x, y))
    functions.set_line_to_func(lambda x, y, pen: pen.add("L", x, y))
    functions.set_quadratic_to_func(lambda a, b, x, y, pen: pen.add_quadratic(a, b, x, y))
    functions.set_cubic_to_func(lambda *given: given[-1].add("C", *given[:-1]))
    functions.set_close_path_func(lambda pen: pen.add("Z"))
    return functions


@lru_cache(maxsize=32)
def _font(path: str) -> Any:  # noqa: ANN401 # ditto
    import uharfbuzz  # few sketches write files of outlines

    return uharfbuzz.Font(uharfbuzz.Face(uharfbuzz.Blob.from_file_path(file_of(path))))
