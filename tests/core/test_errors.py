"""Messages are compared in full: their wording is what students read."""

import pytest

from sketchkit.core.errors import SketchError, either, nearest, shown, wrong_numbers


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


@pytest.mark.parametrize(
    ("args", "name"),
    [
        (("a", 2), "x"),
        ((1, 2, "a"), "z"),
        ((1, 2, 3, "a"), "v"),
        ((1, 2, 3, 4, "a"), "number 5"),
    ],
    ids=["without the optional part", "the optional part", "the other form", "no form"],
)
def test_argument_is_named_by_the_form_of_its_count(args, name):
    error = wrong_numbers("f", args, "x, y [, z] | x, y, u, v", (2, 3, 4, 5))

    assert f"text for {name}: f(" in error.got


def test_what_may_be_something_else_than_a_number_is_passed_over():
    error = wrong_numbers("text", ("a", 1, "b"), "text, x, y")

    assert error.problem == "text() takes 3 values: text, x, y."
    assert error.got == "text for y: text('a', 1, 'b')"


def test_constants_are_listed():
    error = wrong_numbers("f", ("A",), "A | B | C_D")

    assert error.message == "f() takes A, B or C_D.\n    Got f('A')."


def test_number_that_is_too_large_is_the_problem():
    error = wrong_numbers("f", (1, -1e40), "x, y")

    assert error.problem == "A number for f() is too large: 3.4e38 is the most."
    assert error.got == "-1e+40 for y: f(1, -1e+40)"


@pytest.mark.parametrize(
    ("choices", "sentence"), [((1,), "1"), ((1, 2), "1 or 2"), ((1, 2, 3), "1, 2 or 3")]
)
def test_either_lists_choices(choices, sentence):
    assert either(choices) == sentence


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
