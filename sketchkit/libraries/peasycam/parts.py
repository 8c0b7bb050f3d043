"""What a PeasyCam is made of: the only attributes that the groups of its methods may use."""

from __future__ import annotations

from collections.abc import Callable

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.graphics import PGraphics
from sketchkit.api.sketch import Sketch
from sketchkit.core.errors import wrong_numbers
from sketchkit.libraries.peasycam.hand import Hand
from sketchkit.libraries.peasycam.motions import Travel, eased
from sketchkit.libraries.peasycam.rig import Rig
from sketchkit.libraries.peasycam.rotation import Rotation, Vector, between

DEFAULT_MS = 300.0  # what a journey takes if nothing else is said


class CamParts:
    """Attributes of a PeasyCam, and how it moves."""

    _sketch: Sketch
    _canvas: PGraphics
    _rig: Rig
    _hand: Hand
    _travels: dict[str, Travel]
    _resets_on_double_click: bool
    _is_active: bool

    def feed(self) -> None:
        """Set the canvas's camera, as this one stands. It is done by itself when it has moved.

        Several cameras take turns with it: each draws its part of the window after its `feed()`.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> cam = PeasyCam(this, 200)
        >>> camera()
        >>> cam.feed()
        """
        self._rig.state.apply(self._canvas)

    def _step(self) -> None:
        """Move for one frame: when `draw()` has ended, for the next one."""
        has_moved = self._hand.step()
        now_ms = self._sketch.millis()
        for name, travel in list(self._travels.items()):
            has_moved = True
            if not travel.step(now_ms) and self._travels.get(name) is travel:
                del self._travels[name]
        if has_moved:
            self.feed()

    def _travel(self, name: str, change: Callable[[float], None], duration_ms: float) -> None:
        self._travels.pop(name, None)
        self._travels[name] = Travel(change, self._sketch.millis(), duration_ms)

    def _travel_to_distance(self, distance: float, duration_ms: float) -> None:
        rig = self._rig
        start, end = rig.distance, rig.within_limits(distance)

        def change(part: float) -> None:
            rig.distance = eased(start, end, part)

        self._travel("distance", change, duration_ms)

    def _travel_to_center(self, center: Vector, duration_ms: float) -> None:
        rig = self._rig
        start = rig.center

        def change(part: float) -> None:
            x, y, z = (eased(a, b, part) for a, b in zip(start, center, strict=True))
            rig.center = x, y, z

        self._travel("center", change, duration_ms)

    def _travel_to_rotation(self, rotation: Rotation, duration_ms: float) -> None:
        rig = self._rig
        start = rig.rotation
        for glide in self._hand.turning:
            glide.stop()

        def change(part: float) -> None:
            rig.rotation = rotation if part == 1 else between(start, rotation, part)

        self._travel("rotation", change, duration_ms)


class Listener:
    """What the sketch calls of a camera: these names are its, not the student's."""

    def __init__(
        self,
        step: Callable[[], None],
        take_mouse: Callable[[MouseEvent], None],
        take_key: Callable[[KeyEvent], None],
    ) -> None:
        self.draw, self.mouseEvent, self.keyEvent = step, take_mouse, take_key


def numbers(caller: str, args: tuple[object, ...], usage: str) -> list[float]:
    """Return arguments as numbers, or raise the error that says what is wrong with them."""
    try:
        return [float(value) for value in args]  # type: ignore[arg-type] # tried out here
    except (TypeError, ValueError):
        raise wrong_numbers(caller, args, usage) from None
