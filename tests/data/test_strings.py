"""Expected texts were measured with Processing, but for the differences that a test names."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.data import strings


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        ((7,), "7"),
        ((2.5,), "2.5"),
        ((2.0,), "2"),
        ((-0.0,), "0"),
        ((3.14159,), "3.14159"),
        ((1234567.891,), "1234567.9"),
        ((1e10,), "1.0E10"),
        ((0.0005,), "5.0E-4"),
        ((0, 3), "000"),
        ((-7, 5), "-00007"),
        ((123456, 3), "123456"),
        ((3.7, 3), "003"),
        ((-3.7, 3), "-003"),
        ((0, 0), "0"),
        ((3.14159, 1, 2), "3.14"),
        ((3.14159, 4, 1), "0003.1"),
        ((3.14159, 0, 0), "3.142"),
        ((2.0, 1, 0), "2"),
        ((7, 4, 2), "0007.00"),
        ((0.5, 0, 2), "0.50"),
        ((0.125, 1, 2), "0.12"),
        ((0.375, 1, 2), "0.38"),
        ((2.675, 1, 2), "2.67"),
        ((1.115, 1, 2), "1.12"),
        ((99.995, 4, 2), "0100.00"),
        ((-0.001, 1, 2), "-0.00"),
        ((-12.3456, 4, 2), "-0012.35"),
        ((1234567.891, 0, 2), "1234567.88"),
        ((float("inf"), 4, 2), "\u221e"),
        ((float("-inf"), 4, 2), "-\u221e"),
        ((float("nan"), 4, 2), "NaN"),
    ],
    ids=str,
)
def test_nf_counts_digits(args, expected):
    assert strings.nf(*args) == expected


def test_nf_keeps_whole_numbers_exact_where_processing_has_32_bits():
    assert strings.nf(1234567890, 1, 1) == "1234567890.0"


@pytest.mark.parametrize(("number", "expected"), [(7, " 007"), (-7, "-007"), (0, " 000")], ids=str)
def test_nfs_leaves_room_for_a_sign(number, expected):
    assert strings.nfs(number, 3) == expected


@pytest.mark.parametrize(
    ("number", "expected"), [(1.5, "+001.50"), (-1.5, "-001.50"), (-0.0, "+-000.00")], ids=str
)
def test_nfp_shows_every_sign(number, expected):
    assert strings.nfp(number, 3, 2) == expected


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        ((1234567,), "1,234,567"),
        ((-1234.5,), "-1,234"),
        ((1234567.891, 2), "1,234,567.88"),
        ((1234567.891, 0), "1,234,567.875"),
        ((42, 1), "42.0"),
    ],
    ids=str,
)
def test_nfc_sets_commas(args, expected):
    assert strings.nfc(*args) == expected


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        ((255,), "000000FF"),
        ((-1,), "FFFFFFFF"),
        ((0xFFAA0000,), "FFAA0000"),
        ((65535, 2), "FF"),
        ((-1, 4), "FFFF"),
        (("A",), "0041"),
    ],
    ids=str,
)
def test_hex_shows_the_last_digits(args, expected):
    assert strings.hex(*args) == expected


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        ((5, 8), "00000101"),
        ((255, 4), "1111"),
        ((-1,), "1" * 32),
        (("A",), "0000000001000001"),
    ],
    ids=str,
)
def test_binary_shows_the_last_digits(args, expected):
    assert strings.binary(*args) == expected


@given(st.integers(0, 0xFFFFFFFF))
def test_unhex_and_unbinary_undo_hex_and_binary(number):
    assert strings.unhex(strings.hex(number)) == number
    assert strings.unbinary(strings.binary(number)) == number


def test_join_takes_whatever_can_be_printed():
    assert strings.join(["a", 1, 2.5], ", ") == "a, 1, 2.5"


@pytest.mark.parametrize(
    ("text", "delimiter", "pieces"),
    [
        ("a,,c,", ",", ["a", "", "c", ""]),
        ("", ",", [""]),
        ("a::b", "::", ["a", "b"]),
        ("a b  c", " ", ["a", "b", "", "c"]),
    ],
)
def test_split_keeps_empty_pieces(text, delimiter, pieces):
    assert strings.split(text, delimiter) == pieces


@pytest.mark.parametrize(
    ("text", "pieces"),
    [("a b  c\td\n", ["a", "b", "c", "d"]), ("a\u00a0b", ["a", "b"]), ("  ", [])],
    ids=["blanks", "no-break space", "nothing"],
)
def test_split_tokens_drops_empty_pieces(text, pieces):
    assert strings.split_tokens(text) == pieces


def test_split_tokens_takes_each_character_as_a_delimiter():
    assert strings.split_tokens("a, b;c]d", " ,;]") == ["a", "b", "c", "d"]


@pytest.mark.parametrize("text", ["  a b \n", "\u00a0a b\u00a0", "\ufeffa b", "\x01a b\x02"])
def test_trim_takes_away_what_cannot_be_seen(text):
    assert strings.trim(text) == "a b"


@pytest.mark.parametrize(
    ("text", "pattern", "groups"),
    [
        ("a <tag>, here", "<(.*?)>", ["<tag>", "tag"]),
        ("abc", "(x)?b", ["b", None]),
        ("a\nb", "^b$", ["b"]),
        ("a\nb", "a.b", ["a\nb"]),
        ("abc", "(?<middle>b)", ["b", "b"]),
        ("abc", "x", None),
    ],
    ids=["group", "unused group", "line start", "any character", "Java's group name", "none"],
)
def test_match_returns_the_match_and_its_groups(text, pattern, groups):
    assert strings.match(text, pattern) == groups


def test_match_all_returns_each_match():
    assert strings.match_all("a1b22", r"([a-z])(\d+)") == [["a1", "a", "1"], ["b22", "b", "22"]]


def test_match_all_without_a_match_is_none():
    assert strings.match_all("abc", "x") is None
