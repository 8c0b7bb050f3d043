"""Writing a tape: what a renderer would draw is noted down instead."""

from __future__ import annotations

import weakref
from collections import Counter
from collections.abc import Callable, Sequence

from sketchkit.draw.commands import Upload
from sketchkit.draw.meshes import Edit, Mesh
from sketchkit.draw.recorder import Kind, Recorder
from sketchkit.draw.resources import CubeMap, Pixels, Target
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import VertexBlock
from sketchkit.tape.messages import Message
from sketchkit.tape.recorders import encode_recorder
from sketchkit.tape.values import Encoder, Resource

TARGET_FIELDS = ("width", "height", "samples", "top_row_first", "version", "is_noted", "density")
SOURCE_FIELDS = ("vertex", "fragment", "kind")

Send = Callable[[Message], None]


class TapeWriter:
    """Writes what is drawn, and each resource before it is drawn with, as it is then.

    Parameters
    ----------
    send : callable
        Takes each message.
    """

    def __init__(self, send: Send) -> None:
        self._send = send
        self._numbers: weakref.WeakKeyDictionary[Resource, int] = weakref.WeakKeyDictionary()
        self._states: dict[int, object] = {}  # by number: what was last written of a resource
        self._gone: list[int] = []
        self._next = 0

    def write_recorder(self, recorder: Recorder) -> None:
        """Write what a recorder holds."""
        encoder = Encoder(self.number_of)
        value = encode_recorder(recorder, encoder)
        self._write(Message("rows", value, bytes(encoder.body)))

    def write_uploads(self, uploads: Sequence[Upload]) -> None:
        """Write pixels that the sketch has set."""
        for upload in uploads:
            encoder = Encoder(self.number_of)
            number = self.number_of(upload.target)
            data = encoder.array(upload.data)
            place = {"target": number, "data": data, "left": upload.left, "top": upload.top}
            self._write(Message("upload", place, bytes(encoder.body)))

    def number_of(self, resource: Resource) -> int:
        """Return a resource's number; what is new about it is written first."""
        number = self._numbers.get(resource)
        if number is None:
            number = self._numbers[resource] = self._next
            self._next += 1
            weakref.finalize(resource, self._gone.append, number).atexit = False
        match resource:
            case Target():
                self._write_target(number, resource)
            case Pixels():
                self._write_pixels(number, resource)
            case Mesh():
                self._write_mesh(number, resource)
            case ShaderSource():
                self._write_source(number, resource)
            case CubeMap():
                self._write_cube(number, resource)
        return number

    def _write(self, message: Message) -> None:
        if self._gone:
            gone = sorted(self._gone)
            self._gone.clear()
            for number in gone:
                self._states.pop(number, None)
            self._send(Message("forget", gone))
        self._send(message)

    def _write_target(self, number: int, target: Target) -> None:
        state = [getattr(target, name) for name in TARGET_FIELDS]
        if self._is_new(number, state):
            self._send(Message("target", {"number": number, "state": state}))

    def _write_pixels(self, number: int, pixels: Pixels) -> None:
        # The array too: an image that is resized has another one.
        if self._is_new(number, (pixels.version, pixels.data.shape, pixels.mipmaps)):
            encoder = Encoder(self.number_of)
            data = encoder.array(pixels.data)
            value = {"number": number, "data": data, "mipmaps": pixels.mipmaps}
            self._send(Message("pixels", value, bytes(encoder.body)))

    def _write_source(self, number: int, source: ShaderSource) -> None:
        if self._is_new(number, True):
            encoder = Encoder(self.number_of)
            fields: dict[str, object] = {
                name: encoder.encode(getattr(source, name)) for name in SOURCE_FIELDS
            }
            fields |= {"number": number, "attributes": sorted(source.attributes)}
            self._send(Message("shader", fields))

    def _write_cube(self, number: int, cube: CubeMap) -> None:
        faces = [self.number_of(face) for face in cube.faces]  # written anew when they changed
        if self._is_new(number, faces):
            self._send(Message("cube", {"number": number, "faces": faces}))

    def _write_mesh(self, number: int, mesh: Mesh) -> None:
        seen = self._states.get(number)
        if not self._is_new(number, mesh.version):
            return
        edits = mesh.edits_since(seen) if isinstance(seen, int) else None
        if edits is None:
            self._write_whole_mesh(number, mesh)
        for edit in edits or ():
            self._write_edit(number, mesh.blocks[edit.layer], edit)

    def _write_whole_mesh(self, number: int, mesh: Mesh) -> None:
        encoder = Encoder(self.number_of)
        blocks = [[layer.value, encoder.encode(block)] for layer, block in mesh.blocks.items()]
        value = {
            "number": number,
            "blocks": blocks,
            "weight_scale": mesh.weight_scale,
            "kinds": _kinds(mesh),
        }
        self._send(Message("mesh", value, bytes(encoder.body)))

    def _write_edit(self, number: int, block: VertexBlock, edit: Edit) -> None:
        encoder = Encoder(self.number_of)
        owner = block.materials if edit.column == "ambient" else block
        part = encoder.array(getattr(owner, edit.column)[edit.first : edit.last])
        place = {"number": number, "layer": edit.layer.value, "column": edit.column}
        value = {**place, "first": edit.first, "data": part}
        self._send(Message("edit", value, bytes(encoder.body)))

    def _is_new(self, number: int, state: object) -> bool:
        """Return whether a resource differs from what was written of it, and note that it is."""
        if self._states.get(number) == state:
            return False
        self._states[number] = state
        return True


def _kinds(mesh: Mesh) -> dict[str, int]:
    """Return what a mesh was made from: how many of each kind."""
    if mesh.source is None:
        return {}
    counts = Counter(mesh.source.row_array()["kind"].tolist())
    return {Kind(kind).name.lower(): count for kind, count in sorted(counts.items())}
