"""The check `motion`: values of the sketch's own, frame by frame, stay within tolerance bands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table, shown
from sketchkit.grading.checks.bands import F64, Band, band_around, values_at, written_band
from sketchkit.grading.checks.case import Basis, Case, Kind, missing_frame, result
from sketchkit.grading.checks.marks import MarkCurve, Measure, read_curve
from sketchkit.grading.checks.shift import read_shift
from sketchkit.grading.evidence import RunEvidence
from sketchkit.grading.results import CheckResult, Curve, Status
from sketchkit.runtime.watching import is_watchable

USUAL_RELATIVE = 0.05  # of the range that the reference moves through
EXAMPLE = 'Write values = ["ball.x", "angle"].'
TURNS = {"radians": 2 * np.pi, "degrees": 360.0}
BAND_EXAMPLE = "Write [[1, 0, 10], [60, 90, 110]]: frame, lowest, highest."

Corners = tuple[tuple[int, float, float], ...]


@dataclass(frozen=True)
class MotionRule:
    """Which values are watched, and how far they may stray.

    Attributes
    ----------
    values : tuple of str
        Names as the sketch has them.
    absolute, relative : float
        Half the width of the band around a reference: in the value's own unit, and as a share of
        its range. The larger one holds.
    shift : int
        By how many frames the submission may be early or late.
    bands : dict of str to tuple of (frame, low, high)
        Of values whose band is written down.
    curve : MarkCurve
    turn : float
        What a whole turn is, if the values are angles: whole turns make no difference. 0 if not.
    """

    values: tuple[str, ...]
    absolute: float
    relative: float
    shift: int
    curve: MarkCurve
    bands: dict[str, Corners] = field(default_factory=dict)
    turn: float = 0.0


@dataclass(frozen=True)
class _Track:
    """A value of the submission beside its band; `values` are those of the shifted frames."""

    name: str
    band: Band
    values: F64
    own_frames: NDArray[np.int64]

    @property
    def counts(self) -> NDArray[np.bool_]:
        """Where there is a band, and a frame that the submission could have."""
        return np.isfinite(self.band.low) & (self.own_frames >= 1)

    @property
    def is_within(self) -> NDArray[np.bool_]:
        """Where the value is within its band."""
        return self.counts & (self.values >= self.band.low) & (self.values <= self.band.high)


@dataclass(frozen=True)
class _Attempt:
    """All values against one reference, at one shift."""

    tracks: tuple[_Track, ...]
    shift: int
    share: float


def read(table: Table, check: Check) -> MotionRule:
    """Return the values and their tolerances, from a check's table."""
    bands = _read_bands(table, check)
    values = table.texts("values") or tuple(bands)
    if not values:
        raise table.error("A motion check needs values.", hint=EXAMPLE)
    for name in values:
        if not is_watchable(name):
            raise table.error(f"{name!r} is no name of a value.", "values", EXAMPLE)
    for name in bands:
        if name not in values:
            raise table.error(f"bands has {name}, which is not among the values.", "bands")
    absolute, relative = _read_tolerance(table)
    shift = read_shift(table, 0)
    turn = TURNS[table.choice("angles", tuple(TURNS), "radians")] if "angles" in table else 0.0
    curve = read_curve(table, Measure.SHARE)
    return MotionRule(values, absolute, relative, shift, curve, bands, turn)


def needs(check: Check, rule: MotionRule) -> tuple[Run, ...]:
    """Return the run whose values are watched."""
    return (Run(check.events, watched=rule.values, last_frame=check.frames[-1] + rule.shift),)


def basis(rule: MotionRule) -> Basis:
    """Return whether a reference is looked at."""
    return Basis.NOTHING if set(rule.values) <= set(rule.bands) else Basis.SKETCH


def judge(case: Case, rule: MotionRule) -> CheckResult:
    """Return the share of frames and values that are within their bands, at the best shift."""
    references = case.reference_runs() if basis(rule) is Basis.SKETCH else [case.run]
    attempts = [
        _attempt(case, rule, reference, shift)
        for reference in references
        for shift in sorted(range(-rule.shift, rule.shift + 1), key=abs)
    ]
    best = max(attempts, key=lambda attempt: attempt.share, default=None)  # the first of equals
    if best is None:
        return result(case.check, 0.0, rule.curve, ("There is no reference to compare with.",))
    reasons = [*_lateness(best), *(text for track in best.tracks for text in _said(track, case))]
    curves = [_curve(track) for track in best.tracks]
    return result(case.check, rule.curve.score(1 - best.share), rule.curve, reasons, curves=curves)


def _attempt(case: Case, rule: MotionRule, reference: RunEvidence, shift: int) -> _Attempt:
    tracks = tuple(_track(case, rule, reference, name, shift) for name in rule.values)
    counted = sum(int(track.counts.sum()) for track in tracks)
    within = sum(int(track.is_within.sum()) for track in tracks)
    is_known = all(track.counts.any() for track in tracks)
    return _Attempt(tracks, shift, within / counted if counted and is_known else 0.0)


def _track(case: Case, rule: MotionRule, reference: RunEvidence, name: str, shift: int) -> _Track:
    frames = case.check.frames
    if name in rule.bands:
        band = written_band(rule.bands[name], frames)
    else:
        band = band_around(reference.values.get(name, ()), frames, rule.absolute, rule.relative)
    own_frames = band.frames + shift
    values = values_at(case.run.values.get(name, ()), own_frames)
    if rule.turn:
        values = values - rule.turn * np.round((values - (band.low + band.high) / 2) / rule.turn)
    return _Track(name, band, values, own_frames)


def _lateness(attempt: _Attempt) -> list[str]:
    if attempt.shift == 0 or attempt.share == 0:
        return []
    frames = f"{abs(attempt.shift)} frame{'s' if abs(attempt.shift) > 1 else ''}"
    when = "late" if attempt.shift > 0 else "early"
    return [f"Your motion is {frames} {when}, which costs no marks here."]


def _said(track: _Track, case: Case) -> Iterator[str]:
    """Yield what is to be said of a value."""
    if not track.counts.any():
        yield f"The reference has no number {track.name} in these frames: tell your teacher."
        return
    trajectory = case.run.values.get(track.name, ())
    is_past_end = track.counts & (track.own_frames > len(trajectory))
    is_unknown = track.counts & ~is_past_end & ~np.isfinite(track.values)
    has_stopped_early = case.run.status is not Status.GRADED and not len(trajectory)
    if not np.isfinite(trajectory).any() and not has_stopped_early:
        yield (
            f"Your sketch has no number that is called {track.name}: it has to be a variable "
            "outside of all functions, or belong to one."
        )
        return
    if is_past_end.any():
        yield missing_frame(case.run, int(track.own_frames[is_past_end][0]))
    if is_unknown.any():
        yield f"{track.name} is no number in {_frames(track.own_frames[is_unknown])}."
    yield from _stray(track)


def _stray(track: _Track) -> Iterator[str]:
    """Yield where a value leaves its band."""
    is_outside = track.counts & np.isfinite(track.values) & ~track.is_within
    if not is_outside.any():
        return
    first = int(np.argmax(is_outside))
    low, high = track.band.low[first], track.band.high[first]
    total = int(track.counts.sum())
    yield (
        f"{track.name} is outside of its band in {int(is_outside.sum())} of {total} frames. In "
        f"frame {track.own_frames[first]} it is {track.values[first]:.4g}, and {low:.4g} to "
        f"{high:.4g} is expected."
    )


def _frames(numbers: NDArray[np.int64]) -> str:
    """Return frames in words: "frame 3", or "4 frames from frame 3 on"."""
    if len(numbers) == 1:
        return f"frame {numbers[0]}"
    return f"{len(numbers)} frames, first in frame {numbers[0]}"


def _curve(track: _Track) -> Curve:
    """Return the value and its band over the reference's frames, as a report draws them."""
    is_shown = track.counts
    return Curve(
        track.name,
        tuple(track.band.frames[is_shown].tolist()),
        tuple(track.values[is_shown].tolist()),
        tuple(track.band.low[is_shown].tolist()),
        tuple(track.band.high[is_shown].tolist()),
    )


def _read_tolerance(table: Table) -> tuple[float, float]:
    """Return the absolute and the relative tolerance."""
    value = table.value("tolerance")
    if value is None:
        return 0.0, USUAL_RELATIVE
    if not isinstance(value, dict):
        return table.as_number(value, "tolerance", least=0), 0.0
    own = table.table("tolerance", "the tolerance of motion")
    assert own is not None
    widths = own.number("absolute", 0.0, least=0), own.number("relative", 0.0, least=0)
    own.finish()
    return widths


def _read_bands(table: Table, check: Check) -> dict[str, Corners]:
    own = table.table("bands", "bands")
    if own is None:
        return {}
    return {name: _read_band(own, name, corners, check) for name, corners in own.entries().items()}


def _read_band(table: Table, name: str, corners: object, check: Check) -> Corners:
    if not isinstance(corners, list) or not corners:
        raise table.error(
            f"{name} needs a list of corners, not {shown(corners)}.", name, BAND_EXAMPLE
        )
    band = tuple(_read_corner(table, name, corner) for corner in corners)
    if any(first[0] >= second[0] for first, second in pairwise(band)):
        raise table.error(f"The frames of {name} rise.", name, BAND_EXAMPLE)
    if not any(band[0][0] <= number <= band[-1][0] for number in check.frames):
        raise table.error(
            f"The band of {name} covers none of the frames that are looked at.", name, BAND_EXAMPLE
        )
    return band


def _read_corner(table: Table, name: str, corner: object) -> tuple[int, float, float]:
    if not isinstance(corner, list) or len(corner) != 3:
        raise table.error(f"A corner of {name} has three numbers.", name, BAND_EXAMPLE)
    frame, low, high = (table.as_number(number, name) for number in corner)
    if low > high or frame != int(frame):
        raise table.error(
            f"A corner of {name} has a frame, the lowest and the highest number.",
            name,
            BAND_EXAMPLE,
        )
    return int(frame), low, high


KIND = Kind(read, needs, judge, basis)
