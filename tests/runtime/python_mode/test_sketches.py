"""Sketches of Python Mode from their file to their end, and what is told of their mistakes."""

from pathlib import Path

import pytest

from sketchkit.api.pvector import PVector
from tests.runtime.sketches import Remarks, begun, mistake, play, written


def old(folder: Path, text: str, name: str = "old.pyde") -> Path:
    return written(folder, text, name)


def test_sketch_runs_with_live_values_and_python_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sketch = old(
        tmp_path,
        """
        middles = []
        def setup():
            size(101, 50)
            print "ready", width / 2,
        def draw():
            middles.append(width / 2 + frameCount)
        """,
    )

    names = play(sketch, 2)

    assert names["middles"] == [51, 52]
    assert capsys.readouterr().out == "ready 50 "


def test_modules_beside_it_are_python_2_and_see_live_values(tmp_path: Path) -> None:
    old(
        tmp_path,
        """
        from __future__ import division
        def half():
            return width / 2
        """,
        "exact.py",
    )
    old(tmp_path, "def half():\n    return width / 2\n", "cut.py")
    sketch = old(
        tmp_path,
        """
        import exact, cut
        def setup():
            global halves
            size(101, 50)
            halves = exact.half(), cut.half(), width / 2
        """,
    )

    assert play(sketch)["halves"] == (50.5, 50, 50)


def test_modules_of_a_package_find_each_other_without_a_point(tmp_path: Path) -> None:
    old(tmp_path, "", "shapes/__init__.py")
    old(tmp_path, "SIDES = 4\n", "shapes/sides.py")
    old(tmp_path, "from sides import SIDES\nimport sides\n", "shapes/square.py")
    sketch = old(tmp_path, "from shapes.square import SIDES, sides\nn = sides.SIDES + SIDES\n")

    assert play(sketch)["n"] == 8


@pytest.mark.parametrize("name", ["platform", "queue"])
def test_a_file_named_like_a_module_of_python_comes_first(tmp_path: Path, name: str) -> None:
    old(tmp_path, "mine = True\nimport logging\n", f"{name}.py")
    sketch = old(tmp_path, f"import {name}\nfrom {name} import mine\n")

    names = play(sketch)

    assert names["mine"] is True


def test_a_module_may_differ_in_capitals_as_on_windows(tmp_path: Path) -> None:
    old(tmp_path, "RADIUS = 5\n", "Ball.py")
    sketch = old(tmp_path, "from ball import RADIUS\n")

    assert play(sketch)["RADIUS"] == 5


def test_processing_classes_can_be_imported(tmp_path: Path) -> None:
    sketch = old(
        tmp_path,
        """
        from processing.core import PVector, PApplet, PConstants
        import processing.core.PVector as Vector
        from java.lang import Math
        v = PVector(3, 4)
        w = Vector(1, 2)
        x = PApplet.abs(-2)
        y = Math.max(2, 5)
        """,
    )

    names = play(sketch)

    assert isinstance(names["v"], PVector)
    assert isinstance(names["w"], PVector)
    assert (names["x"], names["y"]) == (2, 5)


def test_a_second_window_is_refused_in_a_sentence(tmp_path: Path) -> None:
    sketch = old(tmp_path, "class Other(PApplet):\n    pass\n")

    assert "A sketch has one window here" in mistake(sketch)


def test_python_modules_of_other_names_can_be_imported(tmp_path: Path) -> None:
    sketch = old(
        tmp_path,
        """
        import string, random, sys, os.path
        from itertools import izip
        from StringIO import StringIO
        pairs = list(izip("ab", string.letters))
        big = sys.maxint > 0
        text = StringIO("x").read()
        """,
    )

    names = play(sketch)

    assert names["pairs"] == [("a", "a"), ("b", "b")]
    assert (names["big"], names["text"]) == (True, "x")


def test_settings_are_made_first_wherever_they_stand_in_setup(tmp_path: Path) -> None:
    sketch = old(
        tmp_path,
        """
        def setup():
            global seen
            seen = width
            background(0)
            noSmooth()
            size(300, 200)
        """,
    )

    assert play(sketch)["seen"] == 300


def test_sketch_without_functions_draws_at_once(tmp_path: Path) -> None:
    sketch = old(tmp_path, "rect(1, 2, 3, 4)\nsize(30, 20)\nglobal x\nx = width / 4\n")

    assert play(sketch)["x"] == 7


def test_this_and_frame_are_the_sketch_and_its_window(tmp_path: Path) -> None:
    sketch = old(
        tmp_path,
        """
        def setup():
            size(120, 80)
            this.surface.setTitle("one")
            this.getSurface().setTitle("two")
            frame.setTitle("three")
        def draw():
            global seen
            this.rect(1, 2, 3, 4)
            seen = this.width, this.frameCount, this.mouseX
        """,
    )

    assert play(sketch, 1)["seen"] == (120, 1, 0)


def test_blocks_lists_and_files_are_as_in_python_mode(tmp_path: Path) -> None:
    written(tmp_path, "one\ntwo\n", "data/words.txt")
    sketch = old(
        tmp_path,
        """
        def setup():
            global words, box, value
            size(100, 100, P3D)
            with open("words.txt", "rU") as file:
                words = [line.strip() for line in file]
            box = createShape(BOX, [20, 20, 20])
            with pushMatrix():
                translate(1, 2)
            with beginClosedShape():
                vertex(0, 0)
                vertex(1, 0)
                vertex(1, 1)
            value = pow(2, 3) / 3, sq(3) / 2, round(4.5), map(5, 0, 10, 0, 1), floor(2.5)
        """,
    )

    names = play(sketch)

    assert names["words"] == ["one", "two"]
    assert names["value"] == (8 / 3, 4.5, 5.0, 0.5, 2)


def test_key_pressed_is_a_value_and_a_handler(tmp_path: Path) -> None:
    sketch = old(
        tmp_path,
        """
        seen = []
        def draw():
            seen.append(bool(keyPressed))
        def keyPressed():
            print key
        """,
    )

    assert play(sketch, 1)["seen"] == [False]


def test_mistake_names_file_line_and_text_as_they_are_on_disk(tmp_path: Path) -> None:
    sketch = old(tmp_path, "# -*- coding: utf-8 -*-\ndef draw():\n    print 'é', 5 / 2, elipse\n")

    assert mistake(sketch) == (
        "old.pyde, line 3: elipse is not defined.\n    Do you mean ellipse?\n\n"
        "     3 | print 'é', 5 / 2, elipse"
    )


def test_mistake_in_a_line_that_is_the_same_in_python_3_is_marked(tmp_path: Path) -> None:
    sketch = old(tmp_path, "def draw():\n    x = frameCount / 0\n")

    assert mistake(sketch).splitlines()[-2:] == [
        "     2 | x = frameCount / 0",
        "       |     ^^^^^^^^^^^^^^",
    ]


def test_mistake_behind_lines_that_the_conversion_adds_has_its_own_line(tmp_path: Path) -> None:
    sketch = old(tmp_path, "def f((a, b)):\n    return a\nf((1, 2))\nboom\n")

    assert mistake(sketch).startswith("old.pyde, line 4: boom is not defined.")


def test_mistake_in_a_module_names_the_module(tmp_path: Path) -> None:
    old(tmp_path, "def f():\n    print nothing\n", "helper.py")
    sketch = old(tmp_path, "import helper\nhelper.f()\n")

    assert mistake(sketch).startswith("helper.py, line 2: nothing is not defined.")


def test_syntax_error_names_the_line(tmp_path: Path) -> None:
    sketch = old(tmp_path, "def draw():\n    if x\n        print 1\n")

    assert mistake(sketch).startswith("old.pyde, line 2: This line ends with a colon in Python.")


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("add_library('peasycamera')", "The library peasycamera is not available in sketchkit"),
        ("from java.awt import Robot", "java.awt.Robot is a class of Java"),
        ("import java.util.Scanner", "java.util.Scanner is a class of Java"),
        ("from processing.video import Capture", "processing.video.Capture belongs to a part"),
    ],
)
def test_what_is_java_is_refused_with_a_sentence(tmp_path: Path, line: str, problem: str) -> None:
    assert mistake(old(tmp_path, f"{line}\n")).startswith(f"old.pyde, line 1: {problem}")


def test_library_that_is_there_already_can_be_added(tmp_path: Path) -> None:
    assert play(old(tmp_path, "add_library('pdf')\nx = PDF\n"))["x"]


def test_python_3_sketches_stay_what_they_are(tmp_path: Path) -> None:
    sketch = written(tmp_path, "x = 5 / 2\ny = range(3)\n", "new.py")

    names = play(sketch)

    assert names["x"] == 2.5
    assert isinstance(names["y"], range)


def test_files_are_watched_with_their_modules(tmp_path: Path) -> None:
    old(tmp_path, "", "helper.py")
    sketch = old(tmp_path, "import helper\n")

    with begun(sketch, Remarks()) as loop:
        names = {path.name for path in loop.program.files}

    assert names == {"old.pyde", "helper.py"}


def test_py_file_that_is_python_2_runs_as_python_mode_and_is_told_so(tmp_path: Path) -> None:
    sketch = old(tmp_path, "x = 7 / 2\nprint x\nprint -x\n", "old.py")
    remarks = Remarks()

    assert play(sketch, remarks=remarks)["x"] == 3
    ((_, line, text),) = remarks
    assert line == 2
    assert text.startswith("This is Python 2: the sketch is run as with --python-mode")
    assert "sketchkit port" in text


def test_py_file_whose_module_is_python_2_runs_as_python_mode(tmp_path: Path) -> None:
    old(tmp_path, "def half(x):\n    print x\n    print -x\n    return x / 2\n", "parts.py")
    sketch = old(tmp_path, "from parts import half\nx = half(7)\n", "old.py")
    remarks = Remarks()

    assert play(sketch, remarks=remarks)["x"] == 3
    assert remarks[0][2].startswith("parts.py, line 2, is Python 2")


def test_py_file_in_python_3_with_a_print_of_python_2_is_a_mistake(tmp_path: Path) -> None:
    sketch = old(tmp_path, "name = f'a{1}'\nprint name\n", "new.py")

    assert "Write print(...), with brackets." in mistake(sketch)
