"""Remarks that do not stop a sketch: each is said once for each place in its code.

They are Python's own warnings, so that the standard tools (filters, `pytest.warns`) hold for them;
whoever runs the sketch decides how they look.
"""

import os
import sys
import warnings
from pathlib import Path
from typing import NamedTuple

PACKAGE = str(Path(__file__).parents[1]) + os.sep


class SketchWarning(UserWarning):
    """Something that the sketch probably does not mean, or that has no effect here."""


class Place(NamedTuple):
    """A line of the sketch.

    Attributes
    ----------
    said : dict
        Python's own record of what was said in that file.
    """

    file: str
    line: int
    said: dict[str | tuple[str, type[Warning], int], int]


def calling_place() -> Place:
    """Return the line of the sketch that called into sketchkit."""
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        frame = frame.f_back
    said = frame.f_globals.setdefault("__warningregistry__", {})
    return Place(frame.f_code.co_filename, frame.f_lineno, said)


def warn_once(message: str, place: Place | None = None) -> None:
    """Tell the author of the running sketch, at the line that called into sketchkit.

    Parameters
    ----------
    message : str
        One or two whole sentences, in the names that the sketch uses.
    place : Place, optional
        Another line that it is about.
    """
    file, line, said = place or calling_place()
    warnings.warn_explicit(message, SketchWarning, file, line, registry=said)
