"""`sketchkit diff`: whether two pictures are alike, as the grader sees it, and why not."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from sketchkit.assets.output import write_file
from sketchkit.cli import say
from sketchkit.core.errors import SketchError
from sketchkit.grading.images.files import load_pixels
from sketchkit.grading.images.verdict import Tolerance, Verdict, judge
from sketchkit.grading.pages.diff import diff_page

DIFFERENT = 1  # exit status
WRONG_CALL = 2

picture_file = click.Path(path_type=Path)


@click.command(name="diff")
@click.argument("submitted", metavar="A.png", type=picture_file)
@click.argument("expected", metavar="B.png", type=picture_file)
@click.option(
    "--page",
    metavar="OUT.html",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write a page that holds the two beside each other.",
)
def command(submitted: Path, expected: Path, page: Path | None) -> None:
    """Say whether the picture A.png is what B.png shows, and if not, why.

    Edges that another renderer or driver would draw otherwise do not count. The exit status is
    0 if they are alike, 1 if they differ, 2 if they cannot be compared.
    """
    try:
        pictures = load_pixels(submitted), load_pixels(expected)
        verdict = judge(*pictures)
        if page:
            text = diff_page(submitted.name, expected.name, *pictures, verdict)
            write_file(page, text.encode())
    except SketchError as mistake:
        say.note(str(mistake))
        sys.exit(WRONG_CALL)
    except OSError as problem:
        say.note(f"The page {page} cannot be written: {problem.strerror}.")
        sys.exit(WRONG_CALL)
    click.echo(summary(verdict))
    sys.exit(0 if verdict.is_alike else DIFFERENT)


def summary(verdict: Verdict) -> str:
    """Return a verdict in a few lines."""
    tolerance = Tolerance()
    lines = ["alike" if verdict.is_alike else "different"]
    if verdict.reason:
        lines.append(verdict.reason)
    where = ""
    if verdict.region_box:
        left, top, width, height = verdict.region_box
        where = f", {width} x {height} from ({left}, {top})"
    lines += [
        f"FLIP  mean {verdict.flip_mean:.4f} (of {tolerance.mean}), "
        f"99th percentile {verdict.flip_high:.3f} (of {tolerance.high})",
        f"largest region  {verdict.region} pixels (of {tolerance.region}){where}",
    ]
    return "\n".join(lines)
