"""Textures: images on the GPU, uploaded again when their version has moved on."""

from __future__ import annotations

import weakref

import moderngl
import numpy as np

from sketchkit.draw.resources import Pixels, Wrap


class Textures:
    """The textures of one context."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._textures: weakref.WeakKeyDictionary[Pixels, tuple[moderngl.Texture, int]] = (
            weakref.WeakKeyDictionary()
        )
        self._black: moderngl.Texture | None = None
        self._samplers: dict[tuple[Wrap, bool], moderngl.Sampler] = {}

    def use(self, pixels: Pixels, wrap: Wrap, unit: int = 0) -> None:
        """Bind an image to a texture unit."""
        self._get(pixels).use(location=unit)
        self._sampler(wrap, mipmaps=pixels.mipmaps).use(location=unit)

    def use_nothing(self, unit: int) -> None:
        """Let a texture unit be black."""
        if self._black is None:
            self._black = self._context.texture((1, 1), 4, bytes((0, 0, 0, 255)))
        self._black.use(location=unit)

    def use_picture(self, picture: moderngl.Texture, wrap: Wrap, unit: int = 0) -> None:
        """Bind the picture of a canvas to a texture unit."""
        picture.use(location=unit)
        self._sampler(wrap, mipmaps=False).use(location=unit)

    def _get(self, pixels: Pixels) -> moderngl.Texture:
        texture, version = self._textures.get(pixels, (None, -1))
        size = (pixels.width, pixels.height)
        if texture is not None and texture.size != size:
            texture.release()
            texture = None
        if texture is None:
            texture, version = self._context.texture(size, 4), -1
        if version != pixels.version:
            texture.write(np.ascontiguousarray(pixels.data))
            if pixels.mipmaps:
                texture.build_mipmaps()
            self._textures[pixels] = (texture, pixels.version)
        return texture

    def _sampler(self, wrap: Wrap, *, mipmaps: bool) -> moderngl.Sampler:
        key = (wrap, mipmaps)
        if key not in self._samplers:
            # Three times linear, as Processing: between texels, and between smaller copies.
            smaller = moderngl.LINEAR_MIPMAP_LINEAR if mipmaps else moderngl.LINEAR
            repeats = wrap is Wrap.REPEAT
            self._samplers[key] = self._context.sampler(
                repeat_x=repeats, repeat_y=repeats, filter=(smaller, moderngl.LINEAR)
            )
        return self._samplers[key]

    def forget(self, pixels: Pixels) -> None:
        """Release an image's texture."""
        if entry := self._textures.pop(pixels, None):
            entry[0].release()
