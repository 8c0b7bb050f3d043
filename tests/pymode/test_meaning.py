from fractions import Fraction

import pytest

from sketchkit.api.pvector import PVector
from tests.pymode.running import run, value

D = {"a": 1, "b": 2}


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("5 / 2", 2),
        ("-5 / 2", -3),
        ("n / 2", 3),
        ("n / 2.0", 3.5),
        ("x / 2", 1.25),
        ("True / 2", 0),
        ("n / n", 1),
        ("n / 2 * 1.5", 4.5),
        ("float(n) / 2", 3.5),
        ("F / 2", Fraction(1, 6)),
        ("d.keys()[0]", "a"),
        ("d.values() + [3]", [1, 2, 3]),
        ("d.items()[1]", ("b", 2)),
        ("list(d.iteritems())", [("a", 1), ("b", 2)]),
        ("list(d.itervalues())", [1, 2]),
        ("d.has_key('a')", True),
        ("(k for k in 'xy').next()", "x"),
        ("'é'.encode('utf-8')", "é"),
        ("'abc'.decode('utf-8')", "abc"),
        ("'ab'.encode('hex')", "6162"),
        ("str(0.1 + 0.2)", "0.3"),
        ("str(2.0)", "2.0"),
        ("str(1e20)", "1e+20"),
        ("str(3)", "3"),
        ("unicode('é', 'utf-8')", "é"),
        ("[3, None, 'a', 1].sort()", None),
        ("[1] > 500", True),
        ("None < x", True),
        ("'a' <= 5", False),
        ("n >= 7", True),
        ("1 < n < 9", True),
    ],
)
def test_expression_has_the_value_of_python_2(expression: str, expected: object) -> None:
    found = value(expression, n=7, x=2.5, d=dict(D), F=Fraction(1, 3))

    assert found == expected
    assert type(found) is type(expected)


def test_division_from_the_future_is_true() -> None:
    names = run("from __future__ import division\nx = 5 / 2\ny = 5\ny /= 2")

    assert (names["x"], names["y"]) == (2.5, 2.5)


@pytest.mark.parametrize(
    ("line", "expected"),
    [("x = 7; x /= 2", 3), ("x = 7.0; x /= 2", 3.5), ("x = 7; n = 2; x /= n", 3)],
)
def test_division_in_place_of_whole_numbers_is_whole(line: str, expected: object) -> None:
    assert run(line)["x"] == expected


def test_division_in_place_looks_its_target_up_once() -> None:
    names = run(
        """
        calls = []
        def place():
            calls.append(1)
            return 0
        values = [9]
        values[place()] /= 2
        """
    )

    assert (names["values"], names["calls"]) == ([4], [1])


def test_a_vector_is_divided_by_a_whole_number() -> None:
    vector = value("v / 2", v=PVector(3, 5))
    in_place = run("v /= 2", v=PVector(3, 5))["v"]

    assert (vector.x, vector.y) == (1.5, 2.5)
    assert (in_place.x, in_place.y) == (1.5, 2.5)


def test_division_by_zero_is_an_error_as_ever() -> None:
    with pytest.raises(ZeroDivisionError):
        value("n / 0", n=3)


def test_global_may_stand_behind_the_first_use() -> None:
    names = run(
        """
        x = 1
        def f():
            "A text first."
            print x
            if True:
                global x
                x = 2
        f()
        """
    )

    assert names["x"] == 2


def test_global_outside_of_functions_means_nothing() -> None:
    assert run("x = 1\nglobal x\nx = 2")["x"] == 2


def test_a_function_of_the_sketch_called_str_is_its_own() -> None:
    assert run("def str(x):\n    return 'mine'\ny = str(0.5)")["y"] == "mine"


def test_methods_of_other_objects_are_called_as_they_are() -> None:
    class Owner:
        def keys(self) -> str:
            return "mine"

        def sort(self, order: int) -> int:
            return order

    assert value("o.keys()", o=Owner()) == "mine"
    assert value("o.sort(4)", o=Owner()) == 4


@pytest.mark.parametrize(
    ("body", "expression", "expected"),
    [
        ("def __div__(self, n): return n * 10", "C() / 2", 20),
        ("def __rdiv__(self, n): return n * 10", "2 / C()", 20),
        ("def __nonzero__(self): return False", "bool(C())", False),
        ("def __cmp__(self, other): return -1", "C() < C()", True),
        ("def __cmp__(self, other): return 0", "C() == C()", True),
        ("def __eq__(self, other): return True", "len({C(), C()}) > 0", True),
        (
            "def __iter__(self): return self\n    def next(self): raise StopIteration",
            "list(C())",
            [],
        ),
        (
            "def __len__(self): return 9\n    def __getitem__(self, i): return i\n"
            "    def __getslice__(self, a, b): return (a, b)",
            "C()[2:4]",
            (2, 4),
        ),
    ],
)
def test_methods_of_classes_have_their_old_names(
    body: str, expression: str, expected: object
) -> None:
    assert run(f"class C:\n    {body}\nresult = {expression}")["result"] == expected
