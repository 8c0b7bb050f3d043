"""The names of libraries that every sketch sees, without adding anything."""

from __future__ import annotations

from sketchkit.libraries import peasycam

BUILT_IN: dict[str, type] = {name: getattr(peasycam, name) for name in peasycam.__all__}
