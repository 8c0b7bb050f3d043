"""The workloads: sketches that do one thing many times. Each file begins with its short name."""

from __future__ import annotations

from pathlib import Path


def files() -> dict[str, Path]:
    """Return the file of each workload by its short name: W0, W1, W1s, ..."""
    sketches = sorted(Path(__file__).parent.glob("w*.py"))
    return {_capitalised(sketch.stem.partition("_")[0]): sketch for sketch in sketches}


def file_of(workload: str) -> Path:
    """Return the file of a workload."""
    return files()[workload]


def title_of(workload: str) -> str:
    """Return what a workload does, in words."""
    first_line = file_of(workload).read_text(encoding="utf-8").splitlines()[0]
    return first_line.strip('"').partition(": ")[2].rstrip(".")


def _capitalised(name: str) -> str:
    return name[0].upper() + name[1:]
