"""The view: another camera over the sketch's own, and its drawing redrawn under it.

What was drawn is in eye space already. So a change of camera is one matrix more between eye space
and the picture: only the projections of the draw list change.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Mat4, multiply4
from sketchkit.draw.commands import Clear, Command, Draw, DrawList, DrawMesh
from sketchkit.draw.resources import Target

F64 = NDArray[np.float64]
STEEPEST = 0.49 * math.pi
NEAREST, FARTHEST = 0.02, 50.0  # zooms
TURN = 0.01  # radians for each pixel that the mouse is dragged
NOTCH = 1.1  # zoom for each notch of the wheel


@dataclass(frozen=True)
class View:
    """A camera relative to the sketch's own.

    Attributes
    ----------
    is_3d : bool
        Whether it turns; in 2D it moves and zooms alone.
    pivot : (x, y, z), eye space
        What it turns around; in 2D the middle of the picture, in pixels.
    yaw, pitch : float, radians
    zoom : float
    pan : (x, y)
        In eye space at the pivot; in 2D in pixels.
    """

    is_3d: bool
    pivot: tuple[float, float, float]
    yaw: float = 0.0
    pitch: float = 0.0
    zoom: float = 1.0
    pan: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def of(cls, size: tuple[int, int], distance: float, *, is_3d: bool) -> View:
        """Return the sketch's own camera; `distance` is that of the middle of the picture."""
        width, height = size
        return cls(is_3d, (0.0, 0.0, -distance) if is_3d else (width / 2, height / 2, 0.0))

    @property
    def is_home(self) -> bool:
        """Whether it is the sketch's own camera."""
        return (self.yaw, self.pitch, self.zoom, self.pan) == (0.0, 0.0, 1.0, (0.0, 0.0))

    def home(self) -> View:
        """Return the sketch's own camera."""
        return replace(self, yaw=0.0, pitch=0.0, zoom=1.0, pan=(0.0, 0.0))

    def turned(self, dx: float, dy: float) -> View:
        """Return the view after a drag, in pixels; in 2D it moves."""
        if not self.is_3d:
            return self.moved(dx, dy)
        pitch = min(max(self.pitch + dy * TURN, -STEEPEST), STEEPEST)
        return replace(self, yaw=self.yaw + dx * TURN, pitch=pitch)

    def moved(self, dx: float, dy: float) -> View:
        """Return the view after a drag, in pixels: what is at the pivot follows the mouse."""
        return replace(self, pan=(self.pan[0] + dx, self.pan[1] + dy))

    def zoomed(self, notches: float, place: tuple[float, float] | None = None) -> View:
        """Return the view after turning the wheel; in 2D, `place` stays where it is."""
        zoom = min(max(self.zoom * NOTCH**-notches, NEAREST), FARTHEST)
        if self.is_3d or place is None:
            return replace(self, zoom=zoom)
        factor = zoom / self.zoom
        pan = tuple(
            at - centre - (at - centre - own) * factor
            for at, centre, own in zip(place, self.pivot, self.pan, strict=False)
        )
        return replace(self, zoom=zoom, pan=(pan[0], pan[1]))

    @property
    def matrix(self) -> Mat4:
        """What takes the sketch's eye space to this one."""
        x, y, z = self.pivot
        a, b = math.cos(self.yaw), math.sin(self.yaw)
        p, q = math.cos(self.pitch), math.sin(self.pitch)
        about_y = (a, 0, b, 0, 0, 1, 0, 0, -b, 0, a, 0, 0, 0, 0, 1)
        about_x = (1, 0, 0, 0, 0, p, q, 0, 0, -q, p, 0, 0, 0, 0, 1)
        k = self.zoom
        there = _shift(x + self.pan[0], y + self.pan[1], z)
        scaled = multiply4(there, (k, 0, 0, 0, 0, k, 0, 0, 0, 0, k, 0, 0, 0, 0, 1))
        return multiply4(multiply4(multiply4(scaled, about_x), about_y), _shift(-x, -y, -z))


def _shift(x: float, y: float, z: float) -> Mat4:
    return (1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, z, 0.0, 0.0, 0.0, 1.0)


def redrawn(
    lists: Iterable[DrawList], target: Target, stand_in: Target, view: View
) -> list[DrawList]:
    """Return what was drawn on a target as lists for another one, seen otherwise.

    What goes to other canvases is left out: these are drawn already.
    """
    return [
        replace(
            own,
            commands=[
                moved
                for command in own.commands
                if (moved := _redrawn(command, target, stand_in, view)) is not None
            ],
        )
        for own in lists
    ]


def _redrawn(command: Command, target: Target, stand_in: Target, view: View) -> Command | None:
    match command:
        case Clear():
            return replace(command, target=stand_in) if command.target is target else None
        case Draw(pipeline=pipeline) | DrawMesh(pipeline=pipeline):
            if pipeline.target is not target:
                return None
            projection = pipeline.projection
            if not view.is_home and (pipeline.depth_test or not view.is_3d or _is_deep(projection)):
                projection = multiply4(projection, view.matrix)
            changed = pipeline._replace(target=stand_in, projection=projection, culls_backs=False)
            return replace(command, pipeline=changed)
        case _:
            return replace(command, target=stand_in) if command.target is target else None


def _is_deep(projection: Mat4) -> bool:
    """Return whether something is drawn in perspective: no flat image over all."""
    return projection[12:] != (0.0, 0.0, 0.0, 1.0)


def seen(projection: Mat4, points: F64, size: tuple[int, int]) -> F64:
    """Return segments, (n, 2, 3) eye space, on the picture, (m, 2, 2) pixels.

    What lies behind the camera is cut off.
    """
    flat = np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=2)
    clip = flat @ np.array(projection).reshape(4, 4).T
    clip = clip[np.isfinite(clip).all(axis=(1, 2))]
    nearest = 1e-3
    w = clip[..., 3]
    clip = clip[(w > nearest).any(axis=1)]
    w = clip[..., 3]
    for end, other in ((0, 1), (1, 0)):
        is_cut = w[:, end] <= nearest
        t = (nearest - w[is_cut, other]) / (w[is_cut, end] - w[is_cut, other])
        clip[is_cut, end] = clip[is_cut, other] + t[:, None] * (
            clip[is_cut, end] - clip[is_cut, other]
        )
        w = clip[..., 3]
    x = (clip[..., 0] / w + 1) * size[0] / 2
    y = (1 - clip[..., 1] / w) * size[1] / 2
    return np.stack([x, y], axis=2)
