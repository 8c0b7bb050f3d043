"""Pages for tests: what a drawing becomes, and the file of it as a picture."""

from __future__ import annotations

import io
from collections.abc import Callable

import numpy as np
import pypdfium2
import resvg_py
from PIL import Image

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import P2D
from sketchkit.draw.vertex import U8
from sketchkit.vector.page import Page
from sketchkit.vector.pdf import pdf_bytes
from sketchkit.vector.raw_reader import RawReader
from sketchkit.vector.shape_reader import ShapeReader
from sketchkit.vector.svg import svg_bytes
from tests.canvases import new_canvas

Drawing = Callable[[PGraphics], object]


def page_of(draw: Drawing, renderer: str = P2D) -> Page:
    """Return what `beginRecord()` makes of a drawing."""
    canvas = new_canvas(renderer)
    reader = ShapeReader(canvas.target, canvas.look)
    return _read(canvas, reader, draw)


def raw_page_of(draw: Drawing, renderer: str = P2D) -> Page:
    """Return what `beginRaw()` makes of a drawing."""
    canvas = new_canvas(renderer)
    return _read(canvas, RawReader(canvas.target, canvas.look), draw)


def _read(canvas: PGraphics, reader: ShapeReader | RawReader, draw: Drawing) -> Page:
    canvas.begin_reading(reader)
    draw(canvas)
    canvas.end_reading(reader)
    return reader.finish()


def picture_of(draw: Drawing, renderer: str = P2D) -> U8:
    """Return what the CPU renderer makes of a drawing, (h, w, 3)."""
    canvas = new_canvas(renderer, CpuBackend())
    draw(canvas)
    return canvas.image_data()[:, :, :3]


def svg_picture(page: Page) -> U8:
    """Return the SVG file of a page, drawn, (h, w, 3)."""
    svg = svg_bytes(page).decode("utf-8")
    return _on_white(Image.open(io.BytesIO(bytes(resvg_py.svg_to_bytes(svg_string=svg)))))


def pdf_picture(page: Page) -> U8:
    """Return the PDF file of a page, drawn, (h, w, 3)."""
    document = pypdfium2.PdfDocument(pdf_bytes(page))
    picture = document[0].render(scale=1).to_pil()
    document.close()
    return _on_white(picture)


def _on_white(picture: Image.Image) -> U8:
    white = Image.new("RGBA", picture.size, "white")
    return np.asarray(Image.alpha_composite(white, picture.convert("RGBA")).convert("RGB"))
