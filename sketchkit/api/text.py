"""Writing text on a canvas. Letters are images of one atlas, tinted with the fill colour."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sketchkit.api.images import IMAGE, Images
from sketchkit.api.typesetting import Typesetting, as_text
from sketchkit.assets.fonts import Line
from sketchkit.core.constants import BOTTOM, CENTER, LEFT, RIGHT, TOP
from sketchkit.core.float32 import ROUND, f32
from sketchkit.core.matrix import translate
from sketchkit.data.wrapping import wrap
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.recorder import ROW, PackError, pack_row8
from sketchkit.geometry.rects import rect_edges

TEXT_USAGE = "text, x, y [, z] | text, x, y, width, height"


class Block(NamedTuple):
    """Lines of text, where they are aligned at, and the baseline of the first."""

    lines: list[str]
    x: float
    y: float


class Text(Typesetting, Images):
    """Writing text."""

    def text(self, what: object, x: float, y: float, *more: float) -> None:
        """Write text in the fill colour.

        Parameters
        ----------
        what : str or number
            A newline begins another line. A float is shown with three decimals.
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
        Source: Processing's reference, text().

        Examples
        --------
        >>> fill(0)
        >>> text("word", 10, 30)
        >>> text("a long text that is wrapped", 10, 40, 80, 50)
        """
        try:
            x, y, *numbers = (f32(number + 0.0) for number in (x, y, *more))
        except TypeError:
            self._refuse("text", (what, x, y, *more), TEXT_USAGE)
        written = as_text(what)
        try:
            if not numbers:
                self._write(self._lines_at(written, x, y))
            elif len(numbers) == 1:
                self._write(self._lines_at(written, x, y), numbers[0])
            elif len(numbers) == 2:
                self._write(self._lines_in_box(written, x, y, *numbers))
            else:
                self._refuse("text", (what, x, y, *more), TEXT_USAGE)
        except PackError:
            self._refuse("text", (what, x, y, *more), TEXT_USAGE)

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

    def _write(self, block: Block, z: float = 0.0) -> None:
        """Record lines of text, always with BLEND, as Processing does."""
        color = self._fill if self._fill >= 0 else ~self._fill  # noFill() does not hold for text
        typography, saved, modelview = self._typeset(), self._stage, self._modelview
        if saved.blend is not Blend.BLEND:
            self._restage(blend=Blend.BLEND)
        if z and self._is_3d:
            self._modelview, self._state = translate(modelview, 0.0, 0.0, z), -1
        set_face = self._set_face()
        part = {LEFT: 0.0, CENTER: 0.5, RIGHT: 1.0}[typography.align_x]
        y = block.y
        for written in block.lines:
            line = set_face.line(written)
            self._pack_line(line, f32(block.x - part * line.width), y, color)
            y = f32(y + typography.leading)
        if self._stage is not saved or self._modelview is not modelview:
            self._stage, self._modelview, self._state = saved, modelview, -1

    def _pack_line(self, line: Line, x: float, y: float, color: int) -> None:
        """Record a line of text, one row for each letter."""
        recorder, textures = self._recorder, self._recorder.textures
        state = self._state if self._state >= 0 else self._note_state()
        rows, end = recorder.rows, recorder.row_end
        while end + ROW * len(line.quads) > len(rows):
            rows.extend(bytes(len(rows)))
        link = len(textures) - 1
        last = textures[-1] if textures else None
        for pixels, left, top, width, height, u1, v1, u2, v2 in line.quads:
            if pixels is not last:
                textures.append(pixels)
                last, link = pixels, link + 1
            # In 32 bits, as Processing: P2D rounds corners up, and each last bit may be a pixel.
            x1, y1 = x + left, y + top
            a, b = x1 * ROUND, y1 * ROUND
            x1, y1 = a - (a - x1), b - (b - y1)
            pack_row8(
                rows, end, IMAGE, state, color, color, 0.0, link,
                x1, y1, x1 + width, y1 + height, u1, v1, u2, v2,
            )  # fmt: skip # the row, and its numbers
            end += ROW
        recorder.row_end = end


def _height(lines: list[str], leading: float) -> float:
    """Return the distance from the first baseline to the last; summed up, as Processing does."""
    height = 0.0
    for _ in lines[1:]:
        height = f32(height + leading)
    return height
