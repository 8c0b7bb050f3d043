"""The staged copy of a submission: it takes in files one by one, and refuses too much of them."""

from __future__ import annotations

import hashlib
import os
import unicodedata
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

from sketchkit.grading.intake.naming import is_litter, safe_path
from sketchkit.grading.intake.submission import IntakeLimits, RefusedError

MEGABYTE = 1 << 20
SOURCES = (".py", ".pyde")


class Stage:
    """A folder that is being filled with a submission's files.

    Sizes are counted as the bytes arrive: what an archive says about itself is not believed.
    """

    def __init__(self, folder: Path, limits: IntakeLimits) -> None:
        self.folder = folder
        self._limits = limits
        self._places: dict[str, PurePosixPath] = {}  # by name with case ignored
        self._total = 0  # bytes
        self._digests: dict[str, str] = {}
        folder.mkdir(parents=True)
        folder.chmod(0o755)

    def add(self, name: str, chunks: Iterable[bytes]) -> None:
        """Take in a file.

        Parameters
        ----------
        name : str
            Its path as the submission has it.
        chunks : iterable of bytes
            Its content.

        Raises
        ------
        RefusedError
            If the name is not to be trusted, or it is too much.
        """
        if is_litter(PurePosixPath(name.replace("\\", "/"))):
            return
        path = safe_path(name, self._limits.depth)
        self._claim(path)
        for parent in path.parents[:-1]:
            self._claim(parent, is_folder=True)
        self._make_folders(path)
        self._digests[path.as_posix()] = self._store(path, chunks)

    @property
    def paths(self) -> list[PurePosixPath]:
        """The files that are there, sorted."""
        return sorted(map(PurePosixPath, self._digests))

    def digest(self) -> str:
        """Return a digest of the names and the contents of all files."""
        whole = hashlib.sha256()
        for name, digest in sorted(self._digests.items()):
            whole.update(f"{digest} {len(name)} ".encode())
            whole.update(name.encode("utf-8", "surrogateescape"))
        return whole.hexdigest()

    def _claim(self, path: PurePosixPath, *, is_folder: bool = False) -> None:
        """Refuse a second file of the same name, also one that is the same on some systems."""
        key = unicodedata.normalize("NFC", path.as_posix()).casefold()
        there = self._places.get(key)
        if there is not None and not (is_folder and there == path):
            raise RefusedError(
                f"Two files have one name, {str(there)!r} and {str(path)!r}: some computers "
                "cannot keep both."
            )
        self._places[key] = path
        if len(self._places) > self._limits.files:
            raise RefusedError(f"It has more than {self._limits.files} files and folders.")

    def _make_folders(self, path: PurePosixPath) -> None:
        folder = self.folder
        for part in path.parts[:-1]:
            folder /= part
            try:
                folder.mkdir(exist_ok=True)
                folder.chmod(0o755)
            except OSError as reason:
                raise RefusedError(
                    f"The folder {part!r} cannot be stored: {reason.strerror}."
                ) from None

    def _store(self, path: PurePosixPath, chunks: Iterable[bytes]) -> str:
        """Write a file; return the digest of its content."""
        target = self.folder / path
        try:
            file = os.open(target, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o644)
        except OSError as reason:
            raise RefusedError(
                f"The file {str(path)!r} cannot be stored: {reason.strerror}."
            ) from None
        digest = hashlib.sha256()
        size = 0
        with os.fdopen(file, "wb") as stream:
            for chunk in chunks:
                size += len(chunk)
                self._total += len(chunk)
                self._check_size(path, size)
                digest.update(chunk)
                stream.write(chunk)
        target.chmod(0o644)  # whatever the umask: the job that draws it is another user
        return digest.hexdigest()

    def _check_size(self, path: PurePosixPath, size: int) -> None:
        limits = self._limits
        if path.suffix.lower() in SOURCES and size > limits.source_kb * 1024:
            raise RefusedError(f"{str(path)!r} is more than {limits.source_kb} kB of Python.")
        if size > limits.file_mb * MEGABYTE:
            raise RefusedError(f"{str(path)!r} is larger than {limits.file_mb} MB.")
        if self._total > limits.total_mb * MEGABYTE:
            raise RefusedError(f"Its files are larger than {limits.total_mb} MB all together.")
