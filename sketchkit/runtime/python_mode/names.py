"""All that a sketch of Python Mode sees, besides what every sketch does."""

from __future__ import annotations

from sketchkit.pymode.builtin_names import builtin_names
from sketchkit.runtime.python_mode.importing import Importer
from sketchkit.runtime.python_mode.java import Statics
from sketchkit.runtime.siblings import Family


def python_mode_names(family: Family) -> dict[str, object]:
    """Return these names.

    Parameters
    ----------
    family : Family
        The files of the sketch; its names are those of every sketch.
    """
    statics = Statics(family.names)
    return builtin_names(family.names) | {
        "__import__": Importer(family),
        "PApplet": statics,
    }
