import pytest

from sketchkit.api.gl_access import PGL
from sketchkit.core.constants import JAVA2D, P2D, P3D
from tests.api.sketches import new_sketch


@pytest.mark.parametrize("name", ["flush", "beginPGL"])
def test_what_was_called_for_is_drawn(name: str) -> None:
    canvas = new_sketch().canvas
    canvas.rect(10, 20, 30, 40)
    before = canvas.has_shapes

    getattr(canvas, name)()

    assert (before, canvas.has_shapes) == (True, False)


def test_block_gives_a_PGL() -> None:
    canvas = new_sketch().canvas

    with canvas.beginPGL() as pgl:
        pgl.flush()
        pgl.finish()
    canvas.endPGL()

    assert isinstance(pgl, PGL)


@pytest.mark.parametrize(
    ("renderer", "expected"),
    [(JAVA2D, (False, True, False)), (P2D, (True, True, False)), (P3D, (True, False, True))],
)
def test_kind_of_canvas_can_be_asked_for(renderer: str, expected: tuple[bool, ...]) -> None:
    sketch = new_sketch()
    sketch.size(20, 20, renderer)
    canvas = sketch.canvas

    assert (canvas.isGL(), canvas.is2D(), canvas.is3D()) == expected
