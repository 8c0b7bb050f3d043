"""Which side of an edge a place is on, and where two edges cross: what `sweep` decides by.

The formulas, and so their rounding, are GLU's: triangles depend on it where much coincides.
"""

from __future__ import annotations

Place = tuple[float, float]  # (s, t): left of another if its s is smaller, or else its t; t is up


def side(left: Place, place: Place, right: Place) -> float:
    """Return a number > 0 if `place` is above the edge from `left` to `right`, < 0 if below."""
    before, after = place[0] - left[0], right[0] - place[0]
    if before + after <= 0:
        return 0.0
    return (place[1] - right[1]) * before + (place[1] - left[1]) * after


def height(left: Place, place: Place, right: Place) -> float:
    """Return how far `place` is above the edge from `left` to `right`; 0 if that is vertical."""
    before, after = place[0] - left[0], right[0] - place[0]
    if before + after <= 0:
        return 0.0
    if before < after:
        return (place[1] - left[1]) + (left[1] - right[1]) * (before / (before + after))
    return (place[1] - right[1]) + (right[1] - left[1]) * (after / (before + after))


def crossing(a: Place, b: Place, c: Place, d: Place) -> Place:
    """Return where the edges from `a` to `b` and from `c` to `d` cross, or nearly so."""
    swapped = [(t, s) for s, t in (a, b, c, d)]
    return _crossing_s(a, b, c, d), _crossing_s(*swapped)


def _crossing_s(a: Place, b: Place, c: Place, d: Place) -> float:
    """Interpolate between the middle two of the four ends: exact enough for any angle."""
    (left1, right1), (left2, right2) = sorted((sorted((a, b)), sorted((c, d))))
    if left2 > right1:
        return (left2[0] + right1[0]) / 2
    if right1 <= right2:
        right = right1
        gap1, gap2 = height(left1, left2, right1), height(left2, right1, right2)
    else:
        right = right2
        gap1, gap2 = side(left1, left2, right1), -side(left1, right2, right1)
    if gap1 + gap2 < 0:
        gap1, gap2 = -gap1, -gap2
    gap1, gap2 = max(gap1, 0.0), max(gap2, 0.0)
    if gap1 > gap2:
        return right[0] + (left2[0] - right[0]) * (gap2 / (gap1 + gap2))
    if gap2 == 0:
        return (left2[0] + right[0]) / 2
    return left2[0] + (right[0] - left2[0]) * (gap1 / (gap1 + gap2))
