import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.checks.marks import BY_SHARE, Measure, falling_to, read_curve, step
from tests.grading.checks.cases import table

DISTANCES = st.floats(0, 1e6)


@pytest.mark.parametrize(
    ("text", "distance", "score"),
    [
        ("", 0, 1),
        ("", 1, 1),
        ("", 2.5, 0.5),
        ("", 4, 0),
        ("", math.inf, 0),
        ("", math.nan, 0),
        ("none_at = 2", 1.5, 0.5),
        ("none_at = 2", 3, 0),
        ('curve = "all or nothing"', 1, 1),
        ('curve = "all or nothing"', 1.01, 0),
        ("curve = [[1, 1.0], [2, 0.5], [4, 0]]", 1.5, 0.75),
        ("curve = [[1, 1.0], [2, 0.5], [4, 0]]", 3, 0.25),
        ("curve = [[1, 1.0], [2, 0.5]]", 100, 0.5),
        ("curve = [[1, 1], [2, 0.5], [2, 0.2], [4, 0]]", 2, 0.5),
        ("curve = [[1, 1], [2, 0.5], [2, 0.2], [4, 0]]", 3, 0.1),
    ],
)
def test_score_of_a_distance(text: str, distance: float, score: float) -> None:
    curve = read_curve(table(text), Measure.DISTANCE)

    assert curve.score(distance) == pytest.approx(score)


@pytest.mark.parametrize(
    ("text", "share", "score"),
    [
        ("", 0.25, 0.25),
        ("", 1, 1),
        ('curve = "all or nothing"', 0.99, 0),
        ('curve = "all or nothing"', 1, 1),
        ("curve = [[0.5, 0], [0.9, 1.0]]", 0.9, 1),
        ("curve = [[0.5, 0], [0.9, 1.0]]", 0.7, 0.5),
        ("curve = [[0.5, 0], [0.9, 1.0]]", 0.4, 0),
    ],
)
def test_score_of_a_share(text: str, share: float, score: float) -> None:
    curve = read_curve(table(text), Measure.SHARE)

    assert curve.score(1 - share) == pytest.approx(score)


@pytest.mark.parametrize(
    ("text", "measure", "words"),
    [
        ("", Measure.DISTANCE, "all within the tolerance, none from 4 times it on"),
        ("", Measure.EXCESS, "all within the limit"),
        ("", Measure.SHARE, "in proportion to what is right"),
        ("curve = [[1, 1], [2, 0.5]]", Measure.DISTANCE, "100% at the tolerance, 50% at 2 times"),
        ("curve = [[0.5, 0], [1, 1]]", Measure.SHARE, "0% at 50% right, 100% at 100% right"),
    ],
)
def test_curve_is_stated_in_words(text: str, measure: Measure, words: str) -> None:
    assert read_curve(table(text), measure).words.startswith(words)


@pytest.mark.parametrize(
    ("text", "measure", "words"),
    [
        ("curve = 3", Measure.DISTANCE, 'curve is "all or nothing" or a list'),
        ("curve = [[1, 1]]", Measure.DISTANCE, "two points"),
        ("curve = [[1, 1], [2]]", Measure.DISTANCE, "two numbers"),
        ("curve = [[2, 1], [1, 0]]", Measure.DISTANCE, "first numbers of curve's points rise"),
        ("curve = [[1, 1], [2, 2]]", Measure.DISTANCE, "no share is larger"),
        ("curve = [[1, 0.5], [2, 1]]", Measure.DISTANCE, "no more marks for what is worse"),
        ("curve = [[1, 0.5], [2, 0]]", Measure.DISTANCE, "gives all marks, 1, for the best"),
        ("curve = [[0.5, 1], [0.9, 0]]", Measure.SHARE, "no more marks for what is worse"),
        ("curve = [[0.5, 0], [90, 1]]", Measure.SHARE, "no share is larger"),
        ('curve = [["a", 1], [2, 0]]', Measure.DISTANCE, "curve is a number, not 'a'"),
        ("none_at = 1", Measure.DISTANCE, "none_at is more than 1"),
        ("none_at = 2\ncurve = 1", Measure.DISTANCE, "write one of them"),
    ],
)
def test_curve_that_cannot_be_is_refused(text: str, measure: Measure, words: str) -> None:
    with pytest.raises(AssignmentError, match=words):
        read_curve(table(text), measure)


@given(DISTANCES, DISTANCES, st.floats(1.01, 100))
def test_farther_is_never_better(one: float, other: float, none_at: float) -> None:
    near, far = sorted((one, other))
    for curve in (falling_to(none_at), step(), BY_SHARE):
        assert 1 >= curve.score(near) >= curve.score(far) >= 0


@given(
    st.lists(st.tuples(st.floats(0, 10), st.floats(0, 1)), min_size=1, max_size=6),
    DISTANCES,
)
def test_any_curve_stays_within_its_marks(corners: list[tuple[float, float]], d: float) -> None:
    places = sorted(place for place, _ in corners)
    shares = sorted((share for _, share in corners), reverse=True)
    points = [[0, 1], *map(list, zip(places, shares, strict=True))]
    curve = read_curve(table(f"curve = {points}"), Measure.DISTANCE)

    assert shares[-1] - 1e-12 <= curve.score(d) <= 1


@given(st.integers(1, 40))
def test_all_of_many_parts_are_all_marks(count: int) -> None:
    assert BY_SHARE.score(1 - sum(1 / count for _ in range(count))) == 1
