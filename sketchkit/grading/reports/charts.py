"""Charts as numbers for a template: curves over frames, and how marks are spread.

The template draws them as SVG of 100 by 100 units that is stretched to its place; labels are
HTML beside it, so that they keep their size on a phone. y points down.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from sketchkit.core.constants import MAX_FLOAT
from sketchkit.grading.reports.figures import has_marks, plain
from sketchkit.grading.results import Curve, StudentResult

Point = TypeVar("Point")

MOST_STEPS = 6  # of an axis: more labels do not fit on a phone
MOST_BARS = 10
TALLEST = 84.0  # percent of a histogram's height; its count stands above it
# A curve that shoots off must not press the band flat: so many heights of the band are shown on
# each side of it.
BAND_MARGIN = 1.5
EDGE = 1000.0  # units: where a point that lies far outside is drawn, so that numbers stay short


@dataclass(frozen=True)
class Axis:
    """The ends of an axis, and the labels of ticks that divide it evenly."""

    start: float
    end: float
    labels: tuple[str, ...]

    def place(self, value: float) -> float:
        """Return where a value lies, 0 to 100 within the axis."""
        return (value - self.start) / (self.end - self.start) * 100


@dataclass(frozen=True)
class CurveChart:
    """A curve as a template draws it.

    Attributes
    ----------
    x_labels, y_labels : tuple of str
        From left to right, from top to bottom.
    bands, lines : tuple of str
        Points of polygons, and of polylines, between gaps.
    outside : tuple of (str, str)
        Where the curve leaves the band: x and y, at the chart's edge if they lie beyond it.
    gaps : tuple of (str, str)
        Left end and width of where there is no number.
    words : str
        What the chart shows, for who cannot see it.
    """

    x_labels: tuple[str, ...]
    y_labels: tuple[str, ...]
    bands: tuple[str, ...]
    lines: tuple[str, ...]
    outside: tuple[tuple[str, str], ...]
    gaps: tuple[tuple[str, str], ...]
    words: str


@dataclass(frozen=True)
class Bar:
    """How many submissions have marks within a range."""

    label: str
    count: int
    height: float  # percent of the chart's

    @property
    def top(self) -> float:
        """Percent of the chart's height that are above it."""
        return 100 - self.height


def curve_chart(curve: Curve) -> CurveChart | None:
    """Return a curve as a chart, or None if it has no frames."""
    frames = [float(frame) for frame in curve.frames]
    if not frames:
        return None
    x = axis(min(frames), max(frames))
    y = axis(*_shown_range(curve))
    points = list(zip(frames, curve.values, curve.low, curve.high, strict=True))
    known = [[(f, v) for f, v, _, _ in run] for run in _runs(points, lambda p: _is_drawn(p[1]))]
    banded = _runs(points, lambda p: _is_drawn(p[2]) and _is_drawn(p[3]))
    outside = [(f, v) for f, v, low, high in points if _is_drawn(v) and not low <= v <= high]
    return CurveChart(
        x_labels=x.labels,
        y_labels=y.labels[::-1],
        bands=tuple(
            _points(x, y, [(f, h) for f, _, _, h in run] + [(f, low) for f, _, low, _ in run[::-1]])
            for run in banded
        ),
        lines=tuple(_points(x, y, run if len(run) > 1 else run * 2) for run in known),
        outside=tuple((_unit(x.place(f)), _height(y, v, edge=0.0)) for f, v in outside),
        gaps=_gaps(x, points),
        words=_words(curve, len(outside), sum(not _is_drawn(v) for v in curve.values)),
    )


def axis(start: float, end: float, most_steps: int = MOST_STEPS) -> Axis:
    """Return an axis that holds both ends, divided by steps of 1, 2 or 5 times a power of ten."""
    if not end > start:
        start, end = start - 0.5, start + 0.5
    step = _step((end - start) / most_steps)
    first, last = math.floor(start / step), math.ceil(end / step)
    decimals = max(0, -math.floor(math.log10(step)))
    is_long = decimals > 6 or max(abs(start), abs(end)) >= 1e6
    numbers = [number * step for number in range(first, last + 1)]
    labels = tuple(f"{n:.3g}" if is_long else f"{n:.{decimals}f}" for n in numbers)
    return Axis(numbers[0], numbers[-1], labels)


def histogram(students: Sequence[StudentResult]) -> tuple[Bar, ...]:
    """Return how many submissions have marks in each of some ranges of one width."""
    marks = [student.points for student in students if has_marks(student)]
    possible = max((student.out_of for student in students), default=0.0)
    if not marks or possible <= 0:
        return ()
    step = _step(possible / MOST_BARS)
    edges = np.arange(math.ceil(round(possible / step, 6)) + 1) * step
    counts, _ = np.histogram(np.clip(marks, 0, edges[-1]), edges)
    ends = [plain(float(edge)) for edge in edges]
    return tuple(
        Bar(f"{low}-{high}", int(count), round(TALLEST * int(count) / int(counts.max()), 2))
        for low, high, count in zip(ends, ends[1:], counts, strict=False)
    )


def _step(least: float) -> float:
    """Return the smallest of 1, 2 and 5 times powers of ten that is not below a number."""
    power = 10.0 ** math.floor(math.log10(least))
    factors = (1, 2, 5, 10)
    return power * next(factor for factor in factors if power * factor >= least * (1 - 1e-9))


def _is_drawn(value: float) -> bool:
    """Return whether a value has a place: NaN and infinities have none."""
    return abs(value) <= MAX_FLOAT


def _shown_range(curve: Curve) -> tuple[float, float]:
    values = [value for value in curve.values if _is_drawn(value)]
    band = [value for value in (*curve.low, *curve.high) if _is_drawn(value)]
    if not band:
        return (min(values), max(values)) if values else (0.0, 1.0)
    bottom, top = min(band), max(band)
    margin = BAND_MARGIN * max(top - bottom, abs(top) / 100, 1e-6)
    return (
        max(min([bottom, *values]), bottom - margin),
        min(max([top, *values]), top + margin),
    )


def _runs(points: Iterable[Point], is_in: Callable[[Point], bool]) -> list[list[Point]]:
    """Return the unbroken runs of points that a test holds for."""
    return [list(run) for holds, run in itertools.groupby(points, is_in) if holds]


def _gaps(x: Axis, points: Sequence[tuple[float, ...]]) -> tuple[tuple[str, str], ...]:
    """Return left end and width of where there is no number, between the numbers beside it."""
    gaps = []
    numbered = list(enumerate(points))
    for run in _runs(numbered, lambda item: not _is_drawn(item[1][1])):
        before, after = max(run[0][0] - 1, 0), min(run[-1][0] + 1, len(points) - 1)
        left, right = x.place(points[before][0]), x.place(points[after][0])
        gaps.append((_unit(left), _unit(right - left)))
    return tuple(gaps)


def _points(x: Axis, y: Axis, pairs: Iterable[tuple[float, float]]) -> str:
    return " ".join(f"{_unit(x.place(frame))},{_height(y, value)}" for frame, value in pairs)


def _height(y: Axis, value: float, edge: float = EDGE) -> str:
    """Return how far down a value lies, at most so many units beyond an end of the axis."""
    return _unit(min(max(100 - y.place(value), 0.0 - edge), 100 + edge))


def _unit(number: float) -> str:
    return f"{number:.2f}"


def _words(curve: Curve, outside: int, missing: int) -> str:
    words = f"frames {curve.frames[0]} to {curve.frames[-1]}: "
    words += f"{outside} outside of the band" if outside else "never outside of the band"
    return f"{words}, {missing} without a number." if missing else f"{words}."
