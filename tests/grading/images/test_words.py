import pytest

from sketchkit.grading.images.words import color, direction, percent, place


@pytest.mark.parametrize(
    ("share", "words"),
    [
        (1, "100 %"),
        (0.99999, "99.9 %"),
        (0.4126, "41.3 %"),
        (0.00001, "less than 0.1 %"),
        (0, "0 %"),
    ],
)
def test_share(share: float, words: str) -> None:
    assert percent(share) == words


@pytest.mark.parametrize(
    ("box", "words"),
    [
        ((0, 0, 10, 10), "at the left top"),
        ((45, 45, 10, 10), "in the middle"),
        ((90, 45, 10, 10), "at the right"),
        ((40, 90, 20, 10), "at the bottom"),
        ((0, 0, 100, 100), "in the middle"),
    ],
)
def test_place(box: tuple[int, int, int, int], words: str) -> None:
    assert place(box, 100, 100) == words


@pytest.mark.parametrize(
    ("right", "down", "words"),
    [
        (3, 0, "3 pixels to the right"),
        (-0.5, 0, "half a pixel to the left"),
        (0, -1, "1 pixel up"),
        (1.5, 2, "1.5 pixels to the right and 2 pixels down"),
    ],
)
def test_direction(right: float, down: float, words: str) -> None:
    assert direction(right, down) == words


def test_color_is_what_fill_takes() -> None:
    assert color([254.7, 0, 12.2]) == "(255, 0, 12)"
