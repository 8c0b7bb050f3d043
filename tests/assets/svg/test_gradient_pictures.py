import pytest

from sketchkit.assets.svg.gradient_pictures import SIDE, gradient_picture
from sketchkit.assets.svg.gradients import Gradient

RED, BLUE = 0xFFFF0000, 0x800000FF
STOPS = ((0.0, RED), (1.0, BLUE))


def test_linear_gradient_runs_from_one_end_to_the_other():
    picture = gradient_picture(Gradient(False, (10, 0, 110, 0), STOPS), (10, 0, 100, 50))

    assert picture.shape == (SIDE, SIDE, 4)
    assert picture[0, 0].tolist() == pytest.approx([255, 0, 0, 255], abs=1)
    assert picture[9, -1].tolist() == pytest.approx([0, 0, 255, 128], abs=1)
    assert picture[0, SIDE // 2].tolist() == pytest.approx([127, 0, 128, 191], abs=1)


def test_colour_goes_on_before_and_after_the_ends():
    picture = gradient_picture(Gradient(False, (40, 0, 60, 0), STOPS), (0, 0, 100, 100))

    assert picture[0, 10].tolist() == [255, 0, 0, 255]
    assert picture[0, -10].tolist() == [0, 0, 255, 128]


def test_radial_gradient_is_round_in_the_drawing():
    picture = gradient_picture(Gradient(True, (50, 50, 25), STOPS), (0, 0, 100, 200))

    centre = picture[SIDE // 4, SIDE // 2]
    beside, below = picture[SIDE // 4, SIDE * 5 // 8], picture[SIDE * 5 // 16, SIDE // 2]
    assert centre.tolist() == pytest.approx([255, 0, 0, 255], abs=4)
    assert beside.tolist() == pytest.approx(below.tolist(), abs=4)  # 12.5 away


@pytest.mark.parametrize(
    "gradient",
    [
        Gradient(False, (5, 5, 5, 5), STOPS),
        Gradient(True, (5, 5, 0), STOPS),
        Gradient(False, (0, 0, 1, 1), ()),
    ],
    ids=["no length", "no radius", "no stops"],
)
def test_gradient_of_nothing_is_a_picture_too(gradient):
    assert gradient_picture(gradient, (0, 0, 10, 10)).shape == (SIDE, SIDE, 4)
