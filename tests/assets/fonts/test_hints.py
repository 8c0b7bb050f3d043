import io
import struct
from pathlib import Path

import numpy as np
import pytest
from PIL import ImageFont

from sketchkit.assets.fonts.files import file_of
from sketchkit.assets.fonts.hints import as_java_reads, without_hints
from sketchkit.assets.fonts.letters import open_outlines

DEFAULT = Path(file_of("")).read_bytes()


def mask(font, size, character):
    opened = open_outlines(io.BytesIO(font), size)
    assert isinstance(opened, ImageFont.FreeTypeFont)
    drawn, _ = opened.getmask2(character, mode="L", anchor="ls")
    return np.frombuffer(bytes(drawn), np.uint8).reshape(drawn.size[::-1])


@pytest.mark.parametrize(("size", "rows"), [(15, 10), (16, 10), (17, 11)])
def test_capitals_are_as_high_as_in_processing(size, rows):
    assert len(mask(as_java_reads(DEFAULT, size), size, "H")) == rows


def test_a_size_at_which_both_agree_leaves_the_font_alone():
    assert as_java_reads(DEFAULT, 12) is DEFAULT


def test_without_hints_edges_lie_between_pixels():
    # "E" at 16 pixels, from a JAVA2D frame of Processing's: the upper edge, and the lower one.
    drawn = mask(without_hints(DEFAULT), 16, "E")

    assert drawn[0].tolist() == [0, 72, 128, 128, 128, 128, 128, 62]
    assert drawn[-2:].tolist() == [
        [0, 144, 204, 36, 36, 36, 36, 23],
        [0, 144, 255, 255, 255, 255, 255, 164],
    ]


def test_without_hints_sizes_are_not_whole():
    font = without_hints(DEFAULT)

    assert (mask(font, 15.5, "f")[:, :4] != mask(font, 16, "f")[:, :4]).any()


@pytest.mark.parametrize(
    "data", [b"", b"OTTO" + bytes(20), struct.pack(">4sHHHH", b"ttcf", *[0] * 4)]
)
def test_what_has_no_such_hints_is_left_alone(data):
    assert as_java_reads(data, 16) is data
    assert without_hints(data) is data
