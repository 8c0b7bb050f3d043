"""Processing's noise: smooth random values over one, two or three dimensions.

It is value noise with a cosine between neighbours, four octaves by default, each with twice the
detail and half the height of the one before. The lattice is one table of 4096 numbers, folded:
a step in y is 16 entries away, one in z 256, so that patterns recur.

Sketches ask for it a hundred thousand times a frame, so nothing is called inside the loops: where
a line reads `t = v * ROUND` and then `t - (t - v)`, `v` is rounded to 32 bits, as in `f32`.
"""

from math import cos, pi

from sketchkit.core.errors import SketchError
from sketchkit.core.float32 import ROUND, f32
from sketchkit.core.rng import JavaRandom

_SIZE = 4096
_LAST = _SIZE - 1  # a place & this is the place in the table
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

    __slots__ = ("_heights", "_random", "_rises", "_table", "falloff", "octaves")

    def __init__(self, seed: int) -> None:
        self.octaves = 4
        self.falloff = 0.5
        self._measure_heights()
        self.seed(seed)

    def seed(self, seed: int) -> None:
        """Start over with the noise that belongs to `seed`."""
        self._random = JavaRandom(seed)
        self._table: list[float] = []
        self._rises: list[float] = []

    def detail(self, octaves: int, falloff: float | None = None) -> None:
        """Set the number of octaves and how much each is lower; not above zero: stays as it is."""
        if octaves > 0:
            self.octaves = octaves
        if falloff is not None and falloff > 0:
            self.falloff = f32(falloff)
        self._measure_heights()

    def at(self, x: float, y: float = 0.0, z: float = 0.0) -> float:
        """Return the noise at a point, from 0 to 1; it is mirrored at zero.

        Every step is rounded to 32 bits, as Java's float does it: so all digits are Processing's.
        """
        if not self._table:
            self._fill()
        try:
            if z:
                return self._in_space(*_split(x), *_split(y), *_split(z))
            if y:
                return self._on_plane(*_split(x), *_split(y))
            return self._on_line(*_split(x))
        except (OverflowError, ValueError):
            raise SketchError("noise() needs finite numbers.", got=f"{x}, {y}, {z}") from None

    def _on_line(self, xi: int, xf: float) -> float:
        """Return the noise at x, given as whole part and rest; y and z are 0."""
        table, rises = self._table, self._rises
        total = 0.0
        for height in self._heights:
            t = (step := xf * _EASE_STEPS) * ROUND
            corner = xi & _LAST
            t = (v := rises[corner] * _EASE[int(t - (t - step))]) * ROUND
            t = (v := table[corner] + (t - (t - v))) * ROUND
            t = (v := height * (t - (t - v))) * ROUND
            t = (v := total + (t - (t - v))) * ROUND
            total = t - (t - v)
            xi, xf = (2 * xi, 2 * xf) if xf < 0.5 else (2 * xi + 1, 2 * xf - 1.0)
        return total

    def _on_plane(self, xi: int, xf: float, yi: int, yf: float) -> float:
        """Return the noise at x and y, likewise; z is 0."""
        table, rises = self._table, self._rises
        total = 0.0
        for height in self._heights:
            t = (step := xf * _EASE_STEPS) * ROUND
            ease_x = _EASE[int(t - (t - step))]
            corner = (xi + yi * _Y_STEP) & _LAST
            t = (v := rises[corner] * ease_x) * ROUND
            t = (v := table[corner] + (t - (t - v))) * ROUND
            near = t - (t - v)
            if yf:
                corner += _Y_STEP
                t = (v := rises[corner] * ease_x) * ROUND
                t = (v := table[corner] + (t - (t - v))) * ROUND
                t = (v := (t - (t - v)) - near) * ROUND
                rise = t - (t - v)
                t = (step := yf * _EASE_STEPS) * ROUND
                t = (v := rise * _EASE[int(t - (t - step))]) * ROUND
                t = (v := near + (t - (t - v))) * ROUND
                near = t - (t - v)
            t = (v := height * near) * ROUND
            t = (v := total + (t - (t - v))) * ROUND
            total = t - (t - v)
            xi, xf = (2 * xi, 2 * xf) if xf < 0.5 else (2 * xi + 1, 2 * xf - 1.0)
            yi, yf = (2 * yi, 2 * yf) if yf < 0.5 else (2 * yi + 1, 2 * yf - 1.0)
        return total

    def _in_space(self, xi: int, xf: float, yi: int, yf: float, zi: int, zf: float) -> float:
        """Return the noise at x, y and z, likewise."""
        table, rises = self._table, self._rises
        total = 0.0
        for height in self._heights:
            t = (step := xf * _EASE_STEPS) * ROUND
            ease_x = _EASE[int(t - (t - step))]
            t = (step := yf * _EASE_STEPS) * ROUND
            ease_y = _EASE[int(t - (t - step))]
            corner = (xi + yi * _Y_STEP + zi * _Z_STEP) & _LAST
            near = _on_face(table, rises, corner, ease_x, ease_y)
            if zf:
                far = _on_face(table, rises, corner + _Z_STEP, ease_x, ease_y)
                t = (v := far - near) * ROUND
                rise = t - (t - v)
                t = (step := zf * _EASE_STEPS) * ROUND
                t = (v := rise * _EASE[int(t - (t - step))]) * ROUND
                t = (v := near + (t - (t - v))) * ROUND
                near = t - (t - v)
            t = (v := height * near) * ROUND
            t = (v := total + (t - (t - v))) * ROUND
            total = t - (t - v)
            xi, xf = (2 * xi, 2 * xf) if xf < 0.5 else (2 * xi + 1, 2 * xf - 1.0)
            yi, yf = (2 * yi, 2 * yf) if yf < 0.5 else (2 * yi + 1, 2 * yf - 1.0)
            zi, zf = (2 * zi, 2 * zf) if zf < 0.5 else (2 * zi + 1, 2 * zf - 1.0)
        return total

    def _fill(self) -> None:
        """Draw the numbers of the lattice, and note how far each lies below its next in x."""
        values = [self._random.next_float() for _ in range(_SIZE)]
        beyond = _Z_STEP + _Y_STEP + 2  # the farthest corner of a cell at the last entry
        self._table = values + values[:beyond]
        following = zip(self._table, self._table[1:], strict=False)
        self._rises = [f32(after - before) for before, after in following]

    def _measure_heights(self) -> None:
        """Note how high each octave is."""
        heights = [0.5]
        for _ in range(self.octaves - 1):
            heights.append(f32(heights[-1] * self.falloff))
        self._heights = tuple(heights)


def _on_face(
    table: list[float], rises: list[float], corner: int, ease_x: float, ease_y: float
) -> float:
    """Return the value in a square between four lattice points of one z."""
    t = (v := rises[corner] * ease_x) * ROUND
    t = (v := table[corner] + (t - (t - v))) * ROUND
    near = t - (t - v)
    if not ease_y:
        return near
    corner += _Y_STEP
    t = (v := rises[corner] * ease_x) * ROUND
    t = (v := table[corner] + (t - (t - v))) * ROUND
    t = (v := (t - (t - v)) - near) * ROUND
    t = (v := (t - (t - v)) * ease_y) * ROUND
    t = (v := near + (t - (t - v))) * ROUND
    return t - (t - v)


def _split(value: float) -> tuple[int, float]:
    """Return the whole part and the rest of |value| as a 32-bit float."""
    t = abs(value) * ROUND
    size = t - (t - abs(value))
    whole = int(size)
    return whole, size - whole
