"""The corners of a `beginShape()` that is still open, kept while all before it is drawn."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sketchkit.api._pen import OpenShape
from sketchkit.draw.recorder import Recorder


@contextmanager
def kept_corners(recorder: Recorder, shape: OpenShape | None) -> Iterator[None]:
    """Let the recorder be cleared, and have the corners of an open shape in it afterwards."""
    if shape is None or not recorder.row_end:  # nothing is drawn, and so nothing cleared
        yield
        return
    corners = bytes(recorder.corners[shape.first : recorder.corner_end])
    uvs = b"" if shape.first_uv is None else bytes(recorder.uvs[shape.first_uv : recorder.uv_end])
    attributes = recorder.attributes
    yield
    recorder.corners[: len(corners)], recorder.corner_end = corners, len(corners)
    recorder.uvs[: len(uvs)], recorder.uv_end = uvs, len(uvs)
    recorder.attributes = attributes  # corners refer to its entries
    shape.first = 0
    shape.first_uv = None if shape.first_uv is None else 0
