"""Solids."""

from __future__ import annotations

from sketchkit.api._pen import Pen
from sketchkit.core.notices import warn_once
from sketchkit.draw.recorder import ROW, Kind, PackError, pack_row1, pack_row3

BOX, SPHERE = Kind.BOX.value, Kind.SPHERE.value
BOX_USAGE = "size | width, height, depth"
SPHERE_USAGE = "radius"
SPHEREDETAIL_USAGE = "around [, along]"
FEWEST_AROUND, FEWEST_ALONG = 3, 2


class Shapes3D(Pen):
    """Solids around the origin of the current matrix, in P3D."""

    def box(self, w: float, h: float | None = None, d: float | None = None) -> None:
        """Draw a box.

        Parameters
        ----------
        w, h, d : float, pixels
            Its sizes along x, y and z; one alone stands for all.

        See Also
        --------
        sphere, lights, translate

        Notes
        -----
        Source: Processing's reference, box().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50)
        >>> rotateY(0.6)
        >>> box(40)
        """
        if h is None or d is None:
            h = d = w
        if not self._stage.is_3d:
            return self._need_3d("box")
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        try:
            pack_row3(
                recorder.rows, end, BOX, state, self._fill, self._stroke, self._weight, 0, w, h, d
            )
        except PackError:
            return self._again(self.box, (w,) if w is h is d else (w, h, d), BOX_USAGE)
        recorder.row_end = end + ROW
        return None

    def sphere(self, r: float) -> None:
        """Draw a sphere.

        Parameters
        ----------
        r : float, pixels
            Its radius.

        See Also
        --------
        sphereDetail, box, lights

        Notes
        -----
        Source: Processing's reference, sphere().

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> noStroke()
        >>> lights()
        >>> translate(50, 50)
        >>> sphere(40)
        """
        if not self._stage.is_3d:
            return self._need_3d("sphere")
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        try:
            pack_row1(
                recorder.rows, end, SPHERE, state, self._fill, self._stroke, self._weight, 0, r
            )
        except PackError:
            return self._again(self.sphere, (r,), SPHERE_USAGE)
        recorder.row_end = end + ROW
        return None

    def sphereDetail(self, ures: int, vres: int | None = None) -> None:
        """Set how finely spheres are made.

        Parameters
        ----------
        ures : int
            Steps around; also from pole to pole, if it is alone. At first 30.
        vres : int, optional
            Steps from pole to pole.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50)
        >>> sphereDetail(8)
        >>> sphere(40)
        """
        try:
            around, along = int(ures), int(ures if vres is None else vres)
        except (TypeError, ValueError):
            args = (ures,) if vres is None else (ures, vres)
            self._refuse("sphereDetail", args, SPHEREDETAIL_USAGE)
        self._restyle("sphere_detail", (max(around, FEWEST_AROUND), max(along, FEWEST_ALONG)))

    def _need_3d(self, name: str) -> None:
        """Say once that a solid is not drawn in a flat sketch."""
        warn_once(f"{name}() is drawn only in P3D: write size(width, height, P3D).")
