"""What a handler may ask about its event: `event.getCount()`, `event.isShiftDown()`.

The numbers are Processing's own.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar


@dataclass(frozen=True, slots=True)
class Event:
    """What mouse events and key events have in common.

    Attributes
    ----------
    action : int
        One of the constants of the class: `MouseEvent.PRESS`, `KeyEvent.TYPE`, ...
    modifiers : int
        The sum of `SHIFT`, `CTRL`, `META` and `ALT` for the keys held down.
    millis : int
        When it happened, as `millis()` counts.

    Examples
    --------
    >>> def mousePressed(event):
    ...     println(isinstance(event, Event))
    """

    SHIFT: ClassVar = 1
    CTRL: ClassVar = 2
    META: ClassVar = 4
    ALT: ClassVar = 8
    KEY: ClassVar = 1
    MOUSE: ClassVar = 2
    TOUCH: ClassVar = 3

    action: int
    modifiers: int = 0
    millis: int = 0

    def getAction(self) -> int:
        """Return what happened, one of the constants of the class.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getAction())
        """
        return self.action

    def getModifiers(self) -> int:
        """Return which of Shift, Control, Meta and Alt were held, as a sum.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getModifiers())
        """
        return self.modifiers

    def getMillis(self) -> int:
        """Return when it happened, in milliseconds since the sketch began.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getMillis())
        """
        return self.millis

    def isShiftDown(self) -> bool:
        """Return whether Shift was held.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.isShiftDown())
        """
        return bool(self.modifiers & Event.SHIFT)

    def isControlDown(self) -> bool:
        """Return whether Control was held.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.isControlDown())
        """
        return bool(self.modifiers & Event.CTRL)

    def isMetaDown(self) -> bool:
        """Return whether the Command or Windows key was held.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.isMetaDown())
        """
        return bool(self.modifiers & Event.META)

    def isAltDown(self) -> bool:
        """Return whether Alt was held.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.isAltDown())
        """
        return bool(self.modifiers & Event.ALT)


@dataclass(frozen=True, slots=True)
class MouseEvent(Event):
    """A movement, a button or the wheel of the mouse.

    Attributes
    ----------
    x, y : int, pixels
        Where the pointer was.
    button : int
        `LEFT`, `CENTER`, `RIGHT`, or 0.
    count : int
        Clicks in a row; for the wheel, notches: positive downwards.

    Examples
    --------
    >>> def mouseWheel(event):
    ...     println(event.getCount())
    """

    PRESS: ClassVar = 1
    RELEASE: ClassVar = 2
    CLICK: ClassVar = 3
    DRAG: ClassVar = 4
    MOVE: ClassVar = 5
    ENTER: ClassVar = 6
    EXIT: ClassVar = 7
    WHEEL: ClassVar = 8

    x: int = 0
    y: int = 0
    button: int = 0
    count: int = 0

    def getFlavor(self) -> int:
        """Return `MouseEvent.MOUSE`.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getFlavor())
        """
        return Event.MOUSE

    def getX(self) -> int:
        """Return how far from the left the pointer was, in pixels.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getX())
        """
        return self.x

    def getY(self) -> int:
        """Return how far from the top the pointer was, in pixels.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getY())
        """
        return self.y

    def getButton(self) -> int:
        """Return `LEFT`, `CENTER`, `RIGHT`, or 0.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getButton())
        """
        return self.button

    def getCount(self) -> int:
        """Return the clicks in a row, or the notches of the wheel (positive downwards).

        Examples
        --------
        >>> def mouseWheel(event):
        ...     println(event.getCount())
        """
        return self.count

    def getClickCount(self) -> int:
        """Return the clicks in a row; the older name of `getCount()`.

        Examples
        --------
        >>> def mousePressed(event):
        ...     println(event.getClickCount())
        """
        return self.count

    def getAmount(self) -> float:
        """Return the notches of the wheel; the older name of `getCount()`.

        Examples
        --------
        >>> def mouseWheel(event):
        ...     println(event.getAmount())
        """
        return float(self.count)


@dataclass(frozen=True, slots=True)
class KeyEvent(Event):
    """A key that went down, came up, or typed a character.

    Attributes
    ----------
    key : str
        The character, or `CODED` for a key that has none.
    keyCode : int
        Which key it is: `LEFT`, `SHIFT`, ..., or the capital letter's number.
    is_repeat : bool
        Whether it comes from holding the key.

    Examples
    --------
    >>> def keyPressed(event):
    ...     println(event.getKeyCode())
    """

    PRESS: ClassVar = 1
    RELEASE: ClassVar = 2
    TYPE: ClassVar = 3

    key: str = "\0"
    keyCode: int = 0
    is_repeat: bool = False

    def getFlavor(self) -> int:
        """Return `KeyEvent.KEY`.

        Examples
        --------
        >>> def keyPressed(event):
        ...     println(event.getFlavor())
        """
        return Event.KEY

    def getKey(self) -> str:
        """Return the character, or `CODED`.

        Examples
        --------
        >>> def keyPressed(event):
        ...     println(event.getKey())
        """
        return self.key

    def getKeyCode(self) -> int:
        """Return which key it is, as `keyCode`.

        Examples
        --------
        >>> def keyPressed(event):
        ...     println(event.getKeyCode())
        """
        return self.keyCode

    def isAutoRepeat(self) -> bool:
        """Return whether the event comes from holding the key.

        Examples
        --------
        >>> def keyPressed(event):
        ...     println(event.isAutoRepeat())
        """
        return self.is_repeat
