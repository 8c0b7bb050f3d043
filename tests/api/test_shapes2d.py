"""Flat shapes check what they are given in the call itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from sketchkit.backends.listing import ListingBackend
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.report import StoppedError
from tests.canvases import drawn, draws, fills


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.rect("10", 20, 30, 40), "text for x"),
        (lambda g: g.rect(10, None, 30, 40), "None for y"),
        (lambda g: g.rect(10, 20, 30, 40, 1, 2), "Got 6"),
        (lambda g: g.rect([10], 20, 30, 40), "list"),
        (lambda g: g.line(1, 2, 3, "4"), "text for y2"),
        (lambda g: g.ellipse(1, 2, "3"), "text for width"),
        (lambda g: g.arc(1, 2, 3, 4, "0", 1), "text for start"),
        (lambda g: g.arc(1, 2, 3, 4, 0, 1, "PIE"), "text for mode"),
        (lambda g: g.rect(10, 20, 30, 40, 1, 2, 3, "4"), "text for bl"),
        (lambda g: g.point("1", 2), "text for x"),
        (lambda g: g.triangle(1, 2, 3, 4, 5, "6"), "text for y3"),
        (lambda g: g.quad(1, 2, 3, 4, 5, 6, 7, None), "None for y4"),
        (lambda g: g.square(1, 2, "3"), "text for side: square(1, 2, '3')"),
        (lambda g: g.circle(1, 2, "3"), "text for diameter: circle(1, 2, '3')"),
        (lambda g: g.bezier(1, 2, 3), "Got 3"),
    ],
)
def test_number_that_is_none_is_named(flat, call, message):
    with pytest.raises(SketchError) as caught:
        call(flat)

    assert message in str(caught.value)


def test_refused_call_draws_nothing(flat):
    with pytest.raises(SketchError):
        flat.rect(10, 20, 30, "40")

    assert draws(drawn(flat)) == []


def test_text_that_is_a_number_gets_a_hint(flat):
    with pytest.raises(SketchError, match=r"float\('40'\) makes a number of it"):
        flat.rect(10, 20, 30, "40")


@pytest.mark.parametrize(
    "call",
    [
        lambda g: g.point(1e40, 2),
        lambda g: g.line(1e40, 2, 3, 4),
        lambda g: g.rect(-1e40, 2, 3, 4),
        lambda g: g.rect(10**50, 2, 3, 4),
        lambda g: g.circle(1, 2, 1e40),
        lambda g: g.triangle(1e40, 2, 3, 4, 5, 6),
    ],
    ids=["point", "line", "rect", "whole number", "circle", "triangle"],
)
def test_shape_with_a_number_beyond_java_floats_is_told_of_and_does_not_show(flat, call):
    with pytest.warns(SketchWarning, match=r"A number for \w+\(\) is too large"):
        call(flat)

    assert draws(drawn(flat)) == []


@pytest.mark.parametrize("count", [1024, 1025, 5000])
def test_any_number_of_shapes_is_recorded(flat, count):
    flat.noStroke()
    for _ in range(count):
        flat.rect(0, 0, 1, 1)

    assert len(fills(flat).positions) == 4 * count


def message_of(tmp_path: Path, line: str) -> str:
    """Return what is told when a sketch has this line."""
    path = tmp_path / "wrong.py"
    path.write_text(f"{line}\n", encoding="utf-8")
    with pytest.raises(StoppedError) as caught:
        list(render(Launch(path, tell=print), [0], ListingBackend()))
    return caught.value.report.message


def test_rect_with_three_numbers_tells_how_many_it_takes(tmp_path):
    message = message_of(tmp_path, "rect(10, 20, 30)")

    assert "rect() takes 4, 5 or 8 numbers: x, y, width, height" in message
    assert "Got 3: rect(10, 20, 30)" in message
    assert "square(10, 20, 30)" in message


@pytest.mark.parametrize(
    ("line", "takes"),
    [
        ("line(1, 2, 3)", "4 or 6 numbers: x1, y1, x2, y2, or x1, y1, z1, x2, y2, z2"),
        ("arc(1, 2, 3, 4)", "6 or 7 numbers: x, y, width, height, start, stop [, mode]"),
        ("rotate()", "1 or 4 numbers: angle, or angle, x, y, z"),
        ("scale()", "1, 2 or 3 numbers: factor, or x, y [, z]"),
        ("translate(1)", "2 or 3 numbers: x, y [, z]"),
        ("box()", "1 or 3 numbers: size, or width, height, depth"),
        ("fill()", "1, 2, 3 or 4 numbers: gray [, alpha], or red, green, blue [, alpha]"),
        (
            "text('a')",
            "3, 4, 5 or 6 values: text, x, y [, z], or text, x, y, width, height, or characters,",
        ),
        ("rectMode()", "CORNER, CORNERS, RADIUS or CENTER"),
        ("lights(3)", "nothing between its brackets"),
        ("beginShape(5000)", "POINTS, LINES, TRIANGLES, TRIANGLE_STRIP"),
        ("random('a')", "1 or 2 numbers: high, or low, high, or list"),
    ],
)
def test_report_says_what_a_function_takes(tmp_path, line, takes):
    assert message_of(tmp_path, line).startswith(f"{line.partition('(')[0]}() takes {takes}")


@pytest.mark.parametrize(
    ("line", "count"),
    [
        ("line(1, 2, 3)", 3),
        ("ellipse(1, 2)", 2),
        ("triangle(1, 2, 3, 4)", 4),
        ("quad(1, 2, 3, 4)", 4),
        ("point(1)", 1),
        ("circle(1, 2)", 2),
    ],
)
def test_too_few_numbers_are_counted(tmp_path, line, count):
    message = message_of(tmp_path, line)

    assert message.startswith(f"{line.partition('(')[0]}() takes ")
    assert f"Got {count}: {line}" in message
