"""Lights: where they are, what they add, how many there may be."""

from __future__ import annotations

import math

import pytest

from sketchkit.core.constants import HSB
from sketchkit.core.errors import SketchError
from sketchkit.core.lights import LightKind
from tests.canvases import drawn, draws, fills

EYE_DISTANCE = 50 * math.sqrt(3)  # of the default camera, before a canvas of 100


def lights_of(canvas):
    """Return the lights that a box is drawn in now."""
    canvas.noStroke()
    canvas.box(10)
    return draws(drawn(canvas))[-1].pipeline.lights


def test_usual_lights_are_half_ambient_and_half_from_the_viewer(deep):
    deep.lights()

    ambient, directional = lights_of(deep)

    assert (ambient.kind, ambient.ambient) == (LightKind.AMBIENT, (0.5, 0.5, 0.5))
    assert (directional.kind, directional.diffuse) == (LightKind.DIRECTIONAL, (0.5, 0.5, 0.5))
    assert directional.direction == (0, 0, -1)


def test_usual_lights_drop_those_before(deep):
    deep.pointLight(255, 255, 255, 0, 0, 0)
    deep.lights()

    assert len(lights_of(deep)) == 2


def test_usual_lights_are_the_same_in_any_color_mode(deep):
    deep.colorMode(HSB, 1)
    deep.lights()

    assert lights_of(deep)[0].ambient == (0.5, 0.5, 0.5)


def test_no_lights_shows_colors_as_they_are(deep):
    deep.lights()
    deep.noLights()

    assert lights_of(deep) == ()


def test_point_light_is_placed_before_the_eye(deep):
    deep.pointLight(255, 0, 51, 80, 50, 10)

    (light,) = lights_of(deep)

    assert light.position == pytest.approx((30, 0, 10 - EYE_DISTANCE), abs=1e-3)
    assert light.diffuse == (1, 0, 0.2)


def test_light_is_placed_by_the_matrix_in_force(deep):
    deep.translate(50, 50)
    deep.rotateY(math.pi / 2)
    deep.directionalLight(255, 255, 255, 0, 0, -1)

    (light,) = lights_of(deep)

    assert light.direction == pytest.approx((-1, 0, 0), abs=1e-6)


def test_direction_of_a_light_may_have_any_length(deep):
    deep.directionalLight(255, 255, 255, 0, 30, -40)

    (light,) = lights_of(deep)

    assert light.direction == pytest.approx((0, 0.6, -0.8))


def test_light_color_is_read_in_the_color_mode(deep):
    deep.colorMode(HSB, 360, 100, 100)
    deep.ambientLight(120, 100, 50)

    (light,) = lights_of(deep)

    assert light.ambient == pytest.approx((0, 0.5, 0))


def test_spot_keeps_the_cosine_of_its_cone(deep):
    deep.spotLight(255, 255, 255, 50, 50, 0, 0, 0, -1, math.pi / 3, 4)

    (light,) = lights_of(deep)

    assert light.spot_cosine == pytest.approx(0.5)
    assert light.concentration == 4


def test_falloff_is_for_lights_made_after_it(deep):
    deep.pointLight(9, 9, 9, 0, 0, 0)
    deep.lightFalloff(1, 0.5, 0.25)
    deep.pointLight(9, 9, 9, 0, 0, 0)

    falloffs = [light.falloff for light in lights_of(deep)]

    assert falloffs == [(1, 0, 0), (1, 0.5, 0.25)]


def test_falloff_weakens_no_directional_light(deep):
    deep.lightFalloff(1, 0.5, 0.25)
    deep.directionalLight(9, 9, 9, 0, 0, -1)

    assert lights_of(deep)[0].falloff == (1, 0, 0)


def test_highlights_are_black_until_they_are_set(deep):
    deep.directionalLight(9, 9, 9, 0, 0, -1)
    deep.lightSpecular(255, 255, 0)
    deep.directionalLight(9, 9, 9, 0, 0, -1)

    assert [light.specular for light in lights_of(deep)] == [(0, 0, 0), (1, 1, 0)]


def test_lights_last_for_one_frame(deep):
    deep.lights()
    deep.end_frame()
    deep.begin_frame()

    assert lights_of(deep) == ()


class TestNinthLight:
    @pytest.mark.parametrize(
        "ninth",
        [
            lambda g: g.ambientLight(1, 1, 1),
            lambda g: g.directionalLight(1, 1, 1, 0, 0, -1),
            lambda g: g.pointLight(1, 1, 1, 0, 0, 0),
            lambda g: g.spotLight(1, 1, 1, 0, 0, 0, 0, 0, -1, 1, 1),
        ],
        ids=["ambientLight", "directionalLight", "pointLight", "spotLight"],
    )
    def test_is_refused(self, deep, ninth):
        for i in range(8):
            deep.pointLight(9, 9, 9, i, 0, 0)

        with pytest.raises(SketchError, match="There can be 8 lights"):
            ninth(deep)

    def test_is_refused_after_lights_and_six_others_and_one(self, deep):
        deep.lights()
        for i in range(6):
            deep.pointLight(9, 9, 9, i, 0, 0)

        with pytest.raises(SketchError, match="There can be 8 lights"):
            deep.pointLight(9, 9, 9, 0, 0, 0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.ambientLight("1", 2, 3), r"ambientLight\(\) takes"),
        (lambda g: g.pointLight(1, 2, 3, "x", 0, 0), r"pointLight\(\) takes"),
        (lambda g: g.directionalLight(1, 2, 3, None, 0, -1), r"directionalLight\(\) takes"),
        (lambda g: g.spotLight(1, 2, 3, 0, 0, 0, 0, 0, -1, "wide", 1), r"spotLight\(\) takes"),
        (lambda g: g.lightFalloff("1", 0, 0), r"lightFalloff\(\) takes 3 numbers"),
        (lambda g: g.lightSpecular(None, 0, 0), r"lightSpecular\(\) takes 3 numbers"),
        (lambda g: g.shininess("shiny"), r"shininess\(\) takes 1 number"),
    ],
    ids=[
        "ambientLight",
        "pointLight",
        "directionalLight",
        "spotLight",
        "lightFalloff",
        "lightSpecular",
        "shininess",
    ],
)
def test_what_is_no_number_is_refused(deep, call, message):
    with pytest.raises(SketchError, match=message):
        call(deep)


def test_number_of_a_light_is_named(deep):
    with pytest.raises(SketchError, match="Got text for x: pointLight"):
        deep.pointLight(1, 2, 3, "x", 0, 0)


def test_component_of_a_light_is_named_as_the_color_mode_has_it(deep):
    deep.colorMode(HSB)

    with pytest.raises(SketchError, match="Got text for brightness"):
        deep.directionalLight(1, 2, "3", 0, 0, -1)


def test_refused_light_is_not_added(deep):
    deep.lights()
    with pytest.raises(SketchError):
        deep.pointLight(255, 255, 255, None, 0, 0)

    assert len(lights_of(deep)) == 2


class TestMaterials:
    def test_ambient_color_is_the_fill_until_it_is_set(self, deep):
        deep.lights()
        deep.noStroke()
        deep.fill(200, 100, 50)
        deep.rect(0, 0, 9, 9)
        deep.ambient(1, 2, 3)
        deep.fill(9)
        deep.rect(0, 0, 9, 9)

        ambient = fills(deep).materials.ambient

        assert ambient[[0, 4]].tolist() == [[200, 100, 50, 255], [1, 2, 3, 255]]

    def test_material_at_first(self, deep):
        deep.lights()
        deep.noStroke()
        deep.rect(0, 0, 9, 9)

        materials = fills(deep).materials

        assert materials.specular[0].tolist() == [125, 125, 125, 255]
        assert materials.emissive[0].tolist() == [0, 0, 0, 255]
        assert materials.shininess[0] == 1

    def test_push_style_saves_the_material(self, deep):
        deep.lights()
        deep.noStroke()
        with deep.pushStyle():
            deep.emissive(9)
        deep.rect(0, 0, 9, 9)

        assert fills(deep).materials.emissive[0].tolist() == [0, 0, 0, 255]
