"""What a finished shape looks like: as a whole, and vertex by vertex."""

from __future__ import annotations

from typing import overload

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import WHITE
from sketchkit.api.color import ColorLike
from sketchkit.api.paint import CAPS, JOINS, check_choice
from sketchkit.api.pshape.materials import ShapeMaterials, packed_color
from sketchkit.api.pshape.parts import Look
from sketchkit.api.textures import TEXTURE_MODES
from sketchkit.api.vertices import pixels_of
from sketchkit.core.errors import wrong_numbers
from sketchkit.draw.retain import Quality

FILL_CHANGE_USAGE = "color | True or False | index, color"


class ShapeLooks(ShapeMaterials):
    """Setting colours after `endShape()`, of a whole tree at once."""

    @overload
    def setFill(self, fill: bool | ColorLike, /) -> None: ...
    @overload
    def setFill(self, index: int, fill: ColorLike, /) -> None: ...
    def setFill(self, *change: ColorLike) -> None:
        """Set the fill colour of the whole shape, or of one vertex; or whether it is filled.

        Parameters
        ----------
        *change : color, bool, or int and color
            A colour of `color()` or a string; True or False; a vertex and its colour. Of a group
            all children are changed.

        Raises
        ------
        SketchError
            If it is no colour, or there is no such vertex.

        See Also
        --------
        setStroke, setTint, disableStyle

        Notes
        -----
        A textured shape shows `setTint()` instead. Processing (4.3) shows a vertex's colour only if
        it was set before the shape was first drawn; here it always shows. Source: Processing's
        reference, PShape.setFill().

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setFill(color(255, 204, 0))
        >>> shape(s)
        """
        self._must_be_ended("setFill")
        match change:
            case (bool(is_filled),):
                for leaf in self._leaves():
                    leaf._switch_fill(is_filled)
            case (color,):
                packed = packed_color("setFill", color)
                for leaf in self._leaves():
                    leaf._fill_with(packed)
            case (index, color):
                self._set_corner("fill", Quality.FILL, index, packed_color("setFill", color))
            case _:
                raise wrong_numbers("setFill", change, FILL_CHANGE_USAGE, (1, 2))

    @overload
    def setStroke(self, stroke: bool | ColorLike, /) -> None: ...
    @overload
    def setStroke(self, index: int, stroke: ColorLike, /) -> None: ...
    def setStroke(self, *change: ColorLike) -> None:
        """Set the colour of the outline, or of one vertex of it; or whether there is one.

        Parameters
        ----------
        *change : color, bool, or int and color
            As of `setFill()`.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setStroke(color(255, 0, 0))
        >>> s.setStrokeWeight(4)
        >>> shape(s)
        """
        self._must_be_ended("setStroke")
        match change:
            case (bool(is_stroked),):
                for leaf in self._leaves():
                    leaf._switch_stroke(is_stroked)
            case (color,):
                packed = packed_color("setStroke", color)
                for leaf in self._leaves():
                    leaf._stroke_with(packed)
            case (index, color):
                self._set_corner("stroke", Quality.STROKE, index, packed_color("setStroke", color))
            case _:
                raise wrong_numbers("setStroke", change, FILL_CHANGE_USAGE, (1, 2))

    @overload
    def setTint(self, tint: bool | ColorLike, /) -> None: ...
    @overload
    def setTint(self, index: int, tint: ColorLike, /) -> None: ...
    def setTint(self, *change: ColorLike) -> None:
        """Set in which colour a textured shape shows its image; False is without any.

        Parameters
        ----------
        *change : color, bool, or int and color
            As of `setFill()`.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setTexture(loadImage("photo.png"))
        >>> s.setTint(color(255, 204, 0))
        >>> shape(s)
        """
        self._must_be_ended("setTint")
        match change:
            case (bool(is_tinted),):
                if not is_tinted:
                    for leaf in self._leaves():
                        leaf._tint_with(WHITE)
            case (color,):
                packed = packed_color("setTint", color)
                for leaf in self._leaves():
                    leaf._tint_with(packed)
            case (index, color):
                if self._texture_source is not None:
                    self._set_corner("fill", Quality.FILL, index, packed_color("setTint", color))
            case _:
                raise wrong_numbers("setTint", change, FILL_CHANGE_USAGE, (1, 2))

    def setStrokeWeight(self, *change: float) -> None:
        """Set how wide the outline is, in pixels: of the whole shape, or from one vertex on.

        Parameters
        ----------
        *change : float, or int and float
            A weight; or a vertex and its weight.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setStrokeWeight(5)
        >>> shape(s)
        """
        self._must_be_ended("setStrokeWeight")
        try:
            weight = change[-1] + 0.0
        except (IndexError, TypeError):
            raise wrong_numbers("setStrokeWeight", change, "weight | index, weight") from None
        if len(change) == 2:
            self._set_attribute(self._corner_index("setStrokeWeight", change[0]), weight=weight)
            self._expand_anew()
            return
        for leaf in self._leaves():
            if leaf._weight != weight:
                leaf._weight = weight
                leaf._row_column("weight", weight)
                leaf._all_attributes(weight=weight)
                leaf._expand_anew()

    def setStrokeCap(self, cap: int) -> None:
        """Set the ends of lines: ROUND, SQUARE or PROJECT. In P3D it shows at points alone.

        Examples
        --------
        >>> s = createShape(LINE, 20, 20, 80, 80)
        >>> s.setStrokeWeight(10)
        >>> s.setStrokeCap(SQUARE)
        >>> shape(s)
        """
        check_choice("setStrokeCap", cap, CAPS)
        for leaf in self._leaves():
            leaf._restyle_rows(stroke_cap=cap)

    def setStrokeJoin(self, join: int) -> None:
        """Set the corners of outlines: MITER, BEVEL or ROUND. In P3D they are always bevelled.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setStrokeWeight(10)
        >>> s.setStrokeJoin(ROUND)
        >>> shape(s)
        """
        check_choice("setStrokeJoin", join, JOINS)
        for leaf in self._leaves():
            leaf._restyle_rows(stroke_join=join)

    def setTexture(self, tex: object) -> None:
        """Cover the shape with an image; None takes it off.

        Parameters
        ----------
        tex : PImage, PGraphics or None
            On rectangles, quads, boxes and spheres it lies as a whole; on other shapes where u and
            v of `vertex()` say.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> globe = createShape(SPHERE, 40)
        >>> globe.setStroke(False)
        >>> globe.setTexture(loadImage("photo.png"))
        >>> shape(globe, 50, 50)
        """
        self._must_be_ended("setTexture")
        texture = None if tex is None else pixels_of("setTexture", tex)
        for leaf in self._leaves():
            leaf._cover_with(texture)
            leaf._texture_source = tex
            leaf._expand_anew()

    def setTextureMode(self, mode: int) -> None:
        """Set the units of `setTextureUV()`: IMAGE for pixels of the image, NORMAL for 0 to 1.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.setTextureMode(NORMAL)
        """
        check_choice("setTextureMode", mode, TEXTURE_MODES)
        for leaf in self._leaves():
            leaf._texture_mode = mode

    def disableStyle(self) -> None:
        """Let the shape take fill, stroke and tint from the sketch when it is drawn.

        See Also
        --------
        enableStyle, setFill

        Notes
        -----
        Source: Processing's reference, PShape.disableStyle().

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.disableStyle()
        >>> fill(255, 0, 0)
        >>> shape(s)
        """
        self._must_be_ended("disableStyle")
        self._put_aside = Look(self._fill, self._stroke, self._tint, self._weight, self._style)
        self._version += 1
        for member in self._members():
            member.disableStyle()

    def enableStyle(self) -> None:
        """Take back the shape's own look, after `disableStyle()`.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.disableStyle()
        >>> s.enableStyle()
        >>> fill(255, 0, 0)
        >>> shape(s)
        """
        if self._put_aside is not None and not self._is_group:
            self._wear(self._put_aside)
        self._put_aside = None
        for member in self._members():
            member.enableStyle()

    def _wear_look_of(self, canvas: CanvasParts) -> None:
        """Take over the look of the sketch, after `disableStyle()`."""
        look = Look(canvas._fill, canvas._stroke, canvas._tint, canvas._weight, canvas._style)
        for leaf in self._leaves():
            leaf._wear(look)

    def _wear(self, look: Look) -> None:
        """Change only what differs: the shape may be drawn so in every frame."""
        self._switch_fill(look.fill >= 0)
        if look.fill >= 0:
            self._fill_with(look.fill)
        self._switch_stroke(look.stroke >= 0)
        if look.stroke >= 0:
            self._stroke_with(look.stroke)
            self.setStrokeWeight(look.weight)
            self._restyle_rows(stroke_cap=look.style.stroke_cap, stroke_join=look.style.stroke_join)
        if look.tint >= 0:
            self._tint_with(look.tint)
        if self._style.material != look.style.material:
            self._restyle_rows(material=look.style.material)

    def _switch_fill(self, is_filled: bool) -> None:
        if is_filled != (self._fill >= 0):
            self._fill = ~self._fill
            if self._texture_source is None:
                self._row_column("fill", self._fill)
            self._expand_anew()

    def _switch_stroke(self, is_stroked: bool) -> None:
        if is_stroked != (self._stroke >= 0):
            self._stroke = ~self._stroke
            self._row_column("stroke", self._stroke)
            self._expand_anew()

    def _fill_with(self, color: int) -> None:
        """Give all corners one fill; a shape that is not filled will be in it, once it is."""
        was_filled = self._fill >= 0
        if color == (self._fill if was_filled else ~self._fill):
            return
        self._fill = color if was_filled else ~color
        if self._texture_source is not None and not self._is_primitive:
            self._row_column("fill", color)  # its colour in ambient light
            self._expand_anew()
            return
        self._row_column("fill", self._fill)
        self._corner_column("fill", color)
        self._repaint(Quality.FILL, color)

    def _stroke_with(self, color: int) -> None:
        was_stroked = self._stroke >= 0
        if color == (self._stroke if was_stroked else ~self._stroke):
            return
        self._stroke = color if was_stroked else ~color
        self._row_column("stroke", self._stroke)
        self._corner_column("stroke", color)
        self._repaint(Quality.STROKE, color)

    def _tint_with(self, color: int) -> None:
        if color == self._tint:
            return
        self._tint = color
        if self._texture_source is not None:
            self._corner_column("fill", color)
            if self._is_primitive:
                self._row_column("fill", color)
            self._repaint(Quality.FILL, color)
