from textwrap import dedent

import pytest

from sketchkit.pymode.porting import Ported, port


def ported(text: str) -> Ported:
    return port({"a.py": dedent(text)})


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("print x  # comment\n", "print(x)  # comment\n"),
        ("print 'a', width / 2\n", "print('a', width // 2)\n"),
        ("x = 7 / 2\n", "x = 7 // 2\n"),
        ("x = 7 / 2.0\n", "x = 7 / 2.0\n"),
        ("x = 7\nx /= 2\n", "x = 7\nx //= 2\n"),
        ("x = (width / 2) / (3)\n", "x = (width // 2) // (3)\n"),
        ("s = 'é'; x = width / 2\n", "s = 'é'; x = width // 2\n"),
        ("for i in xrange(3):\n    pass\n", "for i in range(3):\n    pass\n"),
        ("x = range(3) + [1]\n", "x = list(range(3)) + [1]\n"),
        ("k = d.keys()[0]\n", "k = list(d.keys())[0]\n"),
        ("if d.has_key(k):\n    pass\n", "if k in d:\n    pass\n"),
        ("x = map(a, 0, 1, 0, 9)\n", "x = map(a, 0, 1, 0, 9)\n"),
        ("x = map(f, a)\n", "x = list(map(f, a))\n"),
        ("filter(BLUR, 6)\n", "filter(BLUR, 6)\n"),
        ("x = filter(f, a)\n", "x = list(filter(f, a))\n"),
        ("x = unicode(y)\n", "x = str(y)\n"),
        ("class C:\n    def __div__(s, n): f()\n", "class C:\n    def __truediv__(s, n): f()\n"),
    ],
)
def test_text_becomes_python_3(old: str, new: str) -> None:
    result = ported(old)

    assert result.texts["a.py"] == new
    assert result.remarks == []


def test_true_division_from_the_future_stays() -> None:
    text = ported("from __future__ import division\nx = 7 / 2\n").texts["a.py"]

    assert text.strip() == "x = 7 / 2"


def test_division_that_nobody_can_tell_is_left_and_noted() -> None:
    result = ported("def half(n):\n    return n / 2\n")

    assert result.texts["a.py"] == "def half(n):\n    return n / 2\n"
    (remark,) = result.remarks
    assert (remark.file, remark.line) == ("a.py", 2)
    assert "If n and 2 are both whole numbers, write // here" in remark.text


def test_what_modules_are_called_with_counts_too() -> None:
    result = port({"a.py": "import b\nb.half(3)\n", "b.py": "def half(n):\n    return n / 2\n"})

    assert result.texts["b.py"] == "def half(n):\n    return n // 2\n"


def test_late_global_moves_to_the_top_of_its_function() -> None:
    text = ported(
        """\
        def f():
            x = 1
            global x, y
            y = 2
        """
    ).texts["a.py"]

    compile(text, "a.py", "exec")
    assert text.splitlines()[1] == "    global x, y"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("y = round(x)", "round()"),
        ("a.sort(cmp=f)", "cmp_to_key"),
        ("y = cmp(a, b)", "no cmp()"),
        ("y = s.encode('utf-8')", "bytes"),
        ("add_library('peasycam')", "Java"),
        ("from java.util import Random", "Java"),
    ],
)
def test_what_is_to_be_checked_is_told(line: str, words: str) -> None:
    (remark,) = ported(f"x = 1\n{line}\n").remarks

    assert remark.line == 2
    assert words in remark.text


def test_number_made_whole_at_once_needs_no_check() -> None:
    assert ported("y = int(round(x))\n").remarks == []
