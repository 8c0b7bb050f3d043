"""Broken shaders: the message names the right line, and says what to write."""

from typing import NamedTuple

import moderngl
import pytest

from sketchkit.glsl.dialect import Modern, modernize
from sketchkit.glsl.errors import explain, original_names

VERTEX = """\
attribute vec4 position;
uniform mat4 transform;
varying vec4 col;
void main() {
  gl_Position = transform * position;
  col = vec4(1.0);
}
"""


class File(NamedTuple):
    text: str
    name: str


@pytest.fixture
def context(gl_backend):
    return gl_backend.context


def within_main(*lines):
    head = ["varying vec4 col;", "uniform float time;", "uniform sampler2D texture;"]
    return "\n".join([*head, "void main() {", *(f"  {line}" for line in lines), "}", ""])


# The name of a case, a fragment shader, the line, and what the message must say.
BROKEN = {
    "semicolon": (within_main("float a = 1.0", "gl_FragColor = vec4(a);"), 5, "semicolon"),
    "last semicolon": (within_main("gl_FragColor = vec4(1.0)"), 5, "semicolon"),
    "semicolon at the top": ("uniform float a\nvoid main() {}", 1, "semicolon"),
    "semicolon before a word": (
        "varying vec4 col\nuniform float a;\nvoid main() {}",
        1,
        "semicolon",
    ),
    "unknown variable": (within_main("gl_FragColor = vec4(tme);"), 5, "Do you mean time?"),
    "undeclared uniform": (
        within_main("gl_FragColor = vec4(resolution, 0, 1);"),
        5,
        "uniform vec2 resolution;",
    ),
    "unknown function": (within_main("gl_FragColor = vec4(sine(time));"), 5, "Do you mean sin()?"),
    "float into int": (within_main("int i = 1.5;", "gl_FragColor = col;"), 5, "int(value)"),
    "vec3 into vec4": (within_main("gl_FragColor = col.rgb;"), 5, "vec4(value, 1.0)"),
    "vec4 into vec3": (within_main("vec3 c = col;", "gl_FragColor = col;"), 5, "value.xyz"),
    "vec4 times vec3": (within_main("gl_FragColor = col * vec3(1.0);"), 5, "operator"),
    "vec4 and mat3": (within_main("gl_FragColor = col + mat3(1.0);"), 5, "operator"),
    "arguments in the wrong order": (
        within_main("gl_FragColor = texture2D(col.xy, texture);"),
        5,
        "texture2D(image, uv)",
    ),
    "four coordinates": (within_main("gl_FragColor = texture2D(texture, col);"), 5, "uv.xy"),
    "arguments of dot": (within_main("gl_FragColor = vec4(dot(col, time));"), 5, "dot(a, b)"),
    "too few numbers": (within_main("gl_FragColor = vec4(col.rg, 1.0);"), 5, "too few numbers"),
    "too many numbers": (within_main("gl_FragColor = vec4(col, 1.0);"), 5, "too many numbers"),
    "mixed letters": (within_main("gl_FragColor = vec4(col.rgx, 1.0);"), 5, ".rgx does not fit"),
    "value for a uniform": (within_main("time = 2.0;", "gl_FragColor = col;"), 5, "uniform"),
    "value for a varying": (within_main("col = vec4(2.0);"), 5, "comes from the vertex shader"),
    "brace of main": ("void main() {\n  gl_FragColor = vec4(1.0);\n", 1, "not closed"),
    "inner brace": (
        "varying vec4 col;\nvoid main() {\n  if (col.r > 0.5) {\n    discard;\n}\n",
        3,
        "not closed",
    ),
    "brace too many": ("void main() {\n}\n}\n", 3, "too many"),
    "bracket": (within_main("gl_FragColor = vec4(1.0;"), 5, "not closed"),
    "condition": (within_main("if (time) gl_FragColor = col;"), 5, "true or false"),
    "wrong return": ("float f() {\n  return vec3(1.0);\n}\nvoid main() {}", 2, "returns"),
    "no return": ("float f() {\n}\nvoid main() { gl_FragColor = vec4(f()); }", 1, "without return"),
    "declared twice": (within_main("float a = 1.0;", "float a = 2.0;"), 6, "declared twice"),
    "unknown type": (within_main("vector4 a = col;"), 5, "Do you mean vec4?"),
    "unknown type of a uniform": ("uniform Float a;\nvoid main() {}", 1, "Do you mean float?"),
    "beyond an array": (within_main("float a[2];", "a[3] = 1.0;"), 6, "array"),
    "long minus": (within_main("gl_FragColor = vec4(1.0 \u2212 0.5);"), 5, "no letter"),
    "missing endif": ("#ifdef GL_ES\nvoid main() {}\n", 1, "#endif"),
    "number with a letter": (within_main("float a = 1.0d;"), 5, "no number"),
    "text": (within_main('float a = "x";'), 5, "no text in GLSL"),
    "keyword as a name": (within_main("float switch = 1.0;"), 5, "cannot be a name"),
    "unknown version": ("#version 990\nvoid main() {}", 1, "#version"),
    "unknown directive": ("#defin A 1\nvoid main() {}", 1, "#define"),
    "open comment": (within_main("gl_FragColor = col; /* open"), 5, "*/"),
    "no such member": (
        "struct L { vec3 p; };\nuniform L lamp;\nvoid main() {\n  gl_FragColor.rgb = lamp.q;\n}",
        4,
        "no member q",
    ),
    "remainder of floats": (within_main("float a = time % 2.0;"), 5, "mod(a, b)"),
    "misspelt main": ("\nvoid mian() {}\n", 2, "no main()"),
    "other type of a varying": (
        "varying vec3 col;\nvoid main() { gl_FragColor = vec4(col, 1.0); }",
        1,
        "declared differently",
    ),
}


def failed(context, fragment):
    """Return the log of a shader that does not compile, and what was compiled."""
    pair = modernize(VERTEX, "vertex", 330), modernize(fragment, "fragment", 330)
    with pytest.raises(moderngl.Error) as caught:
        context.program(vertex_shader=pair[0].text, fragment_shader=pair[1].text)
    return str(caught.value), *pair


@pytest.mark.parametrize(("source", "line", "words"), BROKEN.values(), ids=BROKEN)
def test_message_names_the_line_and_says_what_is_wrong(context, source, line, words):
    log, vertex, fragment = failed(context, source)

    message = explain(log, File(VERTEX, "a.vert"), File(source, "b.frag"), vertex, fragment)

    assert message.startswith(f"b.frag, line {line}: ")
    assert words in message
    assert "sk_" not in message


def test_line_of_the_source_is_shown(context):
    source = within_main("gl_FragColor = colr;")
    log, _, fragment = failed(context, source)

    message = explain(log, None, File(source, "b.frag"), None, fragment)

    assert message.splitlines() == [
        "b.frag, line 5: There is no variable colr.",
        "    gl_FragColor = colr;",
        "    Do you mean col?",
    ]


# What other drivers say of the fifth line of the same shader; the text has two lines more.
OTHERS = {
    "NVIDIA, variable": ('0(7) : error C1008: undefined variable "tme"', "Do you mean time?"),
    "AMD, variable": ("ERROR: 0:7: error(#143) Undeclared identifier: tme", "Do you mean time?"),
    "Apple, variable": ("ERROR: 0:7: Use of undeclared identifier 'tme'", "Do you mean time?"),
    "ANGLE, variable": ("ERROR: 0:7: 'tme' : undeclared identifier", "Do you mean time?"),
    "NVIDIA, cast": (
        '0(7) : error C7011: implicit cast from "vec3" to "vec4"',
        "Write vec4(value, 1.0).",
    ),
    "Apple, cast": (
        "ERROR: 0:7: Incompatible types (vec4 and vec3) in assignment (and no available implicit "
        "conversion)",
        "Write vec4(value, 1.0).",
    ),
    "ANGLE, cast": (
        "ERROR: 0:7: '=' : cannot convert from '3-component vector of float' to "
        "'FragColor 4-component vector of float'",
        "Write vec4(value, 1.0).",
    ),
    "NVIDIA, arguments": (
        '0(7) : error C1115: unable to find compatible overloaded function "dot(vec4, float)"',
        "dot(a, b)",
    ),
    "ANGLE, arguments": ("ERROR: 0:7: 'dot' : no matching overloaded function found", "dot(a, b)"),
    "Apple, arguments": (
        "ERROR: 0:7: No matching function for call to dot(vec4, float)",
        "dot(a, b)",
    ),
    "AMD, operator": (
        'ERROR: 0:7: error(#160) Cannot convert from: "3-component vector of float" to: '
        '"4-component vector of float"',
        "types",
    ),
    "ANGLE, operator": (
        "ERROR: 0:7: '*' : wrong operand types - no operation '*' exists that takes a left-hand "
        "operand of type 'vec4' and a right operand of type 'vec3'",
        "operator",
    ),
    "NVIDIA, numbers": ("0(7) : error C1068: too much data in type constructor", "too many"),
    "ANGLE, numbers": (
        "ERROR: 0:7: 'constructor' : not enough data provided for construction",
        "too few",
    ),
    "ANGLE, letters": ("ERROR: 0:7: 'rgx' : illegal vector field selection", ".z too"),
}


@pytest.mark.parametrize(("log", "words"), OTHERS.values(), ids=OTHERS)
def test_logs_of_other_drivers_are_understood(log, words):
    source = within_main("gl_FragColor = vec4(tme);")
    headed = f"GLSL Compiler failed\n\nfragment_shader\n====\n{log}\n"

    message = explain(
        headed, None, File(source, "b.frag"), None, modernize(source, "fragment", 330)
    )

    assert message.startswith("b.frag, line 5: ")
    assert words in message


@pytest.mark.parametrize(
    "log",
    [
        "0(8) : error C0000: syntax error, unexpected identifier, expecting ',' or ';' at token "
        '"sk_FragColor"',
        "ERROR: 0:8: 'sk_FragColor' : syntax error",
        'ERROR: 0:8: error(#132) Syntax error: "sk_FragColor" parse error',
        "ERROR: 0:8: '' : syntax error: syntax error",
    ],
)
def test_missing_semicolon_is_found_from_any_drivers_log(log):
    source = within_main("float a = 1.0", "gl_FragColor = vec4(a);")
    headed = f"fragment_shader\n====\n{log}\n"

    message = explain(
        headed, None, File(source, "b.frag"), None, modernize(source, "fragment", 330)
    )

    assert message.startswith("b.frag, line 5: A semicolon is missing")


@pytest.mark.parametrize(
    "log",
    [
        "error: fragment shader input `cul' has no matching output in the previous stage",
        "ERROR: Input of fragment shader 'cul' not written by vertex shader",
        "error: fragment shader varying cul not declared in vertex shader",
    ],
)
def test_varying_that_nobody_writes_is_named_with_its_line(log):
    source = "\nvarying vec3 cul;\nvoid main() { gl_FragColor = vec4(cul, 1.0); }"
    pair = modernize(VERTEX, "vertex", 330), modernize(source, "fragment", 330)

    message = explain(
        f"GLSL Linker failed\n\nProgram\n====\n{log}\n",
        File(VERTEX, "a.vert"),
        File(source, "b.frag"),
        *pair,
    )

    assert message.startswith("b.frag, line 2: cul is read in the fragment shader")


def test_error_that_nobody_has_foreseen_is_told_in_the_drivers_words():
    log = "vertex_shader\n====\n0:3(1): error: the sk_Vertex is tired\n"

    message = explain(log, File("a\nb\nc", "a.vert"), None, Modern("a\nb\nc", {}, (1, 2, 3)), None)

    assert message == "a.vert, line 3: The GLSL compiler says: the gl_Vertex is tired.\n    c"


def test_names_of_ours_become_the_students():
    assert original_names("sk_FragColor, sk_texture") == "gl_FragColor, texture"
