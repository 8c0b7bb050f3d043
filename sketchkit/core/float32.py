"""Java's float: Processing computes in 32 bits, and where the last bit shows, so must we."""

ROUND = 2.0**29 + 1.0  # 29: the bits of a double's fraction that a float lacks (52 - 23)


def f32(x: float) -> float:
    """Return `x` rounded to the nearest number that a 32-bit float can hold.

    Veltkamp's splitting: three operations instead of a call into C, for |x| < 1e299 and not
    below the smallest normal float. Hot code writes it out: `t = x * ROUND; t - (t - x)`.

    Examples
    --------
    >>> f32(0.1)
    0.10000000149011612
    """
    t = x * ROUND
    return t - (t - x)
