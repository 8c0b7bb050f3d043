"""What the tests of models share: their files, and how to write others."""

from pathlib import Path

import numpy as np

DATA = Path(__file__).parent / "data"


def written(folder, name, text):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def corners(part):
    """Return the places of a part, face by face."""
    ends = np.cumsum(part.lengths)
    return [rows.tolist() for rows in np.split(part.places, ends[:-1])]
