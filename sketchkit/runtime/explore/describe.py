"""What a layer is, as plain values: the call, and everything that it was drawn with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.lights import Light, LightKind
from sketchkit.core.matrix import IDENTITY, Affine, eye_distance, translate
from sketchkit.core.style import NO_COLOR, Material
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.pipeline import Clip
from sketchkit.draw.recorder import ROW, Kind, ShapeRun, origin_of
from sketchkit.draw.resources import Pixels, Target, Texture
from sketchkit.draw.stage import Stage
from sketchkit.runtime.explore.calls import Site, Texts, shape_begin, sites
from sketchkit.runtime.explore.layers import Layer, Part
from sketchkit.runtime.explore.log import FrameLog, Records, as_chain
from sketchkit.runtime.explore.matrices import in_words, number, without_camera
from sketchkit.runtime.explore.noting import Chain
from sketchkit.runtime.loader import Program

DEFAULT_FOV = pi / 3
HAND = {
    *("mouseX", "mouseY", "mousePressed", "mouseDragged", "mouseReleased", "mouseClicked"),
    *("mouseMoved", "mouseWheel", "keyPressed", "keyReleased", "keyTyped", "key", "keyCode"),
}
COVERS = (Kind.IMAGE, Kind.LETTER)  # whose tint is in the place of the stroke

Color = tuple[int, int, int, int]  # red, green, blue, alpha


@dataclass(frozen=True)
class Surroundings:
    """What has to be known of the sketch to describe what it has drawn.

    Attributes
    ----------
    texts : Texts
        Its files.
    canvas : Target
        The main canvas.
    camera : Affine
        The modelview with which the main canvas began.
    images : mapping of Texture to str
        Names of the variables that images are in.
    waits : bool
        Whether it reads mouse or keys: what is empty now may be filled by hand.
    """

    texts: Texts
    canvas: Target
    camera: Affine
    images: Mapping[Texture, str]
    waits: bool = False


def surroundings(program: Program) -> Surroundings:
    """Return what has to be known of a sketch to describe what it has drawn."""
    images: dict[Texture, str] = {}
    for name, value in program.namespace.items():
        texture = getattr(value, "_texture", None)
        if callable(texture) and not isinstance(value, type):
            own = texture()
            if isinstance(own, Pixels | Target):
                images[own] = name
    canvas = program.sketch.canvas
    camera = getattr(canvas, "_camera")  # noqa: B009 # the seam between sketch and canvas has none
    texts = Texts(program.sources, program.former)
    waits = any(source.names & HAND for source in program.sources.values())
    return Surroundings(texts, canvas.target, camera, images, waits)


@dataclass(frozen=True)
class Paint:
    """The colours of a call; None: none (`noFill()`, `noStroke()`), or it has no such thing."""

    fill: Color | None = None
    stroke: Color | None = None
    weight: float | None = None
    tint: Color | None = None
    varies: bool = False


@dataclass(frozen=True)
class Description:
    """A layer.

    Attributes
    ----------
    sites : list of Site
        The call and where its function was called from, innermost first.
    made : list of Site
        Of a retained shape: where it, or the part of it, was made.
    began : int or None
        The line of the `beginShape()`.
    which : (place, count)
        Of how many that this line has drawn in a row of calls it is one, counted from 1.
    kind : str
        What was drawn, in lower case: `rect`, `shape`, `background` ...
    modelview : Affine or None
    doing : str
        What the sketch has done to the matrix, in words.
    nesting : int
        Within how many pushMatrix().
    """

    layer: Layer
    frame: int
    sites: list[Site]
    made: list[Site]
    began: int | None
    which: tuple[int, int]
    kind: str
    paint: Paint
    modelview: Affine | None = None
    doing: str = ""
    nesting: int = 0
    blend: str = ""
    depth: str = ""
    clip: Clip | None = None
    lights: tuple[str, ...] | None = None
    material: str = ""
    texture: str = ""
    shader: str = ""

    @property
    def line(self) -> int:
        """The line of the call; 0 if no line of the sketch has drawn it."""
        return self.sites[0].line if self.sites else 0

    @property
    def title(self) -> str:
        """The call: `line 14: rect(10, 10, 20, 20)`."""
        if not self.sites:
            return "the empty canvas" if self.layer.part is Part.BACKGROUND else "sketchkit itself"
        site = self.sites[0]
        return f"{site.place}: {site.text}"


def chain_of(log: FrameLog, layer: Layer) -> Chain:
    """Return the calls of the sketch that have drawn a layer, innermost first."""
    step = log.steps[layer.moment[0]]
    if step.records is None or layer.row < 0:
        return layer.setter
    return step.records.call(layer.row)


def describe(log: FrameLog, layer: Layer, around: Surroundings) -> Description:
    """Return what a layer is."""
    step = log.steps[layer.moment[0]]
    records = step.records
    if records is None or layer.row < 0:
        found = sites(chain_of(log, layer), around.texts)
        paint = Paint()
        return Description(layer, step.frame, found, [], None, (1, 1), "pixels", paint)
    chain = records.call(layer.row)
    row = records.table[layer.row]
    kind, state = Kind(int(row["kind"])), int(row["state"])
    stage = records.stages[state]
    found, which = sites(chain, around.texts), _which(records, layer.row, chain)
    paint = Paint(fill=unpacked(int(row["fill"])))
    plain = Description(layer, step.frame, found, [], None, which, kind.name.lower(), paint)
    if kind is Kind.CLEAR:
        return replace(plain, kind="background", clip=stage.clip)
    described = replace(_with_stage(plain, stage, around), paint=_paint_of(records, layer.row))
    if kind is Kind.MESH:
        part = records.parts[int(row["link"])]
        made, own = _made(part, layer, around.texts), _inner_paint(part, layer)
        described = replace(described, made=made, paint=own, kind="retained shape")
    elif kind is Kind.SHAPE and chain:
        described = replace(described, began=shape_begin(chain[0], around.texts))
    modelview = tuple(records.matrices[12 * state : 12 * state + 12])
    is_lit = stage.lights is not None and layer.part is Part.FILL
    return replace(
        described,
        modelview=modelview,
        doing=in_words(without_camera(modelview, _camera(stage, around))),
        nesting=records.nestings[state],
        material=_material(records.styles[state].material) if is_lit else "",
    )


def _with_stage(plain: Description, stage: Stage, around: Surroundings) -> Description:
    """Return a description with what a sketch sets for more than one shape."""
    layer = plain.layer
    return replace(
        plain,
        blend=stage.blend.name,
        depth=_depth(stage),
        clip=stage.clip,
        lights=_lights(stage, layer),
        texture=_texture(layer, around),
        shader=_shader(layer),
    )


def _paint_of(records: Records, row: int) -> Paint:
    return _paint(records.table, records.corners, row, records.shapes)


def _which(records: Records, row: int, chain: Chain) -> tuple[int, int]:
    """Return the place of a row among those that the same calls have recorded, and their number.

    What takes several rows for one call, as text does, counts as one.
    """
    kinds = records.table["kind"]
    if kinds[row] in (Kind.LETTER, Kind.MESH):
        return 1, 1
    place = count = first = 0
    for end, own in records.origins:
        last = end // ROW
        if own is chain:
            alike = np.flatnonzero(kinds[first:last] == kinds[row]) + first
            count += len(alike)
            place += int((alike <= row).sum())
        first = last
    return place, count


def unpacked(color: int) -> Color | None:
    """Return a packed colour as red, green, blue and alpha; None if it is none."""
    if color < 0:
        return None
    return color >> 16 & 255, color >> 8 & 255, color & 255, color >> 24 & 255


def _paint(
    table: NDArray[np.void], corners: NDArray[np.void], row: int, shapes: list[ShapeRun]
) -> Paint:
    """Return the colours of a row."""
    own = table[row]
    fill, stroke, weight = int(own["fill"]), int(own["stroke"]), float(own["weight"])
    kind = Kind(int(own["kind"]))
    if kind in COVERS:
        return Paint(tint=unpacked(stroke)) if kind is Kind.IMAGE else Paint(fill=unpacked(stroke))
    varies = False
    if kind is Kind.SHAPE:
        run = shapes[int(own["link"])]
        mine = corners[run.first : run.first + run.count]
        fills, strokes = np.unique(mine["fill"]), np.unique(mine["stroke"])
        varies = len(fills) > 1 or len(strokes) > 1
        fill = int(fills[0]) if fill >= 0 and len(fills) else fill
        stroke = int(strokes[0]) if len(strokes) else stroke
    drawn = unpacked(stroke) if weight > 0 else None
    if kind in (Kind.LINE, Kind.POINT):
        fill = NO_COLOR
    return Paint(unpacked(fill), drawn, weight if drawn else None, varies=varies)


def _inner_paint(part: MeshPart, layer: Layer) -> Paint:
    source = part.mesh.source
    if source is None or layer.inner_row is None:
        return Paint(fill=_rgba(layer))
    return _paint(source.row_array(), source.corner_array(), layer.inner_row, source.shapes)


def _rgba(layer: Layer) -> Color:
    red, green, blue, alpha = layer.color.tolist()
    return red, green, blue, alpha


def _made(part: MeshPart | None, layer: Layer, texts: Texts) -> list[Site]:
    """Return where a retained shape was made."""
    source = None if part is None else part.mesh.source
    if source is None or layer.inner_row is None:
        return []
    return sites(as_chain(origin_of(source.origins, layer.inner_row)), texts)


def _camera(stage: Stage, around: Surroundings) -> Affine:
    """Return the modelview with which drawing on a canvas began."""
    if stage.target is around.canvas:
        return around.camera if stage.is_3d else IDENTITY
    if not stage.is_3d:
        return IDENTITY
    width, height = stage.target.width, stage.target.height
    return translate(IDENTITY, -width / 2, -height / 2, -eye_distance(height, DEFAULT_FOV))


def _depth(stage: Stage) -> str:
    if not stage.is_3d:
        return ""
    if not stage.depth_test:
        return "not compared: hint(DISABLE_DEPTH_TEST)"
    return "compared and kept" if stage.depth_write else "compared, not kept"


def _lights(stage: Stage, layer: Layer) -> tuple[str, ...] | None:
    """Return the lights that fall on a layer, in words; None if it is not lit."""
    if stage.lights is None or layer.part is not Part.FILL:
        return None
    return tuple(light_in_words(light) for light in stage.lights)


def light_in_words(light: Light) -> str:
    """Return a light in the words of the functions that make it, in eye space."""
    color = light.ambient if light.kind is LightKind.AMBIENT else light.diffuse
    shown = ", ".join(number(value * 255) for value in color)
    words = f"{light.kind.name.lower()} {shown}"
    if light.kind in (LightKind.POINT, LightKind.SPOT):
        words += f" at ({', '.join(number(value) for value in light.position)})"
    if light.kind in (LightKind.DIRECTIONAL, LightKind.SPOT):
        words += f" toward ({', '.join(number(value) for value in light.direction)})"
    return words


def _material(material: Material) -> str:
    def shown(packed: int) -> str:
        return ", ".join(map(str, (unpacked(packed) or (0, 0, 0))[:3]))

    ambient = "as the fill" if material.ambient < 0 else shown(material.ambient)
    return (
        f"ambient {ambient}; specular {shown(material.specular)}; "
        f"emissive {shown(material.emissive)}; shininess {number(material.shininess)}"
    )


def _texture(layer: Layer, around: Surroundings) -> str:
    """Return what covers a layer, in words."""
    texture = layer.pipeline.texture if layer.pipeline else None
    if texture is None:
        return ""
    name = around.images.get(texture, "")
    kind = "canvas" if isinstance(texture, Target) else "image"
    about = f"{name}, {kind}" if name else kind
    text = f"{about} of {texture.width} x {texture.height}"
    if layer.uv is not None:
        x, y = layer.uv[0] * texture.width, layer.uv[1] * texture.height
        text += f", at {number(x)}, {number(y)}"
    return text


def _shader(layer: Layer) -> str:
    shading = layer.pipeline.shading if layer.pipeline else None
    return shading.source.name if shading else ""
