"""Lights as the shading reads them: plain numbers in eye space."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

Vector3 = tuple[float, float, float]

MOST_LIGHTS = 8  # Processing's own limit, and the size of the arrays that its shaders declare


class LightKind(IntEnum):
    """Processing's four kinds of light."""

    AMBIENT = 0
    DIRECTIONAL = 1
    POINT = 2
    SPOT = 3


@dataclass(frozen=True, slots=True)
class Light:
    """One light, in eye space; colours are 0..1.

    Attributes
    ----------
    kind : LightKind
    position : (x, y, z), eye space
        Of ambient lights too: their falloff counts from it. Meaningless for a directional one.
    direction : (x, y, z), eye space, unit
        Where the light of a directional or spot light goes.
    ambient, diffuse, specular : (r, g, b)
        What it adds to each of the three terms.
    falloff : (constant, linear, quadratic)
    spot_cosine : float
        Cosine of the cone's half angle.
    concentration : float
        Exponent inside the cone; 0 means that there is no cone.
    """

    kind: LightKind
    position: Vector3
    direction: Vector3
    ambient: Vector3
    diffuse: Vector3
    specular: Vector3
    falloff: Vector3
    spot_cosine: float = -1.0
    concentration: float = 0.0


LightRig = tuple[Light, ...]
