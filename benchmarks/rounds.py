"""Interleaved rounds: every contestant draws a workload in turn, again and again."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median

from benchmarks.contestants import Contestant


@dataclass(frozen=True)
class Figure:
    """What a contestant needed for a workload: the median frame of each round, in ms."""

    calls: Sequence[float]
    totals: Sequence[float]

    @property
    def spread(self) -> float:
        """How far apart the rounds were: the slowest by the fastest."""
        return max(self.totals) / min(self.totals)


Results = dict[tuple[str, int], dict[str, Figure]]  # by workload and samples, then contestant


@dataclass(frozen=True)
class Plan:
    """What is measured, how often, and for how long at a time."""

    workloads: Sequence[str]
    samples: Sequence[int]
    rounds: int
    seconds: float


def measure(contestants: Sequence[Contestant], plan: Plan, say: Callable[[str], None]) -> Results:
    """Return what each contestant needed for each workload.

    One after the other draws the same workload, then the next workload comes, and so on for each
    round: what else happens on the machine meets all of them alike. Who takes too long for a
    workload is left out of it.
    """
    too_slow: set[tuple[str, str]] = set()
    medians: dict[tuple[str, int], dict[str, list[tuple[float, float]]]] = {}
    for number in range(plan.rounds):
        for workload in plan.workloads:
            for samples in plan.samples:
                row = medians.setdefault((workload, samples), {})
                for contestant in contestants:
                    if (contestant.name, workload) in too_slow:
                        continue
                    say(f"round {number + 1}: {workload}, {samples} samples, {contestant.name}")
                    times = contestant.run(workload, samples, plan.seconds)
                    if times is None:
                        too_slow.add((contestant.name, workload))
                        continue
                    frame = median(times.calls_ms), median(times.total_ms)
                    row.setdefault(contestant.name, []).append(frame)
    return {
        case: {name: _figure(pairs) for name, pairs in row.items()} for case, row in medians.items()
    }


def _figure(pairs: Sequence[tuple[float, float]]) -> Figure:
    calls, totals = zip(*pairs, strict=True)
    return Figure(calls, totals)
