"""The judge: from evidence to marks. It never runs, imports or parses a submission."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.checks.case import Case
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import CheckResult


def judge(
    check: Check, submission: Evidence, references: Mapping[str, Evidence], pictures: Path
) -> CheckResult:
    """Return a check's result for a submission.

    Parameters
    ----------
    check : Check
    submission : Evidence
    references : dict of str to Evidence
        By their names in the assignment; those that the check does not accept are not looked at.
    pictures : Path
        The folder where heat maps are written. Paths in the result are as the evidence has them,
        absolute: who writes reports copies the pictures and names them anew.
    """
    accepted = {name: references[name] for name in check.references if name in references}
    return KINDS[check.kind].judge(Case(check, submission, accepted, pictures), check.options)
