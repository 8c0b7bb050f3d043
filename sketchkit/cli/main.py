"""The command `sketchkit`: which commands there are. Each is a file, loaded when it is used."""

from __future__ import annotations

import importlib
from typing import NamedTuple

import click

from sketchkit import __version__


class Entry(NamedTuple):
    """Where a command is, and what it is for."""

    module: str
    summary: str


COMMANDS = {
    "run": Entry("sketchkit.cli.run", "Show a sketch in a window."),
    "render": Entry("sketchkit.cli.render", "Write pictures of a sketch's frames."),
    "port": Entry("sketchkit.cli.port", "Write a sketch of Processing's Python Mode as Python 3."),
    "new": Entry("sketchkit.cli.new", "Make a folder for a new sketch."),
    "doctor": Entry("sketchkit.cli.doctor", "Say what works on this computer."),
    "grade": Entry("sketchkit.cli.grade", "Judge a class's sketches."),
    "api": Entry("sketchkit.cli.api", "Say how a name is used, and what there is of Processing."),
    "trace": Entry("sketchkit.cli.trace", "Print what a frame draws, as text."),
    "diff": Entry("sketchkit.cli.diff", "Say whether two pictures are alike, and why not."),
    "inspect": Entry("sketchkit.cli.inspect", "Say which line of a sketch drew a pixel."),
}

EXTRAS = {"scipy": "grade"}  # packages that commands need, and what installs them

FIRST_STEPS = """\
sketchkit draws with Python, as Processing does. A first sketch, spinning.py:

    def setup():
        size(400, 400)

    def draw():
        background(255)
        translate(200, 200)
        rotate(frameCount * 0.02)
        rect(-80, -80, 160, 160)

sketchkit run spinning.py                 shows it in a window
sketchkit render spinning.py --frames 30  writes its 30th frame to out/frame-0030.png
sketchkit new spinning                    makes a folder for it, with completion for your editor
sketchkit --help                          lists all commands
"""


class LazyGroup(click.Group):
    """Commands whose files are not read until they are needed."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names in the order of the table."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return a command, from its file."""
        if cmd_name not in COMMANDS:
            return None
        try:
            command: click.Command = importlib.import_module(COMMANDS[cmd_name].module).command
        except ModuleNotFoundError as missing:
            if missing.name is None or missing.name.partition(".")[0] not in EXTRAS:
                raise
            extra = EXTRAS[missing.name.partition(".")[0]]
            raise click.UsageError(
                f"sketchkit {cmd_name} needs a package that is not installed, {missing.name}. "
                f'Write pip install "sketchkit[{extra}]".'
            ) from None
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the table, without reading the files."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.summary) for name, entry in COMMANDS.items()])


@click.group(
    cls=LazyGroup,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, message="sketchkit %(version)s")
@click.pass_context
def main(context: click.Context) -> None:
    """Draw with Python, as Processing does.

    A sketch is a Python file with setup() and draw(); it needs no imports. Begin with
    sketchkit new NAME, or with sketchkit alone for a first example.
    """
    if context.invoked_subcommand is None:
        click.echo(FIRST_STEPS, nl=False)
