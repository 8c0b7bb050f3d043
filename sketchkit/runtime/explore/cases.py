"""Cases: a row that is asked about, and the triangles that it was made into."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.probe import Range
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.commands import Draw, DrawMesh
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.recorder import Kind
from sketchkit.draw.vertex import Layer as Block
from sketchkit.draw.vertex import VertexBlock
from sketchkit.runtime.explore.describe import Surroundings
from sketchkit.runtime.explore.layers import Part
from sketchkit.runtime.explore.log import FrameLog, Moment, Records


@dataclass(frozen=True)
class Piece:
    """What a row has drawn in one command: its fill, its outline or its points."""

    moment: Moment
    row: int
    part: Part
    pipeline: Pipeline
    block: VertexBlock
    drawn: Range

    @property
    def alphas(self) -> NDArray[np.uint8]:
        """The alphas of its vertices."""
        first = self.drawn.first
        used = self.block.indices[first : first + self.drawn.size]
        return np.asarray(self.block.colors[used, 3])


@dataclass(frozen=True)
class Case:
    """A row that is asked about."""

    log: FrameLog
    around: Surroundings
    serial: int
    row: int

    @property
    def records(self) -> Records:
        """The rows that it is one of."""
        records = self.log.steps[self.serial].records
        assert records is not None
        return records

    @property
    def kind(self) -> Kind:
        """What it draws."""
        return Kind(int(self.records.table["kind"][self.row]))

    @property
    def modelview(self) -> NDArray[np.float64]:
        """Its matrix, (3, 4)."""
        state = int(self.records.table["state"][self.row])
        return np.array(self.records.matrices[12 * state : 12 * state + 12]).reshape(3, 4)


def pieces_of(case: Case) -> Iterator[Piece]:
    """Yield what a row has drawn, command by command."""
    step = case.log.steps[case.serial]
    for index, command in enumerate(step.commands.commands):
        moment = case.serial, index
        if isinstance(command, DrawMesh) and step.rows[index] == case.row:
            part = command.part
            drawn = Range(part.first, part.count, command.modelview, part.weight_scale)
            yield Piece(
                moment,
                case.row,
                _part(part.layer),
                command.pipeline,
                part.mesh.blocks[part.layer],
                drawn,
            )
        elif isinstance(command, Draw):
            order = step.commands.orders[command.layer]
            for key, kind in (
                (2 * case.row, _part(command.layer)),
                (2 * case.row + 1, Part.STROKE),
            ):
                at = np.flatnonzero(order.keys == key)
                if not len(at):
                    continue
                begin = int(order.ends[at[0] - 1]) if at[0] else 0
                end = int(order.ends[at[-1]])
                begin, end = max(begin, command.first), min(end, command.first + command.count)
                if begin < end:
                    block = step.commands.blocks[command.layer]
                    drawn = Range(begin, end - begin, IDENTITY)
                    yield Piece(moment, case.row, kind, command.pipeline, block, drawn)


def _part(block: Block) -> Part:
    return {Block.FILLS: Part.FILL, Block.LINES: Part.STROKE, Block.POINTS: Part.POINT}[block]
