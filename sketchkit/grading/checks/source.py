"""The check `source`: what is called, defined and used, by the syntax trees of the files.

What is wanted earns; what is forbidden only takes away, since an empty sketch has none of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from statistics import fmean

from sketchkit.core.errors import either, nearest
from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.case import Basis, Case, Kind, result
from sketchkit.grading.checks.marks import MarkCurve, Measure, read_curve
from sketchkit.grading.evidence import SourceFacts
from sketchkit.grading.results import CheckResult

Group = tuple[str, ...]  # any one of these will do


@dataclass(frozen=True)
class SourceRule:
    """What is looked for; each group is one part of the marks.

    Attributes
    ----------
    calls, defines, uses : tuple of groups
        Of a group any one will do. `*` stands for any letters.
    forbids : tuple of str
    """

    calls: tuple[Group, ...]
    defines: tuple[Group, ...]
    uses: tuple[Group, ...]
    forbids: tuple[str, ...]
    curve: MarkCurve


def read(table: Table, _: Check) -> SourceRule:
    """Return what is looked for, from a check's table."""
    calls, defines, uses = (_read_groups(table, key) for key in ("calls", "defines", "uses"))
    forbids = table.texts("forbids")
    if not (calls or defines or uses):
        why = "An empty sketch would fulfil forbids alone." if forbids else ""
        raise table.error(
            f"A source check needs calls, defines or uses. {why}".rstrip(),
            "forbids" if forbids else None,
            'Write calls = ["rotateY"].',
        )
    return SourceRule(calls, defines, uses, forbids, read_curve(table, Measure.SHARE))


def needs(_: Check, __: SourceRule) -> tuple[Run, ...]:
    """Return no run: the source is read, not run."""
    return ()


def judge(case: Case, rule: SourceRule) -> CheckResult:
    """Return the share of what is found, less the share of what is forbidden and found."""
    facts = case.submission.source
    problems = [
        *(_missing_call(facts, group) for group in rule.calls),
        *(_missing_definition(facts, group) for group in rule.defines),
        *(_missing_use(facts, group) for group in rule.uses),
    ]
    breaches = [_breach(facts, name) for name in rule.forbids]
    kept = fmean(not breach for breach in breaches) if breaches else 1.0
    share = fmean(not problem for problem in problems) * kept
    return result(case.check, rule.curve.score(1 - share), rule.curve, [*problems, *breaches])


def _missing_call(facts: SourceFacts, group: Group) -> str:
    """Return a sentence if none of a group is called."""
    return _missing(
        group, facts.calls, lambda name: f"{name.removesuffix('()')}()", "is called", "called"
    )


def _missing_definition(facts: SourceFacts, group: Group) -> str:
    defined = {*facts.functions, *(f"class {name}" for name in facts.classes)}
    return _missing(group, defined, _definition, "is defined", "defined")


def _missing_use(facts: SourceFacts, group: Group) -> str:
    used = {*facts.statements, *facts.names, *facts.calls}
    return _missing(group, used, str, "is used", "used")


def _missing(
    group: Group, found: Iterable[str], spelt: Callable[[str], str], verb: str, participle: str
) -> str:
    names = list(found)
    patterns = [_bare(pattern) for pattern in group]
    if any(fnmatchcase(name, pattern) for pattern in patterns for name in names):
        return ""
    if len(group) > 1:
        wanted = either(spelt(pattern) for pattern in patterns)
        return f"None of these {verb} in your code: {wanted}."
    near = nearest(patterns[0], names)
    hint = f" There is {spelt(near)}: is that what you mean?" if near else ""
    return f"{spelt(patterns[0])} is not {participle} in your code.{hint}"


def _definition(name: str) -> str:
    return name if name.startswith("class ") else f"{name}()"


def _breach(facts: SourceFacts, name: str) -> str:
    """Return a sentence if something forbidden is found."""
    every = {*facts.calls, *facts.names, *facts.statements, *facts.functions, *facts.classes}
    pattern = _bare(name)
    found = next((other for other in sorted(every) if fnmatchcase(other, pattern)), None)
    return f"{found} is used, which is not allowed here." if found else ""


def _bare(name: str) -> str:
    """Return a name without what an instructor may write around it: `def draw`, `rect()`."""
    return name.removeprefix("def ").removesuffix("()").strip()


def _read_groups(table: Table, key: str) -> tuple[Group, ...]:
    """Return the groups of a list: a text in it is a group of one."""
    value = table.value(key)
    items = value if isinstance(value, list) else [value] if value is not None else []
    return tuple(_groups(table, key, items))


def _groups(table: Table, key: str, items: Iterable[object]) -> Iterator[Group]:
    for item in items:
        members = item if isinstance(item, list) else [item]
        group = tuple(name for name in members if isinstance(name, str) and name.strip())
        if not group or len(group) < len(members):
            raise table.error(
                f"{key} is a list of names.",
                key,
                f'Write {key} = ["a", ["b", "c"]]: a, and any one of b and c.',
            )
        yield group


KIND = Kind(read, needs, judge, lambda _: Basis.NOTHING, has_frames=False)
