"""What cannot be seen in a scene, as lines: triangles, normals, axes, ground, lights, camera."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.lights import Light, LightKind
from sketchkit.core.matrix import Affine, Mat4, inverse4
from sketchkit.draw.commands import Draw, DrawList, DrawMesh
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import Layer, VertexBlock

F64 = NDArray[np.float64]
MOST_SEGMENTS = 20_000  # of a wire frame: more are no longer told apart
NORMAL_LENGTH = 0.04  # of the distance to the middle of the picture
LIGHT_SIZE = 0.03


class Lines(NamedTuple):
    """Lines of one colour.

    Attributes
    ----------
    segments : (n, 2, 3) float64, eye space
    color : int
        Packed ARGB.
    projection : Mat4
        That of what they belong to.
    """

    segments: F64
    color: int
    projection: Mat4


WIRE, NORMALS = 0xC000E0FF, 0xFFFF40FF
AXES = (0xFFFF4040, 0xFF40FF40, 0xFF6080FF)  # x, y, z
GROUND, LIGHT, CAMERA = 0x70A0A0A0, 0xFFFFE040, 0xFFFFFFFF


def wire(lists: Iterable[DrawList], target: Target) -> Iterator[Lines]:
    """Yield the edges of everything filled on a target."""
    left = MOST_SEGMENTS
    for command, block in _filled(lists, target):
        corners = _corners(command, block)[: left // 3]
        left -= 3 * len(corners)
        edges = corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
        yield Lines(edges, WIRE, command.pipeline.projection)


def normals(lists: Iterable[DrawList], target: Target, distance: float) -> Iterator[Lines]:
    """Yield the normals of everything lit on a target."""
    left = MOST_SEGMENTS
    for command, block in _filled(lists, target):
        if block.normals is None:
            continue
        first, count = _range(command)
        used = np.unique(block.indices[first : first + count])[:left]
        left -= len(used)
        begin, along = block.positions[used].astype(float), block.normals[used].astype(float)
        if isinstance(command, DrawMesh):
            linear = np.array(command.modelview).reshape(3, 4)
            begin, along = begin @ linear[:, :3].T + linear[:, 3], along @ linear[:, :3].T
        lengths = np.linalg.norm(along, axis=1, keepdims=True)
        along = along / np.where(lengths > 0, lengths, 1) * distance * NORMAL_LENGTH
        yield Lines(np.stack([begin, begin + along], axis=1), NORMALS, command.pipeline.projection)


def axes(camera: Affine, projection: Mat4, length: float) -> Iterator[Lines]:
    """Yield the three axes at the sketch's origin."""
    for axis, color in enumerate(AXES):
        end = np.zeros(3)
        end[axis] = length
        yield Lines(_placed(camera, np.array([[np.zeros(3), end]])), color, projection)


def ground(
    camera: Affine, projection: Mat4, centre: tuple[float, float, float], step: float
) -> Lines:
    """Return a grid that lies flat, 10 by 10 cells around a place of the sketch."""
    x, y, z = centre
    steps = np.arange(-5, 6) * step
    along_x = [[(x - 5 * step, y, z + own), (x + 5 * step, y, z + own)] for own in steps]
    along_z = [[(x + own, y, z - 5 * step), (x + own, y, z + 5 * step)] for own in steps]
    return Lines(_placed(camera, np.array(along_x + along_z)), GROUND, projection)


def lamps(lights: Iterable[Light], projection: Mat4, distance: float) -> Iterator[Lines]:
    """Yield a star where each light is, and an arrow where it goes."""
    size = distance * LIGHT_SIZE
    for light in lights:
        if light.kind is LightKind.AMBIENT:
            continue
        toward = np.array(light.direction) * size * 4
        if light.kind is LightKind.DIRECTIONAL:
            place = np.array([0.0, 0.0, -distance]) - toward * 2
        else:
            place = np.array(light.position)
        segments = [[place - axis * size, place + axis * size] for axis in np.eye(3)]
        if light.kind is not LightKind.POINT:
            segments.append([place, place + toward])
        yield Lines(np.array(segments), LIGHT, projection)


def frustum(projection: Mat4, distance: float) -> Lines | None:
    """Return what the sketch's own camera sees, from the eye to the middle of the picture."""
    back = inverse4(projection)
    if back is None:
        return None
    matrix = np.array(back).reshape(4, 4)
    # Where the picture's middle lies in depth, as clip space has it.
    middle = np.array(projection).reshape(4, 4) @ np.array([0, 0, -distance, 1.0])
    corners = []
    for depth in (-1.0, middle[2] / middle[3]):
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            place = matrix @ np.array([x, y, depth, 1.0])
            corners.append(place[:3] / place[3])
    near, far = corners[:4], corners[4:]
    rings = [[ring[i], ring[(i + 1) % 4]] for ring in (near, far) for i in range(4)]
    edges = [[a, b] for a, b in zip(near, far, strict=True)]
    return Lines(np.array(rings + edges), CAMERA, projection)


def _filled(
    lists: Iterable[DrawList], target: Target
) -> Iterator[tuple[Draw | DrawMesh, VertexBlock]]:
    for own in lists:
        for command in own.commands:
            match command:
                case Draw(layer=Layer.FILLS) if command.pipeline.target is target:
                    yield command, own.blocks[Layer.FILLS]
                case DrawMesh() if command.pipeline.target is target:
                    if command.part.layer is Layer.FILLS:
                        yield command, command.part.mesh.blocks[Layer.FILLS]


def _range(command: Draw | DrawMesh) -> tuple[int, int]:
    if isinstance(command, Draw):
        return command.first, command.count
    return command.part.first, command.part.count


def _corners(command: Draw | DrawMesh, block: VertexBlock) -> F64:
    """Return the corners of a draw's triangles, (n, 3, 3), eye space."""
    first, count = _range(command)
    places = block.positions[block.indices[first : first + count]].astype(np.float64)
    if isinstance(command, DrawMesh):
        matrix = np.array(command.modelview).reshape(3, 4)
        places = places @ matrix[:, :3].T + matrix[:, 3]
    return places.reshape(-1, 3, 3)


def _placed(camera: Affine, segments: F64) -> F64:
    """Return places of the sketch, (n, 2, 3), in eye space."""
    matrix = np.array(camera).reshape(3, 4)
    placed: F64 = segments @ matrix[:, :3].T + matrix[:, 3]
    return placed
