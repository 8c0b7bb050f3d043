import pytest

from tests.pymode.running import run, value


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("range(3) + [9]", [0, 1, 2, 9]),
        ("list(xrange(2, 4))", [2, 3]),
        ("range(2.0)", [0, 1]),
        ("zip([1, 2], 'ab')[1]", (2, "b")),
        ("map(abs, [-1, 2])", [1, 2]),
        ("map(None, [1, 2], [3])", [(1, 3), (2, None)]),
        ("filter(None, [0, 1, 2])", [1, 2]),
        ("filter(str.isdigit, 'a1b2')", "12"),
        ("filter(bool, (0, 3))", (3,)),
        ("reduce(lambda a, b: a + b, [1, 2, 3])", 6),
        ("cmp(2, 1)", 1),
        ("sorted([3, 1, 2], cmp=lambda a, b: b - a)", [3, 2, 1]),
        ("sorted(['b', None, 2])", [None, 2, "b"]),
        ("round(2.5)", 3.0),
        ("round(-2.5)", -3.0),
        ("round(1.25, 1)", 1.3),
        ("unichr(233)", "é"),
        ("isinstance('a', basestring)", True),
        ("isinstance(3, long)", True),
        ("long(3.7)", 3),
        ("apply(max, (1, 2))", 2),
        ("os.path.basename('a/b')", "b"),
    ],
)
def test_function_answers_as_in_python_2(expression: str, expected: object) -> None:
    found = value(expression)

    assert found == expected
    assert type(found) is type(expected)


def test_a_list_sorts_by_comparison() -> None:
    assert run("x = [1, 3, 2]\nx.sort(lambda a, b: b - a)")["x"] == [3, 2, 1]


def test_print_writes_at_most_12_digits(capsys: pytest.CaptureFixture[str]) -> None:
    run("print 0.1 + 0.2, 'a'")

    assert capsys.readouterr().out == "0.3 a\n"
