"""Buffers: vertex columns on the GPU, of a list and of meshes, bound to what reads them."""

from __future__ import annotations

import weakref

import moderngl
import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.gl.programs import BuiltInProgram
from sketchkit.backends.gl.sketch_programs import SketchProgram
from sketchkit.draw.meshes import Edit, Mesh
from sketchkit.draw.vertex import CUSTOM, Layer, VertexBlock

AnyProgram = BuiltInProgram | SketchProgram
RING = 3  # as many copies, used in turn: the driver may still be drawing from the last ones
SMALLEST = 1 << 12

# Name in the shaders, format, and where a block keeps it.
_FORMATS: dict[str, str] = {
    "position": "3f4",
    "color": "4f1",
    "uv": "2f4",
    "normal": "3f4",
    "ambient": "4f1",
    "specular": "4f1",
    "emissive": "4f1",
    "shininess": "1f4",
    "direction": "4f4",
    "offset": "2f4",
}

# An edit names a column as the block does.
COLUMN_NAMES = {
    "positions": "position",
    "colors": "color",
    "normals": "normal",
    "uvs": "uv",
    "ambient": "ambient",
}


def columns_of(block: VertexBlock) -> dict[str, NDArray[np.generic]]:
    """Return the columns that a block has, by their names in the shaders."""
    columns: dict[str, NDArray[np.generic] | None] = {
        "position": block.positions,
        "color": block.colors,
        "uv": block.uvs,
        "normal": block.normals,
        "direction": block.directions,
        "offset": block.offsets,
    }
    if block.materials is not None:
        columns |= {
            "ambient": block.materials.ambient,
            "specular": block.materials.specular,
            "emissive": block.materials.emissive,
            "shininess": block.materials.shininess,
        }
    columns |= {CUSTOM + name: column for name, column in block.custom.items()}
    return {name: column for name, column in columns.items() if column is not None}


class _LayerBuffers:
    """The buffers of one layer; they only grow."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._buffers: dict[str, moderngl.Buffer] = {}
        self._arrays: dict[tuple[AnyProgram, frozenset[str]], moderngl.VertexArray] = {}
        self._block: VertexBlock | None = None
        self._present: frozenset[str] = frozenset()

    def upload(self, block: VertexBlock) -> None:
        """Write a block's columns and indices."""
        self._block = block
        columns = columns_of(block)
        self._present = frozenset(columns)
        for name, column in {**columns, "index": block.indices}.items():
            self._write(name, column)

    def _write(self, name: str, column: NDArray[np.generic]) -> None:
        buffer = self._buffers.get(name)
        if buffer is None or buffer.size < column.nbytes:
            size = max(SMALLEST, 1 << (column.nbytes - 1).bit_length()) if column.nbytes else 0
            self._replace(name, max(size, SMALLEST))
            buffer = self._buffers[name]
        buffer.write(np.ascontiguousarray(column))

    def change(self, block: VertexBlock, edit: Edit) -> None:
        """Write the vertices of one column that an edit names."""
        name = COLUMN_NAMES[edit.column]
        column = columns_of(block)[name]
        per_vertex = column.nbytes // len(column)
        part = np.ascontiguousarray(column[edit.first : edit.last])
        self._buffers[name].write(part, offset=edit.first * per_vertex)

    def release(self) -> None:
        """Let go of everything on the GPU."""
        for array in self._arrays.values():
            array.release()
        for buffer in self._buffers.values():
            buffer.release()

    def _replace(self, name: str, size: int) -> None:
        """Make a buffer anew, and with it whatever was bound to the old one."""
        for array in self._arrays.values():
            array.release()
        self._arrays.clear()
        if name in self._buffers:
            self._buffers[name].release()
        self._buffers[name] = self._context.buffer(reserve=size, dynamic=True)

    def array(self, program: AnyProgram) -> moderngl.VertexArray:
        """Return the columns that a program reads, bound to it; those that the block has."""
        key = (program, self._present)
        if key not in self._arrays:
            program.tell_of_unfed(self._present)
            content = [
                self._bound(column, attribute, is_whole=is_whole)
                for attribute, column, is_whole in program.attributes()
                if column in self._present
            ]
            self._arrays[key] = self._context.vertex_array(
                program.compiled,
                content,
                index_buffer=self._buffers["index"],
                index_element_size=4,
            )
        return self._arrays[key]

    def _bound(
        self, column: str, attribute: str, *, is_whole: bool
    ) -> tuple[moderngl.Buffer, str, str]:
        """Return a column as a vertex array takes it, as whole numbers if a shader wants those."""
        if not column.startswith(CUSTOM):
            return self._buffers[column], _FORMATS[column], attribute
        assert self._block is not None
        values = self._block.custom[column.removeprefix(CUSTOM)]
        if is_whole:
            column = f"whole {column}"
            self._write(column, values.astype(np.int32))
        kind = "i4" if is_whole else "f4"
        return self._buffers[column], f"{values.shape[1]}{kind}", attribute


class Buffers:
    """The vertices of the list that is being drawn, and of the meshes that were drawn."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._meshes: weakref.WeakKeyDictionary[Mesh, _MeshBuffers] = weakref.WeakKeyDictionary()
        self._ring = [{layer: _LayerBuffers(context) for layer in Layer} for _ in range(RING)]
        self._turn = 0

    def upload(self, blocks: dict[Layer, VertexBlock]) -> None:
        """Write the blocks of a list."""
        self._turn = (self._turn + 1) % RING
        for layer, block in blocks.items():
            self._ring[self._turn][layer].upload(block)

    def array(self, layer: Layer, program: AnyProgram) -> moderngl.VertexArray:
        """Return a layer's columns bound to a program."""
        return self._ring[self._turn][layer].array(program)

    def mesh_array(self, mesh: Mesh, layer: Layer, program: AnyProgram) -> moderngl.VertexArray:
        """Return the columns of a mesh bound to a program; what has changed is sent first."""
        held = self._meshes.get(mesh)
        if held is None:
            held = self._meshes[mesh] = _MeshBuffers(self._context)
        held.update(mesh)
        return held.layers[layer].array(program)

    def forget(self, mesh: Mesh) -> None:
        """Release a mesh's buffers."""
        if held := self._meshes.pop(mesh, None):
            held.release()


class _MeshBuffers:
    """The buffers of one mesh, as they were at one of its versions."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._version = -1
        self.layers: dict[Layer, _LayerBuffers] = {}

    def update(self, mesh: Mesh) -> None:
        """Send what has changed since the last time; at first, everything."""
        if self._version == mesh.version:
            return
        edits = mesh.edits_since(self._version) if self._version >= 0 else None
        if edits is None:
            for layer, block in mesh.blocks.items():
                buffers = self.layers.setdefault(layer, _LayerBuffers(self._context))
                buffers.upload(block)
        for edit in edits or ():
            self.layers[edit.layer].change(mesh.blocks[edit.layer], edit)
        self._version = mesh.version

    def release(self) -> None:
        """Let go of everything on the GPU."""
        for buffers in self.layers.values():
            buffers.release()
