"""FLIP is held against its authors' own program."""

import flip_evaluator
import numpy as np
import pytest
from numpy.typing import NDArray

from sketchkit.grading.images.flip import TILE, flip

U8 = NDArray[np.uint8]

random = np.random.default_rng(7)


def noise(height: int, width: int) -> U8:
    return random.integers(0, 256, (height, width, 3), dtype=np.uint8)


def flat(*color: int) -> U8:
    return np.full((40, 50, 3), color, np.uint8)


def ramp() -> U8:
    picture = np.zeros((90, 256, 3), np.uint8)
    picture[..., 0] = np.arange(256)
    picture[30:60, 60:120] = (40, 200, 250)
    return picture


def theirs(expected: U8, submitted: U8) -> NDArray[np.float32]:
    pictures = (picture.astype(np.float32) / 255 for picture in (expected, submitted))
    errors, _, _ = flip_evaluator.evaluate(*pictures, "LDR", applyMagma=False)
    return errors[..., 0]


@pytest.mark.parametrize(
    ("expected", "submitted"),
    [
        pytest.param(noise(60, 80), noise(60, 80), id="noise"),
        pytest.param(noise(1, 1), noise(1, 1), id="one pixel"),
        pytest.param(noise(3, 40), noise(3, 40), id="lower than the filters"),
        pytest.param(flat(0, 255, 0), flat(0, 0, 255), id="the largest difference of colours"),
        pytest.param(flat(0, 0, 0), flat(255, 255, 255), id="black and white"),
        pytest.param(ramp(), ramp()[:, ::-1].copy(), id="mirrored"),
        pytest.param(ramp(), np.maximum(ramp(), 6), id="nearly black"),
        pytest.param(noise(TILE + 30, TILE + 20), noise(TILE + 30, TILE + 20), id="many tiles"),
    ],
)
def test_differences_are_those_of_its_authors(expected: U8, submitted: U8) -> None:
    ours = flip(expected, submitted)

    assert np.abs(ours - theirs(expected, submitted)).max() < 1e-3


def test_what_is_left_out_as_equal_is_0_there_too() -> None:
    expected = noise(TILE + 60, 2 * TILE)
    submitted = expected.copy()
    submitted[TILE - 3 : TILE + 5, TILE + 8 : TILE + 14] = 0

    ours = flip(expected, submitted)

    assert np.abs(ours - theirs(expected, submitted)).max() < 1e-3
    assert ours.max() > 0.3


def test_equal_pictures_differ_nowhere() -> None:
    picture = noise(20, 30)

    assert not flip(picture, picture.copy()).any()
