"""Shapes given as arrays: what files and tessellations are made into."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import NDArray

from sketchkit.api._parts import CanvasParts
from sketchkit.api.pshape_corners import ShapeCorners
from sketchkit.api.pshape_parts import Family
from sketchkit.core import constants as c
from sketchkit.draw.recorder import (
    CORNER_DTYPE,
    ROW,
    Attributes,
    Kind,
    ShapeRun,
    pack_row0,
)
from sketchkit.draw.resources import Texture
from sketchkit.draw.tessellation import BulkCorners


class ShapeInBulk(ShapeCorners):
    """Recording many corners at once, as if they had come one by one."""

    @classmethod
    def _empty(cls, canvas: CanvasParts, family: Family) -> Self:
        """Return a shape of a canvas in which nothing is yet."""
        return cls(canvas, family)

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
        recorder, count = self._recorder, len(corners.places)
        is_filled = kind not in (c.LINES, c.POINTS)
        if corners.colors is not None:
            if is_filled:
                self._stroke = min(self._stroke, ~self._stroke)
            else:
                self._fill = min(self._fill, ~self._fill)
        table = np.zeros(count, CORNER_DTYPE)
        table["place"] = corners.places
        table["fill"], table["stroke"] = self._fill, self._stroke
        if corners.colors is not None:
            table["fill" if is_filled else "stroke"] = corners.colors
        table["attributes"] = self._weighted_attributes(corners)
        recorder.corners[:] = table.tobytes()
        recorder.corner_end = len(recorder.corners)
        if corners.uvs is not None:
            recorder.uvs[:] = np.ascontiguousarray(corners.uvs, np.float32).tobytes()
            recorder.uv_end = len(recorder.uvs)
        if corners.normals is not None:
            recorder.normals = np.ascontiguousarray(corners.normals, np.float32)
        self._kind = kind
        has_normals = corners.normals is not None
        first_uv = None if corners.uvs is None else 0
        run = ShapeRun(kind, 0, count, is_closed, contours, first_uv, texture, has_normals)
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
