from pathlib import Path

import pytest

from sketchkit.runtime.explore.tweaks import Tweaks
from tests.runtime.sketches import begun, written

SKETCH = """\
# größe: 5
speed = 2.5
count = 0
class Ball:
    def size(self):
        return 10
ball = Ball()
def setup():
    size(300, 200)
def draw():
    global count
    count += 1; x = 'ä' * 3
    return helper(7)
def helper(a):
    return a + -4
"""


def test_numbers_are_found_but_for_those_of_size(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        found = [(number.line, number.value) for number in Tweaks(loop.program).numbers]

    assert sorted(found) == [(2, 2.5), (3, 0), (6, 10), (12, 1), (12, 3), (13, 7), (15, -4)]


def test_functions_and_methods_get_new_numbers_and_state_stays(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        names = loop.program.namespace
        tweaks = Tweaks(loop.program)
        loop.step()
        for number in tweaks.numbers:
            if number.value in (7, 10, -4):
                number.value *= 2

        tweaks.apply()

        draw, ball = names["draw"], names["ball"]
        assert draw() == 14 - 8  # type: ignore[operator] # the sketch's function
        assert ball.size() == 20  # type: ignore[attr-defined] # of the sketch's class
        assert names["count"] == 2


def test_variable_of_the_file_gets_its_new_number(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        tweaks = Tweaks(loop.program)
        number = next(own for own in tweaks.numbers if own.line == 2)
        number.step(3)
        tweaks.apply()

        assert loop.program.namespace["speed"] == pytest.approx(2.8)
        assert loop.program.namespace["count"] == 0


def test_writing_changes_the_numbers_alone(tmp_path: Path) -> None:
    path = written(tmp_path, SKETCH)
    with begun(path) as loop:
        tweaks = Tweaks(loop.program)
        for number in tweaks.numbers:
            if number.line in (12, 15):
                number.value = 99
        tweaks.write()

    changed = SKETCH.replace("count += 1; x = 'ä' * 3", "count += 99; x = 'ä' * 99")
    assert path.read_text(encoding="utf-8") == changed.replace("a + -4", "a + 99")


def test_number_is_shown_in_its_line(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        tweaks = Tweaks(loop.program)
        number = next(own for own in tweaks.numbers if own.value == 3)

        assert tweaks.around(number) == ("count += 1; x = 'ä' * ", "[3]", "")


@pytest.mark.parametrize(
    ("text", "value", "written_text"),
    [
        ("x = 2 - 3", -4, "x = 2 - (-4)"),
        ("x = f(3)", -4, "x = f(-4)"),
        ("x = -3", 4, "x = 4"),
        ("x = 0x003", 255, "x = 0x0FF"),
        ("x = 1.50", 1.5, "x = 1.50"),
    ],
)
def test_number_keeps_its_meaning_in_the_file(
    tmp_path: Path, text: str, value: float, written_text: str
) -> None:
    path = written(tmp_path, f"def f(): return 3\ndef draw():\n    {text}\n")
    with begun(path) as loop:
        tweaks = Tweaks(loop.program)
        number = tweaks.numbers[-1]
        number.value = value
        tweaks.write()

    assert path.read_text().splitlines()[2] == f"    {written_text}"


def test_variable_that_the_sketch_has_changed_is_left_alone_by_other_numbers(
    tmp_path: Path,
) -> None:
    text = "count = 0\nspeed = 5\ndef draw():\n    global count\n    count += 1\n"
    with begun(written(tmp_path, text)) as loop:
        tweaks = Tweaks(loop.program)
        tweaks.numbers[0].value = 40
        tweaks.apply()
        loop.step()
        tweaks.numbers[1].value = 7
        tweaks.apply()

        assert loop.program.namespace["count"] == 41
        assert loop.program.namespace["speed"] == 7


def test_class_and_mouse_handler_get_new_numbers(tmp_path: Path) -> None:
    text = "class Ball:\n    size = 3\ndef mousePressed():\n    return 8\ndef draw(): pass\n"
    with begun(written(tmp_path, text)) as loop:
        tweaks = Tweaks(loop.program)
        for number in tweaks.numbers:
            number.value += 1
        tweaks.apply()

        assert loop.program.namespace["Ball"].size == 4  # type: ignore[attr-defined] # the sketch's
        assert loop.program.sketch.handlers["mousePressed"]() == 9


def test_written_numbers_that_run_already_are_no_reason_to_begin_anew(tmp_path: Path) -> None:
    path = written(tmp_path, "def setup():\n    f(4)\ndef f(x): return x + 5\ndef draw(): f(6)\n")
    with begun(path) as loop:
        tweaks = Tweaks(loop.program)
        tweaks.numbers[1].value = 50
        tweaks.write()
        once, again = tweaks.takes_written(path), tweaks.takes_written(path)
        tweaks.numbers[0].value = 40  # only setup() would show that
        tweaks.write()

        assert (once, again) == (True, False)
        assert not tweaks.takes_written(path)
    assert "x + 50" in path.read_text()
    assert "f(40)" in path.read_text()


def test_fractions_of_python_2_stay_whole_numbers(tmp_path: Path) -> None:
    path = written(tmp_path, "def half():\n    return 7 / 2\ndef draw(): pass\n", "sketch.pyde")
    with begun(path) as loop:
        tweaks = Tweaks(loop.program)
        tweaks.numbers[0].value = 9
        tweaks.apply()

        assert loop.program.namespace["half"]() == 4  # type: ignore[operator] # the sketch's
