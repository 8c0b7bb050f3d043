"""Which renderer draws: chosen here by name, and nowhere else.

Each is a module that is imported only when it is chosen: a sketch drawn without OpenGL loads none
of it.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

from sketchkit.draw.backend import Backend

# Where each renderer without a window is made.
MAKERS = {
    "gl": ("sketchkit.backends.gl.executor", "GlBackend.headless"),
    "cpu": ("sketchkit.backends.cpu.executor", "CpuBackend"),
}
RENDERERS = tuple(MAKERS)
PREFERRED, FALLBACK = RENDERERS


class RendererError(Exception):
    """The renderer that was asked for cannot work here; the message is a sentence that says why."""


@dataclass(frozen=True)
class Choice:
    """A renderer, and what the user should know about how it was chosen."""

    backend: Backend
    remark: str | None = None


def open_backend(name: str | None = None) -> Choice:
    """Return a renderer that needs no window.

    Parameters
    ----------
    name : str, optional
        One of `RENDERERS`. Without it, the first that works here.

    Raises
    ------
    RendererError
        If the one named cannot work.
    """
    if name is not None:
        return Choice(_open(name))
    try:
        return Choice(_open(PREFERRED))
    except RendererError as reason:
        remark = f"No OpenGL here ({reason}): drawing with the CPU renderer instead."
        return Choice(_open(FALLBACK), remark)


def _open(name: str) -> Backend:
    module_name, path = MAKERS[name]
    try:
        maker: object = importlib.import_module(module_name)
        for part in path.split("."):
            maker = getattr(maker, part)
        return cast(Callable[[], Backend], maker)()
    except (ImportError, RuntimeError) as reason:
        raise RendererError(f"{reason}") from reason
