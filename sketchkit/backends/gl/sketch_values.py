"""What Processing gives to every shader: matrices, sizes, the texture's place, the lights."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain

from sketchkit.core.lights import MOST_LIGHTS, Light, LightKind
from sketchkit.core.matrix import (
    Affine,
    Mat4,
    multiply4,
    normal_matrix,
    to_mat4,
    transpose3,
    transpose4,
)
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Target

Numbers = tuple[float, ...]

_OWN_NAMES = {
    "light_count": "lightCount",
    "light_position": "lightPosition",
    "light_direction": "lightNormal",
    "light_ambient": "lightAmbient",
    "light_diffuse": "lightDiffuse",
    "light_specular": "lightSpecular",
    "light_falloff": "lightFalloff",
    "light_spot": "lightSpot",
}
LIGHT_ARRAYS = frozenset(_OWN_NAMES.values()) - {"lightCount"}
# All that a shader need not be given by the sketch; what this package adds begins with "sk_".
FILLED = frozenset(
    (
        *_OWN_NAMES,
        *_OWN_NAMES.values(),
        *("transform", "transformMatrix", "modelview", "modelviewMatrix", "normalMatrix"),
        *("projection", "projectionMatrix", "viewport", "resolution", "scale", "perspective"),
        *("texture", "texMap", "texMatrix", "texOffset", "weight_scale", "y_sign"),
    )
)
UPRIGHT: Numbers = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
TURNED: Numbers = (1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1)  # v becomes 1 - v


def matrix_values(projection: Mat4, modelview: Affine) -> dict[str, Numbers]:
    """Return the uniforms that follow the modelview; GLSL has columns where we have rows."""
    full = to_mat4(modelview)
    transform = transpose4(multiply4(projection, full))
    eye = transpose4(full)
    return {
        "transform": transform,
        "transformMatrix": transform,
        "modelview": eye,
        "modelviewMatrix": eye,
        "normalMatrix": transpose3(normal_matrix(modelview)),
    }


def stand_in_values(values: Mapping[str, Numbers], y_sign: float) -> dict[str, Numbers]:
    """Return what our own vertex shaders call by other names."""
    own = {mine: values[theirs] for mine, theirs in _OWN_NAMES.items()}
    return own | {"y_sign": (y_sign,)}


def pipeline_values(pipeline: Pipeline) -> dict[str, Numbers]:
    """Return the uniforms that are the same for all that a pipeline draws."""
    width, height = float(pipeline.target.width), float(pipeline.target.height)
    projection = transpose4(pipeline.projection)
    values: dict[str, Numbers] = {
        "projection": projection,
        "projectionMatrix": projection,
        "viewport": (0.0, 0.0, width, height),
        "resolution": (width, height),
        "scale": pipeline.line_scale,
        "perspective": (float(pipeline.stroke_perspective),),
        "sk_height": (height,),
        "sk_is_turned": (float(pipeline.target.top_row_first),),
    }
    texture = pipeline.texture
    if texture is not None:
        values["texMatrix"] = TURNED if isinstance(texture, Target) else UPRIGHT
        values["texOffset"] = (1 / texture.width, 1 / texture.height)
    else:
        values["texMatrix"] = UPRIGHT
    return values | _light_values(pipeline.lights)


def _light_values(lights: tuple[Light, ...]) -> dict[str, Numbers]:
    """Return the arrays of the lights; those that are not there are 0."""
    missing = MOST_LIGHTS - len(lights)

    def joined(rows: Sequence[tuple[float, ...]], size: int) -> Numbers:
        return tuple(chain.from_iterable(rows)) + (0.0,) * (size * missing)

    positions = [(*light.position, _is_placed(light)) for light in lights]
    return {
        "lightCount": (float(len(lights)),),
        "lightPosition": joined(positions, 4),
        "lightNormal": joined([light.direction for light in lights], 3),
        "lightAmbient": joined([light.ambient for light in lights], 3),
        "lightDiffuse": joined([light.diffuse for light in lights], 3),
        "lightSpecular": joined([light.specular for light in lights], 3),
        "lightFalloff": joined([light.falloff for light in lights], 3),
        "lightSpot": joined([(light.spot_cosine, light.concentration) for light in lights], 2),
    }


def _is_placed(light: Light) -> float:
    return float(light.kind is not LightKind.DIRECTIONAL)
