"""The option `--frames`: which frames are meant."""

from __future__ import annotations

import click

from sketchkit.runtime.frame_numbers import parse_frames


def frames(text: str) -> tuple[int, ...]:
    """Return the numbers of frames that an option means.

    Raises
    ------
    click.BadParameter
        With a sentence that says what to write.
    """
    try:
        return parse_frames(text)
    except ValueError as problem:
        raise click.BadParameter(str(problem)) from None
