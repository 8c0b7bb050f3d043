"""Pictures that shaders of the sketch's own look at: canvases that read themselves, cube maps."""

from __future__ import annotations

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.api.pshader import PShader
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import P2D, P3D, RECT, RGB
from sketchkit.core.errors import SketchError
from tests.canvases import new_canvas

SIZE = (8, 8)
PLACED = """
uniform mat4 transform;
attribute vec4 position;
void main() { gl_Position = transform * position; }
"""
BRIGHTER = """
uniform sampler2D texture;
varying vec4 vertTexCoord;
void main() { gl_FragColor = texture2D(texture, vertTexCoord.st) + vec4(0.2, 0.0, 0.0, 0.0); }
"""
PLACED_WITH_PICTURE = """
uniform mat4 transform;
uniform mat4 texMatrix;
attribute vec4 position;
attribute vec2 texCoord;
varying vec4 vertTexCoord;
void main() {
  gl_Position = transform * position;
  vertTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}
"""
LOOKS_ABOUT = """
uniform samplerCube surroundings;
uniform vec3 direction;
void main() { gl_FragColor = textureCube(surroundings, direction); }
"""
FACES = {  # of a cube map: what each of its pictures is seen by
    (1, 0, 0): 0xFF0A0000,
    (-1, 0, 0): 0xFF140000,
    (0, 1, 0): 0xFF1E0000,
    (0, -1, 0): 0xFF280000,
    (0, 0, 1): 0xFF320000,
    (0, 0, -1): 0xFF3C0000,
}


def plain(color: int, size: tuple[int, int] = SIZE) -> PImage:
    picture = PImage(*size, RGB)
    picture.loadPixels()
    for i in range(len(picture.pixels)):
        picture.pixels[i] = color
    picture.updatePixels()
    return picture


def red_in_the_middle(canvas: PGraphics) -> int:
    return int(canvas.image_data()[4, 4, 0])


@pytest.mark.parametrize("times", [1, 2, 4])
def test_each_filter_sees_what_the_one_before_has_made(gl_backend: GlBackend, times: int) -> None:
    canvas = new_canvas(P2D, gl_backend, SIZE)
    brighter = PShader(None, PLACED_WITH_PICTURE, BRIGHTER)

    canvas.background(0)
    for _ in range(times):
        canvas.filter(brighter)

    assert red_in_the_middle(canvas) == 51 * times


@pytest.mark.parametrize("direction", FACES)
def test_cube_map_shows_the_picture_that_a_direction_meets(
    gl_backend: GlBackend, direction: tuple[int, int, int]
) -> None:
    canvas = new_canvas(P3D, gl_backend, SIZE)
    looking = PShader(None, PLACED, LOOKS_ABOUT)

    looking.set("surroundings", [plain(color) for color in FACES.values()])
    looking.set("direction", *direction)
    canvas.shader(looking)
    canvas.rect(0, 0, *SIZE)

    assert red_in_the_middle(canvas) == FACES[direction] >> 16 & 255


def test_cube_map_follows_a_picture_that_changes(gl_backend: GlBackend) -> None:
    canvas = new_canvas(P3D, gl_backend, SIZE)
    pictures = [plain(0xFF000000) for _ in FACES]
    looking = PShader(None, PLACED, LOOKS_ABOUT)
    looking.set("surroundings", pictures)
    looking.set("direction", 1, 0, 0)
    canvas.shader(looking)
    canvas.rect(0, 0, *SIZE)
    before = red_in_the_middle(canvas)

    pictures[0].set(0, 0, plain(0xFFC80000))
    canvas.rect(0, 0, *SIZE)

    assert (before, red_in_the_middle(canvas)) == (0, 200)


def test_canvases_may_be_the_faces_of_a_cube_map(gl_backend: GlBackend) -> None:
    canvas = new_canvas(P3D, gl_backend, SIZE)
    faces = [canvas.offscreen(*SIZE, P2D, 4) for _ in FACES]
    for face in faces:
        with face.beginDraw():
            face.background(90, 0, 0)
    looking = PShader(None, PLACED, LOOKS_ABOUT)
    looking.set("surroundings", faces)
    looking.set("direction", 0, 0, 1)

    canvas.shader(looking)
    canvas.rect(0, 0, *SIZE)

    assert red_in_the_middle(canvas) == 90


@pytest.mark.parametrize("sizes", [[(8, 4)] * 6, [(8, 8)] * 5 + [(4, 4)]], ids=["oblong", "mixed"])
def test_faces_of_a_cube_map_are_squares_of_one_size(sizes: list[tuple[int, int]]) -> None:
    looking = PShader(None, PLACED, LOOKS_ABOUT)

    with pytest.raises(SketchError, match="its six images are squares of one size"):
        looking.set("surroundings", [plain(0, size) for size in sizes])


def test_shape_without_light_is_no_remark_for_a_shader_of_colours(gl_backend: GlBackend) -> None:
    canvas = new_canvas(P3D, gl_backend, SIZE)
    white = "void main() { gl_FragColor = vec4(1.0); }"
    canvas.shader(PShader(None, "#define PROCESSING_COLOR_SHADER\n" + PLACED, white))
    canvas.background(0)
    square = canvas.createShape(RECT, 0, 0, *SIZE)

    canvas.shape(square)  # a warning would be an error here

    assert red_in_the_middle(canvas) == 255
