"""Images and letters to items of a page; textures as images that are cut to their faces."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.fonts.glyph_atlas import Sheet
from sketchkit.assets.fonts.letters import BITMAPS
from sketchkit.assets.fonts.outlines import letter_outline
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.commands import Upload
from sketchkit.draw.resources import Pixels, Target, Texture
from sketchkit.draw.rows import Rows
from sketchkit.vector.page import Item, Mark, Matrix, Page, Path, Picture, Setting, polyline
from sketchkit.vector.views import View

F64 = NDArray[np.float64]
U8 = NDArray[np.uint8]

WHITE = 0xFFFFFFFF
OPAQUE = 0xFF000000
SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])  # all of an image
ALMOST_FLAT = 0.5  # px: how far a face's corners may be off for one image to cover all of it


def image_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield an image, in its tint."""
    texture = rows.recorder.textures[rows.links[row]]
    numbers = rows.numbers[row].astype(np.float64).tolist()
    tint = int(rows.strokes[row])
    if isinstance(texture, Sheet) and (path := _letter(texture, numbers)):
        yield view.mark(path, view.ink(tint, NO_COLOR, 0.0))
        return
    left, top, right, bottom, u1, v1, u2, v2 = numbers
    places = np.array([(left, top), (right, top), (right, bottom), (left, bottom)])
    if isinstance(texture, Pixels):
        pixels = tinted(part_of(texture, u1, v1, u2, v2), tint)
        yield from _covered(view, pixels, places, SQUARE)
    else:
        uvs = np.array([(u1, v1), (u2, v1), (u2, v2), (u1, v2)])
        yield from textured_items(view, texture, places, uvs, tint)


def _letter(sheet: Sheet, numbers: list[float]) -> Path | None:
    """Return the outline of the letter whose image was drawn; None if it has none."""
    left, top, right, _, u1, v1, u2, _ = numbers
    column, row = round(u1 * sheet.width), round(v1 * sheet.height)
    path = letter_path(sheet, column, row)
    if path is None:
        return None
    enlarged = (right - left) / (round(u2 * sheet.width) - column)
    return Path(path.letters, (path.points - (column, row)) * enlarged + (left, top))


def letter_path(sheet: Sheet, column: int, row: int) -> Path | None:
    """Return the outline of the letter whose image begins there, as it lies in the sheet."""
    letter = sheet.letters.get((column, row))
    if letter is None or letter.face.path.lower().endswith(BITMAPS):
        return None
    steps, points = letter_outline(letter.face.path, letter.character)
    return Path(steps, points * letter.size + (column - letter.left, row - letter.top))


def upload_picture(upload: Upload) -> Picture:
    """Return pixels that were set on the canvas itself."""
    height, width, _ = upload.data.shape
    return Picture(upload.data, Setting(), (width, 0.0, 0.0, height, upload.left, upload.top))


def part_of(image: Pixels, u1: float, v1: float, u2: float, v2: float) -> U8:
    """Return a part of an image, given as 0..1 of it, in whole pixels; turned over if u2 < u1."""
    columns = _span(u1, u2, image.width)
    rows = _span(v1, v2, image.height)
    return image.data[rows[0] : rows[1], columns[0] : columns[1]][:: rows[2], :: columns[2]]


def _span(start: float, stop: float, size: int) -> tuple[int, int, int]:
    """Return first, last + 1 and direction."""
    low, high = sorted((round(start * size), round(stop * size)))
    low = min(max(low, 0), size - 1)
    return low, max(min(high, size), low + 1), 1 if start <= stop else -1


def tinted(pixels: U8, tint: int) -> U8:
    """Return pixels multiplied with a packed colour."""
    if tint in (WHITE, NO_COLOR):
        return pixels
    factors = np.array([tint >> 16 & 255, tint >> 8 & 255, tint & 255, tint >> 24], np.uint16)
    return ((pixels * factors + 127) // 255).astype(np.uint8)


def tinted_page(page: Page, tint: int) -> Page:
    """Return a page as it is now, in the colours of a tint."""
    items = list(page.items)
    if tint not in (WHITE, NO_COLOR):
        items = [_tinted_item(item, tint) for item in items]
    return Page(page.width, page.height, items)


def _tinted_item(item: Item, tint: int) -> Item:
    if isinstance(item, Mark):
        fill, stroke = (_tinted_color(color, tint) for color in item.ink[:2])
        return replace(item, ink=item.ink._replace(fill=fill, stroke=stroke))
    image = item.image
    own = tinted_page(image, tint) if isinstance(image, Page) else tinted(image, tint)
    return replace(item, image=own)


def _tinted_color(color: int, tint: int) -> int:
    if color < 0:
        return color
    return sum(
        ((color >> shift & 255) * (tint >> shift & 255) + 127) // 255 << shift
        for shift in (24, 16, 8, 0)
    )


def textured_items(
    view: View, texture: Texture, places: F64, uvs: F64, tint: int
) -> Iterator[Item | None]:
    """Yield an image that covers a face.

    `places` is (k, 2 or 3), `uvs` (k, 2), 0..1 over the image.
    """
    image, opacity = tinted_picture(texture, tint, view.page_of)
    for picture in _covered(view, image, places, uvs):
        yield replace(picture, opacity=opacity)


def tinted_picture(
    texture: Texture, tint: int, page_of: Callable[[Target], Page]
) -> tuple[U8 | Page, float]:
    """Return an image, or another canvas' page, in the colours of a tint; and how opaque it is."""
    if isinstance(texture, Pixels):
        return tinted(texture.data, tint), 1.0
    return tinted_page(page_of(texture), tint | OPAQUE), (tint >> 24) / 255


def _covered(view: View, image: U8 | Page, places: F64, uvs: F64) -> Iterator[Picture]:
    """Yield an image once, or, if it does not lie flat, once for each triangle of a fan."""
    points = view.on_page(places)
    if points is None:
        return
    fans = [np.arange(len(points))]
    if fitted(points, uvs) is None:
        fans = [np.array([0, i, i + 1]) for i in range(1, len(points) - 1)]
    for fan in fans:
        matrix = fitted(points[fan], uvs[fan])
        if matrix is not None:
            is_whole = uvs[fan].tolist() == SQUARE.tolist()
            within = None if is_whole else polyline(points[fan], is_closed=True)
            yield Picture(image, view.setting, matrix, within)


def fitted(points: F64, uvs: F64) -> Matrix | None:
    """Return the matrix that brings all u, v to the points, (k, 2) each, if there is one."""
    columns = np.hstack([uvs, np.ones((len(uvs), 1))])
    solution, _, rank, _ = np.linalg.lstsq(columns, points, rcond=None)
    if rank < 3 or np.abs(columns @ solution - points).max() > ALMOST_FLAT:
        return None
    (a, b), (c, d), (e, f) = solution.tolist()
    return a, b, c, d, e, f
