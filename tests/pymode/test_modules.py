import pytest

from sketchkit.pymode.modules import python_2_module


@pytest.mark.parametrize(
    ("module", "name", "args", "expected"),
    [
        ("string", "join", (["a", "b"], "-"), "a-b"),
        ("string", "upper", ("a",), "A"),
        ("math", "floor", (2.5,), 2.0),
        ("math", "sqrt", (4,), 2.0),
        ("random", "randint", (3.0, 3), 3),
        ("fractions", "gcd", (12, 18), 6),
        ("urllib", "quote", ("a b",), "a%20b"),
        ("operator", "div", (5, 2), 2),
        ("operator", "add", (5, 2), 7),
    ],
)
def test_module_has_what_python_2_had(
    module: str, name: str, args: tuple[object, ...], expected: object
) -> None:
    found = getattr(python_2_module(module), name)(*args)

    assert found == expected
    assert type(found) is type(expected)


@pytest.mark.parametrize("name", ["StringIO", "cPickle", "Queue", "ConfigParser", "urllib2"])
def test_module_of_another_name_is_found(name: str) -> None:
    assert python_2_module(name) is not None


def test_tables_are_read_from_files_opened_as_bytes() -> None:
    csv = python_2_module("csv")

    assert list(csv.reader([b"a,b\n", "1,2\n"])) == [["a", "b"], ["1", "2"]]


def test_star_brings_what_was_added() -> None:
    names = python_2_module("itertools").__all__

    assert {"izip", "chain"} <= set(names)


def test_module_that_is_the_same_is_left_to_python() -> None:
    assert python_2_module("json") is None
