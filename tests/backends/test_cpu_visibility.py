"""What hides what; colours are those of whole rects, so that one pixel tells."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.draw.commands import Clear, Draw
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import Layer, VertexBlock
from tests.backends.draw_lists import BLACK, draw_list, flat_pipeline, triangles

RED, GREEN = (255, 0, 0, 255), (0, 255, 0, 255)
NEAR, FAR = 50.0, -50.0


def two_triangles(first_z: float, second_z: float) -> VertexBlock:
    """Return a red triangle and then a green one, both over the middle of a small target."""
    corners = [[(0, 0, z), (20, 0, z), (0, 20, z)] for z in (first_z, second_z)]
    return triangles(corners, [RED, GREEN])


@pytest.mark.parametrize("samples", [1, 4])
@pytest.mark.parametrize(
    ("first_z", "second_z", "depth_test", "expected"),
    [
        (NEAR, FAR, True, RED),
        (FAR, NEAR, True, GREEN),
        (NEAR, NEAR, True, GREEN),
        (NEAR, FAR, False, GREEN),
    ],
    ids=["behind", "before", "coplanar", "painted"],
)
def test_in_one_draw(
    first_z: float,
    second_z: float,
    depth_test: bool,
    expected: tuple[int, ...],
    samples: int,
) -> None:
    target, backend = Target(8, 8, samples), CpuBackend()
    pipeline = flat_pipeline(target, depth_test=depth_test, depth_write=depth_test)

    backend.execute(draw_list(two_triangles(first_z, second_z), Clear(target, BLACK), pipeline))

    assert tuple(backend.read(target)[4, 4]) == expected


@pytest.mark.parametrize(
    ("writes_first", "tests_first", "clears_depth", "expected"),
    [
        (True, True, None, RED),
        (False, True, None, GREEN),
        (True, False, None, GREEN),  # OpenGL does not write what it does not test
        (True, True, False, RED),
        (True, True, True, GREEN),
    ],
    ids=["both", "no-write", "no-test", "cleared-but-depth", "cleared"],
)
def test_from_draw_to_draw(
    writes_first: bool,
    tests_first: bool,
    clears_depth: bool | None,
    expected: tuple[int, ...],
) -> None:
    target, backend = Target(8, 8), CpuBackend()
    before = flat_pipeline(target, depth_test=tests_first, depth_write=writes_first)
    after = flat_pipeline(target, depth_test=True, depth_write=True)
    first, second = Draw(before, Layer.FILLS, 0, 3), Draw(after, Layer.FILLS, 3, 3)
    between = [] if clears_depth is None else [Clear(target, RED, clears_depth)]

    backend.execute(
        draw_list(two_triangles(NEAR, FAR), Clear(target, BLACK), first, *between, second)
    )

    assert tuple(backend.read(target)[4, 4]) == expected


def test_planes_that_cut_each_other_are_seen_in_part() -> None:
    target, backend = Target(20, 20, 1), CpuBackend()
    slope = [
        [(0, 0, FAR), (20, 0, NEAR), (20, 20, NEAR)],
        [(0, 0, FAR), (20, 20, NEAR), (0, 20, FAR)],
    ]
    level = [[(0, 0, 0), (20, 0, 0), (20, 20, 0)], [(0, 0, 0), (20, 20, 0), (0, 20, 0)]]
    block = triangles(slope + level, [RED] * 2 + [GREEN] * 2)

    backend.execute(
        draw_list(
            block, Clear(target, BLACK), flat_pipeline(target, depth_test=True, depth_write=True)
        )
    )

    picture = backend.read(target)
    assert np.all(picture[:, :10] == GREEN)
    assert np.all(picture[:, 10:] == RED)
