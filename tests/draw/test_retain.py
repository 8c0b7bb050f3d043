"""What a retained shape is made of, and which of its vertices an edit touches."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import (
    CLOSE,
    LINES,
    POINTS,
    POLYGON,
    QUADS,
    RECT,
    TRIANGLE_STRIP,
    TRIANGLES,
)
from sketchkit.draw.retain import Quality, repaint, revise, shows_corners
from sketchkit.draw.vertex import Layer

CORNERS = ((0, 0), (10, 0), (10, 10), (20, 0), (30, 0), (30, 10))


def made(canvas, kind=TRIANGLES, end=None):
    """Return a shape of six corners, and the parts of its mesh."""
    s = canvas.createShape()
    s.beginShape(kind)
    for x, y in CORNERS:
        s.vertex(x, y)
    s.endShape(end)
    return s, s._up_to_date(canvas)


def revised(canvas, quality, corner):
    """Return the fills of a shape of which one corner is brought up to date."""
    s, parts = made(canvas)
    mesh = parts[0].mesh
    table = s._recorder.corner_array()
    table["place"][corner] = (5, 6, 7)
    table["fill"][corner] = 0xFF102030
    del table
    revise(mesh, s._recorder, quality, np.array([corner]))
    return mesh


def test_space_has_a_part_for_each_layer(deep):
    _, parts = made(deep)

    assert [part.layer for part in parts] == [Layer.FILLS, Layer.LINES]
    assert [part.count for part in parts] == [6, 6 * (6 + 6)]  # six sides, six joins


def test_plane_has_strokes_among_the_fills(flat):
    _, parts = made(flat)

    assert [part.layer for part in parts] == [Layer.FILLS]


def test_positions_are_the_shapes_own(deep):
    deep.translate(30, 40)

    _, parts = made(deep)

    assert parts[0].mesh.blocks[Layer.FILLS].positions[:, :2].tolist() == [[*p] for p in CORNERS]


def test_vertices_know_their_corners(deep):
    _, parts = made(deep)

    assert parts[0].mesh.blocks[Layer.FILLS].sources.tolist() == [0, 1, 2, 3, 4, 5]


def test_outlines_of_the_plane_have_no_corner(flat):
    _, parts = made(flat)

    sources = parts[0].mesh.blocks[Layer.FILLS].sources

    assert sorted(set(sources.tolist())) == [-1, 0, 1, 2, 3, 4, 5]


@pytest.mark.parametrize(
    ("kind", "quality", "expected"),
    [
        (TRIANGLES, Quality.PLACE, True),
        (TRIANGLE_STRIP, Quality.FILL, True),
        (QUADS, Quality.UV, True),
        (POINTS, Quality.PLACE, True),
        (POINTS, Quality.STROKE, True),
        (LINES, Quality.PLACE, False),
        (POLYGON, Quality.PLACE, False),
    ],
)
def test_edit_of_faces_and_points_needs_no_new_mesh(kind, quality, expected):
    assert shows_corners(kind, quality) is expected


def test_moved_corner_moves_its_vertex_alone(deep):
    mesh = revised(deep, Quality.PLACE, 2)

    assert mesh.blocks[Layer.FILLS].positions[2].tolist() == [5, 6, 7]
    assert [(edit.column, edit.first, edit.last) for edit in mesh.edits_since(0)] == [
        ("positions", 2, 3)
    ]


def test_outline_in_space_stays_where_it_was(deep):
    _, before = made(deep)
    lines = before[0].mesh.blocks[Layer.LINES].positions

    mesh = revised(deep, Quality.PLACE, 2)

    assert np.array_equal(mesh.blocks[Layer.LINES].positions, lines)


def test_colored_corner_colors_its_vertex_alone(deep):
    mesh = revised(deep, Quality.FILL, 1)

    colors = mesh.blocks[Layer.FILLS].colors
    assert colors[1].tolist() == [0x10, 0x20, 0x30, 0xFF]
    assert colors[0].tolist() == [255, 255, 255, 255]


def test_repainting_fills_leaves_the_outline_of_the_plane(flat):
    _, parts = made(flat)
    block = parts[0].mesh.blocks[Layer.FILLS]

    repaint(parts[0].mesh, Quality.FILL, 0xFF0000FF)

    blue = (block.colors == (0, 0, 255, 255)).all(axis=1)
    assert np.array_equal(blue, block.sources >= 0)


def test_repainting_strokes_leaves_the_fills_of_space(deep):
    _, parts = made(deep)
    mesh = parts[0].mesh

    repaint(mesh, Quality.STROKE, 0xFF0000FF)

    assert (mesh.blocks[Layer.LINES].colors == (0, 0, 255, 255)).all()
    assert (mesh.blocks[Layer.FILLS].colors == 255).all()


def test_ambient_colour_follows_the_fill_where_it_did(deep):
    s = deep.createShape(RECT, 0, 0, 10, 10)
    mesh = s._up_to_date(deep)[0].mesh

    repaint(mesh, Quality.FILL, 0xFF0000FF, with_ambient=True)

    assert (mesh.blocks[Layer.FILLS].materials.ambient == (0, 0, 255, 255)).all()


def test_weights_are_scaled(deep):
    thin, wide = (deep.createShape(RECT, 0, 0, 10, 10) for _ in range(2))
    wide.scale(2)

    halves = [
        np.abs(s._up_to_date(deep)[0].mesh.blocks[Layer.LINES].directions[:, 3]).max()
        for s in (thin, wide)
    ]

    assert halves == [0.5, 1.0]


def test_closed_polygon_ends_in_one_part_of_lines(deep):
    _, parts = made(deep, POLYGON, CLOSE)

    assert [part.layer for part in parts].count(Layer.LINES) == 1
