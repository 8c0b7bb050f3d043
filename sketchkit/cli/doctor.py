"""`sketchkit doctor`: what works on this computer, and what to install for what does not."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from typing import NamedTuple

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from sketchkit import __version__
from sketchkit.cli.probes import probed


class Finding(NamedTuple):
    """Something that was looked at: whether it works, what was seen, and what to do if not."""

    what: str
    works: bool
    seen: str
    advice: str = ""


PACKAGES = (
    *("numpy", "pillow", "moderngl", "glfw", "click", "rich", "font-source-sans-pro"),
    *("svgelements", "pydyf", "uharfbuzz"),
)

# What is tried out: its name in probes.py, what it is called, and what to do if it fails.
TRIED = (
    (
        "gl",
        "OpenGL without a window",
        "Linux: apt install libegl1 libgl1-mesa-dri. Elsewhere: a newer graphics driver. "
        "Without it sketchkit render draws with the CPU.",
    ),
    (
        "osmesa",
        "OSMesa",
        "Only needed where OpenGL without a window fails. Linux: apt install libosmesa6.",
    ),
    (
        "window",
        "a window",
        "sketchkit render needs none. On a server: xvfb-run sketchkit run ...",
    ),
    ("cpu", "CPU renderer", "Reinstall: pip install --force-reinstall sketchkit numpy"),
    ("font", "default font", "pip install font-source-sans-pro"),
    (
        "sandbox",
        "sandbox for grading",
        "Only needed by sketchkit grade, which says what a submission could do. Linux: apt "
        "install bubblewrap, and grade where user namespaces are allowed.",
    ),
    ("python_mode", "sketches of Python Mode (.pyde)", 'pip install "sketchkit[pde]"'),
)


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
    for name, what, advice in TRIED:
        works, seen = probed(name)
        yield Finding(what, works, seen, advice)


def _package(name: str) -> Finding:
    try:
        return Finding(name, True, version(name))
    except PackageNotFoundError:
        return Finding(name, False, "not installed", f"pip install {name}")
