"""Pictures to compare, from files: opened with care, since anybody may have made them."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from sketchkit.core.errors import SketchError

U8 = NDArray[np.uint8]

MOST_PIXELS = 32_000_000  # 4000 x 8000: what is larger takes minutes and gigabytes
KINDS = ("PNG", "JPEG", "GIF", "BMP", "TGA", "TIFF", "WEBP")
WHITE = 255  # what shows through


def load_pixels(path: Path) -> U8:
    """Return a picture as (h, w, 3); what is transparent is shown on white.

    The size is looked at before anything is decoded, and few kinds of files are read at all.

    Raises
    ------
    SketchError
        If there is no such file, or no picture in it, or one that is broken or too large.
    """
    try:
        with (
            warnings.catch_warnings(action="ignore"),  # Pillow's, about sizes and odd headers
            Image.open(path, formats=KINDS) as picture,
        ):
            _refuse_large(path, picture)
            return _rgb(picture)
    except FileNotFoundError:
        raise SketchError(f"There is no file {path}.") from None
    except IsADirectoryError:
        raise SketchError(f"{path} is a folder, not a picture.") from None
    except PermissionError:
        raise SketchError(f"The file {path} may not be read.") from None
    except UnidentifiedImageError:
        kinds = ", ".join(KINDS)
        raise SketchError(f"{path} is no picture.", hint=f"Pictures are {kinds} files.") from None
    except Image.DecompressionBombError:
        raise _too_large(path) from None
    # All that Pillow raises for broken files.
    except (OSError, SyntaxError, ValueError, EOFError, RuntimeError, OverflowError) as problem:
        reason = str(problem).rstrip(".")
        raise SketchError(f"The picture {path} is broken: {reason}.") from None


def _refuse_large(path: Path, picture: Image.Image) -> None:
    if picture.width * picture.height > MOST_PIXELS:
        raise _too_large(path, f"{picture.width} x {picture.height}")


def _too_large(path: Path, size: str | None = None) -> SketchError:
    limit = f"At most {MOST_PIXELS:,} pixels are compared."
    return SketchError(f"The picture {path} is too large.", got=size, hint=limit)


def _rgb(picture: Image.Image) -> U8:
    if picture.mode.startswith("I") or picture.mode == "F":  # greys of 16 bits
        values = np.asarray(picture, np.float64)
        most = 65535 if picture.mode.startswith("I") else 255
        grey = np.clip(np.nan_to_num(values) * (255 / most) + 0.5, 0, 255).astype(np.uint8)
        return np.repeat(grey[..., None], 3, axis=2)
    if not picture.has_transparency_data:
        return np.array(picture.convert("RGB"))
    pixels = np.array(picture.convert("RGBA"))
    colors, alpha = pixels[..., :3].astype(np.uint16), pixels[..., 3:].astype(np.uint16)
    shown: U8 = ((colors * alpha + WHITE * (255 - alpha) + 127) // 255).astype(np.uint8)
    return shown
