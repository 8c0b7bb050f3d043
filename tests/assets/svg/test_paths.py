"""Numbers with many digits are recorded from Processing: getVertex(), getVertexCode()."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.assets.svg.paths import (
    BEZIER_VERTEX,
    BREAK,
    POINTS_OF,
    QUADRATIC_VERTEX,
    VERTEX,
    read_path,
    read_points,
    rounded_rect,
)


@pytest.mark.parametrize(
    ("data", "vertices"),
    [
        pytest.param("M1 2L3 4", [(1, 2), (3, 4)], id="lines"),
        pytest.param("M1 2 3 4", [(1, 2), (3, 4)], id="more places after M are lines"),
        pytest.param("m1 2 3 4", [(1, 2), (4, 6)], id="relative ones too"),
        pytest.param("M1 2h3v-4H0V1", [(1, 2), (4, 2), (4, -2), (0, -2), (0, 1)], id="axes"),
        pytest.param("M10-20.5.5e1-3", [(10, -20.5), (5, -3)], id="without blanks"),
        pytest.param("M0 0L5 5ZL 7 7", [(0, 0), (5, 5), (7, 7)], id="after Z, no new contour"),
        pytest.param("M1 1L5 5zl2 3", [(1, 1), (5, 5), (3, 4)], id="after z, from its start"),
    ],
)
def test_straight_paths(data, vertices):
    outline = read_path(data)

    assert outline.vertices.tolist() == [list(vertex) for vertex in vertices]
    assert outline.codes == (VERTEX,) * len(vertices)


def test_each_contour_after_the_first_begins_with_a_break():
    outline = read_path("M0 0h9v9z m3 3h3v3")

    assert outline.codes == (VERTEX, VERTEX, VERTEX, BREAK, VERTEX, VERTEX, VERTEX)
    assert outline.vertices[3].tolist() == [3, 3]
    assert outline.is_closed


def test_smooth_curves_mirror_the_last_two_points_even_of_a_line():
    outline = read_path(
        "M5 35 C 5 30 15 30 15 35 S 25 40 25 35 L 30 35 S 40 30 40 35 Q 45 30 50 35 T 60 35"
    )

    assert outline.codes == (0, 1, 1, 0, 1, 2, 2)
    assert outline.vertices.astype(int).tolist() == [
        [5, 35],
        *([5, 30], [15, 30], [15, 35]),
        *([15, 40], [25, 40], [25, 35]),
        [30, 35],
        *([35, 35], [40, 30], [40, 35]),
        *([45, 30], [50, 35]),
        *([55, 40], [60, 35]),
    ]


def test_a_smooth_curve_without_one_before_it_starts_where_the_pen_is():
    assert read_path("M1 2s3 4 5 6").vertices[1].tolist() == [1, 2]


def test_arcs_become_bezier_curves():
    outline = read_path("M0 0 A 5 3 30 1 0 10 4 a 0 3 0 0 0 5 5")

    assert outline.codes == (VERTEX, BEZIER_VERTEX, BEZIER_VERTEX, VERTEX)
    np.testing.assert_allclose(
        outline.vertices[1:7],
        [
            (-0.26913, 1.87044),
            (1.76648, 4.31241),
            (4.5094, 5.40957),
            (7.25232, 6.50674),
            (9.73087, 5.87044),
            (10, 4),
        ],
        atol=1e-5,
    )


def test_the_flags_of_an_arc_need_no_blanks():
    spaced, compact = read_path("M80 20a5 5 0 0 1-10 0"), read_path("M80 20a5 5 0 01-10 0")

    assert spaced.vertices.tolist() == compact.vertices.tolist()


@pytest.mark.parametrize(
    ("data", "count"),
    [
        pytest.param("M0 0A10 10 0 0 1 10 10", 2, id="two curves by the last bit"),
        pytest.param("M30.3 7.7a7.7 7.7 0 0 1 7.7 7.7", 2, id="relative"),
        pytest.param("M4.13 4.13a.706 .706 0 0 1-.706 .706", 1, id="one, the last bit being off"),
        pytest.param("M0 0a5 5 0 0 1 0 0", 0, id="nowhere to go"),
    ],
)
def test_a_quarter_of_a_circle_is_one_curve_or_two_as_in_processing(data, count):
    assert read_path(data).codes == (VERTEX,) + (BEZIER_VERTEX,) * count


@pytest.mark.parametrize("data", ["", "  \n", "z"])
def test_a_path_without_places_is_empty(data):
    assert read_path(data).vertices.shape == (0, 2)


@pytest.mark.parametrize(
    ("data", "problem"),
    [
        ("M10 10 L20", "its path cannot be read after 'M10 10 L20'"),
        ("M10 10 X 3 4", "its path cannot be read after 'M10 10'"),
        ("10 10 L 3 3", "its path cannot be read"),
        ("M0 0 L nan 4", "its path cannot be read after 'M0 0 L'"),
        ("M1 1h", "its path cannot be read after 'M1 1h'"),
        ("M1 1L z", "its path cannot be read after 'M1 1L'"),
        ("M1 1 A5 5 0 2 1 3 3", "its path cannot be read after 'M1 1 A5 5 0 2 1'"),
        ("C1 1 2 2 3 3", "its path cannot be read after 'C1 1 2 2 3 3'"),
        ("M1 1 L1e99 3", "a number is too large: 1e+30 is the most"),
    ],
)
def test_what_is_no_path_is_told(data, problem):
    with pytest.raises(ValueError, match=r"path|number") as caught:
        read_path(data)

    assert str(caught.value) == problem


@given(st.text(alphabet="MmLlHhVvCcSsQqTtAaZz 01.5,-e9", max_size=60))
def test_any_text_is_a_whole_path_or_told(data):
    try:
        outline = read_path(data)
    except ValueError:
        return

    assert np.isfinite(outline.vertices).all()
    assert sum(POINTS_OF[code] for code in outline.codes) == len(outline.vertices)


def test_points_go_in_pairs():
    outline = read_points("1,2 3 4,-5.5.6 7", is_closed=True)

    assert outline.vertices.round(3).tolist() == [[1, 2], [3, 4], [-5.5, pytest.approx(0.6)]]
    assert (outline.codes, outline.is_closed) == ((), True)


def test_something_else_among_the_points_is_told():
    with pytest.raises(ValueError, match="'x' is among the numbers '1 x 3'"):
        read_points("1 x 3", is_closed=False)


def test_round_corners_have_the_control_points_of_processing():
    outline = rounded_rect((78, 55, 10, 10), 2, 4)

    assert outline.codes == (0, 1, 0, 1, 0, 1, 0, 1)
    assert QUADRATIC_VERTEX not in outline.codes
    np.testing.assert_allclose(
        outline.vertices[:6],
        [(78, 59), (78, 56.7904), (78.8952, 55), (80, 55), (86, 55), (87.1048, 55)],
        atol=1e-5,
    )
    np.testing.assert_allclose(outline.vertices[-1], (78, 61), atol=1e-5)
