"""Strokes of P2D: polylines to triangles, with caps and joins.

A thin stroke (under 2 pixels) is one quad for each segment. A wide one is the union of
  - two quads for each segment, one on either side of it, and
  - a fan around each joint and each end, whose rim is the join or the cap.
All pieces share whole edges, so that no sample between them is missed. Source: what Processing's
own stroker (Java2D's "pisces") outlines, measured and read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import BEVEL, PROJECT, ROUND

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
F64 = NDArray[np.float64]
I64 = NDArray[np.int64]
Weights = float | F32  # of all lines, or of each, (n, 1); pixels

MITER_LIMIT = 10.0  # a longer tip (in half weights, from the joint) is cut off
SMOOTH_JOINT = 10000 / 65536  # px between the corners of a joint: under it a round join is flat
LONGEST_OVERHANG = 0.75  # px by which a thin line is longer at each end
FEWEST_ROUND_SIDES, MOST_ROUND_SIDES = 3, 400


class Polylines(NamedTuple):
    """Lines through the same number of points.

    Attributes
    ----------
    x, y : (n, k) float32, object space
    is_closed : bool
        Whether a segment leads back from the last point to the first.
    """

    x: F32
    y: F32
    is_closed: bool

    def ends(self) -> tuple[tuple[F32, F32], tuple[F32, F32]]:
        """Return the first and the second point of each segment, (n, s) each coordinate."""
        if self.is_closed:
            return (self.x, self.y), (np.roll(self.x, -1, axis=1), np.roll(self.y, -1, axis=1))
        return (self.x[:, :-1], self.y[:, :-1]), (self.x[:, 1:], self.y[:, 1:])


class Pieces(NamedTuple):
    """Polygons of the same number of corners.

    Attributes
    ----------
    x, y : (m, k) float32
    points : (m, k) int64
        Which point of its polyline each corner takes its colour from.
    lines : (m,) int64
        Which polyline each piece belongs to.
    """

    x: F32
    y: F32
    points: I64
    lines: I64


def _directions(lines: Polylines) -> tuple[F32, F32, F32]:
    """Return unit direction and length of each segment, (n, s) each; of no length: (0, 0)."""
    (x0, y0), (x1, y1) = lines.ends()
    dx, dy = x1 - x0, y1 - y0
    length = np.sqrt(dx * dx + dy * dy)
    safe = np.where(length > 0, length, 1)
    return dx / safe, dy / safe, length


def _segment_points(lines: Polylines) -> tuple[I64, I64]:
    """Return the indices of the points where segments begin and end, (s,) each."""
    first = np.arange(lines.x.shape[1] - (not lines.is_closed))
    return first, (first + 1) % lines.x.shape[1]


def thin_stroke(lines: Polylines, weights: F32) -> Pieces:
    """Return one quad for each segment, a little longer at both ends.

    `weights` is (n, k): that of each point, pixels.
    """
    (x0, y0), (x1, y1) = lines.ends()
    ux, uy, _ = _directions(lines)
    begin, end = _segment_points(lines)
    overhang = np.minimum(np.float32(LONGEST_OVERHANG), weights[:, begin] / 2)
    along_x, along_y = ux * overhang, uy * overhang
    half0, half1 = weights[:, begin] / 2, weights[:, end] / 2
    x = [x0 - uy * half0 - along_x, x0 + uy * half0 - along_x]
    x += [x1 + uy * half1 + along_x, x1 - uy * half1 + along_x]
    y = [y0 + ux * half0 - along_y, y0 - ux * half0 - along_y]
    y += [y1 - ux * half1 + along_y, y1 + ux * half1 + along_y]
    return _pieces(x, y, [begin, begin, end, end], len(lines.x))


def _pieces(x: Sequence[F32], y: Sequence[F32], points: Sequence[I64], line_count: int) -> Pieces:
    """Stack corners, each (n, s), to pieces in the order of the lines, then of the segments."""
    corners = len(x)
    segments = x[0].shape[1]
    return Pieces(
        np.stack(x, axis=2).reshape(-1, corners).astype(np.float32),
        np.stack(y, axis=2).reshape(-1, corners).astype(np.float32),
        np.tile(np.stack(points, axis=1), (line_count, 1)),
        np.repeat(np.arange(line_count), segments),
    )


def round_sides(weights: Weights) -> I64:
    """Return of how many sides the polygon is that round joins and caps are parts of."""
    sides = np.float32(3.14159) * np.asarray(weights, np.float32)
    whole: I64 = np.clip(sides, FEWEST_ROUND_SIDES, MOST_ROUND_SIDES).astype(np.int64)
    return whole


def offsets_of(lines: Polylines, weights: Weights) -> tuple[F32, F32]:
    """Return half the weight across each segment, (n, s): its direction turned by a right angle."""
    ux, uy, _ = _directions(lines)
    half = np.asarray(weights, np.float32) / 2
    return uy * half, -ux * half


def wide_stroke(lines: Polylines, weights: Weights, cap: int, join: int) -> list[Pieces]:
    """Return the pieces of a stroke with caps and joins: quads first, then fans.

    A fan's corners are its centre and its rim. Where joins or caps are round, all weights must
    have the same `round_sides`.
    """
    (x0, y0), (x1, y1) = lines.ends()
    mx, my = offsets_of(lines, weights)
    begin, end = _segment_points(lines)
    count = len(lines.x)
    quads = [
        _pieces(
            [x0 + mx, x1 + mx, x1, x0], [y0 + my, y1 + my, y1, y0], [begin, end, end, begin], count
        ),
        _pieces(
            [x0, x1, x1 - mx, x0 - mx], [y0, y1, y1 - my, y0 - my], [begin, end, end, begin], count
        ),
    ]
    fans = (
        [] if (joints := joints_of(lines, mx, my)) is None else [join_fans(joints, weights, join)]
    )
    if not lines.is_closed and cap in (ROUND, PROJECT):
        fans += [cap_fans(lines, mx, my, weights, cap, at_end=end) for end in (False, True)]
    return quads + fans


class Joints(NamedTuple):
    """Where two segments meet: centre, and the two corners on the outer side, (n, j) each.

    `side` is +1 where the outer side is that of the offset (mx, my), -1 where it is the other.
    """

    cx: F32
    cy: F32
    ax: F32
    ay: F32
    bx: F32
    by: F32
    side: F32
    points: I64
    lines: int


def joints_of(lines: Polylines, mx: F32, my: F32) -> Joints | None:
    """Return the joints of polylines; None if there are none."""
    if lines.is_closed:
        before, after = np.roll(np.arange(mx.shape[1]), 1), np.arange(mx.shape[1])
    else:
        before, after = np.arange(mx.shape[1] - 1), np.arange(1, mx.shape[1])
    if not len(after):
        return None
    (x0, y0), _ = lines.ends()
    cx, cy = x0[:, after], y0[:, after]
    # (mx, my) is the direction turned by a right angle: the cross product of two of them is that
    # of the directions. It tells on which side the line bends, and so where the gap is.
    side = np.where(mx[:, before] * my[:, after] < my[:, before] * mx[:, after], -1, 1)
    side = side.astype(np.float32)
    return Joints(
        cx,
        cy,
        cx + side * mx[:, before],
        cy + side * my[:, before],
        cx + side * mx[:, after],
        cy + side * my[:, after],
        side,
        after,
        len(cx),
    )


def join_fans(joints: Joints, weights: Weights, join: int) -> Pieces:
    """Return a fan around each joint."""
    cx, cy, ax, ay, bx, by, _, points, line_count = joints
    rim_x, rim_y = [ax, bx], [ay, by]
    if join == ROUND:
        arc_x, arc_y = _round_rim(joints, weights, _bend(joints))
        rim_x, rim_y = [ax, *arc_x, bx], [ay, *arc_y, by]
    elif join != BEVEL:
        tip_x, tip_y = _miter_tip(joints, weights)
        rim_x, rim_y = [ax, tip_x, bx], [ay, tip_y, by]
    return _pieces([cx, *rim_x], [cy, *rim_y], [points] * (len(rim_x) + 1), line_count)


def _miter_tip(joints: Joints, weights: Weights) -> tuple[F32, F32]:
    """Return where the outer edges meet; the second corner where the tip would be too long."""
    cx, cy, ax, ay, bx, by, *_ = joints
    # The tip lies on the bisector of the two corners a and b, at (a + b) / (1 + cos).
    sx, sy = ax + bx - 2 * cx, ay + by - 2 * cy
    square = sx * sx + sy * sy
    half = np.asarray(weights) / 2
    scale = np.divide(2 * half * half, square, out=np.zeros_like(square), where=square > 1e-9)
    tip_x, tip_y = sx * scale, sy * scale
    distance = tip_x * tip_x + tip_y * tip_y
    fits = (square > 1e-9) & (distance < (MITER_LIMIT * half) ** 2)
    return np.where(fits, cx + tip_x, bx), np.where(fits, cy + tip_y, by)


def _bend(joints: Joints) -> F32:
    """Return a number above 0 where the way from a to b around the centre goes from x to y."""
    cx, cy, ax, ay, bx, by, *_ = joints
    return (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)


def _round_rim(joints: Joints, weights: Weights, bend: F32) -> tuple[list[F32], list[F32]]:
    """Return the points of a round join between its corners, from a to b, (n, j) each.

    They are the corners of a fixed polygon around the joint that lie beyond the line from a to b;
    those that do not are laid on b, where they make no area.
    """
    cx, cy, ax, ay, bx, by = (value[..., None] for value in joints[:6])
    sides = int(round_sides(weights).max())
    radius = np.asarray(weights)[..., None] / 2
    angle = np.arange(sides) * (2 * np.pi / sides)
    pen_x, pen_y = radius * np.cos(angle), radius * np.sin(angle)
    turn = np.where(bend >= 0, 1, -1)[..., None]
    chord_x, chord_y = bx - ax, by - ay
    beyond = turn * (chord_x * (pen_y - (ay - cy)) - chord_y * (pen_x - (ax - cx))) < 0
    beyond &= chord_x**2 + chord_y**2 >= SMOOTH_JOINT**2
    travelled = (turn * (angle - np.arctan2(ay - cy, ax - cx))) % (2 * np.pi)
    order = np.argsort(np.where(beyond, travelled, np.inf), axis=-1, kind="stable")
    beyond = np.take_along_axis(beyond, order, axis=-1)
    pen_x, pen_y = (np.broadcast_to(pen, order.shape) for pen in (pen_x, pen_y))
    x = np.where(beyond, cx + np.take_along_axis(pen_x, order, axis=-1), bx).astype(np.float32)
    y = np.where(beyond, cy + np.take_along_axis(pen_y, order, axis=-1), by).astype(np.float32)
    return [x[..., i] for i in range(sides)], [y[..., i] for i in range(sides)]


def cap_fans(
    lines: Polylines, mx: F32, my: F32, weights: Weights, cap: int, *, at_end: bool
) -> Pieces:
    """Return a fan around one end of each line."""
    column = slice(-1, None) if at_end else slice(0, 1)
    sign = np.float32(1 if at_end else -1)
    cx, cy = lines.x[:, column], lines.y[:, column]
    ox, oy = sign * mx[:, column], sign * my[:, column]
    point = np.array([lines.x.shape[1] - 1 if at_end else 0])
    ends = Joints(cx, cy, cx + ox, cy + oy, cx - ox, cy - oy, np.ones_like(cx), point, len(cx))
    if cap == ROUND:
        arc_x, arc_y = _round_rim(ends, weights, np.zeros_like(cx))
        x = [cx, ends.ax, *arc_x, ends.bx]
        y = [cy, ends.ay, *arc_y, ends.by]
        return _pieces(x, y, [point] * len(x), len(cx))
    # (-oy, ox) points outwards: the offset turned back to the direction of the line.
    x = [cx, cx + ox, cx + ox - oy, cx - ox - oy, cx - ox]
    y = [cy, cy + oy, cy + oy + ox, cy - oy + ox, cy - oy]
    return _pieces(x, y, [point] * 5, len(cx))
