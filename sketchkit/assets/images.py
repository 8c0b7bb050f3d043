"""Pictures to pixels: whatever the file holds becomes RGBA with straight alpha.

Pictures are written in `output.py`.
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.paths import find_file
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import Pixels

if TYPE_CHECKING:
    from PIL import Image

U8 = NDArray[np.uint8]

EXTENSIONS = {"png", "jpg", "jpeg", "gif", "bmp", "tga", "tif", "tiff", "webp"}


def load_pixels(path: Path) -> Pixels:
    """Return the picture in a file; of an animation, the first frame.

    Raises
    ------
    SketchError
        If it is no picture, or a broken one.
    """
    from PIL import Image, UnidentifiedImageError  # 40 ms, and most sketches load no picture

    try:
        # Pillow remarks on odd headers; whoever drew the picture cannot help it.
        with warnings.catch_warnings(action="ignore"), Image.open(path) as picture:
            return Pixels(_rgba(picture))
    except UnidentifiedImageError:
        raise SketchError(f"{path} is no picture that can be read.", hint=_kinds()) from None
    except (OSError, SyntaxError, ValueError, EOFError) as problem:  # Pillow's, for broken files
        raise SketchError(
            f"The picture {path} is broken: {str(problem).rstrip('.')}.",
            hint="Open it in a picture editor and save it again.",
        ) from None


def load_image(caller: str, filename: str) -> Pixels:
    """Return the picture that a sketch names, from its folders.

    Raises
    ------
    SketchError
        If there is no such file, or it is no picture.
    """
    return load_pixels(find_file(caller, filename))


def _rgba(picture: Image.Image) -> U8:
    """Return a picture of any kind as RGBA, (h, w, 4)."""
    if picture.mode.startswith("I") or picture.mode == "F":
        gray = _eight_bits(np.asarray(picture))
        return np.stack([gray, gray, gray, np.full_like(gray, 255)], axis=2)
    return np.array(picture.convert("RGBA"))


def _eight_bits(gray: np.typing.NDArray[np.generic]) -> U8:
    """Return grays of 16 bits with the lower ones cut off; floats are 0..255 already."""
    if gray.dtype.kind == "f":
        eight: U8 = np.clip(gray, 0, 255).astype(np.uint8)
    else:
        eight = np.clip(gray.astype(np.int64) >> 8, 0, 255).astype(np.uint8)
    return eight


def _kinds() -> str:
    *others, last = sorted(extension.upper() for extension in EXTENSIONS)
    return f"Pictures are {', '.join(others)} or {last} files."
