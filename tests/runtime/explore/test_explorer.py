"""The explorer without a window: events go in, pictures come out of the CPU renderer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.clock import VirtualClock
from sketchkit.core.constants import CODED, DOWN, ENTER, LEFT, RIGHT
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.vertex import U8
from sketchkit.runtime.explore.explorer import SketchExplorer
from sketchkit.runtime.headless import Launch, opened
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.overlay import Overlay
from sketchkit.runtime.reload import exchange
from tests.runtime.sketches import Remarks, written

SOLID = """\
def setup():
    size(200, 150, P3D)
def draw():
    background(255)
    translate(100, 75)
    fill(255, 0, 0)
    noStroke()
    box(40)
"""
FLAT = """\
edge = 20
def setup():
    size(200, 150)
def draw():
    background(255)
    fill(255, 0, 0)
    noStroke()
    square(50, 50, edge)
    circle(150, 75, 30)
"""


class Stand:
    """A sketch, an explorer, and what would be shown."""

    def __init__(self, loop: Loop, explorer: SketchExplorer, backend: CpuBackend) -> None:
        self.loop, self.explorer, self.backend = loop, explorer, backend
        self.overlay = Overlay(backend)

    def step(self, count: int = 1) -> None:
        for _ in range(count):
            self.loop.step()
            self.shown()

    def key(self, number: int) -> bool:
        """Press F1 to F12."""
        return self.explorer.handles(KeyEvent(KeyEvent.PRESS, key=CODED, keyCode=111 + number))

    def press(self, key: object, code: int = 0) -> bool:
        return self.explorer.handles(KeyEvent(KeyEvent.PRESS, key=key, keyCode=code))  # type: ignore[arg-type] # a character or CODED

    def mouse(self, action: int, x: int, y: int, button: int = LEFT, count: int = 0) -> bool:
        event = MouseEvent(action, x=x, y=y, button=button, count=count)
        return self.explorer.handles(event)

    def shown(self) -> U8:
        """Return what stands in the window, (h, w, 3)."""
        target = self.explorer.picture(self.loop.program.sketch.canvas.target)
        if self.explorer.has_overlay:
            size = target.width, target.height
            target = self.overlay.over(target, size, self.explorer.draw_over)
        return self.backend.read(target)[..., :3]

    def own(self) -> U8:
        """Return the sketch's own picture."""
        return self.loop.program.sketch.canvas.image_data()[..., :3]


@contextmanager
def stand(folder: Path, text: str, remarks: Remarks | None = None) -> Iterator[Stand]:
    told = (remarks if remarks is not None else Remarks()).tell
    backend = CpuBackend()
    renderer = Renderer(backend)
    explorer = SketchExplorer(told)
    with opened(Launch(written(folder, text), told), renderer, VirtualClock()) as loop:
        explorer.begin(loop, renderer)
        loop.begin()
        yield Stand(loop, explorer, backend)
        explorer.end()


def reds(picture: U8) -> int:
    """Return how many pixels are red."""
    return int((picture == (255, 0, 0)).all(axis=2).sum())


def test_without_a_key_the_picture_is_the_sketchs(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()

        assert not at.explorer.has_overlay
        np.testing.assert_array_equal(at.shown(), at.own())


def test_function_keys_are_swallowed_and_others_are_not(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        assert at.key(1)
        assert at.key(12)
        assert not at.press("a")
        assert not at.mouse(MouseEvent.PRESS, 10, 10)


def test_help_is_drawn_over_the_picture_alone(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        before = at.own()

        at.key(1)

        assert (at.shown() != before).any()
        np.testing.assert_array_equal(at.own(), before)


def test_pause_stands_still_and_a_step_is_granted_once(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.key(5)
        assert at.explorer.is_paused
        assert not at.explorer.takes_step()

        at.key(6)
        assert [at.explorer.takes_step(), at.explorer.takes_step()] == [True, False]

        at.key(5)
        assert not at.explorer.is_paused


def test_film_is_wanted_once_for_each_press(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.key(4)
        held = KeyEvent(KeyEvent.PRESS, key=CODED, keyCode=115, is_repeat=True)
        once = at.explorer.takes_film(), at.explorer.takes_film()

        assert at.explorer.handles(held)
        assert once == (True, False)
        assert not at.explorer.takes_film()


def test_slow_motion_goes_round(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        speeds = []
        for _ in range(4):
            at.key(7)
            speeds.append(at.explorer.speed)

        assert speeds == [0.5, 0.2, 0.05, 1.0]


def test_camera_turns_with_the_mouse_and_comes_back(tmp_path: Path) -> None:
    with stand(tmp_path, SOLID) as at:
        at.step()
        own = at.own()
        at.key(2)
        at.mouse(MouseEvent.PRESS, 100, 75)
        assert at.mouse(MouseEvent.DRAG, 160, 75)

        at.key(2)  # the mouse is the sketch's again, the camera stays
        turned = at.shown()
        assert reds(turned) > reds(own)  # two faces of the box show
        np.testing.assert_array_equal(at.own(), own)
        assert not at.mouse(MouseEvent.PRESS, 100, 75)

        at.key(3)
        np.testing.assert_array_equal(at.shown(), own)


def test_wheel_enlarges_what_is_at_the_pointer_in_2d(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        at.key(2)
        for _ in range(8):  # 1.1 ** 8 = 2.14
            at.mouse(MouseEvent.WHEEL, 50, 50, count=-1)

        at.key(2)
        at.explorer.draw_over  # noqa: B018 # nothing but the state's line is drawn over it
        picture = at.shown()

        assert (picture[52, 52] == (255, 0, 0)).all()  # the corner stays where it is
        assert (picture[90, 90] == (255, 0, 0)).all()  # 20 * 2.14 = 42.9 px
        assert (picture[97, 97] == (255, 255, 255)).all()


def test_wire_frame_draws_the_diagonal_of_a_rectangle(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()

        at.key(10)
        picture = at.shown()

        # From the top left corner to the bottom right one.
        assert all((picture[at_, at_] != (255, 0, 0)).any() for at_ in (55, 60, 65))
        assert (picture[55, 65] == (255, 0, 0)).all()


def test_gizmos_and_graph_leave_the_sketch_alone(tmp_path: Path) -> None:
    with stand(tmp_path, SOLID) as at:
        at.step(2)
        own = at.own()

        for number in (9, 11, 10, 10):
            at.key(number)
            assert (at.shown() != own).any()

        np.testing.assert_array_equal(at.own(), own)


def test_pointing_says_the_line_and_a_click_keeps_it(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        at.key(8)
        assert not at.mouse(MouseEvent.MOVE, 60, 60)  # the sketch may follow the pointer
        found = at.explorer._inspection((60, 60))
        assert found is not None
        assert found.answer is not None
        assert found.answer.line == 8

        assert at.mouse(MouseEvent.PRESS, 60, 60)
        at.mouse(MouseEvent.MOVE, 5, 5)
        kept = at.shown()
        assert (kept[100] < 200).any()  # the panel is long


def test_frames_are_noted_at_the_beginning_and_while_inspecting(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step(4)
        blind = at.explorer._inspection((60, 60))
        at.key(8)
        at.step()
        seeing = at.explorer._inspection((60, 60))

    assert blind is not None
    assert blind.answer is not None
    assert blind.answer.line == 0
    assert seeing is not None
    assert seeing.answer is not None
    assert seeing.answer.line == 8


def test_numbers_change_what_the_running_sketch_draws(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        before = reds(at.own())
        at.key(12)

        for _ in range(5):  # edge = 20 is the first number: 25
            assert at.press(CODED, RIGHT)
        at.step()

        assert reds(at.own()) - before == 25 * 25 - 20 * 20
        assert at.loop.frame_count == 2


def test_enter_writes_the_numbers_into_the_file(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        at.key(12)
        at.press(CODED, DOWN)  # background(255)
        at.press(CODED, LEFT)

        assert at.press(ENTER, ENTER)

    text = (tmp_path / "sketch.py").read_text(encoding="utf-8")
    assert text == FLAT.replace("background(255)", "background(250)")


def exchanged(at: Stand, text: str) -> None:
    """Give the running sketch another text, as `--keep-state` does."""
    path = at.loop.program.source.path
    path.write_text(text, encoding="utf-8")
    assert exchange(at.loop, [path])


def test_exchanged_text_is_followed(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step(5)
        at.key(8)
        at.step()
        at.key(12)
        at.shown()

        exchanged(at, "# one line more\nother = 1\n" + FLAT.replace("square", "ellipse"))
        old = at.explorer._inspection((52, 52))
        at.press(CODED, RIGHT)  # the first number is `other` now
        at.step()
        new = at.explorer._inspection((52, 52))
        other = at.loop.program.namespace["other"]

    assert old is not None
    assert old.answer is not None
    assert old.answer.title == "sketch.py, line 8: square(50, 50, edge)"
    assert new is not None
    assert new.answer is not None
    assert new.answer.line == 10
    assert other == 2


def test_exchanged_text_that_draws_nothing_is_told(tmp_path: Path) -> None:
    remarks = Remarks()
    with stand(tmp_path, FLAT, remarks) as at:
        at.step(9)
        exchanged(at, FLAT.replace("50, 50", "-90, 50").replace("150, 75", "950, 75"))
        at.step(3)

    assert [line for _, line, _ in remarks] == [8]


@pytest.mark.parametrize("loops", [True, False], ids=["draws on", "stands still"])
def test_picture_without_anything_is_told_once_and_shown(tmp_path: Path, loops: bool) -> None:
    text = "def setup():\n    size(200, 150)\ndef draw():\n    circle(-90, 0, 9)\n"
    remarks = Remarks()

    with stand(tmp_path, text if loops else text + "    noLoop()\n", remarks) as at:
        at.step(5)

        assert [(line, "left of the window" in said) for _, line, said in remarks] == [(4, True)]
        assert (at.shown() != at.own()).any()

        at.press("a")
        assert not at.explorer.has_overlay


def test_nothing_is_kept_of_frames_that_are_covered(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step(20)
        steps = len(at.explorer._log.steps)
        at.step(20)

        assert len(at.explorer._log.steps) == steps


def test_canvases_that_are_made_anew_each_frame_are_let_go(tmp_path: Path) -> None:
    text = """\
        def setup():
            size(50, 50)
        def draw():
            pg = createGraphics(20, 20)
            with pg:
                pg.circle(10, 10, 10)
            image(pg, frameCount, 0)
        """
    with stand(tmp_path, text) as at:
        at.step(200)

        assert len(at.explorer._log.histories) < 40


def test_explorer_lets_go_of_a_sketch(tmp_path: Path) -> None:
    with stand(tmp_path, FLAT) as at:
        at.step()
        renderer = at.explorer._renderer
        assert renderer is not None

        at.explorer.end()

        assert renderer.readers == []
        assert at.explorer.picture(at.loop.program.sketch.canvas.target).width == 200
