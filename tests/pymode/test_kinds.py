import ast
from textwrap import dedent

import pytest

from sketchkit.pymode.kinds import Kinds


def kind_of_result(text: str) -> str:
    """Return the kind of what `result` is in the last line of a text."""
    tree = ast.parse(dedent(text))
    kinds = Kinds([tree])
    last = [node for node in ast.walk(tree) if isinstance(node, ast.Assign)]
    (value,) = [
        node.value
        for node in last
        if isinstance(node.targets[0], ast.Name) and node.targets[0].id == "result"
    ]
    return kinds.of(value)


@pytest.mark.parametrize(
    ("expression", "kind"),
    [
        ("3", "int"),
        ("2.5", "float"),
        ("width", "int"),
        ("PI", "float"),
        ("width * 2 + mouseX", "int"),
        ("width * 0.5", "float"),
        ("7 / 2", "int"),
        ("7 / 2.0", "float"),
        ("int(random(5))", "int"),
        ("random(5)", "float"),
        ("len(x)", "int"),
        ("max(1, width)", "int"),
        ("max(1, 2.0)", "?"),
        ("1 if a else 2", "int"),
        ("1 if a else 2.0", "?"),
        ("unknown(3)", "?"),
        ("range(5)[2]", "int"),
        ("[i * 2 for i in range(4)][0]", "int"),
        ("v.x", "?"),
    ],
)
def test_kind_of_an_expression(expression: str, kind: str) -> None:
    assert kind_of_result(f"result = {expression}") == kind


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        pytest.param("x = 1\nx = 2\nresult = x", "int", id="two whole numbers"),
        pytest.param("x = 1\nx = 2.5\nresult = x", "?", id="two kinds"),
        pytest.param("x = 1\nx += 0.5\nresult = x", "?", id="changed in place"),
        pytest.param("def f(a):\n    result = a\nf(1)\nf(2)", "int", id="all callers agree"),
        pytest.param("def f(a):\n    result = a\nf(1)\nf(2.5)", "?", id="callers differ"),
        pytest.param("def f(a):\n    result = a", "?", id="no caller"),
        pytest.param("def f(a=3):\n    result = a", "int", id="default"),
        pytest.param("def f():\n    return 3\nresult = f()", "int", id="return"),
        pytest.param("n = 1\ndef f():\n    result = n", "int", id="variable of the file"),
        pytest.param(
            "n = 1\ndef f():\n    n = 2.5\nresult = n", "int", id="variable of a function"
        ),
        pytest.param(
            "n = 1\ndef f():\n    global n\n    n = 2.5\nresult = n", "?", id="shared variable"
        ),
        pytest.param("def f():\n    for i in range(9):\n        result = i", "int", id="loop"),
        pytest.param("a = []\na.append(3)\nresult = a[0]", "int", id="list that grows"),
        pytest.param("a, b = 1, 2.5\nresult = a", "int", id="pair"),
        pytest.param(
            "class C:\n    def __init__(self, n):\n        self.n = n\nc = C(4)\nresult = c.n",
            "int",
            id="attribute",
        ),
        pytest.param(
            "class C:\n    def __init__(self):\n        self.x = 1\nv = PVector()\nresult = v.x",
            "?",
            id="a vector's x is a float",
        ),
    ],
)
def test_kinds_follow_names(text: str, kind: str) -> None:
    assert kind_of_result(text) == kind
