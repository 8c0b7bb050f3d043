"""Recorded calls to a mesh: what a retained shape consists of, in its own coordinates."""

from __future__ import annotations

from sketchkit.draw.assemble import Assembler
from sketchkit.draw.commands import Draw
from sketchkit.draw.expand import expand
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.rows import Rows


def retain(recorder: Recorder) -> list[MeshPart]:
    """Return the parts of the mesh that all rows of a recorder make, in the order of drawing.

    The rows' states have the identity for matrix, and stages with a `sighting`.
    """
    rows = Rows(recorder)
    commands = Assembler(rows).assemble(expand(rows))
    mesh = Mesh(commands.blocks)
    return [
        MeshPart(mesh, draw.layer, draw.first, draw.count, draw.pipeline.texture)
        for draw in commands.commands
        if isinstance(draw, Draw)
    ]
