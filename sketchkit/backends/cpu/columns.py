"""A block's columns: those that a program reads, of the vertices that a draw refers to."""

from __future__ import annotations

from typing import TypeVar

from sketchkit.draw.vertex import Materials, VertexBlock

_Column = TypeVar("_Column")


def given(column: _Column | None) -> _Column:
    """Return a column that a program reads.

    Raises
    ------
    ValueError
        If the block was made without it.
    """
    if column is None:
        raise ValueError("the block lacks a column that the draw's program reads")
    return column


def part_of(block: VertexBlock, first: int, last: int) -> VertexBlock:
    """Return the vertices from `first` to before `last`, without indices."""
    rows = slice(first, last)
    materials = block.materials
    return VertexBlock(
        positions=block.positions[rows],
        colors=block.colors[rows],
        indices=block.indices[:0],
        uvs=None if block.uvs is None else block.uvs[rows],
        normals=None if block.normals is None else block.normals[rows],
        materials=materials
        and Materials(
            materials.ambient[rows],
            materials.specular[rows],
            materials.emissive[rows],
            materials.shininess[rows],
        ),
        directions=None if block.directions is None else block.directions[rows],
        offsets=None if block.offsets is None else block.offsets[rows],
    )
