import struct

import pytest

from sketchkit.assets.fonts.vlw import load_vlw, read_vlw
from sketchkit.core.errors import SketchError

D = struct.pack(">7i", ord("d"), 3, 2, 4, 3, 1, 0)  # 2 wide, 3 high, advance 4, 3 up, 1 right
P = struct.pack(">7i", ord("p"), 2, 1, 3, 1, 0, 0)  # one pixel below the baseline
MASKS = bytes([10, 20, 30, 40, 50, 60, 70, 80])
NAMES = struct.pack(">H4sH2s", 4, b"Some", 2, b"PS")


def font(version=11, ascent=0, descent=0, end=NAMES + b"\0"):
    return struct.pack(">6i", 2, version, 24, 0, ascent, descent) + D + P + MASKS + end


def test_letters_have_masks_places_and_widths():
    letters = read_vlw(font()).letters

    assert letters["d"].mask.tolist() == [[10, 20], [30, 40], [50, 60]]
    assert (letters["d"].left, letters["d"].top, letters["d"].advance) == (1, -3, 4)
    assert letters["p"].mask.tolist() == [[70], [80]]


def test_size_names_and_smoothing_are_read():
    read = read_vlw(font())

    assert (read.size, read.name, read.postscript_name) == (24, "Some", "PS")
    assert not read.is_smooth


def test_heights_are_those_of_d_and_p_unless_the_file_says_others():
    assert (read_vlw(font()).ascent, read_vlw(font()).descent) == (3, 1)
    assert (read_vlw(font(ascent=7, descent=5)).ascent, read_vlw(font()).descent) == (7, 1)


def test_old_files_end_after_the_masks():
    read = read_vlw(font(version=8, end=b""))

    assert (read.name, read.is_smooth) == ("", True)


@pytest.mark.parametrize("data", [b"", b"abc", font()[:70], b"\xff" * 100])
def test_what_is_no_such_file_is_told(tmp_path, data):
    path = tmp_path / "letters.vlw"
    path.write_bytes(data)

    with pytest.raises(SketchError, match=r"letters\.vlw cannot be read"):
        load_vlw(path)
