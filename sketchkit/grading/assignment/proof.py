"""The proof of an assignment: its reference earns all marks, twice alike; an empty sketch none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain
from pathlib import Path

from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import CheckResult, Status, StudentResult


def prove(first: StudentResult, second: StudentResult, empty: StudentResult) -> list[str]:
    """Return what is wrong with an assignment, in sentences; none if it is proven.

    Parameters
    ----------
    first, second : StudentResult
        Of one reference, judged twice as if it were handed in.
    empty : StudentResult
        Of a sketch that does nothing.
    """
    return [*_lost_marks(first), *_differences(first, second), *free_marks(empty)]


def free_marks(empty: StudentResult, which: str = "A sketch that does nothing") -> list[str]:
    """Return where a sketch that does nothing, or next to nothing, earns marks, in sentences."""
    return [
        f"{which} gets {check.points:g} of {check.out_of:g} marks in "
        f"{check.name!r}: ask there for what has to be drawn or written, or tolerate less."
        for check in empty.checks
        if check.points > 0
    ]


def unlike_evidence(first: Evidence, second: Evidence) -> list[str]:
    """Return where two runs of one sketch have shown something else, in sentences.

    Pictures are compared byte by byte.
    """
    return [
        *_unlike_runs(first, second),
        *chain.from_iterable(
            _unlike_run(f" with {events}" if events else "", first, second, events)
            for events in sorted(first.runs.keys() & second.runs.keys())
        ),
    ]


def _lost_marks(result: StudentResult) -> Iterator[str]:
    if result.status is not Status.GRADED:
        yield f"The reference {result.name} was not judged to its end: {_why(result)}."
    for check in result.checks:
        if check.score < 1:
            reasons = " ".join(check.reasons)
            yield (
                f"The reference {result.name} gets {check.points:g} of {check.out_of:g} marks in "
                f"{check.name!r}: {reasons}"
            )


def _differences(first: StudentResult, second: StudentResult) -> Iterator[str]:
    """Yield what two judgements of one sketch do not agree in."""
    if False in (first.is_deterministic, second.is_deterministic):
        yield (
            f"The reference {first.name} draws something else at each run: does it ask for the "
            "time, or for random numbers that are not sketchkit's?"
        )
    if first.status is not second.status:
        yield (f"The reference {first.name} ended differently the second time: {_why(second)}.")
    others = {check.name: check for check in second.checks}
    for check in first.checks:
        if check.name not in others or _essence(check) != _essence(others[check.name]):
            yield f"The reference {first.name} was judged otherwise the second time: {check.name}."


def _essence(check: CheckResult) -> CheckResult:
    """Return a result without the places of its pictures, which differ from run to run."""
    comparisons = tuple(
        replace(comparison, submitted=None, expected=None, difference=None)
        for comparison in check.comparisons
    )
    # As texts, so that a value that is no number is equal to itself.
    return replace(
        check, comparisons=comparisons, curves=(), reasons=(*check.reasons, str(check.curves))
    )


def _why(result: StudentResult) -> str:
    return (result.explanation or result.status.value).rstrip(".")


def _unlike_runs(first: Evidence, second: Evidence) -> Iterator[str]:
    for events in sorted(first.runs.keys() ^ second.runs.keys()):
        yield f"One of both runs lacks {events or 'the run without mouse and keys'}."


def _unlike_run(where: str, first: Evidence, second: Evidence, events: str) -> Iterator[str]:
    one, other = first.runs[events], second.runs[events]
    for number in sorted(one.frames.keys() | other.frames.keys()):
        if _bytes(one.frames, number) != _bytes(other.frames, number):
            yield f"Frame {number}{where} is another picture at each run."
            break  # all that follow are likely to differ, too
    for number in sorted(one.traces.keys() | other.traces.keys()):
        if one.traces.get(number) != other.traces.get(number):
            yield f"In frame {number}{where} something else is drawn at each run."
            break
    for name in sorted(one.values.keys() | other.values.keys()):
        if str(one.values.get(name)) != str(other.values.get(name)):
            yield f"{name} has other values{where} at each run."


def _bytes(frames: Mapping[int, Path], number: int) -> bytes | None:
    return frames[number].read_bytes() if number in frames else None
