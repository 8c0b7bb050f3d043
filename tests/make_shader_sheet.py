"""Make sketches/shaders/gallery.png anew: each sketch of that folder, small, in one picture.

    python -m tests.make_shader_sheet

The gallery's test compares with it, and people see from it what there is.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from sketchkit.backends.gl.executor import GlBackend
from sketchkit.draw.vertex import U8
from sketchkit.runtime.headless import Launch, render

SHADERS = Path(__file__).parents[1] / "sketches" / "shaders"
SHEET = SHADERS / "gallery.png"
FRAME = 30
SHRINKING = 4  # times: then what another driver does at edges hardly shows
WIDTH, HEIGHT = 560 // SHRINKING, 420 // SHRINKING  # of a cell; all sketches have one size
COLUMNS = 5


def shader_sketches() -> list[Path]:
    """Return the sketches in the order of the sheet."""
    return sorted(SHADERS.glob("*.py"))


def small(picture: U8) -> U8:
    """Return the means of blocks of pixels, (h, w, 3)."""
    blocks = picture.reshape(HEIGHT, SHRINKING, WIDTH, SHRINKING, 3)
    means: U8 = np.rint(blocks.mean(axis=(1, 3))).astype(np.uint8)
    return means


def cell_of(sketch: Path) -> U8:
    """Return what the sheet has of a sketch."""
    top, left = place_of(shader_sketches().index(sketch))
    with Image.open(SHEET) as sheet:
        return np.asarray(sheet.convert("RGB"))[top : top + HEIGHT, left : left + WIDTH]


def place_of(index: int) -> tuple[int, int]:
    """Return the upper left corner of a cell: row and column."""
    return index // COLUMNS * HEIGHT, index % COLUMNS * WIDTH


def main() -> None:
    """Draw all sketches, and write the sheet."""
    sketches = shader_sketches()
    rows = -(-len(sketches) // COLUMNS)
    sheet = np.zeros((rows * HEIGHT, COLUMNS * WIDTH, 3), np.uint8)
    backend = GlBackend.headless()
    for index, sketch in enumerate(sketches):
        top, left = place_of(index)
        (frame,) = render(Launch(sketch, lambda *_: None), (FRAME,), backend)
        sheet[top : top + HEIGHT, left : left + WIDTH] = small(frame.pixels)
    backend.close()
    Image.fromarray(sheet).save(SHEET, optimize=True)


if __name__ == "__main__":
    main()
