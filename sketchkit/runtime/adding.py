"""`add_library(name)`: the names of a library join those that a sketch sees."""

from __future__ import annotations

import importlib
from collections.abc import Callable

from sketchkit.core.errors import SketchError, either, nearest, shown
from sketchkit.libraries import LIBRARIES

Names = dict[str, object]

# Libraries for Processing that many know, and what one can do without them.
INSTEAD = {
    "gifanimation": "sketchkit render --out movie.gif writes a GIF; saveFrame() writes pictures.",
    "video": "Pictures can be loaded with loadImage().",
    "sound": "Python packages that play sounds can be imported.",
    "minim": "Python packages that play sounds can be imported.",
    "controlp5": "Buttons and sliders can be drawn with rect() and read with mousePressed.",
    "serial": "The Python package pyserial talks to serial ports.",
}


def adder(names: Names) -> Callable[[str], None]:
    """Return the function `add_library` of a sketch.

    Parameters
    ----------
    names : dict
        What the sketch sees behind its own names.
    """

    def add_library(name: str) -> None:
        """Make the names of a library visible to the sketch.

        Parameters
        ----------
        name : str
            The library's, as Processing's menu writes it.

        Raises
        ------
        SketchError
            If sketchkit has none of that name.

        Examples
        --------
        >>> add_library("pdf")
        """
        known = str(name).lower()
        if known not in LIBRARIES:
            raise _unavailable(name)
        if module_name := LIBRARIES[known]:
            module = importlib.import_module(module_name)
            names.update({public: getattr(module, public) for public in module.__all__})

    return add_library


def _unavailable(name: object) -> SketchError:
    known = str(name).lower()
    hint = INSTEAD.get(known)
    if hint is None and (near := nearest(known, LIBRARIES)):
        hint = f"Do you mean {near}?"
    return SketchError(
        f"The library {name} is not available in sketchkit: it is written in Java.",
        got=f"add_library({shown(name)})",
        hint=hint or f"Take add_library() and what uses it out; sketchkit has {either(LIBRARIES)}.",
    )
