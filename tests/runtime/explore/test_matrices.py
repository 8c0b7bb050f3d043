from math import pi

import pytest

from sketchkit.core import matrix as mat
from sketchkit.runtime.explore.matrices import in_words, rows_of, without_camera

START = mat.IDENTITY


@pytest.mark.parametrize(
    ("matrix", "words"),
    [
        (START, "nothing: as at the beginning of draw()"),
        (mat.translate(START, 10, 20), "moved by (10, 20)"),
        (mat.translate(START, 10, 20, -5.5), "moved by (10, 20, -5.5)"),
        (mat.rotate_z(START, pi / 6), "turned by 30 degrees"),
        (mat.rotate_z(START, -pi / 6), "turned by -30 degrees"),
        (mat.rotate_x(START, pi), "turned by 180 degrees about x"),
        (mat.scale(START, 2, 2, 2), "scaled by 2"),
        (mat.scale(START, 1, -1), "scaled by (1, -1)"),
        (
            mat.scale(mat.rotate_y(START, pi / 4), 2, 3),
            "turned by 45 degrees about y, scaled by (2, 3)",
        ),
        (mat.shear_x(START, pi / 4), "sheared, or turned after an uneven scale"),
        (mat.scale(START, 0, 0), "squeezed to nothing (a scale of 0)"),
        (mat.translate(START, float("nan"), 0), "holds numbers that are none (NaN or infinite)"),
    ],
)
def test_matrix_is_said_in_the_words_of_the_calls(matrix: mat.Affine, words: str) -> None:
    assert in_words(matrix) == words


def test_camera_is_taken_out() -> None:
    camera = mat.look_at((50.0, 50.0, 80.0), (50.0, 50.0, 0.0), (0.0, 1.0, 0.0))

    own = without_camera(mat.translate(camera, 7, 8, 9), camera)

    assert in_words(own) == "moved by (7, 8, 9)"


def test_rows_are_four() -> None:
    assert rows_of(mat.translate(START, 1, 2, 3))[3] == [0, 0, 0, 1]
