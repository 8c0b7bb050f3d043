"""`sketchkit doctor`: what works on this computer, and what to install for what does not."""

from __future__ import annotations

import ctypes.util
import importlib.util
import platform
import sys
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, version
from typing import NamedTuple

import click
from rich.console import Console
from rich.table import Table

from sketchkit import __version__
from sketchkit.draw.backend import Backend
from sketchkit.runtime.backends import RendererError, open_backend
from sketchkit.runtime.window import Window, WindowError


class Finding(NamedTuple):
    """Something that was looked at: whether it works, what was seen, and what to do about it."""

    what: str
    works: bool
    seen: str
    advice: str = ""


class Extra(NamedTuple):
    """A package that sketchkit can do without."""

    module: str
    extra: str
    use: str


PACKAGES = ("numpy", "pillow", "moderngl", "glfw", "click", "rich")
EXTRAS: tuple[Extra, ...] = ()
"""Packages that are looked for; each comes with the issue that first uses it."""

GL_ADVICE = "Linux: apt install libegl1 libgl1-mesa-dri. Else: a newer graphics driver."
OSMESA_ADVICE = "Only needed where EGL is missing. Linux: apt install libosmesa6."
WINDOW_ADVICE = "sketchkit render works without. On a server: xvfb-run sketchkit run ..."


@click.command(name="doctor")
def command() -> None:
    """Say what works on this computer: OpenGL, windows, fonts, packages."""
    table = Table(box=None, pad_edge=False)
    for title in ("", "", "found", "what to do"):
        table.add_column(title, overflow="fold")
    for finding in findings():
        mark = "[green]yes[/]" if finding.works else "[red]no[/]"
        table.add_row(mark, finding.what, finding.seen, finding.advice)
    Console().print(table)


def findings() -> Iterator[Finding]:
    """Look at everything."""
    yield Finding("sketchkit", True, f"{__version__}, Python {platform.python_version()}")
    yield Finding("system", True, platform.platform())
    for package in PACKAGES:
        yield _package(package)
    yield _renderer("OpenGL without a window", "gl", GL_ADVICE)
    yield _osmesa()
    yield _window()
    yield _renderer("CPU renderer", "cpu", "")
    yield _font()


def _package(name: str) -> Finding:
    try:
        return Finding(name, True, version(name))
    except PackageNotFoundError:
        return Finding(name, False, "not installed", f"pip install {name}")


def _renderer(what: str, name: str, advice: str) -> Finding:
    try:
        backend = open_backend(name).backend
    except RendererError as reason:
        return Finding(what, False, str(reason), advice)
    seen = _described(backend)
    backend.close()
    return Finding(what, True, seen)
