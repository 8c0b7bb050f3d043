"""Pictures to pixels: whatever the file holds becomes RGBA with straight alpha.

Those that hold floats, brighter than white too, are kept as such besides. Pictures are written in
`output.py`.
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.paths import find_file
from sketchkit.assets.pictures.radiance import MAGIC as RADIANCE
from sketchkit.assets.pictures.radiance import read_radiance
from sketchkit.core.errors import SketchError

if TYPE_CHECKING:
    from PIL import Image

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]

EXTENSIONS = {"png", "jpg", "jpeg", "gif", "bmp", "tga", "tif", "tiff", "webp", "hdr", "exr"}
OPEN_EXR = b"\x76\x2f\x31\x01"


class Picture(NamedTuple):
    """What a file holds.

    Attributes
    ----------
    data : (h, w, 4) uint8
        RGBA; floats are cut to 0..1.
    floats : (h, w, 3) float32, linear, or None
        If the file holds floats.
    """

    data: U8
    floats: F32 | None = None


def load_picture(path: Path) -> Picture:
    """Return the picture in a file; of an animation, the first frame.

    Raises
    ------
    SketchError
        If it is no picture, or a broken one.
    """
    from PIL import Image, UnidentifiedImageError  # 40 ms, and most sketches load no picture

    try:
        if (floats := _floats(path)) is not None:
            return Picture(to_bytes(floats), floats)
        # Pillow remarks on odd headers; whoever drew the picture cannot help it.
        with warnings.catch_warnings(action="ignore"), Image.open(path) as picture:
            return Picture(_rgba(picture))
    except UnidentifiedImageError:
        raise SketchError(f"{path} is no picture that can be read.", hint=_kinds()) from None
    except (
        OSError,
        SyntaxError,
        ValueError,
        EOFError,
        RuntimeError,
    ) as problem:  # for broken files
        raise SketchError(
            f"The picture {path} is broken: {str(problem).rstrip('.')}.",
            hint="Open it in a picture editor and save it again.",
        ) from None


def load_image(caller: str, filename: str) -> Picture:
    """Return the picture that a sketch names, from its folders.

    Raises
    ------
    SketchError
        If there is no such file, or it is no picture.
    """
    return load_picture(find_file(caller, filename))


def to_bytes(floats: F32) -> U8:
    """Return colours as floats, (h, w, 3), cut to 0..1, as RGBA."""
    data = np.full((*floats.shape[:2], 4), 255, np.uint8)
    data[..., :3] = np.clip(np.nan_to_num(floats), 0, 1) * 255 + 0.5
    return data


def _floats(path: Path) -> F32 | None:
    """Return the floats in a file; None if it holds none."""
    with path.open("rb") as file:
        start = file.read(4)
    if start.startswith(RADIANCE):
        return read_radiance(path.read_bytes())
    return _read_exr(path) if start == OPEN_EXR else None


def _read_exr(path: Path) -> F32:
    try:
        import OpenEXR  # large, and few sketches need it
    except ImportError:
        raise SketchError(
            f"{path.name} is an EXR picture: they need a package of their own.",
            hint='Write pip install "sketchkit[hdr]", or save it as .hdr.',
        ) from None
    with OpenEXR.File(str(path)) as file:
        channels = file.channels()
        color = next((channels[name] for name in ("RGB", "RGBA", "Y") if name in channels), None)
        if color is None:
            raise ValueError("it has no colours by the names R, G and B")
        pixels = np.asarray(color.pixels, np.float32)
    return np.stack([pixels] * 3, axis=2) if pixels.ndim == 2 else pixels[..., :3].copy()


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
