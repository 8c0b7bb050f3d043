"""A page as a PDF file, of one page; a pixel is a point, 1/72 inch."""

from __future__ import annotations

import io
import zlib
from itertools import groupby

import numpy as np
import pydyf
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.draw.pipeline import Blend
from sketchkit.vector.page import Ink, Item, Mark, Page, Path, Picture, Rect, path_of, scaled

U8 = NDArray[np.uint8]

CAPS = {c.SQUARE: 0, c.ROUND: 1, c.PROJECT: 2}
JOINS = {c.MITER: 0, c.ROUND: 1, c.BEVEL: 2}
MITER_LIMIT = 10  # as on the canvas
BLENDS = {
    Blend.LIGHTEST: "Lighten",
    Blend.DARKEST: "Darken",
    Blend.EXCLUSION: "Exclusion",
    Blend.MULTIPLY: "Multiply",
    Blend.SCREEN: "Screen",
}


def pdf_bytes(page: Page) -> bytes:
    """Return the file; the same page gives the same bytes."""
    document = pydyf.PDF()
    writer = _Writer(document)
    content = pydyf.Stream(compress=True)
    content.set_matrix(1, 0, 0, -1, 0, page.height)  # y runs down from here on
    writer.write(page, content)
    document.add_object(content)
    document.add_page(
        pydyf.Dictionary(
            {
                "Type": "/Page",
                "Parent": document.pages.reference,
                "MediaBox": pydyf.Array([0, 0, page.width, page.height]),
                "Contents": content.reference,
                "Resources": writer.resources.reference,
                "Group": _group(),
            }
        )
    )
    file = io.BytesIO()
    document.write(file)
    return file.getvalue()


def _group() -> pydyf.Dictionary:
    """Return what makes a page, or a part of one, blend as a whole, and in RGB."""
    return pydyf.Dictionary({"S": "/Transparency", "CS": "/DeviceRGB"})


class _Writer:
    """Writes items into streams.

    Attributes
    ----------
    resources : Dictionary
        What all streams refer to by name.
    """

    def __init__(self, document: pydyf.PDF) -> None:
        self._document = document
        self._states = pydyf.Dictionary()
        self._objects = pydyf.Dictionary()
        self.resources = pydyf.Dictionary({"ExtGState": self._states, "XObject": self._objects})
        document.add_object(self.resources)

    def write(self, page: Page, out: pydyf.Stream) -> None:
        """Write everything that is on a page."""
        for (clip, blend), items in groupby(page.items, key=lambda item: item.setting):
            out.push_state()
            if clip is not None:
                _cut(path_of(Rect(*clip)), out)
            if blend in BLENDS:
                out.set_state(self._state("BM", f"/{BLENDS[blend]}"))
            for item in items:
                out.push_state()
                self._write_item(item, out)
                out.pop_state()
            out.pop_state()

    def _write_item(self, item: Item, out: pydyf.Stream) -> None:
        match item:
            case Mark(outline, ink, _, matrix):
                out.set_matrix(*matrix)
                self._paint(path_of(outline), ink, out)
            case Picture(image, _, matrix, within, opacity):
                if within is not None:
                    _cut(within, out)
                self._set_opacity("ca", round(255 * opacity), out)
                if isinstance(image, Page):
                    out.set_matrix(*scaled(matrix, image.width, image.height))
                    out.draw_x_object(self._form(image))
                else:  # its first row is at the top of the unit square, y up
                    out.set_matrix(*matrix)
                    out.set_matrix(1, 0, 0, -1, 0, 1)
                    out.draw_x_object(self._image(image))

    def _paint(self, path: Path, ink: Ink, out: pydyf.Stream) -> None:
        # Not in one step: PDF would leave out the fill below a translucent stroke.
        if ink.fill >= 0:
            out.set_color_rgb(*_rgb(ink.fill))
            self._set_opacity("ca", ink.fill >> 24, out)
            _trace(path, out)
            out.fill()
        if ink.stroke >= 0:
            out.set_color_rgb(*_rgb(ink.stroke), stroke=True)
            self._set_opacity("CA", ink.stroke >> 24, out)
            out.set_line_width(float(ink.weight))
            out.set_line_cap(CAPS[ink.cap])
            out.set_line_join(JOINS[ink.join])
            out.set_miter_limit(MITER_LIMIT)
            _trace(path, out)
            out.stroke()

    def _set_opacity(self, name: str, alpha: int, out: pydyf.Stream) -> None:
        """Set how opaque fills ("ca") or strokes ("CA") are, 0..255."""
        if alpha < 255:
            out.set_state(self._state(name, round(alpha / 255, 4)))

    def _state(self, key: str, value: object) -> str:
        """Return the name of a graphics state with one entry."""
        name = f"{key}{value}".replace("/", "")
        self._states.setdefault(name, pydyf.Dictionary({key: value}))
        return name

    def _image(self, pixels: U8) -> str:
        """Return the name of an image, its alpha being an image of its own."""
        mask = self._add_image(pixels[..., 3], "/DeviceGray")
        image = self._add_image(pixels[..., :3], "/DeviceRGB", SMask=mask.reference)
        return self._name(image)

    def _add_image(self, samples: U8, colors: str, **more: object) -> pydyf.Stream:
        image = pydyf.Stream(
            [zlib.compress(np.ascontiguousarray(samples).tobytes(), 9)],
            {
                "Type": "/XObject",
                "Subtype": "/Image",
                "Width": samples.shape[1],
                "Height": samples.shape[0],
                "ColorSpace": colors,
                "BitsPerComponent": 8,
                "Interpolate": "true",
                "Filter": "/FlateDecode",
                **more,
            },
        )
        self._document.add_object(image)
        return image

    def _form(self, page: Page) -> str:
        """Return the name of a page that lies on another."""
        form = pydyf.Stream(
            [],
            {
                "Type": "/XObject",
                "Subtype": "/Form",
                "BBox": pydyf.Array([0, 0, page.width, page.height]),
                "Resources": self.resources.reference,
                "Group": _group(),
            },
            compress=True,
        )
        self.write(page, form)
        self._document.add_object(form)
        return self._name(form)

    def _name(self, stream: pydyf.Stream) -> str:
        name = f"X{len(self._objects)}"
        self._objects[name] = stream.reference
        return name


def _rgb(color: int) -> tuple[float, float, float]:
    red, green, blue = (color >> shift & 255 for shift in (16, 8, 0))
    return red / 255, green / 255, blue / 255


def _trace(path: Path, out: pydyf.Stream) -> None:
    """Make a path the current one."""
    steps = {"M": (1, out.move_to), "L": (1, out.line_to), "C": (3, out.curve_to)}
    numbers = iter(path.points.ravel().tolist())
    for letter in path.letters:
        if letter == "Z":
            out.close()
            continue
        count, step = steps[letter]
        step(*(next(numbers) for _ in range(2 * count)))


def _cut(path: Path, out: pydyf.Stream) -> None:
    """Show what follows within a path alone."""
    _trace(path, out)
    out.clip()
    out.end()
