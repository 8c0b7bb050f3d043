"""Places, colours and shares, as a sentence says them."""

from __future__ import annotations

import math
from collections.abc import Iterable

Box = tuple[int, int, int, int]  # left, top, width, height


def percent(share: float) -> str:
    """Return a share of 0..1. What is not all is never said to be all, nor a little nothing.

    Examples
    --------
    >>> percent(0.99999), percent(0.41234), percent(0.00001), percent(1)
    ('99.9 %', '41.2 %', 'less than 0.1 %', '100 %')
    """
    tenths = round(share * 1000) if share < 0.999 else math.floor(share * 1000)
    if tenths == 0 and share > 0:
        return "less than 0.1 %"
    return f"{tenths / 10:g} %"


def color(values: Iterable[float]) -> str:
    """Return a colour as fill() takes it.

    Examples
    --------
    >>> color([254.7, 0, 12.2])
    '(255, 0, 12)'
    """
    return f"({', '.join(str(round(value)) for value in values)})"


def place(box: Box, width: int, height: int) -> str:
    """Return where in a picture a box lies.

    Examples
    --------
    >>> place((0, 0, 10, 10), 100, 100), place((40, 80, 20, 20), 100, 100)
    ('at the left top', 'at the bottom')
    >>> place((45, 45, 10, 10), 100, 100)
    'in the middle'
    """
    left, top, box_width, box_height = box
    across = _third((left + box_width / 2) / width, ("left", "", "right"))
    down = _third((top + box_height / 2) / height, ("top", "", "bottom"))
    return (
        f"at the {across} {down}".replace("  ", " ").rstrip() if across or down else "in the middle"
    )


def direction(right: float, down: float) -> str:
    """Return a movement.

    Examples
    --------
    >>> direction(3, 0), direction(-0.5, 1)
    ('3 pixels to the right', 'half a pixel to the left and 1 pixel down')
    """
    parts = []
    if right:
        parts.append(f"{_pixels(abs(right))} to the {'right' if right > 0 else 'left'}")
    if down:
        parts.append(f"{_pixels(abs(down))} {'down' if down > 0 else 'up'}")
    return " and ".join(parts)


def _pixels(count: float) -> str:
    if count == 0.5:
        return "half a pixel"
    return f"{count:g} pixel{'s' if count != 1 else ''}"


def _third(share: float, names: tuple[str, str, str]) -> str:
    return names[min(int(share * 3), 2)]
