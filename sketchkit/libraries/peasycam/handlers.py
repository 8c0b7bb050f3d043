"""What a drag or the wheel does: objects that a sketch can exchange, or plain functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeAlias, runtime_checkable

from sketchkit.core.errors import SketchError, shown


class PeasyDragHandler:
    """What happens while a button is held and the mouse moves.

    Examples
    --------
    >>> from peasycam import PeasyDragHandler
    >>> size(100, 100, P3D)
    >>> class Lift(PeasyDragHandler):
    ...     def handleDrag(self, dx, dy):
    ...         cam.pan(0, dy)
    >>> cam = PeasyCam(this, 200)
    >>> cam.setLeftDragHandler(Lift())
    """

    def handleDrag(self, dx: float, dy: float) -> None:
        """Take how far the mouse has moved since the last event, in pixels.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.getPanDragHandler().handleDrag(10, 0)
        """
        raise NotImplementedError


class PeasyWheelHandler:
    """What happens when the wheel is turned.

    Examples
    --------
    >>> from peasycam import PeasyWheelHandler
    >>> size(100, 100, P3D)
    >>> class Turn(PeasyWheelHandler):
    ...     def handleWheel(self, delta):
    ...         cam.rotateZ(delta * 0.1)
    >>> cam = PeasyCam(this, 200)
    >>> cam.setWheelHandler(Turn())
    """

    def handleWheel(self, delta: int) -> None:
        """Take the notches, positive towards the user.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.getZoomWheelHandler().handleWheel(1)
        """
        raise NotImplementedError


class DragHandler(PeasyDragHandler):
    """A drag handler that is a function."""

    def __init__(self, call: Callable[[float, float], object]) -> None:
        self._call = call

    def handleDrag(self, dx: float, dy: float) -> None:
        """Take how far the mouse has moved since the last event, in pixels."""
        self._call(dx, dy)


class WheelHandler(PeasyWheelHandler):
    """A wheel handler that is a function."""

    def __init__(self, call: Callable[[int], object]) -> None:
        self._call = call

    def handleWheel(self, delta: int) -> None:
        """Take the notches, positive towards the user."""
        self._call(delta)


@runtime_checkable
class HasHandleDrag(Protocol):
    """A drag handler: PeasyCam's interface needs no base class here."""

    def handleDrag(self, dx: float, dy: float) -> None:
        """Take how far the mouse has moved since the last event, in pixels."""
        ...


@runtime_checkable
class HasHandleWheel(Protocol):
    """A wheel handler."""

    def handleWheel(self, delta: int) -> None:
        """Take the notches, positive towards the user."""
        ...


Drag: TypeAlias = HasHandleDrag | Callable[[float, float], object] | None
Wheel: TypeAlias = HasHandleWheel | Callable[[int], object] | None


def drag_handler(caller: str, handler: Drag) -> HasHandleDrag | None:
    """Return what a sketch has given as a drag handler, as an object; None does nothing."""
    if handler is None or isinstance(handler, HasHandleDrag):
        return handler
    if callable(handler):
        return DragHandler(handler)
    raise SketchError(
        f"{caller}() takes an object with a method handleDrag(dx, dy), a function, or None.",
        got=f"{caller}({shown(handler)})",
    )


def wheel_handler(caller: str, handler: Wheel) -> HasHandleWheel | None:
    """Return what a sketch has given as a wheel handler, as an object; None does nothing."""
    if handler is None or isinstance(handler, HasHandleWheel):
        return handler
    if callable(handler):
        return WheelHandler(handler)
    raise SketchError(
        f"{caller}() takes an object with a method handleWheel(delta), a function, or None.",
        got=f"{caller}({shown(handler)})",
    )
