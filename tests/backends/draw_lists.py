"""Draw lists for tests of renderers: made by hand, or at random from a seed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketchkit.core.lights import Light, LightKind
from sketchkit.core.matrix import Mat4
from sketchkit.draw.commands import Clear, Command, Draw, DrawList
from sketchkit.draw.pipeline import Blend, Pipeline, Program
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.vertex import Layer, Materials, VertexBlock

BLACK = (0, 0, 0, 255)
NOTHING = (0.0, 0.0, 0.0)


def pixel_projection(width: int, height: int) -> Mat4:
    """Return the projection in which x and y are pixels from the top left, and z is -100..100."""
    return (
        *(2 / width, 0.0, 0.0, -1.0),
        *(0.0, -2 / height, 0.0, 1.0),
        *(0.0, 0.0, -0.01, 0.0),
        *(0.0, 0.0, 0.0, 1.0),
    )


def flat_pipeline(target: Target, **changes: object) -> Pipeline:
    """Return a pipeline for plain colours in pixels, without depth."""
    plain = Pipeline(
        Program.FLAT,
        target,
        pixel_projection(target.width, target.height),
        Blend.BLEND,
        depth_test=False,
        depth_write=False,
    )
    return plain._replace(**changes)


def triangles(corners: Sequence[object], colors: Sequence[object]) -> VertexBlock:
    """Return triangles, (n, 3, 2 or 3), each of one colour, (n, 4)."""
    places = np.asarray(corners, np.float32)
    positions = np.zeros((len(places), 3, 3), np.float32)
    positions[..., : places.shape[2]] = places
    return VertexBlock(
        positions=positions.reshape(-1, 3),
        colors=np.asarray(colors, np.uint8).repeat(3, axis=0),
        indices=np.arange(3 * len(places), dtype=np.uint32),
    )


def rect(left: float, top: float, right: float, bottom: float, color: Sequence[int]) -> VertexBlock:
    """Return two triangles of one colour, with a texture spread over them."""
    x, y = (left, right, right, left), (top, top, bottom, bottom)
    return VertexBlock(
        positions=np.array([x, y, (0.0,) * 4], np.float32).T.copy(),
        colors=np.array([color] * 4, np.uint8),
        indices=np.array([0, 1, 2, 0, 2, 3], np.uint32),
        uvs=np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32),
    )


def draw_list(block: VertexBlock, *commands: Command | Pipeline) -> DrawList:
    """Return a list of commands; a pipeline stands for drawing the whole block with it."""
    return DrawList(
        [
            Draw(command, Layer.FILLS, 0, len(block.indices))
            if isinstance(command, Pipeline)
            else command
            for command in commands
        ],
        {Layer.FILLS: block},
    )


def on(target: Target, block: VertexBlock, *pipelines: Pipeline) -> DrawList:
    """Return a list that clears a target to black and draws a block."""
    return draw_list(block, Clear(target, BLACK), *pipelines)


def random_block(rng: np.random.Generator, size: tuple[int, int], count: int) -> VertexBlock:
    """Return triangles all over a target and beyond its edges, with every column of fills.

    Half of them are opaque. Depths are -50..50.
    """
    centres = rng.uniform((-20, -20), (size[0] + 20, size[1] + 20), (count, 1, 2))
    positions = np.concatenate(
        [centres + rng.normal(size=(count, 3, 2)) * 20, rng.uniform(-50, 50, (count, 3, 1))],
        axis=2,
    )
    corners = 3 * count
    colors = rng.integers(0, 256, (corners, 4), np.uint8)
    colors[rng.permutation(count)[: count // 2, None] * 3 + np.arange(3), 3] = 255
    return VertexBlock(
        positions=positions.reshape(-1, 3).astype(np.float32),
        colors=colors,
        indices=np.arange(corners, dtype=np.uint32),
        uvs=rng.uniform(-0.5, 1.5, (corners, 2)).astype(np.float32),
        normals=rng.normal(size=(corners, 3)).astype(np.float32),
        materials=Materials(
            ambient=rng.integers(0, 256, (corners, 4), np.uint8),
            specular=rng.integers(0, 256, (corners, 4), np.uint8),
            emissive=rng.integers(0, 64, (corners, 4), np.uint8),
            shininess=rng.uniform(0.5, 40, corners).astype(np.float32),
        ),
    )


def seen_from_camera(block: VertexBlock, size: tuple[int, int], distance: float) -> VertexBlock:
    """Return a block in pixels as a camera sees it that looks at the middle of the target."""
    block.positions -= np.array([size[0] / 2, size[1] / 2, distance], np.float32)
    return block


def random_lights(rng: np.random.Generator, *kinds: LightKind) -> tuple[Light, ...]:
    """Return a light of each kind, around the origin of a camera."""
    return tuple(_random_light(rng, kind) for kind in kinds)


def _random_light(rng: np.random.Generator, kind: LightKind) -> Light:
    direction = rng.normal(size=3)
    color, gloss = rng.uniform(0, 0.8, (2, 3)).tolist()
    is_ambient, is_spot = kind is LightKind.AMBIENT, kind is LightKind.SPOT
    return Light(
        kind,
        position=tuple(rng.uniform((-80, -60, -150), (80, 60, 0)).tolist()),
        direction=tuple((direction / np.linalg.norm(direction)).tolist()),
        ambient=tuple(color) if is_ambient else NOTHING,
        diffuse=NOTHING if is_ambient else tuple(color),
        specular=NOTHING if is_ambient else tuple(gloss),
        falloff=(1.0, rng.uniform(0, 0.01), 0.0),
        spot_cosine=float(np.cos(rng.uniform(0.5, 1.5))) if is_spot else -1.0,
        concentration=float(rng.uniform(1, 10)) if is_spot else 0.0,
    )


def random_image(rng: np.random.Generator, width: int, height: int, alpha: int | None) -> Pixels:
    """Return an image of noise; of random alpha if none is given."""
    data = rng.integers(0, 256, (height, width, 4), np.uint8)
    if alpha is not None:
        data[..., 3] = alpha
    return Pixels(data)
