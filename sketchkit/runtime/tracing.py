"""What a frame draws, as text instead of a picture."""

from __future__ import annotations

from sketchkit.backends.listing import ListingBackend
from sketchkit.runtime.headless import Launch, render


def trace(launch: Launch, number: int) -> str:
    """Return the draw lists of a frame.

    Parameters
    ----------
    launch : Launch
        The sketch.
    number : int
        frameCount; 0 is what `setup()` draws.

    Raises
    ------
    StoppedError
        If the sketch stops by a mistake before the frame is complete.
    """
    backend = ListingBackend()
    texts: list[str] = []
    for frame in render(launch, range(number + 1), backend, looks=False):
        if frame.repeats is None:
            texts = backend.texts
        backend.texts = []
    return "".join(texts)
