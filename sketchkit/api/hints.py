"""Hints: features of the renderer and of the keyboard that a sketch switches on and off."""

from __future__ import annotations

from sketchkit.api._parts import CanvasParts
from sketchkit.core import constants as c
from sketchkit.core.errors import wrong_numbers
from sketchkit.draw.recorder import Kind

HINT_USAGE = (
    "DISABLE_DEPTH_TEST | DISABLE_DEPTH_MASK | ENABLE_DEPTH_SORT | ENABLE_STROKE_PERSPECTIVE"
)

# What a hint changes of the stage. Those that are not here concern Java's own drivers and windows:
# they are accepted and change nothing.
STAGE_HINTS: dict[int, dict[str, bool]] = {
    c.DISABLE_DEPTH_TEST: {"depth_test": False},
    c.ENABLE_DEPTH_TEST: {"depth_test": True},
    c.DISABLE_DEPTH_MASK: {"depth_write": False},
    c.ENABLE_DEPTH_MASK: {"depth_write": True},
    c.ENABLE_DEPTH_SORT: {"depth_sort": True},
    c.DISABLE_DEPTH_SORT: {"depth_sort": False},
    c.DISABLE_OPTIMIZED_STROKE: {"one_by_one": True},
    c.ENABLE_OPTIMIZED_STROKE: {"one_by_one": False},
    c.ENABLE_STROKE_PERSPECTIVE: {"stroke_perspective": True},
    c.DISABLE_STROKE_PERSPECTIVE: {"stroke_perspective": False},
}
KEY_HINTS = {c.ENABLE_KEY_REPEAT: True, c.DISABLE_KEY_REPEAT: False}
HINTS = [value for name, value in vars(c).items() if name.startswith(("DISABLE_", "ENABLE_"))]


class Hints(CanvasParts):
    """Hints stay from frame to frame, until they are taken back."""

    def hint(self, which: int) -> None:
        """Switch a feature on or off, by a constant such as DISABLE_DEPTH_TEST.

        Parameters
        ----------
        which : constant
            DISABLE_DEPTH_TEST draws what follows over everything; DISABLE_DEPTH_MASK draws it
            without hiding what comes later; ENABLE_DEPTH_SORT draws it from far to near, for
            transparency; ENABLE_STROKE_PERSPECTIVE makes far strokes thin;
            DISABLE_OPTIMIZED_STROKE draws each shape's outline before the next shape, so that it
            shows through translucent ones; ENABLE_KEY_REPEAT has a held key call keyPressed()
            again and again, as it does without P2D or P3D anyway. DISABLE and ENABLE of a name undo
            each other; both stay in force from frame to frame.

        Raises
        ------
        SketchError
            If it is no hint.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> hint(DISABLE_DEPTH_TEST)
        >>> rect(20, 20, 60, 60)
        >>> hint(ENABLE_DEPTH_TEST)
        """
        if which not in HINTS:
            raise wrong_numbers("hint", (which,), HINT_USAGE)
        if which in KEY_HINTS:
            self._repeats_keys = KEY_HINTS[which]
        changes = STAGE_HINTS.get(which, {})
        if all(getattr(self._stage, name) == value for name, value in changes.items()):
            return
        old = self._stage
        self._restage(**changes)
        if "stroke_perspective" in changes:
            # Processing draws the strokes that are waiting with the new value, not with the old.
            # Retained shapes never wait, nor does what came before them.
            waiting = self._recorder.first_state_after(Kind.MESH)
            self._recorder.replace_stage(old, self._stage, waiting)
            self._restage()
