"""Submissions for tests: a text becomes a folder that a job behind the wall may read."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from textwrap import dedent


def submission(folder: Path, text: str, others: Mapping[str, str] | None = None) -> Path:
    """Write a sketch, `sketch.py`, and the files beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in {"sketch.py": text, **(others or {})}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(dedent(content), encoding="utf-8")
    return folder
