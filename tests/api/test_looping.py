import pytest

from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch


def test_looping_can_be_asked_for() -> None:
    sketch = new_sketch()
    sketch.noLoop()
    before = sketch.isLooping()
    sketch.loop()

    assert (before, sketch.isLooping()) == (False, True)


def test_frameRate_is_a_number_and_a_function() -> None:
    sketch = new_sketch()

    sketch.frameRate(30)

    assert sketch.progress.wanted_rate == 30
    assert sketch.frameRate == 60.0


@pytest.mark.parametrize(("rate", "words"), [("fast", "text for fps"), (0, "above 0")])
def test_frameRate_that_cannot_be(rate: object, words: str) -> None:
    with pytest.raises(SketchError, match=words):
        new_sketch().frameRate(rate)  # type: ignore[arg-type] # what is tested


def test_method_calls_a_function_by_name() -> None:
    sketch = new_sketch()
    calls: list[int] = []
    sketch.attach({"drawTree": lambda: calls.append(1)}, lambda: None)

    sketch.method("drawTree")

    assert calls == [1]


def test_unknown_function_is_told_with_the_nearest() -> None:
    sketch = new_sketch()
    sketch.attach({"drawTree": print}, lambda: None)

    with pytest.raises(SketchError, match="drawTree"):
        sketch.thread("drawTre")


def test_this_knows_the_canvas_too() -> None:
    sketch = new_sketch()

    assert sketch.rect == sketch.canvas.rect  # type: ignore[attr-defined] # given by __getattr__
    with pytest.raises(AttributeError):
        sketch.nothing  # type: ignore[attr-defined] # noqa: B018 # what is tested
