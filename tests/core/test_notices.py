import pytest

from sketchkit.core.notices import SketchWarning, warn_once


def test_remark_names_the_line_that_called(recwarn: pytest.WarningsRecorder) -> None:
    with pytest.warns(SketchWarning, match="odd") as caught:
        warn_once("This is odd.")

    assert caught[0].filename == __file__
