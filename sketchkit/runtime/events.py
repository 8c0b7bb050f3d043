"""What happens to the window, in order: each event changes the sketch's state and calls a handler.

The order of things within an event is Processing's (`PApplet.handleMouseEvent`, `handleKeyEvent`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.core.constants import BACKSPACE, DELETE, ENTER, ESC, TAB
from sketchkit.runtime.loader import Program


@dataclass(frozen=True)
class WindowEvent:
    """The window has been moved, has got another size, or gets keys or no more.

    Attributes
    ----------
    handler : str
        `windowMoved`, `windowResized`, `focusGained` or `focusLost`.
    size : (width, height), pixels, or None
        The size that it has got.
    """

    handler: str
    size: tuple[int, int] | None = None


AnyEvent: TypeAlias = MouseEvent | KeyEvent | WindowEvent

MOUSE_HANDLERS = {
    MouseEvent.PRESS: "mousePressed",
    MouseEvent.RELEASE: "mouseReleased",
    MouseEvent.CLICK: "mouseClicked",
    MouseEvent.DRAG: "mouseDragged",
    MouseEvent.MOVE: "mouseMoved",
    MouseEvent.ENTER: "mouseEntered",
    MouseEvent.EXIT: "mouseExited",
    MouseEvent.WHEEL: "mouseWheel",
}
KEY_HANDLERS = {
    KeyEvent.PRESS: "keyPressed",
    KeyEvent.RELEASE: "keyReleased",
    KeyEvent.TYPE: "keyTyped",
}
UNTYPED = (BACKSPACE, TAB, ENTER, ESC, DELETE)  # in P2D and P3D: they only go down and up
PLACING = (MouseEvent.PRESS, MouseEvent.DRAG, MouseEvent.MOVE)  # these say where the pointer is


def dispatch(program: Program, event: AnyEvent) -> None:
    """Bring the sketch's state up to date with an event, and call the handler for it."""
    match event:
        case MouseEvent():
            _dispatch_mouse(program, event)
        case KeyEvent():
            _dispatch_key(program, event)
        case WindowEvent(handler=handler, size=size):
            if size:
                program.sketch.follow_window(*size)
            elif handler == "focusLost":
                program.sketch.keyboard.held.clear()
            program.call(handler)


def _dispatch_mouse(program: Program, event: MouseEvent) -> None:
    pointer = program.sketch.pointer
    if event.action in PLACING:
        if pointer.is_new:
            pointer.x, pointer.y = pointer.drawn_x, pointer.drawn_y = event.x, event.y
            pointer.event_x, pointer.event_y = event.x, event.y
            pointer.is_new = False
        pointer.previous_x, pointer.previous_y = pointer.event_x, pointer.event_y
        pointer.x, pointer.y = event.x, event.y
    pointer.event = event
    pointer.button = event.button
    if event.action in (MouseEvent.PRESS, MouseEvent.RELEASE):
        pointer.is_pressed = event.action == MouseEvent.PRESS
    program.call_registered("mouseEvent", event)
    program.call(MOUSE_HANDLERS[event.action], event)
    if event.action in (MouseEvent.DRAG, MouseEvent.MOVE):
        pointer.event_x, pointer.event_y = pointer.x, pointer.y


def _dispatch_key(program: Program, event: KeyEvent) -> None:
    keyboard = program.sketch.keyboard
    if not _is_heard(program, event):
        return
    keyboard.event = event
    keyboard.key, keyboard.code = event.key, event.keyCode
    if event.action == KeyEvent.PRESS:
        keyboard.held.add(event.keyCode)
    elif event.action == KeyEvent.RELEASE:
        keyboard.held.discard(event.keyCode)
    program.call(KEY_HANDLERS[event.action], event)
    program.call_registered("keyEvent", event)
    if event.action == KeyEvent.PRESS and keyboard.key == ESC:  # `key = 0` in the handler keeps it
        program.sketch.exit()


def _is_heard(program: Program, event: KeyEvent) -> bool:
    """Return whether a key reaches the sketch: Processing's two kinds of windows differ.

    That of the default renderer hands on all; that of P2D and P3D no key that repeats because it
    is held, unless the sketch wants it, and no typing of keys without a printed character.
    """
    if program.sketch.is_java2d:
        return True
    if event.is_repeat and not program.sketch.canvas.repeats_keys:
        return False
    return event.action != KeyEvent.TYPE or event.key not in UNTYPED
