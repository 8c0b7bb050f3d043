"""Light at every vertex: Lambert's diffuse term and Blinn's highlight, in eye space.

The same formulas as shaders/include/lighting.glsl, for all vertices at once. A face can show its
front or its back, so each vertex gets two colours; for the back its normal is reversed.
"""

from __future__ import annotations

import numpy as np

from sketchkit.backends.cpu.columns import given
from sketchkit.core.lights import Light, LightKind, LightRig
from sketchkit.draw.vertex import F32, U8, VertexBlock


def unit_colors(colors: U8) -> F32:
    """Return colours, 0..255, as 0..1."""
    return colors * np.float32(1 / 255)


def light_vertices(block: VertexBlock, lights: LightRig) -> tuple[F32, F32]:
    """Return the colours of front and back, each (n, 4), not clamped.

    Alpha is the fill's. With no light nothing but the emissive colour is left.
    """
    material = given(block.materials)
    surface = _Surface(block.positions, given(block.normals), material.shininess)
    ambient, sides = surface.gather(lights)
    base = ambient * unit_colors(material.ambient[:, :3])
    base += unit_colors(material.emissive[:, :3])
    fill, specular = unit_colors(block.colors), unit_colors(material.specular[:, :3])
    front, back = (
        np.concatenate([base + diffuse * fill[:, :3] + gloss * specular, fill[:, 3:]], axis=1)
        for diffuse, gloss in sides
    )
    return front, back


class _Surface:
    """Vertices that light falls on; arrays are (n, 3) or (n, 1) float32, eye space."""

    def __init__(self, places: F32, normals: F32, shininess: F32) -> None:
        self.places = places
        self.normals = _unit(normals)
        self.from_eye = _unit(places)
        self.shininess = shininess[:, None]

    def gather(self, lights: LightRig) -> tuple[F32, list[tuple[F32, F32]]]:
        """Return the ambient light, and for front and back the diffuse light and the highlight."""
        ambient = np.zeros_like(self.places)
        sides = [(np.zeros_like(self.places), np.zeros_like(self.places)) for _ in range(2)]
        for light in lights:
            to_light, reach = self._reached_by(light)
            ambient += _rgb(light.ambient) * reach
            if light.concentration > 0:
                reach = reach * self._cone(light)
            for normals, (diffuse, gloss) in zip((self.normals, -self.normals), sides, strict=True):
                diffuse += _rgb(light.diffuse) * (reach * _facing(to_light, normals))
                if any(light.specular):
                    halfway = _unit(to_light - self.from_eye)
                    highlight = _facing(halfway, normals) ** self.shininess
                    gloss += _rgb(light.specular) * (reach * highlight)
        return ambient, sides

    def _reached_by(self, light: Light) -> tuple[F32, F32]:
        """Return the directions to a light, and what the distance leaves of it, (n, 1)."""
        if light.kind is LightKind.DIRECTIONAL:
            return -_rgb(light.direction), np.ones((len(self.places), 1), np.float32)
        way = _rgb(light.position) - self.places
        distance = np.sqrt(_dot(way, way))
        constant, linear, quadratic = (np.float32(factor) for factor in light.falloff)
        reach = np.float32(1) / (constant + linear * distance + quadratic * distance * distance)
        return _unit(way), reach

    def _cone(self, light: Light) -> F32:
        """Return what a spot light's cone lets through, (n, 1)."""
        to_light = _unit(_rgb(light.position) - self.places)
        cosine = _dot(-_rgb(light.direction), to_light)
        inside = cosine > np.float32(light.spot_cosine)
        cone: F32 = np.where(inside, np.maximum(cosine, 0) ** np.float32(light.concentration), 0)
        return cone


def _facing(directions: F32, normals: F32) -> F32:
    """Return the cosines of the angles between, (n, 1); 0 where turned away, or undefined."""
    facing: F32 = np.fmax(_dot(directions, normals), np.float32(0))
    return facing


def _dot(a: F32, b: F32) -> F32:
    products = a * b
    total: F32 = products[..., 0:1] + products[..., 1:2] + products[..., 2:3]
    return total


def _unit(vectors: F32) -> F32:
    """Return vectors of length 1; of the zero vector NaN, which `_facing` takes for dark."""
    lengths: F32 = np.sqrt(_dot(vectors, vectors))
    return vectors * (np.float32(1) / lengths)


def _rgb(three: tuple[float, float, float]) -> F32:
    return np.array(three, np.float32)
