from __future__ import annotations

import numpy as np

from sketchkit.core.constants import PROJECT, ROUND
from sketchkit.draw.pipeline import Clip
from sketchkit.vector.page import Ellipse, Ink, Item, Mark, Page, Path, Rect, Setting
from sketchkit.vector.svg import number, svg_bytes


def svg_of(*items: Item) -> str:
    return svg_bytes(Page(30, 20, list(items))).decode()


def test_empty_page_has_its_size() -> None:
    assert '<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20"' in svg_of()


def test_rectangle_is_a_rectangle() -> None:
    svg = svg_of(Mark(Rect(1, 2, 3.5, 4), Ink(fill=0x80FF8000), Setting()))

    assert '<rect x="1" y="2" width="3.5" height="4" fill="#ff8000" fill-opacity="0.5019608"' in svg


def test_line_has_weight_cap_and_join() -> None:
    line = Path("ML", np.array([(0.0, 0.0), (5.0, 0.0)]))

    svg = svg_of(Mark(line, Ink(-1, 0xFF000000, 2.5, PROJECT, ROUND), Setting()))

    assert '<line x1="0" y1="0" x2="5" y2="0" fill="none" stroke="#000000"' in svg
    assert 'stroke-width="2.5" stroke-linecap="square" stroke-linejoin="round"' in svg


def test_matrix_is_kept() -> None:
    svg = svg_of(Mark(Ellipse(0, 0, 2, 1), Ink(fill=0), Setting(), (0, 1, -1, 0, 7, 8)))

    assert '<ellipse cx="0" cy="0" rx="2" ry="1"' in svg
    assert 'transform="matrix(0 1 -1 0 7 8)"' in svg


def test_equal_clips_are_written_once() -> None:
    clipped, free = Setting(Clip(1, 2, 3, 4)), Setting()
    marks = [Mark(Rect(0, 0, 9, 9), Ink(fill=0), how) for how in (clipped, clipped, free, clipped)]

    svg = svg_of(*marks)

    assert svg.count("<clipPath") == 1
    assert svg.count('clip-path="url(#clip1)"') == 2


def test_numbers_are_as_short_as_32_bits_allow() -> None:
    assert [number(value) for value in (np.float32(0.1), 12.0, 1e-5, -0.0, 1e7)] == [
        *("0.1", "12", "0.00001", "0", "10000000")
    ]
