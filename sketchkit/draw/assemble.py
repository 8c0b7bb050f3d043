"""Pieces to a draw list: vertices in eye space, and draws in the order that Processing draws in.

The order is the sketch's. In P2D the outline of a shape follows its fill; in P3D a section's fills
come first, then its strokes, then its points.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.notices import warn_once
from sketchkit.draw.commands import Clear, Command, Draw, DrawList, DrawMesh, Settle, Settling
from sketchkit.draw.custom_columns import custom_columns, custom_samples
from sketchkit.draw.layers import LayerPieces, PieceOrder, unpack_argb
from sketchkit.draw.pieces import Expansion, Fills, Lines, Points
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.recorder import WHOLE, Kind
from sketchkit.draw.resources import Target, Texture
from sketchkit.draw.rows import Rows
from sketchkit.draw.shading import Shading
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import Layer
from sketchkit.geometry.ribbons import ribbon
from sketchkit.geometry.shapes import triangle_normals

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients

# Ends of strokes are pulled a thousandth toward the eye, to win over the fill that they outline.
PULL_PERSPECTIVE = (0.999, 0.999, 0.999)
STROKE = -1  # the source of an outline in the plane
PULL_PARALLEL = (1.0, 1.0, 0.999)
NO_PULL = (1.0, 1.0, 1.0)


class Assembler:
    """Makes one draw list of the pieces of recorded rows."""

    def __init__(self, rows: Rows) -> None:
        self.rows = rows
        self.layers = {layer: LayerPieces() for layer in Layer}

    def assemble(self, expansion: Expansion) -> DrawList:
        """Return the list."""
        self.has_uvs = any(fills.uvs is not None for fills in expansion.fills)
        self.customs = custom_samples(self.rows)
        for fills in expansion.fills:
            self._add_fills(fills)
        for lines in expansion.lines:
            self._add_lines(lines)
        for points in expansion.points:
            self._add_points(points)
        return self._draw_list()

    def _add_fills(self, fills: Fills) -> None:
        x, y, z = self.rows.transform(fills.rows, fills.x, fills.y, fills.z)
        if fills.shift is not None:
            x, y = x + fills.shift[:, :1], y + fills.shift[:, 1:]
        if fills.snap is not None:
            snap = fills.snap[:, None]
            x, y = np.where(snap, np.ceil(x), x), np.where(snap, np.ceil(y), y)
        x, y, z = np.broadcast_arrays(x, y, z)
        columns: dict[str, NDArray[np.generic]] = {
            "positions": np.stack([x, y, z], axis=2),
            "colors": unpack_argb(fills.colors),
        }
        if self.has_uvs:
            no_uvs = np.zeros((1, 1, 2), np.float32)
            columns["uvs"] = no_uvs if fills.uvs is None else fills.uvs
        if self.rows.is_lit:
            columns["normals"] = self._normals(fills, x, y, z)
            columns |= self._materials(fills)
        own = np.full((1, 1), STROKE if fills.is_stroke else 0)
        columns |= self._sources(own if fills.sources is None else fills.sources)
        if self.customs:
            inverse = self._normal_matrices()
            columns |= custom_columns(self.rows, fills, self.customs, inverse)
        keys = 2 * fills.rows + fills.is_stroke
        self.layers[Layer.FILLS].add(
            keys, fills.triangles, columns, fills.textures, fills.hides_back
        )

    def _sources(self, sources: NDArray[np.int64] | None) -> dict[str, NDArray[np.generic]]:
        """Return the column that says which corners vertices are, for what is retained."""
        if not self.rows.is_retained.any():
            return {}
        column = np.zeros((1, 1)) if sources is None else sources
        return {"sources": column.astype(np.int32)}

    def _normals(self, fills: Fills, x: F32, y: F32, z: F32) -> F32:
        """Return normals in eye space, (n, k or 1, 3)."""
        if fills.is_stroke:
            return np.zeros((1, 1, 3), np.float32)
        if fills.normals is None:
            a, b, c = (np.stack([x[:, i], y[:, i], z[:, i]], axis=1) for i in range(3))
            normals = triangle_normals(a, b, c)
            givers = fills.normal_givers
            return normals[:, None] if givers is None else normals[givers]
        inverse = self._normal_matrices()[self.rows.states[fills.rows]]  # (n, 3, 3)
        normals = np.broadcast_to(fills.normals, (len(inverse), *fills.normals.shape[1:]))
        turned: F32 = (normals @ inverse).astype(np.float32)
        return turned

    def _normal_matrices(self) -> F32:
        """Return the inverse of each state's matrix, (s, 3, 3): n @ inverse is the normal's way."""
        linear = self.rows.matrices.reshape(-1, 3, 4)[:, :, :3].astype(np.float64)
        singular = np.abs(np.linalg.det(linear)) < 1e-30
        linear[singular] = np.eye(3)
        return np.linalg.inv(linear).astype(np.float32)

    def _materials(self, fills: Fills) -> dict[str, NDArray[np.generic]]:
        """Return the columns of the material."""
        if fills.attributes is not None:
            materials = [entry.material for entry in self.rows.recorder.attributes]
            index = fills.attributes
        else:
            materials = [style.material for style in self.rows.styles]
            index = self.rows.states[fills.rows][:, None]
        ambient = np.array([material.ambient for material in materials], np.int64)[index]
        follows = fills.colors if fills.ambient is None else fills.ambient
        ambient = np.where(ambient < 0, np.maximum(follows, 0), ambient)
        packed = [
            np.array([material.specular for material in materials], np.int64)[index],
            np.array([material.emissive for material in materials], np.int64)[index],
        ]
        shininess = np.array([material.shininess for material in materials], np.float32)[index]
        return {
            "ambient": unpack_argb(ambient),
            "specular": unpack_argb(packed[0]),
            "emissive": unpack_argb(packed[1]),
            "shininess": shininess,
        }

    def _add_lines(self, lines: Lines) -> None:
        strip = ribbon(lines.x.shape[1], is_closed=lines.is_closed, is_joined=lines.is_joined)
        here, there = strip.points, strip.others
        x, y, z = self.rows.transform(lines.rows, lines.x, lines.y, lines.z)
        positions = np.stack([x[:, here], y[:, here], z[:, here]], axis=2)
        delta = [column[:, there] - column[:, here] for column in (lines.x, lines.y, lines.z)]
        m = self.rows.matrices[self.rows.states[lines.rows]].T[..., None]
        scales = self.rows.scales[self.rows.states[lines.rows]][:, None]
        half = np.broadcast_to(lines.weights, lines.x.shape)[:, here] * scales / 2
        directions = np.stack(
            [
                delta[0] * m[0] + delta[1] * m[1] + delta[2] * m[2],
                delta[0] * m[4] + delta[1] * m[5] + delta[2] * m[6],
                delta[0] * m[8] + delta[1] * m[9] + delta[2] * m[10],
                half * strip.sides,
            ],
            axis=2,
        )
        colors = np.broadcast_to(lines.colors, lines.x.shape)[:, here]
        columns: dict[str, NDArray[np.generic]] = {
            "positions": positions,
            "colors": unpack_argb(colors),
            "directions": directions.astype(np.float32),
        }
        columns |= self._sources(None if lines.sources is None else lines.sources[:, here])
        self.layers[Layer.LINES].add(2 * lines.rows, strip.triangles, columns)

    def _add_points(self, points: Points) -> None:
        place = (points.x[:, None], points.y[:, None], points.z[:, None])
        positions = np.stack(self.rows.transform(points.rows, *place), axis=2)
        corners = points.offsets.shape[1]
        columns: dict[str, NDArray[np.generic]] = {
            "positions": positions.repeat(corners, axis=1),
            "colors": unpack_argb(points.colors[:, None]),
            "offsets": points.offsets,
        }
        columns |= self._sources(None if points.sources is None else points.sources[:, None])
        self.layers[Layer.POINTS].add(2 * points.rows, points.triangles, columns)

    def _draw_list(self) -> DrawList:
        """Return commands, section by section, with the blocks that they refer to."""
        out = DrawList()
        ordered = out.orders
        for layer, collected in self.layers.items():
            if collected.keys:
                indices, ordered[layer] = collected.in_order()
                out.blocks[layer] = collected.block(indices)
        for first, last in self._sections():
            self._draw_section(first, last, ordered, out)
        return out

    def _sections(self) -> list[tuple[int, int]]:
        """Return ranges of rows: one that is drawn by itself, or rows of one stage."""
        stage_ids = np.array([id(stage) for stage in self.rows.stages])[self.rows.states]
        is_alone = np.isin(self.rows.kinds, (*WHOLE, Kind.MESH))
        is_alone |= np.array([stage.one_by_one for stage in self.rows.stages])[self.rows.states]
        begins = np.ones(len(is_alone), np.bool_)
        begins[1:] = (stage_ids[1:] != stage_ids[:-1]) | is_alone[1:] | is_alone[:-1]
        starts = np.flatnonzero(begins).tolist()
        return list(zip(starts, [*starts[1:], len(is_alone)], strict=True))

    def _draw_section(
        self, first: int, last: int, ordered: dict[Layer, PieceOrder], out: DrawList
    ) -> None:
        stage = self.rows.stages[self.rows.states[first]]
        if self.rows.kinds[first] == Kind.SETTLE:
            how = list(Settling)[self.rows.links[first]]
            out.commands.append(Settle(stage.target, how))
            return
        if self.rows.kinds[first] == Kind.CLEAR:
            covers = stage.depth_write and stage.clip is None
            if covers and _is_settle(out.commands[-1:], stage.target):
                out.commands.pop()  # the old picture does not show
            color = unpack_argb(self.rows.fills[first : first + 1])[0].tolist()
            out.commands.append(Clear(stage.target, tuple(color), stage.depth_write, stage.clip))
            return
        if self.rows.kinds[first] == Kind.MESH:
            out.commands.append(self._mesh_draw(first, stage))
            return
        layers = [layer for layer in Layer if layer in ordered]
        if stage.depth_sort and stage.is_3d:  # sorted fills come last: strokes show through them
            layers = layers[1:] + layers[:1]
            if layers[-1] is Layer.FILLS:
                ordered[Layer.FILLS].sort(first, last, out.blocks[Layer.FILLS], stage)
        for layer in layers:
            for run in ordered[layer].runs(first, last):
                pipeline = _pipeline(stage, layer, run.texture, culls_backs=run.hides_back)
                _append(out, Draw(pipeline, layer, run.begin, run.end - run.begin))

    def _mesh_draw(self, row: int, stage: Stage) -> DrawMesh:
        """Return the command for a row that draws a part of a mesh."""
        part = self.rows.recorder.parts[self.rows.links[row]]
        state = 12 * int(self.rows.states[row])
        modelview = tuple(self.rows.recorder.matrices[state : state + 12])
        return DrawMesh(_pipeline(stage, part.layer, part.texture), part, modelview)


def _pipeline(
    stage: Stage, layer: Layer, texture: Texture | None, *, culls_backs: bool = False
) -> Pipeline:
    """Return how a layer of a stage is drawn."""
    lights = stage.lights if layer is Layer.FILLS else None
    if layer is Layer.LINES:
        program = Program.LINE
    elif layer is Layer.POINTS:
        program = Program.POINT
    elif lights is None:
        program = Program.FLAT if texture is None else Program.TEXTURED
    else:
        program = Program.LIT if texture is None else Program.TEXTURED_LIT
    return Pipeline(
        program=program,
        shading=_shading(stage, layer, is_textured=texture is not None),
        target=stage.target,
        projection=stage.projection,
        blend=stage.blend,
        depth_test=stage.depth_test,
        depth_write=stage.depth_write,
        clip=stage.clip,
        lights=lights or (),
        texture=texture,
        wrap=stage.wrap,
        line_scale=_pull(stage),
        stroke_perspective=stage.stroke_perspective,
        culls_backs=culls_backs,
    )


def _shading(stage: Stage, layer: Layer, *, is_textured: bool) -> Shading | None:
    """Return the sketch's own shader for a layer, if it has one that serves."""
    if stage.sighting is not None:
        return None  # of what is retained: the stage that it is drawn on has its own
    if layer is Layer.LINES:
        return stage.shadings.lines
    if layer is Layer.POINTS:
        return stage.shadings.points
    shading = stage.shadings.fills
    if shading is None or shading.serves(is_textured=is_textured, is_lit=stage.lights is not None):
        return shading
    warn_once(
        f"The shader of {shading.source.name} does not draw what is"
        f" {'textured' if is_textured else 'untextured'} and"
        f" {'lit' if stage.lights is not None else 'unlit'}: it is drawn without it.",
        shading.uniforms.place,
    )
    return None


def _pull(stage: Stage) -> tuple[float, float, float]:
    """Return by what the ends of strokes are scaled."""
    if stage.one_by_one:
        return NO_PULL
    return PULL_PERSPECTIVE if stage.is_perspective else PULL_PARALLEL


def _is_settle(commands: list[Command], target: Target) -> bool:
    """Return whether a command only prepares a target's old picture for what follows."""
    return any(
        isinstance(command, Settle)
        and command.target is target
        and command.how is not Settling.NOTE
        for command in commands
    )


def _append(out: DrawList, draw: Draw) -> None:
    """Append a draw, or lengthen the last one if it goes on where that ended."""
    if out.commands and isinstance(last := out.commands[-1], Draw):
        joins = last.layer is draw.layer and last.first + last.count == draw.first
        if joins and last.pipeline == draw.pipeline and not draw.pipeline.reads_itself:
            out.commands[-1] = Draw(last.pipeline, last.layer, last.first, last.count + draw.count)
            return
    out.commands.append(draw)
