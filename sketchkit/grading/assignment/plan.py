"""What has to be run for an assignment, of submissions and of references alike."""

from __future__ import annotations

from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.run import Run, merged
from sketchkit.grading.checks.kinds import KINDS


def runs(assignment: Assignment) -> tuple[Run, ...]:
    """Return the runs, one for each file of events; none if only the source is looked at."""
    parts = (KINDS[check.kind].needs(check, check.options) for check in assignment.checks)
    return merged(part for needed in parts for part in needed)
