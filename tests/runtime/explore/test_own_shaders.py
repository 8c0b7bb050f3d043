"""From a pixel to the line that drew it, where shaders of the sketch's own have drawn it."""

from __future__ import annotations

from pathlib import Path

from sketchkit.backends.gl.executor import GlBackend
from sketchkit.runtime.explore.inspection import Inspection, inspect
from sketchkit.runtime.headless import Launch
from tests.runtime.sketches import Remarks, written

CUT = """\
uniform float cut;
void main() {
  if (gl_FragCoord.x < cut) discard;
  gl_FragColor = vec4(0.0, 0.0, 1.0, 1.0);
}
"""
MOVED = """\
uniform mat4 transform;
uniform vec3 by;
attribute vec4 position;
attribute vec4 color;
varying vec4 vertColor;
void main() {
  gl_Position = transform * (position + vec4(by, 0.0));
  vertColor = color;
}
"""
PLAIN = "varying vec4 vertColor;\nvoid main() { gl_FragColor = vertColor; }\n"
INVERTED = """\
uniform sampler2D texture;
varying vec4 vertTexCoord;
void main() { gl_FragColor = vec4(1.0 - texture2D(texture, vertTexCoord.st).rgb, 1.0); }
"""
TIMES = """\
uniform sampler2D other;
varying vec4 vertTexCoord;
void main() { gl_FragColor = texture2D(other, vertTexCoord.st); }
"""


def looked_at(
    folder: Path, text: str, backend: GlBackend, *places: tuple[int, int], frame: int = 2
) -> list[Inspection]:
    launch = Launch(written(folder, text), Remarks().tell)
    return inspect(launch, frame, places, backend)


def answers(found: list[Inspection]) -> list[tuple[int, tuple[int, int, int, int]]]:
    """Return of each pixel its line, and the colour that its layers come to."""
    return [(own.answer.line if own.answer else 0, own.found.color) for own in found]


DISCARDING = """\
def setup():
    size(100, 100, P3D)
    global cut
    cut = loadShader("cut.frag")
def draw():
    background(255)
    noStroke()
    fill(0, 255, 0)
    rect(0, 0, 100, 100)
    translate(0, 0, 1)
    fill(255, 0, 0)
    shader(cut)
    cut.set("cut", 50.0)
    rect(10, 10, 80, 80)
    resetShader()
"""


def test_pixel_that_a_shader_discards_belongs_to_what_is_behind(
    tmp_path: Path, gl_backend: GlBackend
) -> None:
    written(tmp_path, CUT, "cut.frag")

    left, right = looked_at(tmp_path, DISCARDING, gl_backend, (30, 50), (70, 50))

    assert answers([left, right]) == [(9, (0, 255, 0, 255)), (14, (0, 0, 255, 255))]
    assert next((own.line, why) for own, why in left.beneath()) == (
        14,
        "invisible: its shader discards this pixel",
    )


def test_row_that_a_vertex_shader_moves_is_found_where_it_shows(
    tmp_path: Path, gl_backend: GlBackend
) -> None:
    text = """\
        def setup():
            size(100, 100, P3D)
            global moved
            moved = loadShader("plain.frag", "moved.vert")
        def draw():
            background(255)
            noStroke()
            fill(0, 255, 0)
            rect(50, 0, 50, 50)
            shader(moved)
            moved.set("by", 50.0, 0.0, -5.0)
            for i in range(3):
                fill(200, 50 * i, 0)
                rect(10, 10 + 30 * i, 20, 20)
            fill(0, 0, 255)
            rect(10, 70, 20, 5)
            resetShader()
        """
    written(tmp_path, MOVED, "moved.vert")
    written(tmp_path, PLAIN, "plain.frag")

    found = looked_at(tmp_path, text, gl_backend, (70, 20), (70, 78), (69, 71), (20, 20))

    assert answers(found) == [
        (9, (0, 255, 0, 255)),  # what is moved lies behind it
        (14, (200, 100, 0, 255)),
        (16, (0, 0, 255, 255)),
        (6, (255, 255, 255, 255)),
    ]
    assert found[1].answer is not None
    assert found[1].answer.which == (3, 3)


def test_filter_shader_finds_the_picture_as_it_was(tmp_path: Path, gl_backend: GlBackend) -> None:
    text = """\
        def setup():
            size(100, 100, P2D)
            global inverted
            inverted = loadShader("inverted.frag")
        def draw():
            background(255)
            noStroke()
            fill(255, 0, 0)
            rect(0, 0, 50, 50)
            filter(inverted)
            fill(255, 255, 0)
            rect(50, 50, 50, 50)
        """
    written(tmp_path, INVERTED, "inverted.frag")

    found = looked_at(tmp_path, text, gl_backend, (20, 20), (20, 80), (80, 80))

    assert answers(found) == [
        (10, (0, 255, 255, 255)),
        (10, (0, 0, 0, 255)),
        (12, (255, 255, 0, 255)),
    ]


def test_canvas_that_a_shader_reads_is_the_one_of_that_moment(
    tmp_path: Path, gl_backend: GlBackend
) -> None:
    text = """\
        def setup():
            size(100, 100, P2D)
            global other, pg, white
            other = loadShader("other.frag")
            pg = createGraphics(10, 10, P2D)
            white = createImage(2, 2, RGB)
        def draw():
            with pg: pg.background(0, 90, 180)
            background(255)
            other.set("other", pg)
            shader(other)
            image(white, 0, 0, 50, 50)
            resetShader()
            with pg: pg.background(1, 2, 3)
        """
    written(tmp_path, TIMES, "other.frag")

    assert answers(looked_at(tmp_path, text, gl_backend, (20, 20))) == [(12, (0, 90, 180, 255))]
