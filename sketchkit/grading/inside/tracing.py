"""A trace of each frame: what its draw lists show, counted while a tape is played."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import ClassVar

import numpy as np

from sketchkit.draw.commands import Draw, DrawList, DrawMesh
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.recorder import WHOLE, Kind
from sketchkit.draw.resources import Pixels, Target, Texture
from sketchkit.draw.rows import Rows
from sketchkit.draw.shading import ShaderSource, Shading
from sketchkit.draw.stage import Stage
from sketchkit.glsl.interface import read_interface
from sketchkit.grading.evidence import Trace

# Names of kinds that differ from the recorder's: letters are what text() draws.
NAMES = {Kind.LETTER: "text"}
# Processing gives these to each shader that declares them, whatever the sketch sets.
ALWAYS_GIVEN = frozenset({"resolution", "viewport"})
# What a kept shape was made from is the tape's word: it counts only if it has the vertices for it.
FEWEST_VERTICES = {
    "box": 24,
    "sphere": 12,
    **dict.fromkeys(("rect", "quad", "image", "letter"), 4),
    **dict.fromkeys(("ellipse", "arc", "triangle"), 3),
}


class Tracer:
    """Reads along with a renderer.

    Parameters
    ----------
    mesh_kinds : mapping of Mesh to dict
        What retained geometry was made from.
    """

    reads_shapes: ClassVar = False

    def __init__(self, mesh_kinds: Mapping[Mesh, dict[str, int]]) -> None:
        self._mesh_kinds = mesh_kinds
        self._declared: dict[ShaderSource, frozenset[str]] = {}
        self._begin()

    def _begin(self) -> None:
        self._kinds: Counter[str] = Counter()
        self._nesting = self._lights = self._draw_calls = self._vertices = 0
        self._meshes: set[Mesh] = set()
        self._textures: set[Pixels] = set()
        self._targets: set[Target] = set()
        self._shaders: dict[str, set[str]] = {}

    def take(self, canvas: Target) -> Trace:
        """Return the trace of what was drawn since the last time.

        `canvas` is the main one: the others count as canvases.
        """
        for mesh in self._meshes:
            self._kinds.update(_made_from(mesh, self._mesh_kinds.get(mesh, {})))
        trace = Trace(
            kinds=dict(sorted(self._kinds.items())),
            nesting=self._nesting,
            lights=self._lights,
            retained=len(self._meshes),
            textures=len(self._textures),
            canvases=len(self._targets - {canvas}),
            shaders={name: tuple(sorted(given)) for name, given in sorted(self._shaders.items())},
            draw_calls=self._draw_calls,
            vertices=self._vertices,
        )
        self._begin()
        return trace

    def read_rows(self, rows: Rows) -> None:
        """Take what was recorded."""
        drawn = ~np.isin(rows.kinds, WHOLE)
        kinds, counts = np.unique(rows.kinds[drawn], return_counts=True)
        for kind, count in zip(kinds.tolist(), counts.tolist(), strict=True):
            self._kinds[NAMES.get(Kind(kind), Kind(kind).name.lower())] += count
        recorder = rows.recorder
        for state in np.unique(rows.states[drawn]).tolist():
            self._nesting = max(self._nesting, recorder.nestings[state])
            self._look_at(recorder.stages[state])
        self._meshes |= recorder.meshes
        self._take_textures(_textures(rows))

    def read_commands(self, commands: DrawList) -> None:
        """Take what is about to be drawn."""
        self._vertices += sum(len(block.positions) for block in commands.blocks.values())
        for command in commands.commands:
            self._draw_calls += isinstance(command, Draw | DrawMesh)
            if isinstance(command, DrawMesh):
                part = command.part
                self._vertices += min(part.count, len(part.mesh.blocks[part.layer].positions))

    def _look_at(self, stage: Stage) -> None:
        self._lights = max(self._lights, len(stage.lights or ()))
        self._targets.add(stage.target)
        for shading in stage.shadings:
            if isinstance(shading, Shading):
                given = self._shaders.setdefault(shading.source.name, set())
                given |= self.given_to(shading)

    def given_to(self, shading: Shading) -> frozenset[str]:
        """Return the uniforms of a shader that have been given a value."""
        return self._uniforms(shading.source) & {*shading.uniforms.values, *ALWAYS_GIVEN}

    def _uniforms(self, source: ShaderSource) -> frozenset[str]:
        """Return the names of the uniforms that a shader declares."""
        if source not in self._declared:
            vertex, fragment = source.vertex, source.fragment
            texts = vertex.text if vertex else None, fragment.text if fragment else None
            self._declared[source] = frozenset(read_interface(*texts).uniforms)
        return self._declared[source]

    def _take_textures(self, textures: Iterable[Texture | None]) -> None:
        for texture in textures:
            if isinstance(texture, Pixels):
                self._textures.add(texture)
            elif texture is not None:
                self._targets.add(texture)


def _made_from(mesh: Mesh, claimed: Mapping[str, int]) -> dict[str, int]:
    """Return how many of each kind a kept shape can be made from, of those that are claimed."""
    vertices = sum(len(block.positions) for block in mesh.blocks.values())
    return {
        kind: min(count, vertices // FEWEST_VERTICES.get(kind, 1))
        for kind, count in claimed.items()
    }


def _textures(rows: Rows) -> Iterator[Texture | None]:
    """Yield what shapes are covered with; not the pictures of letters."""
    recorder = rows.recorder
    links = np.unique(rows.links[rows.kinds == Kind.IMAGE])
    yield from (recorder.textures[link] for link in links.tolist())
    yield from (run.texture for run in recorder.shapes)
    yield from (part.texture for part in recorder.parts)
