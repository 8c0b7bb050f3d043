"""What a drawing refers to, as plain data with a version: images and the surfaces drawn on.

A backend keeps its own copy (a texture, a framebuffer) under the object's identity and makes it
anew when `version` has moved on.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray


class Wrap(IntEnum):
    """What a texture shows outside 0..1; the values are Processing's."""

    CLAMP = 0
    REPEAT = 1


@dataclass(eq=False)
class Pixels:
    """An image.

    Attributes
    ----------
    data : (h, w, 4) uint8
        Straight alpha, top row first, RGBA.
    version : int
        Raised by whoever changes `data`.
    mipmaps : bool
        Whether smaller copies (2x2 means) are used when it is drawn small.
    """

    data: NDArray[np.uint8]
    version: int = 0
    mipmaps: bool = True

    @property
    def width(self) -> int:
        """Columns of the image."""
        return int(self.data.shape[1])

    @property
    def height(self) -> int:
        """Rows of the image."""
        return int(self.data.shape[0])

    @property
    def across(self) -> int:
        """Width in the sketch's units: an image has a pixel for each."""
        return self.width

    @property
    def down(self) -> int:
        """Height in the sketch's units."""
        return self.height


@dataclass(eq=False)
class Target:
    """A surface that is drawn on: the main canvas, or one of `createGraphics()`.

    Attributes
    ----------
    width, height : int
        Columns and rows of pixels.
    samples : int
        1 or 4 per pixel.
    density : int
        How many pixels there are for each unit of the sketch, each way.
    top_row_first : bool
        Which way up it is rendered. The main canvas keeps row 0 of its buffer at the top of the
        picture, an offscreen one at the bottom: only so do the places of the samples and the fill
        rule agree with Processing's own frames.
    version : int
        Raised when size or samples change.
    is_noted : bool
        Whether a shader may read it while it is drawn on: it then finds the picture of before.
    """

    width: int
    height: int
    samples: int = 4
    top_row_first: bool = True
    version: int = 0
    is_noted: bool = False
    density: int = 1

    @property
    def across(self) -> int:
        """Width in the sketch's units."""
        return self.width // self.density

    @property
    def down(self) -> int:
        """Height in the sketch's units."""
        return self.height // self.density

    def turn_over(self) -> None:
        """Render it the other way up from now on."""
        self.top_row_first = not self.top_row_first

    def resize(self, across: int, down: int, samples: int, density: int) -> None:
        """Give the surface another size, in units; what was drawn on it is lost."""
        wanted = across * density, down * density, samples, density
        if wanted != (self.width, self.height, self.samples, self.density):
            self.width, self.height, self.samples, self.density = wanted
            self.version += 1


# What a shape can be covered with: an image, or the picture of another canvas.
Texture = Pixels | Target


@dataclass(frozen=True, eq=False)
class CubeMap:
    """Six square pictures of one size around a point, for shaders.

    Attributes
    ----------
    faces : six of Pixels or Target
        In OpenGL's order: those that +x, -x, +y, -y, +z and -z meet.
    """

    faces: tuple[Texture, ...]

    @property
    def side(self) -> int:
        """Columns of each face, and rows."""
        return self.faces[0].width
