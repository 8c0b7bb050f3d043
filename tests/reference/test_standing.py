from dataclasses import dataclass

import pytest

from sketchkit.reference.names import Name
from sketchkit.reference.standing import HANDLERS, Standing, entries, is_here
from sketchkit.runtime.events import KEY_HANDLERS, MOUSE_HANDLERS
from sketchkit.runtime.loop import LAST_CALLS


@dataclass
class PVector:
    x: float

    def mag(self) -> float:
        return self.x


NAMES: dict[str, object] = {"rect": print, "PVector": PVector}


@pytest.mark.parametrize(
    ("owner", "name", "kind", "here"),
    [
        ("", "rect", "function", True),
        ("", "ellipse", "function", False),
        ("", "print", "function", True),  # Python's own
        ("", "while", "keyword", True),
        ("", "switch", "keyword", False),
        ("", "mouseWheel", "handler", True),
        ("", "movieEvent", "handler", False),
        ("PVector", "mag", "method", True),
        ("PVector", "x", "variable", True),
        ("PVector", "y", "variable", False),
        ("Table", "addRow", "method", False),
    ],
)
def test_name_is_here(owner: str, name: str, kind: str, here: bool) -> None:
    assert is_here(Name(owner, name, kind, 1, ""), NAMES) is here


def test_entry_says_where_a_name_stands() -> None:
    found = {(entry.name.owner, entry.name.name): entry for entry in entries(NAMES)}

    assert found["", "rect"].standing is Standing.HERE
    assert found["", "HashMap"].standing is Standing.INSTEAD
    assert found["", "HashMap"].instead == "Write dict in Python."
    assert found["", "ellipse"].standing is Standing.MISSING
    assert found["", "ellipse"].instead is None


def test_handlers_are_those_that_the_runtime_calls() -> None:
    called = {*MOUSE_HANDLERS.values(), *KEY_HANDLERS.values(), *LAST_CALLS}

    assert called <= HANDLERS
    assert HANDLERS - called == {"settings", "setup", "draw", "windowMoved", "windowResized"}
