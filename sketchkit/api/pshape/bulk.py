"""Shapes given as arrays: what files and tessellations are made into."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import NDArray

from sketchkit.api.pshape.corners import ShapeCorners
from sketchkit.api.pshape.parts import Family
from sketchkit.core import constants as c
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.recorder import (
    CORNER_DTYPE,
    ROW,
    Attributes,
    Kind,
    ShapeRun,
    pack_row0,
)
from sketchkit.draw.resources import Texture
from sketchkit.draw.tessellation import BulkCorners, tessellate_parts


class ShapeInBulk(ShapeCorners):
    """Recording many corners at once, as if they had come one by one."""

    def _new(self, family: Family) -> Self:
        """Return another shape of the same canvas, in which nothing is yet."""
        raise NotImplementedError

    def _fill_in_bulk(
        self,
        kind: int,
        corners: BulkCorners,
        texture: Texture | None = None,
        contours: tuple[int, ...] = (),
        *,
        is_closed: bool = False,
    ) -> None:
        """Record one `beginShape(kind)` … `endShape()`.

        What is filled has no outline, and lines and points are not filled, unless the corners
        leave the colours to the shape.
        """
        is_filled = kind not in (c.LINES, c.POINTS)
        if corners.colors is not None:
            on, off = ("_fill", "_stroke") if is_filled else ("_stroke", "_fill")
            setattr(self, on, max(getattr(self, on), ~getattr(self, on)))
            setattr(self, off, min(getattr(self, off), ~getattr(self, off)))
        self._put_corners(corners, "fill" if is_filled else "stroke")
        count = len(corners.places)
        self._put_run(kind, 0, count, texture, contours, is_closed=is_closed)

    def _put_corners(self, corners: BulkCorners, colored: str) -> None:
        """Record corners, whose own colours are for what is filled, or for the stroke."""
        recorder = self._recorder
        table = np.zeros(len(corners.places), CORNER_DTYPE)
        table["place"] = corners.places
        table["fill"], table["stroke"] = self._fill, self._stroke
        if corners.colors is not None:
            table[colored] = corners.colors
        table["attributes"] = self._weighted_attributes(corners)
        recorder.corners[:] = table.tobytes()
        recorder.corner_end = len(recorder.corners)
        if corners.uvs is not None:
            recorder.uvs[:] = np.ascontiguousarray(corners.uvs, np.float32).tobytes()
            recorder.uv_end = len(recorder.uvs)
        if corners.normals is not None:
            recorder.normals = np.ascontiguousarray(corners.normals, np.float32)

    def _put_run(
        self,
        kind: int,
        first: int,
        count: int,
        texture: Texture | None = None,
        contours: tuple[int, ...] = (),
        *,
        is_closed: bool = False,
    ) -> None:
        """Record what is made of some of the corners."""
        recorder = self._recorder
        self._kind = kind
        has_normals = recorder.normals is not None
        first_uv = first if recorder.uv_end else None
        run = ShapeRun(kind, first, count, is_closed, contours, first_uv, texture, has_normals)
        recorder.shapes.append(run)
        fill = self._fill if texture is None else max(self._fill, 0)
        recorder.make_room()
        pack_row0(
            recorder.rows,
            recorder.row_end,
            Kind.SHAPE,
            self._note_state(),
            fill,
            self._stroke,
            self._weight,
            len(recorder.shapes) - 1,
        )
        recorder.row_end += ROW

    def _cut_out(self, kind: int, first: int, count: int) -> Self:
        """Return a shape of some of the corners, in the look that this one has now."""
        piece = self._new(self._family)
        piece._take_look(self)
        piece._stage, piece._put_aside = self._stage, self._put_aside
        piece._texture_source = self._texture_source
        mine, its = self._recorder, piece._recorder
        cut = slice(first, first + count)
        its.attributes = list(mine.attributes)
        its.corners[:] = mine.corner_array()[cut].tobytes()
        its.corner_end = len(its.corners)
        if mine.uv_end:
            its.uvs[:] = mine.uv_array()[cut].tobytes()
            its.uv_end = len(its.uvs)
        if mine.normals is not None:
            its.normals = mine.normals[cut].copy()
        piece._put_run(kind, 0, count, self._current_texture(), is_closed=True)
        return piece

    def _weighted_attributes(self, corners: BulkCorners) -> NDArray[np.int64] | int:
        """Return the entry of the recorder's attributes for each corner."""
        entries, material = self._recorder.attributes, self._style.material
        if corners.weights is None or not len(corners.weights):
            entries.append(Attributes(self._normal, material, self._weight))
            return 0
        weights, entry = np.unique(corners.weights, return_inverse=True)
        entries += [Attributes(self._normal, material, weight) for weight in weights.tolist()]
        self._weight = float(weights[0])
        return entry

    def _become_triangles(self) -> None:
        """Be what the fill is drawn with, corner by corner, without an outline."""
        parts = [(part, IDENTITY) for part in self._up_to_date(self._canvas)]
        triangles = [corners for kind, corners in tessellate_parts(parts) if kind == c.TRIANGLES]
        texture = self._current_texture()
        self._family = Family.GEOMETRY
        self._recorder.clear()
        self._state = -1
        if triangles:
            self._fill_in_bulk(c.TRIANGLES, triangles[0], texture)
        self._expand_anew()
