import numpy as np
import pytest

from sketchkit.assets.models.number_rows import NumberRows, single
from sketchkit.core.errors import SketchError
from tests.assets.models.model_files import DATA

PATH = DATA / "house.obj"


def test_rows_are_float32_and_the_rest_of_a_line_does_not_count():
    rows = NumberRows(2)
    rows.add(PATH, 1, [b"1", b"2.5"])
    rows.add(PATH, 7, [b"-3e2", b"+.5", b"more"])

    numbers = rows.array(PATH)

    assert numbers.dtype == np.float32
    assert numbers.tolist() == [[1, 2.5], [-300, 0.5]]


def test_no_rows_are_an_empty_array():
    assert NumberRows(3).array(PATH).shape == (0, 3)


def test_the_line_of_the_first_wrong_number_is_told():
    rows = NumberRows(2)
    rows.add(PATH, 3, [b"1", b"2"])
    rows.add(PATH, 9, [b"1", b"one"])
    rows.add(PATH, 11, [b"1", b"two"])

    with pytest.raises(SketchError, match=r"house\.obj, line 9: 'one' is no number"):
        rows.array(PATH)


def test_too_few_numbers_are_told_at_once():
    with pytest.raises(SketchError, match=r"line 4: there have to be 3 numbers\.\n    Got 2"):
        NumberRows(3).add(PATH, 4, [b"1", b"2"])


def test_what_32_bits_do_not_hold_is_infinite():
    assert single([1e99, 1]).tolist() == [np.inf, 1]
