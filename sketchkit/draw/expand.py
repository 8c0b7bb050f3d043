"""Rows to pieces: whole columns of one kind at a time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.style import Style
from sketchkit.draw.expand_shapes import expand_shapes
from sketchkit.draw.hidden_backs import hides_back
from sketchkit.draw.outlines import Dots, Outlines, add_dots, add_outlines, row_outlines
from sketchkit.draw.pieces import Expansion, Fills
from sketchkit.draw.recorder import Kind
from sketchkit.draw.rows import ZERO, Rows
from sketchkit.geometry import ellipses
from sketchkit.geometry.circles import fan, side_count, unit_circle
from sketchkit.geometry.rects import rect_corners
from sketchkit.geometry.shapes import QUAD, TRIANGLE, is_aligned
from sketchkit.geometry.solids import Solid, unit_box, unit_sphere

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I64 = NDArray[np.int64]


# How a texture lies on a rectangle or quad; other flat shapes show but one place of it.
WHOLE_TEXTURE = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
NO_TEXTURE = np.zeros((1, 2), np.float32)


def expand(rows: Rows) -> Expansion:
    """Return the pieces that all rows make."""
    out = Expansion([], [], [])
    for kind, function in EXPANSIONS.items():
        at = np.flatnonzero(rows.kinds == kind)
        if len(at):
            function(rows, at, out)
    return out


def _add_fills(
    rows: Rows, at: I64, corners: tuple[F32, F32], triangles: I64, out: Expansion, *, snaps: bool
) -> None:
    """Fill flat pieces, one for each of the rows `at`, in the row's own colour."""
    filled = rows.fills[at] >= 0
    if not filled.any():
        return
    at = at[filled]
    x, y = corners[0][filled], corners[1][filled]
    states = rows.states[at]
    snap = None
    if snaps and (may := rows.can_snap[states]).any():
        snap = may & is_aligned(x, y, triangles=x.shape[1] == 3)
    fills = Fills(at, x, y, ZERO, triangles, rows.fills[at][:, None], snap=snap)
    fills.normals = rows.normals[states][:, None]
    _cover(rows, fills, WHOLE_TEXTURE if x.shape[1] == len(WHOLE_TEXTURE) else NO_TEXTURE)
    out.fills.append(fills)


def _cover(rows: Rows, fills: Fills, uvs: F32) -> None:
    """Give pieces the places on a texture, (k, 2); those of a retained shape, its texture too."""
    if not rows.wants_uvs:
        return
    fills.uvs = np.broadcast_to(uvs, (len(fills.rows), fills.x.shape[1], 2))
    if rows.is_retained.any() and rows.links[fills.rows].any():
        fills.textures = [rows.recorder.textures[link - 1] for link in rows.links[fills.rows]]


def _expand_points(rows: Rows, at: I64, out: Expansion) -> None:
    at = at[(rows.strokes[at] >= 0) & (rows.weights[at] > 0)]
    x, y, z = rows.numbers[at, :3].T
    add_dots(rows, Dots(at, x, y, z, rows.strokes[at], rows.weights[at]), out)


def _expand_lines(rows: Rows, at: I64, out: Expansion) -> None:
    ends = rows.numbers[at, :6].reshape(-1, 2, 3)
    x, y, z = ends[..., 0], ends[..., 1], ends[..., 2]
    add_outlines(rows, row_outlines(rows, at, x, y, z, is_closed=False), out)


def _expand_polygons(rows: Rows, at: I64, out: Expansion, count: int, triangles: I64) -> None:
    corners = rows.numbers[at, : 2 * count].reshape(-1, count, 2)
    x, y = corners[..., 0], corners[..., 1]
    _add_fills(rows, at, (x, y), triangles, out, snaps=True)
    add_outlines(rows, row_outlines(rows, at, x, y, ZERO, is_closed=True), out)


def _expand_triangles(rows: Rows, at: I64, out: Expansion) -> None:
    _expand_polygons(rows, at, out, 3, TRIANGLE)


def _expand_quads(rows: Rows, at: I64, out: Expansion) -> None:
    _expand_polygons(rows, at, out, 4, QUAD)


def _expand_rects(rows: Rows, at: I64, out: Expansion) -> None:
    for mode, some in rows.groups(at, lambda style: style.rect_mode):
        x, y = rect_corners(mode, rows.numbers[some, :4])
        _add_fills(rows, some, (x, y), QUAD, out, snaps=True)
        add_outlines(rows, row_outlines(rows, some, x, y, ZERO, is_closed=True), out)


def _expand_ellipses(rows: Rows, at: I64, out: Expansion) -> None:
    for mode, some in rows.groups(at, lambda style: style.ellipse_mode):
        boxes = ellipses.upright(ellipses.ellipse_boxes(mode, rows.numbers[some, :4]))
        sides = side_count(_screen_diagonals(rows, some, boxes))
        for count in np.unique(sides):
            mine = sides == count
            own = ellipses.Boxes(*(column[mine][:, None] for column in boxes))
            _add_ellipses(rows, some[mine], own, int(count), out)


def _screen_diagonals(rows: Rows, at: I64, boxes: ellipses.Boxes) -> F32:
    """Return how long the diagonals of boxes are on the screen, (n,)."""
    left, top = rows.on_screen(at, boxes.x, boxes.y)
    right, bottom = rows.on_screen(at, boxes.x + boxes.width, boxes.y + boxes.height)
    diagonals: F32 = np.hypot(right - left, bottom - top)
    return diagonals


def _add_ellipses(rows: Rows, at: I64, boxes: ellipses.Boxes, sides: int, out: Expansion) -> None:
    """Add ellipses of one number of sides; the box's columns are (n, 1)."""
    cosines, sines = unit_circle(sides)
    half_width, half_height = boxes.width / 2, boxes.height / 2
    centre_x, centre_y = boxes.x + half_width, boxes.y + half_height
    x = centre_x + cosines * half_width
    y = centre_y + sines * half_height
    with_hub = np.concatenate([centre_x, x], axis=1), np.concatenate([centre_y, y], axis=1)
    _add_fills(rows, at, with_hub, fan(sides + 1, closed=True), out, snaps=False)
    add_outlines(rows, row_outlines(rows, at, x, y, ZERO, is_closed=True), out)


def _expand_arcs(rows: Rows, at: I64, out: Expansion) -> None:
    for mode, some in rows.groups(at, lambda style: style.ellipse_mode):
        boxes = ellipses.ellipse_boxes(mode, rows.numbers[some, :4])
        sides = side_count(_screen_diagonals(rows, some, boxes))
        # One by one: two arcs rarely have the same corners.
        for i, row in enumerate(some):
            box = ellipses.Boxes(*(column[i : i + 1, None] for column in boxes))
            _add_arc(rows, row, box, int(sides[i]), out)


def _add_arc(rows: Rows, row: int, box: ellipses.Boxes, sides: int, out: Expansion) -> None:
    start, stop, mode = rows.numbers[row, 4:7].tolist()
    arc = ellipses.unit_arc(start, stop, int(mode), sides)
    half_width, half_height = box.width / 2, box.height / 2
    x = box.x + half_width + np.append(np.float32(arc.hub[0]), arc.x) * half_width
    y = box.y + half_height + np.append(np.float32(arc.hub[1]), arc.y) * half_height
    at = np.array([row])
    _add_fills(rows, at, (x, y), fan(x.shape[1], closed=False), out, snaps=False)
    if ellipses.arc_outline_passes_hub(int(mode)):
        outlines = row_outlines(rows, at, x, y, ZERO, is_closed=True)
    elif arc.is_full:
        outlines = row_outlines(rows, at, x[:, 1:-1], y[:, 1:-1], ZERO, is_closed=True)
    else:
        outlines = row_outlines(rows, at, x[:, 1:], y[:, 1:], ZERO, is_closed=False)
    add_outlines(rows, outlines, out)


def _expand_boxes(rows: Rows, at: I64, out: Expansion) -> None:
    sizes = rows.numbers[at, :3]
    _add_solids(rows, at, unit_box(), sizes, _box_normal_signs(sizes), out)


def _box_normal_signs(sizes: F32) -> F32 | None:
    """Return by what the box's normals are multiplied, (n, 3): a negative size turns them."""
    if (sizes > 0).all():
        return None
    width, height, depth = (sizes > 0).T
    turned = np.stack([height != depth, width != depth, width != height], axis=1)
    return np.where(turned, -1, 1).astype(np.float32)


def _expand_spheres(rows: Rows, at: I64, out: Expansion) -> None:
    def detail(style: Style) -> tuple[int, int]:
        return style.sphere_detail

    for (around, along), some in rows.groups(at, detail):
        radii = rows.numbers[some, :1].repeat(3, axis=1)
        _add_solids(rows, some, unit_sphere(around, along), radii, None, out)


def _add_solids(
    rows: Rows, at: I64, solid: Solid, sizes: F32, signs: F32 | None, out: Expansion
) -> None:
    """Add copies of a solid, stretched by `sizes`, (n, 3)."""
    corners = solid.positions
    x, y, z = (corners[:, axis] * sizes[:, axis : axis + 1] for axis in range(3))
    filled = rows.fills[at] >= 0
    if filled.any():
        normals = solid.normals[None]
        if signs is not None:
            normals = normals * signs[filled][:, None]
        some = at[filled]
        colors = rows.fills[some][:, None]
        fills = Fills(some, x[filled], y[filled], z[filled], solid.triangles, colors)
        fills.normals = normals
        fills.hides_back = hides_back(rows, some, sizes[filled] * solid.reach)
        _cover(rows, fills, solid.uvs)
        out.fills.append(fills)
    stroked = at[(rows.strokes[at] >= 0) & (rows.weights[at] > 0)]
    if len(stroked):
        mine = np.isin(at, stroked)
        edges = solid.outlines
        x, y, z = (column[mine][:, edges].reshape(-1, edges.shape[1]) for column in (x, y, z))
        owners = stroked.repeat(len(edges))
        colors, weights = rows.strokes[owners][:, None], rows.weights[owners][:, None]
        add_outlines(rows, Outlines(owners, x, y, z, colors, weights, solid.is_closed), out)


def _expand_images(rows: Rows, at: I64, out: Expansion) -> None:
    """Images: the tint is in the place of the stroke, the texture in that of the link."""
    numbers = rows.numbers[at]
    java2d = rows.is_java2d[rows.states[at]][:, None]
    x1, y1, x2, y2 = np.where(java2d, np.trunc(numbers[:, :4]), numbers[:, :4]).T
    u1, v1, u2, v2 = numbers[:, 4:].T
    x, y = np.stack([x1, x1, x2, x2], axis=1), np.stack([y1, y2, y2, y1], axis=1)
    u, v = np.stack([u1, u1, u2, u2], axis=1), np.stack([v1, v2, v2, v1], axis=1)
    textures = [rows.recorder.textures[link] for link in rows.links[at]]
    out.fills.append(
        Fills(
            at,
            x,
            y,
            ZERO,
            QUAD,
            rows.strokes[at][:, None],
            snap=rows.can_snap[rows.states[at]],
            uvs=np.stack([u, v], axis=2),
            textures=textures,
            ambient=rows.fills[at][:, None],
        )
    )


EXPANSIONS: dict[Kind, Callable[[Rows, I64, Expansion], None]] = {
    Kind.POINT: _expand_points,
    Kind.LINE: _expand_lines,
    Kind.TRIANGLE: _expand_triangles,
    Kind.QUAD: _expand_quads,
    Kind.RECT: _expand_rects,
    Kind.ELLIPSE: _expand_ellipses,
    Kind.ARC: _expand_arcs,
    Kind.BOX: _expand_boxes,
    Kind.SPHERE: _expand_spheres,
    Kind.IMAGE: _expand_images,
    Kind.LETTER: _expand_images,
    Kind.SHAPE: expand_shapes,
}
