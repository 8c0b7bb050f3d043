"""Targets: framebuffers, and what their samples are averaged into."""

from __future__ import annotations

import weakref

import moderngl
import numpy as np

from sketchkit.draw.commands import Settling
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8


class Surface:
    """The framebuffer of one target, as it was when its size last changed."""

    def __init__(self, context: moderngl.Context, target: Target) -> None:
        size = (target.width, target.height)
        self.version = target.version
        self._target = weakref.ref(target)
        self._copy: moderngl.Framebuffer | None = None
        self._turned: moderngl.Framebuffer | None = None
        self._previous: moderngl.Framebuffer | None = None
        self._is_averaged = self._is_spread = False
        self.image = context.texture(size, 4)
        """One sample a pixel: the average, or what is drawn on when there is only one."""
        self.depth = context.depth_renderbuffer(size, samples=_samples(target))
        self._averaged = context.framebuffer([self.image])
        self._colors: moderngl.Texture | None = None
        if target.samples > 1:
            self._colors = context.texture(size, 4, samples=target.samples)
            self.framebuffer = context.framebuffer([self._colors], self.depth)
        else:
            self.framebuffer = context.framebuffer([self.image], self.depth)
        self.framebuffer.clear(0.0, 0.0, 0.0, 0.0, depth=1.0)

    def begin_drawing(self) -> moderngl.Framebuffer:
        """Return the framebuffer, whose samples will change."""
        self._is_averaged = self._is_spread = False
        return self.framebuffer

    def average(self, context: moderngl.Context) -> moderngl.Texture:
        """Return the picture with one value a pixel."""
        if self._colors is not None and not self._is_averaged:
            context.copy_framebuffer(self._averaged, self.framebuffer)
            self._is_averaged = True
        return self.image

    def _spread(self, context: moderngl.Context) -> None:
        """Give all samples of each pixel the picture's value; within the scissor, if one is set."""
        if self._colors is not None and not self._is_spread:
            context.copy_framebuffer(self.framebuffer, self._averaged)

    def picture(self, context: moderngl.Context, drawn_on: Target) -> moderngl.Texture:
        """Return the picture as a texture for drawing on a target, which may be its own."""
        image = self.average(context)
        if drawn_on is not self._target() or self._colors is not None:
            return image
        if self._copy is None:  # with one sample, it would be read while it is drawn on
            self._copy = context.framebuffer([context.texture(image.size, 4)])
        context.copy_framebuffer(self._copy, self._averaged)
        copy = self._copy.color_attachments[0]
        assert isinstance(copy, moderngl.Texture)
        return copy

    def turned(self, context: moderngl.Context, copy: moderngl.VertexArray) -> moderngl.Texture:
        """Return the picture with its rows the other way round; `copy` draws a texture so."""
        image = self.average(context)
        if self._turned is None:
            self._turned = context.framebuffer([context.texture(image.size, 4)])
        self._turned.use()
        context.disable(moderngl.DEPTH_TEST | moderngl.BLEND | moderngl.CULL_FACE)
        context.clear_samplers()
        image.filter = (moderngl.NEAREST, moderngl.NEAREST)
        image.use(location=0)
        copy.render(moderngl.TRIANGLES, vertices=3)
        turned = self._turned.color_attachments[0]
        assert isinstance(turned, moderngl.Texture)
        return turned

    def note(self, context: moderngl.Context, copy: moderngl.VertexArray) -> None:
        """Keep the picture beside, row 0 at the bottom, for what is drawn from now on."""
        target = self._target()
        if self._previous is None:
            self._previous = context.framebuffer([context.texture(self.image.size, 4)])
        if target is not None and target.top_row_first:
            self.turned(context, copy)
            assert self._turned is not None
            context.copy_framebuffer(self._previous, self._turned)
        else:
            self.average(context)
            context.copy_framebuffer(self._previous, self._averaged)

    @property
    def previous(self) -> moderngl.Texture | None:
        """The picture that was kept; None before there was one."""
        if self._previous is None:
            return None
        previous = self._previous.color_attachments[0]
        assert isinstance(previous, moderngl.Texture)
        return previous

    def upload(
        self, context: moderngl.Context, target: Target, data: U8, left: int, top: int
    ) -> None:
        """Replace pixels, (h, w, 4), whose top left corner is given from the top of the picture."""
        height, width = data.shape[:2]
        if not target.top_row_first:
            data, top = data[::-1], target.height - top - height
        is_whole = self.image.size == (width, height)
        if not is_whole:
            self.average(context)
        box = (left, top, width, height)
        self.image.write(np.ascontiguousarray(data), viewport=box)
        self._is_averaged = True
        if self._colors is None:
            return
        was_spread, self._is_spread = self._is_spread, False
        self.framebuffer.scissor = box  # a copy changes nothing outside of it
        self.framebuffer.use()
        self._spread(context)
        self.framebuffer.scissor = None  # type: ignore[assignment] # the stubs forget None
        self.framebuffer.use()
        self._is_spread = is_whole or was_spread

    def settle(
        self, context: moderngl.Context, how: Settling, first_sample: moderngl.VertexArray
    ) -> None:
        """Begin a frame over the old picture.

        `first_sample` draws the first sample of the multisampled texture that is bound.
        """
        framebuffer = self.framebuffer
        framebuffer.scissor = None  # type: ignore[assignment] # the stubs forget that it may be
        if how is Settling.TURN:
            self._turn_over(context, first_sample)
        if how is Settling.MEAN:
            self.average(context)
            self._spread(context)
            self._is_spread = True
            return
        framebuffer.depth_mask = True
        framebuffer.color_mask = (False,) * 4
        framebuffer.clear(depth=1.0)
        framebuffer.color_mask = (True,) * 4

    def _turn_over(self, context: moderngl.Context, first_sample: moderngl.VertexArray) -> None:
        """Let the rows change places. It happens once in a sketch: by way of the processor."""
        if self._colors is not None:
            self._averaged.use()
            context.disable(moderngl.DEPTH_TEST | moderngl.BLEND)
            self._colors.use(location=0)
            first_sample.render(moderngl.TRIANGLES, vertices=3)
        data = self._averaged.read(components=4, alignment=1)
        rows = np.frombuffer(data, np.uint8).reshape(self.image.height, -1)
        self.image.write(np.ascontiguousarray(rows[::-1]))
        self._is_averaged, self._is_spread = True, False
        self._spread(context)
        self._is_spread = True

    def read(self, context: moderngl.Context) -> U8:
        """Return the picture, (h, w, 4), in the framebuffer's own order of rows."""
        self.average(context)
        data = self._averaged.read(components=4, alignment=1)
        return np.frombuffer(data, np.uint8).reshape(*self.image.size[::-1], 4)

    def read_pixel(self, context: moderngl.Context, column: int, row: int) -> U8:
        """Return one pixel, (4,), whose row is counted in the framebuffer's own order."""
        box = (column, row, 1, 1)
        if not self._is_averaged:
            self.framebuffer.scissor = box  # a copy changes nothing outside of it
            self.framebuffer.use()
            context.copy_framebuffer(self._averaged, self.framebuffer)
            self.framebuffer.scissor = None  # type: ignore[assignment] # the stubs forget None
            self.framebuffer.use()
        return np.frombuffer(self._averaged.read(viewport=box, components=4), np.uint8)

    def release(self) -> None:
        """Let go of everything on the GPU."""
        if self._colors is not None:
            self._colors.release()
            self.framebuffer.release()
        for made in (self._copy, self._turned, self._previous):
            if made is not None:
                made.release()
        self._averaged.release()
        self.image.release()
        self.depth.release()


def _samples(target: Target) -> int:
    """Return the samples as OpenGL counts them: 0 for none but the pixel itself."""
    return target.samples if target.samples > 1 else 0


class Surfaces:
    """The surfaces of all targets, made when first drawn on."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._surfaces: weakref.WeakKeyDictionary[Target, Surface] = weakref.WeakKeyDictionary()

    def get(self, target: Target) -> Surface:
        """Return a target's surface, made anew if its size has changed."""
        surface = self._surfaces.get(target)
        if surface is None or surface.version != target.version:
            if surface is not None:
                surface.release()
            surface = self._surfaces[target] = Surface(self._context, target)
        return surface

    def forget(self, target: Target) -> None:
        """Release a target's surface."""
        if surface := self._surfaces.pop(target, None):
            surface.release()
