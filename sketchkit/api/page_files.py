"""Files of shapes: which kinds there are, how a canvas is drawn into one, how it is written.

What makes and writes pages is imported when a sketch draws into a file: most never do.
"""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

from sketchkit.api._sketch_parts import Canvas, Recording
from sketchkit.assets.output import write_file
from sketchkit.core.constants import PDF, SVG
from sketchkit.core.errors import SketchError, shown

# Where each is found.
WRITERS: dict[object, str] = {
    SVG: "sketchkit.vector.svg:svg_bytes",
    PDF: "sketchkit.vector.pdf:pdf_bytes",
}
SHAPES = "sketchkit.vector.shape_reader:ShapeReader"
TRIANGLES = "sketchkit.vector.raw_reader:RawReader"


def begin_recording(
    canvas: Canvas, renderer: object, filename: object, reader: str = SHAPES
) -> Recording:
    """Draw into a file as well from now on: SHAPES, or TRIANGLES.

    Raises
    ------
    SketchError
        If there is no such kind of file, or no name is given.
    """
    if renderer not in WRITERS or not isinstance(filename, str | Path):
        raise SketchError(
            "To draw into a file takes SVG or PDF, and the file's name.",
            got=f"{shown(renderer)}, {shown(filename)}",
            hint='Write beginRecord(SVG, "drawing.svg"), or size(400, 400, PDF, "drawing.pdf").',
        )
    follower = _loaded(reader)(canvas.target, canvas.look)
    canvas.begin_reading(follower)
    return Recording(str(filename), _loaded(WRITERS[renderer]), follower)


def _loaded(place: str) -> Any:  # noqa: ANN401 # a class, or a function
    module, _, name = place.partition(":")
    return getattr(importlib.import_module(module), name)


def write_recording(recording: Recording, folder: Path) -> None:
    """Write what was drawn so far.

    Raises
    ------
    SketchError
        If the file cannot be written.
    """
    data = recording.write(recording.reader.finish())
    try:
        write_file(folder / recording.filename, data)
    except OSError as problem:
        reason = problem.strerror or str(problem)
        raise SketchError(f"{recording.filename} cannot be written: {reason}.") from None
