from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from sketchkit.api.host import NoWindow
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import new_sketch


class Desktop(NoWindow):
    """Remembers what it was asked for, and chooses a file."""

    def __init__(self, choice: str | None = None) -> None:
        self.asked: list[object] = []
        self.choice = choice

    def open_link(self, url: str) -> None:
        self.asked.append(url)

    def launch(self, arguments: Sequence[str]) -> None:
        self.asked.append(list(arguments))

    def choose_file(
        self, kind: str, prompt: str, start: str, then: Callable[[str | None], None]
    ) -> None:
        self.asked.append((kind, prompt, start))
        then(self.choice)


def test_link_and_launch_ask_the_desktop() -> None:
    desktop = Desktop()
    sketch = new_sketch(desktop)

    sketch.link("https://processing.org")
    sketch.launch("editor", "notes.txt")

    assert desktop.asked == ["https://processing.org", ["editor", "notes.txt"]]


def test_launch_of_nothing_is_told() -> None:
    with pytest.raises(SketchError, match="name of a file"):
        new_sketch().launch()


@pytest.mark.parametrize(
    ("name", "kind"),
    [("selectInput", "input"), ("selectOutput", "output"), ("selectFolder", "folder")],
)
@pytest.mark.parametrize("choice", ["/music/song.txt", None])
def test_chosen_path_comes_to_the_function_later(
    tmp_path: Path, name: str, kind: str, choice: str | None
) -> None:
    desktop, chosen = Desktop(choice), []
    sketch = new_sketch(desktop, tmp_path)
    sketch.attach({"fileChosen": chosen.append}, lambda: None)

    getattr(sketch, name)("Which?", "fileChosen", "begin")
    before = list(chosen)
    for call in sketch.progress.due_calls:
        call()

    assert desktop.asked == [(kind, "Which?", str(tmp_path / "begin"))]
    assert before == []
    assert chosen == [choice]
    assert choice is None or chosen[0].getName() == "song.txt"


def test_function_that_is_missing_is_told_with_the_nearest() -> None:
    sketch = new_sketch()
    sketch.attach({"fileChosen": print}, lambda: None)

    with pytest.raises(SketchError, match=r"Do you mean fileChosen\?"):
        sketch.selectInput("Which?", "filechosen")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda sketch: sketch.link("https://processing.org"), r"link\(\) shows nothing"),
        (lambda sketch: sketch.launch("x.txt"), r"launch\(\) starts nothing"),
        (lambda sketch: sketch.selectInput("?", print), r"selectInput\(\) asks nobody"),
        (lambda sketch: sketch.selectFolder("?", print), r"selectFolder\(\) asks nobody"),
    ],
)
def test_without_a_window_it_is_only_said(call, words: str) -> None:
    sketch = new_sketch()

    with pytest.warns(SketchWarning, match=words):
        call(sketch)

    assert sketch.progress.due_calls == []
