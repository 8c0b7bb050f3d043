"""Where OpenGL comes from: a window's context, or one without a window through EGL or OSMesa."""

from __future__ import annotations

import ctypes
from types import ModuleType
from typing import NamedTuple

import moderngl

from sketchkit.backends.gl.turning import FindFunction, egl_function

REQUIRED = 330  # OpenGL 3.3 core: the newest that every platform has


class NoContextError(RuntimeError):
    """No OpenGL 3.3 can be had here; the message says what was tried."""


class Headless(NamedTuple):
    """A context without a window: how it was made, and what finds its functions."""

    context: moderngl.Context
    origin: str
    find: FindFunction


def headless_context() -> Headless:
    """Return a context without a window, of EGL or OSMesa.

    Raises
    ------
    NoContextError
        With what each way answered.
    """
    answers = []
    for name, make in (("EGL", _egl_context), ("OSMesa", _osmesa_context)):
        try:
            context, find = make()
            return Headless(context, name, find)
        except Exception as problem:  # moderngl and glfw raise bare Exception
            answers.append(f"{name}: {problem}")
    raise NoContextError("no OpenGL 3.3 without a window (" + "; ".join(answers) + ")")


def window_context() -> moderngl.Context:
    """Return the context of the window that is current on this thread.

    Raises
    ------
    NoContextError
        If it offers less than OpenGL 3.3.
    """
    try:
        return moderngl.create_context(require=REQUIRED)
    except Exception as problem:  # moderngl raises bare Exception
        raise NoContextError(str(problem)) from problem


def _egl_context() -> tuple[moderngl.Context, FindFunction]:
    # moderngl's stubs take all settings for dicts.
    context = moderngl.create_context(standalone=True, backend="egl", require=REQUIRED)  # type: ignore[arg-type]
    return context, egl_function


def _osmesa_context() -> tuple[moderngl.Context, FindFunction]:
    """Return a context of GLFW's null platform, whose drawing OSMesa does."""
    import glfw  # GLFW is the only way to OSMesa that needs no library of ours

    glfw.init_hint(glfw.PLATFORM, glfw.PLATFORM_NULL)
    if not glfw.init():
        raise NoContextError("GLFW could not be started")
    for hint, value in (
        (glfw.CONTEXT_CREATION_API, glfw.OSMESA_CONTEXT_API),
        (glfw.CONTEXT_VERSION_MAJOR, REQUIRED // 100),
        (glfw.CONTEXT_VERSION_MINOR, REQUIRED // 10 % 10),
        (glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE),
        (glfw.VISIBLE, glfw.FALSE),
    ):
        glfw.window_hint(hint, value)
    window = glfw.create_window(16, 16, "sketchkit", None, None)
    if not window:
        raise NoContextError("OSMesa is not installed, or too old for OpenGL 3.3")
    glfw.make_context_current(window)
    loader = _GlfwLoader(glfw, window)
    context = moderngl.create_context(context=loader, require=REQUIRED)  # type: ignore[arg-type] # as above
    return context, loader.load_opengl_function


class _GlfwLoader:
    """Hands moderngl the functions of the context that GLFW has made current."""

    def __init__(self, glfw: ModuleType, window: object) -> None:
        self._glfw = glfw
        self._window = window

    def load_opengl_function(self, name: str) -> int:
        """Return the address of a function, 0 if there is none."""
        address = self._glfw.get_proc_address(name)
        return ctypes.cast(address, ctypes.c_void_p).value or 0

    def __enter__(self) -> None:
        self._glfw.make_context_current(self._window)

    def __exit__(self, *_: object) -> None: ...

    def release(self) -> None:
        """Destroy the window."""
        self._glfw.destroy_window(self._window)
