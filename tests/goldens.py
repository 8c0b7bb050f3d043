"""Goldens: what is expected of a test, kept in a file.

A golden that is missing is written, and the test fails: it has to be looked at. `--update-golden`
replaces those of the chosen tests. Where pictures differ, `expected | difference | actual` is left
in one file, and a page shows them all.
"""

from __future__ import annotations

import difflib
import shutil
from collections.abc import Callable
from html import escape
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

U8 = NDArray[np.uint8]

ENLARGED = 3  # times: single pixels have to be seen
GAP = 6  # px between the three pictures of a sheet


class Failures:
    """Pictures of what differed in this run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def clear(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)

    def keep(self, name: str, expected: U8, actual: U8, remark: str) -> Path:
        """Write a sheet of three pictures and what is to be said about it."""
        self.folder.mkdir(parents=True, exist_ok=True)
        path = self.folder / f"{name}.png"
        Image.fromarray(sheet(expected, actual)).save(path)
        path.with_suffix(".txt").write_text(remark, encoding="utf-8")
        return path

    def write_page(self) -> Path | None:
        """Write a page that shows all sheets; None if there are none."""
        sheets = sorted(self.folder.glob("*.png"))
        if not sheets:
            return None
        rows = [
            f"<h2>{escape(path.stem)}</h2><p>{escape(path.with_suffix('.txt').read_text('utf-8'))}"
            f'<p><img src="{escape(path.name)}">'
            for path in sheets
        ]
        page = self.folder / "index.html"
        head = "<!doctype html><meta charset=utf-8><title>expected | difference | actual</title>"
        style = "<style>body{font:14px sans-serif;background:#eee}</style>"
        page.write_text("\n".join([head, style, *rows]), encoding="utf-8")
        return page


class Goldens:
    """The kept files, below one folder; a name is a path within it."""

    def __init__(self, folder: Path, failures: Failures, *, is_updating: bool) -> None:
        self._folder = folder
        self._failures = failures
        self._is_updating = is_updating

    def check_text(self, name: str, actual: str) -> None:
        """Compare with a text, to the letter."""
        path = self._folder / name
        if self._is_updating or not path.exists():
            self._write(path, lambda: path.write_text(actual, encoding="utf-8"))
        expected = path.read_text(encoding="utf-8")
        if actual != expected:
            lines = expected.splitlines(), actual.splitlines()
            changes = difflib.unified_diff(*lines, "expected", "actual", lineterm="", n=1)
            pytest.fail("\n".join([f"{name} differs:", *changes]), pytrace=False)

    def check_picture(self, name: str, actual: U8) -> None:
        """Compare with a picture, (h, w, 4), in every pixel."""
        path = self._folder / name
        if self._is_updating or not path.exists():
            self._write(path, lambda: Image.fromarray(actual).save(path, optimize=True))
        self.check_near(name, actual, tolerance=0, least_share=1.0, label="cpu")

    def check_near(
        self, name: str, actual: U8, *, tolerance: int, least_share: float, label: str
    ) -> None:
        """Compare with a picture in so many pixels; `label` says what made the actual one."""
        path = self._folder / name
        if not path.exists():
            pytest.fail(f"{name} is not there yet", pytrace=False)
        with Image.open(path) as image:
            expected = np.asarray(image)
        actual = actual[:, :, : expected.shape[2]]  # Processing's frames have no alpha
        share = share_within(expected, actual, tolerance)
        if share < least_share:
            remark = f"{share:.2%} of the pixels within {tolerance}/255; bound: {least_share:.2%}"
            kept = f"{label} {name.replace('/', ' ').removesuffix('.png')}"
            self._failures.keep(kept, expected, actual, remark)
            pytest.fail(f"{name}, drawn by {label}: {remark}", pytrace=False)

    def check_own_near(
        self, name: str, actual: U8, *, tolerance: int, least_share: float, label: str
    ) -> None:
        """Compare so with a picture that is ours; it is written if it is missing."""
        if self._is_updating or not (self._folder / name).exists():
            self.check_picture(name, actual)
        self.check_near(name, actual, tolerance=tolerance, least_share=least_share, label=label)

    def _write(self, path: Path, write: Callable[[], object]) -> None:
        is_new = not path.exists()
        path.parent.mkdir(parents=True, exist_ok=True)
        write()
        if is_new and not self._is_updating:
            pytest.fail(f"{path.name} is new: look at it, and run again", pytrace=False)


def share_within(expected: U8, actual: U8, tolerance: int) -> float:
    """Return the share of pixels of which no channel differs by more; 0 for another size."""
    if expected.shape != actual.shape:
        return 0.0
    return float((difference(expected, actual).max(axis=2) <= tolerance).mean())


def difference(expected: U8, actual: U8) -> U8:
    """Return by how much each channel differs."""
    return np.abs(expected.astype(np.int16) - actual).astype(np.uint8)


def sheet(expected: U8, actual: U8) -> U8:
    """Return expected, difference and actual side by side, enlarged, without alpha."""
    pictures = [expected, actual]
    if expected.shape == actual.shape:
        differs = difference(expected, actual).max(axis=2, keepdims=True) > 0
        # What differs at all is seen: in white where by much, else in gray.
        marks = np.where(differs, np.maximum(difference(expected, actual), 96), 0)
        pictures.insert(1, marks.astype(np.uint8))
    enlarged = [picture[:, :, :3].repeat(ENLARGED, 0).repeat(ENLARGED, 1) for picture in pictures]
    height = max(len(picture) for picture in enlarged)
    columns = []
    for picture in enlarged:
        column = np.full((height, picture.shape[1] + GAP, 3), 255, np.uint8)
        column[: len(picture), : picture.shape[1]] = picture
        columns.append(column)
    return np.concatenate(columns, axis=1)
