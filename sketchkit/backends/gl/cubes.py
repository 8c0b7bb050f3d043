"""Cube maps on the GPU: six pictures, looked up by a direction."""

from __future__ import annotations

import weakref
from collections.abc import Callable

import moderngl
import numpy as np

from sketchkit.draw.resources import CubeMap, Pixels, Target
from sketchkit.draw.vertex import U8

TEXTURE_CUBE_MAP_SEAMLESS = 0x884F  # without it the edges between the faces show
CANVAS = -1  # version of a face that may have changed at any time


class Cubes:
    """The cube maps of one context."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._cubes: weakref.WeakKeyDictionary[
            CubeMap, tuple[moderngl.TextureCube, tuple[int, ...]]
        ] = weakref.WeakKeyDictionary()
        self._sampler: moderngl.Sampler | None = None

    def use(self, cube: CubeMap, picture_of: Callable[[Target], U8], unit: int) -> None:
        """Bind a cube map to a texture unit.

        `picture_of` returns what a canvas shows, (h, w, 4), top row first.
        """
        texture, held = self._cubes.get(cube, (None, (CANVAS,) * len(cube.faces)))
        if texture is None:
            texture = self._context.texture_cube((cube.side, cube.side), 4)
        versions = tuple(
            face.version if isinstance(face, Pixels) else CANVAS for face in cube.faces
        )
        is_changed = False
        for index, face in enumerate(cube.faces):
            if versions[index] == held[index] != CANVAS:
                continue
            rows = face.data if isinstance(face, Pixels) else picture_of(face)
            texture.write(index, np.ascontiguousarray(rows))
            is_changed = True
        if is_changed:
            texture.build_mipmaps()
        self._cubes[cube] = (texture, versions)
        texture.use(location=unit)
        self._smooth_sampler().use(location=unit)

    def _smooth_sampler(self) -> moderngl.Sampler:
        if self._sampler is None:
            self._context.enable_direct(TEXTURE_CUBE_MAP_SEAMLESS)
            filters = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
            self._sampler = self._context.sampler(repeat_x=False, repeat_y=False, filter=filters)
        return self._sampler
