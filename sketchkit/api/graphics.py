"""PGraphics: a surface to draw on, the groups of methods joined."""

from __future__ import annotations

from sketchkit.api.camera import Camera
from sketchkit.api.color import Color
from sketchkit.api.curves import Curves
from sketchkit.api.images import Images
from sketchkit.api.lights import Lights
from sketchkit.api.shapes2d import Shapes2D
from sketchkit.api.shapes3d import Shapes3D
from sketchkit.api.stacks import Stacks
from sketchkit.api.text import Text
from sketchkit.core.constants import P3D
from sketchkit.draw.resources import Target
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import U8


class PGraphics(Color, Lights, Stacks, Shapes2D, Curves, Shapes3D, Camera, Text, Images):
    """A surface to draw on; the window's is one of them."""

    @property
    def width(self) -> int:
        """Columns of pixels."""
        return self._target.width

    @property
    def height(self) -> int:
        """Rows of pixels."""
        return self._target.height

    @property
    def target(self) -> Target:
        """What it draws on."""
        return self._target

    def resize(self, width: int, height: int, renderer_name: str, samples: int) -> None:
        """Give the surface a size and a renderer; what was drawn is lost."""
        self._renderer.flush()
        self._target.resize(width, height, samples)
        self._renderer_name = renderer_name
        is_3d = renderer_name == P3D
        self._stage = Stage(self._target, is_3d=is_3d, is_perspective=is_3d, depth_test=is_3d)
        self._restage(projection=self._flat_projection())
        if is_3d:
            self.perspective()
        self.begin_frame()

    def begin_frame(self) -> None:
        """Put back what does not last from frame to frame: matrix, camera, lights, normal."""
        self._matrices.clear()
        self._normal = (0.0, 0.0, 1.0)
        self._light_falloff, self._light_specular = (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        self._place_camera(self._default_camera())
        if self._stage.lights is not None:
            self._restage(lights=None)

    def end_frame(self) -> None:
        """Draw everything recorded so far."""
        self._renderer.flush()

    def image_data(self) -> U8:
        """Return the picture, (h, w, 4) RGBA, top row first."""
        return self._renderer.read(self._target)
