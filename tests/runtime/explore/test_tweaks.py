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

    assert sorted(found) == [(2, 2.5), (3, 0), (6, 10), (12, 1), (12, 3), (13, 7), (15, 4)]


def test_functions_and_methods_get_new_numbers_and_state_stays(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        names = loop.program.namespace
        tweaks = Tweaks(loop.program)
        loop.step()
        for number in tweaks.numbers:
            if number.value in (7, 10, 4):
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
    assert path.read_text(encoding="utf-8") == changed.replace("a + -4", "a + -99")


def test_label_shows_where_the_number_stands(tmp_path: Path) -> None:
    with begun(written(tmp_path, SKETCH)) as loop:
        tweaks = Tweaks(loop.program)
        number = next(own for own in tweaks.numbers if own.value == 3)

        assert tweaks.label(number) == "  12  count += 1; x = 'ä' * [3]"
