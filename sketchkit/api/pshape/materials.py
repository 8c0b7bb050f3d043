"""How the surface of a finished shape answers light."""

from __future__ import annotations

from dataclasses import replace

from sketchkit.api.color import ColorLike
from sketchkit.api.pshape.corners import ShapeCorners
from sketchkit.core.color import to_packed
from sketchkit.core.errors import wrong_numbers
from sketchkit.core.notices import warn_once


class ShapeMaterials(ShapeCorners):
    """Setting materials after `endShape()`, of a whole tree or of one vertex."""

    def setAmbient(self, *change: ColorLike) -> None:
        """Set the colour that the shape, or one vertex, shows in ambient light.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> ambientLight(255, 255, 255)
        >>> s = createShape(BOX, 40)
        >>> s.setAmbient(color(50, 100, 200))
        >>> shape(s, 50, 50)
        """
        self._set_material("setAmbient", "ambient", change)

    def setSpecular(self, *change: ColorLike) -> None:
        """Set the colour of the highlights of the shape, or of one vertex.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> s = createShape(SPHERE, 40)
        >>> s.setSpecular(color(255))
        """
        self._set_material("setSpecular", "specular", change)

    def setEmissive(self, *change: ColorLike) -> None:
        """Set the light that the shape, or one vertex, gives by itself.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lights()
        >>> s = createShape(BOX, 40)
        >>> s.setEmissive(color(0, 80, 0))
        >>> shape(s, 50, 50)
        """
        self._set_material("setEmissive", "emissive", change)

    def setShininess(self, *change: float) -> None:
        """Set how small the highlights of the shape, or of one vertex, are.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> s = createShape(SPHERE, 40)
        >>> s.setShininess(20)
        """
        self._must_be_ended("setShininess")
        if len(change) not in (1, 2):
            raise wrong_numbers("setShininess", change, "shine | index, shine")
        self._change_material("setShininess", "shininess", change, float(change[-1]))

    def _set_material(self, caller: str, part: str, change: tuple[ColorLike, ...]) -> None:
        self._must_be_ended(caller)
        if len(change) not in (1, 2):
            raise wrong_numbers(caller, change, "color | index, color")
        self._change_material(caller, part, change, packed_color(caller, change[-1]))

    def _change_material(
        self, caller: str, part: str, change: tuple[ColorLike, ...], value: float
    ) -> None:
        if len(change) == 2:
            corner = self._corner_index(caller, change[0])  # type: ignore[arg-type] # it checks
            material = replace(self._attributes_of(corner).material, **{part: value})  # type: ignore[arg-type] # a part and its value
            self._set_attribute(corner, material=material)
            self._expand_anew()
            return
        for leaf in self._leaves():
            leaf._restyle_rows(material=replace(leaf._style.material, **{part: value}))  # type: ignore[arg-type] # ditto

    def _restyle_rows(self, **changes: object) -> None:
        """Change parts of the style of all that is recorded."""
        style = replace(self._style, **changes)  # type: ignore[arg-type] # the callers know
        if all(getattr(self._style, name) == value for name, value in changes.items()):
            return
        self._style = style
        self._recorder.styles[:] = [style] * len(self._recorder.styles)
        if "material" in changes:
            self._all_attributes(material=style.material)
        self._expand_anew()


def packed_color(caller: str, value: ColorLike) -> int:
    """Return a colour that a shape is given: packed, or a string."""
    packed = to_packed(value, caller)
    if 0 < packed <= 255:  # an alpha of 0: it is meant as a gray
        warn_once(f"{caller}({packed}) cannot be seen: write {caller}(color({packed})).")
    return packed
