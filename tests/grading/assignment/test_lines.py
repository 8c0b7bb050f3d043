import pytest

from sketchkit.grading.assignment.lines import Path, line_of

TEXT = """\
# a comment
title = "A"
[limits]
memory_mb = 64

[[checks]]
kind = "image"
curve = [
  [1, 1.0],  # [[checks]]
  [2, 0.0],
]
[[checks]]
expect = \"\"\"
kind = "no key"
\"\"\"
kind = "trace"
kinds = { box = 1,  rect = 0 }
[checks.shader]
uniform = "time"
"""


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("title",), 2),
        (("limits",), 3),
        (("limits", "memory_mb"), 4),
        (("checks", 0), 6),
        (("checks", 0, "curve"), 8),
        (("checks", 0, "curve", 1), 8),
        (("checks", 1), 12),
        (("checks", 1, "kind"), 16),
        (("checks", 1, "kinds", "rect"), 17),
        (("checks", 1, "shader", "uniform"), 19),
    ],
)
def test_line_in_which_a_value_begins(path: Path, line: int) -> None:
    assert line_of(TEXT, path) == line


@pytest.mark.parametrize(
    ("path", "line"),
    [(("checks", 0, "points"), 6), (("limits", "cpu_s"), 3), (("checks", 7), 6)],
)
def test_what_is_missing_is_missed_where_it_belongs(path: Path, line: int) -> None:
    assert line_of(TEXT, path) == line


@pytest.mark.parametrize("path", [(), ("points",)])
def test_whole_file_has_no_line(path: Path) -> None:
    assert line_of(TEXT, path) is None
