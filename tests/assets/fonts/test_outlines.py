from __future__ import annotations

from sketchkit.assets.fonts.outlines import letter_outline


def test_letter_stands_on_the_baseline_and_reaches_up() -> None:
    letters, points = letter_outline("", "H")

    assert set(letters) == {"M", "L", "Z"}
    assert points[:, 1].max() == 0
    assert points[:, 1].min() == -0.656  # the height of the default face's capitals


def test_round_letter_has_curves_and_a_point_for_each_letter_of_the_path() -> None:
    letters, points = letter_outline("", "o")

    assert letters.count("Z") == 2  # outside and inside
    assert len(points) == sum({"M": 1, "L": 1, "C": 3, "Z": 0}[letter] for letter in letters)


def test_space_has_no_outline() -> None:
    assert letter_outline("", " ")[0] == ""
