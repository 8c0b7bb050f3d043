"""What the functions do is tested in tests/data; here lists, printing and errors."""

import pytest

from sketchkit.api import strings
from sketchkit.core.errors import SketchError


@pytest.mark.parametrize(
    ("name", "args", "expected"),
    [
        ("nf", ([1, 20, 300], 4), ["0001", "0020", "0300"]),
        ("nf", ((1.5, 2.25), 3, 1), ["001.5", "002.2"]),
        ("nfs", ([1, -20], 4), [" 0001", "-0020"]),
        ("nfp", ([1.5, -2.25], 3, 1), ["+001.5", "-002.2"]),
        ("nfc", ([1000, -20000],), ["1,000", "-20,000"]),
        ("trim", (["  a", "b "],), ["a", "b"]),
    ],
)
def test_a_list_gives_a_list(name, args, expected):
    assert getattr(strings, name)(*args) == expected


def test_println_prints_values_with_spaces(capsys):
    strings.println("x", 1, 2.5)

    assert capsys.readouterr().out == "x 1 2.5\n"


def test_print_array_numbers_its_lines(capsys):
    strings.printArray(["a", 1])

    assert capsys.readouterr().out == '[0] "a"\n[1] 1\n'


@pytest.mark.parametrize("what", ["text", 12], ids=str)
def test_print_array_of_no_list_prints_it(capsys, what):
    strings.printArray(what)

    assert capsys.readouterr().out == f"{what}\n"


@pytest.mark.parametrize(
    ("name", "args", "message"),
    [
        ("nf", ("seven", 3), "nf() takes 1, 2 or 3 numbers: num [, left] [, right].\n    Got text"),
        ("nfc", (None,), "nfc() takes 1 or 2 numbers: num [, right].\n    Got None"),
        ("hex", ("AB",), "hex() takes 1 or 2 numbers"),
        ("unhex", ("XY",), "unhex() takes text of the digits 0 to 9 and A to F.\n    Got unhex"),
        ("unbinary", ("2",), "unbinary() takes text of the digits 0 and 1.\n"),
        ("join", ("a", 2), "join() takes a list and the text between.\n"),
        ("split", (12, ","), "split() takes a text and what stands between.\n"),
        ("split", ("a", ""), "split() takes a text and what stands between.\n"),
        ("splitTokens", (12,), "splitTokens() takes a text and characters that separate.\n"),
        ("trim", (12,), "trim() takes a text, or a list of them.\n"),
        ("match", ("a", "("), "match() cannot read this pattern: "),
        ("matchAll", (12, "a"), "matchAll() takes a text and a pattern.\n"),
    ],
)
def test_wrong_arguments_are_told(name, args, message):
    with pytest.raises(SketchError) as caught:
        getattr(strings, name)(*args)

    assert caught.value.message.startswith(message)
