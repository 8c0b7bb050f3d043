"""`sketchkit grade init`: a folder with an assignment to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.starter import write_starter


@click.command(name="init")
@click.argument("folder", type=click.Path(path_type=Path))
def command(folder: Path) -> None:
    """Make FOLDER with an assignment in it: each key has a comment, and it works as it is.

    Nothing is overwritten.
    """
    try:
        write_starter(folder)
    except AssignmentError as problem:
        raise click.UsageError(str(problem)) from None
    click.echo(
        f"Your assignment is {folder / 'assignment.toml'}. Prove it with: sketchkit grade check "
        f"{folder}"
    )
