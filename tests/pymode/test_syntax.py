import pytest

from sketchkit.core.errors import SketchError
from sketchkit.pymode import syntax
from sketchkit.pymode.syntax import convert


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("print x", "print(x)"),
        ("print", "print()"),
        ('print "a", b', 'print("a", b)'),
        ("print x,", "print(x, end=' ')"),
        ("print >>f, x", "print(x, file=f)"),
        ("print(x)", "print(x)"),
        ("print(x, y)", "print((x, y))"),
        ("print(x, end='')", "print(x, end='')"),
        ("from __future__ import print_function\nprint(x, y)",) * 2,
        ("try:\n    f()\nexcept E, e:\n    g()", "try:\n    f()\nexcept E as e:\n    g()"),
        ("raise E, 'x'", "raise E('x')"),
        ("x = `y`", "x = repr(y)"),
        ("x = a <> b", "x = a != b"),
        ("x = 0777", "x = 0o777"),
        ("x = 10L", "x = 10"),
        (r"x = ur'\d'", r"x = r'\d'"),
        (r"x = 'C:\users'", r"x = 'C:\\users'"),
        (r"x = u'\u00e9'",) * 2,
        ("x = b'ab'", "x = 'ab'"),
        ("exec code", "exec(code)"),
        ("f = lambda (a, b): a + b", "f = lambda a_b: a_b[0] + a_b[1]"),
        ("x = f'{y}'",) * 2,
        ("# only a comment",) * 2,
        ("",) * 2,
        ("x = 1\n\n\n",) * 2,
    ],
)
def test_python_2_is_written_as_python_3(old: str, new: str) -> None:
    assert convert(old, "a.pyde").text == new


def test_lines_that_the_conversion_adds_are_those_they_came_from() -> None:
    converted = convert("def f((a, b)):\n    return a\nx = 1\n", "a.pyde")

    tree = converted.tree("a.pyde")

    assert converted.text.count("\n") == 4
    assert tree.body[-1].lineno == 3


@pytest.mark.parametrize(
    ("text", "line"),
    [("x = 1\nif x\n    y = 2", 2), ("x = 1\nprint 'a' 'b", 2), ("x = (1,\n", 1)],
)
def test_what_is_no_python_is_a_syntax_error_in_its_line(text: str, line: int) -> None:
    with pytest.raises(SyntaxError) as caught:
        convert(text, "a.pyde")

    assert (caught.value.filename, caught.value.lineno) == ("a.pyde", line)


def test_missing_library_is_told_with_the_command_that_installs_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(syntax.importlib, "import_module", refuse)

    with pytest.raises(SketchError, match="Python Mode") as caught:
        convert("x = 1", "a.pyde")

    assert 'pip install "sketchkit[pde]"' in caught.value.message
