"""What a tape draws is what the sketch draws, to the last bit, whatever it is made of."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.taping import record
from sketchkit.tape.messages import Message, TapeError, read_messages
from sketchkit.tape.playing import Player
from tests.runtime.sketches import written

SKETCHES = Path(__file__).parents[2] / "sketches"
FRAMES = (1, 2, 4)

KEPT = """
def setup():
    global s, g, img
    size(60, 50, P3D)
    s = createShape()
    s.beginShape(TRIANGLES)
    for i in range(9):
        s.fill(i * 25, 100, 200)
        s.vertex(5 + i * 5, 5 + 30 * (i % 2), i)
    s.endShape()
    g = createShape(GROUP)
    for i in range(70):
        g.addChild(createShape(BOX, 4 + i % 3))
        g.getChild(i).translate(i % 10 * 6, i // 10 * 6)
    img = createImage(8, 8, ARGB)
def draw():
    background(40)
    lights()
    pointLight(200, 90, 40, 10, 10, 50)
    img.loadPixels()
    for i in range(64):
        img.pixels[i] = color(i * 4, frameCount * 60, 0, 255 - i)
    img.updatePixels()
    s.setVertex(3, 30, 20 + frameCount, 4)
    s.setFill(4, color(255, 0, 0))
    shape(s)
    pushMatrix()
    translate(4, 4, -20)
    rotateY(0.2 * frameCount)
    g.setFill(color(0, 200, 0))
    shape(g)
    popMatrix()
    image(img, 40, 10, 16, 16)
    beginShape(QUAD_STRIP)
    texture(img)
    for i in range(4):
        normal(0, i, 1)
        vertex(10 * i, 30, 0, 2 * i, 0)
        vertex(10 * i, 45, 5, 2 * i, 8)
    endShape()
"""
PIXELS = """
def setup():
    global pg
    size(60, 50, P2D)
    pg = createGraphics(20, 20, P2D)
def draw():
    if frameCount == 1:
        background(255)
    with pg:
        pg.background(0, 0)
        pg.fill(0, 0, 255, 128)
        pg.circle(10, 10, 5 * frameCount)
    image(pg, 5 * frameCount, 5)
    clip(10, 10, 40, 30)
    blendMode(MULTIPLY)
    rect(12, 12, 30, 30)
    blendMode(BLEND)
    noClip()
    loadPixels()
    for i in range(0, 60 * 50, 7):
        pixels[i] = color(red(pixels[i]) / 2, 60, 0)
    updatePixels()
    filter(BLUR, 1)
    set(3, 3, get(20, 20))
    text("abc", 5, 45)
    bezier(0, 0, 30, 50, 40, 0, 59, 49)
"""
STOPPED = """
def setup():
    size(30, 30)
    rect(5, 5, 10, 10)
def draw():
    circle(15, 15, 5 * frameCount)
    if frameCount == 2:
        noLoop()
"""


def taped(sketch: Path, last: int, backend: Backend, watched: Sequence[str] = ()) -> bytes:
    tape = io.BytesIO()
    launch = Launch(sketch, lambda *_: None)
    record(launch, last, lambda message: tape.write(bytes(message)), lambda: backend, watched)
    return tape.getvalue()


def messages(tape: bytes) -> list[Message]:
    return list(read_messages(io.BytesIO(tape)))


def pictures(tape: bytes, backend: Backend) -> dict[int, np.ndarray]:
    """Return what a tape draws, frame by frame."""
    player, found = Player(Renderer(backend)), {}
    for message in messages(tape):
        player.play(message)
        match message.kind, message.value:
            case "frame", {"number": int(number), "canvas": int(canvas)}:
                found[number] = player.read(canvas)[:, :, :3]
    return found


def is_same(sketch: Path, backend: Backend) -> bool:
    """Return whether a sketch's tape draws what the sketch draws; frames that repeat are left."""
    expected = list(render(Launch(sketch, lambda *_: None), FRAMES, backend))
    found = pictures(taped(sketch, max(FRAMES), backend), backend)
    return all(
        np.array_equal(found[frame.repeats or frame.number], frame.pixels) for frame in expected
    )


@pytest.mark.parametrize("text", [KEPT, PIXELS, STOPPED], ids=["kept", "pixels", "stopped"])
def test_everything_there_is_comes_out_the_same(
    tmp_path: Path, backend: Backend, text: str
) -> None:
    assert is_same(written(tmp_path, text), backend)


@pytest.mark.parametrize("sketch", sorted(SKETCHES.glob("*.py")), ids=lambda path: path.stem)
def test_gallery_comes_out_the_same(sketch: Path) -> None:
    assert is_same(sketch, CpuBackend())


@pytest.mark.parametrize(
    "name", ["displacement", "environment_cube", "game_of_life", "skinning", "convolution"]
)
def test_shaders_come_out_the_same(gl_backend: GlBackend, name: str) -> None:
    assert is_same(SKETCHES / "shaders" / f"{name}.py", gl_backend)


def test_same_sketch_makes_the_same_tape(tmp_path: Path) -> None:
    sketch = written(tmp_path, KEPT)

    assert taped(sketch, 3, CpuBackend()) == taped(sketch, 3, CpuBackend())


def test_nothing_is_drawn_while_a_tape_is_written(tmp_path: Path) -> None:
    sketch = written(tmp_path, KEPT)
    tape = io.BytesIO()

    def refuse() -> Backend:
        raise AssertionError("a renderer was opened")

    record(Launch(sketch, lambda *_: None), 2, lambda m: tape.write(bytes(m)), refuse)

    assert messages(tape.getvalue())[-1] == Message("end", 2)


def test_watched_values_are_written_down(tmp_path: Path) -> None:
    sketch = written(tmp_path, "x = 0\ndef draw():\n    global x\n    x += 2\n")

    tape = taped(sketch, 3, CpuBackend(), ["x", "y"])

    values = [m.value["values"] for m in messages(tape) if m.kind == "frame"]  # type: ignore[index]
    assert [row[0] for row in values] == [0, 2, 4, 6]
    assert np.isnan([row[1] for row in values]).all()


def test_mistake_is_the_last_thing_on_the_tape(tmp_path: Path) -> None:
    sketch = written(tmp_path, "def draw():\n    rect(1, 2, 3)\n")

    last = messages(taped(sketch, 3, CpuBackend()))[-1]

    assert last.kind == "mistake"
    assert isinstance(last.value, list)
    assert last.value[:2] == ["sketch.py", 2]


def test_tape_that_is_cut_off_is_drawn_up_to_there(tmp_path: Path) -> None:
    tape = taped(written(tmp_path, STOPPED), 4, CpuBackend())

    assert set(pictures(tape[:-40], CpuBackend())) >= {0, 1}


def test_resources_that_are_gone_are_forgotten(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def draw():
            image(createImage(4, 4, RGB), 0, 0)
        """,
    )
    player = Player(Renderer(CpuBackend()))

    for message in messages(taped(sketch, 30, CpuBackend())):
        player.play(message)

    assert len(player.resources) < 5


@pytest.mark.parametrize(
    "message",
    [
        Message("target", {"number": 0, "state": [1 << 30, 5, 1, True, 0, False]}),
        Message("target", {"number": 0, "state": [-1, 5, 1, True, 0, False]}),
        Message("target", {"number": 0, "state": [5, 5, 3, True, 0, False]}),
        Message("target", {"number": 0}),
        Message("target", 3),
        Message("rows", {}),
        Message("rows", None),
        Message("upload", {"target": 9, "data": {"a": "|u1", "s": [1, 1, 4], "o": 0}}, bytes(4)),
        Message("pixels", {"number": 1, "data": {"a": "|O", "s": [1], "o": 0}}, bytes(8)),
        Message("pixels", {"number": 1, "data": {"a": "|u1", "s": [-1, 4], "o": 0}}, bytes(8)),
        Message("pixels", {"number": 1, "data": {"a": "|u1", "s": [9, 9, 4], "o": 0}}, bytes(8)),
        Message("cube", {"number": 1, "faces": [1, 2]}),
        Message("mesh", {"number": 1, "blocks": [["fills", {"c": "Stage", "v": []}]]}),
        Message("edit", {"number": 1, "layer": "fills", "column": "__class__"}),
        Message("shader", {"number": 1, "vertex": {"e": "Path", "v": 1}}),
    ],
)
def test_message_that_no_sketch_writes_is_refused(message: Message) -> None:
    with pytest.raises(TapeError):
        Player(Renderer(CpuBackend())).play(message)


def test_triangle_beyond_its_vertices_is_refused(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            shape(createShape(TRIANGLE, 0, 0, 9, 0, 9, 9))
        """,
    )
    player = Player(Renderer(CpuBackend()))
    refused = False
    for message in messages(taped(sketch, 1, CpuBackend())):
        body = message.body
        if message.kind == "mesh":
            indices = np.array([0, 1, 2], np.uint32).tobytes()
            assert indices in body
            body = body.replace(indices, np.array([0, 1, 99], np.uint32).tobytes())
        try:
            player.play(Message(message.kind, message.value, body))
        except TapeError:
            refused = True
            break

    assert refused


@settings(max_examples=50)
@given(st.integers(0, 10_000), st.integers(1, 255))
def test_damaged_tape_never_breaks_the_player(where: int, change: int) -> None:
    tape = bytearray(_drawn_tape())
    tape[where % len(tape)] ^= change
    player = Player(Renderer(CpuBackend()))

    try:
        for message in messages(bytes(tape)):
            player.play(message)
    except (TapeError, OverflowError, ZeroDivisionError, RuntimeWarning, MemoryError):
        pass  # an error in Python is all that may come of it


_TAPES: list[bytes] = []


def _drawn_tape() -> bytes:
    """Return a short tape, made once."""
    if not _TAPES:
        tape = io.BytesIO()
        sketch = SKETCHES / "spinning_box.py"
        launch = Launch(sketch, lambda *_: None)
        record(launch, 1, lambda m: tape.write(bytes(m)), CpuBackend)
        _TAPES.append(tape.getvalue())
    return _TAPES[0]
