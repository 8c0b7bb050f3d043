"""What the mouse does to the camera: which drag turns it, how fast, and about which axes."""

from __future__ import annotations

import math
from enum import Enum

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.sketch import Sketch
from sketchkit.core.constants import CENTER, LEFT, RIGHT
from sketchkit.libraries.peasycam.handlers import (
    DragHandler,
    HasHandleDrag,
    HasHandleWheel,
    WheelHandler,
)
from sketchkit.libraries.peasycam.motions import Glide
from sketchkit.libraries.peasycam.rig import Rig
from sketchkit.libraries.peasycam.rotation import X_AXIS, Y_AXIS, Z_AXIS

ROTATION_STEP = 0.00125  # radians for a pixel, times the root of the distance's logarithm
PAN_PART, ZOOM_PART = 1 / 8, 1 / 10  # of the mouse's way becomes speed


class Constraint(Enum):
    """About which of its axes the camera may be turned by hand."""

    YAW = "its y axis alone"
    PITCH = "its x axis alone"
    ROLL = "its z axis alone"
    SUPPRESS_ROLL = "all but its z axis"


MAY_YAW = (None, Constraint.YAW, Constraint.SUPPRESS_ROLL)
MAY_PITCH = (None, Constraint.PITCH, Constraint.SUPPRESS_ROLL)
MAY_ROLL = (None, Constraint.ROLL)


class Hand:
    """Turns mouse events into pushes.

    Attributes
    ----------
    viewport : list of int
        x, y, width and height of the part of the window in which it is heard.
    constraint, drag_constraint : Constraint or None
        The one that lasts, and the one of the drag that goes on.
    rotation_scale, pan_scale, zoom_scale, wheel_scale : float
        How fast each is.
    """

    def __init__(self, sketch: Sketch, rig: Rig, viewport: list[int]) -> None:
        self._pointer = sketch.pointer
        self._rig = rig
        self.viewport = viewport
        self.constraint: Constraint | None = None
        self.drag_constraint: Constraint | None = None
        self.rotation_scale = self.pan_scale = self.zoom_scale = self.wheel_scale = 1.0
        self.turning = [
            Glide(lambda angle: rig.turn(X_AXIS, angle)),
            Glide(lambda angle: rig.turn(Y_AXIS, angle)),
            Glide(lambda angle: rig.turn(Z_AXIS, angle)),
        ]
        self._zooming = Glide(self._zoom)
        self._panning = [Glide(lambda dx: self._pan(dx, 0)), Glide(lambda dy: self._pan(0, dy))]
        self.rotate_drag = DragHandler(self._push_rotation)
        self.pan_drag = DragHandler(self._push_pan)
        self.zoom_drag = DragHandler(self._push_zoom)
        self.zoom_wheel = WheelHandler(self._push_wheel)
        self.left_drag: HasHandleDrag | None = self.rotate_drag
        self.center_drag: HasHandleDrag | None = self.pan_drag
        self.right_drag: HasHandleDrag | None = self.zoom_drag
        self.wheel: HasHandleWheel | None = self.zoom_wheel
        self._is_dragging = False

    def step(self) -> bool:
        """Glide for one frame; tell whether anything moved."""
        glides = (*self.turning, self._zooming, *self._panning)
        steps = [glide.step() for glide in glides]
        return any(steps)

    def is_over_viewport(self, x: float, y: float) -> bool:
        """Return whether a place lies inside of the viewport."""
        left, top, width, height = self.viewport
        return left < x < left + width and top < y < top + height

    def take_mouse(self, event: MouseEvent) -> bool:
        """Follow the mouse; tell whether this was a double click."""
        is_over = self.is_over_viewport(self._pointer.x, self._pointer.y)
        match event.action:
            case MouseEvent.PRESS:
                self._is_dragging |= is_over
            case MouseEvent.RELEASE:
                self._is_dragging, self.drag_constraint = False, None
            case MouseEvent.CLICK:
                return is_over and event.count == 2
            case MouseEvent.WHEEL if self.wheel and is_over:
                self.wheel.handleWheel(event.count)
            case MouseEvent.DRAG if self._is_dragging:
                self._drag(event)
        return False

    def take_key(self, event: KeyEvent) -> None:
        """End what Shift has begun."""
        if event.action == KeyEvent.RELEASE and event.isShiftDown():
            self.drag_constraint = None

    def _drag(self, event: MouseEvent) -> None:
        pointer = self._pointer
        dx, dy = pointer.x - pointer.previous_x, pointer.y - pointer.previous_y
        if not event.isShiftDown():
            self.drag_constraint = self.constraint
        elif self.drag_constraint is None and abs(dx - dy) > 1:
            self.drag_constraint = Constraint.YAW if abs(dx) > abs(dy) else Constraint.PITCH
        button = pointer.button
        if self.center_drag and (button == CENTER or (button == LEFT and event.isMetaDown())):
            self.center_drag.handleDrag(dx, dy)
        elif self.left_drag and button == LEFT:
            self.left_drag.handleDrag(dx, dy)
        elif self.right_drag and button == RIGHT:
            self.right_drag.handleDrag(dx, dy)

    def _push_rotation(self, dx: float, dy: float) -> None:
        """Turn as if the hand lay on a ball: at the picture's edge it rolls it."""
        root = math.sqrt(math.log10(1 + self._rig.distance))
        step = -root * ROTATION_STEP * self.rotation_scale
        left, top, width, height = self.viewport
        across = _from_middle(self._pointer.x - left, width)
        down = _from_middle(self._pointer.y - top, height)
        pitch, yaw, roll = self.turning
        if self.drag_constraint in MAY_YAW:
            yaw.push(dx * step * (1 - down * down))
        if self.drag_constraint in MAY_PITCH:
            pitch.push(-dy * step * (1 - across * across))
        if self.drag_constraint in MAY_ROLL:
            roll.push(dy * step * across - dx * step * down)

    def _push_pan(self, dx: float, dy: float) -> None:
        for glide, way in zip(self._panning, (dx, dy), strict=True):
            glide.push(way * PAN_PART * self.pan_scale)

    def _push_zoom(self, dx: float, dy: float) -> None:
        self._zooming.push(dy * ZOOM_PART * self.zoom_scale)

    def _push_wheel(self, delta: int) -> None:
        self._zooming.push(delta * self.wheel_scale)

    def _zoom(self, speed: float) -> None:
        if not self._rig.zoom(speed):
            self._zooming.stop()

    def _pan(self, dx: float, dy: float) -> None:
        held = self.drag_constraint
        self._rig.pan_by_mouse(
            0 if held is Constraint.PITCH else dx, 0 if held is Constraint.YAW else dy
        )


def _from_middle(place: float, length: float) -> float:
    """Return where a place lies, -1..1 from edge to edge."""
    return min(max(place / length, 0.0), 1.0) * 2 - 1 if length else 0.0
