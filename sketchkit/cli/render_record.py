"""What a render was made with and what it cost, for `--json`."""

from __future__ import annotations

import json
import platform
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from sketchkit import __version__
from sketchkit.assets.output import write_file
from sketchkit.core.clock import RENDER_DATE
from sketchkit.draw.backend import Backend
from sketchkit.runtime.headless import Frame
from sketchkit.runtime.report import Report

PACKAGES = ("glfw", "moderngl", "numpy", "pillow")


@dataclass
class Record:
    """Collects what happened.

    Attributes
    ----------
    frames : list of dict
        One for each picture, of all sketches.
    remarks, mistakes : list of dict
        What was told about the sketches.
    """

    backend: Backend
    seed: int
    frames: list[dict[str, object]] = field(default_factory=list)
    remarks: list[dict[str, object]] = field(default_factory=list)
    mistakes: list[dict[str, object]] = field(default_factory=list)

    def add_frame(self, sketch: Path, frame: Frame, file: Path) -> None:
        """Keep what is known about a picture."""
        height, width, _ = frame.pixels.shape
        self.frames.append(
            {
                "sketch": str(sketch),
                "frame": frame.number,
                "file": str(file),
                "width": width,
                "height": height,
                "draw_calls": frame.draw_calls,
                "vertices": frame.vertices,
                "ms": frame.elapsed_ms,
                "repeats": frame.repeats,
            }
        )

    def add_remark(self, path: Path, line: int, text: str) -> None:
        """Keep something that was told about a sketch."""
        self.remarks.append({"file": str(path), "line": line, "text": text})

    def add_mistake(self, sketch: Path, report: Report) -> None:
        """Keep why a sketch stopped."""
        self.mistakes.append(
            {
                "sketch": str(sketch),
                "file": str(report.path),
                "line": report.line,
                "text": report.message,
            }
        )

    def write(self, path: Path) -> None:
        """Write all of it as JSON."""
        content = {
            "renderer": self.backend.name,
            "driver": self.backend.describe(),
            "versions": _versions(),
            "seed": self.seed,
            "date": RENDER_DATE.isoformat(),
            "frames": self.frames,
            "remarks": self.remarks,
            "mistakes": self.mistakes,
        }
        write_file(path, (json.dumps(content, indent=2) + "\n").encode())


def _versions() -> dict[str, str]:
    versions = {
        "sketchkit": __version__,
        "python": platform.python_version(),
        "system": platform.platform(),
    }
    for package in PACKAGES:
        try:
            versions[package] = version(package)
        except PackageNotFoundError:
            continue
    return versions
