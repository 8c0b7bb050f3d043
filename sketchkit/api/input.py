"""Mouse and keyboard, as they are at the moment.

Whoever runs the sketch keeps `pointer` and `keyboard` up to date; without a window all stays 0.
"""

from __future__ import annotations

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.live import LiveFlag, live


class Input(SketchParts):
    """`mouseX`, `key` and their relatives."""

    @property
    @live
    def mouseX(self) -> int:
        """How far the pointer is from the left edge of the canvas, in pixels.

        Examples
        --------
        >>> circle(mouseX, mouseY, 20)
        """
        return self.pointer.x

    @property
    @live
    def mouseY(self) -> int:
        """How far the pointer is from the top edge of the canvas, in pixels.

        Examples
        --------
        >>> circle(mouseX, mouseY, 20)
        """
        return self.pointer.y

    @property
    @live
    def pmouseX(self) -> int:
        """What `mouseX` was in the previous frame; in a handler, at the previous event.

        Examples
        --------
        >>> line(pmouseX, pmouseY, mouseX, mouseY)
        """
        return self.pointer.previous_x

    @property
    @live
    def pmouseY(self) -> int:
        """What `mouseY` was in the previous frame; in a handler, at the previous event.

        Examples
        --------
        >>> line(pmouseX, pmouseY, mouseX, mouseY)
        """
        return self.pointer.previous_y

    @property
    @live
    def mouseButton(self) -> int:
        """Which button was pressed last: `LEFT`, `CENTER` or `RIGHT`; 0 before that.

        Examples
        --------
        >>> if mousePressed and mouseButton == RIGHT:
        ...     background(0)
        """
        return self.pointer.button

    @property
    @live
    def mousePressed(self) -> bool:
        """Whether a button of the mouse is held down. A function of this name is called then.

        Examples
        --------
        >>> if mousePressed:
        ...     circle(mouseX, mouseY, 20)
        """
        return self._flag("mousePressed", self.pointer.is_pressed)

    @property
    @live
    def firstMouse(self) -> bool:
        """Whether the pointer has not yet been over the window.

        Examples
        --------
        >>> println(firstMouse)
        """
        return self.pointer.is_new

    @property
    @live
    def key(self) -> str:
        """The character of the last key; `CODED` for keys that have none, see `keyCode`.

        Examples
        --------
        >>> if keyPressed and key == "b":
        ...     background(0)
        """
        return self.keyboard.key

    @property
    @live
    def keyCode(self) -> int:
        """Which key was the last: `UP`, `DOWN`, `LEFT`, `RIGHT`, `SHIFT`, `CONTROL`, `ALT`, ...

        Examples
        --------
        >>> if keyPressed and key == CODED and keyCode == UP:
        ...     translate(0, -10)
        """
        return self.keyboard.code

    @property
    @live
    def keyPressed(self) -> bool:
        """Whether a key is held down. A function of this name is called when one goes down.

        Examples
        --------
        >>> if keyPressed:
        ...     background(0)
        """
        return self._flag("keyPressed", bool(self.keyboard.held))

    @property
    @live
    def mouseEvent(self) -> MouseEvent | None:
        """The last thing that happened with the mouse; None before that.

        Examples
        --------
        >>> println(mouseEvent)
        """
        return self.pointer.event

    @property
    @live
    def keyEvent(self) -> KeyEvent | None:
        """The last thing that happened with a key; None before that.

        Examples
        --------
        >>> println(keyEvent)
        """
        return self.keyboard.event

    def _flag(self, name: str, is_on: bool) -> bool:
        handler = self.handlers.get(name)
        # Not a bool, but it counts, compares and prints as one; only `is` tells the difference.
        return LiveFlag(is_on, handler) if handler else is_on  # type: ignore[return-value]
