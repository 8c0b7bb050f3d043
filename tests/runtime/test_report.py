"""Broken sketches, and what their authors are told."""

from pathlib import Path

import pytest

from sketchkit.runtime.report import StoppedError, reporting
from tests.runtime.sketches import mistake, play, written


def case(name: str, text: str, *parts: str) -> object:
    return pytest.param(text, parts, id=name)


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        case(
            "misspelt function",
            "def draw():\n    elipse(10, 20, 30, 40)\n",
            "sketch.py, line 2: elipse is not defined.",
            "Do you mean ellipse?",
            "2 | elipse(10, 20, 30, 40)",
            "| ^^^^^^",
        ),
        case("misspelt constant", "x = HALFPI", "Do you mean HALF_PI?"),
        case("snake case", "push_matrix()", "Do you mean pushMatrix?"),
        case("misspelt variable", "petals = 3\nprint(petels)", "line 2", "Do you mean petals?"),
        case("word of Java", "x = true", "line 1: true is not defined.", "Write True in Python."),
        case("class of Java", 'n = Integer.parseInt("3")', "Integer is not", "Write int(...)"),
        case("older Processing", "x = screenWidth", "Write displayWidth."),
        case("library of Processing", 's = SoundFile(this, "a.wav")', "pip install sounddevice"),
        case("word of Processing that is not here", "x = sketchRenderer()", "Write isGL(), is2D()"),
        case(
            "own variable with a name of Processing's",
            "def setup():\n    edge = 3\ndef draw():\n    circle(edge, 1, 1)\n",
            "belongs to setup() alone",
        ),
        case(
            "variable of another function",
            "def setup():\n    x = 3\ndef draw():\n    circle(x, 1, 1)\n",
            "line 4: x is not defined here: it belongs to setup() alone.",
            "Write global x as the first line of setup()",
        ),
        case("used above its value", "print(x)\nx = 3", "it gets its value in line 2"),
        case(
            "global forgotten",
            "angle = 0\ndef draw():\n    angle += 0.1\n",
            "line 3: angle is set in draw()",
            "Write global angle as the first line of draw().",
        ),
        case(
            "live value set in a function",
            "def draw():\n    width = width / 2\n",
            "hides sketchkit's width",
            "Give your variable another name.",
        ),
        case("only in an if", "def f():\n    if 0:\n        y = 1\n    y\nf()", "no value yet"),
        case(
            "variable hides a function",
            "fill = 3\ndef draw():\n    fill(255)\n",
            "line 3: fill is your own variable here, and hides the function fill().",
            "Got fill = 3.",
            "variable of line 1",
        ),
        case("local variable hides", "def f():\n    rect = 1\n    rect(1, 2)\nf()", "hides"),
        case("variable hides Python's", "list = [1]\nlist(3)", "hides the function list()"),
        case(
            "module hides a function",
            "import random\nrandom(10)",
            "random is the module random here, and hides the function random().",
        ),
        case("value called", "circle(mouseX(), 1, 1)", "Write mouseX without brackets."),
        case("flag called", "keyPressed()", "keyPressed is a value"),
        case("list called", "a = [1]\na(0)", "a is a list", "a[...]"),
        case("number called", "x = 3\nx(4)", "x is a whole number, not a function."),
        case(
            "too few arguments",
            "def draw():\n    rect(10, 20, 30)\n",
            "line 2: rect() takes 4, 5 or 8 numbers: x, y, width, height",
            "Got 3: rect(10, 20, 30).  For a square write square(10, 20, 30).",
        ),
        case("too many arguments", "radians(1, 2)", "radians() takes 1 number", "Got 2"),
        case("text for a number", "rect(1, 'a', 3, 4)", "text for y"),
        case("unknown argument", "rect(1, 2, 3, 4, colour=3)", "no argument called colour"),
        case(
            "own function",
            "def tree(n, m):\n    pass\ntree(1)",
            "line 3: tree() takes 2 values: n, m.",
            "Got 1: tree(1).",
            "defined in line 1",
        ),
        case(
            "function of a module hides",
            "from math import *\ndist(1, 2, 3, 4)",
            "dist() takes 2 values.",
            "This is dist() of math; it hides sketchkit's.",
        ),
        case("method", "v = PVector(1, 2)\nv.cross()", "v.cross() takes", "Got 0"),
        case(
            "called from elsewhere",
            "def a():\n    b()\ndef b():\n    rect(1)\ndef draw():\n    a()\n",
            "line 4",
            "b() was called at sketch.py, line 2",
            "a() was called at sketch.py, line 6",
        ),
        case("text plus number", "x = 3\nprint('a' + x)", "+ does not work", "str(...)"),
        case("None plus number", "x = None\ny = x + 1", "between None and a whole number"),
        case("function in sum", "x = rect * 2", "pair of brackets missing"),
        case("comparison", "'a' < 3", "< does not work between text and a whole number"),
        case("fraction for a count", "for i in range(5 / 2):\n    pass", "whole numbers", "//"),
        case("fraction as index", "a = [1]\na[0.5]", "counted with whole numbers"),
        case("index beyond", "a = [1, 2]\ni = 2\na[i]", "2 items, a[0] to a[1]", "Got a[2]."),
        case("index of nothing", "a = []\na[0]", "a is empty"),
        case("key", "a = {'left': 1}\na['lefft']", "no key 'lefft'", "'left'?"),
        case("attribute", "v = PVector(1, 2)\nv.nomalize()", "no nomalize", "normalize?"),
        case("attribute of Java", "a = [1]\na.length", "Python writes len(...)."),
        case("attribute of an image", "createImage(2, 2, RGB).isModified()", "updatePixels()"),
        case("attribute of a matrix", "PMatrix3D().n10", "Write m10 and m30."),
        case("attribute of the sketch", "this.sketchWidth()", "Write width."),
        case("misspelt attribute of the sketch", "this.elipse(1, 2, 3, 4)", "Do you mean ellipse?"),
        case("call of OpenGL", "beginPGL().cullFace(1)", "PGL has no cullFace", "Leave it out"),
        case("constant of OpenGL", "PGL.DEPTH_TEST", "hint(DISABLE_DEPTH_TEST)"),
        case("attribute of None", "v = fill(3)\nv.x", "v is None, and None has no x."),
        case("no such child", "XML('a').getChild('b').trim()", "gives None where it finds nothing"),
        case(
            "own function without return",
            "def getChild():\n    pass\ngetChild().x",
            "function that should have given a value without a return",
        ),
        case("module not imported", "random.random()", "write import random"),
        case("no module", "import nump", "no module nump", "numpy?"),
        case("module of Java", "import processing.sound", "needs no import here"),
        case("no name in module", "from math import sine", "no sine"),
        case("division", "n = 0\n1 / n", "divided by zero: n is 0 here"),
        case("conversion of a list", "int(['1', '2'])", "not a list", "parseInt(...) makes"),
        case("conversion of None", "float(None)", "takes one text or number, not None."),
        case("conversion", "int('a')", "'a' is no whole number.", "parseInt(...) gives 0"),
        case("conversion of a fraction", "int('3.9')", "parseInt(...) takes it, without its"),
        case("conversion to a fraction", "float('a')", "'a' is no number.", "parseFloat(...)"),
        case("unpacking", "a, b = 3", "several names before the =, but only one value"),
        case("not iterable", "for i in 10:\n    pass", "for i in range(10):"),
        case("subscript of a number", "x = 3\nx[0]", "x is a whole number: it has no items"),
        case("no file", "open('no.txt')", "no file 'no.txt'"),
        case("recursion", "def f():\n    f()\nf()", "calls itself again and again", "times"),
        case("memory", "raise MemoryError", "not enough memory"),
        case("Ctrl+C", "raise KeyboardInterrupt", "Stopped by Ctrl+C"),
        case("assert", "assert width == 3, 'too narrow'", "too narrow"),
        case("an error of its own", "raise RuntimeError('boo')", "RuntimeError: boo"),
        case("popMatrix", "popMatrix()", "popMatrix() without pushMatrix()"),
        case("vertex", "vertex(1, 2)", "vertex() belongs between beginShape() and endShape()"),
        case("bad size", "size(0, 100)", "at least 1", "size(0, 100)"),
        case("size without height", "size(100)", "size() takes 2 or 3 values", "Got 1: size(100)."),
        case("renderer in quotes", "size(9, 9, 'P3D')", "without quotes"),
    ],
)
def test_mistake(tmp_path: Path, text: str, parts: tuple[str, ...]) -> None:
    told = mistake(written(tmp_path, text))

    for part in parts:
        assert part in told
    assert "sketchkit/" not in told


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        case("colon", "def setup()\n    pass\n", "line 1: This line ends with a colon"),
        case("no block", "def setup():\npass\n", "line 2", "must be indented"),
        case("indent", "x = 1\n  y = 2\n", "line 2: This line is indented"),
        case("dedent", "if 1:\n    x = 1\n  y = 2\n", "line 3", "begin at the same place"),
        case("tabs", "if 1:\n        x = 1\n\ty = 2\n", "line 3: Tabs and spaces"),
        case("bracket", "rect(1, 2\nfill(3)\n", "line 1: The ( here is never closed."),
        case("two brackets", "rect(1, 2))\n", "a ) too many"),
        case("wrong bracket", "x = (1]\n", "( is closed by ]"),
        case("quote", "text('a, 1, 2)\n", "line 1: The text that begins here has no end."),
        case("one =", "if width = 3:\n    pass\n", "To compare write ==."),
        case("comma", "x = [1 2]\n", "Perhaps a comma."),
        case("digit first", "x = 2\ny = 3x\n", "write *"),
        case("curly quote", "text(\u201ca\u201d, 1, 2)\n", "Quotation marks are straight"),
        case("late global", "def f():\n    x = 1\n    global x\n", "first line of the function"),
        case("return outside", "return 3\n", "return stands outside"),
        case("assignment to a call", "f() = 3\n", "on the left of ="),
        case("print of Python 2", "print 'hello'\n", "Write print(...), with brackets."),
        case("except of Python 2", "try:\n    x\nexcept E, e:\n    pass\n", "except Error as e:"),
        case("void", "void setup() {\n}\n", "Python writes def setup():"),
        case("typed variable", "int x = 3;\n", "Write x = and its first value."),
        case("PVector variable", "PVector v = PVector(1, 2)\n", "no type in front"),
        case("for of Java", "for (int i = 0; i < 3; i++) {\n}\n", "for i in range(10):"),
        case("&&", "x = 1 && 2\n", "Write and."),
        case("||", "x = 1 || 2\n", "Write or."),
        case("!", "x = !y\n", "Write not."),
        case("++", "i = 0\ni++\n", "Write i += 1."),
        case("new", "v = new PVector(1, 2)\n", "Write PVector(...)."),
        case("else if", "if 1:\n    x = 1\nelse if 2:\n    x = 2\n", "Write elif."),
        case("comment", "// hello\n", "A comment begins with #."),
        case("brace", "if x > 3 {\n    y\n}\n", "no braces"),
        case("? :", "x = 1 > 2 ? 3 : 4\n", "a if condition else b"),
    ],
)
def test_what_python_cannot_read(tmp_path: Path, text: str, parts: tuple[str, ...]) -> None:
    told = mistake(written(tmp_path, text))

    for part in parts:
        assert part in told


def test_ampersands_in_a_text_are_no_java(tmp_path: Path) -> None:
    assert "and." not in mistake(written(tmp_path, "x = 'a && b' 3\n"))


@pytest.mark.parametrize("data", ["size(9, 9)".encode("utf-16"), b"x = '\xfc'"])
def test_file_that_is_no_utf8(tmp_path: Path, data: bytes) -> None:
    sketch = tmp_path / "sketch.py"
    sketch.write_bytes(data)

    assert "not written in UTF-8" in mistake(sketch)


def test_mistake_in_a_sibling_module_is_told_in_its_file(tmp_path: Path) -> None:
    written(tmp_path, "def look():\n    elipse(1, 2, 3, 4)\n", "helpers.py")

    told = mistake(written(tmp_path, "import helpers\nhelpers.look()"))

    assert told.startswith("helpers.py, line 2: elipse is not defined.")
    assert "look() was called at sketch.py, line 2" in told


def test_syntax_of_a_sibling_module_is_told_in_its_file(tmp_path: Path) -> None:
    written(tmp_path, "x = (1\n", "helpers.py")

    told = mistake(written(tmp_path, "import helpers"))

    assert told.startswith("helpers.py, line 1: The ( here")


def test_marks_stand_under_the_part_that_is_meant(tmp_path: Path) -> None:
    told = mistake(written(tmp_path, "if True:\n    x = 'gr\u00fcn' + nothing\n"))

    source, marks = told.splitlines()[-2:]

    assert source == "     2 | x = 'gr\u00fcn' + nothing"
    assert marks == "       |              ^^^^^^^"


def test_traceback_is_kept_for_those_who_want_it(tmp_path: Path) -> None:
    with pytest.raises(StoppedError) as stopped:
        play(written(tmp_path, "1 / 0"))

    assert "ZeroDivisionError" in stopped.value.report.traceback


def test_failure_of_sketchkit_is_not_blamed_on_the_sketch(tmp_path: Path) -> None:
    with pytest.raises(StoppedError, match="not your mistake"), reporting(tmp_path / "sketch.py"):
        raise KeyError("ours")
