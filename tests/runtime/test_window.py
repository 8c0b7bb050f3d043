"""A real window, on a display of its own: keys and mouse are pressed by xdotool."""

from __future__ import annotations

from pathlib import Path

from sketchkit.backends.listing import ListingBackend
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.replay import read_replay
from tests.runtime.sketches import Remarks, written
from tests.runtime.windows import needs_a_display, shown

pytestmark = needs_a_display


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


CYAN, BLUE, DIMMED_MOST = (0, 200, 200), (0, 0, 200), 100
ONE_FRAME = "        get(1, 1)\n            elipse(1)\n"  # in red, half drawn


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
        written(tmp_path, text.replace("0, 200, 200", "200, 0, 0") + ONE_FRAME)
        stopped = running.shows(lambda screen: screen.getpixel((250, 280)) != CYAN)
        written(tmp_path, text.replace("0, 200, 200", "0, 0, 200"))
        running.shows(lambda screen: screen.getpixel((250, 280)) == BLUE)
        running.xdotool("key", "Escape")

        assert running.ends() == 0
    for picture in (broken, stopped):
        red, green, _ = picture.getpixel((250, 280))
        assert red < green < DIMMED_MOST  # the last good picture is still there
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
