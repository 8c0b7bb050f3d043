"""What keeps something off the picture, in whole sentences with the numbers that tell."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.reach import Obstacle, Reach
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.recorder import Kind
from sketchkit.draw.resources import Target
from sketchkit.runtime.explore.cases import Case, Piece
from sketchkit.runtime.explore.matrices import number


def obstacle_in_words(case: Case, piece: Piece, reached: Reach, surface: Target) -> str:
    """Return what keeps a part off the picture, with the numbers that tell."""
    match reached.obstacle:
        case Obstacle.NO_NUMBER:
            return "One of its numbers is none (NaN) or infinite."
        case Obstacle.BEHIND:
            return "It lies behind the camera: give it a smaller z, or move the camera back."
        case Obstacle.TOO_NEAR:
            near, _ = depth_range(piece.pipeline)
            return f"It is too near: the picture begins {near} in front of the camera."
        case Obstacle.TOO_FAR:
            _, far = depth_range(piece.pipeline)
            return f"It is too far away: the picture ends {far} in front of the camera."
        case Obstacle.LEFT | Obstacle.RIGHT | Obstacle.ABOVE | Obstacle.BELOW:
            return _beside(reached, surface, is_window=piece.pipeline.target is case.around.canvas)
        case Obstacle.FLAT:
            return _without_size(case, piece)
        case Obstacle.CLIPPED:
            clip = piece.pipeline.clip
            assert clip is not None
            return (
                "It lies outside of clip(), which lets through "
                f"{clip.width} x {clip.height} pixels at {clip.left}, {clip.top}."
            )
        case Obstacle.SMALL:
            return "It is smaller than a pixel."
    return "It lies outside of what the camera sees."


def _beside(reached: Reach, surface: Target, *, is_window: bool) -> str:
    """Return on which side of the window something lies."""
    sides = {
        Obstacle.LEFT: ("to the left of", "x", 0),
        Obstacle.RIGHT: ("to the right of", "x", 0),
        Obstacle.ABOVE: ("above", "y", 1),
        Obstacle.BELOW: ("below", "y", 1),
    }
    assert reached.obstacle is not None
    where, axis, index = sides[reached.obstacle]
    picture = "the window" if is_window else "its canvas"
    text = f"It lies {where} {picture}"
    if reached.bounds is None:
        return f"{text}."
    first, last = reached.bounds[index], reached.bounds[index + 2]
    size = (surface.width, surface.height)[index]
    shown = f"{first:.0f} to {last:.0f}" if last - first >= 1 else f"{first:.0f}"
    return f"{text}: there its {axis} is {shown}, and {picture} goes from 0 to {size}."


def depth_range(pipeline: Pipeline) -> tuple[str, str]:
    """Return how far from the camera the picture begins and ends, as numbers to be shown."""
    p = pipeline.projection
    if p[12:] == (0.0, 0.0, 0.0, 1.0):
        return number((p[11] + 1) / p[10]), number((p[11] - 1) / p[10])
    near, far = p[11] / (p[10] - 1), p[11] / (p[10] + 1)
    return number(near), number(far)


def _without_size(case: Case, piece: Piece) -> str:
    """Return why something has no area on the picture."""
    linear = case.modelview[:, :3] if case.kind is not Kind.MESH else _linear(piece)
    sizes = np.linalg.norm(linear, axis=0)
    if (sizes[:2] < 1e-9).any():
        return "The matrix squeezes it to nothing: scale(0) is in force."
    block = piece.block
    first, size = piece.drawn.first, piece.drawn.size
    corners = block.positions[block.indices[first : first + size]].reshape(-1, 3, 3).astype(float)
    if block.directions is None and block.offsets is None:
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        if np.sqrt((across**2).sum(axis=1)).max(initial=0.0) > 1e-9 and math.isfinite(across.sum()):
            return "It is seen exactly from its edge, and flat things have no thickness."
    return "It has no size: its width, its height or its radius is 0."


def _linear(piece: Piece) -> NDArray[np.float64]:
    return np.array(piece.drawn.modelview).reshape(3, 4)[:, :3]
