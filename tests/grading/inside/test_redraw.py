"""Tapes that no sketch has recorded: what a clean process makes of them."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.grading.inside.orders import RedrawOrder
from sketchkit.grading.inside.redraw import redraw
from sketchkit.tape.messages import Message

CANVAS = ["target", {"number": 0, "state": [12, 9, 4, True, 0, False, 1]}]
FRAME = ["frame", {"number": 1, "canvas": 0, "values": [0.5]}]
END = ["end", 1]


def array(kind: str, *shape: int, at: int = 0) -> dict[str, object]:
    return {"a": kind, "s": list(shape), "o": at}


def canvas(*state: object) -> list[object]:
    return ["target", {"number": 0, "state": list(state)}]


def pixels(data: object) -> list[object]:
    return ["pixels", {"number": 1, "data": data, "mipmaps": True}]


def edit(first: int) -> list[object]:
    data = array("<f4", 1, 3)
    where = {"number": 0, "layer": "fills", "column": "positions", "first": first, "data": data}
    return ["edit", where]


# Each is put between the canvas and its first frame; behind it lie 64 bytes.
FORGED: dict[str, list[object]] = {
    "canvas of negative size": canvas(-5, 9, 4, True, 0, False, 1),
    "canvas larger than any": canvas(10**9, 9, 4, True, 0, False, 1),
    "canvas of no number": canvas(float("nan"), 9, 4, True, 0, False, 1),
    "canvas of 4000 samples": canvas(12, 9, 4000, True, 0, False, 1),
    "canvas of texts": canvas(*"xxxxxxx"),
    "canvas without a state": ["target", {"number": 0}],
    "image that is not there": pixels(array("|u1", 16384, 16384, 4)),
    "image of no rows": pixels(array("|u1", 0, 16384, 4)),
    "image of endless numbers": pixels(array("|u1", 10**30, 0, 4, at=10**30)),
    "image that begins before": pixels(array("|u1", 1, 1, 4, at=-4)),
    "image of objects": pixels(array("|O8", 1, 1, 4)),
    "image of floats": pixels(array("<f4", 1, 1, 4)),
    "image that is a text": pixels("\x00" * 16),
    "class that is no value": ["rows", {"styles": [{"c": "object", "v": []}]}],
    "enum of another thing": ["rows", {"styles": [{"e": "Blend", "v": {}}]}],
    "value before the first": ["rows", {"styles": [{"i": 0}]}],
    "rows of nothing": ["rows", None],
    "upload beyond the edge": [
        "upload",
        {"target": 0, "left": 11, "top": 0, "data": array("|u1", 4, 4, 4)},
    ],
    "upload to what is not there": [
        "upload",
        {"target": 7, "left": 0, "top": 0, "data": array("|u1", 4, 4, 4)},
    ],
    "cube of itself": ["cube", {"number": 1, "faces": [1] * 6}],
    "cube of one face": ["cube", {"number": 1, "faces": [0]}],
    "shader that is none": [
        "shader",
        {"number": 1, "vertex": None, "fragment": None, "kind": None, "attributes": []},
    ],
    "edit of a canvas": edit(0),
    "edit before the first": edit(-1),
    "mesh without blocks": ["mesh", {"number": 1, "blocks": [["fills", None]], "weight_scale": 1}],
    "mesh of another layer": ["mesh", {"number": 1, "blocks": [["inner", None]]}],
    "canvas let go": ["forget", [0]],
    "frame of another canvas": ["frame", {"number": 1, "canvas": 9, "values": []}],
    "frame with a number without end": ["frame", {"number": 1, "canvas": 0, "values": [10**400]}],
    "frame with a text": ["frame", {"number": 1, "canvas": 0, "values": ["x"]}],
}


def written(message: object, body: bytes = b"") -> bytes:
    head = json.dumps(message).encode()
    return struct.pack("<IQ", len(head), len(body)) + head + body


def drawn(folder: Path, tape: bytes) -> dict[str, list[object]]:
    """Return what a tape shows, by the kind of message."""
    path = folder / "tape"
    path.write_bytes(tape)
    found: dict[str, list[object]] = {}

    def send(message: Message) -> None:
        found.setdefault(message.kind, []).append(message.value)

    order = RedrawOrder("cpu", (1,), traces=(1,), watched=("x",))
    redraw(order, path, send, CpuBackend())
    return found


def test_tape_of_these_parts_is_drawn(tmp_path: Path) -> None:
    found = drawn(tmp_path, b"".join(map(written, (CANVAS, FRAME, END))))

    assert found["told"] == [{"mistake": "", "end": 1, "damage": ""}]
    assert found["values"] == [{"x": [0.5]}]
    assert len(found["picture"]) == 1


@pytest.mark.parametrize("message", FORGED.values(), ids=FORGED)
def test_forged_message_ends_a_tape_with_a_sentence(tmp_path: Path, message: object) -> None:
    tape = written(CANVAS) + written(message, bytes(64)) + written(FRAME) + written(END)

    (told,) = drawn(tmp_path, tape)["told"]

    assert told["end"] is None  # type: ignore[index] # a table
    assert told["damage"].endswith(".")  # type: ignore[index]


@pytest.mark.parametrize(
    "head",
    [b"null", b"[1, 2]", b"[]", b"{}", b"[" * 1_000_000, b'["end"]', b"\xff\xfe", b'["end", 1, 2]'],
)
def test_head_that_is_no_message_ends_a_tape(tmp_path: Path, head: bytes) -> None:
    tape = written(CANVAS) + struct.pack("<IQ", len(head), 0) + head + written(FRAME)

    (told,) = drawn(tmp_path, tape)["told"]

    assert told["damage"] == "The recording is damaged."  # type: ignore[index] # a table


def test_words_about_the_run_are_cut_to_a_length(tmp_path: Path) -> None:
    remarks = [["remark", ["a.py", n, "x" * 9000]] for n in range(99)]
    tape = b"".join(map(written, (CANVAS, *remarks, ["mistake", ["a.py", 1, "y" * 99_000]])))

    found = drawn(tmp_path, tape)

    assert len(found["remark"]) <= 50
    assert all(len(str(text)) <= 2000 for text in found["remark"])
    assert len(found["told"][0]["mistake"]) <= 8000  # type: ignore[index] # a table
