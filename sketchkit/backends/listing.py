"""The draw list as text: what `sketchkit trace` prints, and what tests compare.

One line for each command, then the vertices it reads. Numbers are rounded to three decimals.
"""

from __future__ import annotations

import math
import weakref
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.lights import Light, LightKind
from sketchkit.core.matrix import Affine, Mat4
from sketchkit.draw.commands import (
    Clear,
    Command,
    Draw,
    DrawList,
    DrawMesh,
    Settle,
    Upload,
)
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.pipeline import Clip, Pipeline
from sketchkit.draw.resources import Target, Texture, Wrap
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import U8, U32, Layer, Materials, VertexBlock

Numbers = Iterable[float] | NDArray[np.floating]

Resource = Texture | Mesh
SHORTENED = 12  # vertices, and triangles, of a draw that are written out


class ListingBackend:
    """Draws nothing: keeps the text of each list.

    Attributes
    ----------
    texts : list of str
        One for each list that was executed.
    is_full : bool
        Whether long draws are written out to their end.
    """

    name = "listing"

    def __init__(self, *, is_full: bool = False) -> None:
        self.texts: list[str] = []
        self.is_full = is_full
        self._names = _Names()

    def describe(self) -> dict[str, str]:
        """Return what draws: nothing."""
        return {"renderer": "none: the draw list as text"}

    def execute(self, commands: DrawList) -> None:
        """Keep the text of a list."""
        self.texts.append(_text(commands, self._names, is_full=self.is_full))

    def prepare(self, source: ShaderSource) -> None:
        """Do nothing: a shader is named, not run."""

    def read(self, target: Target) -> U8:
        """Return a transparent picture."""
        return np.zeros((target.height, target.width, 4), np.uint8)

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return a transparent pixel."""
        return np.zeros(4, np.uint8)

    def forget(self, resource: Resource) -> None:
        """Do nothing: no copy is kept."""

    def close(self) -> None:
        """Let go of the texts."""
        self.texts.clear()


def listing(commands: DrawList, *, is_full: bool = False) -> str:
    """Return a draw list as text, the same for equal lists.

    Parameters
    ----------
    commands : DrawList
    is_full : bool
        Whether long draws are written out to their end. Else the first vertices are, and what
        the others lie within.

    Notes
    -----
    A target, and a texture, is called by the place of its first use: `canvas 1`, `texture 1`. The
    number before a vertex is its place among all vertices of its layer. Normals are written as
    they are kept: not of unit length. What a line leaves out of a material is as in the line
    before.
    """
    return _text(commands, _Names(), is_full=is_full)


class _Names:
    """Numbers targets, and textures, in the order of their first use."""

    def __init__(self) -> None:
        self._numbers: weakref.WeakKeyDictionary[Resource, int] = weakref.WeakKeyDictionary()
        self._counts: Counter[type] = Counter()

    def number(self, resource: Resource) -> int:
        """Return the number of a resource, counted from 1."""
        if resource not in self._numbers:
            self._counts[type(resource)] += 1
            self._numbers[resource] = self._counts[type(resource)]
        return self._numbers[resource]


def _text(commands: DrawList, names: _Names, *, is_full: bool) -> str:
    writer = _Writer(commands, names, math.inf if is_full else SHORTENED)
    lines = [line for command in commands.commands for line in writer.lines(command)]
    return "\n".join([*lines, ""])


class _Writer:
    """Writes the commands of one list, and remembers what it has described."""

    def __init__(self, commands: DrawList, names: _Names, most: float) -> None:
        self._blocks = commands.blocks
        self._names = names
        self._most = most
        self._described: set[Texture] = set()

    def lines(self, command: Command) -> Iterator[str]:
        """Yield the lines of one command."""
        match command:
            case Clear(target, color, depth, clip):
                parts = [_color(color), *["depth"] * depth, *([_clip(clip)] if clip else [])]
                yield f"Clear {self._target(target)}: {', '.join(parts)}"
            case Settle(target, how):
                yield f"Settle {self._target(target)}: {how.value}"
            case Upload(target, data, left, top):
                height, width = data.shape[:2]
                yield f"Upload {self._target(target)}: {width} x {height} pixels at {left} {top}"
            case Draw(pipeline, layer, first, count):
                about = self._draw(pipeline, layer, count)
                yield f"Draw {self._target(pipeline.target)}: {about}"
                yield from _lights(pipeline)
                yield from self._vertices(self._blocks[layer], first, count)
            case DrawMesh(pipeline, part, modelview):
                about = self._draw(pipeline, part.layer, part.count)
                yield f"DrawMesh {self._target(pipeline.target)}: {self._mesh(part)}, {about}"
                yield f"    modelview {_affine(modelview)}"
                yield from _lights(pipeline)
                block = part.mesh.blocks[part.layer]
                yield from self._vertices(block, part.first, part.count)

    def _target(self, target: Target) -> str:
        samples = "1 sample" if target.samples == 1 else f"{target.samples} samples"
        top = "top" if target.top_row_first else "bottom"
        about = f" ({target.width} x {target.height}, {samples}, {top} row first)"
        return f"canvas {self._names.number(target)}{about if self._is_new(target) else ''}"

    def _mesh(self, part: MeshPart) -> str:
        weight = part.weight_scale
        scaled = "" if weight == 1 else f" weights x {_number(weight)}"
        return f"mesh {self._names.number(part.mesh)}{scaled}"

    def _texture(self, pixels: Texture, wrap: Wrap) -> str:
        if isinstance(pixels, Target):
            return f"picture of {self._target(pixels)} {wrap.name}"
        size = f" ({pixels.width} x {pixels.height})" if self._is_new(pixels) else ""
        return f"texture {self._names.number(pixels)}{size} {wrap.name}"

    def _is_new(self, resource: Texture) -> bool:
        """Return whether a resource is mentioned for the first time in this list."""
        is_new = resource not in self._described
        self._described.add(resource)
        return is_new

    def _draw(self, pipeline: Pipeline, layer: Layer, count: int) -> str:
        """Return how something is drawn; what is so by default is left out."""
        what = f"{count // 3} triangles of {layer.value}"
        shading = pipeline.shading
        program = f"shader {shading.source.name}" if shading else pipeline.program.name
        parts = [what, program, pipeline.blend.name, _depth(pipeline)]
        if clip := pipeline.clip:
            parts.append(_clip(clip))
        if pipeline.lights:
            parts.append(f"lights {len(pipeline.lights)}")
        if pipeline.texture is not None:
            parts.append(self._texture(pipeline.texture, pipeline.wrap))
        parts.append(_projection(pipeline.projection))
        if layer is Layer.LINES:
            parts.append(f"pulled {_numbers(pipeline.line_scale)}")
        if pipeline.stroke_perspective:
            parts.append("weights in eye space")
        return ", ".join(parts)

    def _vertices(self, block: VertexBlock, first: int, count: int) -> Iterator[str]:
        """Yield the vertices that a draw reads, and its triangles."""
        corners = block.indices[first : first + count]
        used = np.unique(corners)
        shown = used[: self._count(len(used))]
        material = ""
        for vertex in shown.tolist():
            line = f"    {vertex}: {_vertex(block, vertex)}"
            if block.materials is not None:
                previous, material = material, _material(block.materials, vertex)
                line += f"  {material}" if material != previous else ""
            yield line
        if len(shown) < len(used):
            yield f"    and {len(used) - len(shown)} more; all {_bounds(block, used)}"
        yield f"    triangles {self._triangles(corners)}"

    def _triangles(self, corners: U32) -> str:
        triangles = corners.reshape(-1, 3).tolist()
        shown = triangles[: self._count(len(triangles))]
        text = ", ".join(" ".join(map(str, triangle)) for triangle in shown)
        left = len(triangles) - len(shown)
        return f"{text} and {left} more" if left else text

    def _count(self, count: int) -> int:
        """Return how many of so many things are written out."""
        return count if count <= self._most else SHORTENED


def _number(value: float) -> str:
    """Return a number with at most three decimals, and no minus before a zero."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _numbers(values: Numbers) -> str:
    return " ".join(_number(float(value)) for value in values)


def _color(rgba: Sequence[int] | U8) -> str:
    return "#" + "".join(f"{int(channel):02X}" for channel in rgba)


def _depth(pipeline: Pipeline) -> str:
    """Return what a draw does with the depth: its own is compared, and kept."""
    if not pipeline.depth_test:
        return "no depth test" if pipeline.depth_write else "no depth"
    return "depth" if pipeline.depth_write else "depth test alone"


def _projection(p: Mat4) -> str:
    """Return a projection in the numbers that it was made of."""
    if p[12:] == (0.0, 0.0, 0.0, 1.0):
        # Where clip space ends, at -1 and 1: left and right, top and bottom of the picture.
        x = sorted((side - p[3]) / p[0] for side in (-1, 1))
        y = sorted((side - p[7]) / p[5] for side in (-1, 1))
        return f"ortho x {_number(x[0])}..{_number(x[1])} y {_number(y[0])}..{_number(y[1])}"
    opening = math.degrees(2 * math.atan(1 / abs(p[5])))
    near, far = p[11] / (p[10] - 1), p[11] / (p[10] + 1)
    aside = f" aside {_numbers((p[2], p[6]))}" if p[2] or p[6] else ""
    width = _number(abs(p[5] / p[0]))
    return f"perspective {_number(opening)} deg {width}:1 z {_number(near)}..{_number(far)}{aside}"


def _affine(m: Affine) -> str:
    return " | ".join(_numbers(m[row : row + 4]) for row in (0, 4, 8))


def _lights(pipeline: Pipeline) -> Iterator[str]:
    for light in pipeline.lights:
        yield f"    light {_light(light)}"


def _light(light: Light) -> str:
    """Return a light: where it is or goes, and what it adds."""
    parts = [light.kind.name.lower()]
    if light.kind is not LightKind.DIRECTIONAL:
        parts.append(f"at {_numbers(light.position)}")
    if light.kind in (LightKind.DIRECTIONAL, LightKind.SPOT):
        parts.append(f"toward {_numbers(light.direction)}")
    for name in ("ambient", "diffuse", "specular"):
        if any(color := getattr(light, name)):
            parts.append(f"{name} {_numbers(color)}")
    if light.kind is not LightKind.DIRECTIONAL:
        parts.append(f"falloff {_numbers(light.falloff)}")
    if light.kind is LightKind.SPOT:
        parts.append(f"cosine {_number(light.spot_cosine)} power {_number(light.concentration)}")
    return ", ".join(parts)


def _vertex(block: VertexBlock, vertex: int) -> str:
    """Return one vertex: its place, its colour, and the other columns of its layer."""
    parts = [_numbers(block.positions[vertex]), _color(block.colors[vertex])]
    for name, column in (
        ("uv", block.uvs),
        ("normal", block.normals),
        ("direction", block.directions),
        ("offset", block.offsets),
    ):
        if column is not None:
            parts.append(f"{name} {_numbers(column[vertex])}")
    return "  ".join(parts)


def _material(materials: Materials, vertex: int) -> str:
    colors = (
        f"{name} {_color(getattr(materials, name)[vertex][:3])}"
        for name in ("ambient", "specular", "emissive")
    )
    return "  ".join([*colors, f"shininess {_number(float(materials.shininess[vertex]))}"])


def _bounds(block: VertexBlock, used: U32) -> str:
    """Return what the vertices lie within."""
    low, high = block.positions[used].min(axis=0), block.positions[used].max(axis=0)
    return ", ".join(
        f"{axis} {_number(float(a))}..{_number(float(b))}"
        for axis, a, b in zip("xyz", low, high, strict=True)
    )


def _clip(clip: Clip) -> str:
    return f"clip {clip.width} x {clip.height} at {clip.left} {clip.top}"
