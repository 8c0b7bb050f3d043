"""Rows: what a recorder holds, as columns, with the tables that rows refer to."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Mat4
from sketchkit.core.style import Style
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.stage import Stage

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
Floats = NDArray[np.floating]
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]

ALMOST_ZERO = 1.2e-7  # float32's epsilon, as Processing compares


class Rows:
    """Columns of the recorded rows, and of the states that they refer to.

    Attributes
    ----------
    kinds, states, links : (n,) int32
    fills, strokes : (n,) int64, packed ARGB or NO_COLOR
    weights : (n,) float32
        Those recorded, times `weight_scale`.
    numbers : (n, 8) float32
    matrices : (s, 12) float32
        Modelview of each state, row-major.
    """

    def __init__(self, recorder: Recorder, weight_scale: float = 1.0) -> None:
        table = recorder.row_array()
        self.recorder = recorder
        self.kinds = table["kind"]
        self.states = table["state"]
        self.fills = table["fill"]
        self.strokes = table["stroke"]
        self.weight_scale = np.float32(weight_scale)
        self.weights = table["weight"] * self.weight_scale
        self.links = table["link"]
        self.numbers = table["numbers"]
        self.styles: list[Style] = recorder.styles
        self.stages: list[Stage] = recorder.stages
        self.matrices = np.array(recorder.matrices, np.float32).reshape(-1, 12)

    def of_states(self, value: Callable[[int], Any], dtype: type) -> NDArray[Any]:
        """Return a column over states."""
        return np.array([value(state) for state in range(len(self.styles))], dtype)

    @cached_property
    def is_3d(self) -> Bool:
        """Whether each state strokes in 3D, (s,)."""
        return self.of_states(lambda state: self.stages[state].is_3d, np.bool_)

    @cached_property
    def is_lit(self) -> bool:
        """Whether any row may be lit, so that normals and materials are needed."""
        return any(
            stage.lights is not None or stage.shadings.reads_normals for stage in self.stages
        )

    @cached_property
    def wants_uvs(self) -> bool:
        """Whether a shader may read texture coordinates of what has no texture."""
        is_retained = bool(self.is_retained.any())
        return is_retained or any(stage.shadings.reads_uvs for stage in self.stages)

    @cached_property
    def scales(self) -> F32:
        """By how much each state's matrix enlarges: cube root of its determinant, (s,)."""
        a, b, c, _, d, e, f, _, g, h, i, _ = self.matrices.T.astype(np.float64)
        determinants = a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
        return np.cbrt(np.abs(determinants)).astype(np.float32)

    @cached_property
    def is_java2d(self) -> Bool:
        """Whether each state follows JAVA2D, (s,)."""
        return self.of_states(lambda state: self.stages[state].is_java2d, np.bool_)

    @cached_property
    def is_retained(self) -> Bool:
        """Whether each state belongs to a shape that stays in its own coordinates, (s,)."""
        return self.of_states(lambda state: self.stages[state].sighting is not None, np.bool_)

    @cached_property
    def can_snap(self) -> Bool:
        """Whether each state moves aligned shapes to whole pixels, (s,): P2D without rotation.

        What is retained has no pixels yet.
        """
        turned: Bool = np.abs(self.matrices[:, [1, 4]]).max(axis=1, initial=0) >= ALMOST_ZERO
        return ~self.is_3d & ~turned & ~self.is_java2d & ~self.is_retained

    @cached_property
    def _sightings(self) -> F32:
        """Return the matrices under which sizes on the screen are measured, (s, 12)."""
        if not self.is_retained.any():
            return self.matrices
        pairs = zip(self.stages, self.matrices, strict=True)
        rows = [own if stage.sighting is None else stage.sighting for stage, own in pairs]
        return np.array(rows, np.float32)

    @cached_property
    def normals(self) -> F32:
        """Return the normal in force in each state, (s, 3), object space."""
        return np.array([style.normal for style in self.styles], np.float32)

    def groups(self, at: I64, value: Callable[[Style], Any]) -> Iterator[tuple[Any, I64]]:
        """Yield the rows `at` by a value of their style: value, rows."""
        used = np.unique(self.states[at])
        values = {int(state): value(self.styles[state]) for state in used}
        distinct = list(dict.fromkeys(values.values()))
        if len(distinct) == 1:
            yield distinct[0], at
            return
        for candidate in distinct:
            states = [state for state, own in values.items() if own == candidate]
            yield candidate, at[np.isin(self.states[at], states)]

    def transform(self, at: I64, x: F32, y: F32, z: F32) -> tuple[F32, F32, F32]:
        """Return eye-space coordinates of corners, each (n, k), of the rows `at`, (n,).

        The sums run in Processing's order and in single precision, so that they round alike.
        """
        return self._through(self.matrices, at, x, y, z)

    def _through(self, matrices: F32, at: I64, x: F32, y: F32, z: F32) -> tuple[F32, F32, F32]:
        """Return coordinates after one of the matrices, (s, 12), of each row's state."""
        states = self.states[at]
        if len(states) and (states == states[0]).all():
            m = matrices[states[0]]
        else:
            m = matrices[states].T[..., None]
        return (
            x * m[0] + y * m[1] + z * m[2] + m[3],
            x * m[4] + y * m[5] + z * m[6] + m[7],
            x * m[8] + y * m[9] + z * m[10] + m[11],
        )

    def on_screen(self, at: I64, x: F32, y: F32) -> tuple[F32, F32]:
        """Return pixels on the canvas of points with z = 0 of the rows `at`, (n,) each."""
        seen = self._through(self._sightings, at, x[:, None], y[:, None], ZERO)
        ex, ey, ez = (value[:, 0] for value in seen)
        if not self.is_3d[self.states[at]].any():
            return ex, ey
        sx, sy = ex.copy(), ey.copy()
        stages = [self.stages[state] for state in self.states[at]]
        solid = np.array([stage.is_3d for stage in stages], np.bool_)
        for stage in dict.fromkeys(stage for stage in stages if stage.is_3d):
            mine = solid & np.array([other is stage for other in stages])
            width, height = stage.target.across, stage.target.down
            cx, cy, _, cw = project(stage.projection, ex[mine], ey[mine], ez[mine])
            sx[mine] = (cx / cw + 1) * width / 2
            sy[mine] = (1 - cy / cw) * height / 2
        return sx, sy


ZERO: F32 = np.zeros((1, 1), np.float32)


def project(matrix: Mat4, x: Floats, y: Floats, z: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Return x, y, z and w in clip space of eye-space points, in single precision if they are."""
    p = [x.dtype.type(number) for number in matrix]
    return (
        p[0] * x + p[1] * y + p[2] * z + p[3],
        p[4] * x + p[5] * y + p[6] * z + p[7],
        p[8] * x + p[9] * y + p[10] * z + p[11],
        p[12] * x + p[13] * y + p[14] * z + p[15],
    )
