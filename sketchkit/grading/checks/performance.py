"""The check `performance`: how much a frame gives the renderer to do.

Draw calls and vertices are the same on every computer. Time is not, so that it never counts alone.
A frame that draws nothing is not fast: it gets no marks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from statistics import fmean

from sketchkit.core.errors import either
from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.amount import Amount, read_amount
from sketchkit.grading.checks.case import Basis, Case, Kind, first_of, missing_trace, result
from sketchkit.grading.checks.marks import MarkCurve, Measure, read_curve
from sketchkit.grading.checks.trace import COUNTED, count
from sketchkit.grading.evidence import Trace
from sketchkit.grading.results import CheckResult

MEASURES = ("draw_calls", "vertices")
NONE_AT = 2.0  # times the limit
LEAST_TIME_S = 1.0  # what a busy computer may lose by itself


@dataclass(frozen=True)
class PerformanceRule:
    """What a frame may need.

    Attributes
    ----------
    limits : dict of str to Amount or None
        Of `MEASURES`; None stands for no more than the reference.
    time_s : float or None
        Processor time of the whole run.
    curve : MarkCurve
        Over how many times a limit is exceeded.
    """

    limits: dict[str, Amount | None]
    time_s: float | None
    curve: MarkCurve


def read(table: Table, _: Check) -> PerformanceRule:
    """Return the limits in a check's table."""
    limits = {key: read_amount(table, key) for key in MEASURES if key in table}
    time_s = table.number("time", 0.0, least=LEAST_TIME_S) if "time" in table else None
    if not limits:
        alone = "Time differs between computers: it never counts alone." if time_s else ""
        raise table.error(
            f"A performance check needs {either(MEASURES)}. {alone}".rstrip(),
            "time" if time_s else None,
            'Write draw_calls = "<= 20".',
        )
    return PerformanceRule(limits, time_s, read_curve(table, Measure.EXCESS, NONE_AT))


def needs(check: Check, _: PerformanceRule) -> tuple[Run, ...]:
    """Return the run whose drawing is counted."""
    return (Run(check.events, traced=check.frames, last_frame=check.frames[-1]),)


def basis(rule: PerformanceRule) -> Basis:
    """Return whether a reference is looked at."""
    return Basis.SKETCH if None in rule.limits.values() else Basis.NOTHING


def judge(case: Case, rule: PerformanceRule) -> CheckResult:
    """Return the mean over measures of the mean over frames."""
    reasons: list[str] = []
    scores = [_frames_score(case, rule, measure, reasons) for measure in rule.limits]
    if rule.time_s is not None:
        scores.append(_time_score(case, rule, rule.time_s, reasons))
    return result(case.check, fmean(scores), rule.curve, reasons)


def _frames_score(case: Case, rule: PerformanceRule, measure: str, reasons: list[str]) -> float:
    """Return the mean over frames for one measure; problems are added to the reasons."""
    found = [_frame(case, rule, measure, number) for number in case.check.frames]
    problems = [reason for _, reason in found if reason]
    reasons += [first_of(problems)] if problems else []
    return fmean(score for score, _ in found)


def _frame(case: Case, rule: PerformanceRule, measure: str, number: int) -> tuple[float, str]:
    """Return the score of a frame, and the problem with it, or ""."""
    trace = case.run.traces.get(number)
    if trace is None:
        return 0.0, missing_trace(case.run, number)
    if trace.vertices == 0:
        return 0.0, f"Nothing is drawn in frame {number}."
    amounts = list(_limits(case, rule, measure, number))
    distance = min((_distance(trace, measure, amount) for amount in amounts), default=math.inf)
    if distance <= 1:
        return rule.curve.score(distance), ""
    allowed = either(dict.fromkeys(map(str, amounts))) or "unknown"
    used = f"{count(trace, measure):,}"
    words = f"{COUNTED[measure]} in frame {number}: {used}. Expected: {allowed}."
    return rule.curve.score(distance), words


def _limits(case: Case, rule: PerformanceRule, measure: str, number: int) -> Iterator[Amount]:
    """Yield what is allowed: as much as any of the references needs, if they are the measure."""
    limit = rule.limits[measure]
    if limit is not None:
        yield limit
        return
    for run in case.reference_runs():
        if number in run.traces:
            yield Amount(0, count(run.traces[number], measure))


def _distance(trace: Trace, measure: str, amount: Amount) -> float:
    """Return how many times a limit is exceeded, or fallen short of."""
    found = count(trace, measure)
    if found in amount:
        return 0.0
    if found < amount.low:
        return amount.low / found if found else math.inf
    return found / amount.high if amount.high else math.inf


def _time_score(case: Case, rule: PerformanceRule, time_s: float, reasons: list[str]) -> float:
    last = case.check.frames[-1]
    if last not in case.run.traces or case.run.traces[last].vertices == 0:
        return 0.0
    if case.run.seconds > time_s:
        reasons.append(f"It takes {case.run.seconds:.1f} s of computing; {time_s:g} s are allowed.")
    return rule.curve.score(case.run.seconds / time_s)


KIND = Kind(read, needs, judge, basis)
