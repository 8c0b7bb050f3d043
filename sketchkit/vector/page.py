"""Page: a vector picture as plain data, in the order of drawing. Writers make a file of it.

Coordinates are pixels of the canvas, y down; a mark's own matrix brings its outline there.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import MITER, ROUND
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.pipeline import Blend, Clip

F64 = NDArray[np.float64]
U8 = NDArray[np.uint8]

# a, b, c, d, e, f: x' = a x + c y + e and y' = b x + d y + f, as SVG and PDF write it.
Matrix = tuple[float, float, float, float, float, float]
IDENTITY: Matrix = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)

# How far the control points of a quarter of the unit circle are along its tangents.
QUARTER = 4 / 3 * (np.sqrt(2) - 1)
QUARTERS = np.array(
    [
        *[(1, 0), (1, QUARTER), (QUARTER, 1), (0, 1), (-QUARTER, 1), (-1, QUARTER), (-1, 0)],
        *[(-1, -QUARTER), (-QUARTER, -1), (0, -1), (QUARTER, -1), (1, -QUARTER), (1, 0)],
    ]
)


class Path(NamedTuple):
    """Lines and curves.

    Attributes
    ----------
    letters : str
        M begins at a point, L is a line to one, C a cubic curve by two control points to a third,
        Z goes back to the last M.
    points : (n, 2) float64
        Of all letters, one after the other.
    """

    letters: str
    points: F64


class Rect(NamedTuple):
    """A rectangle along the axes."""

    x: float
    y: float
    width: float
    height: float


class Ellipse(NamedTuple):
    """An ellipse along the axes: its centre and its half sizes."""

    x: float
    y: float
    half_width: float
    half_height: float


Outline = Path | Rect | Ellipse


class Ink(NamedTuple):
    """How an outline is painted; colours are packed ARGB or NO_COLOR.

    Attributes
    ----------
    weight : float
        Of the stroke, in the outline's own units.
    """

    fill: int = NO_COLOR
    stroke: int = NO_COLOR
    weight: float = 1.0
    cap: int = ROUND
    join: int = MITER


class Setting(NamedTuple):
    """What concerns all that is drawn on a page, whatever it is: where, and how it is mixed in."""

    clip: Clip | None = None
    blend: Blend = Blend.BLEND


@dataclass(frozen=True, eq=False, slots=True)
class Mark:
    """A painted outline."""

    outline: Outline
    ink: Ink
    setting: Setting
    matrix: Matrix = IDENTITY


@dataclass(frozen=True, eq=False, slots=True)
class Picture:
    """An image, or another page.

    Attributes
    ----------
    image : (h, w, 4) uint8, straight alpha, or Page
    matrix : Matrix
        From the unit square to the page.
    within : Path or None
        The part of the page that it is cut to.
    opacity : float, 0..1
    """

    image: U8 | Page
    setting: Setting
    matrix: Matrix
    within: Path | None = None
    opacity: float = 1.0


Item = Mark | Picture


@dataclass(eq=False)
class Page:
    """A picture: what is on it, the lowest first."""

    width: int
    height: int
    items: list[Item] = field(default_factory=list)

    def clear(self, color: int, clip: Clip | None) -> None:
        """Cover everything with a colour; without a clip nothing is left of what was there."""
        if clip is None:
            self.items.clear()
        if color >> 24:
            whole = Rect(0, 0, self.width, self.height)
            self.items.append(Mark(whole, Ink(fill=color), Setting(clip)))


def polyline(points: F64, *, is_closed: bool) -> Path:
    """Return straight lines through points, (n, 2)."""
    return Path("M" + "L" * (len(points) - 1) + "Z" * is_closed, points)


def joined(faces: list[F64]) -> Path:
    """Return closed faces, (k, 2 or 3) each, as one path that covers them all."""
    turned = [corners if _is_clockwise(corners) else corners[::-1] for corners in faces]
    letters = "".join("M" + "L" * (len(corners) - 1) + "Z" for corners in turned)
    return Path(letters, np.vstack(turned))


def _is_clockwise(corners: F64) -> bool:
    """Return in which sense a face runs: where two of different senses overlap would be a hole."""
    x, y = corners[:, 0], corners[:, 1]
    return bool((x * np.roll(y, -1) - y * np.roll(x, -1)).sum() >= 0)


def path_of(outline: Outline) -> Path:
    """Return an outline as lines and curves."""
    if isinstance(outline, Path):
        return outline
    x, y, width, height = outline
    if isinstance(outline, Rect):
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        return polyline(np.array(corners, np.float64), is_closed=True)
    return Path("MCCCCZ", QUARTERS * (width, height) + (x, y))


def scaled(matrix: Matrix, width: float, height: float) -> Matrix:
    """Return a matrix from a rectangle of some size, instead of one from the unit square."""
    a, b, c, d, e, f = matrix
    return a / width, b / width, c / height, d / height, e, f
