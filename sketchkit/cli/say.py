"""What the commands write on the terminal: mistakes and remarks, on standard error."""

from __future__ import annotations

from pathlib import Path

import click

from sketchkit.runtime.report import Report


def mistake(report: Report, *, with_traceback: bool) -> None:
    """Show a mistake of the sketch."""
    if with_traceback:
        click.echo(report.traceback, err=True)
    head, _, rest = str(report).partition("\n")
    click.secho(head, err=True, bold=True)
    if rest:
        click.echo(rest, err=True)


def remark(path: Path, line: int, text: str) -> None:
    """Show something that does not stop the sketch."""
    click.secho(f"{path.name}, line {line}: {text}", err=True, fg="yellow")


def note(text: str) -> None:
    """Show something that is not about the sketch."""
    click.secho(text, err=True, fg="yellow")
