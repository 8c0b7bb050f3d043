"""Scenes by topic; `SCENES` has them all."""

from tests.scenes import (
    blending,
    cameras,
    colors,
    curves,
    files,
    hints,
    image_operations,
    images,
    lights,
    offscreen,
    retained,
    shaders,
    shapes2d,
    solids,
    strokes,
    text,
    textures,
    transforms,
    vertices,
)
from tests.scenes.registry import SCENES, Scene

TOPICS = (
    blending,
    cameras,
    colors,
    curves,
    files,
    hints,
    image_operations,
    images,
    lights,
    offscreen,
    retained,
    shaders,
    shapes2d,
    solids,
    strokes,
    text,
    textures,
    transforms,
    vertices,
)

__all__ = ["SCENES", "TOPICS", "Scene"]
