from contextlib import nullcontext

import numpy as np
import pytest

from sketchkit.api.pimage import PImage
from sketchkit.core.constants import (
    ADD,
    ARGB,
    BLUR,
    INVERT,
    JAVA2D,
    NORMAL,
    P2D,
    P3D,
    POSTERIZE,
    RGB,
)
from sketchkit.core.notices import SketchWarning
from tests.canvases import new_canvas

RED, GREEN, BLUE, WHITE = 0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFFFFFFFF
CLEAR_RED = 0x80FF0000


@pytest.fixture(params=[JAVA2D, P2D, P3D])
def canvas(request, backend):
    """A small canvas, blue, on each renderer in turn."""
    canvas = new_canvas(request.param, backend, (20, 10), samples=1)
    canvas.background(0, 0, 255)
    canvas.noStroke()
    return canvas


def plain_image(color, size=(4, 4)):
    image = PImage(*size, ARGB)
    image.pixels[:] = color
    return image


def reads(canvas):
    """Count how often the canvas is read back from now on."""
    counts = []
    read = canvas._renderer.backend.read

    def counted(target):
        counts.append(target)
        return read(target)

    canvas._renderer.backend.read = counted
    return counts


@pytest.fixture
def flat(backend):
    canvas = new_canvas(P2D, backend, (20, 10), samples=1)
    canvas.background(0, 0, 255)
    canvas.noStroke()
    yield canvas
    vars(canvas._renderer.backend).pop("read", None)


def test_get_shows_what_was_just_drawn(canvas):
    canvas.fill(255, 0, 0)
    canvas.rect(5, 5, 2, 2)

    assert canvas.get(5, 5) == RED
    assert canvas.get(4, 5) == BLUE
    assert canvas.get(-1, 0) == canvas.get(20, 0) == 0


def test_set_shows_at_once_and_stays_below_what_is_drawn_later(canvas):
    canvas.set(3, 4, RED)
    canvas.set(6, 4, RED)
    canvas.fill(0, 255, 0)
    canvas.rect(6, 4, 1, 1)
    canvas.end_frame()

    data = canvas.image_data()
    assert data[4, 3].tolist() == [255, 0, 0, 255]
    assert data[4, 6].tolist() == [0, 255, 0, 255]


def test_many_calls_in_a_row_read_once(flat):
    counts = reads(flat)

    for i in range(50):
        flat.set(i % 20, i % 10, flat.get(1, 1) + i)

    assert len(counts) == 1


def test_after_drawing_the_first_pixel_is_read_alone(flat):
    counts = reads(flat)

    colors = []
    for i in range(3):
        flat.fill(255, 0, i)
        flat.rect(i, 0, 1, 1)
        colors.append(flat.get(i, 0))

    assert colors == [RED, RED + 1, RED + 2]
    assert counts == []


@pytest.mark.parametrize("is_offscreen", [False, True], ids=["window", "canvas"])
def test_a_pixel_read_alone_is_as_in_the_whole_picture(backend, is_offscreen):
    canvas = new_canvas(P2D, backend, (20, 10), samples=4)
    if is_offscreen:
        canvas = canvas.offscreen(20, 10, P2D, 4)
    with canvas.beginDraw() if is_offscreen else nullcontext():
        canvas.background(0, 0, 255)
        alone = []
        for x in range(20):
            canvas.fill(255, 0, 0)
            canvas.ellipse(4, 3, 7.3, 4.6)
            alone.append(canvas.get(x, 2))

        assert alone == canvas.get().pixels[40:60]
        assert len(set(alone)) > 3


def test_get_of_a_part_and_of_all_are_copies(canvas):
    part, whole = canvas.get(15, 5, 10, 10), canvas.get()

    canvas.background(255)

    assert (part.width, part.height, whole.width, whole.height) == (10, 10, 20, 10)
    assert whole.get(0, 0) == part.get(0, 0) == BLUE
    assert part.get(5, 0) == 0


def test_pixels_are_read_changed_and_shown(canvas):
    canvas.loadPixels()
    assert len(canvas.pixels) == 200
    assert canvas.pixels[0] == BLUE

    canvas.pixels[21] = RED
    canvas.updatePixels()

    assert canvas.image_data()[1, 1].tolist() == [255, 0, 0, 255]


def test_np_pixels_are_the_same_pixels(canvas):
    canvas.loadPixels()
    canvas.np_pixels[2, :, 0] = 255
    canvas.updatePixels()

    assert canvas.get(7, 2) == canvas.pixels[47] == 0xFFFF00FF


def test_a_held_array_follows_the_next_frame(canvas):
    pixels, array = canvas.pixels, canvas.np_pixels

    canvas.loadPixels()

    assert pixels[0] == BLUE
    assert array[0, 0].tolist() == [0, 0, 255, 255]


def test_changes_without_updatePixels_do_not_show(canvas):
    canvas.loadPixels()
    canvas.pixels[0] = RED
    canvas.rect(5, 5, 1, 1)
    canvas.end_frame()

    assert canvas.image_data()[0, 0].tolist() == [0, 0, 255, 255]


def test_updatePixels_puts_the_pixels_below_what_was_drawn_since_loadPixels(canvas):
    canvas.loadPixels()
    canvas.fill(255, 0, 0)
    canvas.rect(5, 5, 1, 1)
    canvas.pixels[0] = GREEN
    canvas.updatePixels()

    assert canvas.get(5, 5) == RED
    assert canvas.get(0, 0) == GREEN


def test_pixels_before_loadPixels_are_none(canvas):
    assert len(canvas.pixels) == 0
    with pytest.warns(SketchWarning, match="loadPixels"):
        canvas.updatePixels()


def test_another_size_gives_other_pixels(canvas):
    canvas.loadPixels()

    canvas.resize(6, 5, P2D, 1)

    assert len(canvas.pixels) == 0
    canvas.loadPixels()
    assert len(canvas.pixels) == 30
    assert canvas.np_pixels.shape == (5, 6, 4)


def test_a_smoothed_canvas_shows_means(backend):
    canvas = new_canvas(P2D, backend, (20, 10), samples=4)
    canvas.background(0)
    canvas.noStroke()
    canvas.triangle(0, 0, 20, 0, 0, 10)

    shades = {canvas.get(x, 5) & 255 for x in range(20)}

    assert shades - {0, 255}


def test_an_image_is_set_without_matrix_and_blended_but_in_java2d(canvas):
    canvas.translate(9, 9)
    canvas.rotate(1)

    canvas.set(2, 3, plain_image(CLEAR_RED))
    canvas.set(12, 3, plain_image(RED))

    assert canvas.get(2, 3) == (CLEAR_RED if canvas._stage.is_java2d else 0xFF80007F)
    assert canvas.get(12, 3) == canvas.get(15, 6) == RED
    assert canvas.get(16, 3) == BLUE


def test_blend_mode_and_clip_hold_for_copies_and_not_for_pixels(canvas):
    canvas.blendMode(ADD)
    canvas.clip(0, 0, 10, 10)

    canvas.copy(plain_image(RED), 0, 0, 4, 4, 8, 0, 4, 4)
    canvas.set(15, 5, GREEN)

    assert canvas.get(9, 0) == 0xFFFF00FF
    assert canvas.get(10, 0) == BLUE
    assert canvas.get(15, 5) == GREEN


def test_a_copy_of_the_canvas_itself(canvas):
    canvas.fill(255, 0, 0)
    canvas.rect(0, 0, 2, 2)

    canvas.copy(0, 0, 4, 4, 10, 2, 4, 4)
    canvas.copy(0, 0, 4, 4, 15, 2, 4, 4)

    for left in (10, 15):
        assert canvas.get(left, 2) == canvas.get(left + 1, 3) == RED
        assert canvas.get(left + 2, 2) == BLUE


def test_an_enlarged_copy_mixes_pixels_but_not_in_java2d(canvas):
    canvas.fill(255, 0, 0)
    canvas.rect(0, 0, 1, 10)

    canvas.copy(0, 0, 4, 4, 10, 0, 8, 8)

    colors = [canvas.get(x, 3) for x in range(10, 14)]
    if canvas._stage.is_java2d:
        assert colors == [RED, RED, BLUE, BLUE]
    else:
        assert colors[0] >> 16 & 255 > colors[1] >> 16 & 255 > colors[2] >> 16 & 255 > 0


def test_copy_without_numbers_is_an_image(canvas):
    image = canvas.copy()

    assert isinstance(image, PImage)
    assert image.get(3, 3) == BLUE


def test_blend_counts_alpha_and_not_the_blend_mode(canvas):
    canvas.blendMode(ADD)

    canvas.blend(plain_image(WHITE), 0, 0, 4, 4, 2, 2, 4, 4, ADD)
    canvas.blend(0, 0, 1, 1, 10, 2, 2, 2, ADD)

    assert canvas.get(3, 3) == WHITE
    assert canvas.get(10, 2) == BLUE


def test_filter_changes_all_that_was_drawn(canvas):
    canvas.fill(255, 0, 0)
    canvas.rect(5, 5, 2, 2)

    canvas.filter(INVERT)
    canvas.fill(0, 0, 1)
    canvas.rect(0, 0, 1, 1)

    assert canvas.get(5, 5) == 0xFF00FFFF
    assert canvas.get(9, 9) == 0xFFFFFF00
    assert canvas.get(0, 0) == 0xFF000001


def test_filters_follow_each_other(canvas):
    canvas.fill(200, 100, 0)
    canvas.rect(0, 0, 10, 10)

    canvas.filter(BLUR, 1)
    canvas.filter(POSTERIZE, 2)

    assert canvas.get(2, 5) == 0xFFFF0000
    assert canvas.get(17, 5) == BLUE


def test_mask_sets_alpha_upside_down_but_in_java2d(canvas):
    mask = PImage(20, 10, RGB)
    mask.pixels[:20] = WHITE  # the top row

    canvas.mask(mask)

    shown, hidden = (0, 9) if canvas._stage.is_java2d else (9, 0)
    assert canvas.get(3, shown) == BLUE
    assert canvas.get(3, hidden) == 0x000000FF


def test_depth_stays_when_pixels_are_sent(backend):
    canvas = new_canvas(P3D, backend, (20, 10), samples=1)
    canvas.background(0)
    canvas.noStroke()
    canvas.fill(255, 0, 0)
    canvas.rect(0, 0, 20, 10)

    canvas.set(0, 0, GREEN)
    canvas.filter(INVERT)
    canvas.translate(0, 0, -5)
    canvas.rect(0, 0, 20, 10)

    assert canvas.get(10, 5) == 0xFF00FFFF


def test_reading_gives_what_the_window_shows(canvas):
    canvas.fill(255, 0, 0, 100)
    canvas.ellipse(10, 5, 8, 8)

    canvas.loadPixels()

    assert np.array_equal(canvas.np_pixels, canvas.image_data())


@pytest.mark.parametrize("is_textured", [False, True])
def test_reading_within_a_shape_loses_none_of_its_corners(canvas, is_textured):
    canvas.textureMode(NORMAL)
    canvas.rect(15, 0, 2, 2)
    canvas.beginShape()
    if is_textured:
        canvas.texture(plain_image(RED))
    canvas.vertex(2, 2, 0, 0)
    canvas.fill(canvas.get(15, 0))
    canvas.vertex(8, 2, 1, 0)
    canvas.rect(0, 0, 1, 1)
    canvas.set(12, 8, GREEN)
    canvas.vertex(8, 8, 1, 1)
    canvas.vertex(2, 8, 0, 1)
    canvas.endShape()

    inside = {canvas.get(x, y) for x, y in ((3, 3), (7, 3), (3, 7), (7, 7))}
    assert inside == {RED if is_textured else WHITE}
    assert canvas.get(9, 3) == BLUE
    assert canvas.get(12, 8) == GREEN


def test_a_list_masks_as_it_stands(canvas):
    canvas.mask([255] * 20 + [0] * 180)

    assert canvas.get(3, 0) == BLUE
    assert canvas.get(3, 9) == 0x000000FF
