"""What a sketch adds with `add_library(name)`: which libraries there are, and what they bring.

A library that sketchkit has is a module of this folder, in whose `__all__` are the names that the
sketch is to see, and a line of `LIBRARIES`.
"""

from __future__ import annotations

from collections.abc import Mapping

# By the name that add_library() takes, in small letters: the module that has its names, or None if
# they are among those that every sketch sees.
LIBRARIES: Mapping[str, str | None] = {
    "pdf": None,
    "svg": None,
    "peasycam": "sketchkit.libraries.peasycam",
}

# The modules that `import` finds, as Java's packages are called, unless there are others so named.
MODULES: Mapping[str, str] = {
    "peasy": "sketchkit.libraries.peasycam",
    "peasycam": "sketchkit.libraries.peasycam",
}
