"""Tokens put together are the text again, and each knows where it stands."""

from hypothesis import given
from hypothesis import strategies as st

from sketchkit.glsl.tokens import Kind, code_of, directives, next_code, text_of, tokenize

PIECES = st.sampled_from(
    ["//", "/*", "*/", "\n", "\r\n", "\\\n", "#define ", "#", " ", "texture", "1.5e-3", ".5", '"']
)


@given(st.text())
def test_any_text_is_the_sum_of_its_tokens(text):
    assert text_of(tokenize(text)) == text


@given(st.lists(PIECES).map("".join))
def test_any_mix_of_comments_and_directives_is_the_sum_of_its_tokens(text):
    tokens = tokenize(text)

    assert text_of(tokens) == text
    assert all(token.text for token in tokens)


@given(st.lists(PIECES).map("".join))
def test_line_of_a_token_counts_the_ends_of_lines_before_it(text):
    before = ""
    for token in tokenize(text):
        assert token.line == before.replace("\r\n", "\n").count("\n") + 1
        before += token.text


def test_words_of_comments_are_no_code():
    code = code_of(tokenize("float a; // float b\n/* float\n c; */ int d;"))

    assert [token.text for token in code] == ["float", "a", ";", "int", "d", ";"]
    assert code[-1].line == 3


def test_directive_goes_on_after_a_backslash():
    tokens = tokenize("#define A \\\n  texture2D\nfloat")

    assert [token.directive for token in tokens if token.kind is Kind.NAME] == ["define"] * 3 + [""]


def test_sign_within_a_line_is_no_directive():
    assert all(not token.directive for token in tokenize("a # b"))


def test_each_directive_is_a_line_of_code():
    found = directives(tokenize("#version 330\n  # define N 8 // eight\nint a;\n#endif"))

    assert [[token.text for token in line] for line in found] == [
        ["version", "330"],
        ["define", "N", "8"],
        ["endif"],
    ]


def test_next_code_skips_comments_and_ends_with_its_directive():
    tokens = tokenize("#define T texture\n(a /* b */ (")
    by_text = {token.text: place for place, token in enumerate(tokens)}

    assert next_code(tokens, by_text["texture"]) == ""
    assert next_code(tokens, by_text["a"]) == "("


def test_column_counts_from_the_start_of_the_line():
    assert [(t.text, t.column) for t in code_of(tokenize("a\n  b c"))] == [
        ("a", 0),
        ("b", 2),
        ("c", 4),
    ]
