"""sketchkit: Processing for Python, without Java.

A sketch needs no import: `sketchkit run spinning.py` gives it its names. For editors that want
it, `from sketchkit import *` in the same file is the same.
"""

import sys

from sketchkit.core import running

__version__ = "0.1.0"

# What is here for programs and notebooks, loaded when it is asked for: sketches start without it.
FOR_PROGRAMS = {
    "render": "sketchkit.notebooks.rendering",
    "load_ipython_extension": "sketchkit.notebooks.magic",
}


def __getattr__(name: str) -> object:
    """Return a name of the sketch that is running, `sketchkit.rect` as well as `import *`."""
    if name in FOR_PROGRAMS:
        from importlib import import_module

        value: object = getattr(import_module(FOR_PROGRAMS[name]), name)
        return value
    sketch = running.current()
    if sketch is None:
        if name == "__all__" and _importer() == "__main__":
            raise ImportError(f"A sketch is started with: sketchkit run {sys.argv[0]}")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}: no sketch is running")
    if name == "__all__":
        return list(sketch.lasting)
    try:
        return sketch.names[name]
    except KeyError:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}") from None


def _importer() -> object:
    frame = sys._getframe(2)
    while frame.f_back and str(frame.f_globals.get("__name__")).startswith("importlib"):
        frame = frame.f_back
    return frame.f_globals.get("__name__")
