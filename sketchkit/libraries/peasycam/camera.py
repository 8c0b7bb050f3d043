"""PeasyCam: the groups of its methods joined, and how it takes part in the sketch."""

from __future__ import annotations

from dataclasses import replace

from sketchkit.api.events import MouseEvent
from sketchkit.api.graphics import PGraphics
from sketchkit.api.sketch import Sketch
from sketchkit.api.view import View
from sketchkit.core import running
from sketchkit.core.constants import DISABLE_DEPTH_TEST, ENABLE_DEPTH_TEST, MAX_FLOAT
from sketchkit.core.errors import SketchError, wrong_numbers
from sketchkit.libraries.peasycam.control import Control
from sketchkit.libraries.peasycam.hand import Hand
from sketchkit.libraries.peasycam.parts import Listener, numbers
from sketchkit.libraries.peasycam.placing import Placing
from sketchkit.libraries.peasycam.rig import Rig

USAGE = "distance | x, y, z, distance"


class PeasyCam(Placing, Control):
    """A camera for P3D that the mouse moves around what it looks at.

    A drag with the left button turns it, with the right one or the wheel it comes nearer, with the
    middle one it moves along. It glides on a little. With Shift a drag keeps its direction. A
    double click brings the camera back.

    Parameters
    ----------
    *args : [this,] [canvas,] [x, y, z,] distance
        The point to look at, the origin if it is left out, and how far to be from it. `this` may be
        left out; a canvas of `createGraphics()` has its camera set instead of the window's.

    Raises
    ------
    SketchError
        If there are not 1 or 4 numbers, or no sketch is running.

    Notes
    -----
    The origin is at the window's top left corner only as long as the default camera is in force:
    here it is in the middle. Source: Jonathan Feinberg's library PeasyCam for Processing.

    Examples
    --------
    >>> size(100, 100, P3D)
    >>> cam = PeasyCam(this, 200)
    >>> cam.setMinimumDistance(50)
    >>> cam.rotateX(-0.5)
    >>> box(60)
    """

    VERSION = "302"  # of the library whose behaviour this is

    def __init__(self, *args: object) -> None:
        sketch, canvas, rest = _owners(args)
        self._sketch, self._canvas = sketch, canvas
        values = numbers("PeasyCam", rest, USAGE)
        if len(values) not in (1, 4):
            raise wrong_numbers("PeasyCam", rest, USAGE)
        x, y, z = values[:-1] or (0.0, 0.0, 0.0)
        self._rig = Rig((x, y, z), values[-1])
        self._hand = Hand(self._sketch, self._rig, [0, 0, canvas.width, canvas.height])
        self._travels = {}
        self._resets_on_double_click, self._is_active = True, False
        self._view: View | None = None
        self._listener = Listener(self._step, self._take_mouse, self._hand.take_key)
        self.feed()
        self._sketch.registerMethod("draw", self._listener)
        self.setActive(True)

    def setActive(self, active: bool) -> None:
        """Listen to the mouse, or not.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.setActive(False)
        """
        if bool(active) == self._is_active:
            return
        self._is_active = bool(active)
        sketch = self._sketch
        change = sketch.registerMethod if active else sketch.unregisterMethod
        for name in ("mouseEvent", "keyEvent"):
            change(name, self._listener)

    def isActive(self) -> bool:
        """Return whether the camera listens to the mouse.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).isActive())
        True
        """
        return self._is_active

    def setMouseControlled(self, isMouseControlled: bool) -> None:
        """Listen to the mouse, or not: the older name of `setActive()`.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> PeasyCam(this, 200).setMouseControlled(False)
        """
        self.setActive(isMouseControlled)

    def getCanvas(self) -> PGraphics:
        """Return the canvas whose camera is set.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> println(PeasyCam(this, 200).getCanvas() is g)
        True
        """
        return self._canvas

    def version(self) -> str:
        """Return the version of PeasyCam that this one behaves as.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> println(cam.version(), PeasyCam.VERSION)
        302 302
        """
        return self.VERSION

    def beginHUD(self) -> None:
        """Draw flat from now on, before everything and without lights: x and y are pixels.

        See Also
        --------
        endHUD

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> box(60)
        >>> cam.beginHUD()
        >>> square(5, 5, 20)
        >>> cam.endHUD()
        """
        canvas = self._canvas
        canvas.hint(DISABLE_DEPTH_TEST)
        canvas.pushMatrix()
        canvas.resetMatrix()
        if canvas.is_3d:
            self._view = canvas.current_view()
            canvas.set_view(replace(self._view, lights=None))
            width, height = self._hand.viewport[2:]
            canvas.ortho(0, width, -height, 0, -MAX_FLOAT, MAX_FLOAT)

    def endHUD(self) -> None:
        """Draw in space again.

        Raises
        ------
        SketchError
            If there was no `beginHUD()`.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> cam.beginHUD()
        >>> text("in front", 5, 20)
        >>> cam.endHUD()
        """
        canvas = self._canvas
        if canvas.is_3d:
            if self._view is None:
                raise SketchError("endHUD() without beginHUD().")
            canvas.set_view(self._view)
            self._view = None
        canvas.popMatrix()
        canvas.hint(ENABLE_DEPTH_TEST)

    def _take_mouse(self, event: MouseEvent) -> None:
        if self._hand.take_mouse(event) and self._resets_on_double_click:
            self.reset()


def _owners(args: tuple[object, ...]) -> tuple[Sketch, PGraphics, tuple[object, ...]]:
    """Return the sketch and the canvas that a camera is for, and the arguments after them."""
    match args:
        case [Sketch() as sketch, *rest]:
            pass
        case rest:
            sketch = _running_sketch()
    match rest:
        case [PGraphics() as canvas, *numbers]:
            return sketch, canvas, tuple(numbers)
    assert isinstance(sketch.canvas, PGraphics)
    return sketch, sketch.canvas, tuple(rest)


def _running_sketch() -> Sketch:
    sketch = running.current()
    this = sketch.names.get("this") if sketch else None
    if not isinstance(this, Sketch):
        raise SketchError("PeasyCam() belongs into a sketch that is running.")
    return this
