"""How the mouse moves the camera: what a sketch may change of it."""

from __future__ import annotations

from sketchkit.libraries.peasycam.hand import Constraint
from sketchkit.libraries.peasycam.handlers import (
    Drag,
    HasHandleWheel,
    PeasyDragHandler,
    PeasyWheelHandler,
    Wheel,
    drag_handler,
    wheel_handler,
)
from sketchkit.libraries.peasycam.parts import CamParts, numbers


class Control(CamParts):
    """Handlers of drags and wheel, their speed, constraints, and the part of the window."""

    def getRotateDragHandler(self) -> PeasyDragHandler:
        """Return what turns the camera: the left button's handler at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setRightDragHandler(cam.getRotateDragHandler())
        """
        return self._hand.rotate_drag

    def getPanDragHandler(self) -> PeasyDragHandler:
        """Return what moves the camera along the picture: the middle button's handler at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setLeftDragHandler(cam.getPanDragHandler())
        """
        return self._hand.pan_drag

    def getZoomDragHandler(self) -> PeasyDragHandler:
        """Return what brings the camera nearer: the right button's handler at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setLeftDragHandler(cam.getZoomDragHandler())
        """
        return self._hand.zoom_drag

    def getZoomWheelHandler(self) -> PeasyWheelHandler:
        """Return what the wheel does at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setWheelHandler(cam.getZoomWheelHandler())
        """
        return self._hand.zoom_wheel

    def getWheelHandler(self) -> HasHandleWheel | None:
        """Return what the wheel does now.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> handler = PeasyCam(this, 200).getWheelHandler()
        """
        return self._hand.wheel

    def setLeftDragHandler(self, handler: Drag) -> None:
        """Say what a drag with the left button does.

        Parameters
        ----------
        handler : PeasyDragHandler, function or None
            It takes how far the mouse has moved, `dx, dy`. None: nothing.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setLeftDragHandler(lambda dx, dy: cam.rotateZ(dx * 0.01))
        """
        self._hand.left_drag = drag_handler("setLeftDragHandler", handler)

    def setCenterDragHandler(self, handler: Drag) -> None:
        """Say what a drag with the middle button does, or with the left one and Command.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setCenterDragHandler(None)
        """
        self._hand.center_drag = drag_handler("setCenterDragHandler", handler)

    def setRightDragHandler(self, handler: Drag) -> None:
        """Say what a drag with the right button does.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setRightDragHandler(cam.getPanDragHandler())
        """
        self._hand.right_drag = drag_handler("setRightDragHandler", handler)

    def setWheelHandler(self, handler: Wheel) -> None:
        """Say what the wheel does; the handler takes its notches.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setWheelHandler(lambda delta: cam.rotateY(delta * 0.1))
        """
        self._hand.wheel = wheel_handler("setWheelHandler", handler)

    def getWheelScale(self) -> float:
        """Return how fast the wheel is; 1 at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getWheelScale())
        1.0
        """
        return self._hand.wheel_scale

    def setWheelScale(self, scale: float) -> None:
        """Make the wheel faster, or slower; below 0 it works the other way round.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setWheelScale(0.5)
        """
        (self._hand.wheel_scale,) = numbers("setWheelScale", (scale,), "scale")

    def getRotationScale(self) -> float:
        """Return how fast a drag turns the camera; 1 at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getRotationScale())
        1.0
        """
        return self._hand.rotation_scale

    def setRotationScale(self, scale: float) -> None:
        """Make a drag turn the camera faster, or slower.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setRotationScale(2)
        """
        (self._hand.rotation_scale,) = numbers("setRotationScale", (scale,), "scale")

    def getPanScale(self) -> float:
        """Return how fast a drag moves the camera along the picture; 1 at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getPanScale())
        1.0
        """
        return self._hand.pan_scale

    def setPanScale(self, scale: float) -> None:
        """Make a drag move the camera along the picture faster, or slower.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setPanScale(0.5)
        """
        (self._hand.pan_scale,) = numbers("setPanScale", (scale,), "scale")

    def getZoomScale(self) -> float:
        """Return how fast a drag brings the camera nearer; 1 at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getZoomScale())
        1.0
        """
        return self._hand.zoom_scale

    def setZoomScale(self, scale: float) -> None:
        """Make a drag bring the camera nearer faster, or slower.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setZoomScale(0.5)
        """
        (self._hand.zoom_scale,) = numbers("setZoomScale", (scale,), "scale")

    def setFreeRotationMode(self) -> None:
        """Let a drag turn the camera about all its axes, as at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setFreeRotationMode()
        """
        self._hand.constraint = None

    def setYawRotationMode(self) -> None:
        """Let a drag turn the camera about its y axis alone, like a globe.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setYawRotationMode()
        """
        self._hand.constraint = Constraint.YAW

    def setPitchRotationMode(self) -> None:
        """Let a drag turn the camera about its x axis alone.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setPitchRotationMode()
        """
        self._hand.constraint = Constraint.PITCH

    def setRollRotationMode(self) -> None:
        """Let a drag turn the camera about its z axis alone: the picture turns.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setRollRotationMode()
        """
        self._hand.constraint = Constraint.ROLL

    def setSuppressRollRotationMode(self) -> None:
        """Let a drag turn the camera about its x and y axis, but never roll it.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setSuppressRollRotationMode()
        """
        self._hand.constraint = Constraint.SUPPRESS_ROLL

    def setResetOnDoubleClick(self, resetOnDoubleClick: bool) -> None:
        """Say whether a double click brings the camera back to where it was at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setResetOnDoubleClick(False)
        """
        self._resets_on_double_click = bool(resetOnDoubleClick)

    def setViewport(self, x: float, y: float, w: float, h: float) -> None:
        """Say in which part of the window the camera listens to the mouse.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> left = PeasyCam(this, 200)
        >>> left.setViewport(0, 0, 50, 100)
        """
        values = numbers("setViewport", (x, y, w, h), "x, y, width, height")
        self._hand.viewport[:] = map(int, values)

    def getViewport(self) -> list[int]:
        """Return x, y, width and height of that part: the whole canvas at first.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getViewport())
        [0, 0, 100, 100]
        """
        return self._hand.viewport

    def insideViewport(self, x: float, y: float) -> bool:
        """Return whether a place of the window lies in that part.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).insideViewport(120, 50))
        False
        """
        return self._hand.is_over_viewport(*numbers("insideViewport", (x, y), "x, y"))
