import pytest

from sketchkit.api._sketch_parts import Phase
from sketchkit.core.constants import P2D, P3D, SPAN
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


@pytest.mark.parametrize(
    ("args", "display"), [((), None), ((P2D,), None), ((1,), 1), ((P3D, 1), 1), ((SPAN,), 0)]
)
def test_fullScreen_is_as_large_as_the_screen(
    args: tuple[str | int, ...], display: int | None
) -> None:
    host = RecordingHost()
    sketch = new_sketch(host)

    sketch.fullScreen(*args)

    assert (sketch.width, sketch.height) == (sketch.displayWidth, sketch.displayHeight)
    assert host.asked == [("fullscreen", display)]


@pytest.mark.parametrize("args", [(2,), (P3D, 2)])
def test_fullScreen_can_be_on_another_screen(args: tuple[str | int, ...]) -> None:
    class TwoScreens(RecordingHost):
        def display_size(self, display: int | None = None) -> tuple[int, int]:
            return {None: (1920, 1080), 2: (800, 600)}[display]

    sketch = new_sketch(TwoScreens())

    sketch.fullScreen(*args)

    assert (sketch.width, sketch.height) == (800, 600)
    assert (sketch.displayWidth, sketch.displayHeight) == (1920, 1080)


def test_density_is_one_on_an_ordinary_screen() -> None:
    sketch = new_sketch()

    sketch.pixelDensity(1)
    with pytest.warns(SketchWarning, match="no effect"):
        sketch.pixelDensity(2)

    assert sketch.pixelDensity == sketch.displayDensity() == 1
    assert sketch.pixelWidth == sketch.width


def test_fine_screen_has_two_pixels_for_a_unit() -> None:
    host = RecordingHost()
    host.density = 2
    sketch = new_sketch(host)

    sketch.size(30, 20)

    assert (sketch.width, sketch.pixelWidth, sketch.pixelHeight) == (30, 60, 40)
    assert sketch.pixelDensity == sketch.displayDensity() == 2


def test_pixelDensity_of_one_holds_on_a_fine_screen_too() -> None:
    host = RecordingHost()
    host.density = 2
    sketch = new_sketch(host)

    sketch.size(30, 20)
    sketch.pixelDensity(1)

    assert (sketch.width, sketch.pixelWidth) == (30, 30)
