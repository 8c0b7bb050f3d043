"""Writing text on a canvas: what it shows of a value, and where its lines begin."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sketchkit.api.font_choice import FontChoice
from sketchkit.api.lettering import Block, Lettering
from sketchkit.api.typesetting import as_text, characters
from sketchkit.core.constants import BOTTOM, CENTER, LEFT, RIGHT, TOP
from sketchkit.core.float32 import f32
from sketchkit.data.wrapping import wrap
from sketchkit.draw.recorder import PackError
from sketchkit.geometry.rects import rect_edges

TEXT_USAGE = "text, x, y [, z] | text, x, y, width, height | characters, start, stop, x, y [, z]"


class Text(Lettering, FontChoice):
    """Writing text, and everything for it."""

    def text(self, what: object, x: float, y: float, *more: float) -> None:
        r"""Write text in the fill colour.

        Parameters
        ----------
        what : str or number
            A newline begins another line. A float is shown with three decimals, and any other
            object as `print()` shows it.
        x, y : float, pixels
            Where the text begins on its baseline, unless `textAlign()` says otherwise.
        *more : 1 or 2 float, optional
            One number is z. Two make a box of the four, which `rectMode()` gives their meaning:
            text is wrapped in it, and lines that do not fit are left out.

        Raises
        ------
        SketchError
            If there are not 2, 3 or 4 numbers.

        See Also
        --------
        textSize, textAlign, textWidth, textFont

        Notes
        -----
        A list of characters is written from one place in it to another, `text(characters, start,
        stop, x, y)`. What the font has no letter for leaves a gap. Source: Processing's reference,
        text().

        Examples
        --------
        >>> fill(0)
        >>> text("word", 10, 30)
        >>> text("a long text that is wrapped", 10, 40, 80, 50)
        >>> text(["a", "b", "c"], 0, 2, 60, 30)
        """
        if len(more) > 1 and not isinstance(what, str) and isinstance(what, Sequence):
            self._write_characters(what, x, y, *more)
            return
        try:
            x, y, *numbers = (f32(number + 0.0) for number in (x, y, *more))
        except TypeError:
            self._refuse("text", (what, x, y, *more), TEXT_USAGE)
        written = as_text(what)
        try:
            if len(numbers) < 2:
                self._write(self._lines_at(written, x, y), *numbers)
            elif len(numbers) == 2:
                self._write(self._lines_in_box(written, x, y, *numbers))
            else:
                self._refuse("text", (what, x, y, *more), TEXT_USAGE)
        except PackError:
            self._refuse("text", (what, x, y, *more), TEXT_USAGE)

    def _write_characters(
        self, what: Sequence[object], start: float, stop: float, *place: float
    ) -> None:
        """Write some characters of a list."""
        if len(place) > 3:
            self._refuse("text", (what, start, stop, *place), TEXT_USAGE)
        self.text(characters("text", what, start, stop), *place)

    def _lines_at(self, written: str, x: float, y: float) -> Block:
        """Return the lines of a text, aligned at a point."""
        lines = written.split("\n")
        below_first = _height(lines, self._typeset().leading)
        align = self._typography.align_y
        if align == CENTER:
            y += f32(self.textAscent() - below_first) / 2
        elif align == TOP:
            y += self.textAscent()
        elif align == BOTTOM:
            y -= f32(self.textDescent() + below_first)
        return Block(lines, x, f32(y))

    def _lines_in_box(self, written: str, a: float, b: float, c: float, d: float) -> Block:
        """Return the lines of a text that fit into a box, aligned in it."""
        typography = self._typeset()
        box = rect_edges(self._style.rect_mode, np.array([[a, b, c, d]], np.float32))
        left, top, right, bottom = (float(edge[0]) for edge in box)
        width, height = f32(right - left), f32(bottom - top)
        ascent, descent, leading = self.textAscent(), self.textDescent(), typography.leading
        lines = wrap(written, width, self._set_face().width)
        if leading > 0:
            room = f32(f32(height - f32(ascent + descent)) / leading)
            del lines[max(0, 1 + math.floor(room)) :]
        x = {LEFT: left, CENTER: f32(left + width / 2), RIGHT: right}[typography.align_x]
        below_first = f32(leading * (len(lines) - 1))
        y = f32(top + ascent)
        if typography.align_y == CENTER:
            y += f32(height - f32(ascent + below_first)) / 2
        elif typography.align_y == BOTTOM:
            y = f32(bottom - descent) - below_first
        return Block(lines, x, f32(y))


def _height(lines: list[str], leading: float) -> float:
    """Return the distance from the first baseline to the last; summed up, as Processing does."""
    height = 0.0
    for _ in lines[1:]:
        height = f32(height + leading)
    return height
