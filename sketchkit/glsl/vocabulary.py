"""What shaders are written in: types, functions and variables, for hints."""

from sketchkit.glsl.words import word_set

TYPES = word_set(
    """
    void bool int uint float double vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 uvec2 uvec3
    uvec4 mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 sampler1D
    sampler2D sampler3D samplerCube sampler2DRect sampler2DShadow struct
    """
)
STATEMENTS = word_set(
    """
    if else for while do return break continue discard switch case default true false
    """
)
FUNCTIONS = word_set(
    """
    radians degrees sin cos tan asin acos atan sinh cosh tanh pow exp log exp2 log2 sqrt inversesqrt
    abs sign floor trunc round ceil fract mod min max clamp mix step smoothstep isnan isinf
    length distance dot cross normalize faceforward reflect refract matrixCompMult outerProduct
    transpose determinant inverse lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual
    any all not texture texture1D texture2D texture3D textureCube texture2DRect texture2DProj
    texture2DLod textureLod textureProj textureSize texelFetch dFdx dFdy fwidth
    """
)
VARIABLES = frozenset(
    (
        "gl_Position",
        "gl_PointSize",
        "gl_FragColor",
        "gl_FragCoord",
        "gl_FrontFacing",
        "gl_FragDepth",
    )
)
# What Processing fills, once it is declared.
FEEDS = {
    "transform": "uniform mat4",
    "modelview": "uniform mat4",
    "projection": "uniform mat4",
    "normalMatrix": "uniform mat3",
    "texMatrix": "uniform mat4",
    "texOffset": "uniform vec2",
    "resolution": "uniform vec2",
    "viewport": "uniform vec4",
    "texture": "uniform sampler2D",
    "lightCount": "uniform int",
    "lightPosition": "uniform vec4",
    "position": "attribute vec4",
    "vertex": "attribute vec4",
    "color": "attribute vec4",
    "normal": "attribute vec3",
    "texCoord": "attribute vec2",
    "vertColor": "varying vec4",
    "vertTexCoord": "varying vec4",
    "iTime": "uniform float",
    "time": "uniform float",
    "iResolution": "uniform vec3",
}
USAGES = {
    "texture2D": "It takes the image, then the place: texture2D(image, uv), uv a vec2.",
    "texture": "It takes the image, then the place: texture(image, uv).",
    "textureCube": "It takes the image, then a direction: textureCube(image, direction), a vec3.",
    "mix": "It takes two values of the same type and how far to go: mix(a, b, 0.5).",
    "clamp": "It takes a value, the least and the most: clamp(x, 0.0, 1.0).",
    "smoothstep": "It takes two edges and a value: smoothstep(0.0, 1.0, x).",
    "step": "It takes an edge and a value: step(0.5, x).",
    "pow": "It takes a number and an exponent of the same type: pow(x, 2.0).",
    "mod": "It takes two floats, or a vector and a float: mod(x, 2.0).",
    "dot": "It takes two vectors of the same size: dot(a, b).",
    "cross": "It takes two vec3: cross(a, b).",
    "reflect": "It takes the direction of the ray and the normal: reflect(ray, normal).",
    "distance": "It takes two places of the same size: distance(a, b).",
    "length": "It takes one vector: length(v).",
    "normalize": "It takes one vector: normalize(v).",
    "min": "It takes two values of the same type: min(a, b).",
    "max": "It takes two values of the same type: max(a, b).",
    "sin": "It takes one angle in radians: sin(x).",
    "cos": "It takes one angle in radians: cos(x).",
}
