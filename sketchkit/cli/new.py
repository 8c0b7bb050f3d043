"""`sketchkit new`: a folder for a sketch, with what editors need to know its names."""

from __future__ import annotations

import json
import keyword
from pathlib import Path

import click

from sketchkit.api.names import names_of
from sketchkit.assets.output import write_file
from sketchkit.runtime.checks import TAKEN_NAMES
from sketchkit.stubs import blank_sketch, stub

SKETCH = """\
def setup():
    size(640, 360)


def draw():
    background(255)
    fill(200, 80, 40)
    circle(width / 2, height / 2, 120 + 40 * sin(frameCount * 0.05))
"""

# Names come from __builtins__.pyi; and a file may both read the value keyPressed and define the
# function keyPressed().
PYRIGHT = {"typeCheckingMode": "standard", "reportUnnecessaryComparison": "none"}


@click.command(name="new")
@click.argument("name", type=click.Path(path_type=Path))
def command(name: Path) -> None:
    """Make the folder NAME, with a first sketch and support for editors in it.

    VS Code (Pylance), pyright and basedpyright then complete and check all names of sketchkit,
    though the sketch imports none. Elsewhere write from sketchkit import * at its beginning.
    """
    _refuse_bad_name(name)
    (name / "data").mkdir(parents=True)
    files = {
        f"{name.name}.py": SKETCH,
        "__builtins__.pyi": stub(),
        "pyrightconfig.json": json.dumps(PYRIGHT, indent=2) + "\n",
        "ruff.toml": f"builtins = {json.dumps(sorted(names_of(blank_sketch())))}\n",
    }
    for file, text in files.items():
        write_file(name / file, text.encode())
    click.echo(f"Your sketch is {name / name.name}.py. See it with: sketchkit run {name}")


def _refuse_bad_name(folder: Path) -> None:
    name = folder.name
    if folder.exists():
        raise click.UsageError(f"There is a file or folder {folder} already.")
    if not name.isidentifier() or keyword.iskeyword(name):
        raise click.UsageError(
            f"{name!r} cannot be the name of a sketch: letters, digits and _ make one, and no "
            "digit comes first."
        )
    if name in TAKEN_NAMES:
        raise click.UsageError(f"{name} is the name of a Python module: choose another.")
