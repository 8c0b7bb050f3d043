"""The benchmarks still run, and their table says what it should."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.call_cost import NoBackend
from benchmarks.rounds import Figure
from benchmarks.table import largest_spread, results_table
from benchmarks.workloads import files, title_of
from sketchkit.runtime.headless import Launch, render

# In their second frame: an empty one, a shape that was sent in the first, and pixels.
SENDING_NOTHING = ("W0", "W5", "W10")


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path.name}, line {line}: {text}")


@pytest.mark.parametrize("workload", files())
def test_workload_goes_out_in_few_draws(workload: str) -> None:
    launch = Launch(files()[workload], refuse)

    (frame,) = render(launch, [2], NoBackend(), looks=False)  # nothing is drawn

    assert frame.draw_calls <= 4
    assert (frame.vertices >= 4_000) == (workload not in SENDING_NOTHING)


def test_title_is_the_first_line_without_the_short_name() -> None:
    assert title_of("W0") == "nothing but a background"


def test_ratios_are_of_medians_and_of_best_rounds() -> None:
    results = {
        ("W1", 4): {
            "sketchkit": Figure(calls=[2, 3, 4], totals=[8, 10, 12]),
            "py5": Figure(calls=[20, 20, 20], totals=[40, 40, 60]),
        }
    }

    table = results_table(results, ["py5"])

    assert table.splitlines()[2] == (
        "| W1 | 4 | 3.00 | 7.00 | **10.0** | 20.0 | 40.0 | 4.00 (5.00) |"
    )
    assert largest_spread(results) == "Slowest round by fastest, at most: 1.50 (sketchkit, W1)."


def test_table_has_dashes_for_who_was_too_slow() -> None:
    results = {("W5", 1): {"sketchkit": Figure([3.0], [10.0])}}

    assert results_table(results, ["py5"]).endswith("| **10.0** | - | - | - |")
