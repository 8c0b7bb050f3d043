"""`requestImage()`: images that are loaded while the sketch goes on."""

from __future__ import annotations

from concurrent.futures import Future
from threading import Thread

import numpy as np

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.pimage import PImage
from sketchkit.assets.pictures.images import Picture, load_image
from sketchkit.core.clock import VirtualClock
from sketchkit.core.constants import ARGB
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import warn_once
from sketchkit.draw.resources import Pixels

LOADING, FAILED = 0, -1  # what the width is meanwhile, and if there is no picture


class RequestedImage(PImage):
    """An image that is being loaded. Until it is there, nothing is seen of it."""

    def __init__(self, coming: Future[Picture]) -> None:
        self._adopt(np.zeros((1, 1, 4), np.uint8))
        self.format = ARGB
        self._coming = coming
        self._state: int | None = LOADING  # None: it is there

    def _refresh(self) -> None:
        if self._state == LOADING and self._coming.done():
            try:
                picture = self._coming.result()
            except SketchError as error:
                self._state = FAILED
                warn_once(error.message)
            else:
                self._state = None
                self._hold(picture)

    def _texture(self) -> Pixels:
        self._refresh()
        return super()._texture()

    @property
    def width(self) -> int:
        """Columns of pixels; 0 while it is loaded, -1 if it cannot be."""
        self._refresh()
        return super().width if self._state is None else self._state

    @property
    def height(self) -> int:
        """Rows of pixels; 0 while it is loaded, -1 if it cannot be."""
        self._refresh()
        return super().height if self._state is None else self._state


class Requests(SketchParts):
    """What is fetched while the sketch goes on."""

    def requestImage(self, filename: str, extension: str | None = None) -> PImage:
        """Load an image while the sketch goes on.

        Parameters
        ----------
        filename : str
            As for `loadImage()`.
        extension : str, optional
            As for `loadImage()`: the file itself decides.

        Returns
        -------
        PImage
            Its width is 0 until it is there, and -1 if it cannot be loaded.

        See Also
        --------
        loadImage, image

        Notes
        -----
        Drawn before it is there, it shows nothing. Where there is no window it is loaded at once,
        so that every run gives the same pictures. Source: Processing's reference, requestImage().

        Examples
        --------
        >>> img = requestImage("photo.png")
        >>> def draw():
        ...     if img.width > 0:
        ...         image(img, 0, 0)
        """
        coming: Future[Picture] = Future()
        if isinstance(self._clock, VirtualClock):
            _load(coming, filename)
        else:
            Thread(target=_load, args=(coming, filename), daemon=True).start()
        return RequestedImage(coming)


def _load(coming: Future[Picture], filename: str) -> None:
    try:
        coming.set_result(load_image("requestImage", filename))
    except SketchError as error:
        coming.set_exception(error)
