import pytest

from sketchkit.api._sketch_parts import Phase
from sketchkit.core.constants import P2D, P3D
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import RecordingHost, new_sketch


def test_size_resizes_canvas_and_window() -> None:
    host = RecordingHost()
    sketch = new_sketch(host)

    sketch.size(320.7, 240, P3D)

    assert (sketch.width, sketch.height) == (320, 240)
    assert host.asked == [("size", 320, 240)]


def test_canvas_has_four_samples_until_noSmooth() -> None:
    sketch = new_sketch()

    sketch.size(10, 10)
    smooth = sketch.canvas.target.samples
    sketch.noSmooth()

    assert (smooth, sketch.canvas.target.samples) == (4, 1)


@pytest.mark.parametrize("level", [2, 4, 8])
def test_smooth_at_any_level_changes_nothing(level: int) -> None:
    sketch = new_sketch()
    version = sketch.canvas.target.version

    sketch.smooth(level)

    assert sketch.canvas.target.version == version


@pytest.mark.parametrize(
    ("args", "words"),
    [
        ((0, 10), "at least 1"),
        ((10, -4), "at least 1"),
        ((20000, 10), "at most 16384"),
        (("a", 10), "text for width"),
        ((10, 10, "P3D"), "without quotes"),
    ],
)
def test_size_that_cannot_be(args: tuple[object, ...], words: str) -> None:
    with pytest.raises(SketchError, match=words):
        new_sketch().size(*args)  # type: ignore[arg-type] # what is tested


def test_size_in_draw_names_windowResize() -> None:
    sketch = new_sketch()
    sketch.progress.phase = Phase.DRAW

    with pytest.raises(SketchError, match="windowResize"):
        sketch.size(10, 10)


def test_noSmooth_in_draw_is_too_late() -> None:
    sketch = new_sketch()
    sketch.progress.phase = Phase.DRAW

    with pytest.warns(SketchWarning, match=r"no effect in draw\(\)"):
        sketch.noSmooth()

    assert sketch.canvas.target.samples == 4


@pytest.mark.parametrize("args", [(), (P2D,), (1,), (P3D, 1)])
def test_fullScreen_is_as_large_as_the_screen(args: tuple[str | int, ...]) -> None:
    host = RecordingHost()
    sketch = new_sketch(host)

    sketch.fullScreen(*args)

    assert (sketch.width, sketch.height) == (sketch.displayWidth, sketch.displayHeight)
    assert host.asked == [("fullscreen",)]


def test_density_is_one() -> None:
    sketch = new_sketch()

    sketch.pixelDensity(1)
    with pytest.warns(SketchWarning, match="no effect"):
        sketch.pixelDensity(2)

    assert sketch.pixelDensity == sketch.displayDensity() == 1
    assert sketch.pixelWidth == sketch.width
