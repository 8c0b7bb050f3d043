import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.assets.pictures.radiance import radiance_bytes, read_radiance

HEADER = b"#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 1 +X 2\n"


def test_four_bytes_are_three_fractions_and_a_power_of_two():
    floats = read_radiance(HEADER + bytes((128, 64, 0, 129, 255, 0, 1, 136)) + b"")

    assert floats.tolist() == [[[1.0, 0.5, 0.0], [255.0, 0.0, 1.0]]]


def test_a_power_of_zero_is_black():
    assert not read_radiance(HEADER + bytes((9, 9, 9, 0)) * 2).any()


def test_rows_in_runs():
    header = b"#?RGBE\n\n-Y 1 +X 8\n"
    red, green = bytes((128 + 8, 128)), bytes((3, 128, 0, 0, 128 + 5, 64))
    row = bytes((2, 2, 0, 8)) + red + green + bytes((128 + 8, 0)) + bytes((128 + 8, 129))

    floats = read_radiance(header + row)

    assert floats[0, :, 0].tolist() == [1.0] * 8
    assert floats[0, :, 1].tolist() == [1.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5, 0.5]


@given(
    width=st.integers(1, 300),
    height=st.integers(1, 4),
    seed=st.integers(0, 99),
    runs=st.booleans(),
)
def test_what_is_written_is_read_within_one_part_of_128(width, height, seed, runs):
    random = np.random.default_rng(seed)
    floats = np.exp(random.normal(0, 4, (height, width, 3))).astype(np.float32)
    if runs:
        floats[:, : width // 2] = floats[:1, :1]

    again = read_radiance(radiance_bytes(floats))

    highest = floats.max(axis=2, keepdims=True)
    assert (np.abs(again - floats) <= highest / 127).all()


def test_what_is_no_colour_is_written_as_black():
    floats = np.array([[[-1, np.nan, 0], [np.inf, 0, 0]]], np.float32)

    again = read_radiance(radiance_bytes(floats))

    assert again[0, 0].tolist() == [0, 0, 0]
    assert again[0, 1, 0] > 1e38


@pytest.mark.parametrize(
    ("file", "message"),
    [
        (b"GIF89a", "does not begin"),
        (HEADER.replace(b"rgbe", b"xyze"), "does not begin"),
        (HEADER.replace(b"-Y", b"+Y"), "no size"),
        (HEADER + b"123", "ends too early"),
        (b"#?RGBE\n\n-Y 2 +X 8\n" + bytes((2, 2, 0, 8, 136, 1)), "ends too early"),
    ],
)
def test_a_broken_file_is_told(file, message):
    with pytest.raises(ValueError, match=message):
        read_radiance(file)
