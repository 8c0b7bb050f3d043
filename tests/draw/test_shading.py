"""Which shader draws what."""

from __future__ import annotations

import pytest

from sketchkit.draw.shading import (
    ShaderFile,
    ShaderKind,
    ShaderSource,
    Shading,
    Shadings,
    Uniforms,
)

CASES = [(textured, lit) for textured in (False, True) for lit in (False, True)]


def shading(kind: ShaderKind, *attributes: str) -> Shading:
    file = ShaderFile("", "wave.glsl")
    return Shading(ShaderSource(None, file, kind, frozenset(attributes)), Uniforms())


@pytest.mark.parametrize(
    ("kind", "served"),
    [
        (ShaderKind.COLOR, [(False, False)]),
        (ShaderKind.TEXTURE, [(True, False)]),
        (ShaderKind.LIGHT, [(False, True)]),
        (ShaderKind.TEXLIGHT, [(True, True)]),
        (ShaderKind.ANY, CASES),
        (ShaderKind.LINE, []),
        (ShaderKind.POINT, []),
    ],
    ids=lambda value: value.name if isinstance(value, ShaderKind) else "",
)
def test_define_limits_what_a_shader_draws(
    kind: ShaderKind, served: list[tuple[bool, bool]]
) -> None:
    chosen = shading(kind)

    found = [case for case in CASES if chosen.serves(is_textured=case[0], is_lit=case[1])]

    assert found == served


@pytest.mark.parametrize("name", ["ambient", "specular", "emissive", "shininess"])
def test_shader_that_reads_the_material_gives_way_without_lights(name: str) -> None:
    chosen = shading(ShaderKind.ANY, "position", name)

    assert not chosen.serves(is_textured=False, is_lit=False)
    assert chosen.serves(is_textured=False, is_lit=True)


def test_columns_are_made_for_what_the_fill_shader_reads() -> None:
    plain = Shadings(fills=shading(ShaderKind.ANY, "position", "color"))
    full = Shadings(fills=shading(ShaderKind.ANY, "normal", "texCoord"))

    assert (plain.reads_normals, plain.reads_uvs) == (False, False)
    assert (full.reads_normals, full.reads_uvs) == (True, True)


def test_shaders_of_lines_ask_for_no_columns_of_fills() -> None:
    lines = Shadings(lines=shading(ShaderKind.LINE, "normal", "texCoord"))

    assert not lines.reads_normals
    assert not lines.reads_uvs


def test_source_is_called_by_its_fragment_file() -> None:
    source = ShaderSource(
        ShaderFile("", "wave.vert"), ShaderFile("", "wave.frag"), ShaderKind.ANY, frozenset()
    )

    assert source.name == "wave.frag"
