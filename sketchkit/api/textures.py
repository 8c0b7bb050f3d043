"""Textures: images on the shapes of beginShape()."""

from __future__ import annotations

from sketchkit.api._pen import OpenShape
from sketchkit.api.paint import check_choice
from sketchkit.api.vertices import Vertices, pixels_of
from sketchkit.core import constants as c
from sketchkit.draw.recorder import CORNER, UV, Recorder, pack_uv

TEXTURE_MODES = {c.IMAGE: "IMAGE", c.NORMAL: "NORMAL"}


class Textures(Vertices):
    """The texture of the shape that is open, and how its coordinates are read."""

    def texture(self, image: object) -> None:
        """Cover the shape that is open with an image.

        Parameters
        ----------
        image : PImage
            Where it goes, `vertex()` says with u and v.

        Raises
        ------
        SketchError
            If no shape is open, or it is no image.

        See Also
        --------
        textureMode, textureWrap, vertex

        Examples
        --------
        >>> img = createImage(8, 8, RGB)
        >>> noStroke()
        >>> beginShape()
        >>> texture(img)
        >>> vertex(20, 20, 0, 0)
        >>> vertex(80, 20, 8, 0)
        >>> vertex(80, 80, 8, 8)
        >>> vertex(20, 80, 0, 8)
        >>> endShape()
        """
        shape = self._open("texture")
        shape.texture = pixels_of("texture", image)
        if shape.first_uv is None:
            begin_uvs(self._recorder, shape)

    def noTexture(self) -> None:
        """Leave the vertices that follow without a texture; Processing's own name for it.

        Examples
        --------
        >>> noTexture()
        """
        if self._shape is not None:
            self._shape.texture = self._shape.first_uv = None

    def textureMode(self, mode: int) -> None:
        """Set the units of u and v: IMAGE for pixels of the image (at first), NORMAL for 0 to 1.

        Examples
        --------
        >>> textureMode(NORMAL)
        """
        check_choice("textureMode", mode, TEXTURE_MODES)
        self._texture_mode = mode


def begin_uvs(recorder: Recorder, shape: OpenShape) -> None:
    """Give a shape texture coordinates from now on; its corners so far get (0, 0)."""
    shape.first_uv = recorder.uv_end
    for _ in range((recorder.corner_end - shape.first) // CORNER):
        recorder.make_room()
        pack_uv(recorder.uvs, recorder.uv_end, 0.0, 0.0)
        recorder.uv_end += UV
