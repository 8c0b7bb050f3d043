import pytest

from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch
from tests.runtime.sketches import play, written


def test_area_lies_in_the_middle_as_large_as_it_fits() -> None:
    sketch = new_sketch()
    sketch.size(400, 300)
    sketch.pointer.x, sketch.pointer.y = 200, 151

    sketch.windowRatio(100, 100)

    # 300 pixels for 100 units: 3 each, and 50 are left on either side.
    assert (sketch.ratioScale, sketch.ratioLeft, sketch.ratioTop) == (3.0, 50.0, 0.0)
    assert (sketch.rwidth, sketch.rheight) == (100, 100)
    assert (sketch.rmouseX, sketch.rmouseY) == (50, 50)


def test_without_it_all_is_as_in_the_window() -> None:
    sketch = new_sketch()
    sketch.size(400, 300)
    sketch.pointer.x, sketch.pointer.y = 7, 9

    assert (sketch.rwidth, sketch.rheight, sketch.ratioScale) == (400, 300, 1.0)
    assert (sketch.rmouseX, sketch.rmouseY) == (7, 9)


def test_each_frame_begins_in_the_area(tmp_path) -> None:
    sketch = written(
        tmp_path,
        """
        seen = []
        def setup():
            size(400, 300)
            windowRatio(100, 100)
            seen.append((screenX(0, 0), screenX(1, 0)))
        def draw():
            seen.append((screenX(0, 0), screenX(1, 0)))
        """,
    )

    seen = play(sketch, 2)["seen"]
    assert [pytest.approx(places) for places in seen] == [(0, 1), (50, 53), (50, 53)]


@pytest.mark.parametrize(
    ("args", "words"), [((0, 10), "two numbers above 0"), (("a", 10), "2 numbers: wide, high")]
)
def test_area_that_cannot_be_is_told(args, words: str) -> None:
    with pytest.raises(SketchError, match=words):
        new_sketch().windowRatio(*args)
