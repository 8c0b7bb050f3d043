"""The check `trace`: what is drawn, whatever it looks like: boxes, lights, nesting, shaders.

Expectations that a frame without any drawing fulfils, as "no rectangle", earn nothing: they take
away. So an empty sketch scores nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import fmean

from sketchkit.core.errors import either, nearest
from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.amount import Amount, exactly, read_amount
from sketchkit.grading.checks.case import Basis, Case, Kind, first_of, missing_trace, result
from sketchkit.grading.checks.marks import MarkCurve, Measure, read_curve
from sketchkit.grading.evidence import Trace
from sketchkit.grading.results import CheckResult

DRAWN_WITH = {
    "rect": "rect() or square()",
    "ellipse": "ellipse() or circle()",
    "shape": "beginShape()",
    "mesh": "shape()",
    "text": "text(), in letters",
    **{
        name: f"{name}()"
        for name in (
            "box",
            "sphere",
            "line",
            "triangle",
            "quad",
            "point",
            "arc",
            "image",
        )
    },
}
OTHER_NAMES = {"square": "rect", "circle": "ellipse", "beginShape": "shape", "PShape": "mesh"}
COUNTED = {
    "nesting": "Levels of pushMatrix() around what is drawn",
    "lights": "Lights that shine",
    "retained": "Different kept shapes (createShape(), loadShape()) that are drawn",
    "textures": "Different images that are drawn with",
    "canvases": "Different canvases (createGraphics()) that are drawn",
    "vertices": "Vertices",
    "draw_calls": "Draw calls",
}


@dataclass(frozen=True)
class Expectation:
    """How many of something are expected.

    Attributes
    ----------
    subject : str
        A key of `COUNTED`, or "kinds.box".
    amount : Amount or None
        None stands for "as in the reference".
    """

    subject: str
    amount: Amount | None


@dataclass(frozen=True)
class ShaderExpectation:
    """That something is drawn by a shader of the sketch's own.

    Attributes
    ----------
    name : str
        Of its file; "" for any.
    uniforms : tuple of str
        That the sketch gives to it.
    """

    name: str = ""
    uniforms: tuple[str, ...] = ()


@dataclass(frozen=True)
class TraceRule:
    """What a frame is expected to show; each expectation is one part of the marks."""

    expectations: tuple[Expectation, ...]
    shader: ShaderExpectation | None
    curve: MarkCurve


@dataclass(frozen=True)
class _Finding:
    """One expectation in one frame: whether it holds, whether it earns, and what to say if not."""

    is_met: bool
    earns: bool
    reason: str


def read(table: Table, _: Check) -> TraceRule:
    """Return the expectations in a check's table."""
    expectations = [
        *_read_kinds(table),
        *(Expectation(key, read_amount(table, key)) for key in COUNTED if key in table),
    ]
    shader = _read_shader(table)
    if not expectations and shader is None:
        raise table.error(
            "A trace check expects something.",
            hint=f"Give one of kinds, shader, {', '.join(COUNTED)}: lights = 2.",
        )
    return TraceRule(tuple(expectations), shader, read_curve(table, Measure.SHARE))


def needs(check: Check, _: TraceRule) -> tuple[Run, ...]:
    """Return the run whose drawing is looked at."""
    return (Run(check.events, traced=check.frames, last_frame=check.frames[-1]),)


def basis(rule: TraceRule) -> Basis:
    """Return whether a reference is looked at."""
    is_relative = any(expectation.amount is None for expectation in rule.expectations)
    return Basis.SKETCH if is_relative else Basis.NOTHING


def judge(case: Case, rule: TraceRule) -> CheckResult:
    """Return the mean of the frames' marks: in each the share of what is fulfilled."""
    scores: list[float] = []
    unmet: dict[str, list[str]] = {}  # by what is expected: the sentences, frame by frame
    for number in case.check.frames:
        trace = case.run.traces.get(number)
        if trace is None:
            scores.append(0.0)
            unmet.setdefault("", []).append(missing_trace(case.run, number))
            continue
        findings = dict(_findings(case, rule, number, trace))
        scores.append(rule.curve.score(1 - _share(list(findings.values()), trace)))
        for subject, finding in findings.items():
            if not finding.is_met:
                unmet.setdefault(subject, []).append(finding.reason)
    return result(case.check, fmean(scores), rule.curve, map(first_of, unmet.values()))


def _findings(
    case: Case, rule: TraceRule, number: int, trace: Trace
) -> Iterator[tuple[str, _Finding]]:
    """Yield each expectation's subject and how it stands with it in a frame."""
    for expectation in rule.expectations:
        amounts = _amounts(case, expectation, number)
        found = count(trace, expectation.subject)
        yield (
            expectation.subject,
            _Finding(
                any(found in amount for amount in amounts),
                not any(0 in amount for amount in amounts),
                f"{_noun(expectation.subject)} in frame {number}: {found:,}. "
                f"Expected: {either(dict.fromkeys(map(str, amounts))) or 'unknown'}.",
            ),
        )
    if rule.shader:
        reason = _shader_problem(rule.shader, trace, number)
        yield "shader", _Finding(not reason, True, reason)


def _amounts(case: Case, expectation: Expectation, number: int) -> list[Amount]:
    """Return what is accepted: of several references, what any of them has."""
    if expectation.amount is not None:
        return [expectation.amount]
    traces = (run.traces.get(number) for run in case.reference_runs())
    return [exactly(count(trace, expectation.subject)) for trace in traces if trace is not None]


def count(trace: Trace, subject: str) -> int:
    """Return how many of something a frame has: of "lights", or of "kinds.box"."""
    group, _, kind = subject.partition(".")
    number: int = trace.kinds.get(kind, 0) if kind else getattr(trace, group)
    return number


def _share(findings: Sequence[_Finding], trace: Trace) -> float:
    """Return the share of the marks that a frame earns, less what its breaches take away."""
    earning = [finding.is_met for finding in findings if finding.earns]
    conditions = [finding.is_met for finding in findings if not finding.earns]
    earned = fmean(earning) if earning else float(trace.vertices > 0 or bool(trace.kinds))
    return earned * (fmean(conditions) if conditions else 1.0)


def _shader_problem(expected: ShaderExpectation, trace: Trace, number: int) -> str:
    """Return why no shader is as expected, in a sentence; "" if one is."""
    named = {
        name: uniforms for name, uniforms in trace.shaders.items() if expected.name in ("", name)
    }
    if not named:
        which = expected.name or "a shader of your own"
        return f"Nothing is drawn with {which} in frame {number}: call shader() before drawing."
    lacking = min(
        (
            [uniform for uniform in expected.uniforms if uniform not in uniforms]
            for uniforms in named.values()
        ),
        key=len,
    )
    if not lacking:
        return ""
    return (
        f"The shader in frame {number} is not given {either(lacking)}: "
        f'call set("{lacking[0]}", ...) of it.'
    )


def _noun(subject: str) -> str:
    group, _, kind = subject.partition(".")
    return f"Drawn with {DRAWN_WITH[kind]}" if kind else COUNTED[group]


def _read_kinds(table: Table) -> Iterator[Expectation]:
    kinds = table.table("kinds", "kinds")
    if kinds is None:
        return
    for kind in kinds.entries():
        if kind not in DRAWN_WITH:
            known = OTHER_NAMES.get(kind) or nearest(kind, list(DRAWN_WITH))
            hint = f"Do you mean {known}?" if known else f"Kinds are {', '.join(DRAWN_WITH)}."
            raise kinds.error(f"{kind} is no kind of shape.", kind, hint)
        yield Expectation(f"kinds.{kind}", read_amount(kinds, kind))


def _read_shader(table: Table) -> ShaderExpectation | None:
    own = table.table("shader", "shader")
    if own is None:
        return None
    expected = ShaderExpectation(own.text("name", ""), own.texts("uniform"))
    own.finish()
    return expected


KIND = Kind(read, needs, judge, basis)
