import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.float32 import f32


@given(st.floats(1e-30, 1e30) | st.floats(-1e30, -1e-30) | st.just(0.0))
def test_f32_is_the_nearest_32_bit_float(x):
    assert f32(x) == struct.unpack("f", struct.pack("f", x))[0]


@pytest.mark.parametrize("x", [16777217.0, 16777219.0], ids=["down", "up"])
def test_f32_sends_a_tie_to_the_even_neighbour(x):
    assert f32(x) == struct.unpack("f", struct.pack("f", x))[0]
