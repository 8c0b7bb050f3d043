import numpy as np
import pytest
from numpy.typing import NDArray

from sketchkit.grading.images.verdict import judge

U8 = NDArray[np.uint8]


def scene() -> U8:
    picture = np.full((60, 80, 3), 240, np.uint8)
    picture[5:30, 8:40] = (200, 40, 0)
    picture[35:50, 50:75] = (0, 60, 180)
    return picture


def judged(submitted: U8) -> tuple[str, str]:
    verdict = judge(np.ascontiguousarray(submitted), scene())
    assert not verdict.is_alike
    assert verdict.distance > 10
    assert verdict.heat.shape == scene().shape
    return verdict.reason, verdict.explanation


def test_both_sizes_are_told() -> None:
    reason, explanation = judged(np.zeros((20, 20, 3), np.uint8))

    assert reason == "Your picture is 20 x 20 pixels; 80 x 60 is expected."
    assert explanation == ""


@pytest.mark.parametrize(
    ("submitted", "words", "name"),
    [
        (scene()[:40, :70], "It is the left top part of the expected one.", "cut off"),
        (
            np.pad(scene(), ((0, 9), (0, 5), (0, 0))),
            "The expected one is its left top part.",
            "too large",
        ),
        (scene().repeat(2, 0).repeat(2, 1), "scaled by 2.", "scaled"),
        (scene()[::2, ::2], "scaled by 0.5.", "scaled"),
        (np.rot90(scene(), -1), "Turned back by 90 degrees", "turned by 90 degrees"),
        (np.full((80, 60, 3), 240, np.uint8), "Width and height are swapped.", ""),
    ],
)
def test_what_explains_the_size_is_told(submitted: U8, words: str, name: str) -> None:
    reason, explanation = judged(submitted)

    assert words in reason
    assert explanation == name


def test_background_alone_is_no_part_of_the_expected_picture() -> None:
    assert judged(np.full((30, 40, 3), 240, np.uint8))[1] == ""


def test_one_pixel_and_many() -> None:
    assert judged(np.zeros((1, 1, 3), np.uint8))[1] == ""
