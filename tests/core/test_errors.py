"""Messages are compared in full: their wording is what students read."""

import pytest

from sketchkit.core.errors import SketchError, nearest, shown, wrong_numbers


def test_message_of_a_problem_alone_is_one_line():
    assert SketchError("No such colour.").message == "No such colour."


def test_message_joins_problem_what_was_got_and_a_hint():
    error = SketchError("sq() takes 1 number: n.", got="2: sq(1, 2)", hint="Write pow(1, 2).")

    assert error.message == "sq() takes 1 number: n.\n    Got 2: sq(1, 2).  Write pow(1, 2)."


def test_hint_alone_stands_on_the_second_line():
    assert SketchError("No.", hint="Write yes.").message == "No.\n    Write yes."


def test_text_of_the_exception_is_its_message():
    error = SketchError("No.", got="1")

    assert str(error) == error.message


def test_wrong_count_names_the_counts_that_are_given():
    error = wrong_numbers("rect", (10, 20, 30), "x, y, width, height [, radii]", (4, 5, 8))

    assert error.message == (
        "rect() takes 4, 5 or 8 numbers: x, y, width, height [, radii].\n"
        "    Got 3: rect(10, 20, 30)."
    )


@pytest.mark.parametrize(
    ("usage", "counts"),
    [
        ("n", "1 number:"),
        ("x, y [, z]", "2 or 3 numbers:"),
        ("x [, y] [, z]", "1, 2 or 3 numbers:"),
        ("a, b | list", "1 or 2 numbers:"),
        ("", "0 numbers:"),
    ],
)
def test_counts_are_read_from_the_usage(usage, counts):
    assert counts in wrong_numbers("f", (0,) * 9, usage).problem


@pytest.mark.parametrize(
    ("value", "got", "hint"),
    [
        ("30", "text for y: f(1, '30')", "float('30') makes a number of it."),
        ("thirty", "text for y: f(1, 'thirty')", None),
        (None, "None for y: f(1, None)", "A function that ends without return gives None."),
        (abs, "a function for y: f(1, abs)", "Is there a pair of brackets missing?"),
        ({}, "a dict for y: f(1, {})", None),
    ],
    ids=["digits", "words", "None", "function", "dict"],
)
def test_wrong_kind_names_the_argument(value, got, hint):
    error = wrong_numbers("f", (1, value), "x, y")

    assert (error.got, error.hint) == (got, hint)


def test_shown_numbers_are_short():
    assert shown(10 / 3) == "3.3333"


def test_shown_text_is_cut_in_the_middle():
    assert len(shown("x" * 1000)) <= 40


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("elipse", "ellipse"),
        ("push_matrix", "pushMatrix"),
        ("PushMatrix", "pushMatrix"),
        ("zebra", None),
    ],
)
def test_nearest_finds_what_was_meant(name, found):
    assert nearest(name, ["ellipse", "pushMatrix", "rect"]) == found
