"""`sketchkit doctor`: what works on this computer, and what to install for what does not."""

from __future__ import annotations

import ctypes.util
import platform
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from typing import NamedTuple

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from sketchkit import __version__
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.runtime.backends import RendererError, open_backend
from sketchkit.runtime.window import Window, WindowError
from sketchkit.stubs import blank_canvas


class Finding(NamedTuple):
    """Something that was looked at: whether it works, what was seen, and what to do about it."""

    what: str
    works: bool
    seen: str
    advice: str = ""


PACKAGES = ("numpy", "pillow", "moderngl", "glfw", "click", "rich", "font-source-sans-pro")

GL_ADVICE = "Linux: apt install libegl1 libgl1-mesa-dri. Else: a newer graphics driver."
OSMESA_ADVICE = "Only needed where EGL is missing. Linux: apt install libosmesa6."
WINDOW_ADVICE = "sketchkit render works without. On a server: xvfb-run sketchkit run ..."


@click.command(name="doctor")
def command() -> None:
    """Say what works on this computer: OpenGL, windows, fonts, packages."""
    table = Table(box=None, pad_edge=False, show_header=False)
    for finding in findings():
        mark = "[green]yes[/]" if finding.works else "[red]no[/]"
        table.add_row(mark, finding.what, Text(finding.seen))
        if finding.advice and not finding.works:
            table.add_row("", "", Text(finding.advice, style="yellow"))
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


def _described(backend: Backend) -> str:
    return ", ".join(backend.describe().values())


def _osmesa() -> Finding:
    library = ctypes.util.find_library("OSMesa")
    return Finding("OSMesa", bool(library), library or "not installed", OSMESA_ADVICE)


def _window() -> Finding:
    try:
        with Window("sketchkit doctor") as window:
            return Finding("a window", True, _described(window.backend))
    except WindowError as reason:
        return Finding("a window", False, str(reason), WINDOW_ADVICE)


def _font() -> Finding:
    try:
        width = blank_canvas().textWidth("Hello")
    except (SketchError, ModuleNotFoundError) as reason:
        return Finding("default font", False, str(reason), "pip install font-source-sans-pro")
    return Finding("default font", True, f"Source Sans Pro ('Hello' is {width:g} wide)")
