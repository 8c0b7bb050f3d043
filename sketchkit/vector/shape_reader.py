"""ShapeReader: turns recorded calls into a page, each call as the shape that it names."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import groupby
from typing import ClassVar

from sketchkit.draw.assemble import Assembler
from sketchkit.draw.commands import Draw, DrawList, DrawMesh, Upload
from sketchkit.draw.expand import expand
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.recorder import Kind, Recorder
from sketchkit.draw.resources import Target
from sketchkit.draw.rows import Rows
from sketchkit.draw.vertex import U8
from sketchkit.vector.canvas_pages import CanvasPages
from sketchkit.vector.faces import Unit, batch_of, in_depth, units_of
from sketchkit.vector.page import Item, Page
from sketchkit.vector.pictures import image_items, upload_picture
from sketchkit.vector.polygons import shape_items
from sketchkit.vector.shapes import ITEMS as FLAT_ITEMS
from sketchkit.vector.views import View, views_of

ITEMS: dict[int, Callable[[Rows, int, View], Iterator[Item | None]]] = {
    **FLAT_ITEMS,
    Kind.IMAGE: image_items,
    Kind.LETTER: image_items,
    Kind.SHAPE: shape_items,
}

SOLID = (Kind.BOX, Kind.SPHERE, Kind.MESH)  # they have sides: some of them lie behind others


class ShapeReader:
    """Writes what is drawn on a target onto a page, in the sketch's order.

    Other canvases have pages as well, which are laid on it when they are drawn like images.

    Parameters
    ----------
    target : Target
    look : callable
        Returns what was drawn on a canvas so far, (h, w, 4).
    """

    reads_shapes: ClassVar = True

    def __init__(self, target: Target, look: Callable[[Target], U8]) -> None:
        self._pages = CanvasPages(look)
        self._page = self._pages.begin(target)

    def read_rows(self, rows: Rows) -> None:
        """Add what some rows draw."""
        views = views_of(rows, self._pages.page)
        kinds, states = rows.kinds.tolist(), rows.states.tolist()
        stages = [views[state].stage for state in states]
        is_solid = [
            kind in SOLID and (stage.is_3d or kind != Kind.MESH)
            for kind, stage in zip(kinds, stages, strict=True)
        ]
        for (are_solid, target), run in groupby(
            range(len(kinds)), key=lambda row: (is_solid[row], stages[row].target)
        ):
            page, at = self._pages.page(target), list(run)
            if are_solid:
                page.items += solid_items(rows.recorder.part(at[0], at[-1] + 1), self._pages.page)
                continue
            for row in at:
                _add(rows, row, views[states[row]], page)

    def read_commands(self, commands: DrawList) -> None:
        """Add pixels that the sketch has set; all else has come as rows."""
        for command in commands.commands:
            if isinstance(command, Upload):
                self._pages.page(command.target).items.append(upload_picture(command))

    def finish(self) -> Page:
        """Return the page."""
        return self._page


def _add(rows: Rows, row: int, view: View, page: Page) -> None:
    """Add what a row draws to a page."""
    kind = int(rows.kinds[row])
    if kind == Kind.CLEAR:
        page.clear(int(rows.fills[row]), view.stage.clip)
    else:
        items = mesh_items if kind == Kind.MESH else ITEMS.get(kind)
        if items is not None:
            page.items += [item for item in items(rows, row, view) if item is not None]


def mesh_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield what a flat retained shape was made from; its first part stands for all."""
    mesh = rows.recorder.parts[rows.links[row]].mesh
    if mesh.source is None or (row and _is_part_of(mesh, rows, row - 1, view)):
        return
    source = Rows(mesh.source, mesh.weight_scale)
    for i, (kind, state) in enumerate(
        zip(source.kinds.tolist(), source.states.tolist(), strict=True)
    ):
        if kind in ITEMS:
            yield from ITEMS[kind](source, i, replace(view, style=source.styles[state]))


def _is_part_of(mesh: Mesh, rows: Rows, row: int, view: View) -> bool:
    """Return whether a row draws a part of a mesh, at the place that a view has."""
    if rows.kinds[row] != Kind.MESH or rows.recorder.parts[rows.links[row]].mesh is not mesh:
        return False
    modelview = rows.matrices[rows.states[row]].reshape(3, 4)
    return bool((modelview == view.modelview).all())


def solid_items(recorder: Recorder, page_of: Callable[[Target], Page]) -> list[Item]:
    """Return the triangles, lines and points that all rows of a recorder become, far ones first."""
    rows = Rows(recorder)
    commands = Assembler(rows).assemble(expand(rows))
    units: list[Unit] = []
    for command in commands.commands:
        if isinstance(command, Draw | DrawMesh):
            units += units_of(batch_of(command, commands), page_of)
    return in_depth(units)
