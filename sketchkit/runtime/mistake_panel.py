"""A mistake, as it is shown in the window: over the dimmed picture, in letters that fit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import BASELINE, LEFT
from sketchkit.runtime.report import Report

LEAST_SIZE = 480, 200  # px; in a smaller window no sentence can be read
TEXT_SIZES = (17, 16, 15, 14, 13, 12, 11, 10, 9)  # px; the first that fits is taken
LEADING = 1.4  # of the text size
MARGIN = 14  # px

DIM = 0xB0101418
PLACE_COLOR = 0xFFFF8A70
TEXT_COLOR = 0xFFFFFFFF
SOURCE_COLOR = 0xFFCFE3FF
MARK_COLOR = 0xFFFF6450
HINT_COLOR = 0xFFA9B4C0
HINT = "Mend it and save: the sketch goes on here. Esc ends it."


@dataclass(frozen=True)
class Line:
    """A line of the panel.

    Attributes
    ----------
    text : str
    color : int
        Packed ARGB.
    mark : (first, end), from 0
        The characters that are underlined; none if they are equal.
    """

    text: str
    color: int
    mark: tuple[int, int] = (0, 0)


def shown_size(width: int, height: int) -> tuple[int, int]:
    """Return how large a window must be to show a mistake over a picture of that size."""
    return max(width, LEAST_SIZE[0]), max(height, LEAST_SIZE[1])


def draw_mistake(canvas: PGraphics, report: Report) -> None:
    """Draw what a report says over all of a canvas."""
    canvas.noStroke()
    canvas.fill(DIM)
    canvas.rect(0, 0, canvas.width, canvas.height)
    canvas.textAlign(LEFT, BASELINE)
    height = canvas.height - 2 * MARGIN
    for size in TEXT_SIZES:
        canvas.textSize(size)
        lines = list(_lines(canvas, report, canvas.width - 2 * MARGIN))
        if len(lines) * size * LEADING <= height:
            break
    y: float = MARGIN + size
    for line in lines:
        _write(canvas, line, y, size)
        y += size * LEADING


def _lines(canvas: PGraphics, report: Report, width: float) -> Iterator[Line]:
    """Yield the lines of the panel, none wider than it."""
    yield from (Line(text, PLACE_COLOR) for text in _wrapped(canvas, report.place, width))
    for part in report.message.splitlines():
        yield from (Line(text, TEXT_COLOR) for text in _wrapped(canvas, part, width))
    if report.source_line.strip():
        yield Line("", TEXT_COLOR)
        yield _source_line(canvas, report, width)
    if report.calls:
        yield Line("", TEXT_COLOR)
        for call in report.calls:
            yield from (Line(text, HINT_COLOR) for text in _wrapped(canvas, call, width))
    yield Line("", TEXT_COLOR)
    yield from (Line(text, HINT_COLOR) for text in _wrapped(canvas, HINT, width))


def _wrapped(canvas: PGraphics, text: str, width: float) -> Iterator[str]:
    """Yield a text in lines of whole words, each as far indented as the text is."""
    indent = text[: len(text) - len(text.lstrip())]
    line = ""
    for word in text.split():
        longer = f"{line} {word}" if line else indent + word
        if line and canvas.textWidth(longer) > width:
            yield line
            longer = indent + word
        line = longer
    yield line


def _source_line(canvas: PGraphics, report: Report, width: float) -> Line:
    """Return the line of the sketch; one that is too long loses its beginning before the mark."""
    text = report.source_line.rstrip().expandtabs(1)
    indent = len(text) - len(text.lstrip())
    first, end = (max(column - indent, 0) for column in report.columns)
    text = text.lstrip()
    cut = 0
    room = width - canvas.textWidth("00000  ")
    while canvas.textWidth(text[cut:end]) > room and cut < first:
        cut += 1
    number = f"{report.line}  "
    shown, start = number + text[cut:], len(number) - cut
    while canvas.textWidth(shown) > width:
        shown = shown[:-1]
    return Line(shown, SOURCE_COLOR, (first + start, end + start))


def _write(canvas: PGraphics, line: Line, y: float, size: float) -> None:
    canvas.fill(line.color)
    canvas.text(line.text, MARGIN, y)
    first, end = line.mark
    if first < end:
        left = MARGIN + canvas.textWidth(line.text[:first])
        canvas.fill(MARK_COLOR)
        width = canvas.textWidth(line.text[first:end])
        canvas.rect(left, y + size * 0.2, max(width, size / 2), 2)  # also behind the line's end
