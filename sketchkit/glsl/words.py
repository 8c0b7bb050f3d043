"""Words of GLSL that have changed their meaning over its versions: tables alone."""

from __future__ import annotations

from typing import NamedTuple


def word_set(text: str) -> frozenset[str]:
    """Return the words of a text: long lists are read best without commas and quotes."""
    return frozenset(text.split())


# The functions that read textures are now all called by what they do, not by the sampler.
_SAMPLERS = ("1D", "2D", "3D", "Cube", "2DRect", "1DArray", "2DArray")
_ENDINGS = ("", "ARB", "EXT")
TEXTURE_FUNCTIONS = {
    f"texture{sampler}{way}{ending}": f"texture{way}"
    for sampler in _SAMPLERS
    for way in ("", "Proj", "Lod", "ProjLod", "Grad", "ProjGrad")
    for ending in _ENDINGS
}
_SHADOWS = {
    "1D": "vec3",
    "2D": "vec3",
    "2DRect": "vec3",
    "1DProj": "vec4",
    "2DProj": "vec4",
    "2DRectProj": "vec4",
}


def shadow_function(name: str) -> str | None:
    """Return GLSL for a function `shadow...` of old; None if there is no such function.

    They returned a vec4, where `texture()` of a shadow map returns a float.
    """
    kind = _SHADOWS.get(name.removeprefix("shadow"))
    if kind is None or not name.startswith("shadow"):
        return None
    function = "textureProj" if "Proj" in name else "texture"
    sampler = f"sampler{name.removeprefix('shadow').removesuffix('Proj')}Shadow"
    return f"vec4 sk_{name}({sampler} s, {kind} p) {{ return vec4({function}(s, p)); }}"


# Functions built in since 1.30: a shader's own function of such a name is renamed.
NEWER_FUNCTIONS = word_set(
    """
    acosh asinh atanh cosh sinh tanh round roundEven trunc modf isnan isinf
    determinant inverse transpose outerProduct
    texture textureProj textureLod textureProjLod textureGrad textureProjGrad textureSize
    textureOffset textureLodOffset textureProjOffset textureGradOffset textureGather texelFetch
    texelFetchOffset textureQueryLod textureQueryLevels
    floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat fma frexp ldexp
    bitCount bitfieldExtract bitfieldInsert bitfieldReverse findLSB findMSB
    packUnorm2x16 packSnorm2x16 packUnorm4x8 packSnorm4x8 packHalf2x16 packDouble2x32
    unpackUnorm2x16 unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 unpackHalf2x16
    umulExtended imulExtended uaddCarry usubBorrow
    interpolateAtCentroid interpolateAtSample interpolateAtOffset
    imageLoad imageStore imageSize barrier
    """
)

# Words that a later version, or one to come, has kept for itself: as names they are renamed.
RESERVED = word_set(
    """
    active asm atomic_uint buffer cast class coherent common enum extern external filter fixed
    flat fvec2 fvec3 fvec4 goto half hvec2 hvec3 hvec4 image1D image2D image3D imageCube inline
    input interface layout long namespace noinline noperspective output packed partition patch
    precise public readonly resource restrict sample shared short sizeof smooth static subroutine
    superp template this typedef union unsigned using volatile writeonly
    """
)

PRECISIONS = frozenset(("lowp", "mediump", "highp"))

# Extensions whose work 3.30 does by itself.
INCLUDED_EXTENSIONS = word_set(
    """
    GL_ARB_draw_buffers GL_ARB_draw_instanced GL_ARB_explicit_attrib_location
    GL_ARB_fragment_coord_conventions GL_ARB_shader_bit_encoding GL_ARB_shader_texture_lod
    GL_ARB_texture_rectangle GL_ARB_uniform_buffer_object GL_ATI_shader_texture_lod
    GL_EXT_draw_buffers GL_EXT_frag_depth GL_EXT_gpu_shader4 GL_EXT_shader_texture_lod
    GL_EXT_texture_array GL_OES_standard_derivatives GL_OES_texture_3D
    """
)


class Legacy(NamedTuple):
    """A variable that GLSL once had by itself; in 3.30 the shader has to declare it.

    Attributes
    ----------
    name : str
        What it is called instead.
    declaration : str
        Without the name's end: `out vec4 sk_FragData` is followed by `size`.
    size : str
        Of an array, in brackets.
    fed_by : tuple of str
        Processing's names for what it holds; none, if the other stage fills it.
    """

    name: str
    declaration: str
    size: str = ""
    fed_by: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The whole declaration."""
        return f"{self.declaration} {self.name}{self.size};"


def _given(name: str, declaration: str, *fed_by: str) -> Legacy:
    return Legacy(name, declaration, fed_by=fed_by)


_BOTH = {
    "gl_ModelViewMatrix": _given("sk_ModelView", "uniform mat4", "modelview", "modelviewMatrix"),
    "gl_ProjectionMatrix": _given(
        "sk_Projection", "uniform mat4", "projection", "projectionMatrix"
    ),
    "gl_ModelViewProjectionMatrix": _given(
        "sk_Transform", "uniform mat4", "transform", "transformMatrix"
    ),
    "gl_NormalMatrix": _given("sk_NormalMatrix", "uniform mat3", "normalMatrix"),
}
LEGACY_VARIABLES = {
    "vertex": _BOTH
    | {
        "gl_Vertex": _given("sk_Vertex", "in vec4", "position", "vertex"),
        "gl_Normal": _given("sk_Normal", "in vec3", "normal"),
        "gl_Color": _given("sk_Color", "in vec4", "color"),
        "gl_MultiTexCoord0": _given("sk_MultiTexCoord0", "in vec4", "texCoord"),
        "gl_FrontColor": Legacy("sk_FrontColor", "out vec4"),
        "gl_TexCoord": Legacy("sk_TexCoord", "out vec4", "[8]"),
    },
    "fragment": _BOTH
    | {
        "gl_FragColor": Legacy("sk_FragColor", "out vec4"),
        "gl_FragData": Legacy("sk_FragData", "out vec4", "[gl_MaxDrawBuffers]"),
        "gl_Color": Legacy("sk_FrontColor", "in vec4"),
        "gl_TexCoord": Legacy("sk_TexCoord", "in vec4", "[8]"),
    },
}

# What differs where the picture's first row is its top: in OpenGL rows count from the bottom.
TURNED = {
    "gl_FragCoord": (
        "sk_FragCoord",
        "vec4 sk_FragCoord = vec4(gl_FragCoord.x, sk_is_turned > 0.5 ? "
        "sk_height - gl_FragCoord.y : gl_FragCoord.y, gl_FragCoord.zw);",
    ),
    "dFdy": (
        "sk_dFdy",
        " ".join(
            f"{kind} sk_dFdy({kind} p) {{ return dFdy(p) * (1.0 - 2.0 * sk_is_turned); }}"
            for kind in ("float", "vec2", "vec3", "vec4")
        ),
    ),
}
