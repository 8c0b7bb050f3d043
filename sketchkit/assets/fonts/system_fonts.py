"""The fonts that this computer has: their names and files.

Only a sketch that names one gets one, for pictures have to look the same everywhere.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from sketchkit.assets.fonts.letters import open_outlines

PLAIN = ("Regular", "Book", "Roman", "Normal")  # styles that a font's name does not mention
ENDINGS = (".ttf", ".otf")


def font_names() -> list[str]:
    """Return the names of all fonts, in alphabetical order."""
    return sorted({name for name, _ in _fonts()}, key=str.lower)


def font_file(name: str) -> str | None:
    """Return the file of a font; None if there is none.

    Parameters
    ----------
    name : str
        As `font_names()` has it, or with `-` and no spaces, "DejaVuSans-Bold"; capitals do not
        matter.
    """
    wanted = _plain(name)
    return next((str(path) for found, path in _fonts() if _plain(found) == wanted), None)


def _plain(name: str) -> str:
    return "".join(letter for letter in name.lower() if letter not in " -_")


@lru_cache(maxsize=1)
def _fonts() -> tuple[tuple[str, Path], ...]:
    """Return name and file of each font; looked for once."""
    return tuple((name, path) for path in _files() if (name := _name(path)))


def _files() -> Iterator[Path]:
    for folder in font_folders():
        for path in sorted(folder.rglob("*")):
            if path.suffix.lower() in ENDINGS:
                yield path


def font_folders(platform: str = sys.platform) -> list[Path]:
    """Return the folders in which a system keeps fonts, those of the user last."""
    home = Path.home()
    if platform == "darwin":
        libraries = Path("/System/Library"), Path("/Library"), home / "Library"
        return [library / "Fonts" for library in libraries]
    if platform == "win32":
        windows = Path(os.environ.get("WINDIR", r"C:\Windows"))
        local = Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local"))
        return [windows / "Fonts", local / "Microsoft" / "Windows" / "Fonts"]
    shared = os.environ.get("XDG_DATA_DIRS", "/usr/local/share:/usr/share").split(":")
    own = os.environ.get("XDG_DATA_HOME", home / ".local" / "share")
    return [*(Path(folder) / "fonts" for folder in shared), Path(own) / "fonts", home / ".fonts"]


def _name(path: Path) -> str | None:
    """Return a font's name, with its style unless that is the plain one; None for no font."""
    try:
        family, style = open_outlines(str(path), 12).getname()
    except OSError:
        return None
    if not family:
        return None
    return family if style in (None, *PLAIN) else f"{family} {style}"
