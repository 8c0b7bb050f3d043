"""The command `sketchkit`: which commands there are. Each is a file, loaded when it is used."""

from __future__ import annotations

import importlib

import click

from sketchkit import __version__

COMMANDS = {
    "run": "sketchkit.cli.run",
    "render": "sketchkit.cli.render",
    "new": "sketchkit.cli.new",
    "doctor": "sketchkit.cli.doctor",
    "trace": "sketchkit.cli.trace",
}

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
        command: click.Command = importlib.import_module(COMMANDS[cmd_name]).command
        return command


@click.group(
    cls=LazyGroup,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, message="sketchkit %(version)s")
@click.pass_context
def main(context: click.Context) -> None:
    """Draw with Python, as Processing does.

    A sketch is a Python file with setup() and draw(); it needs no imports.
    """
    if context.invoked_subcommand is None:
        click.echo(FIRST_STEPS, nl=False)
