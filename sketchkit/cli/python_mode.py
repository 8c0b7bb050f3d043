"""The option `--python-mode`: a .py file may be Python 2 too, as older sketches are."""

from __future__ import annotations

import click

python_mode = click.option(
    "--python-mode",
    "python",
    flag_value=2,
    default=None,
    type=int,
    help="Read SKETCH as Processing's Python Mode does (Python 2), as if it ended in .pyde.",
)
