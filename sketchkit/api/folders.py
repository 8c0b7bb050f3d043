"""Where files are: full paths in the sketch's folder and its `data` folder, and lists of them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.core.errors import SketchError, nearest, shown

OPTIONS = ("directories", "files", "hidden", "recursive", "relative")


class FilePath(str):
    """The full path of a file: a text, with the methods of Java's File that sketches call."""

    __slots__ = ()

    def getAbsolutePath(self) -> str:
        """Return the path.

        Examples
        --------
        >>> dataFile("poem.txt").getAbsolutePath() == dataPath("poem.txt")
        True
        """
        return str(self)

    def getPath(self) -> str:
        """Return the path.

        Examples
        --------
        >>> dataFile("poem.txt").getPath() == dataPath("poem.txt")
        True
        """
        return str(self)

    def getName(self) -> str:
        """Return the last part of the path.

        Examples
        --------
        >>> dataFile("poem.txt").getName()
        'poem.txt'
        """
        return Path(self).name

    def getParent(self) -> str:
        """Return the folder that the file lies in.

        Examples
        --------
        >>> dataFile("poem.txt").getParent() == dataPath("")
        True
        """
        return str(Path(self).parent)

    def exists(self) -> bool:
        """Return whether there is such a file or folder.

        Examples
        --------
        >>> dataFile("poem.txt").exists()
        True
        """
        return Path(self).exists()

    def isFile(self) -> bool:
        """Return whether it is a file, and no folder.

        Examples
        --------
        >>> dataFile("poem.txt").isFile()
        True
        """
        return Path(self).is_file()

    def isDirectory(self) -> bool:
        """Return whether it is a folder.

        Examples
        --------
        >>> dataFile("poem.txt").isDirectory()
        False
        """
        return Path(self).is_dir()

    def length(self) -> int:
        """Return how many bytes the file has; 0 if there is none.

        Examples
        --------
        >>> dataFile("poem.txt").length() > 0
        True
        """
        return Path(self).stat().st_size if Path(self).exists() else 0

    def listFiles(self) -> list[FilePath]:
        """Return the files and folders in a folder.

        Examples
        --------
        >>> "poem.txt" in [file.getName() for file in dataFile("").listFiles()]
        True
        """
        return [FilePath(path) for path in sorted(Path(self).iterdir())]


class Folders(SketchParts):
    """`dataFile()`, `savePath()`, `listPaths()` and the like."""

    def sketchFile(self, where: str = "") -> FilePath:
        """Return the full path of a file in the sketch's folder.

        Parameters
        ----------
        where : str
            The file's name; with none it is the folder itself.

        See Also
        --------
        sketchPath, dataFile, saveFile

        Notes
        -----
        The path is a text that has `exists()`, `getName()` and the like as well.

        Examples
        --------
        >>> sketchFile("notes.txt").exists()
        False
        """
        return FilePath(self.folder / where)

    def dataFile(self, where: str = "") -> FilePath:
        """Return the full path of a file in the sketch's `data` folder.

        Parameters
        ----------
        where : str
            The file's name; with none it is the folder itself.

        See Also
        --------
        dataPath, sketchFile

        Notes
        -----
        The path is a text that has `exists()`, `getName()` and the like as well.

        Examples
        --------
        >>> dataFile("poem.txt").exists()
        True
        """
        return FilePath(self.folder / "data" / where)

    def savePath(self, where: str) -> str:
        """Return the full path of a file that the sketch will write, and make its folders.

        Parameters
        ----------
        where : str
            The file's name, in the sketch's folder.

        See Also
        --------
        saveFile, sketchPath, saveStrings

        Examples
        --------
        >>> path = savePath("results/scores.txt")
        >>> with open(path, "w") as file:
        ...     chars = file.write("anna 12")
        """
        path = self.folder / where
        path.parent.mkdir(parents=True, exist_ok=True)
        return str(path)

    def saveFile(self, where: str) -> FilePath:
        """Return what `savePath()` does, as a path that has `exists()`, `getName()` and the like.

        Examples
        --------
        >>> saveFile("results/scores.txt").exists()
        False
        """
        return FilePath(self.savePath(where))

    def listPaths(self, path: str, *options: str) -> list[str]:
        """Return the full paths of the files in a folder, in the order of their names.

        Parameters
        ----------
        path : str
            The folder, seen from the sketch's own.
        *options : str
            `"files"` or `"directories"` for these alone, `"recursive"` for what lies in folders
            within, `"hidden"` for names that begin with a dot, `"extension=png"` or
            `"extensions=png|jpg"` for some kinds, `"relative"` for paths seen from the folder.

        See Also
        --------
        listFiles, dataPath

        Examples
        --------
        >>> listPaths("data", "extension=txt", "relative")
        ['poem.txt']
        """
        folder = self.folder / path
        paths = self.listFiles(path, *options)
        return [os.path.relpath(p, folder) if "relative" in options else str(p) for p in paths]

    def listFiles(self, path: str, *options: str) -> list[FilePath]:
        """Return the files in a folder, as paths that have `getName()` and the like.

        Parameters
        ----------
        path : str
            The folder, seen from the sketch's own.
        *options : str
            As those of `listPaths()`.

        Examples
        --------
        >>> [file.getName() for file in listFiles("data", "extensions=txt|svg")]
        ['house.svg', 'poem.txt']
        """
        endings = _endings(options)
        only_files = "files" in options and "directories" not in options
        only_folders = "directories" in options and "files" not in options
        return [
            FilePath(file)
            for file in _within(self.folder / path, options)
            if not (only_files and file.is_dir())
            and not (only_folders and not file.is_dir())
            and (not endings or file.is_dir() or file.suffix.lower() in endings)
        ]


def _within(folder: Path, options: Sequence[str]) -> Iterator[Path]:
    """Yield what is in a folder, in the order of the names."""
    if not folder.is_dir():
        raise SketchError(f"There is no folder {folder}.", hint="A path begins in the sketch's.")
    for path in sorted(folder.iterdir()):
        if path.name.startswith(".") and "hidden" not in options:
            continue
        yield path
        if path.is_dir() and "recursive" in options:
            yield from _within(path, options)


def _endings(options: Sequence[str]) -> set[str]:
    """Return the endings that are wanted; none if all are.

    Raises
    ------
    SketchError
        If there is an option that is none.
    """
    endings: set[str] = set()
    for option in options:
        name, _, value = str(option).partition("=")
        if name in ("extension", "extensions"):
            endings |= {f".{ending.lower()}" for ending in value.split("|")}
        elif option not in OPTIONS:
            known = nearest(str(option), [*OPTIONS, "extension=png"])
            raise SketchError(
                f"{shown(option)} is no option of listPaths() and listFiles().",
                hint=f"Do you mean {known!r}?" if known else f"There are {', '.join(OPTIONS)}.",
            )
    return endings
