from pathlib import Path
from textwrap import dedent

import pytest

from sketchkit.pymode.dialect import Sign, sign_of_python_2


def file(folder: Path, text: str, name: str = "old.py") -> Path:
    path = folder / name
    path.write_text(dedent(text).lstrip("\n"))
    return path


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("size(100, 100)\nprint 'ready'\nprint 'steady'\n", 2),
        ("try:\n    size(9, 9)\nexcept Exception, e:\n    print e\n", 3),
        ("if width <> 100:\n    raise Exception, width\n", 1),
        ("def f((x, y)):\n    print x\n", 1),
        ("exec 'x = 1'\nexec 'y = 1'\n", 1),
        ("for i in range(3):\n\tprint `i`\n        print i\n", 2),
    ],
    ids=["print", "except", "unequal", "tuple", "exec", "tabs"],
)
def test_what_is_python_2_alone_is_known_by_its_first_line(
    tmp_path: Path, text: str, line: int
) -> None:
    sketch = file(tmp_path, text)

    assert sign_of_python_2(sketch) == Sign(sketch, line)


@pytest.mark.parametrize(
    "text",
    [
        "print('ready')\nx = 7 / 2\n",
        "print 'a'\nprint 'b'\nprint(f'{1}')\n",
        "def f(x: int):\n    print x\n    print x\n",
        "print 'a'\nprint 'b'\nprint('c', end='')\n",
        "print 'a'\nprint 'b'\nif x\n    pass\n",
        "print 'a'\nx = 1 / 2\nprint('b')\n",
        "day = 07\n",
        "if 1:\n\tx = 1\n        y = 2\n",
        "ellipse(50, 50, 20, 20\n",
    ],
    ids=[
        "both",
        "f-string",
        "annotation",
        "print function",
        "broken",
        "slip",
        "octal",
        "tabs",
        "bracket",
    ],
)
def test_python_3_with_or_without_a_mistake_is_not_taken_for_it(tmp_path: Path, text: str) -> None:
    assert sign_of_python_2(file(tmp_path, text)) is None


def test_a_module_that_is_imported_tells_too(tmp_path: Path) -> None:
    ball = file(tmp_path, "def show():\n    print 'ball'\n    print 'shown'\n", "ball.py")
    file(tmp_path, "from ball import show\n", "game.py")

    assert sign_of_python_2(file(tmp_path, "import game\n")) == Sign(ball, 2)


def test_a_module_that_nobody_imports_does_not(tmp_path: Path) -> None:
    file(tmp_path, "print 'a'\nprint 'ball'\n", "ball.py")

    assert sign_of_python_2(file(tmp_path, "import math\n")) is None
