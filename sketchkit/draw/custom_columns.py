"""Columns of what `attrib()` and its like give to vertices."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.pieces import Fills
from sketchkit.draw.recorder import Custom, CustomKind
from sketchkit.draw.rows import Rows
from sketchkit.draw.vertex import CUSTOM

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients


def custom_samples(rows: Rows) -> dict[str, Custom]:
    """Return the attributes that any vertex has, each with one of its values."""
    samples: dict[str, Custom] = {}
    for entry in rows.recorder.attributes:
        if entry.custom:
            samples |= entry.custom
    return samples


def custom_columns(
    rows: Rows, fills: Fills, samples: dict[str, Custom], inverse: F32
) -> dict[str, NDArray[np.generic]]:
    """Return a column for each attribute, (n, k, size); 0 where a vertex has none.

    `inverse` is (s, 3, 3): n @ inverse is the way of a normal into eye space.
    """
    return {
        CUSTOM + name: _column(rows, fills, name, sample, inverse)
        for name, sample in samples.items()
    }


def _column(rows: Rows, fills: Fills, name: str, sample: Custom, inverse: F32) -> F32:
    size = len(sample.values)
    if fills.attributes is None:
        return np.zeros((1, 1, size), np.float32)
    nothing = (0.0,) * size
    entries = [entry.custom.get(name) for entry in rows.recorder.attributes]
    table = np.array([custom.values if custom else nothing for custom in entries], np.float32)
    column: F32 = table[fills.attributes]
    match sample.kind:
        case CustomKind.PLACE:
            x, y, z = np.moveaxis(column, 2, 0)
            return np.stack(rows.transform(fills.rows, x, y, z), axis=2)
        case CustomKind.DIRECTION:
            turned: F32 = (column @ inverse[rows.states[fills.rows]]).astype(np.float32)
            return turned
        case _:
            return column
