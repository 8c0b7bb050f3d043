"""Frames for films, and films read back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from sketchkit.assets.movies.movie import Movie


def flat(number: int, size: tuple[int, int] = (61, 41)) -> np.ndarray:
    """Return a red rectangle on white, farther to the right in each frame."""
    width, height = size
    pixels = np.full((height, width, 3), 255, np.uint8)
    pixels[10:30, number : number + 15] = (200, 30, 40)
    return pixels


def shaded(number: int, size: tuple[int, int] = (64, 48)) -> np.ndarray:
    """Return a soft picture of thousands of colours, under a stripe of pure white."""
    rows, columns = np.mgrid[: size[1], : size[0]]
    waves = np.sin(columns / 20 + number / 9), np.cos(rows / 15), np.sin((rows + columns) / 25)
    pixels = (128 + 120 * np.stack(waves, axis=-1)).astype(np.uint8)
    pixels[:10] = 255
    return pixels


def filmed(path: Path, frames: list[np.ndarray], fps: float) -> str | None:
    """Write a film; return what is told about it."""
    movie = Movie(path, fps)
    for pixels in frames:
        movie.add(pixels)
    return movie.finish()


def pictures(path: Path) -> list[tuple[np.ndarray, float]]:
    """Return the frames of a GIF, WebP or PNG, by Pillow, and for how many milliseconds each."""
    with Image.open(path) as image:
        found = []
        for number in range(image.n_frames):
            image.seek(number)
            found.append((np.asarray(image.convert("RGB")), float(image.info["duration"])))
    return found
