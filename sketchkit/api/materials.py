"""Materials: how surfaces answer light."""

from __future__ import annotations

from sketchkit.api.color import ColorLike
from sketchkit.api.paint import Paint
from sketchkit.core import constants as c
from sketchkit.core.color import COMPONENTS

AMBIENT_USAGE = SPECULAR_USAGE = EMISSIVE_USAGE = f"gray | {COMPONENTS[c.RGB]}"


class Materials(Paint):
    """What a surface makes of ambient light, of highlights, and by itself."""

    def ambient(self, v1: ColorLike, v2: float | None = None, v3: float | None = None) -> None:
        """Set the colour that a surface shows in ambient light; until then it is the fill colour.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> ambientLight(255, 255, 255)
        >>> ambient(50, 100, 200)
        >>> translate(50, 50)
        >>> box(40)
        """
        self._material(ambient=self._mix("ambient", v1, v2, v3))

    def specular(self, v1: ColorLike, v2: float | None = None, v3: float | None = None) -> None:
        """Set the colour of a surface's highlights; it needs `lightSpecular()` to show.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> specular(255)
        """
        self._material(specular=self._mix("specular", v1, v2, v3))

    def emissive(self, v1: ColorLike, v2: float | None = None, v3: float | None = None) -> None:
        """Set the light that a surface gives by itself; it shows only while there are lights.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lights()
        >>> emissive(0, 80, 0)
        >>> translate(50, 50)
        >>> box(40)
        """
        self._material(emissive=self._mix("emissive", v1, v2, v3))

    def shininess(self, shine: float) -> None:
        """Set how small highlights are; at first 1.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> shininess(20)
        """
        try:
            self._material(shininess=shine + 0.0)
        except TypeError:
            self._refuse("shininess", (shine,), "shine")
