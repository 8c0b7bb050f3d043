"""`sketchkit run`: a sketch in a window."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from sketchkit.cli import say
from sketchkit.cli.python_mode import python_mode
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.runtime.player import Player
from sketchkit.runtime.window import Window, WindowError

NO_WINDOW = 2  # exit status


@click.command(name="run", context_settings={"ignore_unknown_options": True})
@click.argument("sketch", type=sketch_file)
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
@python_mode
@click.option("--traceback", is_flag=True, help="Show all that Python says about a mistake.")
def command(sketch: Path, args: tuple[str, ...], python: int | None, traceback: bool) -> None:
    """Show SKETCH, a Python file (.py or .pyde) or its folder, in a window.

    Esc or closing the window ends it. Save the file while it runs, and it starts again. What
    follows SKETCH is the list that the sketch sees as args.
    """
    try:
        window = Window(sketch.stem)
    except WindowError as reason:
        say.note(
            f"No window can be opened here ({reason}); "
            f"sketchkit render {sketch} draws the sketch without one."
        )
        sys.exit(NO_WINDOW)
    with window:
        player = Player(
            sketch,
            window,
            args=args,
            python=python,
            tell=say.remark,
            say=lambda report: say.mistake(report, with_traceback=traceback),
        )
        is_well = player.play()
    sys.exit(0 if is_well else 1)
