"""The numbers panel under the mouse, drawn by the CPU renderer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from sketchkit.api.events import Event, MouseEvent
from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import P2D
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.explore.numbers_panel import NumbersPanel
from sketchkit.runtime.explore.tweaks import Number
from sketchkit.runtime.loop import Loop
from tests.runtime.sketches import begun, written

TEXT = "speed = 100\nshift = -5\ndef draw():\n    circle(10, 20, 0x40)\n"
ROW = 16  # px: the first line is the title


class Table:
    """A sketch, and its numbers on a canvas."""

    def __init__(self, loop: Loop, size: tuple[int, int]) -> None:
        self.loop = loop
        self.panel = NumbersPanel()
        self.panel.follow(loop.program)
        self.canvas = PGraphics(Renderer(CpuBackend()), Target(*size))
        self.canvas.resize(*size, P2D, 1)
        self.draw()

    @property
    def numbers(self) -> list[Number]:
        assert self.panel.tweaks is not None
        return self.panel.tweaks.numbers

    def draw(self) -> None:
        self.panel.draw(self.canvas)

    def mouse(self, action: int, row: int, x: int = 40, count: int = 1, modifiers: int = 0) -> bool:
        y = 8 + 4 + ROW * (row + 1) + ROW // 2
        event = MouseEvent(action, x=x, y=y, count=count, modifiers=modifiers)
        taken = self.panel.handles_mouse(event)
        self.draw()
        return taken


@contextmanager
def table(folder: Path, text: str = TEXT, size: tuple[int, int] = (500, 200)) -> Iterator[Table]:
    with begun(written(folder, text)) as loop:
        yield Table(loop, size)


def test_drag_changes_the_number_of_its_row_and_comes_back(tmp_path: Path) -> None:
    with table(tmp_path) as at:
        at.mouse(MouseEvent.PRESS, 0)
        at.mouse(MouseEvent.DRAG, 0, x=60)  # 20 px: 10 steps of 100 / 50
        there = at.loop.program.namespace["speed"]
        at.mouse(MouseEvent.DRAG, 3, x=40)
        back = at.loop.program.namespace["speed"]
        at.mouse(MouseEvent.RELEASE, 3, x=40)
        at.mouse(MouseEvent.MOVE, 0, x=90)

        assert (there, back) == (120, 100)
        assert at.loop.program.namespace["speed"] == 100


def test_shift_drags_ten_times_as_fast(tmp_path: Path) -> None:
    with table(tmp_path) as at:
        at.mouse(MouseEvent.PRESS, 0)
        at.mouse(MouseEvent.DRAG, 0, x=42, modifiers=Event.SHIFT)

        assert at.numbers[0].value == 120


def test_wheel_changes_the_chosen_number_and_else_chooses(tmp_path: Path) -> None:
    with table(tmp_path) as at:
        at.mouse(MouseEvent.WHEEL, 0, count=-1)
        at.mouse(MouseEvent.WHEEL, 3, count=1)  # now the second one is chosen
        at.mouse(MouseEvent.WHEEL, 1, count=1)

        assert [number.value for number in at.numbers[:2]] == [102, -6]


def test_click_below_the_numbers_writes_them(tmp_path: Path) -> None:
    with table(tmp_path) as at:
        at.mouse(MouseEvent.PRESS, 4)
        at.mouse(MouseEvent.DRAG, 4, x=44)
        at.mouse(MouseEvent.RELEASE, 4)

        at.mouse(MouseEvent.PRESS, 5)

        assert (tmp_path / "sketch.py").read_text() == TEXT.replace("0x40", "0x42")
        assert not at.numbers[4].is_changed


def test_what_happens_beside_the_panel_is_the_sketchs(tmp_path: Path) -> None:
    with table(tmp_path) as at:
        assert at.mouse(MouseEvent.PRESS, 1)
        at.mouse(MouseEvent.RELEASE, 1)
        assert not at.mouse(MouseEvent.PRESS, 1, x=480)
        assert not at.mouse(MouseEvent.PRESS, 9)


@pytest.mark.parametrize("size", [(300, 200), (120, 90)])
def test_long_lines_are_cut_around_their_number(tmp_path: Path, size: tuple[int, int]) -> None:
    text = f"value = {' + '.join('abcdefgh' for _ in range(20))} + 12 + 'and so much more'\n"
    shown: list[str] = []
    with table(tmp_path, "def draw():\n    " + text, size) as at:
        at.canvas.text = lambda line, *place: shown.append(line)  # type: ignore[method-assign] # a spy
        at.draw()

    row = next(line for line in shown if "value" in line or "[12]" in line)
    assert "[12]" in row
    assert at.canvas.textWidth(row) <= size[0]
    assert len(shown) == len({*shown})  # a row for each line


def test_all_numbers_can_be_reached_in_a_small_window(tmp_path: Path) -> None:
    text = "".join(f"n{i} = {i + 1000}\n" for i in range(30))
    with table(tmp_path, text, (300, 120)) as at:
        for _ in range(29):
            at.mouse(MouseEvent.WHEEL, -1, count=1)
        at.mouse(MouseEvent.WHEEL, 3, count=-1)  # the last of 4 rows

        assert at.numbers[29].value > 1029
