"""Whole runs behind the wall: what they show of a sketch, and what it cannot make them say."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.grading.evidence import RunEvidence, Trace
from sketchkit.grading.results import Status
from sketchkit.grading.runs import Outcome, Request, carry_out
from sketchkit.grading.sandbox.job import Limits
from sketchkit.grading.sandbox.level import Level
from sketchkit.runtime.headless import Launch, render
from tests.grading.sketches import submission

BOX = """
    angle = 0
    def setup():
        size(60, 50, P3D)
    def draw():
        global angle
        angle += 0.5
        background(200)
        lights()
        translate(30, 25)
        with pushMatrix():
            rotateY(angle)
            box(20)
        text("A", 0, 0)
"""


class Runner:
    """Runs sketches in a folder of the test's own."""

    def __init__(self, folder: Path, level: Level) -> None:
        self.folder = folder
        self.level = level

    def outcome(self, text: str, last: int = 2, **wishes: object) -> Outcome:
        request = Request(
            submission(self.folder / "submission", text),
            "sketch.py",
            "cpu",
            0,
            tuple(range(1, last + 1)),
            last,
            traces=(last,),
            limits=Limits(cpu_s=10, wall_s=20),
        )
        request = Request(**{**vars(request), **wishes})  # type: ignore[arg-type]
        workshop = self.folder / "workshop"
        workshop.mkdir(exist_ok=True)
        outcome = carry_out(request, self.folder / "pictures", workshop, self.level)
        assert list(workshop.iterdir()) == []
        return outcome

    def run(self, text: str, last: int = 2, **wishes: object) -> RunEvidence:
        return self.outcome(text, last, **{"is_twice": False, **wishes}).evidence


@pytest.fixture
def runner(tmp_path: Path, walled: Level) -> Runner:
    return Runner(tmp_path, walled)


def pixels(path: Path) -> np.ndarray:
    with Image.open(path) as picture:
        return np.array(picture)


def test_pictures_are_those_of_render(runner: Runner) -> None:
    evidence = runner.run(BOX)

    sketch = runner.folder / "submission" / "sketch.py"
    for frame in render(Launch(sketch, lambda *_: None), [1, 2], CpuBackend()):
        assert np.array_equal(pixels(evidence.frames[frame.number]), frame.pixels)


def test_trace_shows_what_was_drawn(runner: Runner) -> None:
    trace = runner.run(BOX).traces[2]

    assert trace.kinds == {"box": 1, "text": 1}
    assert (trace.nesting, trace.lights, trace.retained) == (1, 2, 0)


def test_trace_shows_retained_shapes_canvases_and_images(runner: Runner) -> None:
    trace = runner.run(
        """
        def setup():
            global s, pg, img
            size(40, 40, P3D)
            s = createShape(BOX, 10)
            pg = createGraphics(10, 10, P3D)
            img = createImage(5, 5, RGB)
        def draw():
            with pg:
                pg.background(255)
                pg.rect(1, 1, 3, 3)
            image(pg, 0, 0)
            image(img, 20, 0)
            shape(s)
            shape(s, 10, 10)
        """
    ).traces[2]

    assert (trace.retained, trace.canvases, trace.textures) == (1, 1, 1)
    assert trace.kinds["rect"] == 1
    assert trace.kinds["image"] == 2
    assert trace.kinds["box"] == 1


def test_trace_shows_shaders_and_their_uniforms(runner: Runner) -> None:
    folder = Path(__file__).parents[2] / "sketches" / "shaders"
    request = {"folder": folder, "sketch": "wave.py", "renderer": "gl"}

    trace = runner.run("", **request).traces[2]

    assert any("time" in given for given in trace.shaders.values())


def test_watched_values_are_those_of_each_frame(runner: Runner) -> None:
    values = runner.run(BOX, last=3, watched=("angle", "frameCount", "nothing")).values

    assert values["angle"] == (0.5, 1.0, 1.5)
    assert values["frameCount"] == (1.0, 2.0, 3.0)
    assert all(math.isnan(number) for number in values["nothing"])


def test_events_are_replayed(runner: Runner) -> None:
    events = runner.folder / "events.json"
    events.write_text('{"events": [{"frame": 1, "click": "left", "at": [7, 9]}]}')

    values = runner.run(
        """
        place = [0, 0]
        def draw():
            pass
        def mouseClicked():
            place[:] = mouseX, mouseY
        """,
        events=events,
        watched=("place[0]", "place[1]"),
    ).values

    assert values == {"place[0]": (7.0, 7.0), "place[1]": (9.0, 9.0)}


def test_reference_is_drawn_otherwise_as_well(runner: Runner) -> None:
    variants = runner.run(BOX, varied=(2,)).variants

    assert {name: list(frames) for name, frames in variants.items()} == {
        "depth test off": [2],
        "lights off": [2],
    }


def test_sketch_that_draws_the_same_twice_is_deterministic(runner: Runner) -> None:
    assert runner.outcome(BOX + "\n    def keyPressed(): random(1)\n").evidence.is_deterministic


@pytest.mark.parametrize(
    "number", ["time.time_ns() % 50", "id(object()) // 16 % 50", "os.urandom(1)[0] % 50"]
)
def test_sketch_that_draws_something_else_each_time_is_found(runner: Runner, number: str) -> None:
    text = f"import os, time\ndef draw():\n    rect({number}, {number}, {number} + 9, 5)\n"

    assert runner.outcome(text, last=5).evidence.is_deterministic is False


def test_sketch_that_prints_another_time_is_deterministic(runner: Runner) -> None:
    text = "import os\ndef draw():\n    a = os.urandom(8)\n    rect(2, 2, 9, 9)\n    print(a)\n"

    assert runner.outcome(text).evidence.is_deterministic is True


def test_frames_after_the_last_are_like_it(runner: Runner) -> None:
    evidence = runner.run("def draw():\n    rect(9, 9, 20 * frameCount, 9)\n    noLoop()\n", last=4)

    assert evidence.status is Status.GRADED
    assert sorted(evidence.frames) == [1, 2, 3, 4]
    assert np.array_equal(pixels(evidence.frames[1]), pixels(evidence.frames[4]))


def test_mistake_ends_it_and_frames_before_are_kept(runner: Runner) -> None:
    evidence = runner.run("def draw():\n    if frameCount == 3: elipse(1, 2)\n", last=5)

    assert evidence.status is Status.STOPPED
    assert "sketch.py, line 2: elipse is not defined." in evidence.explanation
    assert sorted(evidence.frames) == [1, 2]


def test_process_that_ends_after_a_good_frame_has_that_frame_alone(runner: Runner) -> None:
    evidence = runner.run("import os\ndef draw():\n    if frameCount == 2: os._exit(0)\n", last=3)

    assert evidence.status is Status.CRASHED
    assert sorted(evidence.frames) == [1]
    assert evidence.explanation.startswith("It did not come to its end.")


def test_endless_loop_is_over_its_limit(runner: Runner) -> None:
    evidence = runner.run("def draw():\n    while True: pass\n", limits=Limits(cpu_s=2, wall_s=20))

    assert evidence.status is Status.OVER_LIMIT
    assert "2 s of processor time" in evidence.explanation


def test_what_is_printed_is_kept(runner: Runner) -> None:
    assert runner.run("def setup():\n    print('<b>hello</b>')\n").console == "<b>hello</b>\n"


FORGERIES = {
    # Each writes to descriptor 3, or changes what sketchkit would write there, in the belief that
    # its word will be taken for it.
    "a picture": """
        import os, json, struct
        def send(kind, value, body=b""):
            head = json.dumps([kind, value]).encode()
            os.write(3, struct.pack("<IQ", len(head), len(body)) + head + body)
        def draw():
            send("picture", {"frame": 1, "variant": ""}, b"\\x89PNG")
            send("told", {"mistake": "", "end": 2, "damage": ""})
    """,
    "a trace": """
        import os, json, struct
        def draw():
            trace = {"frame": 2, "trace": {"kinds": {"sphere": 9}, "lights": 8}}
            head = json.dumps(["trace", trace]).encode()
            os.write(3, struct.pack("<IQ", len(head), 0) + head)
    """,
    "the counters": """
        import sketchkit.draw.renderer as r
        r.Renderer.reset_stats = lambda self: setattr(self, "stats", r.Stats(0, 0))
        import sketchkit.grading.inside.tracing as t
        from sketchkit.grading.evidence import Trace
        t.Tracer.take = lambda *_: Trace({"sphere": 9}, lights=8)
        def draw():
            rect(1, 1, 2, 2)
    """,
}


@pytest.mark.parametrize("text", FORGERIES.values(), ids=FORGERIES.keys())
def test_forged_words_are_not_taken(runner: Runner, text: str) -> None:
    evidence = runner.run(text)

    trace = evidence.traces.get(2, Trace())
    assert "sphere" not in trace.kinds
    assert trace.lights == 0
    assert all(pixels(path).shape == (100, 100, 3) for path in evidence.frames.values())


@pytest.mark.parametrize(
    "garbage",
    ["os.urandom(999)", "bytes(64)", 'struct.pack("<IQ", 4, 1 << 60) + b"[1]]"'],
    ids=["noise", "zeros", "size"],
)
def test_garbage_on_the_tape_ends_it(runner: Runner, garbage: str) -> None:
    evidence = runner.run(f"import os, struct\ndef draw():\n    os.write(3, {garbage})\n")

    assert evidence.status is Status.CRASHED
    assert "recording" in evidence.explanation


def test_forged_drawing_is_drawn_as_it_is_counted(runner: Runner) -> None:
    """Whoever reaches into the recorder to claim lights is drawn with these lights."""
    evidence = runner.run(
        """
        import gc
        from sketchkit.draw.recorder import Recorder
        def draw():
            background(255)
            rect(10, 10, 50, 50)
            for recorder in [o for o in gc.get_objects() if isinstance(o, Recorder)]:
                recorder.row_end = 0
        """
    )

    assert evidence.traces[2].kinds == {}
    assert (pixels(evidence.frames[2]) == 204).all()


def test_threads_and_last_wishes_are_not_waited_for(runner: Runner) -> None:
    evidence = runner.run(
        """
        import atexit, sys, threading, time
        threading.Thread(target=time.sleep, args=(999,)).start()
        atexit.register(time.sleep, 999)
        class Slow:
            write = print
            def flush(self):
                time.sleep(999)
        def draw():
            print("drawn", frameCount, end=" ")
            if frameCount == 2:
                sys.stdout = Slow()
        """
    )

    assert evidence.status is Status.GRADED
    assert evidence.console == "drawn 1 drawn 2 "


def test_picture_that_is_too_large_to_be_looked_at_is_told(runner: Runner) -> None:
    evidence = runner.run("def setup():\n    size(9000, 20)\ndef draw():\n    background(0)\n")

    assert evidence.frames == {}
    assert "9000 x 20 pixels" in evidence.explanation


def test_source_is_read_by_its_syntax_tree(runner: Runner) -> None:
    source = runner.outcome(
        """
        class Ball:
            def move(self): pass
        def draw():
            # sphere(10)
            for i in range(3):
                circle(i, i, 5)
        """,
        is_twice=False,
    ).source

    assert "circle" in source.calls
    assert "sphere" not in source.calls
    assert set(source.functions) == {"draw", "Ball.move"}
    assert source.classes == ("Ball",)
    assert source.statements["for"] == 1


@pytest.mark.parametrize("text", ["(" * 100_000, "-" * 100_000 + "1", "x = " + "[" * 5000])
def test_source_made_to_break_the_parser_is_the_students_fault(runner: Runner, text: str) -> None:
    evidence = runner.run(text)

    assert evidence.status in (Status.STOPPED, Status.CRASHED)
