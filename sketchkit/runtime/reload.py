"""Has one of the sketch's files been saved? A look at their times, once a frame: 1 µs a file."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from sketchkit.runtime.source import Source

Stamp = tuple[int, int] | None  # time of the last change in ns, and size; None for no file


class Watch:
    """Notices when files change."""

    def __init__(self, files: Iterable[Path]) -> None:
        self._stamps = {path: _stamp(path) for path in files}

    def add(self, files: Iterable[Path]) -> None:
        """Look at these files as well, as they are from now on."""
        for path in files:
            if path not in self._stamps:
                self._stamps[path] = _stamp(path)

    def changed(self) -> list[Path]:
        """Return the files that have changed since the last time, and exist."""
        changed = []
        for path, old in self._stamps.items():
            if (new := _stamp(path)) != old:
                self._stamps[path] = new
                if new:  # editors may take a file away for a moment
                    changed.append(path)
        return changed


def compile_all(files: Iterable[Path], python: int | None = None) -> None:
    """Read changed files as Python, so that a broken one is found before the old one is left.

    Parameters
    ----------
    files : iterable of Path
        Which.
    python : 2 or 3, optional
        Which Python they are written in.

    Raises
    ------
    SyntaxError, OSError
        As `Source.read` does.
    """
    for path in files:
        Source.read(path, python)


def _stamp(path: Path) -> Stamp:
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size
