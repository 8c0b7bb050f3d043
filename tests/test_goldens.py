"""The goldens themselves: what fails, what is written, what is left to look at."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.goldens import ENLARGED, GAP, Failures, Goldens, share_within, sheet

Failed = pytest.fail.Exception

GRAY = np.full((4, 5, 4), 128, np.uint8)


@pytest.fixture
def failures(tmp_path: Path) -> Failures:
    return Failures(tmp_path / "failures")


@pytest.fixture
def kept(tmp_path: Path, failures: Failures) -> Goldens:
    return Goldens(tmp_path, failures, is_updating=False)


def one_pixel_off(by: int = 1) -> np.ndarray:
    other = GRAY.copy()
    other[1, 2, 0] += by
    return other


def test_new_golden_is_written_and_fails(kept, tmp_path):
    with pytest.raises(Failed, match="is new"):
        kept.check_text("new.txt", "text")

    assert (tmp_path / "new.txt").read_text() == "text"
    kept.check_text("new.txt", "text")


def test_new_picture_is_written_as_it_is(kept, tmp_path):
    with pytest.raises(Failed, match="is new"):
        kept.check_picture("new.png", GRAY)

    assert np.array_equal(np.asarray(Image.open(tmp_path / "new.png")), GRAY)
    kept.check_picture("new.png", GRAY)


def test_text_that_differs_shows_the_line(kept, tmp_path):
    (tmp_path / "old.txt").write_text("one\ntwo\nthree")

    with pytest.raises(Failed) as caught:
        kept.check_text("old.txt", "one\n2\nthree")

    assert "-two\n+2" in str(caught.value)


def test_one_pixel_that_differs_by_one_fails(kept, tmp_path):
    Image.fromarray(GRAY).save(tmp_path / "old.png")

    with pytest.raises(Failed, match=r"95\.00% of the pixels"):
        kept.check_picture("old.png", one_pixel_off())


def test_tolerance_and_share_allow_for_some(kept, tmp_path):
    Image.fromarray(GRAY).save(tmp_path / "old.png")

    kept.check_near("old.png", one_pixel_off(2), tolerance=2, least_share=1, label="gl")
    kept.check_near("old.png", one_pixel_off(9), tolerance=2, least_share=0.95, label="gl")
    with pytest.raises(Failed):
        kept.check_near("old.png", one_pixel_off(9), tolerance=2, least_share=0.96, label="gl")


def test_golden_of_elsewhere_is_not_written(kept, tmp_path):
    with pytest.raises(Failed, match="not there yet"):
        kept.check_near("none.png", GRAY, tolerance=2, least_share=1, label="gl")

    assert not (tmp_path / "none.png").exists()


def test_updating_replaces_and_passes(tmp_path, failures):
    (tmp_path / "old.txt").write_text("old")

    Goldens(tmp_path, failures, is_updating=True).check_text("old.txt", "new")

    assert (tmp_path / "old.txt").read_text() == "new"


def test_another_size_agrees_in_nothing():
    assert share_within(GRAY, GRAY[:3], 255) == 0


def test_sheet_shows_three_pictures():
    picture = sheet(GRAY, one_pixel_off())

    assert picture.shape == (4 * ENLARGED, 3 * (5 * ENLARGED + GAP), 3)


def test_page_lists_what_differs(kept, tmp_path, failures):
    Image.fromarray(GRAY).save(tmp_path / "old.png")
    with pytest.raises(Failed):
        kept.check_picture("old.png", one_pixel_off())

    page = failures.write_page()

    text = page.read_text()
    assert 'src="cpu old.png"' in text
    assert "95.00%" in text
    assert (page.parent / "cpu old.png").exists()


def test_no_page_without_failures(failures):
    assert failures.write_page() is None
