import numpy as np
import pytest
from PIL import Image

from sketchkit.api.pimage import PImage
from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.core.constants import ALPHA, ARGB, RGB
from sketchkit.core.errors import SketchError

COLOR = 0x40102030


@pytest.fixture
def image():
    made = PImage(4, 3, ARGB)
    made.set(1, 1, COLOR)
    return made


@pytest.mark.parametrize(
    ("image_format", "empty", "stored", "pixel"),
    [
        pytest.param(RGB, 0xFF000000, 0xFF102030, 0xFF102030, id="RGB is opaque"),
        pytest.param(ARGB, 0, COLOR, COLOR, id="ARGB keeps alpha"),
        pytest.param(ALPHA, 0x00FFFFFF, 0x30FFFFFF, 0x30, id="ALPHA is white, of the lowest byte"),
    ],
)
def test_formats(image_format, empty, stored, pixel):
    image = PImage(4, 3, image_format)

    image.set(1, 1, COLOR)

    assert (image.width, image.height, image.format) == (4, 3, image_format)
    assert image.get(0, 0) == empty
    assert image.get(1, 1) == stored
    assert image.pixels[5] == pixel


@pytest.mark.parametrize("place", [(-1, 0), (0, -1), (4, 0), (0, 3)])
def test_outside_is_zero_and_not_set(image, place):
    before = image.copy()

    image.set(*place, 0xFFFFFFFF)

    assert image.get(*place) == 0
    assert list(image.pixels) == list(before.pixels)


def test_places_are_cut_off(image):
    assert image.get(1.9, 1.9) == COLOR


def test_a_part_is_a_copy(image):
    part = image.get(1, 1, 2, 2)

    part.set(0, 0, 0)

    assert (part.width, part.height) == (2, 2)
    assert image.get(1, 1) == COLOR


def test_a_part_beyond_the_edge_is_transparent_there():
    image = PImage(4, 3, RGB)
    image.set(1, 1, COLOR)

    part = image.get(-1, -1, 4, 4)  # checked against Processing

    assert part.format == ARGB
    assert [part.get(x, 2) for x in range(4)] == [0, 0xFF000000, 0xFF102030, 0xFF000000]
    assert [part.get(x, 0) for x in range(4)] == [0, 0, 0, 0]


def test_get_without_numbers_is_a_copy(image):
    whole = image.get()

    whole.set(1, 1, 0)

    assert image.get(1, 1) == COLOR


def test_set_with_an_image_replaces_what_it_covers(image):
    image.set(2, 2, image.get(1, 1, 2, 2))

    assert image.get(2, 2) == COLOR
    assert image.get(3, 2) == 0


@pytest.mark.parametrize("place", [(-1, -1), (3, 2), (9, 9), (-9, 0)])
def test_set_with_an_image_is_cut_at_the_edges(image, place):
    other = PImage(2, 2, RGB)

    image.set(*place, other)

    x, y = place
    covered = {(x + i, y + j) for i in range(2) for j in range(2)}
    black = {(i, j) for i in range(4) for j in range(3) if image.get(i, j) == 0xFF000000}
    assert black == covered & {(i, j) for i in range(4) for j in range(3)}


@pytest.mark.parametrize(
    ("size", "asked", "expected"),
    [  # from Processing: ratios are computed with 32 bits, and cut off
        ((160, 120), (0, 119), (158, 119)),
        ((100, 33), (99, 0), (99, 32)),
        ((640, 480), (0, 301), (401, 301)),
        ((4, 3), (8, 6), (8, 6)),
    ],
)
def test_resize_with_zero_keeps_the_proportions(size, asked, expected):
    image = PImage(*size)

    image.resize(*asked)

    assert (image.width, image.height) == expected
    assert len(image.pixels) == expected[0] * expected[1]


def test_what_is_drawn_is_a_copy_that_stays_until_a_change(image):
    drawn = image._texture()
    assert image._texture() is drawn

    image.set(0, 0, 0xFFFFFFFF)

    assert drawn.data[0, 0].tolist() == [0, 0, 0, 0]
    assert image._texture() is not drawn
    assert image._texture().data[0, 0].tolist() == [255, 255, 255, 255]


@pytest.mark.parametrize(
    "change",
    [
        lambda image: image.set(0, 0, 1),
        lambda image: image.pixels.__setitem__(0, 1),
        lambda image: image.updatePixels(),
        lambda image: image.resize(2, 2),
        lambda image: image.set(0, 0, PImage(1, 1)),
    ],
    ids=["set", "pixels", "updatePixels", "resize", "set image"],
)
def test_every_change_is_drawn_next_time(image, change):
    drawn = image._texture()

    change(image)

    assert image._texture() is not drawn


def test_np_pixels_are_the_image_itself(image):
    image.np_pixels[0, 3] = (1, 2, 3, 4)

    assert image.np_pixels.shape == (3, 4, 4)
    assert image.get(3, 0) == 0x04010203


def test_a_held_pixel_array_stays_alive(image):
    pixels = image.pixels

    image.loadPixels()
    pixels[0] = COLOR
    image.updatePixels()

    assert image.get(0, 0) == COLOR


def test_save_writes_beside_the_sketch(image, tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)

    image.save("out/a.png")
    PImage(2, 2).save("b")

    set_sketch_folder(before)
    with Image.open(tmp_path / "out" / "a.png") as picture:
        assert np.array(picture)[1, 1].tolist() == [0x10, 0x20, 0x30, 0x40]
    with Image.open(tmp_path / "b.tif") as picture:
        assert (picture.size, picture.mode) == ((2, 2), "RGB")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda image: PImage(0, 5), "at least 1 pixel"),
        (lambda image: PImage(5, 5, 77), "RGB, ARGB or ALPHA"),
        (lambda image: PImage("5", 5), "Got text for width"),
        (lambda image: image.get(1), "takes 0, 2 or 4 numbers"),
        (lambda image: image.get(1, 2, 3), "takes 0, 2 or 4 numbers"),
        (lambda image: image.set("a", 2, 3), "Got text for x"),
        (lambda image: image.set(1, 2, "gren"), "no colour of this name"),
        (lambda image: image.set(1, 2, None), "set"),
        (lambda image: image.resize(0, 0), "one of them may be 0"),
        (lambda image: image.resize(-5, 5), "one of them may be 0"),
        (lambda image: image.updatePixels(1), "takes 0 or 4 numbers"),
        (lambda image: image.save("a.xyz"), "file name ends in"),
    ],
)
def test_mistakes_are_told(image, call, message):
    with pytest.raises(SketchError, match=message):
        call(image)


def test_an_image_without_alpha_is_drawn_opaque():
    image = PImage(1, 1, RGB)

    image.pixels[0] = COLOR

    assert image.pixels[0] == COLOR
    assert image.get(0, 0) == 0xFF102030
    assert image._texture().data[0, 0].tolist() == [0x10, 0x20, 0x30, 255]


def test_a_mask_is_drawn_white():
    image = PImage(1, 1, ALPHA)

    image.pixels[0] = 77

    assert image._texture().data[0, 0].tolist() == [255, 255, 255, 77]


def test_floats_of_bytes_go_from_0_to_1(image):
    image.set(0, 0, 0xFFFF0033)

    assert image.np_floats[0, 0].tolist() == pytest.approx([1, 0, 0.2])


def test_floats_that_are_set_stay_and_show_cut():
    image = PImage(2, 1)

    image.np_floats = [[[0.5, 3, -1], [1, 0, 0]]]

    assert image.np_floats[0, 0].tolist() == [0.5, 3, -1]
    assert image.get(0, 0) == 0xFF80FF00


def test_a_changed_pixel_ends_the_floats():
    image = PImage(2, 1)
    image.np_floats = np.full((1, 2, 3), 3.0)

    image.set(0, 0, 0xFF000000)

    assert image.np_floats.max() == 1


def test_floats_are_saved_and_loaded(tmp_path):
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    image = PImage(2, 1)
    image.np_floats = np.array([[[8, 0.5, 0], [0, 0, 16]]])

    image.save("light.hdr")
    again = PImage._load("loadImage", "light.hdr")

    set_sketch_folder(before)
    assert (again.np_floats == image.np_floats).all()
    assert again.format == RGB


def test_pixels_can_be_set_all_at_once(image):
    image.pixels = [COLOR] * 12

    assert set(image.pixels) == {COLOR}


@pytest.mark.parametrize("suffix", ["jpg", "bmp", "tga", "gif", "webp", "tif"])
def test_transparent_images_are_saved_as_every_kind(image, tmp_path, suffix):
    image.save(str(tmp_path / f"a.{suffix}"))

    with Image.open(tmp_path / f"a.{suffix}") as picture:
        assert picture.size == (4, 3)
