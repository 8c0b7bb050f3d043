import numpy as np
import pytest

from sketchkit.api.pixel_array import PixelArray
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import Pixels

ORANGE = 0xFFCC6600


@pytest.fixture
def image():
    return Pixels(np.zeros((2, 3, 4), np.uint8))


def test_colours_are_unsigned_ints_row_by_row(image):
    image.data[1, 0] = (0xCC, 0x66, 0x00, 0xFF)

    pixels = PixelArray(image)

    assert len(pixels) == 6
    assert pixels[3] == ORANGE
    assert list(pixels) == [0, 0, 0, ORANGE, 0, 0]
    assert pixels[-3] == ORANGE


@pytest.mark.parametrize(
    "color",
    [ORANGE, ORANGE - 2**32, "#CC6600", np.int64(ORANGE), np.uint32(ORANGE)],
    ids=["int", "negative, as Java has it", "text", "int64", "uint32"],
)
def test_setting_writes_rgba_and_counts_as_a_change(image, color):
    PixelArray(image)[2] = color

    assert image.data[0, 2].tolist() == [0xCC, 0x66, 0x00, 0xFF]
    assert image.version == 1


def test_float_places_are_cut_off(image):
    pixels = PixelArray(image)

    pixels[2.9] = ORANGE

    assert pixels[2] == pixels[2.0] == ORANGE


def test_slices_take_one_colour_or_as_many_as_they_are_long(image):
    pixels = PixelArray(image)

    pixels[:3] = "#FF0000"
    pixels[4:] = [1, -1]
    pixels[3:4] = np.array([-2])

    assert pixels[2:] == [0xFFFF0000, 0xFFFFFFFE, 1, 0xFFFFFFFF]


def test_numpy_sees_packed_colours(image):
    pixels = PixelArray(image)
    pixels[1] = ORANGE

    assert np.asarray(pixels).tolist() == [0, ORANGE, 0, 0, 0, 0]
    assert np.asarray(pixels).dtype == np.uint32


@pytest.mark.parametrize(("place", "shown"), [(6, "6"), (-7, "-7"), ("a", "'a'")])
def test_a_place_outside_is_told(image, place, shown):
    pixels = PixelArray(image)

    with pytest.raises(SketchError) as reading:
        pixels[place]
    with pytest.raises(SketchError) as writing:
        pixels[place] = 0

    assert reading.value.got == writing.value.got == f"pixels[{shown}]"


def test_too_few_colours_for_a_slice_are_told(image):
    with pytest.raises(SketchError) as caught:
        PixelArray(image)[:] = [0, 1]

    assert caught.value.got == "2 colours for 6 pixels"


def test_what_is_no_colour_is_told(image):
    with pytest.raises(SketchError, match="no colour of this name"):
        PixelArray(image)[0] = "oragne"


def test_a_window_on_nothing_says_what_to_write(image):
    pixels = PixelArray(image)
    pixels.give_up()

    with pytest.raises(SketchError, match="There are no pixels yet") as caught:
        pixels[0]

    assert caught.value.hint == "Write loadPixels() first."
    assert len(pixels) == 0


def test_a_window_can_move_to_another_image(image):
    pixels = PixelArray(image)
    other = Pixels(np.full((1, 2, 4), 255, np.uint8))

    pixels.show(other)

    assert list(pixels) == [0xFFFFFFFF] * 2
