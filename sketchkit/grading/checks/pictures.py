"""Pictures of evidence: their sizes are looked at before anything is decoded."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

U8 = NDArray[np.uint8]

MOST_PIXELS = 1 << 26  # 8192 x 8192: more than any sketch's window


class PictureError(Exception):
    """A picture that cannot be looked at, with the reason in a sentence."""


def size_of(path: Path) -> tuple[int, int]:
    """Return width and height, from the file's first bytes.

    Raises
    ------
    PictureError
        If it is no picture, or too large a one.
    """
    with _opened(path) as picture:
        return picture.size


def read_picture(path: Path) -> U8:
    """Return a picture as (h, w, 3) uint8.

    Raises
    ------
    PictureError
        If it is no picture, a broken one, or too large.
    """
    with _opened(path) as picture:
        return np.asarray(_decoded(picture, path))


def read_small(path: Path, width: int) -> U8:
    """Return a picture shrunk to about a width, (h, w, 3) uint8: enough to tell moments apart."""
    with _opened(path) as picture:
        factor = max(picture.width // width, 1)
        return np.asarray(_decoded(picture, path).reduce(factor))


class Pictures(Mapping[str, U8]):
    """Pictures by name, each read when it is asked for.

    Most are never looked at: they explain a difference, and only where there is one.
    """

    def __init__(self, paths: Mapping[str, Path]) -> None:
        self._paths = paths

    def __getitem__(self, name: str) -> U8:
        return read_picture(self._paths[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._paths)

    def __len__(self) -> int:
        return len(self._paths)


def _opened(path: Path) -> Image.Image:
    try:
        with warnings.catch_warnings(action="ignore"):  # on many pixels: they are counted here
            picture = Image.open(path)
    except Image.DecompressionBombError:
        raise PictureError(f"The picture {path.name} is too large.") from None
    except (OSError, SyntaxError, ValueError):
        raise PictureError(f"{path.name} is no picture that can be read.") from None
    if picture.width * picture.height > MOST_PIXELS:
        picture.close()
        raise PictureError(
            f"The picture {path.name} is too large: {picture.width} x {picture.height} pixels."
        )
    return picture


def _decoded(picture: Image.Image, path: Path) -> Image.Image:
    try:
        return picture.convert("RGB")
    except (OSError, SyntaxError, ValueError):
        raise PictureError(f"The picture {path.name} is broken.") from None
