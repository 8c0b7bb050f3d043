"""Playing a tape: its resources come into being, and what was recorded is drawn.

A tape may have been written by anybody. What could bring a renderer out of step is checked here;
all else shows as an error or as a picture.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import cast

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.commands import Upload
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import CubeMap, Pixels, Target, Texture
from sketchkit.draw.shading import ShaderFile, ShaderKind, ShaderSource
from sketchkit.draw.vertex import U8, Layer, Materials, VertexBlock
from sketchkit.tape.messages import Message, TapeError
from sketchkit.tape.recorders import decode_recorder
from sketchkit.tape.values import Decoder, Resource
from sketchkit.tape.writing import TARGET_FIELDS

LONGEST_SIDE = 16384  # px; no sketch of a course is larger, and no driver draws more
EDITED = frozenset({"positions", "colors", "normals", "uvs", "ambient"})
DAMAGED = "The recording is damaged."

Change = Callable[[Recorder], None]


class Player:
    """Draws what tapes say.

    Parameters
    ----------
    renderer : Renderer
    change : callable, optional
        Alters what was recorded before it is drawn: to see a sketch without its lights.

    Attributes
    ----------
    resources : dict
        By number.
    mesh_kinds : dict of Mesh to dict
        What retained geometry was made from: how many of each kind.
    """

    def __init__(self, renderer: Renderer, change: Change | None = None) -> None:
        self.renderer = renderer
        self.resources: dict[int, Resource] = {}
        self.mesh_kinds: dict[Mesh, dict[str, int]] = {}
        self._change = change

    def play(self, message: Message) -> None:
        """Take one step; messages of a kind that draws nothing are passed over.

        Raises
        ------
        TapeError
            If no sketch can have recorded it.
        """
        step = STEPS.get(message.kind)
        if step is None:
            return
        try:
            step(self, message)
        except (AttributeError, IndexError, KeyError, TypeError, ValueError) as problem:
            raise TapeError(DAMAGED) from problem

    def read(self, number: int) -> U8:
        """Return what is on a target, (h, w, 4) RGBA, top row first."""
        target = self.resources.get(number)
        if not isinstance(target, Target):
            raise TapeError(DAMAGED)
        return self.renderer.read(target)

    def _rows(self, message: Message) -> None:
        decoder = Decoder(message.body, self.resources)
        recorder = decode_recorder(cast("dict[str, object]", message.value), decoder)
        if self._change is not None:
            self._change(recorder)
        for part in recorder.parts:
            block = part.mesh.blocks[part.layer]
            _check(0 <= part.first <= part.first + part.count <= len(block.indices))
        self.renderer.draw(recorder)

    def _upload(self, message: Message) -> None:
        value = _table(message)
        target = self.resources[cast(int, value["target"])]
        data = _pixels(Decoder(message.body, {}).array(value["data"]))
        left, top = int(cast(int, value["left"])), int(cast(int, value["top"]))
        _check(isinstance(target, Target))
        target = cast(Target, target)
        _check(left >= 0 and left + data.shape[1] <= target.width)
        _check(top >= 0 and top + data.shape[0] <= target.height)
        self.renderer.upload([Upload(target, data, left, top)])

    def _target(self, message: Message) -> None:
        value = _table(message)
        number, state = cast(int, value["number"]), cast("list[int]", value["state"])
        fields = dict(zip(TARGET_FIELDS, state, strict=True))
        width, height = int(fields["width"]), int(fields["height"])
        _check(0 < width <= LONGEST_SIDE and 0 < height <= LONGEST_SIDE)
        _check(fields["samples"] in (1, 4) and fields["density"] in (1, 2))
        target = self.resources.setdefault(number, Target(width, height))
        for name, field in fields.items():
            setattr(target, name, field)

    def _pixels(self, message: Message) -> None:
        value = _table(message)
        data = _pixels(Decoder(message.body, {}).array(value["data"]))
        number = cast(int, value["number"])
        pixels = self.resources.setdefault(number, Pixels(data, version=-1))
        _check(isinstance(pixels, Pixels))
        pixels = cast(Pixels, pixels)
        pixels.data, pixels.mipmaps = data, bool(value["mipmaps"])
        pixels.version += 1

    def _shader(self, message: Message) -> None:
        value = _table(message)
        decoder = Decoder(message.body, {})
        vertex, fragment = (decoder.decode(value[name]) for name in ("vertex", "fragment"))
        kind = decoder.decode(value["kind"])
        attributes = frozenset(str(name) for name in cast("list[str]", value["attributes"]))
        _check(all(file is None or isinstance(file, ShaderFile) for file in (vertex, fragment)))
        _check(isinstance(kind, ShaderKind) and (vertex is not None or fragment is not None))
        self.resources[cast(int, value["number"])] = ShaderSource(
            cast("ShaderFile | None", vertex),
            cast("ShaderFile | None", fragment),
            cast(ShaderKind, kind),
            attributes,
        )

    def _cube(self, message: Message) -> None:
        value = _table(message)
        faces = tuple(self.resources[number] for number in cast("list[int]", value["faces"]))
        _check(len(faces) == 6 and all(isinstance(face, Pixels | Target) for face in faces))
        cube = CubeMap(cast("tuple[Texture, ...]", faces))
        self.resources[cast(int, value["number"])] = cube

    def _mesh(self, message: Message) -> None:
        value = _table(message)
        decoder = Decoder(message.body, {})
        blocks = {
            Layer(layer): cast(VertexBlock, decoder.decode(block))
            for layer, block in cast("list[tuple[str, object]]", value["blocks"])
        }
        for block in blocks.values():
            _check_block(block)
        mesh = Mesh(blocks, weight_scale=float(cast(float, value["weight_scale"])))
        self.resources[cast(int, value["number"])] = mesh
        kinds = cast("dict[str, int]", value["kinds"])
        self.mesh_kinds[mesh] = {str(kind): int(count) for kind, count in kinds.items()}

    def _edit(self, message: Message) -> None:
        value = _table(message)
        mesh = cast(Mesh, self.resources[cast(int, value["number"])])
        layer, name = Layer(value["layer"]), cast(str, value["column"])
        _check(name in EDITED)
        block = mesh.blocks[layer]
        column = getattr(block.materials if name == "ambient" else block, name)
        part = Decoder(message.body, {}).array(value["data"])
        first = cast(int, value["first"])
        last = first + len(part)
        _check(first >= 0 and last <= len(column) and part.dtype == column.dtype)
        column[first:last] = part
        mesh.note_change(layer, name, np.arange(first, last))

    def _forget(self, message: Message) -> None:
        for number in cast("list[int]", message.value):
            resource = self.resources.pop(number, None)
            if isinstance(resource, Mesh):
                self.mesh_kinds.pop(resource, None)
            if isinstance(resource, Pixels | Target | Mesh):
                self.renderer.backend.forget(resource)


STEPS: Mapping[str, Callable[[Player, Message], None]] = {
    "rows": Player._rows,
    "upload": Player._upload,
    "target": Player._target,
    "pixels": Player._pixels,
    "shader": Player._shader,
    "cube": Player._cube,
    "mesh": Player._mesh,
    "edit": Player._edit,
    "forget": Player._forget,
}

# Columns of a block: how many numbers each vertex has, and of which kind.
COLUMNS: dict[str, tuple[int, type]] = {
    "positions": (3, np.float32),
    "colors": (4, np.uint8),
    "uvs": (2, np.float32),
    "normals": (3, np.float32),
    "directions": (4, np.float32),
    "offsets": (2, np.float32),
}


def _check_block(block: VertexBlock) -> None:
    """See to it that a block's columns are of one length, and its triangles within them."""
    _check(isinstance(block, VertexBlock))
    count = len(block.positions)
    for name, (width, kind) in COLUMNS.items():
        column = getattr(block, name)
        if column is not None or name in ("positions", "colors"):
            _check(column.shape == (count, width) and column.dtype == kind)
    if block.materials is not None:
        _check(isinstance(block.materials, Materials))
        for name in ("ambient", "specular", "emissive"):
            column = getattr(block.materials, name)
            _check(column.shape == (count, 4) and column.dtype == np.uint8)
        shininess = block.materials.shininess
        _check(shininess.shape == (count,) and shininess.dtype == np.float32)
    for column in block.custom.values():
        _check(column.ndim == 2 and len(column) == count and column.dtype == np.float32)
    indices = block.indices
    _check(indices.ndim == 1 and len(indices) % 3 == 0 and indices.dtype == np.uint32)
    _check(not len(indices) or int(indices.max()) < count)


def _pixels(data: NDArray[np.generic]) -> U8:
    _check(data.ndim == 3 and data.shape[2] == 4 and data.dtype == np.uint8)
    _check(0 < data.shape[0] <= LONGEST_SIDE and 0 < data.shape[1] <= LONGEST_SIDE)
    return cast(U8, data)


def _table(message: Message) -> Mapping[str, object]:
    _check(isinstance(message.value, dict))
    return cast("dict[str, object]", message.value)


def _check(is_right: bool) -> None:
    if not is_right:
        raise TapeError(DAMAGED)
