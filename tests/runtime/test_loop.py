from pathlib import Path

import pytest

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.core.constants import CODED, ESC, LEFT, UP
from sketchkit.runtime.events import WindowEvent
from sketchkit.runtime.report import StoppedError
from tests.runtime.sketches import begun, mistake, play, written

LOG = "log = []\n"


def test_order_of_a_sketchs_life(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        log = ["file"]
        def settings():
            log.append("settings")
        def setup():
            log.append(("setup", frameCount))
        def draw():
            log.append(("draw", frameCount))
        """,
    )

    assert play(sketch, 2)["log"] == ["file", "settings", ("setup", 0), ("draw", 1), ("draw", 2)]


def test_noLoop_in_setup_draws_once(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        frames = []
        def setup():
            noLoop()
        def draw():
            frames.append(frameCount)
        """,
    )

    assert play(sketch, 5)["frames"] == [1]


def test_redraw_draws_once_more(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        frames = []
        def setup():
            noLoop()
        def draw():
            frames.append(frameCount)
        def mousePressed():
            redraw()
        """,
    )
    with begun(sketch) as loop:
        loop.step()
        loop.post(MouseEvent(MouseEvent.PRESS, x=1, y=1, button=LEFT))
        for _ in range(4):
            loop.step()

        assert loop.program.namespace["frames"] == [1, 2]


def test_redraw_within_draw_is_too_late(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        frames = []
        def draw():
            noLoop()
            redraw()
            frames.append(frameCount)
        """,
    )

    assert play(sketch, 4)["frames"] == [1]


def test_loop_takes_noLoop_back(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            noLoop()
        def draw():
            loop()
        """,
    )
    with begun(sketch) as loop:
        for _ in range(4):
            loop.step()

        assert loop.frame_count == 4


@pytest.mark.parametrize("call", ["exit()", "import sys; sys.exit()"])
def test_exit_ends_the_sketch_with_this_frame(tmp_path: Path, call: str) -> None:
    sketch = written(
        tmp_path,
        f"""
        def draw():
            if frameCount == 2:
                {call}
        """,
    )
    with begun(sketch) as loop:
        for _ in range(4):
            loop.step()

        assert loop.is_finished
        assert loop.frame_count == 2


def test_sketch_without_functions_draws_while_it_is_read(tmp_path: Path) -> None:
    with begun(written(tmp_path, "size(30, 20)\nbackground(0)\nw = width")) as loop:
        assert loop.program.namespace["w"] == 30
        assert not loop.is_drawing
        assert loop.step() is False


def test_camera_of_setup_stays_and_the_matrix_does_not(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        seen = []
        def setup():
            size(100, 100, P3D)
            camera(0, 0, 50, 0, 0, 0, 0, 1, 0)
            seen.append(round(screenX(0, 0, 0)))
        def draw():
            seen.append(round(screenX(0, 0, 0)))
            translate(10, 0)
        """,
    )

    assert play(sketch, 2)["seen"] == [50, 50, 50]


def test_time_of_a_render_is_that_of_its_frames(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        seen = []
        def draw():
            seen.append(frameRate)
            delay(10000)
        """,
    )

    assert play(sketch, 2)["seen"] == [60.0, 60.0]


HANDLERS = """
log = []
def draw():
    log.append(("draw", mouseX, pmouseX, mousePressed))
def mousePressed(event):
    log.append(("pressed", mouseX, event.getX(), mouseButton == LEFT, bool(mousePressed)))
def mouseDragged():
    log.append(("dragged", pmouseX, mouseX))
def mouseReleased():
    log.append(("released", bool(mousePressed)))
def mouseClicked(event):
    log.append(("clicked", event.getCount()))
def mouseWheel(event):
    log.append(("wheel", event.getCount()))
"""


def test_mouse_events_come_after_draw_in_their_order(tmp_path: Path) -> None:
    with begun(written(tmp_path, HANDLERS)) as loop:
        loop.post(MouseEvent(MouseEvent.PRESS, x=10, y=5, button=LEFT, count=1))
        loop.post(MouseEvent(MouseEvent.DRAG, x=14, y=5, button=LEFT))
        loop.post(MouseEvent(MouseEvent.RELEASE, x=14, y=5, button=LEFT))
        loop.post(MouseEvent(MouseEvent.CLICK, x=14, y=5, button=LEFT, count=1))
        loop.post(MouseEvent(MouseEvent.WHEEL, count=-2))
        loop.step()
        loop.step()

        assert loop.program.namespace["log"] == [
            ("draw", 0, 0, False),
            ("pressed", 10, 10, True, True),
            ("dragged", 10, 14),
            ("released", False),
            ("clicked", 1),
            ("wheel", -2),
            ("draw", 14, 10, False),
        ]


def test_keys_are_values_and_call_handlers(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        log = []
        def draw():
            log.append(bool(keyPressed))
        def keyPressed():
            log.append((key, keyCode, key == CODED and keyCode == UP))
        def keyTyped():
            log.append("typed " + key)
        """,
    )
    with begun(sketch) as loop:
        loop.post(KeyEvent(KeyEvent.PRESS, key="a", keyCode=65))
        loop.post(KeyEvent(KeyEvent.TYPE, key="a"))
        loop.post(KeyEvent(KeyEvent.PRESS, key=CODED, keyCode=UP))
        loop.post(KeyEvent(KeyEvent.RELEASE, key="a", keyCode=65))
        loop.step()
        loop.step()
        loop.post(KeyEvent(KeyEvent.RELEASE, key=CODED, keyCode=UP))
        loop.step()
        loop.step()

        assert loop.program.namespace["log"] == [
            False,
            ("a", 65, False),
            "typed a",
            (CODED, UP, True),
            True,
            True,
            False,
        ]


def test_escape_ends_the_sketch(tmp_path: Path) -> None:
    with begun(written(tmp_path, "def draw():\n    pass\n")) as loop:
        loop.post(KeyEvent(KeyEvent.PRESS, key=ESC, keyCode=27))
        loop.step()

        assert loop.is_finished


def test_window_of_another_size_is_followed(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def windowResized():
            global seen
            seen = width, height
        """,
    )
    with begun(sketch) as loop:
        loop.post(WindowEvent("windowResized", (70, 80)))
        loop.step()

        assert loop.program.namespace["seen"] == (70, 80)


def test_last_calls(tmp_path: Path) -> None:
    with begun(written(tmp_path, "log = []\ndef stop():\n    log.append('stop')\n")) as loop:
        loop.end()

        assert loop.program.namespace["log"] == ["stop"]


def test_mistake_in_a_handler_is_told_with_its_line(tmp_path: Path) -> None:
    sketch = written(tmp_path, "def mousePressed():\n    elipse(1, 2, 3, 4)\n")

    def click() -> None:
        with begun(sketch) as loop:
            loop.post(MouseEvent(MouseEvent.PRESS))
            loop.step()

    with pytest.raises(StoppedError, match=r"line 2: elipse"):
        click()


def test_size_in_draw_is_refused(tmp_path: Path) -> None:
    text = mistake(written(tmp_path, "def draw():\n    size(100, 100)\n"))

    assert "line 2: size() belongs at the beginning of setup()" in text


def test_delay_puts_the_time_of_a_render_forward(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        seen = []
        def setup():
            delay(250)
        def draw():
            delay(1000)
            seen.append(millis())
        """,
    )

    assert play(sketch, 2)["seen"] == [1250, 2250]


def test_thread_of_a_render_goes_on_when_its_delay_is_over(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        seen = []
        def tick():
            while True:
                seen.append(millis())
                delay(400)
        def setup():
            thread("tick")
        def draw():
            delay(200)
        """,
    )

    # Each of the six frames begins 200 ms later than the one before it, the first at 0.
    assert play(sketch, 6)["seen"] == [0, 400, 800]


def test_mistake_in_a_thread_stops_the_sketch_in_that_frame(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def work():
            delay(10)
            nothing()
        def setup():
            thread("work")
        def draw():
            delay(10)
        """,
    )

    assert "line 4: nothing is not defined" in mistake(sketch, 2)


@pytest.mark.parametrize(("seed", "is_anew"), [("pass", True), ("randomSeed(5)", False)])
def test_random_numbers_of_a_render_begin_anew_in_setup(
    tmp_path: Path, seed: str, is_anew: bool
) -> None:
    sketch = written(
        tmp_path,
        f"""
        {seed}
        seen = [random(1)]
        def setup():
            seen.append(random(1))
        def draw():
            seen.append(random(1))
        """,
    )

    at_top, in_setup, in_draw = play(sketch, 1)["seen"]
    assert (at_top == in_setup) is is_anew
    assert in_draw != in_setup


def test_noise_of_a_render_begins_anew_in_setup_unless_seeded(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        noiseSeed(3)
        seen = [noise(0.4)]
        def setup():
            seen.append(noise(0.4))
        """,
    )

    seen = play(sketch)["seen"]
    assert seen[0] == seen[1]


def test_function_of_a_dialog_is_called_after_draw_with_live_values(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        log = []
        def draw():
            log.append("draw")
        def chosen():
            log.append(("chosen", frameCount))
        """,
    )
    with begun(sketch) as loop:
        loop.program.sketch.progress.due_calls.append(lambda: loop.program.namespace["chosen"]())
        loop.step()

        assert loop.program.namespace["log"] == ["draw", ("chosen", 1)]


def test_a_function_called_stop_that_takes_something_is_the_sketchs_own(tmp_path: Path) -> None:
    sketch = written(tmp_path, "def stop(player):\n    1 / 0\n")

    with begun(sketch) as loop:
        loop.end()
