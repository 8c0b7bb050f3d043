"""What the corners of a finished shape are, in its recorder: reading and writing it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.api.pshape.parts import Family, ShapeParts
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.draw.given_vertices import corner_of, given_places, with_given
from sketchkit.draw.recorder import CORNER, UV, Attributes, ShapeRun, pack_uv, unpack_place
from sketchkit.draw.resources import Texture
from sketchkit.draw.retain import Quality
from sketchkit.draw.vertex import Layer, VertexBlock

SPARE_ATTRIBUTES = 64

Triple = tuple[float, float, float]


class ShapeCorners(ShapeParts):
    """Corners of what was given vertex by vertex; a primitive has those of its mesh."""

    @property
    def _is_primitive(self) -> bool:
        return self._family is Family.PRIMITIVE

    def _corner_index(self, caller: str, index: float) -> int:
        """Return the index of a corner that can be changed."""
        if self._is_group or self._is_primitive:
            raise SketchError(
                f"{caller}() with an index is for shapes made with beginShape().",
                hint="getTessellation() makes such a shape of any other.",
            )
        given = self._checked(caller, index, self._vertex_count())
        run = self._curved_run
        return given if run is None else corner_of(run, self._corner_places(), given)

    @property
    def _curved_run(self) -> ShapeRun | None:
        """What is recorded, if it has curves: its corners are not the vertices given then."""
        runs = self._recorder.shapes
        return runs[0] if len(runs) == 1 and runs[0].curves else None

    def _vertex_count(self) -> int:
        run = self._curved_run
        if run is None:
            return self._recorder.corner_end // CORNER
        return len(given_places(run, self._corner_places()))

    def _corner_places(self) -> NDArray[np.float32]:
        """Return the places of all corners, (n, 3)."""
        places: NDArray[np.float32] = self._recorder.corner_array()["place"]
        return places

    def _move_given(self, index: int, place: Triple) -> None:
        """Move a vertex of a shape with curves, and the curves with it."""
        run = self._curved_run
        assert run is not None
        places = self._corner_places()
        given = given_places(run, places)
        given[index] = place
        self._recorder.shapes[0], places[:] = with_given(run, places, given)
        self._expand_anew()

    def _checked(self, caller: str, index: float, count: int) -> int:
        try:
            corner = int(index + 0)
        except (TypeError, ValueError):
            got = f"{kind_of(index)}: {shown(index)}"
            raise SketchError(f"{caller}() takes the index of a vertex first.", got=got) from None
        if not 0 <= corner < count:
            has = f"vertices 0 to {count - 1}" if count else "no vertices"
            raise SketchError(f"{caller}(): the shape has {has}.", got=str(corner))
        return corner

    def _made_block(self) -> VertexBlock | None:
        """Return the vertices that a primitive's fill is made of, or its line or point."""
        mesh = self._mesh()
        if mesh is None:
            return None
        return next((mesh.blocks[layer] for layer in Layer if layer in mesh.blocks), None)

    def _made_places(self) -> NDArray[np.float32]:
        """Return the vertices of a primitive, (n, 3), as Processing counts them."""
        if self._kind in (c.POINT, c.LINE):
            numbers: NDArray[np.float32] = self._recorder.row_array()["numbers"][0, :6].copy()
            return numbers.reshape(2, 3)[: 1 if self._kind == c.POINT else 2]
        block = self._made_block()
        if block is None or block.sources is None:
            return np.zeros((0, 3), np.float32)
        places = block.positions[block.sources >= 0]
        if self._kind == c.ELLIPSE:  # its fan ends where it began
            return np.concatenate([places, places[1:2]])
        return places

    def _place(self, caller: str, index: int) -> Triple:
        if self._is_primitive:
            places = self._made_places()
            x, y, z = places[self._checked(caller, index, len(places))].tolist()
            return x, y, z
        run = self._curved_run
        if run is not None:
            given = given_places(run, self._corner_places())
            x, y, z = given[self._checked(caller, index, len(given))].tolist()
            return x, y, z
        corner = self._corner_index(caller, index)
        x, y, z = unpack_place(self._recorder.corners, corner * CORNER)
        return x, y, z

    def _normal_at(self, index: int) -> Triple:
        block = self._made_block()
        if self._is_primitive:
            count = 0 if block is None else len(block.positions)
            vertex = self._checked("getNormal", index, count)
        else:
            vertex = self._corner_index("getNormal", index)
            if self._recorder.normals is not None:
                x, y, z = self._recorder.normals[vertex].tolist()
                return x, y, z
            if all(run.has_normals for run in self._recorder.shapes):
                return self._attributes_of(vertex).normal
            found = np.flatnonzero(_sources(block) == vertex)
            if not len(found):
                return self._attributes_of(vertex).normal
            vertex = int(found[0])
        if block is None or block.normals is None:
            return 0.0, 0.0, 1.0
        normal = block.normals[vertex].astype(np.float64)
        x, y, z = (normal / (np.linalg.norm(normal) or 1)).tolist()
        return x, y, z

    def _keep_normals(self) -> None:
        """Have a normal for each corner that can be changed: given ones, or those of faces."""
        recorder = self._recorder
        if recorder.normals is not None:
            return
        corners = range(recorder.corner_end // CORNER)
        recorder.normals = np.array([self._normal_at(i) for i in corners], np.float32)
        recorder.shapes[:] = [run._replace(has_normals=True) for run in recorder.shapes]

    def _uv_at(self, caller: str, index: int) -> tuple[float, float]:
        if self._is_primitive:
            return self._made_uv(caller, index)
        corner = self._corner_index(caller, index)
        uvs = self._recorder.uv_array()
        if corner >= len(uvs):
            return 0.0, 0.0
        u, v = uvs[corner].tolist()
        return u, v

    def _made_uv(self, caller: str, index: int) -> tuple[float, float]:
        """Return where on a texture a primitive's vertex lies, whether it has one or not."""
        if self._texture_source is None and self._kind in (c.RECT, c.QUAD):
            return ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))[self._checked(caller, index, 4)]
        block = self._made_block()
        if block is None or block.uvs is None:
            return 0.0, 0.0
        u, v = block.uvs[self._checked(caller, index, len(block.uvs))].tolist()
        return u, v

    def _ensure_uvs(self) -> None:
        """Give all corners texture coordinates, if they have none."""
        recorder = self._recorder
        while recorder.uv_end // UV < recorder.corner_end // CORNER:
            recorder.make_room()
            pack_uv(recorder.uvs, recorder.uv_end, 0.0, 0.0)
            recorder.uv_end += UV

    def _color_at(self, caller: str, index: int, name: str) -> int:
        """Return the fill or the stroke of a corner."""
        if self._is_primitive:
            color = self._fill if name == "fill" else self._stroke
            return color if color >= 0 else ~color
        color = int(self._recorder.corner_array()[self._corner_index(caller, index)][name])
        return color if color >= 0 else ~color

    def _material_at(self, caller: str, index: int, part: str) -> float:
        material = self._style.material
        if not self._is_primitive:
            material = self._attributes_of(self._corner_index(caller, index)).material
        value: float = getattr(material, part)
        return value

    def _attributes_of(self, corner: int) -> Attributes:
        entry = int(self._recorder.corner_array()[corner]["attributes"])
        return self._recorder.attributes[entry]

    def _set_attribute(self, corner: int, **changes: object) -> None:
        """Change what a corner has besides place and colours."""
        entries = self._recorder.attributes
        table = self._recorder.corner_array()
        entries.append(self._attributes_of(corner)._replace(**changes))  # type: ignore[arg-type] # the callers know
        table["attributes"][corner] = len(entries) - 1
        if len(entries) > 2 * len(table) + SPARE_ATTRIBUTES:  # most are nobody's any more
            used, table["attributes"] = np.unique(table["attributes"], return_inverse=True)
            entries[:] = [entries[i] for i in used]

    def _unweigh_bare_corners(self) -> None:
        """Give corners that came without a stroke no weight, in 3D.

        As in Processing, a stroke that is switched on later does not show there until
        `setStrokeWeight()` says how wide it is.
        """
        table, entries = self._recorder.corner_array(), self._recorder.attributes
        is_bare = table["stroke"] < 0
        if not self._stage.is_3d or not is_bare.any():
            return
        table["attributes"][is_bare] += len(entries)
        entries += [entry._replace(weight=0.0) for entry in entries]

    def _all_attributes(self, **changes: object) -> None:
        entries = self._recorder.attributes
        entries[:] = [entry._replace(**changes) for entry in entries]  # type: ignore[arg-type] # the callers know

    def _set_corner(self, name: str, quality: Quality, index: object, color: int) -> None:
        """Give one corner another fill or stroke."""
        corner = self._corner_index(f"set{name.title()}", index)  # type: ignore[arg-type] # it checks
        self._recorder.corner_array()[name][corner] = color
        self._edit(quality, corner)

    def _corner_column(self, name: str, value: int) -> None:
        self._recorder.corner_array()[name] = value

    def _row_column(self, name: str, value: float) -> None:
        self._recorder.row_array()[name] = value

    def _cover_with(self, texture: Texture | None) -> None:
        """Put a texture on everything that is recorded."""
        recorder, old = self._recorder, self._current_texture()
        if self._is_primitive and not recorder.shapes:
            recorder.textures[:] = [] if texture is None else [texture]
            self._row_column("link", 0 if texture is None else 1)
            return
        self._ensure_uvs()
        if self._texture_mode == c.IMAGE:
            uvs = recorder.uv_array()
            if old is not None:
                uvs *= (old.width, old.height)
            if texture is not None:
                uvs /= (texture.across, texture.down)
        runs = recorder.shapes
        runs[:] = [run._replace(texture=texture, first_uv=run.first) for run in runs]
        fill = self._fill if texture is None or self._fill >= 0 else ~self._fill
        self._row_column("fill", fill)


def _sources(block: VertexBlock | None) -> NDArray[np.int32]:
    if block is None or block.sources is None:
        return np.zeros(0, np.int32)
    return block.sources
