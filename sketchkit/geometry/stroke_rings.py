"""The outline of a wide stroke as one ring for each line: for strokes whose overlaps would show.

What is inside by the non-zero rule is the stroke. The corners come in the order, and with the
colours, of Processing's own stroker: where colours vary along a line, both show in the triangles.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import MITER, PROJECT, ROUND
from sketchkit.geometry.strokes import (
    Joints,
    Pieces,
    Polylines,
    Weights,
    cap_fans,
    join_fans,
    joints_of,
    offsets_of,
)

F32 = NDArray[np.float32]
I64 = NDArray[np.int64]
Corner = tuple[float, float, int]  # x, y, and the point that gives the colour


def stroke_rings(
    lines: Polylines, weights: Weights, cap: int, join: int
) -> tuple[F32, F32, I64, list[int]]:
    """Return a ring around each line's stroke.

    Returns
    -------
    x, y : (p,) float32
    sources : (p,) int64
        Which point (of all lines, end to end) each corner takes its colour from.
    lengths : list of int
        How many corners each ring has.
    """
    offsets = offsets_of(lines, weights)
    joints = joints_of(lines, *offsets)
    fans = None if joints is None else join_fans(joints, weights, join)
    caps = [cap_fans(lines, *offsets, weights, cap, at_end=at_end) for at_end in (False, True)]
    count = lines.x.shape[1]
    corners: list[Corner] = []
    lengths = []
    for line in range(len(lines.x)):
        walk = _Walk(lines, line, offsets, joints, fans)
        if lines.is_closed:
            ring = walk.closed(joins_are_mitered=join == MITER)
        else:
            rims = [_rim(pieces, line) if cap in (ROUND, PROJECT) else [] for pieces in caps]
            ring = walk.open(*rims)
        corners += [(x, y, point + line * count) for x, y, point in ring]
        lengths.append(len(ring))
    x, y, sources = (np.array(column) for column in zip(*corners, strict=True))
    return x.astype(np.float32), y.astype(np.float32), sources, lengths


def _rim(fans: Pieces, row: int) -> list[Corner]:
    """Return the rim of one fan, between its first and its last corner."""
    point = int(fans.points[row, 0])
    rim = zip(fans.x[row, 1:].tolist(), fans.y[row, 1:].tolist(), strict=True)
    return [(x, y, point) for x, y in list(dict.fromkeys(rim))[1:-1]]


class _Walk:
    """Goes along both sides of one line."""

    def __init__(
        self,
        lines: Polylines,
        line: int,
        offsets: tuple[F32, F32],
        joints: Joints | None,
        fans: Pieces | None,
    ) -> None:
        self.x, self.y = lines.x[line].tolist(), lines.y[line].tolist()
        self.offset_x, self.offset_y = offsets[0][line].tolist(), offsets[1][line].tolist()
        self.count = len(self.x)
        self.sides: list[float] = [] if joints is None else joints.side[line].tolist()
        self.first_joint = 0 if lines.is_closed else 1
        self.fans = fans
        self.fan_row = line * len(self.sides)

    def at(self, point: int, segment: int, sign: int) -> Corner:
        """Return the corner beside a point, across a segment."""
        x, y = self.offset_x[segment], self.offset_y[segment]
        return self.x[point] + sign * x, self.y[point] + sign * y, point

    def joint(self, point: int) -> tuple[int, list[Corner]]:
        """Return the outer side of a joint, and what is between its two corners there."""
        index = point - self.first_joint
        assert self.fans is not None
        return int(self.sides[index]), _rim(self.fans, self.fan_row + index)

    def both_sides(self) -> tuple[list[Corner], list[Corner]]:
        """Return the corners left and right, from the first point to the last.

        On the outer side of a joint they follow its fan, on the inner one they pass its centre.
        """
        chains: dict[int, list[Corner]] = {1: [self.at(0, 0, 1)], -1: [self.at(0, 0, -1)]}
        for point in range(1, self.count - 1):
            outer, between = self.joint(point)
            for sign, chain in chains.items():
                chain.append(self.at(point, point - 1, sign))
                chain += between if sign == outer else [(self.x[point], self.y[point], point)]
                chain.append(self.at(point, point, sign))
        last = self.count - 1
        for sign, chain in chains.items():
            chain.append(self.at(last, last - 1, sign))
        return chains[1], chains[-1]

    def open(self, start: list[Corner], end: list[Corner]) -> list[Corner]:
        """Return the ring of an open line, its caps given."""
        left, right = self.both_sides()
        return [*left, *end, *right[::-1], *start]

    def closed(self, *, joins_are_mitered: bool) -> list[Corner]:
        """Return the ring of a closed line: all round one side, and back along the other.

        The tips of the last two miters take the colour of the point before, as in Processing.
        """
        left, right = self.both_sides()
        last = self.count - 1
        outer, between = self.joint(last)
        (left if outer == 1 else right).extend(
            _recolored(between, last - 1) if joins_are_mitered else between
        )
        outer, between = self.joint(0)
        if joins_are_mitered:
            between = _recolored(between, last)
        left += [self.at(last, last, 1), self.at(0, last, 1)]
        left += between if outer == 1 else []
        back = [self.at(0, 0, 1), self.at(0, 0, -1)]
        back += between[::-1] if outer == -1 else []
        back += [self.at(0, last, -1), self.at(last, last, -1)]
        return [*left, *back, *right[::-1]]


def _recolored(corners: list[Corner], point: int) -> list[Corner]:
    return [(x, y, point) for x, y, _ in corners]
