"""The numbers panel: each number of the sketch in its line, changed by keys or by the mouse."""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CODED, DOWN, ENTER, LEFT, RIGHT, UP
from sketchkit.runtime.explore.panel import LEADING, MARGIN, SIZE, draw_panel
from sketchkit.runtime.explore.tweaks import Number, Tweaks
from sketchkit.runtime.loader import Program

TITLE = "Numbers: drag one, or use the wheel or the arrows"
WRITE = "Write them into the file: click here, or Enter"
PIXELS = 2  # of a drag, for a step
FAST = 10  # times, with Shift
HEAD = 8  # characters: the mark of what is changed, and the number of the line
CUT = "..."
SHARE = 0.8  # of the room, for what stands before a number and itself, if a line is too long


@dataclass
class _Drag:
    """A number that the mouse drags: where it began, and what the number was then."""

    number: Number
    x: int
    value: float


class NumbersPanel:
    """Shows the numbers of a sketch, and changes them.

    Attributes
    ----------
    tweaks : Tweaks or None
        The numbers; None while it is not shown.
    """

    def __init__(self) -> None:
        self.tweaks: Tweaks | None = None
        self._chosen = 0
        self._rows: range = range(0)  # which numbers are shown
        self._size = (0.0, 0.0)
        self._drag: _Drag | None = None

    def follow(self, program: Program) -> None:
        """Show the numbers of the text that a sketch runs now."""
        if self.tweaks is None or not self.tweaks.is_of(program):
            self.tweaks, self._drag = Tweaks(program), None
            self._chosen = min(self._chosen, max(len(self.tweaks.numbers) - 1, 0))

    def draw(self, canvas: PGraphics) -> None:
        """Draw as many numbers as there is room for, the chosen one among them."""
        tweaks = self.tweaks
        if tweaks is None or not tweaks.numbers:
            draw_panel(canvas, ["There are no numbers in this sketch."])
            return
        count = max((canvas.height - 3 * MARGIN) // LEADING - 2, 1)
        first = min(max(self._rows.start, self._chosen - count + 1), self._chosen)
        first = max(min(first, len(tweaks.numbers) - count), 0)
        self._rows = range(first, min(first + count, len(tweaks.numbers)))
        canvas.textSize(SIZE)
        lines = [_row(canvas, _label(tweaks, place)) for place in self._rows]
        marked = 1 + self._chosen - first
        first_line, last_line = (_row(canvas, ("", text, "")) for text in (TITLE, WRITE))
        self._size = draw_panel(canvas, [first_line, *lines, last_line], marked=marked)

    def handles_key(self, event: KeyEvent) -> bool:
        """Take a key; return whether the sketch does not get it."""
        tweaks = self.tweaks
        code = event.keyCode if event.key == CODED else event.key
        if tweaks is None or not tweaks.numbers or code not in (UP, DOWN, LEFT, RIGHT, ENTER):
            return False
        if event.action != KeyEvent.PRESS:
            return True
        if code == ENTER:
            tweaks.write()
        elif code in (UP, DOWN):
            self._chosen = (self._chosen + (1 if code == DOWN else -1)) % len(tweaks.numbers)
        else:
            self._step(tweaks.numbers[self._chosen], 1 if code == RIGHT else -1, event)
        return True

    def handles_mouse(self, event: MouseEvent) -> bool:
        """Take what the mouse does over the panel, and what it drags from there."""
        tweaks = self.tweaks
        if tweaks is None or not tweaks.numbers:
            return False
        if self._drag is not None:
            return self._go_on_dragging(self._drag, event)
        width, height = self._size
        x, y = event.x - MARGIN, event.y - MARGIN
        if not (0 <= x < width and 0 <= y < height):
            return False
        row = int(y - MARGIN / 2) // LEADING - 1
        if event.action == MouseEvent.PRESS:
            self._press(tweaks, row, event)
        elif event.action == MouseEvent.WHEEL:
            self._turn(tweaks, row, event)
        return event.action not in (MouseEvent.ENTER, MouseEvent.EXIT)

    def _press(self, tweaks: Tweaks, row: int, event: MouseEvent) -> None:
        """Choose the number of a row and begin to drag it; below all rows, write."""
        if 0 <= row < len(self._rows):
            self._chosen = self._rows[row]
            number = tweaks.numbers[self._chosen]
            self._drag = _Drag(number, event.x, number.value)
        elif row == len(self._rows):
            tweaks.write()

    def _turn(self, tweaks: Tweaks, row: int, event: MouseEvent) -> None:
        """Change the chosen number by the wheel over its own row, or else choose another one."""
        if 0 <= row < len(self._rows) and self._rows[row] == self._chosen:
            self._step(tweaks.numbers[self._chosen], -event.count, event)
        else:
            last = len(tweaks.numbers) - 1
            self._chosen = min(max(self._chosen + event.count, 0), last)

    def _go_on_dragging(self, drag: _Drag, event: MouseEvent) -> bool:
        if event.action == MouseEvent.DRAG:
            drag.number.value = drag.value
            self._step(drag.number, round((event.x - drag.x) / PIXELS), event)
        elif event.action == MouseEvent.RELEASE:
            self._drag = None
        return event.action not in (MouseEvent.ENTER, MouseEvent.EXIT)

    def _step(self, number: Number, count: int, event: KeyEvent | MouseEvent) -> None:
        assert self.tweaks is not None
        number.step(count * (FAST if event.isShiftDown() else 1))
        self.tweaks.apply()


def _label(tweaks: Tweaks, place: int) -> tuple[str, str, str]:
    """Return what stands before a number, itself with its line's number, and what follows."""
    number = tweaks.numbers[place]
    before, shown, after = tweaks.around(number)
    return f"{'*' if number.is_changed else ' '} {number.line:>4}  {before}", shown, after


def _row(canvas: PGraphics, label: tuple[str, str, str]) -> str:
    """Return a line that fits into the canvas, cut before and behind its number."""
    before, shown, after = label
    room = canvas.width - 4 * MARGIN
    if canvas.textWidth(before + shown + after) <= room:
        return before + shown + after
    head, before = before[:HEAD], before[HEAD:]
    while before and canvas.textWidth(head + CUT + before + shown) > room * SHARE:
        before = before[1:]
    start = (head + CUT + before if before else head) + shown
    while (after or not head) and canvas.textWidth(start + after + CUT) > room:
        start, after = (start, after[:-1]) if after else (start[:-1], "")
    return start + after + CUT
