"""The sketch's own programs: what is not set, what is not fed, what was there before."""

from __future__ import annotations

import warnings
from collections.abc import Iterator

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.api.pshader import PShader
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import CLOSE, P2D, RGB, TRIANGLES
from sketchkit.core.notices import SketchWarning
from tests.canvases import new_canvas

VERTEX = """
uniform mat4 transform;
attribute vec4 position;
attribute float heat;
varying float warmth;
void main() { gl_Position = transform * position; warmth = heat; }
"""
PLAIN = VERTEX.replace("warmth = heat", "warmth = 0.0")


@pytest.fixture
def g(gl_backend: GlBackend) -> PGraphics:
    canvas = new_canvas(P2D, gl_backend, (40, 20), samples=1)
    canvas.background(0)
    canvas.noStroke()
    return canvas


@pytest.fixture
def told() -> Iterator[list[warnings.WarningMessage]]:
    with warnings.catch_warnings(record=True) as messages:
        warnings.simplefilter("default", SketchWarning)
        yield messages


def cover(g: PGraphics, shader: PShader) -> None:
    """Draw over everything with a shader, in two frames."""
    g.shader(shader)
    for _ in range(2):
        g.rect(0, 0, 40, 20)
        g.end_frame()
        g.begin_frame()


def color_at(g: PGraphics, x: int, y: int) -> list[int]:
    return g.image_data()[y, x, :3].tolist()  # type: ignore[no-any-return] # of a uint8 array


def texts(told: list[warnings.WarningMessage]) -> list[str]:
    return [str(message.message) for message in told]


def test_number_that_nobody_has_set_is_said_once(
    g: PGraphics, told: list[warnings.WarningMessage]
) -> None:
    cover(g, PShader(None, PLAIN, "uniform float time; void main() { gl_FragColor = vec4(time); }"))

    (text,) = texts(told)
    assert text.startswith("Nothing has set time, a uniform of the shader of the fragment shader")
    assert "it is 0" in text


def test_several_are_said_together(g: PGraphics, told: list[warnings.WarningMessage]) -> None:
    cover(
        g,
        PShader(
            None,
            PLAIN,
            "uniform float time; uniform vec3 tone; uniform sampler2D map;"
            "void main() { gl_FragColor = texture2D(map, vec2(time)) + vec4(tone, 1.0); }",
        ),
    )

    (text,) = texts(told)
    assert "Nothing has set map, time, tone, uniforms of" in text
    assert "they are 0 or black. Its set() sets them." in text


def test_sampler_that_nobody_has_set_is_black_and_said_once(
    g: PGraphics, told: list[warnings.WarningMessage]
) -> None:
    white = PImage(2, 2, RGB)
    white.loadPixels()
    white.pixels[:] = [0xFFFFFFFF] * 4
    white.updatePixels()
    text = "uniform sampler2D map; void main() { gl_FragColor = texture2D(map, vec2(0.5)); }"
    other = PShader(None, PLAIN, text)
    other.set("map", white)

    cover(g, other)
    cover(g, PShader(None, PLAIN, text))

    assert color_at(g, 10, 10) == [0, 0, 0]
    assert len(told) == 1
    assert "Nothing has set map" in texts(told)[0]
    assert "it is black" in texts(told)[0]


@pytest.mark.parametrize(
    "fragment",
    [
        "uniform vec2 resolution; void main() { gl_FragColor = vec4(resolution, 0.0, 1.0); }",
        "uniform sampler2D texture; void main() { gl_FragColor = texture2D(texture, vec2(0.0)); }",
        "uniform vec3 lightDiffuse[8]; uniform int lightCount;"
        "void main() { gl_FragColor = vec4(lightDiffuse[lightCount], 1.0); }",
        "uniform sampler2D ppixels; void main() { gl_FragColor = texture2D(ppixels, vec2(0.0)); }",
        "uniform float unused; void main() { gl_FragColor = vec4(1.0); }",
        "uniform float begun = 0.5; void main() { gl_FragColor = vec4(begun); }",
    ],
    ids=["resolution", "texture", "lights", "ppixels", "unused", "with a first value"],
)
def test_nothing_is_said_of_what_needs_no_setting(
    g: PGraphics, told: list[warnings.WarningMessage], fragment: str
) -> None:
    cover(g, PShader(None, PLAIN, fragment))

    assert texts(told) == []


def test_value_set_later_stops_the_remark(
    g: PGraphics, told: list[warnings.WarningMessage]
) -> None:
    shader = PShader(
        None, PLAIN, "uniform float time; void main() { gl_FragColor = vec4(time, 0.0, 0.0, 1.0); }"
    )
    shader.set("time", 1.0)

    cover(g, shader)

    assert texts(told) == []
    assert color_at(g, 10, 10) == [255, 0, 0]


WARM = "varying float warmth; void main() { gl_FragColor = vec4(warmth, 0.0, 0.0, 1.0); }"


def test_attribute_that_nothing_feeds_is_said_once(
    g: PGraphics, told: list[warnings.WarningMessage]
) -> None:
    cover(g, PShader(None, VERTEX, WARM))

    (text,) = texts(told)
    assert text.startswith("Nothing feeds heat, an attribute of the shader")


def test_attribute_that_is_fed_is_not_said(
    g: PGraphics, told: list[warnings.WarningMessage]
) -> None:
    g.shader(PShader(None, VERTEX, WARM))
    g.beginShape(TRIANGLES)
    g.attrib("heat", 1.0)
    g.vertex(0, 0)
    g.vertex(80, 0)
    g.vertex(0, 40)
    g.endShape(CLOSE)

    assert color_at(g, 5, 5) == [255, 0, 0]
    assert texts(told) == []


def test_attributes_of_whole_numbers_get_whole_numbers(g: PGraphics) -> None:
    vertex = """#version 330
    uniform mat4 transform; in vec4 position; in ivec2 bone; flat out int which;
    void main() { gl_Position = transform * position; which = bone.y; }
    """
    fragment = """#version 330
    flat in int which; out vec4 color;
    void main() { color = vec4(which == 3 ? 1.0 : 0.0, 0.0, 0.0, 1.0); }
    """
    g.shader(PShader(None, vertex, fragment))
    g.beginShape(TRIANGLES)
    g.attrib("bone", 7, 3)
    g.vertex(0, 0)
    g.vertex(80, 0)
    g.vertex(0, 40)
    g.endShape()

    assert color_at(g, 5, 5) == [255, 0, 0]


BEFORE = """
uniform sampler2D before;
void main() { gl_FragColor = vec4(texture2D(before, vec2(0.5)).rgb + vec3(0.0, 0.2, 0.0), 1.0); }
"""


@pytest.mark.parametrize("name", ["ppixels", "before"])
def test_canvas_drawn_with_its_own_picture_sees_that_of_before(g: PGraphics, name: str) -> None:
    pg = g.offscreen(10, 10, P2D, 1)
    shader = PShader(None, PLAIN, BEFORE.replace("before", name))
    if name != "ppixels":
        shader.set(name, pg)

    seen = []
    for _ in range(3):
        pg.beginDraw()
        pg.background(255, 0, 0)  # it is not this that the shader sees
        pg.noStroke()
        pg.shader(shader)
        pg.rect(0, 0, 10, 10)
        pg.endDraw()
        seen.append(color_at(pg, 5, 5))

    assert seen == [[0, 51, 0], [0, 102, 0], [0, 153, 0]]


def test_window_drawn_with_its_own_picture_sees_that_of_before(g: PGraphics) -> None:
    shader = PShader(None, PLAIN, BEFORE.replace("before", "ppixels"))
    g.shader(shader)

    seen = []
    for _ in range(4):
        g.background(255, 0, 0)
        g.rect(0, 0, 40, 20)
        seen.append(color_at(g, 5, 5))
        g.end_frame()
        g.begin_frame()

    assert seen[-1] == [0, 153, 0]  # as in Processing, the first two frames see black
    assert seen[:2] == [[0, 51, 0]] * 2
