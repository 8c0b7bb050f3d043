"""Tolerance bands: where a value may be in each frame, around a reference or as it is written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

F64 = NDArray[np.float64]

SLACK = 1e-6  # of a value's size: what rounding may cost where a reference does not move


@dataclass(frozen=True)
class Band:
    """Where a value may be.

    Attributes
    ----------
    frames : (n,) int
    low, high : (n,) float64
        NaN where nothing is known, so that the frame does not count.
    """

    frames: NDArray[np.int64]
    low: F64
    high: F64


def written_band(corners: Sequence[tuple[int, float, float]], frames: Sequence[int]) -> Band:
    """Return the band through corners `(frame, low, high)`: straight between, nothing outside."""
    places, lows, highs = np.array(corners, float).T
    numbers = np.array(frames)
    low, high = (
        np.interp(numbers, places, edge, left=np.nan, right=np.nan) for edge in (lows, highs)
    )
    return Band(numbers, low, high)


def band_around(
    trajectory: Sequence[float], frames: Sequence[int], absolute: float, relative: float
) -> Band:
    """Return the band around a reference's values, which begin with frame 1.

    Its half width is the larger of `absolute` and of `relative` times the range in these frames.
    """
    numbers = np.array(frames)
    middle = values_at(trajectory, numbers)
    is_known = np.isfinite(middle)
    extent = float(np.ptp(middle[is_known])) if is_known.any() else 0.0
    width = max(absolute, relative * extent) + SLACK * np.maximum(np.abs(middle), 1)
    middle = np.where(is_known, middle, np.nan)
    return Band(numbers, middle - width, middle + width)


def values_at(trajectory: Sequence[float], frames: NDArray[np.int64]) -> F64:
    """Return the values of frames, which are counted from 1; NaN where there is none."""
    values = np.full(len(frames), np.nan)
    is_there = (frames >= 1) & (frames <= len(trajectory))
    values[is_there] = np.array(trajectory, float)[frames[is_there] - 1]
    return values
