"""Putting lines of text on a canvas: as images of letters, as Java would, or as shapes."""

from __future__ import annotations

import math
from typing import NamedTuple

from sketchkit.api.images import Images
from sketchkit.api.typesetting import Typesetting
from sketchkit.api.vertices import Vertices
from sketchkit.assets.fonts.faces import LARGEST, NOTICEABLE, Face, Line, enlarged_size, fonts_of
from sketchkit.assets.fonts.glyph_outlines import rings, whole_parts
from sketchkit.assets.fonts.letters import letters_of
from sketchkit.core.constants import CENTER, CLOSE, LEFT, RIGHT, SHAPE
from sketchkit.core.float32 import ROUND, f32
from sketchkit.core.matrix import IDENTITY, scale, translate
from sketchkit.core.notices import warn_once
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.recorder import ROW, Kind, pack_row8
from sketchkit.geometry.enlargement import enlargement

LETTER = Kind.LETTER.value
PARTS = {LEFT: 0.0, CENTER: 0.5, RIGHT: 1.0}  # of a line, that are left of the point it is set at
POINT = 1 / 64  # px: Java rounds the points of outlines so


class Block(NamedTuple):
    """Lines of text, where they are aligned at, and the baseline of the first."""

    lines: list[str]
    x: float
    y: float


class Lettering(Typesetting, Images, Vertices):
    """Lines of text."""

    def _write(self, block: Block, z: float = 0.0) -> None:
        """Draw lines of text."""
        modelview = self._modelview
        if z and self._is_3d:
            self._modelview, self._state = translate(modelview, 0.0, 0.0, z), -1
        if self._typography.mode == SHAPE and self._has_outlines():
            self._write_shapes(block)
        else:
            self._write_images(block)
        if self._modelview is not modelview:
            self._modelview, self._state = modelview, -1

    def _write_images(self, block: Block) -> None:
        """Draw letters as images; in P2D and P3D always with BLEND, as Processing does."""
        color = self._fill if self._fill >= 0 else ~self._fill  # noFill() does not hold for text
        saved = self._stage
        if saved.is_java2d and self._is_scalable():
            self._write_as_java(block, color)
            return
        if saved.blend is not Blend.BLEND:
            self._restage(blend=Blend.BLEND)
        self._write_lines(block, color)
        if self._stage is not saved:
            self._stage, self._state = saved, -1

    def _is_scalable(self) -> bool:
        return letters_of(self._typeset().face).own_size is None

    def _write_lines(self, block: Block, color: int) -> None:
        """Draw lines whose letters are enlarged, unless a transform enlarges them further."""
        typography, measured = self._typeset(), self._set_face()
        face = self._drawn_face(measured, block)
        part = PARTS[typography.align_x]
        y = block.y
        for written in block.lines:
            # Whatever is drawn, the letters find their places beside one another as in Processing:
            # where text is made smaller, its neighbours in the image show.
            line = measured.line(written)
            x = f32(block.x - part * line.width)
            self._pack_line(line if face is measured else face.line(written), x, y, color)
            y = f32(y + typography.leading)

    def _drawn_face(self, measured: Face, block: Block) -> Face:
        """Return the face that lines are drawn in: made anew where a transform enlarges them."""
        larger = self._enlargement(block.x, block.y)
        if larger < NOTICEABLE or not self._is_scalable():
            return measured
        drawn_at = enlarged_size(measured.setting.made_at, larger)
        return fonts_of(self._renderer).set(measured.setting._replace(drawn_at=drawn_at))

    def _enlargement(self, x: float, y: float) -> float:
        """Return how many pixels of the screen a unit of the sketch is long, at a place."""
        if self._modelview is IDENTITY and not self._is_3d:
            return float(self._target.density)
        screen = self._target.width, self._target.height
        return enlargement(self._modelview, self._stage.projection, screen, x, y)

    def _write_as_java(self, block: Block, color: int) -> None:
        """Draw lines as JAVA2D does: letters of their size on the screen, at whole pixels."""
        typography, measured, modelview = self._typography, self._set_face(), self._modelview
        larger = self._enlargement(block.x, block.y)
        if not 0 < larger < math.inf or math.isnan(block.x + block.y):
            return
        face = self._java_face(measured, larger)
        part = PARTS[typography.align_x]
        y = block.y
        for written in block.lines:
            x = f32(block.x - part * measured.width(written))
            # Java's way to whole numbers: half a pixel more, and what is behind the point is cut.
            begin = translate(modelview, int(x + 0.5), int(y + 0.5))
            a, b, _, left, d, e, _, top, *_ = begin
            if b or d or a != e or a < 0:
                self._modelview, self._state = scale(begin, 1 / larger, 1 / larger), -1
                self._pack_line(face.line(written), 0.0, 0.0, color)
            else:
                density = self._target.density
                in_pixels = IDENTITY if density == 1 else scale(IDENTITY, 1 / density, 1 / density)
                if modelview is not in_pixels:
                    self._modelview, self._state = in_pixels, -1
                left, top = left * density, top * density
                self._pack_line(face.line(written), int(left + 0.5), int(top + 0.5), color)
            y = f32(y + typography.leading)

    def _java_face(self, measured: Face, larger: float) -> Face:
        """Return the face of JAVA2D's letters: at their size on the screen, in its pixels."""
        size = f32(measured.setting.size * larger)
        # Whether letters are smooth the canvas decides, and not the font.
        typeface = measured.setting.typeface._replace(is_smooth=self._target.samples > 1)
        drawn_at = min(max(size, 1.0), LARGEST)
        return fonts_of(self._renderer).set(
            measured.setting._replace(typeface=typeface, size=size, drawn_at=drawn_at)
        )

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
                rows, end, LETTER, state, color, color, 0.0, link,
                x1, y1, x1 + width, y1 + height, u1, v1, u2, v2,
            )  # fmt: skip # the row, and its numbers
            end += ROW
        recorder.row_end = end

    def _has_outlines(self) -> bool:
        """Return whether text is drawn as shapes, or say why not."""
        if self._stage.is_java2d:
            return False  # it has no such mode; its letters are as crisp
        if not self._is_scalable():
            warn_once("textMode(SHAPE) has no effect on a .vlw font: it has no outlines.")
            return False
        return True

    def _write_shapes(self, block: Block) -> None:
        """Draw letters as filled shapes, without strokes."""
        typography, face = self._typeset(), self._set_face()
        saved_stroke, self._stroke = self._stroke, NO_COLOR
        part = PARTS[typography.align_x]
        y = block.y
        for written in block.lines:
            x = f32(block.x - part * face.width(written))
            for character in written:
                self._draw_shape(character, x, y)
                x = f32(x + face.advance(character))
            y = f32(y + typography.leading)
        self._stroke = saved_stroke

    def _draw_shape(self, character: str, x: float, y: float) -> None:
        """Draw a letter's outline, with the pen at a place."""
        face, size = self._typography.face, self._typography.size
        parts = whole_parts(self._bezier_detail)[:-1]  # Processing leaves out the ends of curves
        outline = rings(face.path, character, parts)
        if not outline:
            return
        self.beginShape()
        for i, ring in enumerate(outline):
            if i:
                self.beginContour()
            for across, down in (ring * size / POINT).round().tolist():
                self.vertex(x + across * POINT, y + down * POINT)
            if i:
                self.endContour()
        self.endShape(CLOSE)
