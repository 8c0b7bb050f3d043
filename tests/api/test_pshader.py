"""PShader: values for its uniforms, and what it is when its files change."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.api.pshader import PShader, loaded_files, reload_shaders
from sketchkit.api.shader_files import ShaderPaths
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import P2D, RGB
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.vertex import U8
from tests.canvases import new_canvas

VERTEX = """
uniform mat4 transform;
attribute vec4 position;
void main() { gl_Position = transform * position; }
"""
TONE = """
uniform vec3 tone;
void main() { gl_FragColor = vec4(tone, 1.0); }
"""
LIST = """
struct Lamp { vec3 tint; };
uniform float parts[3];
uniform Lamp lamp;
void main() { gl_FragColor = vec4(vec3(parts[0], parts[1], parts[2]) + lamp.tint, 1.0); }
"""
PICTURE = """
uniform sampler2D picture;
void main() { gl_FragColor = texture2D(picture, vec2(0.5)); }
"""


@pytest.fixture
def g(gl_backend: GlBackend) -> PGraphics:
    canvas = new_canvas(P2D, gl_backend, (40, 20), samples=1)
    canvas.background(0)
    canvas.noStroke()
    return canvas


def program(fragment: str) -> PShader:
    return PShader(None, VERTEX, fragment)


def picture(g: PGraphics) -> U8:
    return g.image_data()[:, :, :3]


def test_lines_make_a_shader_as_the_text_does(g: PGraphics) -> None:
    shader = PShader(None, VERTEX.splitlines(), TONE.splitlines())
    shader.set("tone", 1, 0, 0)

    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [255, 0, 0]


def test_whole_numbers_do_for_floats(g: PGraphics) -> None:
    shader = program(TONE)
    shader.set("tone", 0, 1, 0)

    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [0, 255, 0]


def test_value_set_after_drawing_does_not_reach_back(g: PGraphics) -> None:
    shader = program(TONE)
    shader.set("tone", 1, 0, 0)
    g.shader(shader)

    g.rect(0, 0, 20, 20)
    shader.set("tone", 0, 0, 1)
    g.rect(20, 0, 20, 20)

    assert picture(g)[10, [10, 30]].tolist() == [[255, 0, 0], [0, 0, 255]]


def test_values_stay_from_frame_to_frame(g: PGraphics) -> None:
    shader = program(TONE)
    shader.set("tone", 1, 0, 0)
    g.shader(shader)
    g.end_frame()
    g.begin_frame()

    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [255, 0, 0]


def test_elements_and_members_are_set_alone(g: PGraphics) -> None:
    shader = program(LIST)
    shader.set("parts", [1.0, 0.0, 0.0])
    shader.set("parts[1]", 1.0)
    shader.set("lamp.tint", 0, 0, 0.2)

    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [255, 255, 51]


def test_image_is_seen_as_it_is_when_something_is_drawn(g: PGraphics) -> None:
    image = PImage(2, 2, RGB)
    shader = program(PICTURE)
    shader.set("picture", image)
    g.shader(shader)

    for place, tone in ((0, 0xFFFF0000), (20, 0xFF0000FF)):
        image.loadPixels()
        image.pixels[:] = [tone] * 4
        image.updatePixels()
        g.rect(place, 0, 20, 20)

    assert picture(g)[10, [10, 30]].tolist() == [[255, 0, 0], [0, 0, 255]]


def test_unknown_uniform_is_said_once_with_the_nearest_name() -> None:
    shader = program(TONE)

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("default", SketchWarning)
        for _ in range(2):
            shader.set("tome", 1, 0, 0)

    (warning,) = told
    assert "no uniform 'tome'. Do you mean 'tone'?" in str(warning.message)


def test_element_behind_the_end_is_refused() -> None:
    with pytest.raises(SketchError, match="parts has 3 elements"):
        program(LIST).set("parts[3]", 1.0)


def test_what_processing_fills_is_left_to_it(g: PGraphics) -> None:
    shader = program(
        "uniform vec2 resolution; void main() { gl_FragColor = vec4(resolution / 40.0, 0.0, 1.0); }"
    )
    shader.set("resolution", 1.0, 1.0)

    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [255, 128, 0]


def test_text_is_asked_for_where_something_else_is_given() -> None:
    with pytest.raises(SketchError, match="takes the text of a vertex"):
        PShader(None, 3, TONE)  # type: ignore[arg-type] # the mistake


def test_bound_says_whether_it_is_in_force(g: PGraphics) -> None:
    shader = program(TONE)

    before = shader.bound()
    g.shader(shader)
    during = shader.bound()
    g.resetShader()

    assert (before, during, shader.bound()) == (False, True, False)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "tone.frag"
    path.write_text(TONE)
    return path


def test_saved_file_is_compiled_anew_and_values_stay(
    g: PGraphics, gl_backend: GlBackend, file: Path
) -> None:
    shader = PShader._load(ShaderPaths(file, None), gl_backend)
    shader.set("tone", 1, 0, 0)
    g.shader(shader)
    file.write_text(TONE.replace("tone, 1.0", "tone.bgr, 1.0"))

    assert reload_shaders([file], gl_backend)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [0, 0, 255]


def test_broken_file_leaves_the_shader_as_it_was(
    g: PGraphics, gl_backend: GlBackend, file: Path
) -> None:
    shader = PShader._load(ShaderPaths(file, None), gl_backend)
    shader.set("tone", 1, 0, 0)
    g.shader(shader)
    file.write_text(TONE.replace("tone, 1.0", "tome, 1.0"))

    with pytest.raises(SketchError, match=r"tone\.frag"):
        reload_shaders([file], gl_backend)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [255, 0, 0]


def test_value_of_another_type_is_dropped_when_the_file_changes(
    g: PGraphics, gl_backend: GlBackend, file: Path
) -> None:
    shader = PShader._load(ShaderPaths(file, None), gl_backend)
    shader.set("tone", 1, 1, 1)
    file.write_text("uniform float tone; void main() { gl_FragColor = vec4(vec3(tone), 1.0); }")

    reload_shaders([file], gl_backend)
    shader.set("tone", 0.2)
    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [51, 51, 51]


def test_files_of_loaded_shaders_are_known(gl_backend: GlBackend, file: Path) -> None:
    shader = PShader._load(ShaderPaths(file, None), gl_backend)

    assert file in loaded_files()
    assert not reload_shaders([file.with_name("other.frag")], gl_backend)
    assert repr(shader) == "<PShader: tone.frag>"


def test_matrices_in_a_list_arrive_like_one_alone(g: PGraphics) -> None:
    shader = program(
        "uniform mat2 both[2]; uniform mat2 one;"
        "void main() { vec2 x = vec2(1.0, 0.0);"
        "gl_FragColor = vec4(both[1] * x, (one * x).y, 1.0); }"
    )
    turn = np.array([[0.2, 0.0], [0.8, 0.0]])
    shader.set("both", [np.zeros((2, 2)), turn])
    shader.set("one", turn)

    g.shader(shader)
    g.rect(0, 0, 40, 20)

    assert picture(g)[10, 10].tolist() == [51, 204, 204]
