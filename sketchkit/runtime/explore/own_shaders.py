"""Shaders of the sketch's own, asked what they give a pixel.

Only the sketch's own backend can run them. So a part of a draw is drawn again, alone, onto an
empty surface: once over black and once over white. What differs was not drawn, by `discard` or
because it lies elsewhere; the rest is the shader's colour.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from sketchkit.backends.cpu.frames import packed_depths
from sketchkit.backends.cpu.probe import Fragment
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import Clear, Command, Draw, DrawList, DrawMesh
from sketchkit.draw.layers import PieceOrder
from sketchkit.draw.pipeline import Blend, Clip, Pipeline
from sketchkit.draw.resources import CubeMap, Target, Texture
from sketchkit.draw.shading import ShaderFile, Shading, Uniforms, UniformValue
from sketchkit.draw.vertex import U8
from sketchkit.runtime.explore.log import FrameLog, Moment
from sketchkit.runtime.explore.stand_ins import StandIns

BLACK, WHITE = (0, 0, 0, 0), (255, 255, 255, 255)
MOST_PIECES = 64  # of a draw that its shader moves to the pixel: the last ones
DEPTH = ShaderFile(
    """
    void main() {
        float high = floor(gl_FragCoord.z * 255.0);
        float middle = floor(fract(gl_FragCoord.z * 255.0) * 255.0);
        float low = floor(fract(gl_FragCoord.z * 65025.0) * 255.0);
        gl_FragColor = vec4(vec3(high, middle, low) / 255.0, 1.0);
    }
    """,
    "depth.frag",
)
DIGITS = 255.0, 65025.0, 16581375.0  # what the three of a depth count

Place = tuple[int, int]
Span = tuple[int, int]  # first index, and the one after the last


class OwnShaders:
    """Asks a backend for the colours that shaders give.

    Parameters
    ----------
    log : FrameLog
        What was drawn.
    backend : Backend
        What drew it.
    """

    def __init__(self, log: FrameLog, backend: Backend) -> None:
        self._log = log
        self._backend = backend
        self._stand_ins = StandIns(log, backend)

    def fragments(
        self, moment: Moment, place: Place, known: list[Fragment]
    ) -> list[Fragment] | None:
        """Return what a draw has in a pixel; None if the backend runs no shaders.

        Parameters
        ----------
        known : list of Fragment
            Where its triangles lie, if the shader does not move them.
        """
        command = self._log.command(moment)
        assert isinstance(command, Draw | DrawMesh)
        shading = command.pipeline.shading
        assert shading is not None
        try:
            self._backend.prepare(shading.source)
        except SketchError:
            return None
        own = self._isolated(moment, command)
        if shading.source.vertex is not None:
            return list(self._moved(moment, own, place))
        return [self._colored(moment, own, place, fragment) for fragment in known]

    def _isolated(self, moment: Moment, command: Draw | DrawMesh) -> Draw | DrawMesh:
        """Return a draw onto a surface of its own, with all pictures as they were then."""
        pipeline, step = command.pipeline, self._log.steps[moment[0]]
        surface = step.surfaces[pipeline.target]
        scratch = Target(surface.width, surface.height, surface.samples, surface.top_row_first)
        assert pipeline.shading is not None
        source, uniforms = pipeline.shading
        values = {
            name: self._value(moment, pipeline.target, value)
            for name, value in uniforms.values.items()
        }
        own = pipeline._replace(
            target=scratch,
            blend=Blend.REPLACE,
            clip=None,
            culls_backs=False,
            depth_write=pipeline.depth_test,
            texture=self._stand_ins.texture(pipeline.texture, moment),
            shading=Shading(source, Uniforms(values, uniforms.place)),
        )
        return replace(command, pipeline=own)

    def _value(self, moment: Moment, target: Target, value: UniformValue) -> UniformValue:
        """Return the value of a uniform, with canvases as they were then."""
        stand_ins = self._stand_ins
        if value is target:
            return stand_ins.noted(target, moment)
        if isinstance(value, CubeMap):
            faces: tuple[Texture, ...] = tuple(
                stand_ins.texture(face, moment) or face for face in value.faces
            )
            return CubeMap(faces)
        if isinstance(value, tuple):
            return tuple(  # type: ignore[return-value] # numbers stay numbers
                own if isinstance(own, int | float) else stand_ins.texture(own, moment)
                for own in value
            )
        return stand_ins.texture(value, moment) or value

    def _colored(
        self, moment: Moment, command: Draw | DrawMesh, place: Place, fragment: Fragment
    ) -> Fragment:
        """Return a fragment with the colour that the shader gives it."""
        first = 3 * fragment.triangle
        color, share = self._drawn(moment, _part(command, (first, first + 3)), place)
        if not share:
            return fragment._replace(is_discarded=True)
        return fragment._replace(color=color)

    def _moved(self, moment: Moment, command: Draw | DrawMesh, place: Place) -> Iterator[Fragment]:
        """Yield what its pieces have in the pixel, wherever the shader has moved them."""
        clip = self._log.command(moment).pipeline.clip  # type: ignore[union-attr] # it is a draw
        for span in list(self._covering(moment, command, place))[-MOST_PIECES:]:
            part = _part(command, span)
            color, share = self._drawn(moment, part, place)
            samples = command.pipeline.target.samples
            is_covered = np.arange(samples) < max(round(share * samples), 1)
            depth = self._depth(moment, part, place)
            depths = packed_depths(np.full(samples, depth, np.float32))
            is_clipped = clip is not None and not _lies_in(clip, place)
            yield Fragment(span[0] // 3, is_covered, is_clipped, color, depths, None)

    def _covering(self, moment: Moment, command: Draw | DrawMesh, place: Place) -> Iterator[Span]:
        """Yield the pieces that lie on the pixel: halves of which none does are left out."""
        left = [_pieces(self._log, moment, command)]
        while left:
            pieces = left.pop()
            whole = pieces[0][0], pieces[-1][1]
            if not self._drawn(moment, _part(command, whole), place)[1]:
                continue
            if len(pieces) == 1:
                yield pieces[0]
                continue
            middle = len(pieces) // 2
            left += [pieces[middle:], pieces[:middle]]

    def _drawn(self, moment: Moment, command: Draw | DrawMesh, place: Place) -> tuple[U8, float]:
        """Return the colour that a draw gives a pixel, and how much of it it covers, 0..1."""
        black, white = (self._over(moment, command, place, ground) for ground in (BLACK, WHITE))
        share = 1 - float(np.mean(white - black)) / 255
        if share < 1 / 16:
            return np.zeros(4, np.uint8), 0.0
        return np.rint(np.clip(black / share, 0, 255)).astype(np.uint8), share

    def _over(
        self,
        moment: Moment,
        command: Draw | DrawMesh,
        place: Place,
        ground: tuple[int, int, int, int],
    ) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
        """Return the pixel after a draw over a ground of one colour."""
        target = command.pipeline.target
        only = command.pipeline._replace(clip=Clip(*place, 1, 1))
        blocks = self._log.steps[moment[0]].commands.blocks
        commands: list[Command] = [Clear(target, ground), replace(command, pipeline=only)]
        self._backend.execute(DrawList(commands, blocks))
        x, y = place
        pixel: np.ndarray[tuple[int], np.dtype[np.float64]]
        pixel = self._backend.read(target)[y, x].astype(np.float64)
        return pixel

    def _depth(self, moment: Moment, command: Draw | DrawMesh, place: Place) -> float:
        """Return how far away a draw lies in the middle of a pixel, 0 (near) to 1."""
        pipeline = command.pipeline
        if not pipeline.depth_test or pipeline.shading is None:
            return 0.0
        source, uniforms = pipeline.shading
        surface = pipeline.target
        told = pipeline._replace(
            target=Target(surface.width, surface.height, 1, surface.top_row_first),
            shading=Shading(replace(source, fragment=DEPTH), uniforms),
        )
        try:
            digits = self._over(moment, replace(command, pipeline=told), place, WHITE)
        except SketchError:  # its vertex shader goes with no other one
            return 0.0
        return float(sum(digit / unit for digit, unit in zip(digits, DIGITS, strict=False)))


def own_fragments(
    log: FrameLog, moment: Moment, pipeline: Pipeline, place: Place, known: list[Fragment]
) -> list[Fragment]:
    """Return what a draw with a shader of the sketch's own has in a pixel.

    Without a backend that runs shaders, it is what the built-in one would have there.
    """
    if pipeline.shading is None or log.backend is None:
        return known
    found = OwnShaders(log, log.backend).fragments(moment, place, known)
    return known if found is None else found


def _part(command: Draw | DrawMesh, span: Span) -> Draw | DrawMesh:
    """Return a draw of some of its indices alone."""
    first, end = span
    if isinstance(command, Draw):
        return replace(command, first=first, count=end - first)
    return replace(command, part=command.part._replace(first=first, count=end - first))


def _pieces(log: FrameLog, moment: Moment, command: Draw | DrawMesh) -> list[Span]:
    """Return the indices of each row that a draw was made from."""
    drawn = command if isinstance(command, Draw) else command.part
    whole = drawn.first, drawn.first + drawn.count
    order: PieceOrder | None
    if isinstance(command, Draw):
        order = log.steps[moment[0]].commands.orders[command.layer]
    else:
        order = command.part.mesh.orders.get(command.part.layer)
    if order is None:
        return [whole]
    ends = order.ends[(order.ends > whole[0]) & (order.ends < whole[1])].tolist()
    cuts = [whole[0], *dict.fromkeys(ends), whole[1]]
    return list(pairwise(cuts))


def _lies_in(clip: Clip, place: Place) -> bool:
    x, y = place
    return clip.left <= x < clip.left + clip.width and clip.top <= y < clip.top + clip.height
