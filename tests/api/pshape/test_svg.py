"""loadShape() of SVG files: what the parts are, and how they are drawn."""

import numpy as np
import pytest
from PIL import Image

from sketchkit.api.pshape.shape import PShape
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import BREAK, ELLIPSE, GROUP, JAVA2D, P2D, RECT, VERTEX
from sketchkit.core.errors import SketchError
from tests.canvases import new_canvas

HOUSE = """<svg xmlns="http://www.w3.org/2000/svg" width="90" height="60">
<g id="walls" transform="translate(10 20)" fill="#ff0000">
<rect id="front" x="5" y="5" width="20" height="10"/><circle id="sun" cx="50" cy="5" r="4"/></g>
<path id="door" d="M0,0 h4 v8 h-4 z" stroke="#00ff00" stroke-width="2"/>
</svg>"""


@pytest.fixture
def svg(tmp_path):
    def written(text=HOUSE, name="house.svg"):
        (tmp_path / name).write_text(text)
        return str(tmp_path / name)

    return written


def red_box(renderer, draw):
    """Return left, top, right and bottom of what is red on a canvas."""
    canvas = new_canvas(renderer, CpuBackend(), samples=1)
    canvas.background(255)
    draw(canvas)
    rows, columns = (canvas.image_data()[..., :3] == (255, 0, 0)).all(axis=2).nonzero()
    return [columns.min(), rows.min(), columns.max() + 1, rows.max() + 1]


def test_elements_are_children_with_their_names(flat, svg):
    house = flat.loadShape(svg())

    walls, door = house.getChildren()
    assert [walls.getFamily(), door.getFamily()] == [GROUP, PShape.PATH]
    assert [child.getName() for child in walls.getChildren()] == ["front", "sun"]
    assert [child.getKind() for child in walls.getChildren()] == [RECT, ELLIPSE]
    assert house.getChild("sun") is walls.getChild(1)
    assert house.getChild("garden") is None


def test_width_is_the_documents_and_getWidth_what_is_drawn(flat, svg):
    house = flat.loadShape(svg())

    assert (house.width, house.height) == (90, 60)
    assert house.getChild("door").getWidth() == pytest.approx(6, abs=0.01)  # with its stroke


@pytest.mark.parametrize(
    "measure",
    [
        lambda g, house: (house.getWidth(), house.getHeight()),
        lambda g, house: g.shape(house, 0, 0, 45, 30),
    ],
    ids=["asked", "drawn"],
)
def test_width_is_what_is_drawn_once_it_has_been_measured(flat, svg, measure):
    house = flat.loadShape(svg())
    flat.shape(house, 10, 10)
    before = house.width, house.height

    measure(flat, house)

    assert before == (90, 60)
    assert (house.width, house.height) == (house.getWidth(), house.getHeight()) != before


def test_in_JAVA2D_every_part_has_the_size_of_the_document(svg):
    canvas = new_canvas(JAVA2D)

    house = canvas.loadShape(svg())

    assert house.getChild("door").getWidth() == 90


def test_codes_of_a_path_begin_with_a_break(flat, svg):
    door = flat.loadShape(svg()).getChild("door")

    assert door.getVertexCodes() == [BREAK, VERTEX, VERTEX, VERTEX, VERTEX]
    assert door.getVertexCount() == 4


@pytest.mark.parametrize(
    ("renderer", "box"),
    [
        pytest.param(P2D, [16, 27, 36, 37], id="P2D"),
        pytest.param(JAVA2D, [6, 7, 26, 17], id="JAVA2D forgets them"),
    ],
)
def test_part_drawn_alone_stays_where_its_groups_take_it(svg, renderer, box):
    name = svg()

    assert red_box(renderer, lambda g: g.shape(g.loadShape(name).getChild("front"), 1, 2)) == box


def test_style_of_the_file_is_the_files_alone(flat, svg):
    flat.fill(0, 0, 255)
    flat.stroke(255)
    house = flat.loadShape(svg())

    assert house.getChild("front").getFill(0) == 0xFFFF0000
    assert house.getChild("door").getStroke(0) == 0xFF00FF00
    assert house.getChild("door").getStrokeWeight(0) == 2


def test_gradient_shows_in_JAVA2D(svg):
    gradient = """<svg xmlns="http://www.w3.org/2000/svg" width="90" height="60"><defs>
    <linearGradient id="g" gradientUnits="userSpaceOnUse" x1="10" x2="50">
    <stop offset="0" stop-color="#ff0000"/><stop offset="1" stop-color="#0000ff"/>
    </linearGradient></defs>
    <circle cx="30" cy="30" r="20" fill="url(#g)"/></svg>"""
    canvas = new_canvas(JAVA2D, CpuBackend())
    canvas.background(255)

    canvas.shape(canvas.loadShape(svg(gradient)))

    row = canvas.image_data()[30, :, :3].astype(int)
    assert row[5].tolist() == [255, 255, 255]
    np.testing.assert_allclose(row[[15, 30, 45], 0], [223, 127, 32], atol=4)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param("<svg><rect></svg>", "line 1", id="not closed"),
        pytest.param("<html/>", "web page", id="web page"),
    ],
)
def test_broken_file_is_told(flat, svg, text, message):
    with pytest.raises(SketchError, match=message):
        flat.loadShape(svg(text))


def test_missing_file_is_told(flat):
    with pytest.raises(SketchError, match=r"gone\.svg"):
        flat.loadShape("gone.svg")


def test_picture_is_no_shape(flat, tmp_path):
    Image.new("RGB", (2, 2)).save(tmp_path / "photo.png")

    with pytest.raises(SketchError, match="no model"):
        flat.loadShape(str(tmp_path / "photo.png"))
