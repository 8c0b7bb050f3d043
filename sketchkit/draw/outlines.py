"""Strokes and points of rows: outlines in the plane in P2D, strips that face the viewer in P3D."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import ROUND
from sketchkit.draw.added_corners import mix_colors
from sketchkit.draw.pieces import Expansion, Fills, Lines, Points
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.rows import ZERO, Rows
from sketchkit.geometry.circles import fan, side_count, unit_circle
from sketchkit.geometry.polygons import interpolate, tessellate
from sketchkit.geometry.shapes import SAME
from sketchkit.geometry.stroke_rings import stroke_rings
from sketchkit.geometry.strokes import Pieces, Polylines, round_sides, thin_stroke, wide_stroke

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]

THIN = 2.0  # px: strokes below it have neither caps nor joins, but those of retained shapes
SEGMENT = np.array([(0, 1, 2), (2, 0, 3)])
SQUARE_X = np.array([[0, -1, 1, 1, -1]], np.float32) / 2
SQUARE_Y = np.array([[0, -1, -1, 1, 1]], np.float32) / 2
OPAQUE = 255
MIDDLE = np.float32(0.5)  # of a pixel
PAINTS_ONCE = (Blend.BLEND, Blend.REPLACE, Blend.LIGHTEST, Blend.DARKEST)


class Outlines(NamedTuple):
    """Polylines to stroke; `n` of them through `k` points.

    Attributes
    ----------
    rows : (n,) int64, ascending
    x, y, z : (n, k) float32, object space
        A dimension of z may be 1.
    colors : (n, k) or (n, 1) int64, packed ARGB
    weights : (n, k) or (n, 1) float32
    is_closed : bool
    sources : (n, k) int64 or None
        The recorder's corners that the points are.
    """

    rows: I64
    x: F32
    y: F32
    z: F32
    colors: I64
    weights: F32
    is_closed: bool
    sources: I64 | None = None

    def take(self, chosen: Bool | I64) -> Outlines:
        """Return some of the polylines."""
        z = self.z if len(self.z) == 1 else self.z[chosen]
        return Outlines(
            self.rows[chosen],
            self.x[chosen],
            self.y[chosen],
            z,
            self.colors[chosen],
            self.weights[chosen],
            self.is_closed,
            None if self.sources is None else self.sources[chosen],
        )


def row_outlines(rows: Rows, at: I64, x: F32, y: F32, z: F32, *, is_closed: bool) -> Outlines:
    """Return one outline for each of the rows `at`, in the row's own colour and weight."""
    return Outlines(
        at, x, y, z, rows.strokes[at][:, None], rows.weights[at][:, None], is_closed
    ).take((rows.strokes[at] >= 0) & (rows.weights[at] > 0))


def add_outlines(rows: Rows, outlines: Outlines, out: Expansion) -> None:
    """Stroke polylines into `out`."""
    if not len(outlines.rows):
        return
    states = rows.states[outlines.rows]
    kinds = rows.is_3d[states] * 2 + has_joints(rows, outlines.rows)
    for kind in np.unique(kinds):
        some = outlines.take(kinds == kind)
        if kind >= 2:
            shape = np.broadcast_shapes(some.x.shape, some.z.shape)
            z = np.broadcast_to(some.z, shape)
            out.lines.append(
                Lines(
                    some.rows,
                    some.x,
                    some.y,
                    z,
                    some.colors,
                    some.weights,
                    some.is_closed,
                    is_joined=bool(kind == 3),
                    sources=some.sources,
                )
            )
        elif kind == 1:
            _add_wide(rows, some, out)
        else:
            _add_thin(rows, some, out)


def has_joints(rows: Rows, at: I64) -> Bool:
    """Return which outlines have joins and caps: the weight at the end of a shape decides."""
    states = rows.states[at]
    found: Bool = (rows.scales[states] * rows.weights[at] >= THIN) | rows.is_retained[states]
    return found


def _add_thin(rows: Rows, outlines: Outlines, out: Expansion) -> None:
    """Add one quad for each segment; those along the axes are moved to whole pixels."""
    lines = Polylines(outlines.x, outlines.y, outlines.is_closed)
    weights = np.broadcast_to(outlines.weights, outlines.x.shape)
    pieces = thin_stroke(lines, weights)
    states = rows.states[outlines.rows]
    scaled = rows.scales[states][:, None] * outlines.weights
    whole = (scaled == np.trunc(scaled)).all(axis=1)
    snap = rows.can_snap[states] & whole & _rows_agree(outlines.rows, _is_aligned(lines))
    fills = _stroke_fills(rows, outlines, pieces, SEGMENT)
    fills.snap = snap[pieces.lines] if snap.any() else None
    out.fills.append(fills)


def _is_aligned(lines: Polylines) -> Bool:
    """Return which polylines have all their segments along the axes, (n,)."""
    (x0, y0), (x1, y1) = lines.ends()
    aligned = ((np.abs(x0 - x1) < SAME) | (np.abs(y0 - y1) < SAME)).all(axis=1)
    return np.asarray(aligned)


def _rows_agree(rows: I64, fits: Bool) -> Bool:
    """Return for each piece whether all pieces of its row fit, (n,)."""
    return fits if fits.all() else ~np.isin(rows, rows[~fits])


def _shift(rows: Rows, at: I64, x: F32, y: F32) -> F32 | None:
    """Return by how much outlines that begin at x, y, (n,), are moved to the middle of a pixel."""
    moves = rows.is_java2d[rows.states[at]]
    if not moves.any():
        return None
    eye_x, eye_y, _ = rows.transform(at, x[:, None], y[:, None], ZERO)
    start = np.concatenate([eye_x, eye_y], axis=1)
    return np.where(moves[:, None], np.floor(start) + MIDDLE - start, 0)


def _stroke_fills(rows: Rows, outlines: Outlines, pieces: Pieces, triangles: I64) -> Fills:
    """Return pieces of strokes as fills, in the colours of their points."""
    if outlines.colors.shape[1] == 1:
        colors = outlines.colors[pieces.lines]
    else:
        colors = outlines.colors[pieces.lines[:, None], pieces.points]
    shift = _shift(rows, outlines.rows, outlines.x[:, 0], outlines.y[:, 0])
    return Fills(
        outlines.rows[pieces.lines],
        pieces.x,
        pieces.y,
        ZERO,
        triangles,
        colors,
        is_stroke=True,
        shift=None if shift is None else shift[pieces.lines],
    )


def _add_wide(rows: Rows, outlines: Outlines, out: Expansion) -> None:
    """Add strokes with caps and joins, for each cap and join, and sides of what is round."""
    states = rows.states[outlines.rows]
    styles = [rows.styles[state] for state in states]
    blends = [rows.stages[state].blend for state in states]
    # Where pieces overlap does not show if they are opaque and of one colour, or if there is one.
    is_opaque = (outlines.colors >> 24).min(axis=1) == OPAQUE
    is_plain = (outlines.colors == outlines.colors[:, :1]).all(axis=1)
    paints_once = np.array([blend in PAINTS_ONCE for blend in blends], np.bool_)
    is_single = outlines.x.shape[1] == 2
    may_overlap = np.asarray((is_opaque & is_plain & paints_once) | is_single)
    sides = round_sides(outlines.weights[:, 0])
    groups: dict[tuple[int, int, int, bool], list[int]] = defaultdict(list)
    for i, style in enumerate(styles):
        is_round = ROUND in (style.stroke_cap, style.stroke_join)
        own_sides = int(sides[i]) if is_round else 0
        groups[own_sides, style.stroke_cap, style.stroke_join, bool(may_overlap[i])].append(i)
    for (_, cap, join, is_free), members in groups.items():
        some = outlines.take(np.array(members))
        if is_free:
            _add_overlapping(rows, some, cap, join, out)
        else:
            _add_united(rows, some, cap, join, out)


def _add_overlapping(rows: Rows, outlines: Outlines, cap: int, join: int, out: Expansion) -> None:
    """Add strokes piece by piece: where the pieces overlap does not show."""
    lines = Polylines(outlines.x, outlines.y, outlines.is_closed)
    for pieces in wide_stroke(lines, outlines.weights[:, :1], cap, join):
        triangles = fan(pieces.x.shape[1], closed=False)
        out.fills.append(_stroke_fills(rows, outlines, pieces, triangles))


def _add_united(rows: Rows, outlines: Outlines, cap: int, join: int, out: Expansion) -> None:
    """Add strokes as one outline for each row, so that nothing is painted twice."""
    for row in np.unique(outlines.rows):
        some = outlines.take(outlines.rows == row)
        lines = Polylines(some.x, some.y, some.is_closed)
        x, y, sources, lengths = stroke_rings(lines, some.weights[:, :1], cap, join)
        points = np.stack([x, y, np.zeros_like(x)], axis=1).astype(np.float64)
        found = tessellate(points, lengths)
        if not len(found.triangles):
            continue
        colors = mix_colors(found, np.broadcast_to(some.colors, some.x.shape).ravel()[sources])
        corners = interpolate(found, points)[found.triangles].astype(np.float32)
        out.fills.append(
            Fills(
                np.full(len(corners), row),
                corners[..., 0],
                corners[..., 1],
                ZERO,
                np.array([(0, 1, 2)]),
                colors[found.triangles],
                is_stroke=True,
                shift=_shift(rows, some.rows[:1], some.x[:1, 0], some.y[:1, 0]),
            )
        )


class Dots(NamedTuple):
    """Points to draw, (n,) each; `sources` as of `Outlines`."""

    rows: I64
    x: F32
    y: F32
    z: F32
    colors: I64
    weights: F32
    sources: I64 | None = None

    def take(self, chosen: Bool | I64) -> Dots:
        """Return some of the points."""
        return Dots(*(None if column is None else column[chosen] for column in self))  # type: ignore[arg-type] # None is the last one's alone


def add_dots(rows: Rows, dots: Dots, out: Expansion) -> None:
    """Draw points: discs, or squares where the cap is not round."""
    states = rows.states[dots.rows]
    round_caps = np.array([style.stroke_cap == ROUND for style in rows.styles], np.bool_)[states]
    sides = np.where(round_caps, side_count(dots.weights), 0)
    solid = rows.is_3d[states]
    for key in dict.fromkeys(zip(sides.tolist(), solid.tolist(), strict=True)):
        mine = (sides == key[0]) & (solid == key[1])
        some = dots.take(mine)
        if key[0]:
            cosines, sines = unit_circle(key[0])
            hub = np.zeros(1, np.float32)
            unit_x = np.concatenate([hub, cosines / 2])[None]
            unit_y = np.concatenate([hub, sines / 2])[None]
        else:
            unit_x, unit_y = SQUARE_X, SQUARE_Y
        _add_fans(rows, some, (unit_x, unit_y), out, is_round=bool(key[0]), is_3d=key[1])


def _add_fans(
    rows: Rows, dots: Dots, unit: tuple[F32, F32], out: Expansion, *, is_round: bool, is_3d: bool
) -> None:
    """Add points of one outline, given as the corners of a fan of size 1."""
    triangles = fan(unit[0].shape[1], closed=True)
    states = rows.states[dots.rows]
    if is_3d:
        size = (dots.weights * rows.scales[states])[:, None]
        offsets = np.stack([unit[0] * size, unit[1] * size], axis=2)
        out.points.append(
            Points(dots.rows, dots.x, dots.y, dots.z, dots.colors, offsets, triangles, dots.sources)
        )
        return
    size = dots.weights[:, None]
    out.fills.append(
        Fills(
            dots.rows,
            dots.x[:, None] + unit[0] * size,
            dots.y[:, None] + unit[1] * size,
            ZERO,
            triangles,
            dots.colors[:, None],
            is_stroke=True,
            snap=None if is_round else rows.can_snap[states],
            shift=_shift(rows, dots.rows, dots.x, dots.y),
        )
    )
