"""Attributes that a sketch gives to vertices, for a shader of its own."""

from __future__ import annotations

from sketchkit.api._pen import Pen
from sketchkit.api.color import ColorLike
from sketchkit.core.color import unit_rgba
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.draw.recorder import Custom, CustomKind

MOST_NUMBERS = 4


class Attribs(Pen):
    """They hold for the vertices that follow, up to the end of the shape."""

    def attrib(self, name: str, *values: float) -> None:
        """Give the vertices that follow a number, or up to four, for a shader.

        Parameters
        ----------
        name : str
            Of the attribute in the shader.
        *values : 1 to 4 float, int or bool

        Raises
        ------
        SketchError
            If there are not 1 to 4 numbers, or no shape is open.

        See Also
        --------
        attribPosition, attribNormal, attribColor, shader

        Notes
        -----
        Source: the course guide's section 6.6; Processing's PShape.attrib().

        Examples
        --------
        >>> beginShape(TRIANGLES)
        >>> attrib("heat", 0.2)
        >>> vertex(20, 80)
        >>> attrib("heat", 0.9)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        if not 1 <= len(values) <= MOST_NUMBERS:
            raise wrong_numbers("attrib", (name, *values), "name, a [, b] [, c] [, d]")
        self._give("attrib", name, CustomKind.PLAIN, values)

    def attribPosition(self, name: str, x: float, y: float, z: float) -> None:
        """Give the vertices that follow another place; it is transformed as vertices are.

        Examples
        --------
        >>> beginShape(TRIANGLES)
        >>> attribPosition("tip", 50, 15, 0)
        >>> vertex(20, 80)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        self._give("attribPosition", name, CustomKind.PLACE, (x, y, z))

    def attribNormal(self, name: str, nx: float, ny: float, nz: float) -> None:
        """Give the vertices that follow another direction; it is transformed as normals are.

        Examples
        --------
        >>> beginShape(TRIANGLES)
        >>> attribNormal("tangent", 1, 0, 0)
        >>> vertex(20, 80)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        self._give("attribNormal", name, CustomKind.DIRECTION, (nx, ny, nz))

    def attribColor(self, name: str, color: ColorLike) -> None:
        """Give the vertices that follow another colour: in the shader a vec4, 0 to 1 each.

        Examples
        --------
        >>> beginShape(TRIANGLES)
        >>> attribColor("glow", color(255, 0, 0))
        >>> vertex(20, 80)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        parts = unit_rgba("attribColor", color)
        self._give("attribColor", name, CustomKind.PLAIN, parts)

    def _give(self, caller: str, name: str, kind: CustomKind, values: tuple[float, ...]) -> None:
        if not isinstance(name, str):
            raise SketchError(f"{caller}() takes the attribute's name first.", got=shown(name))
        if self._shape is None:
            raise SketchError(
                f"{caller}() belongs between beginShape() and endShape().",
                hint="Write beginShape() before it.",
            )
        try:
            numbers = tuple(value + 0.0 for value in values)
        except TypeError:
            raise wrong_numbers(caller, (name, *values), "name, numbers") from None
        self._custom = {**self._custom, name: Custom(kind, numbers)}
        self._attributes = -1
