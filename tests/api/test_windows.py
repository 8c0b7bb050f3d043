import pytest

from sketchkit.core.constants import CROSS
from sketchkit.core.errors import SketchError
from tests.api.sketches import RecordingHost, new_sketch


@pytest.mark.parametrize("name", ["windowTitle", "setTitle"])
def test_title(name: str) -> None:
    host = RecordingHost()

    getattr(new_sketch(host), name)("Spinning")

    assert host.asked == [("title", "Spinning")]


def test_surface_is_the_window() -> None:
    host = RecordingHost()
    sketch = new_sketch(host)

    sketch.surface.setTitle("Spinning")
    sketch.frame.setResizable(True)
    sketch.surface.setLocation(10, 20)
    sketch.surface.setSize(50, 60)

    assert host.asked == [
        ("title", "Spinning"),
        ("resizable", True),
        ("position", 10, 20),
        ("size", 50, 60),
    ]
    assert (sketch.width, sketch.height) == (50, 60)


def test_cursor() -> None:
    host = RecordingHost()
    sketch = new_sketch(host)

    sketch.cursor(CROSS)
    sketch.noCursor()
    sketch.cursor()

    assert host.asked == [("cursor", CROSS), ("cursor", None), ("cursor", 0)]


def test_unknown_cursor_is_refused() -> None:
    with pytest.raises(SketchError, match="CROSS"):
        new_sketch().cursor(99)


def test_window_without_pixels_is_refused() -> None:
    with pytest.raises(SketchError, match="at least one pixel"):
        new_sketch().windowResize(0, 10)
