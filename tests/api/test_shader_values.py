"""Values for uniforms, as the shader declares them."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.api.pimage import PImage
from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.api.pvector import PVector
from sketchkit.api.shader_values import numbers_for, textures_for
from sketchkit.core.constants import RGB
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import CubeMap
from sketchkit.glsl.interface import Declared

MATRIX = PMatrix3D(*range(16))


def image(side: int = 2) -> PImage:
    return PImage(side, side, RGB)


@pytest.mark.parametrize(
    ("declared", "values", "numbers"),
    [
        (Declared("float"), (1,), [1]),
        (Declared("int"), (2.0,), [2]),
        (Declared("bool"), (True,), [1]),
        (Declared("vec3"), (1, 2, 3), [1, 2, 3]),
        (Declared("vec3"), ([1, 2, 3],), [1, 2, 3]),
        (Declared("vec3"), (np.array([1, 2, 3]),), [1, 2, 3]),
        (Declared("vec3"), (PVector(1, 2, 3),), [1, 2, 3]),
        (Declared("vec2"), (PVector(1, 2),), [1, 2]),
        (Declared("vec4"), (PVector(1, 2, 3), 4), [1, 2, 3, 4]),
        (Declared("float", 3), ([1, 2, 3],), [1, 2, 3]),
        (Declared("float", 3), ([1, 2],), [1, 2]),
        (Declared("vec2", 2), ([1, 2, 3, 4], 2), [1, 2, 3, 4]),
        (Declared("vec2", 2), ([[1, 2], [3, 4]],), [1, 2, 3, 4]),
        (Declared("vec3", 2), ([PVector(1, 2, 3), PVector(4, 5, 6)],), [1, 2, 3, 4, 5, 6]),
        (Declared("mat4"), (MATRIX,), list(range(16))),
        (Declared("mat4"), (list(range(16)),), list(range(16))),
        (Declared("mat3"), (MATRIX, True), [0, 1, 2, 4, 5, 6, 8, 9, 10]),
        (Declared("mat2"), ([[1, 2], [3, 4]],), [1, 3, 2, 4]),
        (Declared("mat2", 2), ([[[1, 2], [3, 4]], [[5, 6], [7, 8]]],), [1, 3, 2, 4, 5, 7, 6, 8]),
        (Declared("mat4", 2), ([MATRIX, MATRIX],), [*range(16), *range(16)]),
        (Declared("mat2"), (PMatrix2D(1, 2, 3, 4, 5, 6),), [1, 2, 4, 5]),
    ],
)
def test_numbers_arrive_in_the_order_of_glsl(
    declared: Declared, values: tuple[object, ...], numbers: list[float]
) -> None:
    assert list(numbers_for("u", declared, values)) == numbers


@pytest.mark.parametrize(
    ("declared", "values", "words"),
    [
        (Declared("vec3"), (1, 2), "u is a vec3 in the shader: it takes 3 numbers"),
        (Declared("float"), (1, 2), "u is a float in the shader: it takes 1 number"),
        (Declared("float"), (image(),), "u is a float"),
        (Declared("vec2"), (), "Got nothing"),
        (Declared("vec2"), ("red",), "u is a vec2"),
        (Declared("mat4"), ([1, 2, 3],), "u is a mat4 in the shader: it takes 16 numbers"),
        (Declared("float", 3), ([1, 2, 3, 4],), r"u is a float\[3\] in the shader"),
        (Declared("vec2", 3), ([1, 2, 3],), r"u is a vec2\[3\]"),
        (Declared("Lamp"), (1,), r'set\("u.member", value\)'),
    ],
)
def test_what_does_not_fit_names_the_declaration(
    declared: Declared, values: tuple[object, ...], words: str
) -> None:
    with pytest.raises(SketchError, match=words):
        numbers_for("u", declared, values)


def test_sampler_takes_an_image() -> None:
    own = image()

    assert textures_for("u", Declared("sampler2D"), (own,)) is own._texture()


def test_array_of_samplers_takes_a_list() -> None:
    first, second = image(), image()

    found = textures_for("u", Declared("sampler2D", 2), ([first, second],))

    assert found == (first._texture(), second._texture())


def test_cube_takes_six_squares_of_one_size() -> None:
    faces = [image() for _ in range(6)]

    found = textures_for("u", Declared("samplerCube"), (faces,))

    assert isinstance(found, CubeMap)
    assert found.faces == tuple(face._texture() for face in faces)


@pytest.mark.parametrize(
    ("declared", "values", "words"),
    [
        (Declared("sampler2D"), (3,), "u is a sampler2D in the shader: it takes an image"),
        (Declared("sampler2D", 2), ([image()],), "it takes 2 images"),
        (Declared("samplerCube"), ([image()] * 5,), "it takes 6 images"),
        (Declared("samplerCube"), ([image()] * 5 + [image(4)],), "squares of one size"),
    ],
)
def test_samplers_refuse_all_else(
    declared: Declared, values: tuple[object, ...], words: str
) -> None:
    with pytest.raises(SketchError, match=words):
        textures_for("u", declared, values)
