"""Images on a canvas: drawing, loading and making them, the background, and clipping."""

from __future__ import annotations

from typing import Protocol

from sketchkit.api._parts import BACKDROP, WHITE, CanvasParts
from sketchkit.api.color import ColorLike
from sketchkit.api.pimage import PImage
from sketchkit.api.vertices import pixels_of
from sketchkit.assets.pictures.images import EXTENSIONS
from sketchkit.core.color import pack
from sketchkit.core.constants import CENTER, CORNERS
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.float32 import f32
from sketchkit.core.matrix import IDENTITY, ortho
from sketchkit.core.notices import warn_once
from sketchkit.draw.pipeline import Clip
from sketchkit.draw.recorder import ROW, Kind, PackError, pack_row8
from sketchkit.draw.resources import Texture
from sketchkit.imaging.blits import Region

IMAGE = Kind.IMAGE.value
IMAGE_USAGE = (
    "image, x, y | image, x, y, width, height | image, x, y, width, height, u1, v1, u2, v2"
)
CREATEIMAGE_USAGE = "width, height, format"
CLIP_USAGE = "x, y, width, height"
WHOLE = (0.0, 0.0, 1.0, 1.0)
Box = tuple[float, float, float, float]


class Drawable(Protocol):
    """What has an image: a PImage, or a canvas of `createGraphics()`."""

    def _texture(self) -> Texture:
        """Return the image as it is now."""
        ...


class Images(CanvasParts):
    """Images, the background, and clipping."""

    def image(
        self,
        img: Drawable,
        a: float,
        b: float,
        c: float | None = None,
        d: float | None = None,
        *uv: float,
    ) -> None:
        """Draw an image; `imageMode()` gives the numbers their meaning.

        Parameters
        ----------
        img : PImage
            Or a canvas of `createGraphics()`.
        a, b : float, pixels
            At first: x and y of the top left corner.
        c, d : float, pixels, optional
            At first: width and height. Without them the image keeps its size.
        *uv : 4 int, optional
            The part of the image that is drawn, in its own pixels: left, top, right, bottom.

        Raises
        ------
        SketchError
            If it is no image, or there are not 2, 4 or 8 numbers.

        See Also
        --------
        loadImage, imageMode, tint, texture

        Notes
        -----
        `tint()` colours it, `fill()` does not. Source: Processing's reference, image().

        Examples
        --------
        >>> img = createImage(40, 40, RGB)
        >>> image(img, 10, 10)
        >>> image(img, 60, 10, 30, 80)
        """
        try:
            pixels = img._texture()
        except AttributeError:
            pixels = pixels_of("image", img)
        tint = WHITE if self._tint < 0 else self._tint
        try:
            part = _part(pixels, *uv) if uv else WHOLE
            self._pack_image(pixels, self._image_edges(pixels, a, b, c, d) + part, tint)
        except (*PackError, TypeError, ValueError):
            sizes = tuple(number for number in (c, d) if number is not None)
            self._refuse("image", (img, a, b, *sizes, *uv), IMAGE_USAGE)

    def _pack_image(self, pixels: Texture, numbers: tuple[float, ...], tint: int) -> None:
        """Record an image: left, top, right, bottom, and the same within the texture, 0..1."""
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        if end + ROW > len(recorder.rows):
            recorder.make_room()
        textures = recorder.textures
        if not textures or textures[-1] is not pixels:
            textures.append(pixels)
        link, fill, weight = len(textures) - 1, self._fill, self._weight
        pack_row8(recorder.rows, end, IMAGE, state, fill, tint, weight, link, *numbers)
        recorder.row_end = end + ROW

    def _image_edges(
        self, pixels: Texture, a: float, b: float, c: float | None, d: float | None
    ) -> Box:
        """Return left, top, right and bottom of an image."""
        if c is not None:
            if d is None:
                raise TypeError("a width without a height")
            return edges(self._image_mode, a, b, c, d)
        width, height = pixels.across, pixels.down
        if self._image_mode == CENTER:  # by whole pixels
            a, b = a - (width >> 1), b - (height >> 1)
        return a, b, a + width, b + height

    def loadImage(self, filename: str, extension: str | None = None) -> PImage:
        """Load an image from a file.

        Parameters
        ----------
        filename : str
            PNG, JPEG, GIF, BMP, TGA, TIFF or WebP; HDR (and EXR, with the extra `hdr`) for
            colours as floats, see `np_floats`. Looked for in the sketch's `data` folder, then
            beside the sketch.
        extension : str, optional
            The kind, `"png"`, for a name that does not show it. The file itself decides.

        Returns
        -------
        PImage

        Raises
        ------
        SketchError
            If there is no such file, or it is no picture.

        See Also
        --------
        image, requestImage, createImage, PImage

        Notes
        -----
        Load in `setup()`: in `draw()` the file would be read again in every frame. Source:
        Processing's reference, loadImage().

        Examples
        --------
        >>> img = loadImage("photo.png")
        >>> image(img, 0, 0)
        """
        if extension is not None and str(extension).lower().lstrip(".") not in EXTENSIONS:
            raise SketchError(
                "loadImage() reads no such kind of picture.",
                got=shown(extension),
                hint=f"Kinds are {', '.join(sorted(EXTENSIONS))}.",
            )
        return PImage._load("loadImage", filename)

    def createImage(self, w: int, h: int, format: int) -> PImage:
        """Make an image, to be filled with `set()` or `pixels`.

        Parameters
        ----------
        w, h : int, pixels
        format : RGB, ARGB or ALPHA
            RGB begins black; ARGB can have transparent pixels, and begins with them; ALPHA is a
            mask.

        Returns
        -------
        PImage

        Raises
        ------
        SketchError
            If the size is not above 0, or the format unknown.

        See Also
        --------
        loadImage, PImage

        Notes
        -----
        Source: Processing's reference, createImage().

        Examples
        --------
        >>> img = createImage(66, 66, RGB)
        >>> for i in range(len(img.pixels)):
        ...     img.pixels[i] = color(0, 90, 102)
        >>> img.updatePixels()
        >>> image(img, 17, 17)
        """
        return PImage(w, h, format)

    def background(self, *color: ColorLike | PImage) -> None:
        """Fill the whole canvas with a colour or an image.

        Parameters
        ----------
        *color : float, color, str or PImage
            As for `fill()`; or one image, as large as the canvas.

        Raises
        ------
        SketchError
            If the arguments make no colour, or the image has another size.

        See Also
        --------
        clear, fill, colorMode

        Notes
        -----
        Pixels are replaced, alpha included; of a 3D canvas the depths are forgotten too. An
        image with transparent pixels lies over the gray of an empty canvas. Source: Processing's
        reference, background().

        Examples
        --------
        >>> background(255, 204, 0)
        >>> rect(20, 20, 60, 60)
        """
        if len(color) == 1 and hasattr(color[0], "_texture"):
            self._background_image(pixels_of("background", color[0]))
        else:
            self._pack_whole(Kind.CLEAR, pack(self._color_mode, *color, name="background"))

    def clear(self) -> None:
        """Make the whole of a canvas of `createGraphics()` transparent.

        See Also
        --------
        background

        Notes
        -----
        In the window it does nothing, as in Processing. Source: Processing's reference, clear().

        Examples
        --------
        >>> pg = createGraphics(60, 60)
        >>> with pg:
        ...     pg.circle(30, 30, 40)
        ...     pg.clear()
        ...     pg.circle(30, 30, 20)
        >>> image(pg, 20, 20)
        """
        if self._is_offscreen:
            self._pack_whole(Kind.CLEAR, 0)
            return
        warn_once(
            "clear() is for canvases of createGraphics(): as in Processing, it does nothing in the "
            "window. background(0) makes that black."
        )

    def _background_image(self, pixels: Texture) -> None:
        """Clear, and draw an image over all."""
        width, height = self._target.width, self._target.height
        if (pixels.width, pixels.height) != (width, height):
            raise SketchError(
                "The image for background() is as large as the canvas.",
                got=f"{pixels.width} x {pixels.height} for a canvas of {width} x {height}",
                hint=f"Write img.resize({width}, {height}) after loading it.",
            )
        self._pack_whole(Kind.CLEAR, BACKDROP)
        self._draw_over(pixels, Region(0, 0, width, height))

    def _draw_over(self, pixels: Texture, placed: Region, part: Box = WHOLE) -> None:
        """Draw an image without matrix, depth, light and tint; clip and blend mode hold."""
        saved = self._stage, self._modelview
        width, height = self._target.width, self._target.height
        flat = ortho(0.0, width, -height, 0.0, -1.0, 1.0)
        self._restage(
            is_3d=False, projection=flat, depth_test=False, depth_write=False, lights=None
        )
        self._modelview = IDENTITY
        self._pack_image(pixels, (*placed.edges, *part), WHITE)
        self._stage, self._modelview = saved
        self._state = -1

    def clip(self, a: float, b: float, c: float, d: float) -> None:
        """Draw only within a rectangle from now on; `imageMode()` gives the numbers their meaning.

        Parameters
        ----------
        a, b, c, d : float, pixels
            At first: x and y of the top left corner, width and height; cut to whole pixels. The
            matrix does not move it.

        See Also
        --------
        noClip, imageMode

        Notes
        -----
        It holds for `background()` too, and in the frames that follow. Source: Processing's
        reference, clip().

        Examples
        --------
        >>> clip(20, 20, 60, 30)
        >>> circle(50, 50, 70)
        >>> noClip()
        """
        try:
            left, top, right, bottom = map(f32, edges(self._image_mode, a, b, c, d))
        except TypeError:
            self._refuse("clip", (a, b, c, d), CLIP_USAGE)
        # Processing hands the lower edge to OpenGL, counted from below, and cuts it off there.
        height = f32(bottom - top)
        below = int(f32(f32(self._target.down - top) - height))
        lower = self._target.down - below
        box = int(left), lower - int(height), int(f32(right - left)), int(height)
        self._restage(clip=Clip(*(self._target.density * side for side in box)))

    def noClip(self) -> None:
        """Draw everywhere again.

        Examples
        --------
        >>> clip(20, 20, 60, 30)
        >>> noClip()
        >>> circle(50, 50, 70)
        """
        if self._stage.clip is not None:
            self._restage(clip=None)


def edges(mode: int, a: float, b: float, c: float, d: float) -> Box:
    """Return left, top, right and bottom as `imageMode()` reads four numbers; never reversed."""
    if mode == CORNERS:
        left, top, right, bottom = a, b, c, d
    elif mode == CENTER:
        left, top, right, bottom = a - c / 2, b - d / 2, a + c / 2, b + d / 2
    else:
        left, top, right, bottom = a, b, a + c, b + d
    if right < left:
        left, right = right, left
    if bottom < top:
        top, bottom = bottom, top
    return left, top, right, bottom


def _part(pixels: Texture, u1: float, v1: float, u2: float, v2: float) -> Box:
    """Return a part of an image, given in whole pixels, as a part of its texture."""
    width, height = pixels.across, pixels.down
    return int(u1) / width, int(v1) / height, int(u2) / width, int(v2) / height
