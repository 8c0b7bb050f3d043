import json
from collections import Counter

import pytest
from click.testing import CliRunner, Result

from sketchkit.cli.api import missing_lines, score_lines
from sketchkit.cli.main import main
from sketchkit.reference.names import Name
from sketchkit.reference.standing import Entry, Standing


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["api", *arguments])


def test_score_and_what_is_not_here() -> None:
    output = run().output

    assert "names   here  instead  missing" in output
    assert "Write img.format: ARGB has alpha, RGB has none.\n    PImage.checkAlpha()" in output


def test_score_counts_each_tier() -> None:
    found = [
        Entry(Name("", "rect", "function", 1, ""), Standing.HERE, None),
        Entry(Name("", "line", "function", 1, ""), Standing.HERE, None),
        Entry(Name("", "HashMap", "class", 2, ""), Standing.INSTEAD, "Write dict."),
        Entry(Name("", "Table", "class", 2, ""), Standing.MISSING, None),
    ]

    lines = [line.split()[-4:] for line in score_lines(found)]

    assert lines[1:] == [list("2200"), list("2011"), list("0000")]


def test_class_stands_for_its_names() -> None:
    found = [
        Entry(Name("", "Serial", "class", 3, ""), Standing.INSTEAD, "Use pyserial."),
        Entry(Name("Serial", "read", "method", 3, ""), Standing.INSTEAD, "Use pyserial."),
        Entry(Name("Serial", "stop", "method", 3, ""), Standing.INSTEAD, "Use pyserial."),
        Entry(Name("", "rect", "function", 1, ""), Standing.HERE, None),
    ]

    assert list(missing_lines(found)) == ["", "Use pyserial.", "    Serial and its 2 names"]


def test_all_that_is_missing_is_listed() -> None:
    output = run("--missing").output

    assert "SoundFile and its 13 names" in output
    assert "names   here" not in output


def test_json_has_score_and_names() -> None:
    data = json.loads(run("--json").output)

    standings = Counter((str(name["tier"]), name["standing"]) for name in data["names"])
    assert standings == Counter(
        {
            (tier, standing): count
            for tier, counts in data["tiers"].items()
            for standing, count in counts.items()
            if count
        }
    )
    rect = next(name for name in data["names"] if name["name"] == "rect" and not name["owner"])
    assert rect["standing"] == "here"


def test_json_of_the_missing_leaves_out_what_is_here() -> None:
    data = json.loads(run("--missing", "--json").output)

    assert {name["standing"] for name in data["names"]} <= {"instead", "missing"}


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("rect", ["rect(a, b, c, d, *radii)", "    Draw a rectangle; `rectMode()` gives"]),
        ("rect()", ["rect(a, b, c, d, *radii)"]),
        ("map", ["map(value, start1, stop1, start2, stop2)\nmap(function, *iterables)\n"]),
        ("mouseX", ["mouseX\n    How far the pointer is"]),
        ("CENTER", ["CENTER = 3"]),
        ("PVector.mag", ["PVector.mag()\n    Return the length of the vector."]),
        ("PVector.angleBetween", ["PVector.angleBetween(v1, v2)"]),
        ("heading", ["PVector.heading()"]),
        ("PVector", ["PVector(x=0.0, y=0.0, z=0.0)", "    Methods\n", "angleBetween"]),
    ],
)
def test_name_is_described(name: str, lines: list[str]) -> None:
    result = run(name)

    assert result.exit_code == 0
    for line in lines:
        assert line in result.output


def test_sections_of_a_docstring_are_kept_but_for_its_errors() -> None:
    output = run("size").output

    assert "    See Also\n    --------\n" in output
    assert "Raises" not in output


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("HashMap", "HashMap is not in sketchkit.\n    Write dict in Python."),
        ("PGL.enable", "PGL.enable is not in sketchkit.\n    Write hint("),
        ("enable", "PGL.enable() is not in sketchkit."),
        ("rnadom", "Do you mean random?"),
        ("PVector.nothing", "There is no PVector.nothing"),
    ],
)
def test_name_that_is_not_here_is_told(name: str, words: str) -> None:
    result = run(name)

    assert result.exit_code == 1
    assert words in result.output
