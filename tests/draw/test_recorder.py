"""Rows of numbers, packed as a sketch calls."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import RECT
from sketchkit.core.matrix import IDENTITY
from sketchkit.core.style import NO_COLOR, Style
from sketchkit.draw.recorder import (
    CORNER,
    ROW,
    Kind,
    PackError,
    Recorder,
    pack_corner,
    pack_row0,
    pack_row4,
    pack_row8,
    pack_uv,
    unpack_place,
)
from sketchkit.draw.resources import Target
from sketchkit.draw.stage import Stage

RED = 0xFFFF0000


def test_row_keeps_what_the_call_was_given():
    recorder = Recorder()

    pack_row4(recorder.rows, 0, Kind.RECT, 5, RED, NO_COLOR, 2.5, 7, 10, 20, 30.5, 40)
    recorder.row_end = ROW
    (row,) = recorder.row_array()

    assert row["kind"] == Kind.RECT
    assert (row["state"], row["link"]) == (5, 7)
    assert (row["fill"], row["stroke"]) == (RED, NO_COLOR)
    assert row["weight"] == 2.5
    assert row["numbers"].tolist() == [10, 20, 30.5, 40, 0, 0, 0, 0]


def test_rows_follow_each_other():
    recorder = Recorder()

    for number in range(3):
        pack_row8(
            recorder.rows, number * ROW, Kind.QUAD, 0, 0, 0, 0.0, 0, number, *[0] * 6, 9 - number
        )
    recorder.row_end = 3 * ROW

    assert recorder.row_array()["numbers"][:, 0].tolist() == [0, 1, 2]
    assert recorder.row_array()["numbers"][:, 7].tolist() == [9, 8, 7]


def test_shorter_row_leaves_nothing_of_the_one_before_it():
    recorder = Recorder()

    pack_row8(recorder.rows, 0, Kind.QUAD, 0, 0, 0, 0.0, 0, *range(1, 9))
    pack_row0(recorder.rows, 0, Kind.CLEAR, 0, RED, NO_COLOR, 0.0, 0)
    recorder.row_end = ROW

    assert recorder.row_array()["numbers"].tolist() == [[0] * 8]


@pytest.mark.parametrize("value", ["10", None, [10]], ids=["text", "None", "list"])
def test_what_is_no_number_is_not_packed(value):
    recorder = Recorder()

    with pytest.raises(PackError):
        pack_row4(recorder.rows, 0, Kind.RECT, 0, 0, 0, 0.0, 0, value, 0, 0, 0)


def test_full_buffer_is_not_written_beyond():
    recorder = Recorder(capacity=1)

    with pytest.raises(PackError):
        pack_row0(recorder.rows, ROW, Kind.CLEAR, 0, 0, 0, 0.0, 0)


def test_room_is_made_once_it_is_needed():
    recorder = Recorder(capacity=1)

    had_room = not recorder.make_room()
    recorder.row_end = ROW

    assert had_room
    assert recorder.make_room()
    assert len(recorder.rows) >= 2 * ROW
    assert not recorder.make_room()


def test_making_room_keeps_the_rows():
    recorder = Recorder(capacity=1)
    pack_row4(recorder.rows, 0, Kind.RECT, 0, RED, 0, 0.0, 0, 1, 2, 3, 4)
    recorder.row_end = ROW

    recorder.make_room()

    assert recorder.row_array()["fill"].tolist() == [RED]


def test_states_are_numbered_as_they_come():
    recorder = Recorder()
    stage = Stage(Target(10, 10))

    indices = [recorder.keep_state(Style(), stage, IDENTITY) for _ in range(3)]

    assert indices == [0, 1, 2]
    assert len(recorder.matrices) == 3 * 12


def test_corner_keeps_place_and_colors():
    recorder = Recorder()

    pack_corner(recorder.corners, 0, 1.5, 2, -3, 4, RED, NO_COLOR)
    recorder.corner_end = CORNER
    (corner,) = recorder.corner_array()

    assert corner["place"].tolist() == [1.5, 2, -3]
    assert (corner["attributes"], corner["fill"], corner["stroke"]) == (4, RED, NO_COLOR)
    assert unpack_place(recorder.corners, 0) == (1.5, 2, -3)


def test_texture_coordinates_come_in_pairs():
    recorder = Recorder()

    pack_uv(recorder.uvs, 0, 0.25, 1)
    pack_uv(recorder.uvs, 8, 0.5, -1)
    recorder.uv_end = 16

    np.testing.assert_array_equal(recorder.uv_array(), [(0.25, 1), (0.5, -1)])


def test_cleared_recorder_is_empty():
    recorder = Recorder()
    pack_row0(recorder.rows, 0, Kind.CLEAR, 0, 0, 0, 0.0, 0)
    recorder.row_end = ROW
    recorder.keep_state(Style(), Stage(Target(1, 1)), IDENTITY)

    recorder.clear()

    assert len(recorder.row_array()) == 0
    assert recorder.styles == recorder.stages == recorder.matrices == []


def test_stage_is_replaced_from_a_state_on():
    recorder = Recorder()
    old, new = Stage(Target(9, 9)), Stage(Target(9, 9))
    for _ in range(3):
        recorder.keep_state(Style(), old, IDENTITY)

    recorder.replace_stage(old, new, first=1)

    assert [stage is new for stage in recorder.stages] == [False, True, True]


def test_states_behind_the_last_row_of_a_kind_begin_after_its_own(flat):
    recorder = flat._recorder
    flat.rect(0, 0, 9, 9)
    flat.shape(flat.createShape(RECT, 0, 0, 9, 9))
    flat.translate(1, 0)
    flat.rect(0, 0, 9, 9)

    first = recorder.first_state_after(Kind.MESH)

    rows = recorder.row_array()
    assert rows["state"][rows["state"] >= first].tolist() == rows["state"][-1:].tolist()
    assert recorder.first_state_after(Kind.IMAGE) == 0
