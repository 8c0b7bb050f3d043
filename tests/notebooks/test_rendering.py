import builtins
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from PIL import Image

import sketchkit
from sketchkit.core.errors import SketchError
from sketchkit.runtime.report import StoppedError
from tests.runtime.sketches import written

SKETCH = """
def setup():
    size(20, 10)
def draw():
    background(frameCount, 0, 0)
"""

# As a notebook's cells are run: compiled from a text, in a namespace without Processing's names.
CELL = """
class Dot:
    def __init__(self, x): self.x = x
    def show(self): circle(self.x, 5, 8)

twice = lambda value: value * 2
state = "at first"

def setup():
    global dot, state
    size(20, 10)
    noStroke()
    fill(0, 255, 0)
    dot = Dot(map(5, 0, 10, 0, 20))
    state = "set up"

def draw():
    background(twice(frameCount), width, mouseX)
    dot.show()
"""


def cell(text: str = CELL) -> dict[str, object]:
    namespace: dict[str, object] = {"__name__": "__main__", "__builtins__": builtins}
    exec(compile(text, "/tmp/ipykernel_1/22.py", "exec"), namespace)
    return namespace


def render(*args: object, **options: object) -> list[np.ndarray]:
    return sketchkit.render(*args, renderer="cpu", **options)


@pytest.mark.parametrize("frames", [[1, 30], "1,30", range(1, 31, 29)])
def test_file_becomes_arrays(tmp_path: Path, frames: object) -> None:
    pictures = render(written(tmp_path, SKETCH), frames=frames)

    assert [picture.shape for picture in pictures] == [(10, 20, 3)] * 2
    assert [picture[0, 0].tolist() for picture in pictures] == [[1, 0, 0], [30, 0, 0]]


def test_file_becomes_images(tmp_path: Path) -> None:
    (image,) = render(str(written(tmp_path, SKETCH)), as_images=True)

    assert isinstance(image, Image.Image)
    assert image.getpixel((0, 0)) == (1, 0, 0)


def test_namespace_of_a_notebook_becomes_a_sketch() -> None:
    namespace = cell()

    (picture,) = render(namespace, frames=3)

    assert picture[0, 0].tolist() == [6, 20, 0]
    assert picture[5, 10].tolist() == [0, 255, 0]
    assert namespace["state"] == "set up"


def test_everything_is_as_before_afterwards() -> None:
    namespace = cell()
    names, own = set(vars(builtins)), set(namespace)

    render(namespace, frames=2)

    assert set(vars(builtins)) == names
    assert set(namespace) - {"dot"} == own
    assert builtins.map is map


def test_everything_is_as_before_after_a_mistake() -> None:
    namespace = cell("def mousePressed(): pass\ndef draw():\n    elipse(1, 2, 3, 4)\n")
    names, own = set(vars(builtins)), set(namespace)

    with pytest.raises(StoppedError):
        render(namespace)

    assert set(vars(builtins)) == names
    assert set(namespace) == own
    assert sys.modules["__main__"].__name__ == "__main__"


def test_mistake_is_told_as_on_the_command_line() -> None:
    namespace = cell("def draw():\n    elipse(1, 2, 3, 4)\n")

    with pytest.raises(StoppedError) as stopped:
        render(namespace)

    assert str(stopped.value).startswith(
        "notebook, line 2: elipse is not defined.\n    Do you mean ellipse?"
    )
    assert stopped.value._render_traceback_() == str(stopped.value).splitlines()


def test_single_functions() -> None:
    def setup() -> None:
        size(8, 6)  # noqa: F821 # there while it runs

    def draw() -> None:
        background(0, 0, frameCount)  # noqa: F821 # there while it runs

    (picture,) = render(setup=setup, draw=draw, frames=7)
    (same,) = render([setup, draw], frames=7)

    assert picture.shape == (6, 8, 3)
    assert picture[0, 0].tolist() == [0, 0, 7]
    assert np.array_equal(picture, same)


def test_module() -> None:
    module = ModuleType("moving")
    exec(SKETCH, vars(module))

    (picture,) = render(module, frames=2)

    assert picture[0, 0].tolist() == [2, 0, 0]


def test_function_replaces_that_of_the_namespace() -> None:
    namespace = cell(SKETCH)
    exec("def other(): background(9, 9, 9)", namespace)

    (picture,) = render(namespace, draw=namespace["other"])

    assert picture[0, 0].tolist() == [9, 9, 9]


def test_flags_are_values_though_functions_have_their_names() -> None:
    text = "def keyPressed(): pass\ndef draw(): background(255 if keyPressed else 0)"
    namespace = cell(text)

    (picture,) = render(namespace)

    assert picture[0, 0].tolist() == [0, 0, 0]
    assert callable(namespace["keyPressed"])


def test_modules_of_others_are_left_alone() -> None:
    text = "from textwrap import dedent\ndef draw(): assert 'map' not in dedent.__globals__"

    render(cell(text))


def test_live_values_are_seen_through_the_package() -> None:
    text = "import sketchkit\ndef draw(): background(sketchkit.frameCount, 0, 0)"

    (picture,) = render(cell(text), frames=6)

    assert picture[0, 0].tolist() == [6, 0, 0]


def test_added_library_is_gone_afterwards() -> None:
    text = "def setup():\n    add_library('peasycam')\n    global kind\n    kind = CameraState"
    namespace = cell(text)

    render(namespace)

    assert namespace["kind"].__name__ == "CameraState"
    assert not hasattr(builtins, "CameraState")


def test_own_variables_come_first() -> None:
    (picture,) = render(cell("red = 7\ndef draw(): background(red, 0, 0)"))

    assert picture[0, 0].tolist() == [7, 0, 0]


def test_seed_decides() -> None:
    text = "def draw(): background(random(255), 0, 0)"

    one, same, other = (render(cell(text), seed=seed)[0] for seed in (1, 1, 12345))

    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_file_and_functions_together_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match="a file or functions, not both"):
        render(written(tmp_path, SKETCH), draw=print)


def test_something_else_is_refused() -> None:
    with pytest.raises(SketchError, match="takes a sketch's file, or functions"):
        render([1, 2])


def test_star_import_has_no_names_for_programs(tmp_path: Path) -> None:
    (tmp_path / "other.py").write_text("")
    text = "import sketchkit\nfrom sketchkit import *\nfound = 'render' in dir()\n" + SKETCH

    render(written(tmp_path, text + "    assert not found and sketchkit.render\n"))
