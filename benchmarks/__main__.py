"""`python -m benchmarks`: measures, and prints tables in Markdown."""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path
from statistics import median

from benchmarks import contestants, workloads
from benchmarks.call_cost import call_cost, memory
from benchmarks.contestants import Contestant
from benchmarks.machine import load, machine, remark_on_load
from benchmarks.rounds import Plan, measure
from benchmarks.start_up import start_up
from benchmarks.table import largest_spread, results_table

CPU_WORKLOADS = ("W1", "W3")


def main() -> None:
    """Measure what the command line asks for."""
    options = _options()
    plan = Plan(options.workloads, options.samples, options.rounds, options.seconds)
    before = load()
    print(machine(), "", remark_on_load(before), "", sep="\n", flush=True)
    if "frames" in options.parts:
        _print_frames(plan, options.py5_python, options.java)
    if "cpu" in options.parts:
        _print_cpu(plan)
    if "calls" in options.parts:
        _print_call_cost()
    if "start" in options.parts:
        _print_start_up(options.rounds)


def _options() -> argparse.Namespace:
    every = tuple(workloads.files())
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--workloads", nargs="+", choices=every, default=every, metavar="W")
    parser.add_argument("--samples", nargs="+", type=int, choices=(1, 4), default=(1, 4))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument(
        "--seconds", type=float, default=1.0, help="for one run, after as many to warm up"
    )
    parser.add_argument(
        "--py5-python", type=Path, default=Path(sys.executable), help="a Python that has py5"
    )
    parser.add_argument("--java", default="java", help="the command that runs Java 17")
    parts = ("frames", "cpu", "calls", "start")
    parser.add_argument("--parts", nargs="+", choices=parts, default=parts)
    return parser.parse_args()


def _print_frames(plan: Plan, python: Path, java: str) -> None:
    print("## Frames, 640 x 480, in milliseconds\n")
    for workload in plan.workloads:
        print(f"- {workload}: {workloads.title_of(workload)}")
    with tempfile.TemporaryDirectory() as classes, contestants.display():
        others = _others(python, java, Path(classes))
        results = measure([contestants.sketchkit(), *others], plan, _progress)
    print("", results_table(results, [other.name for other in others]), sep="\n")
    print(f"\n{plan.rounds} rounds, interleaved. {largest_spread(results)}\n", flush=True)


def _others(python: Path, java: str, classes: Path) -> list[Contestant]:
    found = [contestants.processing(python, java, classes), contestants.py5(python)]
    for name, contestant in zip(("Processing", "py5"), found, strict=True):
        if contestant is None:
            print(f"\n{name} is not here, or is not found: see --py5-python and --java.")
    return [contestant for contestant in found if contestant is not None]


def _print_cpu(plan: Plan) -> None:
    print("## CPU renderer, in milliseconds\n")
    cpu = contestants.sketchkit("cpu")
    chosen = [workload for workload in CPU_WORKLOADS if workload in plan.workloads]
    cpu_plan = Plan(chosen, plan.samples, plan.rounds, plan.seconds)
    print(results_table(measure([cpu], cpu_plan, _progress), [], own=cpu.name), "\n", flush=True)


def _print_call_cost() -> None:
    cost, size = call_cost(), memory()
    print("## One fill() and one rect()\n")
    print(f"- recorded in {cost.recorded:.0f} ns, expanded in {cost.expanded:.0f} ns;")
    print(f"  two empty Python calls: {cost.empty:.0f} ns")
    print(f"- {size.recorded:.0f} bytes recorded, {size.drawing:.0f} at most while it is drawn\n")


def _print_start_up(rounds: int) -> None:
    print("## Whole processes, in seconds\n")
    for name, seconds in start_up(rounds).items():
        print(f"- {name}: {median(seconds):.3f} (best {min(seconds):.3f})")


def _progress(text: str) -> None:
    """Show what is being measured, where a person looks on."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


main()
