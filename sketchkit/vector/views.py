"""View: how the shapes of one recorded state come to the page."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.core.matrix import Mat4
from sketchkit.core.style import NO_COLOR, Style
from sketchkit.draw.resources import Target
from sketchkit.draw.rows import Rows, project
from sketchkit.draw.stage import Stage
from sketchkit.vector.page import (
    IDENTITY,
    Ink,
    Mark,
    Matrix,
    Outline,
    Page,
    Path,
    Setting,
    path_of,
)

F64 = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class View:
    """A state, with what is drawn under it.

    Attributes
    ----------
    modelview : (3, 4) float64
    scale : float
        By what the weights of strokes are multiplied that lie on the screen, in P3D.
    page_of : callable
        Returns the page of another canvas.
    """

    stage: Stage
    style: Style
    modelview: F64
    scale: float
    page_of: Callable[[Target], Page]

    @property
    def setting(self) -> Setting:
        """Where it is drawn, and how it is mixed in."""
        return Setting(self.stage.clip, self.stage.blend)

    @property
    def matrix(self) -> Matrix:
        """From the plane z = 0 to the page, for what is not in 3D."""
        (a, c, _, e), (b, d, _, f), _ = self.modelview.tolist()
        return a, b, c, d, e, f

    def flat(self) -> View:
        """Return the page itself, for what has been brought there already."""
        stage = replace(self.stage, is_3d=False)
        return View(stage, self.style, np.eye(3, 4), 1.0, self.page_of)

    def ink(self, fill: int, stroke: int, weight: float) -> Ink:
        """Return how a shape in these colours is painted; weight 0 is no stroke."""
        if self.stage.is_3d:  # strokes of P3D have no caps, and their joins are bevels
            cap, join = c.SQUARE, c.BEVEL
        else:
            cap, join = self.style.stroke_cap, self.style.stroke_join
        stroke = stroke if stroke >= 0 and weight > 0 else NO_COLOR
        return Ink(max(fill, NO_COLOR), stroke, weight, cap, join)

    def on_page(self, points: F64) -> F64 | None:
        """Return points, (n, 2 or 3), as the page shows them, (n, 2).

        None if one of them is not before the eye.
        """
        if points.shape[1] == 2:
            points = np.hstack([points, np.zeros((len(points), 1))])
        eye = points @ self.modelview[:, :3].T + self.modelview[:, 3]
        if self.stage.is_3d:
            eye = on_screen(self.stage.projection, self.stage.target, eye)
        return None if np.isnan(eye).any() else eye[:, :2]

    def mark(self, outline: Outline, ink: Ink) -> Mark | None:
        """Return an outline in the plane z = 0, painted; None where there is nothing to see."""
        if ink.fill < 0 and ink.stroke < 0:
            return None
        if not self.stage.is_3d:
            return Mark(outline, ink, self.setting, self.matrix)
        return self.solid_mark(path_of(outline), ink)

    def solid_mark(self, path: Path, ink: Ink) -> Mark | None:
        """Return a path whose points may lie in space, (n, 2 or 3), painted."""
        if not self.stage.is_3d:
            return self.mark(Path(path.letters, path.points[:, :2]), ink)
        points = self.on_page(path.points)
        if points is None or (ink.fill < 0 and ink.stroke < 0):
            return None
        ink = ink._replace(weight=ink.weight * self.scale)
        return Mark(Path(path.letters, points), ink, self.setting, IDENTITY)


def views_of(rows: Rows, page_of: Callable[[Target], Page]) -> list[View]:
    """Return the view of each state."""
    modelviews = rows.matrices.reshape(-1, 3, 4).astype(np.float64)
    states = zip(rows.stages, rows.styles, modelviews, rows.scales.tolist(), strict=True)
    return [View(*state, page_of) for state in states]


def on_screen(projection: Mat4, target: Target, eye: F64) -> F64:
    """Return points in eye space, (n, 3), as x, y and nearness on the screen, (n, 3).

    NaN are those that are not before the eye.
    """
    x, y, z, w = project(projection, *eye.T)
    w = np.where(w > 0, w, np.nan)
    return np.stack(
        [(x / w + 1) * target.across / 2, (1 - y / w) * target.down / 2, -z / w], axis=1
    )
