"""`sketchkit trace`: what a frame draws, as text."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from sketchkit.cli import say
from sketchkit.cli.python_mode import python_mode
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.runtime.headless import Launch
from sketchkit.runtime.report import StoppedError
from sketchkit.runtime.tracing import trace


@click.command(name="trace")
@click.argument("sketch", type=sketch_file)
@click.option("--frame", default=1, show_default=True, type=click.IntRange(0), help="Which.")
@click.option("--seed", default=0, show_default=True, help="Where random() and noise() begin.")
@python_mode
@click.option("--traceback", is_flag=True, help="Show all that Python says about a mistake.")
def command(sketch: Path, frame: int, seed: int, python: int | None, traceback: bool) -> None:
    """Print what one frame of SKETCH draws: the list that every renderer carries out."""
    try:
        click.echo(trace(Launch(sketch, say.remark, seed, python=python), frame), nl=False)
    except StoppedError as stopped:
        say.mistake(stopped.report, with_traceback=traceback)
        sys.exit(1)
