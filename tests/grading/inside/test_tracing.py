import numpy as np
import pytest

from sketchkit.draw.meshes import Mesh
from sketchkit.draw.shading import ShaderFile, ShaderKind, ShaderSource, Shading, Uniforms
from sketchkit.draw.vertex import Layer, VertexBlock
from sketchkit.grading.inside.tracing import Tracer, _made_from

FRAGMENT = "uniform vec2 resolution;\nuniform float time;\nvoid main() { gl_FragColor = vec4(1); }"


def given(fragment: str, **values: object) -> frozenset[str]:
    source = ShaderSource(None, ShaderFile(fragment, "a.glsl"), ShaderKind.ANY, frozenset())
    shading = Shading(source, Uniforms(dict(values)))  # type: ignore[arg-type] # as a tape has them
    return Tracer({}).given_to(shading)


def test_what_processing_sets_itself_is_given() -> None:
    assert given(FRAGMENT, time=(1.0,)) == {"resolution", "time"}


def test_uniform_that_nobody_set_is_not_given() -> None:
    assert given(FRAGMENT) == {"resolution"}


def test_uniform_that_the_shader_has_not_is_not_given() -> None:
    assert given("void main() {}", time=(1.0,), resolution=(1.0, 1.0)) == set()


@pytest.mark.parametrize(("vertices", "boxes"), [(0, 0), (23, 0), (24, 1), (48, 2), (480, 3)])
def test_kept_shape_is_made_from_no_more_than_it_has_vertices_for(
    vertices: int, boxes: int
) -> None:
    block = VertexBlock(
        np.zeros((vertices, 3), np.float32),
        np.zeros((vertices, 4), np.uint8),
        np.zeros(0, np.uint32),
    )

    assert _made_from(Mesh({Layer.FILLS: block}), {"box": 3}) == {"box": boxes}
