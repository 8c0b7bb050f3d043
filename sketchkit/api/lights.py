"""Lights. Lighting is worked out at vertices, as in Processing."""

from __future__ import annotations

import math
from typing import NoReturn

from sketchkit.api.style import Styling
from sketchkit.core import constants as c
from sketchkit.core import matrix as mat
from sketchkit.core.color import COMPONENTS, hsb_to_rgb, in_model
from sketchkit.core.errors import SketchError
from sketchkit.core.lights import MOST_LIGHTS, Light, LightKind, Vector3

NONE: Vector3 = (0.0, 0.0, 0.0)
HALF: Vector3 = (0.5, 0.5, 0.5)
STEADY: Vector3 = (1.0, 0.0, 0.0)  # the falloff of a light that does not grow weaker
LIGHTSPECULAR_USAGE = COMPONENTS[c.RGB]
AMBIENTLIGHT_USAGE = f"{LIGHTSPECULAR_USAGE} [, x, y, z]"
POINTLIGHT_USAGE = f"{LIGHTSPECULAR_USAGE}, x, y, z"
DIRECTIONALLIGHT_USAGE = f"{LIGHTSPECULAR_USAGE}, nx, ny, nz"
SPOTLIGHT_USAGE = f"{POINTLIGHT_USAGE}, nx, ny, nz, angle, concentration"


class Lights(Styling):
    """Lights last for one frame; a light is placed by the matrix in force when it is made."""

    def lights(self) -> None:
        """Set the usual lights: half ambient, half from behind the viewer.

        See Also
        --------
        ambientLight, directionalLight, pointLight, spotLight, noLights

        Notes
        -----
        Lights set before are dropped. Source: Processing's reference, lights(); the course guide's
        chapter on lights.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lights()
        >>> translate(50, 50)
        >>> rotateY(0.6)
        >>> box(40)
        """
        self._light_falloff, self._light_specular = STEADY, NONE
        self._restage(lights=())
        self._add_light(LightKind.AMBIENT, ambient=HALF, position=NONE)
        self._add_light(LightKind.DIRECTIONAL, diffuse=HALF, direction=(0.0, 0.0, -1.0))

    def noLights(self) -> None:
        """Drop all lights: shapes show their colours as they are.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lights()
        >>> noLights()
        >>> translate(50, 50)
        >>> box(40)
        """
        self._restage(lights=None)

    def ambientLight(
        self, v1: float, v2: float, v3: float, x: float = 0.0, y: float = 0.0, z: float = 0.0
    ) -> None:
        """Add light from everywhere.

        Parameters
        ----------
        v1, v2, v3 : float
            Its colour, in the current `colorMode()`.
        x, y, z : float, optional
            Where `lightFalloff()` counts from.

        Raises
        ------
        SketchError
            For a ninth light.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> ambientLight(120, 40, 200)
        >>> translate(50, 50)
        >>> box(40)
        """
        try:
            color, position = self._light_color(v1, v2, v3), (x + 0.0, y + 0.0, z + 0.0)
        except TypeError:
            self._refuse_light("ambientLight", (v1, v2, v3, x, y, z), AMBIENTLIGHT_USAGE)
        self._add_light(LightKind.AMBIENT, ambient=color, position=position)

    def directionalLight(
        self, v1: float, v2: float, v3: float, nx: float, ny: float, nz: float
    ) -> None:
        """Add light that comes from one direction, as from the sun.

        Parameters
        ----------
        v1, v2, v3 : float
            Its colour, in the current `colorMode()`.
        nx, ny, nz : float
            Where it goes; of any length.

        Raises
        ------
        SketchError
            For a ninth light.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> noStroke()
        >>> directionalLight(255, 80, 60, 1, 0, -1)
        >>> translate(50, 50)
        >>> sphere(40)
        """
        try:
            color, direction = self._light_color(v1, v2, v3), (nx + 0.0, ny + 0.0, nz + 0.0)
        except TypeError:
            args = (v1, v2, v3, nx, ny, nz)
            self._refuse_light("directionalLight", args, DIRECTIONALLIGHT_USAGE)
        self._add_light(LightKind.DIRECTIONAL, diffuse=color, direction=direction)

    def pointLight(self, v1: float, v2: float, v3: float, x: float, y: float, z: float) -> None:
        """Add light from a place, as from a lamp.

        Parameters
        ----------
        v1, v2, v3 : float
            Its colour, in the current `colorMode()`.
        x, y, z : float, pixels

        Raises
        ------
        SketchError
            For a ninth light.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> noStroke()
        >>> pointLight(255, 220, 180, 20, 20, 90)
        >>> translate(50, 50)
        >>> sphere(40)
        """
        try:
            color, position = self._light_color(v1, v2, v3), (x + 0.0, y + 0.0, z + 0.0)
        except TypeError:
            self._refuse_light("pointLight", (v1, v2, v3, x, y, z), POINTLIGHT_USAGE)
        self._add_light(LightKind.POINT, diffuse=color, position=position)

    def spotLight(
        self,
        v1: float,
        v2: float,
        v3: float,
        x: float,
        y: float,
        z: float,
        nx: float,
        ny: float,
        nz: float,
        angle: float,
        concentration: float,
    ) -> None:
        """Add light from a place that shines in a cone.

        Parameters
        ----------
        v1, v2, v3 : float
            Its colour, in the current `colorMode()`.
        x, y, z : float, pixels
        nx, ny, nz : float
            Where it shines to; of any length.
        angle : float, radians
            Between the axis and the side of the cone.
        concentration : float
            The exponent of the cosine with which it grows weaker away from the axis; 0 is no cone.

        Raises
        ------
        SketchError
            For a ninth light.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> noStroke()
        >>> spotLight(255, 255, 200, 50, 20, 100, 0, 0.3, -1, PI / 3, 2)
        >>> translate(50, 50)
        >>> sphere(40)
        """
        try:
            color = self._light_color(v1, v2, v3)
            position, direction = (x + 0.0, y + 0.0, z + 0.0), (nx + 0.0, ny + 0.0, nz + 0.0)
            cone = (max(0.0, math.cos(angle)), concentration + 0.0)
        except (TypeError, ValueError):  # ValueError: of an infinite angle
            args = (v1, v2, v3, x, y, z, nx, ny, nz, angle, concentration)
            self._refuse_light("spotLight", args, SPOTLIGHT_USAGE)
        self._add_light(
            LightKind.SPOT, diffuse=color, position=position, direction=direction, cone=cone
        )

    def lightFalloff(self, constant: float, linear: float, quadratic: float) -> None:
        """Set how lights made after it grow weaker with distance d.

        Parameters
        ----------
        constant, linear, quadratic : float
            The light is divided by constant + linear * d + quadratic * d * d. At first 1, 0, 0.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lightFalloff(1, 0.01, 0)
        >>> pointLight(255, 255, 255, 20, 20, 60)
        >>> translate(50, 50)
        >>> box(40)
        """
        try:
            self._light_falloff = (constant + 0.0, linear + 0.0, quadratic + 0.0)
        except TypeError:
            self._refuse(
                "lightFalloff", (constant, linear, quadratic), "constant, linear, quadratic"
            )

    def lightSpecular(self, v1: float, v2: float, v3: float) -> None:
        """Set the colour of the highlights that lights made after it give; at first black.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> noStroke()
        >>> lightSpecular(255, 255, 255)
        >>> directionalLight(150, 150, 150, 0, 0, -1)
        >>> shininess(10)
        >>> translate(50, 50)
        >>> sphere(40)
        """
        try:
            self._light_specular = self._light_color(v1, v2, v3)
        except TypeError:
            self._refuse_light("lightSpecular", (v1, v2, v3), LIGHTSPECULAR_USAGE)

    def _light_color(self, v1: float, v2: float, v3: float) -> Vector3:
        """Return a light's colour, 0..1 each: it is not rounded to bytes, as other colours are."""
        mode = self._color_mode
        parts = (v1 / mode.max1, v2 / mode.max2, v3 / mode.max3)
        r, g, b = (min(max(part, 0.0), 1.0) for part in parts)
        return hsb_to_rgb(r, g, b) if mode.model == c.HSB else (r, g, b)

    def _refuse_light(self, name: str, args: tuple[object, ...], usage: str) -> NoReturn:
        self._refuse(name, args, in_model(self._color_mode.model, usage))

    def _add_light(
        self,
        kind: LightKind,
        *,
        ambient: Vector3 = NONE,
        diffuse: Vector3 = NONE,
        position: Vector3 = NONE,
        direction: Vector3 = NONE,
        cone: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Add a light, brought into eye space by the current matrix."""
        rig = self._stage.lights or ()
        if len(rig) == MOST_LIGHTS:
            raise SketchError(
                f"There can be {MOST_LIGHTS} lights; this would be one more.",
                hint="lights() and ambientLight() count too. noLights() drops them all.",
            )
        lit = kind is not LightKind.AMBIENT
        light = Light(
            kind=kind,
            position=mat.transform_point(self._modelview, *position),
            direction=_eye_direction(self._modelview, direction),
            ambient=ambient,
            diffuse=diffuse,
            specular=self._light_specular if lit else NONE,
            falloff=STEADY if kind is LightKind.DIRECTIONAL else self._light_falloff,
            spot_cosine=cone[0],
            concentration=cone[1],
        )
        self._restage(lights=(*rig, light))


def _eye_direction(modelview: mat.Affine, direction: Vector3) -> Vector3:
    """Return a direction in eye space, of length 1; like a normal, by the inverse's transpose."""
    inverse = mat.inverse(modelview)
    if inverse is None:
        return NONE
    x, y, z = direction
    turned = [x * inverse[i] + y * inverse[4 + i] + z * inverse[8 + i] for i in range(3)]
    length = math.hypot(*turned)
    if not length:
        return NONE
    return turned[0] / length, turned[1] / length, turned[2] / length
