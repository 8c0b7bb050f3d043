"""What must pass and what must not, on pictures that sketchkit draws."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from sketchkit.grading.images.verdict import Tolerance, judge
from tests.grading.images.drawing import FLAT, SOLID, changed, drawn

U8 = NDArray[np.uint8]


@pytest.fixture(scope="module")
def flat(tmp_path_factory: pytest.TempPathFactory) -> U8:
    """Shapes in 2D, 160 x 120."""
    return drawn(tmp_path_factory.mktemp("flat"), FLAT)


@pytest.fixture(scope="module")
def solid(tmp_path_factory: pytest.TempPathFactory) -> U8:
    """A box and a sphere in light."""
    return drawn(tmp_path_factory.mktemp("solid"), SOLID)


def eight_bits(values: NDArray[np.float64]) -> U8:
    return np.rint(np.clip(values, 0, 255)).astype(np.uint8)


def test_equal_pictures_are_alike(flat: U8) -> None:
    verdict = judge(flat, flat.copy())

    assert verdict.is_alike
    assert (verdict.distance, verdict.flip_mean, verdict.flip_high, verdict.region) == (0, 0, 0, 0)
    assert (verdict.region_box, verdict.reason, verdict.explanation) == (None, "", "")
    assert verdict.heat.shape == flat.shape


@pytest.mark.parametrize("source", [FLAT, SOLID], ids=["2D", "3D"])
def test_edges_without_smoothing_are_alike(tmp_path: Path, source: str) -> None:
    smooth = drawn(tmp_path, source)
    rough = drawn(tmp_path, source.replace("    background", "    noSmooth()\n    background"))

    assert not np.array_equal(smooth, rough)
    assert judge(rough, smooth).is_alike
    assert judge(smooth, rough).is_alike


def test_rounding_of_a_driver_is_alike(solid: U8) -> None:
    noise = np.random.default_rng(1).integers(-1, 2, solid.shape)

    assert judge(eight_bits(solid.astype(float) + noise), solid).is_alike


@pytest.mark.parametrize(
    ("before", "after"),
    [
        pytest.param("circle(110, 45, 50)", "pass", id="missing circle"),
        pytest.param("rect(142, 98, 8, 8)", "pass", id="missing square of 8 x 8"),
        pytest.param("line(95, 112, 150, 83)", "pass", id="missing line"),
        pytest.param("    stroke(20)\n", "", id="missing stroke"),
        pytest.param("fill(200, 80, 40)", "fill(180, 80, 40)", id="colour off by 20"),
        pytest.param("circle(110, 45, 50)", "circle(113, 45, 50)", id="circle 3 pixels off"),
        pytest.param("strokeWeight(2)", "strokeWeight(6)", id="thick stroke"),
    ],
)
def test_mistake_in_2d_is_not_alike(tmp_path: Path, flat: U8, before: str, after: str) -> None:
    assert not judge(drawn(tmp_path, changed(FLAT, before, after)), flat).is_alike


@pytest.mark.parametrize(
    ("before", "after"),
    [
        pytest.param("circle(110, 45, 50)", "circle(111, 45, 50)", id="circle a pixel off"),
        pytest.param("rect(142, 98, 8, 8)", "rect(142, 99, 8, 8)", id="small square a pixel off"),
        pytest.param("strokeWeight(1)", "strokeWeight(2)", id="line of 2 pixels instead of 1"),
        pytest.param("fill(30, 90, 160)", "fill(36, 90, 160)", id="colour off by 6"),
    ],
)
def test_slight_mistake_is_not_alike_but_near(
    tmp_path: Path, flat: U8, before: str, after: str
) -> None:
    verdict = judge(drawn(tmp_path, changed(FLAT, before, after)), flat)

    assert not verdict.is_alike
    assert 1 < verdict.distance <= 2
    assert verdict.reason.startswith("A region of")


def test_colour_off_by_rounding_and_a_little_more_is_alike(tmp_path: Path, flat: U8) -> None:
    submitted = drawn(tmp_path, changed(FLAT, "fill(30, 90, 160)", "fill(33, 90, 160)"))

    assert judge(submitted, flat).is_alike


def test_edges_that_lie_elsewhere_are_told(tmp_path: Path, flat: U8) -> None:
    submitted = drawn(tmp_path, changed(FLAT, "circle(110, 45, 50)", "circle(111, 45, 50)"))

    assert "an edge lies a little elsewhere" in judge(submitted, flat).reason


@pytest.mark.parametrize(
    ("before", "after"),
    [
        pytest.param("    lights()\n", "", id="no light"),
        pytest.param("lights()", "lights(); ambientLight(40, 40, 40)", id="another light"),
        pytest.param("sphere(22)", "sphereDetail(5); sphere(22)", id="coarse sphere"),
        pytest.param("rotateX(0.4)", "pass", id="missing rotation"),
    ],
)
def test_mistake_in_3d_is_not_alike(tmp_path: Path, solid: U8, before: str, after: str) -> None:
    assert not judge(drawn(tmp_path, changed(SOLID, before, after)), solid).is_alike


def test_negated_normal_is_not_alike(tmp_path: Path) -> None:
    source = """
def setup():
    size(80, 60, P3D)
    background(0)
    directionalLight(255, 255, 255, 0, 0, -1)
    noStroke()
    beginShape(QUADS)
    normal(0, 0, 1)
    vertex(10, 10)
    vertex(70, 10)
    vertex(70, 50)
    vertex(10, 50)
    endShape()
"""
    expected = drawn(tmp_path, source)

    submitted = drawn(tmp_path, changed(source, "normal(0, 0, 1)", "normal(0, 0, -1)"))

    assert not judge(submitted, expected).is_alike


def test_missing_object_is_told_with_its_place_and_colours(tmp_path: Path, flat: U8) -> None:
    verdict = judge(drawn(tmp_path, changed(FLAT, "rect(142, 98, 8, 8)", "pass")), flat)

    assert verdict.region == 64
    assert verdict.region_box == (142, 98, 8, 8)
    assert verdict.distance == pytest.approx(math.sqrt(64 / 12))
    assert "A region of 8 x 8 pixels at the right bottom differs" in verdict.reason
    assert "(235, 235, 235) on average where (0, 120, 90) is expected" in verdict.reason
    assert verdict.explanation == ""


TRANSFORMED = {
    "flipped in y": lambda picture: picture[::-1],
    "mirrored in x": lambda picture: picture[:, ::-1],
    "turned by 180 degrees": lambda picture: picture[::-1, ::-1],
    "red and blue swapped": lambda picture: picture[..., ::-1],
    "red and green swapped": lambda picture: picture[..., [1, 0, 2]],
    "green and blue swapped": lambda picture: picture[..., [0, 2, 1]],
    "colours rotated": lambda picture: picture[..., [1, 2, 0]],
    "colours inverted": lambda picture: 255 - picture,
    "greyscale": lambda picture: np.repeat(
        eight_bits(picture @ [0.3, 0.59, 0.11])[..., None], 3, axis=2
    ),
    "gamma": lambda picture: eight_bits((picture / 255) ** 2.2 * 255),
    "brightness": lambda picture: eight_bits(picture * 0.7),
    "half a pixel": lambda picture: eight_bits((picture + np.roll(picture, 1, 1).astype(int)) / 2),
    "moved": lambda picture: np.roll(picture, (2, -3), (0, 1)),
}


@pytest.mark.parametrize("name", TRANSFORMED)
@pytest.mark.parametrize("scene", ["flat", "solid"])
def test_transformation_is_named(request: pytest.FixtureRequest, scene: str, name: str) -> None:
    expected: U8 = request.getfixturevalue(scene)

    verdict = judge(np.ascontiguousarray(TRANSFORMED[name](expected)), expected)

    assert not verdict.is_alike
    assert verdict.explanation == name


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ("flipped in y", "Turned upside down, your picture is the expected one."),
        ("gamma", "With a gamma of 2.2 undone, your picture is the expected one."),
        ("brightness", "another brightness, every colour times 0.70"),
        ("half a pixel", "the expected one, moved half a pixel to the right"),
        ("moved", "the expected one, moved 3 pixels to the left and 2 pixels down"),
    ],
)
def test_transformation_is_told_in_a_sentence(flat: U8, change: str, sentence: str) -> None:
    verdict = judge(np.ascontiguousarray(TRANSFORMED[change](flat)), flat)

    assert sentence in verdict.reason


@pytest.mark.parametrize(
    ("place", "paint", "words"),
    [
        ("flipped in y", "gamma", "Turned upside down and with a gamma of 2.2 undone, your"),
        ("mirrored in x", "red and blue swapped", "left to right and with red and blue swapped"),
        ("turned by 180 degrees", "brightness", "Turned by 180 degrees, your picture is the exp"),
    ],
)
def test_two_transformations_at_once_are_told(flat: U8, place: str, paint: str, words: str) -> None:
    submitted = TRANSFORMED[paint](TRANSFORMED[place](flat))

    verdict = judge(np.ascontiguousarray(submitted), flat)

    assert verdict.explanation == f"{place}, {paint}"
    assert words in verdict.reason


def test_picture_drawn_half_a_pixel_aside_is_told_so(tmp_path: Path, flat: U8) -> None:
    circles = """
def setup():
    size(100, 80)
    noStroke()
    fill(0, 60, 120)
    translate(0, 0)
    for x in (25, 60, 80):
        circle(x, 0.5 * x + 10, 24)
"""
    submitted = drawn(tmp_path, changed(circles, "translate(0, 0)", "translate(0.5, 0)"))

    verdict = judge(submitted, drawn(tmp_path, circles))

    assert verdict.explanation == "half a pixel"


def test_flip_about_a_middle_a_pixel_off_is_told(flat: U8) -> None:
    submitted = np.roll(flat[::-1], 1, 0)
    submitted[0] = submitted[1]

    assert judge(submitted, flat).explanation == "flipped in y"


def test_frame_on_which_nothing_is_drawn_explains_nothing(tmp_path: Path, flat: U8) -> None:
    submitted = drawn(tmp_path, changed(FLAT, "background(235)", "background(204)"))

    verdict = judge(submitted, flat, alternatives={"frame 0": np.full_like(flat, 204)})

    assert "frame 0" not in verdict.reason


def test_one_explanation_alone_can_be_tried(flat: U8) -> None:
    submitted = flat[::-1]

    assert judge(submitted, flat, only="flipped in y").explanation == "flipped in y"
    assert judge(submitted, flat, only="gamma").explanation == ""


@pytest.mark.parametrize(
    ("exponent", "words"), [(1 / 2.2, "a gamma of 1/2.2"), (1.4, "a gamma of 1.4")]
)
def test_gamma_is_measured(solid: U8, exponent: float, words: str) -> None:
    verdict = judge(eight_bits((solid / 255) ** exponent * 255), solid)

    assert words in verdict.reason


def test_whole_picture_that_moved_by_a_pixel_is_not_alike(flat: U8) -> None:
    assert not judge(np.roll(flat, 1, 1), flat).is_alike


def test_share_of_the_pixels_is_told_where_it_is_not_all(flat: U8) -> None:
    submitted = flat[::-1].copy()
    submitted[40:52, 70:82] = (255, 0, 255)

    verdict = judge(submitted, flat)

    assert verdict.explanation == "flipped in y"
    assert "99.2 % of the pixels agree then" in verdict.reason


def test_symmetrical_picture_is_not_called_mirrored() -> None:
    expected = np.full((60, 81, 3), 255, np.uint8)
    expected[10:50, 30:51] = 0
    submitted = expected.copy()
    submitted[20:30, 36:45] = 255

    assert judge(submitted, expected).explanation == ""


def test_wrong_grey_of_one_object_is_no_gamma() -> None:
    expected = np.full((60, 80, 3), 255, np.uint8)
    expected[10:50, 30:50] = 150
    submitted = expected.copy()
    submitted[10:50, 30:50] = 90

    assert judge(submitted, expected).explanation == ""


def test_one_flat_colour_is_told(flat: U8) -> None:
    verdict = judge(np.full_like(flat, 204), flat)

    assert verdict.explanation == "one flat colour"
    assert "one flat colour, (204, 204, 204)" in verdict.reason


@pytest.mark.parametrize("submitted", [(255, 0, 0), (0, 0, 255), (90, 90, 90)])
def test_two_flat_pictures_are_explained_by_nothing(submitted: tuple[int, int, int]) -> None:
    pictures = (np.full((20, 30, 3), color, np.uint8) for color in (submitted, (0, 128, 255)))

    verdict = judge(*pictures)

    assert not verdict.is_alike
    assert verdict.explanation == ""


def test_moment_of_half_a_pixels_movement_is_no_frame(tmp_path: Path, solid: U8) -> None:
    half = np.roll(solid, 1, 1)
    submitted = ((half.astype(int) + solid) // 2).astype(np.uint8)
    near = drawn(tmp_path, changed(SOLID, "rotateY(0.5)", "rotateY(0.51)"))

    assert judge(submitted, solid, alternatives={"frame 2": near}).explanation == "half a pixel"


def test_other_frame_is_told(tmp_path: Path, solid: U8) -> None:
    other = drawn(tmp_path, changed(SOLID, "rotateY(0.5)", "rotateY(0.8)"))

    verdict = judge(
        other, solid, alternatives={"frame 29": other, "frame 30": solid}, name="frame 30"
    )

    assert verdict.explanation == "frame 29"
    assert verdict.reason == "This is frame 29, not frame 30."


def test_reference_without_lights_is_told(tmp_path: Path, solid: U8) -> None:
    dark = drawn(tmp_path, changed(SOLID, "    lights()\n", ""))

    verdict = judge(dark, solid, alternatives={"depth test off": solid, "lights off": dark})

    assert verdict.explanation == "lights off"
    assert "without lights" in verdict.reason


def test_alternative_that_is_the_expected_picture_explains_nothing(
    tmp_path: Path, flat: U8
) -> None:
    submitted = drawn(tmp_path, changed(FLAT, "circle(110, 45, 50)", "pass"))

    assert judge(submitted, flat, alternatives={"lights off": flat}).explanation == ""


def test_alternative_of_another_size_is_passed_over(flat: U8) -> None:
    assert judge(flat[::-1], flat, alternatives={"frame 1": flat[:5]}).explanation == "flipped in y"


def test_tolerance_decides(flat: U8) -> None:
    submitted = flat.copy()
    submitted[100:104, 3:8] = 0  # 20 pixels

    assert not judge(submitted, flat).is_alike
    assert judge(submitted, flat, Tolerance(mean=0.1, high=1, region=20)).is_alike


def test_nothing_tolerated_is_a_number_still(flat: U8) -> None:
    verdict = judge(np.roll(flat, 40, 1), flat, Tolerance(0, 0, 0))

    assert verdict.distance == 1000


def test_negative_tolerance_is_refused() -> None:
    with pytest.raises(ValueError, match="from 0 on"):
        Tolerance(mean=-1)


@pytest.mark.parametrize("size", [(1, 1), (1, 9), (9, 1), (2, 2), (5, 7), (8, 8), (17, 26)])
@pytest.mark.parametrize("kind", ["noise", "flat"])
def test_pictures_of_any_size_have_a_verdict(size: tuple[int, int], kind: str) -> None:
    random = np.random.default_rng(5)
    submitted, expected = random.integers(0, 256, (2, *size, 3), dtype=np.uint8)
    if kind == "flat":
        submitted[:], expected[:] = 10, 240

    verdict = judge(submitted, expected)

    assert not verdict.is_alike
    assert math.isfinite(verdict.distance)
    assert verdict.reason.endswith(".")
    assert verdict.heat.shape == (*size, 3)
