"""Panels: text and lines over the picture, drawn with sketchkit's own canvas."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import BASELINE, LEFT, LINES

F64 = NDArray[np.float64]

SIZE = 12  # px, of letters
LEADING = 16
MARGIN = 8
DIM = 0xD0101418
WHITE, FAINT, MARKED = 0xFFFFFFFF, 0xFFA9B4C0, 0xFFFFD060


def draw_panel(
    canvas: PGraphics,
    lines: Sequence[str],
    *,
    at: tuple[float, float] = (MARGIN, MARGIN),
    marked: int = -1,
) -> tuple[float, float]:
    """Draw lines of text on a dim ground; return the width and height that they take.

    Parameters
    ----------
    at : (x, y)
        The top left corner. A panel that would not fit is moved up or to the left.
    marked : int
        The line that is shown in another colour.
    """
    canvas.textSize(SIZE)
    canvas.textAlign(LEFT, BASELINE)
    shown = list(wrapped(canvas, lines, canvas.width - 4 * MARGIN))
    room = max((canvas.height - 3 * MARGIN) // LEADING, 1)
    if len(shown) > room:
        shown = [*shown[: room - 1], "..."]
    width = max((canvas.textWidth(line) for line in shown), default=0.0) + 2 * MARGIN
    height = len(shown) * LEADING + MARGIN
    x = max(min(at[0], canvas.width - width - MARGIN), 0.0)
    y = max(min(at[1], canvas.height - height - MARGIN), 0.0)
    canvas.noStroke()
    canvas.fill(DIM)
    canvas.rect(x, y, width, height)
    for row, line in enumerate(shown):
        canvas.fill(MARKED if row == marked else WHITE if row == 0 else FAINT)
        canvas.text(line, x + MARGIN, y + (row + 1) * LEADING - 2)
    return width, height


def wrapped(canvas: PGraphics, lines: Iterable[str], width: float) -> Iterable[str]:
    """Yield lines that are not wider than there is room, broken between words."""
    for line in lines:
        rest = line
        indent = " " * (len(line) - len(line.lstrip()) + 4)
        while canvas.textWidth(rest) > width and " " in rest.strip():
            cut = len(rest)
            while canvas.textWidth(rest[:cut]) > width:
                found = rest.rfind(" ", len(indent), cut)
                if found <= 0:
                    break
                cut = found
            if cut in (0, len(rest)):
                break
            yield rest[:cut]
            rest = indent + rest[cut:].lstrip()
        yield rest


def draw_lines(canvas: PGraphics, segments: F64, color: int) -> None:
    """Draw segments, (n, 2, 2) pixels, those far outside of the canvas left out."""
    size = np.array([canvas.width, canvas.height])
    low, high = segments.min(axis=1), segments.max(axis=1)
    inside = ((high >= 0) & (low <= size)).all(axis=1) & (np.abs(segments) < 1e5).all(axis=(1, 2))
    canvas.noFill()
    canvas.stroke(color)
    canvas.strokeWeight(1)
    canvas.beginShape(LINES)
    for (x1, y1), (x2, y2) in segments[inside].tolist():
        canvas.vertex(x1, y1)
        canvas.vertex(x2, y2)
    canvas.endShape()


def draw_graph(canvas: PGraphics, times_ms: Sequence[float], lines: Sequence[str]) -> None:
    """Draw how long the last frames took, and some numbers below."""
    width, height = 130.0, 40.0
    x, y = canvas.width - width - MARGIN, MARGIN
    canvas.noStroke()
    canvas.fill(DIM)
    canvas.rect(x, y, width, height + LEADING * len(lines) + MARGIN)
    most = max([*times_ms, 1000 / 30])
    canvas.stroke(0x60FFFFFF)
    canvas.strokeWeight(1)
    limit = y + height - height * (1000 / 60) / most  # a frame of 60 a second
    canvas.line(x, limit, x + width, limit)
    canvas.stroke(MARKED)
    for place, time_ms in enumerate(times_ms[-int(width) :]):
        canvas.line(x + place, y + height, x + place, y + height - height * time_ms / most)
    canvas.textSize(SIZE)
    canvas.textAlign(LEFT, BASELINE)
    canvas.fill(WHITE)
    for row, line in enumerate(lines):
        canvas.text(line, x + MARGIN, y + height + (row + 1) * LEADING - 2)
