"""Where the camera is, and how a sketch moves it."""

from __future__ import annotations

from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.libraries.peasycam.parts import DEFAULT_MS, CamParts, numbers
from sketchkit.libraries.peasycam.rotation import X_AXIS, Y_AXIS, Z_AXIS, Rotation, Vector
from sketchkit.libraries.peasycam.state import CameraState

LOOK_AT_USAGE = "x, y, z [, distance] [, animationTimeMillis]"


class Placing(CamParts):
    """Distance, direction, what it looks at; states to come back to."""

    def getDistance(self) -> float:
        """Return how far the camera is from what it looks at.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getDistance())
        200.0
        """
        return self._rig.distance

    def setDistance(self, newDistance: float, animationTimeMillis: float = DEFAULT_MS) -> None:
        """Travel to another distance.

        Parameters
        ----------
        newDistance : float
            From the eye to what it looks at; within the limits that are set.
        animationTimeMillis : float, milliseconds
            How long it takes.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setDistance(400, 1000)
        """
        args = (newDistance, animationTimeMillis)
        self._travel_to_distance(*numbers("setDistance", args, "distance, animationTimeMillis"))

    def setMinimumDistance(self, minimumDistance: float) -> None:
        """Let the camera come no nearer: 1 at first, and never less than 0.01.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setMinimumDistance(50)
        """
        (least,) = numbers("setMinimumDistance", (minimumDistance,), "distance")
        self._rig.limit(least, self._rig.maximum)
        self.feed()

    def setMaximumDistance(self, maximumDistance: float) -> None:
        """Let the camera go no farther.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setMaximumDistance(500)
        """
        (most,) = numbers("setMaximumDistance", (maximumDistance,), "distance")
        self._rig.limit(self._rig.minimum, most)
        self.feed()

    def lookAt(self, x: float, y: float, z: float, *more: float) -> None:
        """Travel so that the camera looks at another point, from the same side.

        Parameters
        ----------
        x, y, z : float
            The point.
        *more : distance, animationTimeMillis
            How far to be from it, and how long it takes (300). If there is one number alone, a
            whole number is the time and any other the distance, as in Java.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.lookAt(10, 0, 0, 150.0, 1000)
        """
        args = (x, y, z, *more)
        if len(more) > 2:
            raise wrong_numbers("lookAt", args, LOOK_AT_USAGE)
        values = numbers("lookAt", args, LOOK_AT_USAGE)
        center: Vector = (values[0], values[1], values[2])
        if len(more) == 2:
            self.setState(CameraState(self._rig.rotation, center, values[3]), values[4])
        elif more and isinstance(more[0], int):
            self.setState(CameraState(self._rig.rotation, center, self._rig.distance), values[3])
        else:
            self._travel_to_center(center, DEFAULT_MS)
            if more:
                self._travel_to_distance(values[3], DEFAULT_MS)

    def getLookAt(self) -> list[float]:
        """Return the point that the camera looks at.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 50, 50, 0, 200).getLookAt())
        [50.0, 50.0, 0.0]
        """
        return list(self._rig.center)

    def getPosition(self) -> list[float]:
        """Return where the eye is.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 50, 50, 0, 200).getPosition())
        [50.0, 50.0, 200.0]
        """
        return list(self._rig.state.eye)

    def getUpVector(self) -> list[float]:
        """Return the direction that runs down the picture, as `camera()` takes it.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getUpVector())
        [0.0, 1.0, 0.0]
        """
        return list(self._rig.state.up)

    def getRotations(self) -> list[float]:
        """Return the angles about x, y and z that turn things towards the camera.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> x, y, z = cam.getRotations()
        >>> rotateX(x)
        >>> rotateY(y)
        >>> rotateZ(z)
        >>> square(0, 0, 30)  # seen from the front, wherever the camera is
        """
        return list(self._rig.rotation.angles())

    def setRotations(self, pitch: float, yaw: float, roll: float) -> None:
        """Put the camera on a side, given by its angles about x, y and z, at once.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setRotations(-0.4, 0.6, 0)
        """
        angles = numbers("setRotations", (pitch, yaw, roll), "pitch, yaw, roll")
        self._travels.pop("rotation", None)
        self._rig.rotation = Rotation.of_angles(*angles)
        self.feed()

    def rotateX(self, angle: float) -> None:
        """Turn the camera about its own x axis, which runs through what it looks at.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.rotateX(-0.4)
        """
        self._turn("rotateX", X_AXIS, angle)

    def rotateY(self, angle: float) -> None:
        """Turn the camera about its own y axis.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.rotateY(0.6)
        """
        self._turn("rotateY", Y_AXIS, angle)

    def rotateZ(self, angle: float) -> None:
        """Turn the camera about its own z axis: the picture turns.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.rotateZ(0.2)
        """
        self._turn("rotateZ", Z_AXIS, angle)

    def _turn(self, caller: str, axis: Vector, angle: float) -> None:
        self._rig.turn(axis, *numbers(caller, (angle,), "angle"))
        self.feed()

    def pan(self, dx: float, dy: float) -> None:
        """Move the camera and what it looks at along the picture.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.pan(20, 0)
        """
        self._rig.pan(*numbers("pan", (dx, dy), "dx, dy"))
        self.feed()

    def reset(self, animationTimeInMillis: float = DEFAULT_MS) -> None:
        """Travel back to where the camera was at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.rotateY(2)
        >>> cam.reset(0)
        """
        self.setState(self._rig.start, animationTimeInMillis)

    def getState(self) -> CameraState:
        """Return where the camera is, to come back to.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> state = PeasyCam(this, 200).getState()
        """
        return self._rig.state

    def setState(self, state: CameraState, animationTimeMillis: float = DEFAULT_MS) -> None:
        """Travel to where the camera was when `getState()` was called.

        Parameters
        ----------
        state : CameraState
            Of this camera, or of another one.
        animationTimeMillis : float, milliseconds
            How long it takes; 0 is at once.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> state = cam.getState()
        >>> cam.rotateY(1)
        >>> cam.setState(state, 500)
        """
        if not isinstance(state, CameraState):
            raise SketchError(
                "setState() takes what getState() has returned.",
                got=f"setState({shown(state)})",
            )
        (duration_ms,) = numbers("setState", (animationTimeMillis,), "animationTimeMillis")
        if duration_ms > 0:
            self._travel_to_rotation(state.rotation, duration_ms)
            self._travel_to_center(state.center, duration_ms)
            self._travel_to_distance(state.distance, duration_ms)
        else:
            self._rig.place(state)
        self.feed()
