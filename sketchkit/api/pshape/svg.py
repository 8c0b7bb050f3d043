"""SVG drawings as shapes that are kept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import BLACK, WHITE
from sketchkit.api.pimage import PImage
from sketchkit.api.pshape.parts import Family
from sketchkit.api.pshape.shape import PrimitiveShape, PShape
from sketchkit.assets.svg.drawing import SvgNode, load_svg, outline_of
from sketchkit.assets.svg.gradient_pictures import gradient_picture
from sketchkit.assets.svg.gradients import Gradient
from sketchkit.assets.svg.paths import POINTS_OF, Outline
from sketchkit.assets.svg.styles import SvgStyle
from sketchkit.core import constants as c
from sketchkit.core.notices import warn_once


def svg_shape(canvas: CanvasParts, path: Path) -> PShape:
    """Return the drawing in an SVG file.

    Raises
    ------
    SketchError
        If the file is broken; it names the line.
    """
    drawing = load_svg(path)
    for remark in drawing.remarks:
        warn_once(remark)
    shape = _shape_of(canvas, drawing.root)
    shape._document_size = drawing.width, drawing.height
    return shape


def _shape_of(canvas: CanvasParts, node: SvgNode) -> PShape:
    """Return a node with everything in it."""
    gradient = node.style.fill_gradient if canvas._stage.is_java2d else None  # others show none
    outline = node.outline if gradient is None else outline_of(node)
    if node.kind == c.GROUP:
        shape = PShape(canvas, Family.GROUP)
        for child in node.children:
            shape.addChild(_shape_of(canvas, child))
    elif outline is not None:
        shape = _path(canvas, outline, node.style)
        if gradient is not None:
            _show_gradient(shape, gradient)
    else:
        shape = PrimitiveShape(canvas, node.kind, node.numbers, lambda pen: _wear(pen, node.style))
    if node.name is not None:
        shape.setName(node.name)
    if node.matrix is not None:
        shape._matrix = shape._own_steps = node.matrix
    shape._is_visible = node.is_visible
    return shape


def _wear(shape: PShape, style: SvgStyle) -> None:
    """Give a shape the look that the file gives it; numbers mean what they mean in SVG."""
    shape._fill = ~BLACK if style.fill is None else style.fill
    shape._stroke = ~BLACK if style.stroke is None else style.stroke
    shape._weight = style.stroke_weight
    shape._style = replace(
        shape._style,
        stroke_cap=style.stroke_cap,
        stroke_join=style.stroke_join,
        rect_mode=c.CORNER,
        ellipse_mode=c.CORNER,
    )


def _path(canvas: CanvasParts, outline: Outline, style: SvgStyle) -> PShape:
    """Return a path: its corners, its curves, and its holes."""
    shape = PShape(canvas, Family.PATH)
    shape._is_read_path = bool(outline.codes)
    _wear(shape, style)
    shape.beginShape()
    calls: dict[int, Callable[..., None]] = {
        c.VERTEX: shape.vertex,
        c.BEZIER_VERTEX: shape.bezierVertex,
        c.QUADRATIC_VERTEX: shape.quadraticVertex,
    }
    is_inner = False
    places = iter(outline.vertices.tolist())
    for code in outline.codes or (c.VERTEX,) * len(outline.vertices):
        if code == c.BREAK:
            if is_inner:
                shape.endContour()
            shape.beginContour()
            is_inner = True
            continue
        numbers = [number for _ in range(POINTS_OF[code]) for number in next(places)]
        calls[code](*numbers)
    if is_inner:
        shape.endContour()
    shape.endShape(c.CLOSE if outline.is_closed else None)
    return shape


def _show_gradient(shape: PShape, gradient: Gradient) -> None:
    """Lay a picture of a gradient over a path."""
    places = shape._corner_places()[:, :2].copy()  # of what is about to grow
    if not len(places):
        return
    low, high = places.min(axis=0), places.max(axis=0)
    size = np.where(high > low, high - low, 1)
    shape._fill = WHITE
    shape.setTextureMode(c.NORMAL)
    box = (float(low[0]), float(low[1]), float(size[0]), float(size[1]))
    shape.setTexture(PImage._of(gradient_picture(gradient, box), c.ARGB))
    shape._recorder.uv_array()[:] = (places - low) / size
    shape._corner_column("fill", WHITE)
