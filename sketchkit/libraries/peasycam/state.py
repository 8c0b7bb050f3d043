"""Where a PeasyCam stands: what it looks at, from how far, from which side."""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.api.graphics import PGraphics
from sketchkit.api.sketch import Sketch
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.float32 import f32
from sketchkit.libraries.peasycam.rotation import Y_AXIS, Z_AXIS, Rotation, Vector


@dataclass(frozen=True)
class CameraState:
    """A camera's place, to go back to: `cam.getState()` gives it, `cam.setState()` takes it.

    Attributes
    ----------
    rotation : Rotation
        Turns the z axis towards the eye.
    center : (x, y, z)
        What it looks at.
    distance : float
        From there to the eye.

    Examples
    --------
    >>> size(100, 100, P3D)
    >>> cam = PeasyCam(this, 200)
    >>> state = cam.getState()
    >>> cam.rotateY(1)
    >>> cam.setState(state, 0)
    """

    rotation: Rotation
    center: Vector
    distance: float

    @property
    def eye(self) -> Vector:
        """Where the eye is."""
        x, y, z = self.rotation.turn(Z_AXIS)
        center, distance = self.center, self.distance
        return center[0] + x * distance, center[1] + y * distance, center[2] + z * distance

    @property
    def up(self) -> Vector:
        """The direction that runs down the picture; `camera()` calls it up."""
        return self.rotation.turn(Y_AXIS)

    def apply(self, target: Sketch | PGraphics) -> None:
        """Set the camera of the sketch (`this`), or of a canvas of `createGraphics()`.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> cam = PeasyCam(this, 200)
        >>> pg = createGraphics(100, 100, P3D)
        >>> cam.getState().apply(pg)
        """
        canvas = target.canvas if isinstance(target, Sketch) else target
        if not isinstance(canvas, PGraphics):
            raise SketchError(
                "apply() takes the sketch, or a canvas of createGraphics().",
                got=f"apply({shown(target)})",
                hint="Write state.apply(this).",
            )
        if canvas.is_3d:  # a flat canvas has no camera to set: it may only show another one
            canvas.camera(*(f32(value) for value in (*self.eye, *self.center, *self.up)))
