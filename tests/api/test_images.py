import numpy as np
import pytest
from PIL import Image

from sketchkit.api.pimage import PImage
from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.core.constants import ADD, ARGB, CENTER, CORNERS, P2D, P3D, RGB
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.commands import Clear
from sketchkit.draw.pipeline import Blend, Clip, Program
from tests.canvases import drawn, draws, fills, new_canvas


def box(block):
    """Return left, top, right and bottom of all positions."""
    (left, top, _), (right, bottom, _) = block.positions.min(axis=0), block.positions.max(axis=0)
    return [float(value) for value in (left, top, right, bottom)]


@pytest.fixture
def picture():
    return PImage(20, 10)


@pytest.mark.parametrize(
    ("mode", "numbers", "expected"),
    [
        pytest.param(None, (5, 6), [5, 6, 25, 16], id="its own size"),
        pytest.param(None, (5, 6, 40, 50), [5, 6, 45, 56], id="corner and size"),
        pytest.param(None, (5, 6, -4, -5), [1, 1, 5, 6], id="negative sizes"),
        pytest.param(CORNERS, (5, 6), [5, 6, 25, 16], id="corners, its own size"),
        pytest.param(CORNERS, (50, 60, 30, 20), [30, 20, 50, 60], id="corners in any order"),
        pytest.param(CENTER, (50, 50), [40, 45, 60, 55], id="centre"),
        pytest.param(CENTER, (50, 50, 10, 30), [45, 35, 55, 65], id="centre and size"),
    ],
)
def test_image_mode_gives_the_numbers_their_meaning(flat, picture, mode, numbers, expected):
    if mode is not None:
        flat.imageMode(mode)

    flat.image(picture, *numbers)

    assert box(fills(flat)) == expected


def test_an_odd_image_is_centred_by_whole_pixels(flat):
    flat.imageMode(CENTER)

    flat.image(PImage(5, 3), 50, 50)

    assert box(fills(flat)) == [48, 49, 53, 52]


def test_a_part_is_given_in_pixels_of_the_image(flat, picture):
    flat.image(picture, 0, 0, 40, 40, 5, 2, 15.9, 10)

    assert np.unique(fills(flat).uvs[:, 0]).tolist() == pytest.approx([0.25, 0.75])
    block = drawn(flat)
    assert not block.blocks


def test_tint_is_the_colour_and_fill_is_not(flat, picture):
    flat.fill(255, 0, 0)
    flat.image(picture, 0, 0)
    flat.tint(10, 20, 30, 40)
    flat.image(picture, 50, 0)

    colors = fills(flat).colors

    assert colors[0].tolist() == [255, 255, 255, 255]
    assert colors[-1].tolist() == [10, 20, 30, 40]


def test_images_of_one_picture_are_one_draw(flat, picture):
    for x in range(20):
        flat.image(picture, x, 0)
    flat.image(PImage(4, 4), 0, 50)

    found = draws(drawn(flat))

    assert [draw.pipeline.program for draw in found] == [Program.TEXTURED] * 2
    assert [draw.count for draw in found] == [20 * 6, 6]


def test_what_was_drawn_does_not_change_with_its_image(gl_backend):
    canvas = new_canvas("P2D", gl_backend, (20, 10), samples=1)
    picture = PImage(10, 10)

    canvas.image(picture, 0, 0)
    picture.pixels[:] = 0xFFFF0000
    picture.updatePixels()
    canvas.image(picture, 10, 0)
    canvas.end_frame()

    data = canvas.image_data()
    assert data[5, 5].tolist() == [0, 0, 0, 255]
    assert data[5, 15].tolist() == [255, 0, 0, 255]


def test_load_image_tells_its_format_by_its_pixels(flat, tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    Image.new("RGBA", (2, 3), (1, 2, 3, 255)).save(tmp_path / "opaque.png")
    Image.new("RGBA", (2, 3), (1, 2, 3, 4)).save(tmp_path / "clear.png")

    opaque, clear = flat.loadImage("opaque.png"), flat.loadImage("clear.png", "png")

    set_sketch_folder(before)
    assert (opaque.width, opaque.height, opaque.format) == (2, 3, RGB)
    assert (clear.format, clear.get(0, 0)) == (ARGB, 0x04010203)


@pytest.mark.parametrize(
    ("arguments", "color"),
    [
        ((51,), (51, 51, 51, 255)),
        ((51, 102), (51, 51, 51, 102)),
        ((1, 2, 3), (1, 2, 3, 255)),
        ((1, 2, 3, 4), (1, 2, 3, 4)),
        (("#CC6600",), (0xCC, 0x66, 0, 255)),
    ],
)
def test_background_replaces_all_pixels(flat, arguments, color):
    flat.background(*arguments)

    (clear,) = [c for c in drawn(flat).commands if isinstance(c, Clear)][-1:]

    assert clear.color == color


def test_clear_makes_a_canvas_transparent(flat):
    canvas = flat.offscreen(20, 20, P2D, 1)

    with canvas.beginDraw():
        canvas.clear()

        assert drawn(canvas).commands[-1].color == (0, 0, 0, 0)


def test_clear_does_nothing_in_the_window(flat):
    drawn(flat)

    with pytest.warns(SketchWarning, match=r"background\(0\) makes that black"):
        flat.clear()

    assert not drawn(flat).commands


def test_a_background_image_ignores_matrix_depth_lights_and_tint_but_not_clip_and_blend():
    canvas = new_canvas(P3D)
    canvas.lights()
    canvas.rotateX(1)
    canvas.tint(255, 0, 0)
    canvas.clip(10, 10, 20, 20)
    canvas.blendMode(ADD)
    before = canvas._stage, canvas._modelview

    canvas.background(PImage(100, 100))

    commands = drawn(canvas)
    (draw,) = draws(commands)
    block = commands.blocks[draw.layer]
    assert box(block) == [0, 0, 100, 100]
    assert block.colors[0].tolist() == [255, 255, 255, 255]
    assert draw.pipeline.program is Program.TEXTURED
    assert not draw.pipeline.depth_test
    assert not draw.pipeline.depth_write
    assert draw.pipeline.clip == Clip(10, 10, 20, 20)
    assert draw.pipeline.blend is Blend.ADD
    assert (canvas._stage, canvas._modelview) == before


def test_a_background_image_is_shown_pixel_by_pixel(backend):
    canvas = new_canvas(P3D, backend, (30, 20))
    picture = PImage(30, 20)
    picture.np_pixels[..., :3] = np.random.default_rng(0).integers(0, 256, (20, 30, 3), np.uint8)

    canvas.background(picture)

    assert (canvas.image_data() == picture.np_pixels).all()


# Where Processing drew black in a canvas of 60 x 60: left, right, top, bottom of what is not cut.
@pytest.mark.parametrize(
    ("mode", "numbers", "expected"),
    [
        (None, (10.6, 10.6, 20.7, 20.7), (10, 30, 12, 32)),
        (None, (10.2, 10.3, 20.5, 20.9), (10, 30, 12, 32)),
        (None, (-5.5, -5.5, 20.2, 20.2), (-5, 15, -5, 15)),
        (CENTER, (30.5, 30.5, 21, 21), (20, 41, 20, 41)),
        (CORNERS, (40.5, 40.5, 11, 21), (11, 40, 22, 41)),
        (None, (10, 10, 0, 20), (10, 10, 10, 30)),
    ],
)
def test_clip_is_cut_to_whole_pixels_as_processing_does(mode, numbers, expected):
    canvas = new_canvas("P2D", size=(60, 60))
    if mode is not None:
        canvas.imageMode(mode)

    canvas.clip(*numbers)

    left, top, width, height = canvas._stage.clip
    assert (left, left + width, top, top + height) == expected


def test_no_clip_draws_everywhere_again(flat):
    flat.clip(10, 10, 20, 20)

    flat.noClip()

    assert flat._stage.clip is None


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g, i: g.image(i, 1, 2, 3), "takes 3, 5 or 9 values"),
        (lambda g, i: g.image(i, 1, 2, 3, 4, 5), "takes 3, 5 or 9 values"),
        (lambda g, i: g.image(i, 1, "2"), "Got text for y"),
        (lambda g, i: g.image(i, 1, None), "Got None for y"),
        (lambda g, i: g.image("photo.png", 1, 2), "takes an image"),
        (lambda g, i: g.image("photo.png", 1, 2), r"img = loadImage\('photo.png'\)"),
        (lambda g, i: g.image(5, 1, 2), "Got a number: 5"),
        (lambda g, i: g.image(i, 1e40, 2), r"image\(\) is too large"),
        (lambda g, i: g.image(None, 1, 2), "takes an image"),
        (lambda g, i: g.clip(1, 2, 3, "4"), "Got text for height"),
        (lambda g, i: g.background(i), "Got 20 x 10 for a canvas of 100 x 100"),
        (lambda g, i: g.background("gren"), "no colour of this name"),
        (lambda g, i: g.background(1, 2, 3, 4, 5), "background"),
        (lambda g, i: g.createImage(-1, 5, RGB), "at least 1 pixel"),
        (lambda g, i: g.loadImage("a.png", "psd"), "no such kind of picture"),
        (lambda g, i: g.loadImage("nowhere.png"), "There is no file nowhere.png"),
    ],
)
def test_mistakes_are_told(flat, picture, call, message):
    with pytest.raises(SketchError, match=message):
        call(flat, picture)
