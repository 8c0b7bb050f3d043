"""The explorer in a real window: its keys are pressed by xdotool, and the screen is looked at."""

from __future__ import annotations

from pathlib import Path

from PIL import Image, ImageChops

from tests.runtime.sketches import written
from tests.runtime.windows import needs_a_display, shown

pytestmark = needs_a_display

WINDOW = (0, 0, 400, 300)
COUNTING = """
    def setup():
        size(400, 300, P2D)
        windowMove(0, 0)
        frameRate(30)
    def draw():
        background(frameCount % 250, 0, 0)
    def mousePressed():
        print("pressed", flush=True)
"""
BOX = """
    def setup():
        size(400, 300, P3D)
        windowMove(0, 0)
        frameRate(30)
    def draw():
        background(255)
        noStroke()
        fill(200, 0, 0)
        translate(200, 150, 0)
        box(80)
"""
RED, WHITE = (200, 0, 0), (255, 255, 255)


def are_bright(screen: Image.Image, left: int, top: int) -> bool:
    """Return whether there are letters in a part of the window."""
    part = screen.crop((left, top, left + 300, top + 24)).convert("L")
    return part.getextrema()[1] > 200


def is_paused(screen: Image.Image) -> bool:
    return are_bright(screen, 0, 270)


def test_pause_stands_still_steps_one_frame_and_shows_help(tmp_path: Path, display: str) -> None:
    with shown(written(tmp_path, COUNTING), display) as running:
        running.shows(lambda screen: screen.getpixel((390, 10))[0] > 5)
        running.xdotool("key", "F5")
        paused = running.shows(is_paused).getpixel((390, 10))[0]
        for step in range(1, 4):
            running.xdotool("key", "F6")
            running.shows(lambda screen, own=paused + step: screen.getpixel((390, 10))[0] == own)
        running.xdotool("key", "F1")
        helped = running.shows(lambda screen: are_bright(screen, 8, 8))
        running.xdotool("key", "F1", "key", "F5")
        running.shows(lambda screen: not is_paused(screen) and not are_bright(screen, 8, 8))

    assert helped.getpixel((390, 290))[0] == paused + 3


def test_orbit_shows_another_side_and_f3_brings_the_picture_back(
    tmp_path: Path, display: str
) -> None:
    with shown(written(tmp_path, BOX), display) as running:
        first = running.shows(lambda screen: screen.getpixel((200, 150)) == RED)
        running.xdotool("key", "F2", "mousemove", "150", "150", "mousedown", "1")
        running.xdotool("mousemove", "190", "150", "mouseup", "1")
        # Turned by 40 hundredths of a radian, the box is wider: it reaches beyond 47 px.
        running.shows(lambda screen: screen.getpixel((200 + 51, 150)) == RED)
        running.xdotool("key", "F3")
        last = running.shows(lambda screen: screen.getpixel((200 + 51, 150)) == WHITE)

    assert ImageChops.difference(first.crop(WINDOW), last.crop(WINDOW)).getbbox() is None


def test_film_and_pixel_are_had_without_the_sketch_hearing_of_it(
    tmp_path: Path, display: str
) -> None:
    with shown(written(tmp_path, COUNTING), display) as running:
        running.shows(lambda screen: screen.getpixel((390, 10))[0] > 0)
        running.xdotool("key", "F4")
        film = running.says("Filming movie-0001").split()[1].rstrip(".")
        running.xdotool("key", "F8", "mousemove", "200", "250", "click", "1")
        running.shows(lambda screen: are_bright(screen, 8, 8))
        running.xdotool("key", "F8")
        running.shows(lambda screen: not are_bright(screen, 8, 8))
        running.xdotool("key", "F4")
        told = running.says(film)
        running.xdotool("click", "1")
        running.says("pressed")
        running.xdotool("key", "Escape")
        rest = list(running.process.stdout or ())

        assert running.ends() == 0
    assert told.endswith("seconds.")
    assert (tmp_path / film).stat().st_size > 100
    assert rest == []
