"""Fans and strips: which triangle gives each corner of a polygon the normal that it lacks.

GLU hands triangles over in groups as large as it finds them: fans, strips, and single triangles.
Corners that groups share become one corner for each, and Processing computes normals for these:
each of them takes the normal of the last triangle of its group that it is part of.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.geometry.polygons import Triangle, Winding, fill_monotone, project
from sketchkit.geometry.sweep_order import OrderedSweep

F64 = NDArray[np.float64]
I32 = NDArray[np.int32]

Edge = tuple[int, int]  # from one point to another, its triangle on the left

# From triangle to triangle: whether the edge keeps its first point as it turns, again and again.
FAN = (True,)
STRIP = (False, True)
STRIP_BACK = (True, False)


class _Group(NamedTuple):
    """A fan or strip that begins at `start`; a single triangle if its size is 1."""

    size: int
    start: Edge
    turns: tuple[bool, ...] = FAN


def normal_givers(
    points: F64, ring_lengths: Sequence[int], winding: Winding = Winding.NONZERO
) -> I32:
    """Return for each corner of the triangles of `tessellate()` whose normal it has.

    Parameters
    ----------
    points, ring_lengths, winding
        As for `tessellate()`.

    Returns
    -------
    (m, 3) int32
        Rows of its triangles.
    """
    sweep = OrderedSweep(project(points, ring_lengths), len(points), winding.is_inside)
    sweep.run()
    triangles: list[Triangle] = []
    bounds = [0]
    begun: list[Triangle] = []  # each from the edge that GLU goes out from
    for corners in sweep.regions:
        fill_monotone(corners, triangles)
        begun += triangles[bounds[-1] :]
        is_single = len(triangles) == bounds[-1] + 1
        start = corners[-1][1] if is_single else triangles[-2][1]
        begun[-1] = _rotated(begun[-1], start)
        bounds.append(len(triangles))
    order = [row for region in sweep.order() for row in range(*bounds[region : region + 2])]
    givers = np.arange(len(triangles), dtype=np.int32).repeat(3).reshape(-1, 3)
    faces = _Faces(begun)
    for row in order:
        if not faces.is_taken[row]:
            _take(faces.largest_group(row), faces, triangles, givers)
    return givers


def _rotated(triangle: Triangle, start: int) -> Triangle:
    a, b, c = triangle
    return triangle if start == a else (b, c, a) if start == b else (c, a, b)


def _take(group: _Group, faces: _Faces, triangles: list[Triangle], givers: I32) -> None:
    """Take the triangles of a group, and enter the givers of their corners."""
    rows, tips, _ = faces.walk(group.start, group.turns)
    points = [*group.start, *tips]
    is_fan = group.turns is FAN
    spots = [(0 if is_fan else i, i + 1, i + 2) for i in range(len(rows))]
    last = {spot: row for row, three in zip(rows, spots, strict=True) for spot in three}
    for row, three in zip(rows, spots, strict=True):
        for spot in three:
            givers[row, triangles[row].index(points[spot])] = last[spot]


class _Faces:
    """Triangles by their edges, and which of them are in a group."""

    def __init__(self, triangles: list[Triangle]) -> None:
        self.is_taken = [False] * len(triangles)
        self._triangles = triangles
        self._by_edge: dict[Edge, tuple[int, int]] = {}  # row and tip of the triangle to its left
        for row, (a, b, c) in enumerate(triangles):
            self._by_edge[a, b] = row, c
            self._by_edge[b, c] = row, a
            self._by_edge[c, a] = row, b

    def largest_group(self, row: int) -> _Group:
        """Return the largest fan or strip with a triangle; of equal ones, the first."""
        a, b, c = self._triangles[row]
        edges = [(a, b), (b, c), (c, a)]
        groups = [_Group(1, (a, b)), *map(self._fan, edges), *map(self._strip, edges)]
        return max(groups, key=lambda group: group.size)

    def walk(
        self, edge: Edge, turns: tuple[bool, ...], *, is_back: bool = False
    ) -> tuple[list[int], list[int], Edge]:
        """Take free triangles from an edge on: to its left, or to its right.

        Returns
        -------
        list of int
            The triangles.
        list of int
            The third point of each.
        Edge
            The one behind the last triangle.
        """
        rows: list[int] = []
        tips: list[int] = []
        for keeps_first in cycle(turns):
            row, tip = self._by_edge.get(edge[::-1] if is_back else edge, (-1, -1))
            if row < 0 or self.is_taken[row]:
                break
            self.is_taken[row] = True
            rows.append(row)
            tips.append(tip)
            edge = (edge[0], tip) if keeps_first else (tip, edge[1])
        return rows, tips, edge

    def _fan(self, edge: Edge) -> _Group:
        """Return the largest fan around the first point of an edge, its left triangle in it."""
        rows, _, _ = self.walk(edge, FAN)
        rows_back, _, start = self.walk(edge, FAN, is_back=True)
        self._free(rows + rows_back)
        return _Group(len(rows) + len(rows_back), start, FAN)

    def _strip(self, edge: Edge) -> _Group:
        """Return the largest strip across an edge, with the triangle to its left.

        The triangles of a strip turn left and right by turns. To begin with the right turn, there
        must be an even number of them up to the edge, or the strip begins one later.
        """
        rows, _, end = self.walk(edge, STRIP)
        rows_back, _, start = self.walk(edge, STRIP_BACK, is_back=True)
        self._free(rows + rows_back)
        size = len(rows) + len(rows_back)
        if len(rows) % 2 == 0:
            return _Group(size, end[::-1], STRIP)
        if len(rows_back) % 2 == 0:
            return _Group(size, start, STRIP)
        return _Group(size - 1, (start[0], self._by_edge[start][1]), STRIP)

    def _free(self, rows: list[int]) -> None:
        for row in rows:
            self.is_taken[row] = False
