"""Attributes for shaders, changed at a finished shape's vertices."""

from __future__ import annotations

from sketchkit.api.attribs import MOST_NUMBERS
from sketchkit.api.color import ColorLike
from sketchkit.api.pshape.corners import ShapeCorners
from sketchkit.core.color import unit_rgba
from sketchkit.core.errors import SketchError, nearest, wrong_numbers
from sketchkit.draw.recorder import Custom, CustomKind


class ShapeAttribs(ShapeCorners):
    """Setting what `attrib()` and its like gave."""

    def setAttrib(self, name: str, index: int, *values: float) -> None:
        """Set the numbers of an attribute at one vertex.

        Parameters
        ----------
        name : str
            As it was given to `attrib()`.
        index : int
            The vertex.
        *values : 1 to 4 float, int or bool

        Raises
        ------
        SketchError
            If the shape has no such attribute or vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.attrib("heat", 0.2)
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setAttrib("heat", 1, 0.9)
        >>> shape(s)
        """
        if not 1 <= len(values) <= MOST_NUMBERS:
            raise wrong_numbers("setAttrib", (name, index, *values), "name, index, a [, b, c, d]")
        self._set_custom("setAttrib", name, index, CustomKind.PLAIN, values)

    def setAttribPosition(self, name: str, index: int, x: float, y: float, z: float) -> None:
        """Set the place that `attribPosition()` gave to one vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.attribPosition("tip", 50, 15, 0)
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setAttribPosition("tip", 1, 50, 5, 0)
        """
        self._set_custom("setAttribPosition", name, index, CustomKind.PLACE, (x, y, z))

    def setAttribNormal(self, name: str, index: int, nx: float, ny: float, nz: float) -> None:
        """Set the direction that `attribNormal()` gave to one vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.attribNormal("tangent", 1, 0, 0)
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setAttribNormal("tangent", 1, 0, 1, 0)
        """
        self._set_custom("setAttribNormal", name, index, CustomKind.DIRECTION, (nx, ny, nz))

    def setAttribColor(self, name: str, index: int, color: ColorLike) -> None:
        """Set the colour that `attribColor()` gave to one vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape(TRIANGLES)
        >>> s.attribColor("glow", color(255, 0, 0))
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape()
        >>> s.setAttribColor("glow", 1, color(0, 0, 255))
        """
        values = unit_rgba("setAttribColor", color)
        self._set_custom("setAttribColor", name, index, CustomKind.PLAIN, values)

    def _set_custom(
        self, caller: str, name: str, index: int, kind: CustomKind, values: tuple[float, ...]
    ) -> None:
        self._must_be_ended(caller)
        corner = self._corner_index(caller, index)
        custom = self._attributes_of(corner).custom
        if name not in custom:
            known = nearest(name, custom)
            hint = f"Do you mean {known!r}?" if known else "attrib() gives it, before vertex()."
            raise SketchError(f"The vertex has no attribute {name!r}.", hint=hint)
        try:
            numbers = tuple(value + 0.0 for value in values)
        except TypeError:
            raise wrong_numbers(caller, (name, index, *values), "name, index, numbers") from None
        self._set_attribute(corner, custom={**custom, name: Custom(kind, numbers)})
        self._expand_anew()
