import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.data.json_reading import read_json
from sketchkit.data.json_writing import COMPACT, quote, write_json
from sketchkit.data.malformed import MalformedError

VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)


@pytest.mark.parametrize(
    ("text", "compact"),  # what Processing reads them as, written by format(-1)
    [
        ("{'a': 1, b: hello world, c => 2; d = 3,}", '{"a":1,"b":"hello world","c":2,"d":3}'),
        ("[1,,2,]", "[1,null,2]"),
        ('{"a":007}', '{"a":7}'),
        ('{"a":1e3}', '{"a":1000}'),
        ('{"a":1e20}', '{"a":1.0E20}'),
        ('{"a":100.0}', '{"a":100}'),
        ('{"a":0.00001}', '{"a":1.0E-5}'),
        ("[NaN, TRUE, +1, .5]", '["NaN",true,1,0.5]'),
    ],
)
def test_reads_and_writes_as_processing(text: str, compact: str) -> None:
    assert write_json(read_json(text), COMPACT) == compact


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        ('{\n  "a": 1\n  "b": 2\n}', (3, 3), "A comma or } is missing"),
        ('{"a" 1}', (1, 6), "colon"),
        ("[1,\n2", (2, 2), "does not end"),
        ('{"a": "x\n"}', (1, 7), "not closed in its line"),
        ('{"a": 1, "a": 2}', (1, 10), "twice"),
        ('["\\q"]', (1, 3), "means nothing"),
        ("", (1, 1), "nothing in it"),
        ('{"a": 1} b', (1, 10), "behind its end"),
        ('{"a": }', (1, 7), "value is missing"),
        ("[" * 5000, (1, 202), "within each other"),
    ],
)
def test_mistake_is_told_with_its_place(text: str, place: tuple[int, int], problem: str) -> None:
    with pytest.raises(MalformedError, match=problem) as caught:
        read_json(text)

    assert (caught.value.line, caught.value.column) == place


@given(VALUES, st.sampled_from([COMPACT, 0, 2]))
def test_what_is_written_is_read_again_by_python_and_by_us(value: object, indent: int) -> None:
    text = write_json(value, indent)

    assert json.loads(text) == value
    assert read_json(text) == value


@given(VALUES)
def test_the_slow_way_reads_strict_json_the_same(value: object) -> None:
    strict = json.dumps(value)

    assert read_json(strict[:-1] + ",]" if strict.endswith("]") and value else strict) == value


def test_layout_is_that_of_processing() -> None:
    text = write_json({"e": [], "in": {"f": 2, "g": [1]}}, 2)

    assert text == '{\n  "e": [],\n  "in": {\n    "f": 2,\n    "g": [1]\n  }\n}'


def test_marks_are_escaped_as_in_processing() -> None:
    assert quote('h\u00e9</x>\u2028"\n') == '"h\u00e9<\\/x>\\u2028\\"\\n"'
