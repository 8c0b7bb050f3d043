"""The vertices of a finished shape: reading and changing them one by one."""

from __future__ import annotations

from typing import overload

from sketchkit.api._pen import PackError
from sketchkit.api.pshape.corners import ShapeCorners
from sketchkit.api.pvector import PVector
from sketchkit.core import constants as c
from sketchkit.core.errors import wrong_numbers
from sketchkit.draw.recorder import CORNER, pack_place
from sketchkit.draw.retain import Quality


class ShapeVertices(ShapeCorners):
    """Vertices are counted as they were given; transforms of the shape are not in them."""

    def getVertexCount(self, includeChildren: bool = False) -> int:
        """Return how many vertices the shape has; a group has none, unless children count.

        Examples
        --------
        >>> s = createShape(RECT, 10, 10, 50, 50)
        >>> print(s.getVertexCount())
        4
        """
        if self._is_group:
            if not includeChildren:
                return 0
            return sum(leaf.getVertexCount() for leaf in self._leaves())
        if self._is_primitive:
            return len(self._made_places())
        return self._vertex_count()

    def getVertex(self, index: int, vec: PVector | None = None) -> PVector:
        """Return the place of a vertex; a given vector is filled.

        Parameters
        ----------
        index : int
            From 0 to `getVertexCount()` - 1.
        vec : PVector, optional

        Raises
        ------
        SketchError
            If there is no such vertex.

        See Also
        --------
        setVertex, getVertexCount

        Notes
        -----
        Source: Processing's reference, PShape.getVertex().

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(20, 20)
        >>> s.vertex(80, 40)
        >>> s.vertex(40, 80)
        >>> s.endShape(CLOSE)
        >>> v = s.getVertex(1)
        >>> circle(v.x, v.y, 10)
        """
        place = self._place("getVertex", index)
        if vec is None:
            return PVector(*place)
        vec.set(*place)
        return vec

    def getVertexX(self, index: int) -> float:
        """Return the x of a vertex.

        Examples
        --------
        >>> print(createShape(RECT, 10, 20, 50, 50).getVertexX(0))
        10.0
        """
        return self._place("getVertexX", index)[0]

    def getVertexY(self, index: int) -> float:
        """Return the y of a vertex.

        Examples
        --------
        >>> print(createShape(RECT, 10, 20, 50, 50).getVertexY(0))
        20.0
        """
        return self._place("getVertexY", index)[1]

    def getVertexZ(self, index: int) -> float:
        """Return the z of a vertex.

        Examples
        --------
        >>> print(createShape(RECT, 10, 20, 50, 50).getVertexZ(0))
        0.0
        """
        return self._place("getVertexZ", index)[2]

    @overload
    def setVertex(self, index: int, vec: PVector, /) -> None: ...
    @overload
    def setVertex(self, index: int, x: float, y: float, z: float = 0.0, /) -> None: ...
    def setVertex(self, index: int, *place: float | PVector) -> None:
        """Move a vertex.

        Parameters
        ----------
        index : int
        *place : 2 or 3 float, or PVector
            Where it comes.

        Raises
        ------
        SketchError
            If there is no such vertex, or the shape has not ended.

        See Also
        --------
        getVertex, setNormal, setTextureUV

        Notes
        -----
        As in Processing, once a 3D shape of triangles or quads was drawn, its outline stays where
        it is, and so do the normals that were made from its faces. Moving a few vertices of many
        costs little: only they are sent to the graphics card. Of curves the control points are
        vertices too, and the curve follows them. Source: Processing's reference,
        PShape.setVertex().

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setVertex(1, 20, 20)
        >>> shape(s)
        """
        self._must_be_ended("setVertex")
        corner = self._corner_index("setVertex", index)
        numbers = tuple(place[0]) if len(place) == 1 and isinstance(place[0], PVector) else place
        try:
            x, y, z = (*numbers, 0.0) if len(numbers) == 2 else numbers
            if self._curved_run is None:
                pack_place(self._recorder.corners, corner * CORNER, x, y, z)
            else:
                self._move_given(index, (x + 0.0, y + 0.0, z + 0.0))  # type: ignore[operator] # no PVector
        except (TypeError, ValueError, *PackError):
            usage = "index, x, y [, z]"
            raise wrong_numbers("setVertex", (index, *place), usage) from None
        self._edit(Quality.PLACE, corner)

    @overload
    def getNormal(self, index: int, vec: PVector, /) -> PVector: ...
    @overload
    def getNormal(self, index: int, /) -> PVector: ...
    def getNormal(self, index: int, vec: PVector | None = None) -> PVector:
        """Return the normal of a vertex: the one that it was given, or its face's.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> n = createShape(BOX, 20).getNormal(0)
        """
        normal = self._normal_at(index)
        if vec is None:
            return PVector(*normal)
        vec.set(*normal)
        return vec

    def getNormalX(self, index: int) -> float:
        """Return the x of a vertex's normal.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> x = createShape(BOX, 20).getNormalX(0)
        """
        return self._normal_at(index)[0]

    def getNormalY(self, index: int) -> float:
        """Return the y of a vertex's normal.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> y = createShape(BOX, 20).getNormalY(0)
        """
        return self._normal_at(index)[1]

    def getNormalZ(self, index: int) -> float:
        """Return the z of a vertex's normal.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> z = createShape(BOX, 20).getNormalZ(0)
        """
        return self._normal_at(index)[2]

    def setNormal(self, index: int, nx: float, ny: float, nz: float) -> None:
        """Set the normal of a vertex.

        Notes
        -----
        The other vertices keep theirs, even if those were made from faces.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setNormal(1, 0, 0.6, 0.8)
        """
        self._must_be_ended("setNormal")
        corner = self._corner_index("setNormal", index)
        try:
            normal = (nx + 0.0, ny + 0.0, nz + 0.0)
        except TypeError:
            raise wrong_numbers("setNormal", (index, nx, ny, nz), "index, nx, ny, nz") from None
        self._keep_normals()
        assert self._recorder.normals is not None
        self._recorder.normals[corner] = normal
        self._edit(Quality.NORMAL, corner)

    def getTextureU(self, index: int) -> float:
        """Return the u of a vertex, 0 to 1 over the texture.

        Examples
        --------
        >>> print(createShape(RECT, 10, 20, 50, 50).getTextureU(1))
        1.0
        """
        return self._uv_at("getTextureU", index)[0]

    def getTextureV(self, index: int) -> float:
        """Return the v of a vertex, 0 to 1 over the texture.

        Examples
        --------
        >>> print(createShape(RECT, 10, 20, 50, 50).getTextureV(1))
        0.0
        """
        return self._uv_at("getTextureV", index)[1]

    def setTextureUV(self, index: int, u: float, v: float) -> None:
        """Set where on the texture a vertex lies, in the units of the shape's `textureMode()`.

        Examples
        --------
        >>> img = loadImage("photo.png")
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.texture(img)
        >>> s.vertex(10, 10, 0, 0)
        >>> s.vertex(90, 10, 60, 0)
        >>> s.vertex(90, 90, 60, 40)
        >>> s.endShape()
        >>> s.setTextureUV(1, 30, 0)
        >>> shape(s)
        """
        self._must_be_ended("setTextureUV")
        corner = self._corner_index("setTextureUV", index)
        texture = self._current_texture()
        try:
            u, v = u + 0.0, v + 0.0
        except TypeError:
            raise wrong_numbers("setTextureUV", (index, u, v), "index, u, v") from None
        if texture is not None and self._texture_mode == c.IMAGE:
            u, v = u / texture.across, v / texture.down
        self._ensure_uvs()
        self._recorder.uv_array()[corner] = u, v
        self._edit(Quality.UV, corner)

    def getFill(self, index: int) -> int:
        """Return the fill colour of a vertex.

        Examples
        --------
        >>> s = createShape(RECT, 10, 10, 50, 50)
        >>> print(hex(s.getFill(0)))
        FFFFFFFF
        """
        return self._color_at("getFill", index, "fill")

    def getTint(self, index: int) -> int:
        """Return the tint of a vertex of a textured shape; without a texture it is 0.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 50).getTint(0))
        0
        """
        return 0 if self._texture_source is None else self._color_at("getTint", index, "fill")

    def getStroke(self, index: int) -> int:
        """Return the outline's colour at a vertex.

        Examples
        --------
        >>> print(hex(createShape(RECT, 10, 10, 50, 50).getStroke(0)))
        FF000000
        """
        return self._color_at("getStroke", index, "stroke")

    def getStrokeWeight(self, index: int) -> float:
        """Return the outline's weight at a vertex, in pixels.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 50).getStrokeWeight(0))
        1.0
        """
        if self._is_primitive:
            return self._weight
        return self._attributes_of(self._corner_index("getStrokeWeight", index)).weight

    def getAmbient(self, index: int) -> int:
        """Return the colour of a vertex in ambient light.

        Examples
        --------
        >>> print(hex(createShape(RECT, 10, 10, 50, 50).getAmbient(0)))
        FFFFFFFF
        """
        ambient = int(self._material_at("getAmbient", index, "ambient"))
        return self.getFill(index) if ambient < 0 else ambient

    def getSpecular(self, index: int) -> int:
        """Return the colour of a vertex's highlights.

        Examples
        --------
        >>> print(hex(createShape(RECT, 10, 10, 50, 50).getSpecular(0)))
        FF7D7D7D
        """
        return int(self._material_at("getSpecular", index, "specular"))

    def getEmissive(self, index: int) -> int:
        """Return the light that a vertex gives by itself.

        Examples
        --------
        >>> print(hex(createShape(RECT, 10, 10, 50, 50).getEmissive(0)))
        FF000000
        """
        return int(self._material_at("getEmissive", index, "emissive"))

    def getShininess(self, index: int) -> float:
        """Return how small the highlights at a vertex are.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 50).getShininess(0))
        1.0
        """
        return self._material_at("getShininess", index, "shininess")
