"""Old GLSL becomes core GLSL: what changes, what stays, and that it compiles."""

import moderngl
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.glsl.dialect import modernize

FRAGMENT = """\
// reads texture2D: a comment
#ifdef GL_ES
precision mediump float;
#endif
uniform sampler2D texture;
varying vec4 col;
void main() {
  gl_FragColor = texture2D(texture, col.st) * col;
}
"""


@pytest.fixture
def context(gl_backend):
    return gl_backend.context


def body(source, stage="fragment", version=330):
    """Return a shader without the lines that were added."""
    modern = modernize(source, stage, version)
    lines = modern.text.split("\n")
    numbers = list(modern.lines)
    return "\n".join(
        line
        for place, line in enumerate(lines[: len(numbers)])
        if place + 1 == len(numbers) or numbers[place + 1 : place + 2] != numbers[place : place + 1]
    )


def test_words_change_and_comments_do_not():
    assert body(FRAGMENT).splitlines() == [
        "// reads texture2D: a comment",
        "#ifdef GL_ES",
        "  ",
        "#endif",
        "uniform sampler2D sk_texture;",
        "in vec4 col;",
        "void main() {",
        "  sk_FragColor = texture(sk_texture, col.st) * col;",
        "}",
    ]


def test_sketch_keeps_the_name_of_a_sampler():
    assert modernize(FRAGMENT, "fragment", 330).renamed == {"texture": "sk_texture"}


def test_each_line_knows_where_it_comes_from():
    modern = modernize(FRAGMENT, "fragment", 330)
    source = FRAGMENT.splitlines()

    for number, line in enumerate(modern.text.splitlines(), 1):
        if line.startswith(("//", "void", "}")):
            assert source[modern.source_line(number) - 1] == line


@pytest.mark.parametrize(
    ("first", "expected"),
    [
        ("", "#version 410"),
        ("#version 100\n", "#version 410"),
        ("#version 120\n", "#version 410"),
        ("#version 300 es\n", "#version 410"),
        ("#version 150\n", "#version 150"),
        ("#version 330 core\n", "#version 330 core"),
        ("//#version 150\n", "#version 410"),
    ],
)
def test_version_is_the_best_unless_the_source_has_a_modern_one(first, expected):
    text = modernize(f"{first}void main() {{}}", "fragment", 410).text

    assert text.splitlines()[0].rstrip() == expected


def test_modern_source_keeps_its_words():
    source = "#version 330\nuniform vec4 sample;\nout vec4 c;\nvoid main() { c = sample; }"

    assert modernize(source, "fragment", 450).text == source


def test_declarations_follow_the_last_extension():
    source = "#extension GL_ARB_gpu_shader5 : enable\nvoid main() { gl_FragColor = vec4(1.0); }"

    assert modernize(source, "fragment", 330).text.splitlines()[:3] == [
        "#version 330",
        "#extension GL_ARB_gpu_shader5 : enable",
        "out vec4 sk_FragColor;",
    ]


def test_rows_count_from_the_bottom():
    text = modernize("void main() { gl_FragColor = gl_FragCoord; }", "fragment", 330).text

    assert "sk_height - gl_FragCoord.y" in text
    assert "sk_FragColor = sk_FragCoord;" in text


def test_vertex_shader_is_turned_by_a_main_of_ours():
    text = modernize("#version 150\nvoid main() {\n}", "vertex", 330).text

    assert text.splitlines() == [
        "#version 150",
        "uniform float sk_y_sign;",
        "void sk_main() {",
        "}",
        "void main() { sk_main(); gl_Position.y *= sk_y_sign; }",
    ]


def test_members_of_structs_are_renamed_with_their_owners():
    source = "struct M { float sample; };\nuniform M m[2];\nvoid main() {}"

    assert modernize(source, "fragment", 330).renamed == {
        "m[0].sample": "m[0].sk_sample",
        "m[1].sample": "m[1].sk_sample",
    }


@given(st.text())
def test_lines_of_any_text_are_counted(text):
    modern = modernize(text, "fragment", 330)

    assert modern.source_line(1) == 1
    assert list(modern.lines) == sorted(modern.lines)


FRAGMENTS = {
    "sampler named texture": FRAGMENT,
    "old and new function": "uniform sampler2D texture;\nvoid main() { vec2 p = vec2(0.5); "
    "gl_FragColor = texture2D(texture, p) + texture(texture, p); }",
    "variable named texture": "uniform sampler2D t;\nvoid main() { vec2 p = vec2(0.5); "
    "vec4 texture = texture2D(t, p); gl_FragColor = texture + texture2D(t, p.yx); }",
    "function named texture": "uniform sampler2D t;\nvec4 texture(vec2 p) { return texture2D(t, p);"
    " }\nvoid main() { gl_FragColor = texture(vec2(0.5)); }",
    "functions named like new ones": "float round(float x) { return floor(x + 0.5); }\n"
    "mat3 transpose(mat3 m) { return m; }\nfloat sinh(float x) { return x; }\n"
    "void main() { gl_FragColor = vec4(transpose(mat3(1.0))[0], round(sinh(1.2))); }",
    "reserved words": "uniform float sample;\nuniform vec3 filter, input;\n"
    "float half(float common) { return common * 0.5; }\n"
    "void main() { float buffer = 1.0, shared = 2.0, smooth = 3.0, flat = 4.0, output = 5.0;\n"
    "gl_FragColor = vec4(sample + half(buffer), shared + smooth, flat, output)"
    " + vec4(filter + input, 1.0); }",
    "qualifiers": "flat in int kind;\nsmooth in vec4 c;\nout vec4 result;\n"
    "void main() { result = c * float(kind); }",
    "macro for a function": "#define texture2D texture\nuniform sampler2D t;\n"
    "void main() { gl_FragColor = texture2D(t, vec2(0.5)); }",
    "macros": "#define TEX(s, p) texture2D(s, p).rgb\n#define T texture2D\n#define S texture\n"
    "uniform sampler2D texture;\n"
    "void main() { gl_FragColor = vec4(TEX(texture, vec2(0.5)), 1.0) + T(S, vec2(0.1)); }",
    "macro for texture()": "#define T texture\nuniform sampler2D texture;\n"
    "void main() { gl_FragColor = T(texture, vec2(0.5)); }",
    "macros for precisions": "#define highp\n#define PRECISION mediump\n"
    "precision PRECISION float;\nuniform highp float x;\nvoid main() { gl_FragColor = vec4(x); }",
    "macro of a condition": "#if __VERSION__ >= 130\n#define varying in\n#endif\n"
    "varying vec4 col;\nvoid main() { gl_FragColor = col; }",
    "several outputs": "void main() { gl_FragData[0] = vec4(1.0); gl_FragData[1] = vec4(0.0); }",
    "OpenGL ES": "#version 100\nprecision mediump float;\nuniform lowp sampler2D texture;\n"
    "varying highp vec4 col;\nvoid main() { gl_FragColor = texture2D(texture, col.st, 0.5); }",
    "OpenGL ES 3": "#version 300 es\nprecision highp float;\nin vec4 col;\nout vec4 result;\n"
    "void main() { result = col * gl_FragCoord.y; }",
    "version after a comment": "// hi\n#version 120\n#extension GL_EXT_gpu_shader4 : enable\n"
    "invariant varying vec4 col;\nvoid main() { gl_FragColor = col; }",
    "modern": "#version 330 core\nlayout(location = 0) out vec4 c;\nin vec4 col;\n"
    "void main() { c = col + gl_FragCoord + dFdy(col); }",
    "ways to read": "#extension GL_ARB_shader_texture_lod : require\nuniform sampler2D t;\n"
    "uniform samplerCube e;\nvarying vec4 col;\nvoid main() { gl_FragColor = "
    "texture2DLod(t, col.st, 1.0) + textureCube(e, col.xyz) + texture2DProj(t, col)"
    " + texture2DGradARB(t, col.xy, col.xy, col.zw); }",
    "samplers": "#extension GL_ARB_texture_rectangle : enable\nuniform sampler2DRect r;\n"
    "uniform sampler1D line;\nuniform sampler3D block;\nvarying vec4 col;\n"
    "void main() { gl_FragColor = texture2DRect(r, col.st) + texture1D(line, col.x)"
    " + texture3D(block, col.xyz); }",
    "shadow map": "uniform sampler2DShadow s;\nvarying vec4 col;\n"
    "void main() { gl_FragColor = shadow2D(s, col.xyz) + shadow2DProj(s, col); }",
    "derivatives": "#ifdef GL_OES_standard_derivatives\n"
    "#extension GL_OES_standard_derivatives : enable\n#endif\nvarying vec4 col;\n"
    "void main() { gl_FragColor = vec4(cross(dFdx(col.xyz), dFdy(col.xyz)), fwidth(col.x)); }",
    "place outside of functions": "uniform vec2 resolution;\n"
    "vec2 uv = gl_FragCoord.xy / resolution;\nvoid main() { gl_FragColor = vec4(uv, 0.0, 1.0); }",
    "lists in braces": "float k[3] = {1.0, 2.0, 3.0};\nconst float[2] m = {1.0, 2.0};\n"
    "void main() { vec2 a = {1.0, 2.0}; gl_FragColor = vec4(k[0], m[1], a); }",
    "whole numbers": "float f(float x) { if (x > 1) return 1; return -0; }\n"
    "void main() { float a = 1; float b = max(0, a); b = pow(a, 2);\n"
    "gl_FragColor = vec4(f(1), b, clamp(a, 0, 1), mod(a, 2)); }",
    "two main() and a condition": "#ifdef GL_ES\nvoid main() {}\n#else\n"
    "void main(void) { gl_FragColor = vec4(1.0); }\n#endif",
    "letters from a paste": "// caf\u00e9 \u2014\nvoid main() {\u00a0gl_FragColor = vec4(1.0); }",
    "ends of lines of Windows": "varying vec4 col;\r\nvoid main()\r\n{ gl_FragColor = col; }\r\n",
}
PASS_ON = """\
uniform mat4 transform;
attribute vec4 vertex;
attribute vec4 color;
varying vec4 col;
void main() {
  gl_Position = transform * vertex;
  col = color;
}
"""


@pytest.mark.parametrize("version", [330, 410, 450])
@pytest.mark.parametrize("source", FRAGMENTS.values(), ids=FRAGMENTS)
def test_fragment_shader_compiles(context, source, version):
    if version > context.version_code:
        pytest.skip(f"OpenGL has {context.version_code} here")
    needed = PASS_ON.replace(
        "varying vec4 col;", "varying vec4 col; flat out int kind; smooth out vec4 c;"
    )
    needed = needed.replace("col = color;", "col = color; kind = 1; c = color;")

    context.program(
        vertex_shader=modernize(needed, "vertex", version).text,
        fragment_shader=modernize(source, "fragment", version).text,
    )


VERTICES = {
    "plain": PASS_ON,
    "new words": "in vec4 position;\nout vec4 col;\n"
    "void main(void) { col = position; gl_Position = position; }",
    "modern": "#version 330\nlayout(location = 0) in vec4 position;\nint main_count = 3;\n"
    "void main ( ) { gl_Position = position * float(main_count); }",
    "variables of old": "#version 120\nvoid main() {\n"
    "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; gl_FrontColor = gl_Color;\n"
    "gl_TexCoord[0] = gl_MultiTexCoord0 + vec4(gl_NormalMatrix * gl_Normal, 0.0); }",
    "bones": "uniform mat4 Transforms[58];\nattribute vec4 Weights;\n"
    "attribute vec4 MatrixIndices;\nvarying vec3 normal;\nvoid main() {\n"
    "mat4 transform = Weights.x * Transforms[int(round(MatrixIndices.x))];\n"
    "gl_Position = transform * gl_Vertex;\nnormal = vec3(transform * vec4(gl_Normal, 0.0));\n}",
    "texture in a vertex shader": "uniform sampler2D texture;\nattribute vec2 texCoord;\n"
    "void main() { gl_Position = texture2DLod(texture, texCoord, 0.0); }",
}


@pytest.mark.parametrize("version", [330, 450])
@pytest.mark.parametrize("source", VERTICES.values(), ids=VERTICES)
def test_vertex_shader_compiles(context, source, version):
    if version > context.version_code:
        pytest.skip(f"OpenGL has {context.version_code} here")

    context.program(
        vertex_shader=modernize(source, "vertex", version).text,
        fragment_shader=f"#version {version}\nvoid main() {{}}",
    )


def test_variables_of_old_are_fed_by_processings_names(context):
    modern = modernize(VERTICES["bones"], "vertex", 330)

    assert modern.renamed == {"position": "sk_Vertex", "vertex": "sk_Vertex", "normal": "sk_Normal"}


def test_word_that_is_wrong_stays_wrong(context):
    text = modernize("void main() { gl_FragColor = vec4(nothing); }", "fragment", 330).text

    with pytest.raises(moderngl.Error):
        context.program(vertex_shader=modernize(PASS_ON, "vertex", 330).text, fragment_shader=text)
