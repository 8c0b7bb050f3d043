"""attrib() and its like: what they refuse, and changing them later."""

from __future__ import annotations

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pshape.shape import PShape
from sketchkit.core.constants import TRIANGLES
from sketchkit.core.errors import SketchError
from sketchkit.draw.commands import DrawMesh
from sketchkit.draw.vertex import Layer, VertexBlock
from tests.canvases import drawn, flat_canvas


@pytest.fixture
def g() -> PGraphics:
    canvas = flat_canvas()
    canvas.noStroke()
    return canvas


def kept(g: PGraphics) -> PShape:
    s = g.createShape()
    s.beginShape(TRIANGLES)
    s.attrib("heat", 0.25)
    s.attribPosition("tip", 1, 2, 3)
    s.attribNormal("along", 1, 0, 0)
    s.attribColor("glow", g.color(255, 0, 0))
    for x, y in [(0, 0), (10, 0), (0, 10)]:
        s.vertex(x, y)
    s.endShape()
    return s


def block_of(g: PGraphics, s: PShape) -> VertexBlock:
    g.shape(s)
    (draw,) = (command for command in drawn(g).commands if isinstance(command, DrawMesh))
    return draw.part.mesh.blocks[Layer.FILLS]


def test_attrib_belongs_into_a_shape(g: PGraphics) -> None:
    with pytest.raises(SketchError, match="between beginShape"):
        g.attrib("heat", 1.0)


@pytest.mark.parametrize("values", [(), (1, 2, 3, 4, 5), ("hot",)])
def test_attrib_takes_one_to_four_numbers(g: PGraphics, values: tuple[float, ...]) -> None:
    g.beginShape()

    with pytest.raises(SketchError, match=r"attrib\(\)"):
        g.attrib("heat", *values)


def test_attrib_wants_a_name(g: PGraphics) -> None:
    g.beginShape()

    with pytest.raises(SketchError, match="name first"):
        g.attrib(1.0, 2.0)  # type: ignore[arg-type] # the mistake


def test_kept_shape_has_its_attributes(g: PGraphics) -> None:
    custom = block_of(g, kept(g)).custom

    assert custom["heat"].tolist() == [[0.25]] * 3
    assert custom["tip"].tolist() == [[1, 2, 3]] * 3
    assert custom["along"].tolist() == [[1, 0, 0]] * 3
    assert custom["glow"].tolist() == [[1, 0, 0, 1]] * 3


def test_attributes_are_changed_at_single_vertices(g: PGraphics) -> None:
    s = kept(g)

    s.setAttrib("heat", 1, 0.75)
    s.setAttribPosition("tip", 0, 7, 8, 9)
    s.setAttribNormal("along", 2, 0, 1, 0)
    s.setAttribColor("glow", 1, g.color(0, 0, 255))

    custom = block_of(g, s).custom
    assert custom["heat"].ravel().tolist() == [0.25, 0.75, 0.25]
    assert custom["tip"].tolist() == [[7, 8, 9], [1, 2, 3], [1, 2, 3]]
    assert custom["along"].tolist() == [[1, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert custom["glow"].tolist() == [[1, 0, 0, 1], [0, 0, 1, 1], [1, 0, 0, 1]]


def test_unknown_attribute_hints_at_the_nearest(g: PGraphics) -> None:
    with pytest.raises(SketchError, match="Do you mean 'heat'"):
        kept(g).setAttrib("heet", 1, 0.5)


def test_vertex_that_is_not_there_is_refused(g: PGraphics) -> None:
    with pytest.raises(SketchError):
        kept(g).setAttrib("heat", 3, 0.5)
