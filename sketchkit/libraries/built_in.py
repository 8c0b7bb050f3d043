"""The names of libraries that every sketch sees, without adding anything."""

from __future__ import annotations

from sketchkit.libraries.peasycam import PeasyCam

BUILT_IN: dict[str, type] = {"PeasyCam": PeasyCam}
