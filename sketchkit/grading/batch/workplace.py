"""The folder of results: reports for people, and beneath `cache` what need not be done twice."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Workplace:
    """Where everything is.

    Attributes
    ----------
    folder : Path
        Absolute.
    """

    folder: Path

    @property
    def renders(self) -> Path:
        """Pictures and traces, by what they were made from."""
        return self.folder / "cache" / "renders"

    @property
    def differences(self) -> Path:
        """Heat maps, by submission."""
        return self.folder / "cache" / "differences"

    @property
    def results(self) -> Path:
        """One file for each submission that has been judged."""
        return self.folder / "cache" / "results"

    @property
    def staging(self) -> Path:
        """The submissions, unpacked."""
        return self.folder / "cache" / "staging"

    @property
    def _work(self) -> Path:
        return self.folder / "cache" / "work"

    def clear(self) -> None:
        """Throw away what an earlier batch that was killed has left half-done."""
        for leftover in (self._work, self.staging):
            shutil.rmtree(leftover, ignore_errors=True)

    @contextmanager
    def workshop(self) -> Iterator[Path]:
        """Make a folder that is gone at the end of the block."""
        self._work.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self._work, ignore_cleanup_errors=True) as folder:
            yield Path(folder)

    def relative(self, path: Path | None) -> Path | None:
        """Return where a file is, seen from the folder of results."""
        return None if path is None else path.relative_to(self.folder)
