from pathlib import Path

import pytest

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch
from tests.runtime.sketches import begun, written

SKETCH = """
told = []
class Library:
    def pre(self): told.append(("pre", frameCount))
    def draw(self): told.append(("library's draw", mouseX))
    def post(self): told.append(("post", frameCount))
    def dispose(self): told.append("dispose")
    def mouseEvent(self, event): told.append(("mouseEvent", event.getAction(), mouseX))
    def keyEvent(self, event): told.append(("keyEvent", key))
library = Library()
def setup():
    for name in ("pre", "draw", "post", "dispose", "mouseEvent", "keyEvent"):
        registerMethod(name, library)
def draw(): told.append("draw")
def mouseMoved(): told.append("mouseMoved")
def keyPressed(): told.append("keyPressed")
"""


def test_methods_are_called_in_processings_order(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        loop.post(MouseEvent(MouseEvent.MOVE, x=7, y=8))
        loop.post(KeyEvent(KeyEvent.PRESS, key="a", keyCode=65))
        loop.step()
        loop.end()

    assert loop.program.namespace["told"] == [
        ("pre", 1),
        "draw",
        ("mouseEvent", MouseEvent.MOVE, 7),
        "mouseMoved",
        "keyPressed",
        ("keyEvent", "a"),
        ("library's draw", 7),
        ("post", 1),
        "dispose",
    ]


def test_frames_that_are_not_drawn_call_only_event_methods(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH + "noLoop()")) as loop:
        loop.step()
        told = loop.program.namespace["told"]
        told.clear()
        loop.post(MouseEvent(MouseEvent.MOVE, x=7, y=8))
        loop.step()

    assert told == [("mouseEvent", MouseEvent.MOVE, 7), "mouseMoved"]


def test_unregistered_method_is_called_no_longer(tmp_path: Path) -> None:
    text = SKETCH + "def stop(): told.clear(); unregisterMethod('dispose', library)"

    with begun(written(tmp_path, text)) as loop:
        loop.end()

    assert loop.program.namespace["told"] == []


def test_method_may_end_its_own_calls(tmp_path: Path) -> None:
    text = """
    class Once:
        def __init__(self): registerMethod("pre", self)
        def pre(self):
            told.append(1)
            unregisterMethod("pre", self)
    told = []
    Once(); Once()
    def draw(): pass
    """

    with begun(written(tmp_path, text)) as loop:
        loop.step()
        loop.step()

    assert loop.program.namespace["told"] == [1, 1]


@pytest.mark.parametrize(
    ("name", "target", "said"),
    [
        ("post", object(), "needs an object with a method post()"),
        ("drawn", object(), "knows pre, draw, post"),
    ],
)
def test_wrong_call_is_told(name: str, target: object, said: str) -> None:
    with pytest.raises(SketchError) as told:
        new_sketch().registerMethod(name, target)

    assert said in told.value.problem


def test_second_registration_is_told() -> None:
    sketch = new_sketch()
    library = type("Library", (), {"pre": lambda self: None})()
    sketch.registerMethod("pre", library)

    with pytest.raises(SketchError, match="registered already"):
        sketch.registerMethod("pre", library)
