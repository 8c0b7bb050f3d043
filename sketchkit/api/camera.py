"""Camera and projection; and where a point lies on the screen."""

from __future__ import annotations

import math

from sketchkit.api._parts import Block, CanvasParts
from sketchkit.api.pmatrix import PMatrix3D
from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.float32 import f32
from sketchkit.core.notices import warn_once

FIELD_OF_VIEW = f32(60 * f32(f32(math.pi) / 180))  # radians, as Processing rounds it
PERSPECTIVE_USAGE = "fov, aspect, near, far"
ORTHO_USAGE = "left, right, bottom, top [, near, far]"
FRUSTUM_USAGE = "left, right, bottom, top, near, far"
PLACE_USAGE = "x, y [, z]"
NEAR_AND_FAR = "a near above 0 and a far beyond it"
SIDES_THAT_DIFFER = "sides that differ: left and right, bottom and top, near and far"
FAR = 10.0  # the default camera's clipping planes: its eye's distance times, and by, this


class Camera(CanvasParts):
    """Camera and projection stay from frame to frame, until they are set again."""

    def camera(self, *numbers: float) -> None:
        """Place the camera; without numbers, back to its default place.

        Parameters
        ----------
        *numbers : 9 float
            Eye, the point it looks at, and the direction that runs down the picture: x, y, z each.

        Raises
        ------
        SketchError
            If there are neither 0 nor 9 numbers.

        See Also
        --------
        perspective, ortho, beginCamera

        Notes
        -----
        At first the eye stands before the middle of the canvas, so far away that z = 0 is shown
        in its own size. The camera stays in force from frame to frame. Source: Processing's
        reference, camera(); the course guide's chapter on cameras.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> camera(70, -60, 120, 0, 0, 0, 0, 1, 0)
        >>> box(40)
        """
        if not numbers:
            self._place_camera(self._default_camera())
            return
        try:
            ex, ey, ez, cx, cy, cz, ux, uy, uz = (value + 0.0 for value in numbers)
        except (TypeError, ValueError):
            usage = "eyeX, eyeY, eyeZ, centerX, centerY, centerZ, upX, upY, upZ"
            self._refuse("camera", numbers, usage)
        # An eye at its own centre sees nothing, as in Processing; ortho() still needs a distance.
        self._eye_distance = math.dist((ex, ey, ez), (cx, cy, cz)) or self._eye_distance
        self._place_camera(mat.look_at((ex, ey, ez), (cx, cy, cz), (ux, uy, uz)))

    def _default_eye(self) -> float:
        """Return how far the default eye is from the canvas."""
        return mat.eye_distance(self._target.down, FIELD_OF_VIEW)

    def _default_camera(self) -> mat.Affine:
        """Return the modelview with which a frame begins."""
        if not self._stage.is_3d:
            return mat.IDENTITY
        x, y = self._target.across / 2, self._target.down / 2
        self._eye_distance = self._default_eye()
        return mat.look_at((x, y, self._eye_distance), (x, y, 0.0), (0.0, 1.0, 0.0))

    def _place_camera(self, modelview: mat.Affine) -> None:
        self._camera = self._modelview = modelview
        self._state = -1

    def beginCamera(self) -> Block:
        """Begin to move the camera by transforms: `translate()` and its like move it, not shapes.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> with beginCamera():
        ...     camera()
        ...     rotateX(-PI / 7)
        >>> translate(50, 50)
        >>> box(40)
        """
        return Block(self.endCamera)

    def endCamera(self) -> None:
        """End moving the camera.

        Examples
        --------
        See `beginCamera()`.
        """
        self._camera = self._modelview

    def perspective(self, *numbers: float) -> None:
        """Set a projection in which what is far is small; without numbers, the default one.

        Parameters
        ----------
        *numbers : 4 float
            Angle of view from top to bottom (radians), width of the picture by its height, and
            the distances of the near and the far clipping plane.

        Raises
        ------
        SketchError
            If there are neither 0 nor 4 numbers.

        Notes
        -----
        It stays in force from frame to frame. Source: Processing's reference, perspective().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> perspective(PI / 2, 1, 5, 2000)
        >>> translate(50, 50)
        >>> box(40)
        """
        if not numbers:
            eye = self._default_eye()
            aspect = self._target.across / self._target.down
            numbers = (FIELD_OF_VIEW, aspect, eye / FAR, eye * FAR)
        try:
            fov, aspect, near, far = (value + 0.0 for value in numbers)
            projection = mat.perspective(fov, aspect, near, far)
        except (TypeError, ValueError):
            self._refuse("perspective", numbers, PERSPECTIVE_USAGE)
        except ZeroDivisionError:
            raise _without_room("perspective", NEAR_AND_FAR, numbers) from None
        if projection is mat.SEES_NOTHING:  # as in many a sketch before the mouse has moved
            warn_once("perspective() shows nothing through an angle or a width of 0.")
        self._project("perspective", projection, is_perspective=True)

    def ortho(self, *numbers: float) -> None:
        """Set a projection without perspective; without numbers, in the size of the canvas.

        Parameters
        ----------
        *numbers : 4 or 6 float
            Left, right, bottom, top; near and far. Around the axis of the camera.

        Raises
        ------
        SketchError
            If there are not 0, 4 or 6 numbers.

        Notes
        -----
        It stays in force from frame to frame. Source: Processing's reference, ortho().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> ortho()
        >>> translate(50, 50)
        >>> rotateX(-PI / 6)
        >>> rotateY(PI / 4)
        >>> box(40)
        """
        if not numbers:
            x, y = self._target.across / 2, self._target.down / 2
            numbers = (-x, x, -y, y)
        if len(numbers) == 4:
            numbers = (*numbers, 0.0, self._eye_distance * FAR)
        try:
            left, right, bottom, top, near, far = (value + 0.0 for value in numbers)
        except (TypeError, ValueError):
            self._refuse("ortho", numbers, ORTHO_USAGE)
        try:
            projection = mat.ortho(left, right, bottom, top, near, far)
        except ZeroDivisionError:
            raise _without_room("ortho", SIDES_THAT_DIFFER, numbers) from None
        self._project("ortho", projection, is_perspective=False)

    def frustum(
        self, left: float, right: float, bottom: float, top: float, near: float, far: float
    ) -> None:
        """Set a perspective by the window in the near plane that it sees through.

        Parameters
        ----------
        left, right, bottom, top : float
            The window, from the camera's axis.
        near, far : float
            Distances of the clipping planes; near > 0.

        Notes
        -----
        It stays in force from frame to frame. Source: Processing's reference, frustum().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> frustum(-10, 10, -10, 10, 20, 900)
        >>> translate(50, 50)
        >>> box(40)
        """
        args = (left, right, bottom, top, near, far)
        try:
            projection = mat.frustum(*args)
        except TypeError:
            self._refuse("frustum", args, FRUSTUM_USAGE)
        except ZeroDivisionError:
            raise _without_room("frustum", SIDES_THAT_DIFFER, args) from None
        self._project("frustum", projection, is_perspective=True)

    def _project(self, name: str, projection: mat.Mat4, *, is_perspective: bool) -> None:
        if not self._stage.is_3d:
            warn_once(f"{name}() works only in P3D: write size(width, height, P3D).")
            return
        self._restage(projection=projection, is_perspective=is_perspective)

    def _flat_projection(self) -> mat.Mat4:
        """Return the projection of a flat canvas: a pixel is a pixel."""
        return mat.ortho(0.0, self._target.across, -self._target.down, 0.0, -1.0, 1.0)

    def printCamera(self) -> None:
        """Print the camera's matrix.

        Examples
        --------
        >>> printCamera()  # doctest: +SKIP
        """
        PMatrix3D(*mat.to_mat4(self._camera)).print()

    def printProjection(self) -> None:
        """Print the projection's matrix.

        Examples
        --------
        >>> printProjection()  # doctest: +SKIP
        """
        PMatrix3D(*self._stage.projection).print()

    def screenX(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the x on the canvas at which a point is drawn.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50, -100)
        >>> print(screenX(0, 0, 0))
        50.0
        """
        return self._screen("screenX", x, y, z)[0]

    def screenY(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the y on the canvas at which a point is drawn.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50, -100)
        >>> print(screenY(0, 0, 0))
        50.0
        """
        return self._screen("screenY", x, y, z)[1]

    def screenZ(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the depth at which a point is drawn: 0 at the near plane, 1 at the far one.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(round(screenZ(50, 50, 0), 3))
        0.909
        """
        return self._screen("screenZ", x, y, z)[2]

    def _screen(self, name: str, x: float, y: float, z: float) -> tuple[float, float, float]:
        try:
            eye = mat.transform_point(self._modelview, x, y, z)
        except TypeError:
            self._refuse(name, (x, y, z), PLACE_USAGE)
        cx, cy, cz, cw = mat.transform4(self._stage.projection, *eye)
        cw = cw or 1.0
        width, height = self._target.across, self._target.down
        return width * (1 + cx / cw) / 2, height * (1 - cy / cw) / 2, (1 + cz / cw) / 2

    def modelX(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the x of a point without the camera: where the transforms have put it.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 20)
        >>> print(round(modelX(0, 0, 0)))
        50
        """
        return self._model("modelX", x, y, z)[0]

    def modelY(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the y of a point without the camera.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 20)
        >>> print(round(modelY(0, 0, 0)))
        20
        """
        return self._model("modelY", x, y, z)[1]

    def modelZ(self, x: float, y: float, z: float = 0.0) -> float:
        """Return the z of a point without the camera.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(0, 0, -40)
        >>> print(round(modelZ(0, 0, 0)))
        -40
        """
        return self._model("modelZ", x, y, z)[2]

    def _model(self, name: str, x: float, y: float, z: float) -> tuple[float, float, float]:
        try:
            eye = mat.transform_point(self._modelview, x, y, z)
        except TypeError:
            self._refuse(name, (x, y, z), PLACE_USAGE)
        camera = mat.inverse(self._camera)
        return eye if camera is None else mat.transform_point(camera, *eye)


def _without_room(name: str, needs: str, numbers: tuple[float, ...]) -> SketchError:
    """Return the error for a projection that sees a space without width, height or depth."""
    return SketchError(f"{name}() needs {needs}.", got=f"{name}({', '.join(map(shown, numbers))})")
