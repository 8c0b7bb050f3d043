"""Shaders read from files."""

from __future__ import annotations

from pathlib import Path

import pytest

from sketchkit.api.shader_files import ShaderPaths, read_source
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.shading import ShaderFile, ShaderKind

FRAGMENT = "uniform vec3 tone;\nvoid main() { gl_FragColor = vec4(tone, 1.0); }\n"
VERTEX = "attribute vec4 position;\nattribute vec3 normal;\nvoid main() { gl_Position = position; }"


def test_pair_of_files_says_uniforms_and_attributes(tmp_path: Path) -> None:
    fragment, vertex = tmp_path / "a.frag", tmp_path / "a.vert"
    fragment.write_text(FRAGMENT)
    vertex.write_text(VERTEX)

    source, declared = ShaderPaths(fragment, vertex).read()

    assert declared["tone"].type == "vec3"
    assert source.attributes == {"position", "normal"}
    assert source.name == "a.frag"


def test_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match=r"gone\.frag cannot be read"):
        ShaderPaths(tmp_path / "gone.frag", None).read()


@pytest.mark.parametrize("encoding", ["utf-8-sig", "latin-1"])
def test_comments_in_other_encodings_do_no_harm(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "a.frag"
    path.write_bytes(("// größer\n" + FRAGMENT).encode(encoding))

    source, _ = ShaderPaths(path, None).read()

    assert source.fragment is not None
    assert source.fragment.text.startswith("// größer")


def test_fragment_shader_alone_stands_behind_ours() -> None:
    lit = "#define PROCESSING_LIGHT_SHADER\n" + FRAGMENT

    plain_source, _ = read_source(None, ShaderFile(FRAGMENT, "a.frag"))
    lit_source, _ = read_source(None, ShaderFile(lit, "a.frag"))

    assert plain_source.kind is ShaderKind.ANY
    assert "normal" not in plain_source.attributes
    assert lit_source.kind is ShaderKind.LIGHT
    assert "normal" in lit_source.attributes


def test_both_files_of_a_pair_are_watched(tmp_path: Path) -> None:
    pair = ShaderPaths(tmp_path / "a.frag", tmp_path / "a.vert")

    assert pair.all == (tmp_path / "a.frag", tmp_path / "a.vert")


def test_stages_of_different_kinds_are_told_once_and_the_vertex_shader_decides() -> None:
    lit = ShaderFile("#define PROCESSING_LIGHT_SHADER\n" + VERTEX, "a.vert")
    textured = ShaderFile("#define PROCESSING_TEXTURE_SHADER\n" + FRAGMENT, "a.frag")

    with pytest.warns(SketchWarning, match=r"a\.vert and a\.frag are for different kinds"):
        source, _ = read_source(lit, textured)

    assert source.kind is ShaderKind.LIGHT
