import pytest

from sketchkit.runtime.frame_numbers import parse_frames


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("3", (3,)),
        ("1,30", (1, 30)),
        ("30, 1", (1, 30)),
        ("1-4", (1, 2, 3, 4)),
        ("1-10:5", (1, 6)),
        ("0-20:10,3,3", (0, 3, 10, 20)),
    ],
)
def test_frames_that_are_meant(text: str, numbers: tuple[int, ...]) -> None:
    assert parse_frames(text) == numbers


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "none of 3, 1,30"),
        ("one", "none of"),
        ("-1", "none of"),
        ("1..5", "none of"),
        ("1,", "none of"),
        ("5-1", "empty range"),
        ("1-5:0", "empty range"),
        ("1-9999999999", "more than 100,000"),
    ],
)
def test_frames_that_mean_nothing(text: str, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        parse_frames(text)
