"""Strokes of P3D, seen by a camera of 90 degrees in a target of 100 x 100."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.lines import widen_lines, widen_points
from sketchkit.core.matrix import perspective
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import F32
from tests.backends.draw_lists import flat_pipeline

LENS = perspective(np.pi / 2, 1.0, 1.0, 1000.0)


def pipeline(**changes: object) -> Pipeline:
    return flat_pipeline(Target(100, 100), projection=LENS, **changes)


def on_screen(clip: F32) -> F32:
    """Return places in pixels from the top left."""
    return (clip[:, :2] / clip[:, 3:] * (50, -50) + 50).astype(np.float32)


def line(half_weight: float, z: float, how: Pipeline) -> F32:
    """Return the corners on both sides of the left end of a level line, in pixels."""
    positions = np.array([(-z / 2, 0, -z)] * 2, np.float32)
    directions = np.array([(z, 0, 0, half_weight), (z, 0, 0, -half_weight)], np.float32)
    return on_screen(widen_lines(positions, directions, how))


@pytest.mark.parametrize("z", [10, 100])
def test_the_weight_is_in_pixels_at_any_distance(z: float) -> None:
    assert np.allclose(np.sort(line(3, z, pipeline())[:, 1]), [47, 53], atol=1e-3)


@pytest.mark.parametrize(("z", "half_width"), [(10, 15), (100, 1.5)])
def test_with_stroke_perspective_it_shrinks(z: float, half_width: float) -> None:
    rows = line(3, z, pipeline(stroke_perspective=True))[:, 1]

    assert np.allclose(np.sort(rows), [50 - half_width, 50 + half_width], atol=1e-3)


def test_ends_are_pulled_toward_the_eye_but_stay_where_they_are_seen() -> None:
    scaled = pipeline(line_scale=(0.5, 0.5, 0.5))

    assert np.allclose(line(3, 20, scaled), line(3, 20, pipeline()), atol=1e-3)
    positions = np.array([(0, 0, -20)], np.float32)
    assert widen_lines(positions, np.zeros((1, 4), np.float32), scaled)[0, 3] == 10


def test_the_middle_of_a_join_stays_in_its_place() -> None:
    positions = np.array([(3, 4, -20)], np.float32)

    middle = widen_lines(positions, np.array([(0, 0, 0, 5)], np.float32), pipeline())

    assert np.allclose(on_screen(middle), [(50 + 7.5, 50 + 10)])


def test_a_line_toward_the_eye_has_no_width() -> None:
    positions = np.array([(0, 0, -20)], np.float32)

    end = widen_lines(positions, np.array([(0, 0, 10, 5)], np.float32), pipeline())

    assert np.allclose(on_screen(end), [(50, 50)])


def test_points_are_as_large_at_any_distance() -> None:
    positions = np.array([(0, 0, -10), (0, 0, -100)], np.float32)
    offsets = np.array([(4, 2), (4, 2)], np.float32)

    corners = on_screen(widen_points(positions, offsets, pipeline()))

    assert np.allclose(corners[0], corners[1])
    assert np.allclose(np.abs(corners[0] - 50), (4, 2))
