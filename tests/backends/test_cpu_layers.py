"""Translucent drawing: the order of every pixel's fragments is the order of the triangles."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.blending import blend
from sketchkit.backends.cpu.executor import MOST_PARTS, CpuBackend
from sketchkit.draw.commands import Clear
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8
from tests.backends.draw_lists import draw_list, flat_pipeline, on, random_block, triangles

CORNERS = [(0, 0), (20, 0), (0, 20)]


def stacked(colors: list[tuple[int, ...]], samples: int = 4) -> U8:
    """Return the pixel in the middle of triangles drawn over each other, on black."""
    target, backend = Target(8, 8, samples), CpuBackend()
    block = triangles([CORNERS] * len(colors), colors)
    backend.execute(on(target, block, flat_pipeline(target)))
    return backend.read(target)[4, 4]


def one_by_one(colors: list[tuple[int, ...]]) -> U8:
    there = np.array([0, 0, 0, 255], np.uint8)
    for color in colors:
        there = blend(Blend.BLEND, np.array(color, np.uint8), there)
    return there


@pytest.mark.parametrize("samples", [1, 4])
@pytest.mark.parametrize("count", [1, 2, 5, 40])
def test_layers_are_blended_in_order(count: int, samples: int) -> None:
    colors = [tuple(c) for c in np.random.default_rng(count).integers(0, 256, (count, 4)).tolist()]

    assert stacked(colors, samples).tolist() == one_by_one(colors).tolist()


def test_opaque_and_translucent_triangles_in_turn() -> None:
    turns = [(200, 10, 20, 255), (0, 200, 50, 60)] * MOST_PARTS

    assert stacked(turns).tolist() == one_by_one(turns).tolist()
    assert stacked(turns[:6]).tolist() == one_by_one(turns[:6]).tolist()


def test_alpha_is_added_on_a_transparent_target() -> None:
    target, backend = Target(8, 8, 4, top_row_first=False), CpuBackend()
    block = triangles([CORNERS], [(255, 0, 0, 128)])

    backend.execute(draw_list(block, Clear(target, (0, 0, 0, 0)), flat_pipeline(target)))

    assert backend.read(target)[4, 4].tolist() == [128, 0, 0, 128]  # as Processing stores it


def test_opaque_blending_is_replacing() -> None:
    target = Target(60, 50)
    block = random_block(np.random.default_rng(2), (60, 50), 40)
    block.colors[:, 3] = 255
    pictures = []

    for mode in (Blend.BLEND, Blend.REPLACE):
        backend = CpuBackend()
        backend.execute(on(target, block, flat_pipeline(target, blend=mode)))
        pictures.append(backend.read(target))

    assert np.array_equal(*pictures)
