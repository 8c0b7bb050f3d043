"""A real window, on a display of its own: keys and mouse are pressed by xdotool.

Nothing here waits for a time: the sketch says on its output what it has seen.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from PIL import Image, ImageGrab

from sketchkit.backends.listing import ListingBackend
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.replay import read_replay
from tests.runtime.sketches import Remarks, written

ROOT = Path(__file__).parents[2]
TOOLS = ("Xvfb", "xdotool")

pytestmark = [
    pytest.mark.skipif(
        not all(map(shutil.which, TOOLS)), reason=f"{' and '.join(TOOLS)} are not installed"
    ),
    pytest.mark.timeout(60),
]


@pytest.fixture(scope="module")
def display() -> Iterator[str]:
    """Start an X server; the number of its display is the server's choice."""
    read, write = os.pipe()
    command = [
        "Xvfb",
        "-displayfd",
        str(write),
        "-screen",
        "0",
        "800x600x24",
        "-nolisten",
        "tcp",
        "-noreset",
    ]
    with subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL) as server:
        os.close(write)
        with os.fdopen(read) as answer:
            yield f":{answer.readline().strip()}"
        server.terminate()


class Running:
    """A sketch in its window."""

    def __init__(self, process: subprocess.Popen[str], environment: dict[str, str]) -> None:
        self.process = process
        self._environment = environment

    def says(self, words: str) -> str:
        """Read the sketch's output up to a line with these words in it, and return that."""
        assert self.process.stdout
        for line in self.process.stdout:
            if words in line:
                return line.strip()
        raise AssertionError(f"the sketch ended without saying {words!r}")

    def xdotool(self, *args: str) -> None:
        subprocess.run(["xdotool", *args], env=self._environment, check=True, timeout=30)

    def shows(self, is_so: Callable[[Image.Image], bool]) -> Image.Image:
        """Look at the screen until it is so, and return it."""
        while self.process.poll() is None:
            with suppress(OSError):  # the server has no time yet
                screen = ImageGrab.grab(xdisplay=self._environment["DISPLAY"])
                if is_so(screen):
                    return screen
        raise AssertionError("the sketch has ended")

    def ends(self) -> int:
        return self.process.wait(timeout=30)


@contextmanager
def shown(sketch: Path, display: str, *options: str) -> Iterator[Running]:
    environment = {**os.environ, "DISPLAY": display, "PYTHONPATH": str(ROOT)}
    environment.pop("WAYLAND_DISPLAY", None)
    with subprocess.Popen(
        [sys.executable, "-u", "-m", "sketchkit", "run", *options, str(sketch)],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        running = Running(process, environment)
        try:
            yield running
        finally:
            process.kill()


def test_key_is_heard_and_escape_closes(tmp_path: Path, display: str) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(200, 150, P3D)
        def draw():
            background(255, 200, 0)
            box(40)
            if frameCount == 3:
                print("ready", focused)
        def keyPressed():
            saveStrings("heard.txt", [key, keyCode])
            print("heard", key)
        """,
    )
    with shown(sketch, display) as running:
        assert running.says("ready") == "ready True"
        running.xdotool("key", "k")
        running.says("heard k")
        running.xdotool("key", "Escape")

        assert running.ends() == 0
    assert (tmp_path / "heard.txt").read_text().split()[1] == "27"


def test_pointer_is_where_it_was_moved(tmp_path: Path, display: str) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(200, 150)
            windowMove(0, 0)
        def draw():
            if frameCount == 3:
                print("ready")
        def mouseClicked():
            print("clicked", mouseX, mouseY, mouseButton == RIGHT)
            exit()
        """,
    )
    with shown(sketch, display) as running:
        running.says("ready")
        running.xdotool("mousemove", "60", "70", "click", "3")

        assert running.says("clicked") == "clicked 60 70 True"
        assert running.ends() == 0


def test_window_shows_what_was_drawn(tmp_path: Path, display: str) -> None:
    sketch = written(
        tmp_path,
        """
        from PIL import ImageGrab
        def setup():
            size(200, 150)
            windowMove(0, 0)
        def draw():
            background(0, 0, 255)
            noStroke()
            fill(255, 0, 0)
            rect(0, 0, 100, 75)
            if frameCount == 9:  # frame 8 is on the screen
                screen = ImageGrab.grab(xdisplay=None)
                print("seen", *(screen.getpixel(at)[:3] for at in ((50, 30), (150, 30), (50, 120))))
                exit()
        """,
    )
    with shown(sketch, display) as running:
        assert running.says("seen") == "seen (255, 0, 0) (0, 0, 255) (0, 0, 255)"


def test_mistake_leaves_the_window_open(tmp_path: Path, display: str) -> None:
    sketch = written(
        tmp_path,
        "def draw():\n    print('frame')\n    if frameCount == 3:\n        elipse(1, 2, 3, 4)\n",
    )
    with shown(sketch, display) as running:
        assert running.says("elipse") == "sketch.py, line 4: elipse is not defined."
        running.xdotool("search", "--sync", "--name", "a mistake in sketch.py, line 4")
        running.xdotool("key", "Escape")

        assert running.ends() == 1


def test_drag_is_no_click_and_buttons_wheel_and_keys_come_in_order(
    tmp_path: Path, display: str
) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(200, 150, P2D)
            windowMove(0, 0)
        def draw():
            if frameCount == 3:
                print("ready")
        def mousePressed():
            print("pressed", mouseX, mouseY)
        def mouseDragged():
            print("dragged", pmouseX, mouseX)
        def mouseReleased():
            print("released", mouseX)
        def mouseClicked(event):
            print("clicked", event.getCount())
        def mouseWheel(event):
            print("wheel", event.getCount(), event.isShiftDown())
        def keyPressed():
            print("key", key if key != CODED else keyCode)
        def keyTyped():
            if key == "q":
                exit()
        """,
    )
    with shown(sketch, display) as running:
        running.says("ready")
        running.xdotool("mousemove", "50", "40", "mousedown", "1", "mousemove", "70", "40")
        running.says("dragged")
        running.xdotool("mouseup", "1", "click", "1", "keydown", "shift", "click", "5")
        running.xdotool("keyup", "shift", "key", "Left", "key", "q")
        told = [line.strip() for line in running.process.stdout or ()]

        assert running.ends() == 0
    assert told == [
        *("released 70", "pressed 70 40", "released 70", "clicked 1"),
        *("key 16", "wheel 1 True", "key 37", "key q"),
    ]


CYAN, DIMMED_MOST = (0, 200, 200), 100


def test_broken_text_lies_over_the_picture_until_it_is_mended(tmp_path: Path, display: str) -> None:
    text = """
        def setup():
            size(500, 300)
            windowMove(0, 0)
        def draw():
            background(0, 200, 200)
    """
    sketch = written(tmp_path, text)
    with shown(sketch, display) as running:
        running.shows(lambda screen: screen.getpixel((250, 280)) == CYAN)

        written(tmp_path, text + "    if\n")
        broken = running.shows(lambda screen: screen.getpixel((250, 280)) != CYAN)
        written(tmp_path, text)
        running.shows(lambda screen: screen.getpixel((250, 280)) == CYAN)
        running.xdotool("key", "Escape")

        assert running.ends() == 0
    red, green, _ = broken.getpixel((250, 280))
    assert red < green < DIMMED_MOST  # the picture is still there
    assert broken.crop((0, 0, 500, 150)).convert("L").getextrema()[1] > 200  # and letters


def test_recorded_events_are_those_that_render_replays(tmp_path: Path, display: str) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(200, 150)
            windowMove(0, 0)
        def draw():
            if frameCount == 3:
                print("ready", flush=True)
        def mouseClicked():
            saveStrings("seen.txt", [mouseX, mouseY, frameCount, millis(), random(1)])
            exit()
        """,
    )
    events = tmp_path / "events.json"
    with shown(sketch, display, "--record-input", str(events)) as running:
        running.says("ready")
        running.xdotool("mousemove", "60", "70", "click", "1")
        assert running.ends() == 0
    seen = (tmp_path / "seen.txt").read_text()
    (tmp_path / "seen.txt").unlink()

    replay = read_replay(events)
    last = max(replay.events)
    list(render(Launch(sketch, Remarks().tell, replay=replay), [last], ListingBackend()))

    assert seen.startswith("60\n70\n")
    assert (tmp_path / "seen.txt").read_text() == seen
