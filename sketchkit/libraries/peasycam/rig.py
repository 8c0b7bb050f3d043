"""The camera itself: it stands on a sphere around what it looks at."""

from __future__ import annotations

import math

from sketchkit.libraries.peasycam.rotation import Rotation, Vector
from sketchkit.libraries.peasycam.state import CameraState

SMALLEST_DISTANCE = 0.01
ZOOM_STEP = 0.02  # of the distance, for a speed of 1
PAN_STEP = 0.0025  # of the distance, for a speed of 1


class Rig:
    """Where the camera is now, and between which distances it may be.

    Parameters
    ----------
    center : (x, y, z)
        What it looks at.
    distance : float
        How far it is away; at least `SMALLEST_DISTANCE`.
    """

    def __init__(self, center: Vector, distance: float) -> None:
        self.start = CameraState(Rotation(), center, max(distance, SMALLEST_DISTANCE))
        self.minimum, self.maximum = 1.0, math.inf
        self.place(self.start)

    @property
    def state(self) -> CameraState:
        """Where it is."""
        return CameraState(self.rotation, self.center, self.distance)

    def place(self, state: CameraState) -> None:
        """Put it somewhere."""
        self.rotation, self.center, self.distance = state.rotation, state.center, state.distance

    def turn(self, axis: Vector, angle_rad: float) -> None:
        """Turn it about one of its own axes through what it looks at."""
        self.rotation = self.rotation.after(Rotation.about(axis, angle_rad))

    def pan(self, dx: float, dy: float) -> None:
        """Move it, and what it looks at, along the picture."""
        moved = self.rotation.turn((dx, dy, 0.0))
        x, y, z = (old + change for old, change in zip(self.center, moved, strict=True))
        self.center = x, y, z

    def zoom(self, speed: float) -> bool:
        """Go nearer or farther by a part of the distance; tell whether it was free to."""
        wanted = self.distance * (1 + speed * ZOOM_STEP)
        self.distance = self.within_limits(wanted)
        return self.distance == wanted

    def pan_by_mouse(self, dx: float, dy: float) -> None:
        """Move it with the hand: the farther away, the more."""
        self.pan(-dx * self.distance * PAN_STEP, -dy * self.distance * PAN_STEP)

    def limit(self, minimum: float, maximum: float) -> None:
        """Let it go no nearer and no farther."""
        self.minimum, self.maximum = max(minimum, SMALLEST_DISTANCE), maximum
        self.distance = self.within_limits(self.distance)

    def within_limits(self, distance: float) -> float:
        """Return the nearest distance that is allowed."""
        return min(self.maximum, max(self.minimum, distance))
