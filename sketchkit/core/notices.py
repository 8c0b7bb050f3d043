"""Remarks that do not stop a sketch: each is said once for each place in its code.

They are Python's own warnings, so that the standard tools (filters, `pytest.warns`) hold for them;
whoever runs the sketch decides how they look.
"""

import os
import sys
import warnings
from pathlib import Path
from types import FrameType

PACKAGE = str(Path(__file__).parents[1]) + os.sep


class SketchWarning(UserWarning):
    """Something that the sketch probably does not mean, or that has no effect here."""


def warn_once(message: str) -> None:
    """Tell the author of the running sketch, at the line that called into sketchkit.

    Parameters
    ----------
    message : str
        One or two whole sentences, in the names that the sketch uses.
    """
    frame = _calling_frame()
    warnings.warn_explicit(
        message,
        SketchWarning,
        frame.f_code.co_filename,
        frame.f_lineno,
        registry=frame.f_globals.setdefault("__warningregistry__", {}),
    )


def _calling_frame() -> FrameType:
    frame = sys._getframe(2)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        frame = frame.f_back
    return frame
