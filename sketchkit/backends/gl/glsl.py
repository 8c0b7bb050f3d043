"""The one place that finds our shader files."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

_PACKAGE = Path(__file__).parents[2]
# In a wheel the folder is inside the package; in a checkout it lies beside it.
_FOLDERS = (_PACKAGE / "shaders", _PACKAGE.parent / "shaders")
_INCLUDE = re.compile(r'^#include "(.+)"$', re.MULTILINE)


@cache
def source(name: str) -> str:
    """Return the text of a file in `shaders/`, with what it includes put in."""
    folder = next(folder for folder in _FOLDERS if (folder / name).is_file())
    text = (folder / name).read_text(encoding="utf-8")
    return _INCLUDE.sub(lambda found: source(f"include/{found[1]}"), text)
