"""Which way up a target is rendered.

Where the driver has clip control (OpenGL 4.5), it turns the picture over; elsewhere a sign in the
vertex shaders does. They differ only where a horizontal edge runs exactly through a row of samples:
with clip control it falls to the side that it falls to in Processing's windows.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable

import moderngl

FindFunction = Callable[[str], int]  # the address of a function of OpenGL; 0 if there is none

LOWER_LEFT, UPPER_LEFT = 0x8CA1, 0x8CA2
NEGATIVE_ONE_TO_ONE = 0x935E
EXTENSION = "GL_ARB_clip_control"


def egl_function(name: str) -> int:
    """Return the address of a function of the current EGL context."""
    find = ctypes.CDLL("libEGL.so.1").eglGetProcAddress
    find.restype, find.argtypes = ctypes.c_void_p, [ctypes.c_char_p]
    return find(name.encode()) or 0


class Turning:
    """Turns targets over in one context."""

    def __init__(self, context: moderngl.Context, find: FindFunction | None) -> None:
        self._context = context
        self._clip_control: Callable[[int, int], None] | None = None
        if find is not None and EXTENSION in context.extensions and (at := find("glClipControl")):
            prototype = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_uint)
            self._clip_control = prototype(at)

    def turn(self, *, top_row_first: bool) -> float:
        """Make ready to draw, and return what shaders multiply y with.

        Front is what is clockwise as seen on the picture, either way up.
        """
        if self._clip_control is None:
            self._context.front_face = "ccw" if top_row_first else "cw"
            return -1.0 if top_row_first else 1.0
        self._clip_control(UPPER_LEFT if top_row_first else LOWER_LEFT, NEGATIVE_ONE_TO_ONE)
        self._context.front_face = "cw"
        return 1.0

    def reset(self) -> None:
        """Draw as OpenGL does by itself."""
        if self._clip_control is not None:
            self._clip_control(LOWER_LEFT, NEGATIVE_ONE_TO_ONE)
