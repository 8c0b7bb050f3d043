"""Processing's noise: smooth random values over one, two or three dimensions.

It is value noise with a cosine between neighbours, four octaves by default, each with twice the
detail and half the height of the one before. The lattice is one table of 4096 numbers, folded:
a step in y is 16 entries away, one in z 256, so that patterns recur.
"""

from math import cos, pi

from sketchkit.core.errors import SketchError
from sketchkit.core.float32 import ROUND, f32
from sketchkit.core.rng import JavaRandom

_SIZE = 4096
_Y_STEP = 16
_Z_STEP = 256
_EASE_STEPS = 360  # half degrees from one lattice point to the next


def _ease_table() -> tuple[float, ...]:
    """Return half of 1 - cos, every half degree up to 180, each step rounded to 32 bits."""
    degree = f32(f32(pi) / 180.0)
    angles = (f32(i * degree) * 0.5 for i in range(_EASE_STEPS + 1))
    return tuple(0.5 * f32(1.0 - f32(cos(angle))) for angle in angles)


_EASE = _ease_table()


class PerlinNoise:
    """The noise of one seed; `octaves` and `falloff` are what `noiseDetail()` sets.

    Examples
    --------
    >>> round(PerlinNoise(0).at(0.5), 6)
    0.668368
    """

    __slots__ = ("_random", "_table", "falloff", "octaves")

    def __init__(self, seed: int) -> None:
        self.octaves = 4
        self.falloff = 0.5
        self.seed(seed)

    def seed(self, seed: int) -> None:
        """Start over with the noise that belongs to `seed`."""
        self._random = JavaRandom(seed)
        self._table: list[float] = []

    def detail(self, octaves: int, falloff: float | None = None) -> None:
        """Set the number of octaves and how much each is lower; not above zero: stays as it is."""
        if octaves > 0:
            self.octaves = octaves
        if falloff is not None and falloff > 0:
            self.falloff = f32(falloff)

    def at(self, x: float, y: float = 0.0, z: float = 0.0) -> float:
        """Return the noise at a point, from 0 to 1; it is mirrored at zero.

        Every step is rounded to 32 bits, as Java's float does it: so all digits are Processing's.
        """
        table = self._table or self._fill()
        try:
            xi, xf = _split(x)
            yi, yf = _split(y) if y else (0, 0.0)
            zi, zf = _split(z) if z else (0, 0.0)
        except (OverflowError, ValueError):
            raise SketchError("noise() needs finite numbers.", got=f"{x}, {y}, {z}") from None
        total = 0.0
        height = 0.5
        falloff = self.falloff
        for _ in range(self.octaves):
            corner = (xi + yi * _Y_STEP + zi * _Z_STEP) % _SIZE
            value = height * _inside_cell(table, corner, xf, yf, zf)
            t = value * ROUND
            value = total + (t - (t - value))
            t = value * ROUND
            total = t - (t - value)
            height = f32(height * falloff)
            xi, xf = (2 * xi, 2 * xf) if xf < 0.5 else (2 * xi + 1, 2 * xf - 1.0)
            if yf or yi:
                yi, yf = (2 * yi, 2 * yf) if yf < 0.5 else (2 * yi + 1, 2 * yf - 1.0)
            if zf or zi:
                zi, zf = (2 * zi, 2 * zf) if zf < 0.5 else (2 * zi + 1, 2 * zf - 1.0)
        return total

    def _fill(self) -> list[float]:
        values = [self._random.next_float() for _ in range(_SIZE)]
        beyond = (
            _Z_STEP + _Y_STEP + 2
        )  # the farthest corner of a cell that starts at the last entry
        self._table = values + values[:beyond]
        return self._table


def _inside_cell(table: list[float], corner: int, xf: float, yf: float, zf: float) -> float:
    """Return the value at a point of a cell, whose first corner is an entry of the table."""
    step = xf * _EASE_STEPS
    t = step * ROUND
    ease_x = _EASE[int(t - (t - step))]
    near = _between(table[corner], table[corner + 1], ease_x)
    if yf:
        step = yf * _EASE_STEPS
        t = step * ROUND
        ease_y = _EASE[int(t - (t - step))]
        corner_y = corner + _Y_STEP
        near = _between(near, _between(table[corner_y], table[corner_y + 1], ease_x), ease_y)
    if zf:
        step = zf * _EASE_STEPS
        t = step * ROUND
        far = _inside_cell(table, corner + _Z_STEP, xf, yf, 0.0)
        near = _between(near, far, _EASE[int(t - (t - step))])
    return near


def _between(start: float, stop: float, amount: float) -> float:
    """Return start + (stop - start) * amount, rounded to 32 bits at each of the three steps."""
    value = stop - start
    t = value * ROUND
    value = (t - (t - value)) * amount
    t = value * ROUND
    value = start + (t - (t - value))
    t = value * ROUND
    return t - (t - value)


def _split(value: float) -> tuple[int, float]:
    """Return the whole part and the rest of |value| as a 32-bit float."""
    t = abs(value) * ROUND
    size = t - (t - abs(value))
    whole = int(size)
    return whole, size - whole
