"""What a shader declares, by the names that a sketch uses."""

import pytest

from sketchkit.glsl.interface import Declared, kind_of_source, read_interface


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("#define PROCESSING_COLOR_SHADER", "COLOR"),
        ("#define   PROCESSING_TEXTURE_SHADER // note", "TEXTURE"),
        ("//#define PROCESSING_LIGHT_SHADER", "LIGHT"),
        ("/* #define PROCESSING_TEXLIGHT_SHADER */", "TEXLIGHT"),
        ("#define PROCESSING_LINE_SHADER", "LINE"),
        ("#define PROCESSING_POINT_SHADER", "POINT"),
        ("#define PROCESSING_TRIANGLES_SHADER", "POLY"),
        ("attribute vec4 direction;", "LINE"),
        ("in vec2 offset;", "POINT"),
        ("#define PROCESSING_TEX_SHADER", None),
        ("# define PROCESSING_COLOR_SHADER", None),
    ],
)
def test_kind_is_what_processing_reads_from_a_line(line, kind):
    assert kind_of_source(f"uniform mat4 transform;\n  {line}\nvoid main() {{}}") == kind


def test_first_define_of_a_file_decides():
    source = "#define PROCESSING_LIGHT_SHADER\n#define PROCESSING_COLOR_SHADER"

    assert kind_of_source(source) == "LIGHT"


def test_one_stage_is_enough_to_give_a_pair_its_kind():
    interface = read_interface("void main() {}", "#define PROCESSING_COLOR_SHADER")

    assert (interface.kind, interface.kinds_differ) == ("COLOR", False)


def test_stages_that_contradict_each_other_are_noted():
    interface = read_interface("#define PROCESSING_LIGHT_SHADER", "#define PROCESSING_COLOR_SHADER")

    assert (interface.kind, interface.kinds_differ) == ("LIGHT", True)


@pytest.mark.parametrize(
    ("declaration", "uniforms"),
    [
        ("uniform float time;", {"time": Declared("float")}),
        ("uniform lowp vec3 a, b[2];", {"a": Declared("vec3"), "b": Declared("vec3", 2)}),
        ("uniform mat4 Transforms[58];", {"Transforms": Declared("mat4", 58)}),
        ("uniform vec2[3] places;", {"places": Declared("vec2", 3)}),
        ("uniform /* a */ float // b\n x = 1.0;", {"x": Declared("float")}),
        ("#define N 4\nuniform float k[N * 2 + 1];", {"k": Declared("float", 9)}),
        ("const int N = 3;\nuniform int k[N];", {"k": Declared("int", 3)}),
        ("layout(location = 2) uniform sampler2D map;", {"map": Declared("sampler2D")}),
        ("// uniform float off;", {}),
        ("void f() { int uniformity = 1; }", {}),
        ("#ifdef GL_ES\nuniform float a;\n#endif", {"a": Declared("float")}),
    ],
)
def test_uniforms_have_type_and_length(declaration, uniforms):
    assert read_interface(None, f"{declaration}\nvoid main() {{}}").uniforms == uniforms


def test_members_of_structs_are_uniforms_of_their_own():
    source = "struct Lamp { vec3 place; float reach[2]; };\nuniform Lamp lamp, lamps[2];"

    assert read_interface(None, source).uniforms == {
        "lamp.place": Declared("vec3"),
        "lamp.reach": Declared("float", 2),
        "lamps[0].place": Declared("vec3"),
        "lamps[0].reach": Declared("float", 2),
        "lamps[1].place": Declared("vec3"),
        "lamps[1].reach": Declared("float", 2),
    }


def test_struct_declared_with_its_uniform():
    uniforms = read_interface(None, "uniform struct Fog { float near; } fog;").uniforms

    assert uniforms == {"fog.near": Declared("float")}


def test_uniforms_of_both_stages_are_one_list():
    uniforms = read_interface("uniform mat4 transform;", "uniform vec3 tint;").uniforms

    assert set(uniforms) == {"transform", "tint"}


def test_attributes_of_both_generations_are_found():
    vertex = "attribute vec4 position;\nlayout(location=1) in vec4 color;\nvarying vec4 col;"

    assert read_interface(vertex, None).attributes == {"position", "color"}


def test_variables_that_glsl_once_had_are_attributes_too():
    vertex = "void main() { gl_Position = gl_Vertex + vec4(gl_Normal, 0.0); }"

    assert read_interface(vertex, None).attributes == {"position", "normal"}


def test_variables_within_functions_are_not_declared():
    assert read_interface("void main() { vec4 position; }", None).attributes == frozenset()
