"""Lit colours; the numbers are those of Processing."""

from __future__ import annotations

from math import atan, cos, pi, sin

import numpy as np
import pytest

from sketchkit.backends.cpu.lighting import light_vertices
from sketchkit.core.lights import Light, LightKind
from sketchkit.draw.vertex import Materials, VertexBlock

NONE, HALF, FULL = (0.0,) * 3, (0.5,) * 3, (1.0,) * 3
CONSTANT = (1.0, 0.0, 0.0)
TO_VIEWER = (0.0, 0.0, 1.0)
AMBIENT = Light(LightKind.AMBIENT, NONE, NONE, HALF, NONE, NONE, CONSTANT)
AHEAD = Light(LightKind.DIRECTIONAL, NONE, (0.0, 0.0, -1.0), NONE, HALF, NONE, CONSTANT)


def lit(
    *lights: Light,
    normal: tuple[float, ...] = TO_VIEWER,
    place: tuple[float, ...] = (0.0, 0.0, -100.0),
    specular: int = 0,
    emissive: int = 0,
    shininess: float = 1.0,
) -> tuple[int, int]:
    """Return the red of front and back of a vertex of grey 200, 0..255 and cut off."""
    block = VertexBlock(
        positions=np.array([place], np.float32),
        colors=np.array([[200, 200, 200, 255]], np.uint8),
        indices=np.zeros(0, np.uint32),
        normals=np.array([normal], np.float32),
        materials=Materials(
            ambient=np.array([[200, 200, 200, 255]], np.uint8),
            specular=np.full((1, 4), specular, np.uint8),
            emissive=np.full((1, 4), emissive, np.uint8),
            shininess=np.array([shininess], np.float32),
        ),
    )
    with np.errstate(all="ignore"):
        front, back = light_vertices(block, lights)
    return int(front[0, 0] * 255 + 1e-3), int(back[0, 0] * 255 + 1e-3)


def test_default_lights_leave_what_faces_the_camera() -> None:
    assert lit(AMBIENT, AHEAD) == (200, 100)


def test_default_lights_on_a_wall_turned_by_60_degrees() -> None:
    assert lit(AMBIENT, AHEAD, normal=(sin(pi / 3), 0, cos(pi / 3))) == (150, 100)


def test_normals_of_any_length_count_alike() -> None:
    assert lit(AHEAD, normal=(0, 0, 0.01)) == lit(AHEAD, normal=(0, 0, 70))


def test_without_a_light_only_what_glows_is_seen() -> None:
    assert lit(emissive=30) == (30, 30)


def test_without_a_normal_diffuse_light_is_dark() -> None:
    assert lit(AMBIENT, AHEAD, normal=NONE) == (100, 100)


@pytest.mark.parametrize(("shininess", "expected"), [(1, 97), (10, 76)])
def test_highlights(shininess: float, expected: int) -> None:
    tilt = atan(0.5)
    light = Light(
        LightKind.DIRECTIONAL, NONE, (-sin(tilt), 0.0, -cos(tilt)), NONE, NONE, FULL, CONSTANT
    )

    assert lit(light, specular=100, shininess=shininess)[0] == expected


def test_falloff_counts_from_the_light() -> None:
    light = Light(LightKind.POINT, (0.0, 0.0, -90.0), NONE, NONE, FULL, NONE, (1.0, 0.1, 0.01))

    assert lit(light)[0] == pytest.approx(200 / (1 + 1 + 1), abs=1)


@pytest.mark.parametrize(
    ("spot_cosine", "concentration", "expected"),
    [(0.8, 2.0, 160), (0.9, 2.0, 0), (0.9, 0.0, 200)],
    ids=["inside", "outside", "no cone"],
)
def test_spots(spot_cosine: float, concentration: float, expected: int) -> None:
    tilt = atan(0.5)  # cosine 0.8944
    light = Light(
        LightKind.SPOT,
        position=(0.0, 0.0, -50.0),
        direction=(sin(tilt), 0.0, -cos(tilt)),
        ambient=NONE,
        diffuse=FULL,
        specular=NONE,
        falloff=CONSTANT,
        spot_cosine=spot_cosine,
        concentration=concentration,
    )

    assert lit(light)[0] == expected
