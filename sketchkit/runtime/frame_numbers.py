"""Which frames: `3`, `1,30`, `1-60`, `1-60:5`, and several of these with commas between."""

from __future__ import annotations

import re

MOST_FRAMES = 100_000  # an hour has 216,000: more is a slip of the finger


def parse_frames(text: str) -> tuple[int, ...]:
    """Return the numbers of frames that a text means.

    Raises
    ------
    ValueError
        With a sentence that says what to write.

    Examples
    --------
    >>> parse_frames("1,30")
    (1, 30)
    >>> parse_frames("0-20:10, 3")
    (0, 3, 10, 20)
    """
    numbers: set[int] = set()
    for part in text.split(","):
        found = re.fullmatch(r"\s*(\d+)(?:\s*-\s*(\d+)(?::(\d+))?)?\s*", part)
        if not found:
            raise ValueError(f"{text!r} is none of 3, 1,30, 1-60 and 1-60:5.")
        first = int(found[1])
        last, step = int(found[2] or first), int(found[3] or 1)
        if step == 0 or last < first:
            raise ValueError(f"{part.strip()} is an empty range: write 1-60, or 1-60:5.")
        if (last - first) // step >= MOST_FRAMES:
            raise ValueError(f"{part.strip()} is more than {MOST_FRAMES:,} frames.")
        numbers.update(range(first, last + 1, step))
    return tuple(sorted(numbers))
