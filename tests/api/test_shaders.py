"""loadShader(), shader(), resetShader() and filter() on a canvas."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pshader import PShader
from sketchkit.assets.paths import set_sketch_folder, sketch_folder
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import BOX, LINES, P2D, P3D, POINTS, QUADS, TRIANGLES
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.commands import Draw, DrawMesh
from sketchkit.draw.vertex import Layer
from tests.canvases import deep_canvas, drawn, draws, fills, flat_canvas, new_canvas

VERTEX = """
uniform mat4 transform;
attribute vec4 position;
attribute vec2 texCoord;
varying vec2 uv;
void main() { gl_Position = transform * position; uv = texCoord; }
"""
RED = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }"


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[Path]:
    before = sketch_folder()
    set_sketch_folder(tmp_path)
    yield tmp_path
    set_sketch_folder(before)


def red(define: str = "") -> PShader:
    line = f"#define PROCESSING_{define}_SHADER\n" if define else ""
    return PShader(None, VERTEX, line + RED)


def shaded(g: PGraphics) -> list[bool]:
    """Return which draws a shader of the sketch's makes."""
    return [
        command.pipeline.shading is not None
        for command in drawn(g).commands
        if isinstance(command, Draw | DrawMesh)
    ]


def test_file_is_found_in_the_data_folder(folder: Path, gl_backend: GlBackend) -> None:
    (folder / "data").mkdir()
    (folder / "data" / "red.frag").write_text(RED)
    g = new_canvas(P2D, gl_backend, (20, 20), samples=1)

    g.shader(g.loadShader("red.frag"))
    g.rect(0, 0, 20, 20)

    assert g.image_data()[10, 10].tolist() == [255, 0, 0, 255]


def test_missing_file_is_named(folder: Path) -> None:
    with pytest.raises(SketchError, match=r"gone\.frag"):
        flat_canvas().loadShader("gone.frag")


def test_mistake_in_a_file_is_told_when_it_is_loaded(folder: Path, gl_backend: GlBackend) -> None:
    (folder / "wrong.frag").write_text("void main() {\n    gl_FragColor = nothing;\n}\n")
    g = new_canvas(P2D, gl_backend)

    with pytest.raises(SketchError, match=r"wrong\.frag, line 2"):
        g.loadShader("wrong.frag")


@pytest.mark.parametrize("call", ["shader", "filter"])
def test_cpu_refuses_in_one_sentence(call: str) -> None:
    g = new_canvas(P2D, CpuBackend())

    with pytest.raises(SketchError, match="The CPU renderer does not run shaders"):
        getattr(g, call)(red())


def test_shader_wants_a_shader() -> None:
    with pytest.raises(SketchError, match=r"shader\(\) takes a PShader"):
        flat_canvas().shader("red.frag")  # type: ignore[arg-type] # the mistake


@pytest.mark.parametrize("kind", [QUADS, 77])
def test_kind_is_one_of_three(kind: int) -> None:
    with pytest.raises(SketchError, match="TRIANGLES"):
        flat_canvas().shader(red(), kind)


def test_fills_are_drawn_with_it_and_strokes_of_p3d_are_not() -> None:
    g = deep_canvas()
    g.shader(red())
    g.rect(0, 0, 10, 10)

    found = {draw.layer: draw.pipeline.shading is not None for draw in draws(drawn(g))}

    assert found == {Layer.FILLS: True, Layer.LINES: False}


@pytest.mark.parametrize("explicit", [False, True])
def test_shader_of_lines_finds_its_place_by_its_define(explicit: bool) -> None:
    g = deep_canvas()
    g.shader(red("LINE"), *([LINES] if explicit else []))
    g.rect(0, 0, 10, 10)

    found = {draw.layer: draw.pipeline.shading is not None for draw in draws(drawn(g))}

    assert found == {Layer.FILLS: False, Layer.LINES: True}


def test_reset_without_a_kind_is_about_fills() -> None:
    g = deep_canvas()
    g.shader(red())
    g.shader(red("POINT"))
    g.resetShader()
    g.noStroke()
    g.rect(0, 0, 10, 10)
    g.stroke(0)
    g.point(5, 5)

    assert shaded(g) == [False, True]

    g.resetShader(POINTS)
    g.point(5, 5)

    assert shaded(g) == [False]


def test_reset_holds_from_its_line_on() -> None:
    g = flat_canvas()
    g.noStroke()
    g.shader(red())
    g.rect(0, 0, 10, 10)
    g.resetShader()
    g.rect(0, 0, 10, 10)
    g.shader(red(), TRIANGLES)
    g.rect(0, 0, 10, 10)

    assert shaded(g) == [True, False, True]


def test_shader_is_kept_in_the_next_frame() -> None:
    g = flat_canvas()
    g.noStroke()
    g.shader(red())
    g.end_frame()
    g.begin_frame()
    g.rect(0, 0, 10, 10)

    assert shaded(g) == [True]


def test_what_the_define_leaves_out_is_drawn_without_it_and_said() -> None:
    g = flat_canvas()
    g.noStroke()
    g.shader(red("TEXTURE"))
    g.rect(0, 0, 10, 10)

    with pytest.warns(SketchWarning, match="does not draw what is untextured and unlit"):
        assert shaded(g) == [False]


def test_kept_shape_is_drawn_with_the_shader_of_the_canvas() -> None:
    g = deep_canvas()
    s = g.createShape(BOX, 10)
    s.setStroke(False)
    g.shader(red())
    g.shape(s)
    g.resetShader()
    g.shape(s)

    assert shaded(g) == [True, False]


def test_own_transforms_of_a_kept_shape_are_in_its_vertices_then() -> None:
    g = deep_canvas()
    s = g.createShape(BOX, 10)
    s.setStroke(False)
    s.translate(100, 0)
    g.shader(red())
    g.translate(1, 2, 3)
    g.shape(s)

    (draw,) = (command for command in drawn(g).commands if isinstance(command, DrawMesh))

    assert draw.part.mesh.blocks[Layer.FILLS].positions[:, 0].min() == 95
    assert draw.modelview[3] - g._camera[3] == pytest.approx(1)


def test_texture_coordinates_are_kept_without_a_texture_for_a_shader() -> None:
    g = flat_canvas()
    g.noStroke()
    g.shader(red())
    g.beginShape(TRIANGLES)
    g.vertex(0, 0, 0.1, 0.2)
    g.vertex(10, 0, 0.3, 0.4)
    g.vertex(0, 10, 0.5, 0.6)
    g.endShape()

    uvs = fills(g).uvs

    assert uvs is not None
    assert uvs.ravel().tolist() == pytest.approx([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])


def test_filter_sees_what_was_drawn_and_leaves_all_else_as_it_was(gl_backend: GlBackend) -> None:
    g = new_canvas(P3D, gl_backend, (20, 20), samples=1)
    g.background(255, 0, 0)
    g.translate(10, 10)
    g.lights()
    swap = PShader(
        None,
        VERTEX.replace("uv = texCoord", "uv = vec2(texCoord.x, 1.0 - texCoord.y)"),
        "uniform sampler2D texture; varying vec2 uv;"
        "void main() { gl_FragColor = texture2D(texture, uv).gbra; }",
    )

    g.filter(swap)
    g.noStroke()
    g.fill(0, 255, 0)
    g.rect(0, 0, 10, 10)

    picture = g.image_data()
    assert picture[5, 5].tolist() == [0, 0, 255, 255]
    assert picture[15, 15].tolist() == [0, 255, 0, 255]


def test_filter_of_numbers_still_works(gl_backend: GlBackend) -> None:
    g = new_canvas(P2D, gl_backend, (20, 20), samples=1)
    g.background(255, 0, 0)

    g.filter(13)  # INVERT

    assert g.image_data()[5, 5, :3].tolist() == [0, 255, 255]
