"""The file of each face; the default one is part of a package of fonts."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files
from pathlib import Path


def file_of(path: str) -> str:
    """Return the file of a face; "" is the default one."""
    return path or _default()


@lru_cache(maxsize=1)
def _default() -> str:
    """Return the file of the default face: Processing's own is a copy of it."""
    return str(Path(str(files("font_source_sans_pro"))) / "files" / "SourceSansPro-Regular.ttf")
