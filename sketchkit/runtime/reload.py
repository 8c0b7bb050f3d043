"""Has one of the sketch's files been saved? A look at their times, once a frame: 1 µs a file.

And if so: can the new text take the place of the old one while the sketch goes on?
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from sketchkit.runtime.carrying import begins_alike
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.report import StoppedError, reporting
from sketchkit.runtime.source import PYTHON_MODE, Source

Stamp = tuple[int, int, int] | None  # time of the last change in ns, size, number; None: no file


class Watch:
    """Notices when files change.

    Editors empty a file and then write it, or take it away and put another one there, and save
    several at once. So a change counts when all files have been the same for two looks.
    """

    def __init__(self, files: Iterable[Path]) -> None:
        self._stamps = {path: _stamp(path) for path in files}
        self._fresh: Mapping[Path, Stamp] = {}  # what has changed since, as it was at the last look

    def add(self, files: Iterable[Path]) -> None:
        """Look at these files as well, as they are from now on."""
        for path in files:
            if path not in self._stamps:
                self._stamps[path] = _stamp(path)

    def changed(self) -> list[Path]:
        """Return the files that have changed since the last time, exist, and are at rest."""
        stamps = {path: _stamp(path) for path in self._stamps}
        fresh = {path: new for path, new in stamps.items() if new and new != self._stamps[path]}
        is_at_rest, self._fresh = fresh == self._fresh, fresh
        if not is_at_rest:
            return []
        self._stamps.update(fresh)
        return list(fresh)


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


def exchange(loop: Loop, changed: Collection[Path]) -> bool:
    """Let the new text of a running sketch take the place of the old one, if that is possible.

    It is not if the text of `setup()` has changed, if there is no `draw()`, or if other files than
    texts have changed: then it must begin anew.

    Raises
    ------
    StoppedError
        If the new text's own lines stop by a mistake: the old one is there as before.
    """
    program = loop.program
    if not (
        changed
        and program.has("draw")
        and all(path.suffix in (".py", PYTHON_MODE) for path in changed)
    ):
        return False
    new = Source.read(program.source.path, program.source.python)
    if not begins_alike(program.source, new):
        return False
    try:
        with reporting(program.source.path, program), loop.running_first_lines():
            program.exchange(new)
    except StoppedError:
        program.put_back()
        raise
    return True


def _stamp(path: Path) -> Stamp:
    try:
        status = path.stat()
    except OSError:
        return None
    if status.st_size == 0:
        return None  # it is being written
    return status.st_mtime_ns, status.st_size, status.st_ino
