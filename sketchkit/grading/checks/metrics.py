"""How two pictures are compared: by what an eye sees of the difference, or pixel by pixel."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields

import numpy as np

from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.pictures import U8
from sketchkit.grading.images import verdict as flip
from sketchkit.grading.images.sizes import explain_size
from sketchkit.grading.images.verdict import Tolerance, Verdict


@dataclass(frozen=True)
class PixelTolerance:
    """How far pixels may be off.

    Attributes
    ----------
    step : int
        A pixel differs if one of its colours does by more than this, of 255.
    share : float
        Of all pixels, how many may differ.
    """

    step: int = 2
    share: float = 0.001


AnyTolerance = Tolerance | PixelTolerance


def read_tolerance(table: Table) -> AnyTolerance:
    """Return what a check's `metric` and `tolerance` say."""
    metric = table.choice("metric", tuple(METRICS), "flip")
    own = table.table("tolerance", f"the tolerance of metric {metric!r}")
    tolerance = METRICS[metric](own) if own else METRICS[metric](None)
    if own:
        own.finish()
    return tolerance


def compare(
    submitted: U8,
    expected: U8,
    tolerance: AnyTolerance,
    alternatives: Mapping[str, U8] = flip.NO_ALTERNATIVES,
    name: str = "",
    only: str | None = None,
) -> Verdict:
    """Return what is to be said of two pictures, (h, w, 3).

    `alternatives` are other pictures that the submitted one may resemble more, by name; `name` is
    the expected one's. `only` is the one explanation of a difference that is tried: "" for none.
    """
    if isinstance(tolerance, PixelTolerance):
        return _pixel_by_pixel(submitted, expected, tolerance)
    return flip.judge(submitted, expected, tolerance, alternatives, name=name, only=only)


def _flip_tolerance(table: Table | None) -> AnyTolerance:
    if table is None:
        return Tolerance()
    defaults = {field.name: getattr(Tolerance(), field.name) for field in fields(Tolerance)}
    values = {name: table.number(name, value, least=0) for name, value in defaults.items()}
    return Tolerance(**{name: type(defaults[name])(value) for name, value in values.items()})


def _pixel_tolerance(table: Table | None) -> AnyTolerance:
    usual = PixelTolerance()
    if table is None:
        return usual
    return PixelTolerance(
        table.whole("step", usual.step), table.number("share", usual.share, least=0)
    )


METRICS: dict[str, Callable[[Table | None], AnyTolerance]] = {
    "flip": _flip_tolerance,
    "pixels": _pixel_tolerance,
}


def _pixel_by_pixel(submitted: U8, expected: U8, tolerance: PixelTolerance) -> Verdict:
    height, width, _ = expected.shape
    if submitted.shape != expected.shape:
        differs = np.ones((height, width), bool)
        return _pixel_verdict(differs, math.inf, explain_size(submitted, expected).sentence)
    steps = np.abs(submitted.astype(np.int16) - expected).max(axis=2)
    differs = steps > tolerance.step
    count, allowed = int(differs.sum()), tolerance.share * differs.size
    distance = count / allowed if allowed else math.inf if count else 0.0
    noun = "pixel differs" if count == 1 else "pixels differ"
    reason = f"{count:,} {noun}, and {math.floor(allowed):,} may." if distance > 1 else ""
    return _pixel_verdict(differs, distance, reason)


def _pixel_verdict(differs: np.typing.NDArray[np.bool_], distance: float, reason: str) -> Verdict:
    return Verdict(
        is_alike=distance <= 1,
        distance=min(distance, flip.FARTHEST),
        flip_mean=0.0,
        flip_high=0.0,
        region=int(differs.sum()),
        region_box=_box(differs),
        reason=reason,
        explanation="",
        heat=np.repeat((differs * np.uint8(255))[..., None], 3, axis=2),
    )


def _box(differs: np.typing.NDArray[np.bool_]) -> tuple[int, int, int, int] | None:
    """Return left, top, width and height of what differs."""
    rows, columns = np.nonzero(differs)
    if not len(rows):
        return None
    left, top = int(columns.min()), int(rows.min())
    return left, top, int(columns.max()) - left + 1, int(rows.max()) - top + 1
