"""The player, with a window and a clock made of plain Python."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from sketchkit.api.events import KeyEvent
from sketchkit.api.host import NoWindow
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.listing import ListingBackend
from sketchkit.core.constants import ESC
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import Target
from sketchkit.draw.shading import ShaderSource
from sketchkit.runtime import filming
from sketchkit.runtime.events import AnyEvent
from sketchkit.runtime.explorer import Explorer, NoExplorer
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.inputs import Recorded, Replayed
from sketchkit.runtime.mouse import Mouse
from sketchkit.runtime.player import PLAIN, Manner, Player
from sketchkit.runtime.replay import replay_of
from sketchkit.runtime.report import Report
from tests.assets.movies.films import pictures
from tests.runtime.sketches import Remarks, written

NO_EXPLORER = NoExplorer()
MOMENT_S = 0.001  # how long everything takes


class FakeScreen(NoWindow):
    """A window whose time passes only while it is waited for.

    `plan` says what happens when: at a time, an action.
    """

    def __init__(self, closes_s: float) -> None:
        self.backend = ListingBackend()
        self.time_s = 0.0
        self.closes_s = closes_s
        self.plan: dict[float, Callable[[], Sequence[AnyEvent]]] = {}
        self.shown: list[tuple[float, int]] = []
        self.titles: list[str] = []

    def now(self) -> float:
        return self.time_s

    @property
    def is_closed(self) -> bool:
        return self.time_s >= self.closes_s

    def wait(self, timeout_s: float) -> Sequence[AnyEvent]:
        self.time_s += max(timeout_s, MOMENT_S)
        due = [time_s for time_s in self.plan if time_s <= self.time_s]
        return [event for time_s in due for event in self.plan.pop(time_s)()]

    def pace(self, frames_per_second: float) -> None:
        pass

    is_damaged = False

    def show(self, target: Target) -> None:
        self.shown.append((self.time_s, target.width))

    def set_title(self, title: str) -> None:
        self.titles.append(title)


def play(
    path: Path,
    screen: FakeScreen,
    explorer: Explorer = NO_EXPLORER,
    manner: Manner = PLAIN,
) -> tuple[bool, list[Report]]:
    told: list[Report] = []
    player = Player(path, screen, manner, tell=Remarks().tell, say=told.append, explorer=explorer)
    return player.play(), told


def saved(path: Path, text: str) -> Callable[[], Sequence[AnyEvent]]:
    """Return what saves a file as an editor does."""

    def save() -> Sequence[AnyEvent]:
        written(path.parent, text, path.name)
        return []

    return save


@pytest.mark.parametrize(("setup", "frames"), [("", 60), ("frameRate(10)", 10)])
def test_frames_come_at_their_rate(tmp_path: Path, setup: str, frames: int) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(
        tmp_path, f"def setup():\n    size(20, 20)\n    {setup}\ndef draw():\n    background(0)\n"
    )

    is_well, _ = play(sketch, screen)

    assert is_well
    assert len(screen.shown) - 1 == pytest.approx(frames, abs=2)  # first and last moment


def test_frameRate_is_measured(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            frameRate(20)
        def draw():
            if frameCount == 100:
                saveStrings("rate.txt", [round(frameRate)])
        """,
    )

    play(sketch, FakeScreen(closes_s=6.0))

    assert (tmp_path / "rate.txt").read_text() == "20\n"


class Director(NoExplorer):
    """Begins and ends films at times."""

    def __init__(self, screen: FakeScreen, *times_s: float) -> None:
        self.screen, self.times_s = screen, list(times_s)

    def takes_film(self) -> bool:
        is_due = bool(self.times_s) and self.screen.time_s >= self.times_s[0]
        return is_due and bool(self.times_s.pop(0))


def test_film_shows_each_frame_as_long_as_the_window_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(filming.importlib.util, "find_spec", lambda name: None)
    text = """
    def setup(): frameRate(10)
    def draw(): background(frameCount)
    """
    screen, notes = FakeScreen(closes_s=2.0), []
    screen.backend = CpuBackend()
    director = Director(screen, 0.5, 1.5)

    path = written(tmp_path, text)
    tell = Remarks().tell
    Player(path, screen, tell=tell, say=print, note=notes.append, explorer=director).play()

    shown = [
        (int(pixels[0, 0, 0]), lasts) for pixels, lasts in pictures(tmp_path / "movie-0001.gif")
    ]
    assert sum(lasts for _, lasts in shown) == pytest.approx(1000, abs=110)
    assert [value for value, _ in shown] == list(range(shown[0][0], shown[0][0] + len(shown)))
    assert notes[0] == "Filming movie-0001.gif. The same key ends it."


def test_film_is_whole_when_the_window_is_closed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(filming.importlib.util, "find_spec", lambda name: None)
    screen = FakeScreen(closes_s=1.0)
    screen.backend = CpuBackend()
    director, tell = Director(screen, 0.5), Remarks().tell

    path = written(tmp_path, "def draw(): background(frameCount)")
    Player(path, screen, tell=tell, say=print, note=str, explorer=director).play()

    assert len(pictures(tmp_path / "movie-0001.gif")) > 10


def test_exit_closes_the_window(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=9.0)

    is_well, _ = play(written(tmp_path, "def draw():\n    exit()\n"), screen)

    assert is_well
    assert screen.time_s < 1


def test_mistake_is_shown_and_the_window_stays_with_its_picture(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=3.0)
    text = "size(20, 20)\ndef draw():\n    if frameCount == 3:\n        elipse(1)\n"

    is_well, told = play(written(tmp_path, text), screen)

    assert not is_well
    assert [report.line for report in told] == [4]
    assert screen.titles[-1] == "sketch: a mistake in sketch.py, line 4"
    assert screen.shown[-1][1] == 480  # a sentence has no room in 20 pixels


def test_escape_closes_the_window_after_a_mistake(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=9.0)
    screen.plan[0.5] = lambda: [KeyEvent(KeyEvent.PRESS, key=ESC)]

    is_well, _ = play(written(tmp_path, "elipse(1)"), screen)

    assert not is_well
    assert screen.time_s < 1


def test_saved_sketch_starts_again(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(tmp_path, "size(20, 20)")
    screen.plan[0.5] = saved(sketch, "size(300, 20)")

    play(sketch, screen)

    assert [width for _, width in (screen.shown[0], screen.shown[-1])] == [20, 300]


def test_relative_path_is_followed_from_the_sketchs_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(tmp_path, "size(20, 20)", "folder/sketch.py")
    screen.plan[0.5] = saved(sketch, "size(300, 20)")
    monkeypatch.chdir(tmp_path)

    play(Path("folder/sketch.py"), screen)

    assert screen.shown[-1][1] == 300


def test_saved_module_starts_the_sketch_again(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    helper = written(tmp_path, "side = 20", "helpers.py")
    screen.plan[0.5] = saved(helper, "side = 300")

    play(written(tmp_path, "import helpers\nsize(helpers.side, 20)"), screen)

    assert [width for _, width in (screen.shown[0], screen.shown[-1])] == [20, 300]


def test_old_version_goes_on_while_the_new_one_is_no_python(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(tmp_path, "def draw():\n    if frameCount == 45: saveStrings('a', [1])\n")
    screen.plan[0.2] = saved(sketch, "def draw(\n")

    is_well, told = play(sketch, screen)

    assert is_well
    assert [report.line for report in told] == [1]
    assert (tmp_path / "a").exists()


def test_sketch_that_could_not_be_read_starts_when_it_is_mended(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(tmp_path, "size(20, 20")
    screen.plan[0.5] = saved(sketch, "size(200, 20)")

    is_well, told = play(sketch, screen)

    assert is_well
    assert len(told) == 1
    assert screen.shown[-1][1] == 200


def test_saved_data_starts_the_sketch_again(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    data = written(tmp_path, "20", "data/side.txt")
    screen.plan[0.5] = saved(data, "300")

    play(written(tmp_path, "size(int(loadStrings('side.txt')[0]), 20)"), screen)

    assert [width for _, width in (screen.shown[0], screen.shown[-1])] == [20, 300]


def test_what_the_sketch_itself_writes_does_not_start_it_again(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    written(tmp_path, "1", "score.txt")
    sketch = written(
        tmp_path,
        """
        loadStrings("score.txt")
        def draw():
            saveStrings("score.txt", [frameCount])
            surface.setTitle(frameCount)
        """,
    )

    play(sketch, screen)

    assert int(screen.titles[-1]) > 50


def test_saved_file_is_let_be_without_reloading(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    sketch = written(tmp_path, "size(20, 20)")
    screen.plan[0.5] = saved(sketch, "size(300, 20)")

    play(sketch, screen, manner=Manner(reloads=False))

    assert screen.shown[-1][1] == 20


GOING_ON = """
import helpers
count = 0
class Ball:
    def tell(self): return "old ball"
def setup():
    global ball
    size(20, 20)
    ball = Ball()
def draw():
    global count
    count += 1
    surface.setTitle(f"{count} {frameCount} {ball.tell()} old {helpers.name()}")
"""


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    written(tmp_path, "def name(): return 'here'", "helpers.py")
    return written(tmp_path, GOING_ON)


KEEPING = Manner(keeps_state=True)


def test_variables_survive_a_new_text_of_the_functions(kept: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.plan[0.5] = saved(kept, GOING_ON.replace("old", "new"))

    play(kept, screen, manner=KEEPING)

    count, frame, *words = screen.titles[-1].split()
    assert words == ["new", "ball", "new", "here"]
    assert count == frame
    assert int(count) > 50


def test_variables_survive_a_new_text_of_a_module(kept: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.plan[0.5] = saved(kept.with_name("helpers.py"), "def name(): return 'there'")

    play(kept, screen, manner=KEEPING)

    assert screen.titles[-1].endswith("there")
    assert int(screen.titles[-1].split()[0]) > 50


def test_old_text_goes_on_if_the_new_ones_own_lines_are_wrong(kept: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.plan[0.3] = saved(kept, GOING_ON.replace("old", "new") + "elipse()\n")

    is_well, told = play(kept, screen, manner=KEEPING)

    assert is_well
    assert [str(report).splitlines()[0] for report in told] == [
        "sketch.py, line 14: elipse is not defined."
    ]
    assert screen.titles[-1].endswith("old ball old here")
    assert int(screen.titles[-1].split()[0]) > 50


def test_new_setup_is_run_though_state_is_kept(kept: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.plan[0.5] = saved(kept, GOING_ON.replace("size(20, 20)", "size(300, 20)"))

    play(kept, screen, manner=KEEPING)

    assert screen.shown[-1][1] == 300


def test_mistake_is_cleared_by_the_next_good_text(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    text = "def setup():\n    size(20, 20)\ndef draw():\n    background(0)\n"
    sketch = written(tmp_path, text)
    screen.plan[0.2] = saved(sketch, text + "if\n")
    screen.plan[0.6] = saved(sketch, text)

    is_well, told = play(sketch, screen)

    assert is_well
    assert len(told) == 1
    assert {width for time_s, width in screen.shown if 0.3 < time_s < 0.6} == {480}
    assert screen.shown[-1][1] == 20
    assert screen.titles[-1] == "sketch"


class SeeingScreen(FakeScreen):
    """A window whose pictures can be looked at: what is in the middle of the left and right half.

    `seen` says it of each picture: when, the two colours, and the window's size.
    """

    def __init__(self, closes_s: float) -> None:
        super().__init__(closes_s)
        self.backend: CpuBackend = CpuBackend()  # type: ignore[assignment] # it draws
        self.seen: list[tuple[float, tuple[int, ...], tuple[int, ...], tuple[int, int]]] = []
        self.size = (0, 0)

    def set_size(self, width: int, height: int) -> None:
        self.size = width, height

    def show(self, target: Target) -> None:
        super().show(target)
        pixels = self.backend.read(target)
        height, width, _ = pixels.shape
        left, right = pixels[height - 5, width // 4, :3], pixels[height - 5, 3 * width // 4, :3]
        seen = (tuple(side.tolist()) for side in (left, right))
        self.seen.append((self.time_s, *seen, self.size))


BLUE, RED = (0, 0, 250), (250, 0, 0)
GOOD = """
def setup():
    size(480, 200)
def draw():
    background(0, 0, 250)
"""
HALF_DRAWN = """
def setup():
    size(480, 200)
    background(250, 0, 0)
def draw():
    background(250, 0, 0)
    get(1, 1)
    elipse(1)
"""


def dimmed(color: tuple[int, ...]) -> tuple[int, ...]:
    """Return what a colour becomes under the panel: 0xB0 of 255 of 16, 20, 24."""
    return tuple(
        pytest.approx(own + (dark - own) * 0xB0 / 255, abs=2)
        for own, dark in zip(color, (16, 20, 24), strict=True)
    )


def test_mistake_in_the_first_frame_lies_over_the_old_texts_picture(tmp_path: Path) -> None:
    screen = SeeingScreen(closes_s=1.0)
    sketch = written(tmp_path, GOOD)
    screen.plan[0.3] = saved(sketch, HALF_DRAWN)
    screen.plan[0.6] = saved(sketch, GOOD.replace("0, 0, 250", "250, 0, 0"))

    play(sketch, screen)

    assert screen.seen[-1][1] == RED
    others = [left for time_s, left, *_ in screen.seen if time_s > 0.3 and left not in (BLUE, RED)]
    assert others
    assert all(left == dimmed(BLUE) for left in others)


def test_mistake_in_a_later_frame_lies_over_the_frame_before(tmp_path: Path) -> None:
    text = """
    def setup():
        size(480, 200, P3D)
    def draw():
        background(0, 0, 250) if frameCount < 5 else background(250, 0, 0)
        if frameCount == 5:
            loadPixels()
            elipse(1)
    """
    screen = SeeingScreen(closes_s=0.5)

    play(written(tmp_path, text), screen)

    assert screen.seen[-1][1] == dimmed(BLUE)


@pytest.mark.parametrize("reads", ["", "get(1, 1)"])
def test_picture_that_a_broken_frame_has_turned_over_is_shown_right(
    tmp_path: Path, reads: str
) -> None:
    text = f"""
    def setup():
        size(480, 200, P2D)
        noStroke()
    def draw():
        if frameCount == 1:
            background(250, 0, 0)
            fill(0, 0, 250)
            rect(0, 100, 480, 100)
        if frameCount == 3:  # the second one without a background
            {reads}
            elipse(1)
    """
    screen = SeeingScreen(closes_s=0.5)

    play(written(tmp_path, text), screen)

    assert screen.seen[-1][1] == dimmed(BLUE)


def test_window_gets_the_size_of_the_picture_that_a_mistake_lies_over(tmp_path: Path) -> None:
    screen = SeeingScreen(closes_s=1.0)
    sketch = written(tmp_path, GOOD)
    smaller = HALF_DRAWN.replace("480, 200", "600, 50")
    screen.plan[0.3] = saved(sketch, smaller)
    screen.plan[0.6] = saved(sketch, smaller.replace("elipse(1)", "pass"))

    play(sketch, screen)

    sizes = [size for time_s, *_, size in screen.seen if time_s < 0.6]
    assert sizes[-1] == (480, 200)
    assert screen.seen[-1][-1] == (600, 50)


def test_title_that_a_mended_sketch_sets_stays(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    good = "def setup():\n    surface.setTitle('mine')\ndef draw():\n    background(0)\n"
    sketch = written(tmp_path, good + "    elipse(1)\n")
    screen.plan[0.3] = saved(sketch, good)

    play(sketch, screen)

    assert screen.titles[-1] == "mine"


RANDOM = """
def setup():
    size(20, 20)
def draw():
    pass
def mousePressed():
    saveStrings("seen.txt", [f"{random(1)} {millis()} {frameCount}"])
"""


def test_recorded_hand_is_replayed_to_the_last_bit(tmp_path: Path) -> None:
    sketch, recorded = written(tmp_path, RANDOM), Recorded()
    screen = FakeScreen(closes_s=0.5)
    screen.plan[0.2] = lambda: Mouse().press(0)

    play(sketch, screen, manner=Manner(inputs=recorded))
    first = (tmp_path / "seen.txt").read_text()
    (tmp_path / "seen.txt").unlink()
    replay = replay_of(json.loads(recorded.text()))
    play(sketch, FakeScreen(closes_s=0.5), manner=Manner(inputs=Replayed(replay)))
    in_window = (tmp_path / "seen.txt").read_text()
    list(render(Launch(sketch, Remarks().tell, replay=replay), [60], ListingBackend()))

    assert in_window == first
    assert (tmp_path / "seen.txt").read_text() == first


class ShaderBackend(ListingBackend):
    """Remembers which shaders it was to compile; what says `broken` does not compile."""

    def __init__(self) -> None:
        super().__init__()
        self.compiled: list[str] = []

    def prepare(self, source: ShaderSource) -> None:
        assert source.fragment is not None
        if "broken" in source.fragment.text:
            raise SketchError("tone.frag, line 1: it is broken.")
        if not self.compiled or self.compiled[-1] != source.fragment.text:
            self.compiled.append(source.fragment.text)


SHADED = """
setups = []
def setup():
    size(20, 20, P2D)
    global tone
    tone = loadShader("tone.frag")
    setups.append(1)
def draw():
    background(0)
    shader(tone)
    rect(0, 0, 10, 10)
    surface.setTitle(f"{len(setups)} setups, {frameCount} frames")
"""


def test_saved_shader_is_compiled_while_the_sketch_goes_on(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.backend = backend = ShaderBackend()
    sketch = written(tmp_path, SHADED)
    shader = written(tmp_path, "void main() { }\n", "tone.frag")
    screen.plan[0.4] = saved(shader, "void main() { gl_FragColor = vec4(1.0); }\n")

    finished, told = play(sketch, screen)

    assert [len(text) for text in backend.compiled] == [16, 42]
    assert told == []
    assert finished
    assert screen.titles[-1].startswith("1 setups")


def test_broken_shader_is_told_and_the_old_one_goes_on(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=1.0)
    screen.backend = backend = ShaderBackend()
    sketch = written(tmp_path, SHADED)
    shader = written(tmp_path, "void main() { }\n", "tone.frag")
    screen.plan[0.4] = saved(shader, "broken\n")

    _, told = play(sketch, screen)

    assert len(backend.compiled) == 1
    assert len(told) == 1
    assert "it is broken" in str(told[0])
    assert screen.shown[-1][0] > 0.9


class Stepper(NoExplorer):
    """Pauses after some frames, and then wants single ones; swallows all keys."""

    def __init__(self, steps: int) -> None:
        self.steps = steps
        self.is_paused = False
        self.asked = 0

    def handles(self, event: AnyEvent) -> bool:
        self.is_paused = True
        return isinstance(event, KeyEvent)

    def takes_step(self) -> bool:
        self.asked += 1
        return self.asked <= self.steps


COUNTED = """
def draw():
    surface.setTitle(f"{frameCount} {millis()}")
def keyPressed():
    exit()
"""


def test_paused_sketch_draws_only_the_steps_that_are_wanted(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=2.0)
    screen.plan[0.5] = lambda: [KeyEvent(KeyEvent.PRESS, key="x")]

    play(written(tmp_path, COUNTED), screen, Stepper(3))

    frame, millis = map(int, screen.titles[-1].split())
    assert frame == pytest.approx(33, abs=2)
    assert millis == pytest.approx(550, abs=20)  # half a second, and three 60ths
    assert screen.time_s > 1.9  # the key was not the sketch's


class Slow(NoExplorer):
    speed = 0.1


def test_slow_motion_slows_frames_and_time(tmp_path: Path) -> None:
    screen = FakeScreen(closes_s=2.0)

    play(written(tmp_path, COUNTED), screen, Slow())

    frame, millis = map(int, screen.titles[-1].split())
    assert frame == pytest.approx(12, abs=1)
    assert millis == pytest.approx(200, abs=20)
