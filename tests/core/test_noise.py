"""Expected numbers were measured with Processing's noise()."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.errors import SketchError
from sketchkit.core.noise import PerlinNoise

NEAR = {"abs": 1e-8}  # the numbers are written with 8 digits


@pytest.mark.parametrize(
    ("seed", "place", "expected"),
    [
        (0, (0.5,), 0.66836804),
        (0, (1.5, 2.5), 0.36199683),
        (99, (123.3,), 0.59637016),
        (0, (0.9400000000000001,), 0.58316189),
        (1, (197.11060964159398, 99.61226507505039), 0.42790014),
        (99, (131.43006097563892, 282.2092784793264), 0.34189516),
        (0, (265.9, 235.0), 0.21781895),
        (0, (93.3, 262.5, 267.9), 0.58483160),
        (-5, (186.41369606996676, 251.94019601443182, 29.72226098545722), 0.47593898),
        (99, (198.3, 78.5, 46.3), 0.43497354),
        (0, (0.7000000000000001,), 0.66323668),
    ],
    ids=str,
)
def test_a_seed_gives_processings_noise(seed, place, expected):
    assert PerlinNoise(seed).at(*place) == pytest.approx(expected, **NEAR)


@pytest.mark.parametrize(
    ("octaves", "falloff", "place", "expected"),
    [
        (1, 0.5, (192.5276273042024, 63.73492259834692, 271.9688030195047), 0.09521054),
        (8, 0.65, (138.96731467470224, 226.0741517207155, 118.51276804735886), 0.40233722),
        (2, 0.2, (296.5911086122927, 194.42462333494083, 38.554501475203004), 0.29794765),
        (3, 1.0, (88.91475585980874, 69.50989300400724, 201.21969778498251), 0.83589840),
    ],
)
def test_detail_sets_octaves_and_falloff(octaves, falloff, place, expected):
    noise = PerlinNoise(0)

    noise.detail(octaves, falloff)

    assert noise.at(*place) == pytest.approx(expected, **NEAR)


def test_detail_that_is_not_above_zero_changes_nothing():
    noise = PerlinNoise(0)

    noise.detail(0, 0)

    assert (noise.octaves, noise.falloff) == (4, 0.5)


@given(st.floats(-300, 300), st.floats(-300, 300), st.floats(-300, 300))
def test_noise_is_mirrored_at_zero(x, y, z):
    noise = PerlinNoise(0)

    assert noise.at(x, y, z) == noise.at(-x, -y, -z)


@given(st.floats(0, 1000), st.floats(0, 1000), st.floats(0, 1000))
def test_noise_stays_between_zero_and_one(x, y, z):
    assert 0 <= PerlinNoise(1).at(x, y, z) <= 1


def test_zero_for_a_dimension_is_the_same_as_leaving_it_out():
    noise = PerlinNoise(3)

    assert noise.at(1.3, 2.7) == noise.at(1.3, 2.7, 0.0)


def test_seeding_again_gives_other_noise():
    noise = PerlinNoise(0)
    before = noise.at(0.5)

    noise.seed(1)

    assert noise.at(0.5) != before


def test_a_place_that_is_not_finite_is_refused():
    with pytest.raises(SketchError, match="finite"):
        PerlinNoise(0).at(float("nan"))
