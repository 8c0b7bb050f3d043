"""The table: rounds of figures as Markdown, with ratios to the other contestants."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

from benchmarks.rounds import Figure, Results


def results_table(results: Results, others: Sequence[str], own: str = "sketchkit") -> str:
    """Return one row for each workload and number of samples.

    Figures are medians over the rounds. A ratio says how many times as long the other needed, of
    the medians and, in brackets, of each one's best round: above 1, sketchkit is faster. A dash
    stands for one that was not through in the time that it had.
    """
    head = ["workload", "samples", "calls", "flush", "total"]
    for other in others:
        head += [f"{other} calls", "total", "ratio"]
    rows = [head, ["---", *["--:"] * (len(head) - 1)]]
    for (workload, samples), figures in results.items():
        ours = figures[own]
        calls, total = median(ours.calls), median(ours.totals)
        row = [workload, str(samples), _ms(calls), _ms(total - calls), f"**{_ms(total)}**"]
        for other in others:
            row += _comparison(figures.get(other), ours)
        rows.append(row)
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def largest_spread(results: Results) -> str:
    """Return how far apart the rounds of one contestant were at most, as a sentence."""
    spread, name, workload = max(
        (figure.spread, name, workload)
        for (workload, _), row in results.items()
        for name, figure in row.items()
    )
    return f"Slowest round by fastest, at most: {spread:.2f} ({name}, {workload})."


def _comparison(theirs: Figure | None, ours: Figure) -> list[str]:
    if theirs is None:
        return ["-", "-", "-"]
    ratio = median(theirs.totals) / median(ours.totals)
    best = min(theirs.totals) / min(ours.totals)
    calls, total = median(theirs.calls), median(theirs.totals)
    return [_ms(calls), _ms(total), f"{ratio:.2f} ({best:.2f})"]


def _ms(value: float) -> str:
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"
