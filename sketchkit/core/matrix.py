"""Transforms as plain tuples of floats: products, rotations, cameras, projections.

Row-major, with column vectors: the point p goes to m @ p, and `translate(m, ...)` is m @ T, so what
is applied last reaches the point first. y points down in sketch space; the projections turn it
over, as Processing's do (their second diagonal number is negative).

An Affine has 12 numbers, the last row (0, 0, 0, 1) being understood; a Mat4 has all 16. Each
operation touches only the numbers that it changes: these run at every call of a sketch.
"""

from math import cbrt, cos, sin, sqrt, tan
from typing import TypeAlias

from sketchkit.core.float32 import f32

Vector: TypeAlias = tuple[float, float, float]
Affine: TypeAlias = tuple[float, ...]  # 12
Mat4: TypeAlias = tuple[float, ...]  # 16
Mat3: TypeAlias = tuple[float, ...]  # 9

IDENTITY: Affine = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
IDENTITY4: Mat4 = (*IDENTITY, 0.0, 0.0, 0.0, 1.0)

# The projection that lays every point behind the far plane. Processing divides by 0 there, and its
# infinite numbers show nothing; ours stay numbers.
SEES_NOTHING: Mat4 = (*(0.0,) * 8, *(0.0, 0.0, 0.0, 2.0), *(0.0, 0.0, 0.0, 1.0))

NOTHING = 1.2e-7  # float32's epsilon: Processing takes a squared axis or a length below it for zero


def translate(m: Affine, x: float, y: float, z: float = 0.0) -> Affine:
    """Return `m` with its origin moved by (x, y, z), in its own units."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    tx += a * x + b * y + c * z
    ty += d * x + e * y + f * z
    tz += g * x + h * y + i * z
    return a, b, c, tx, d, e, f, ty, g, h, i, tz


def scale(m: Affine, x: float, y: float, z: float = 1.0) -> Affine:
    """Return `m` with its axes stretched by x, y and z."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    return a * x, b * y, c * z, tx, d * x, e * y, f * z, ty, g * x, h * y, i * z, tz


def rotate_x(m: Affine, angle: float) -> Affine:
    """Return `m` turned about its x axis; `angle` in radians, from y towards z."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    p = cos(angle)
    q = sin(angle)
    b, c = b * p + c * q, c * p - b * q
    e, f = e * p + f * q, f * p - e * q
    h, i = h * p + i * q, i * p - h * q
    return a, b, c, tx, d, e, f, ty, g, h, i, tz


def rotate_y(m: Affine, angle: float) -> Affine:
    """Return `m` turned about its y axis; `angle` in radians, from z towards x."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    p = cos(angle)
    q = sin(angle)
    a, c = a * p - c * q, c * p + a * q
    d, f = d * p - f * q, f * p + d * q
    g, i = g * p - i * q, i * p + g * q
    return a, b, c, tx, d, e, f, ty, g, h, i, tz


def rotate_z(m: Affine, angle: float) -> Affine:
    """Return `m` turned about its z axis; `angle` in radians, from x towards y."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    p = cos(angle)
    q = sin(angle)
    a, b = a * p + b * q, b * p - a * q
    d, e = d * p + e * q, e * p - d * q
    g, h = g * p + h * q, h * p - g * q
    return a, b, c, tx, d, e, f, ty, g, h, i, tz


def rotate_axis(m: Affine, angle: float, x: float, y: float, z: float) -> Affine:
    """Return `m` turned by `angle` radians about the axis (x, y, z), of any length but zero."""
    length_squared = x * x + y * y + z * z
    if length_squared < NOTHING:
        return m
    length = sqrt(length_squared)
    x /= length
    y /= length
    z /= length
    p = cos(angle)
    q = sin(angle)
    t = 1.0 - p
    row_x = t * x * x + p, t * x * y - q * z, t * x * z + q * y, 0.0
    row_y = t * x * y + q * z, t * y * y + p, t * y * z - q * x, 0.0
    row_z = t * x * z - q * y, t * y * z + q * x, t * z * z + p, 0.0
    return multiply(m, row_x + row_y + row_z)


def shear_x(m: Affine, angle: float) -> Affine:
    """Return `m` sheared so that x grows by tan(angle) for each y."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    t = tan(angle)
    return a, b + a * t, c, tx, d, e + d * t, f, ty, g, h + g * t, i, tz


def shear_y(m: Affine, angle: float) -> Affine:
    """Return `m` sheared so that y grows by tan(angle) for each x."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    t = tan(angle)
    return a + b * t, b, c, tx, d + e * t, e, f, ty, g + h * t, h, i, tz


def multiply(m: Affine, n: Affine) -> Affine:
    """Return m @ n, of two affine transforms."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    j, k, l_, ux, o, p, q, uy, r, s, t, uz = n
    return (
        a * j + b * o + c * r,
        a * k + b * p + c * s,
        a * l_ + b * q + c * t,
        a * ux + b * uy + c * uz + tx,
        d * j + e * o + f * r,
        d * k + e * p + f * s,
        d * l_ + e * q + f * t,
        d * ux + e * uy + f * uz + ty,
        g * j + h * o + i * r,
        g * k + h * p + i * s,
        g * l_ + h * q + i * t,
        g * ux + h * uy + i * uz + tz,
    )


def multiply4(m: Mat4, n: Mat4) -> Mat4:
    """Return m @ n, of two full matrices."""
    n00, n01, n02, n03, n10, n11, n12, n13, n20, n21, n22, n23, n30, n31, n32, n33 = n
    product: list[float] = []
    for row in (0, 4, 8, 12):
        a, b, c, d = m[row : row + 4]
        product += (
            a * n00 + b * n10 + c * n20 + d * n30,
            a * n01 + b * n11 + c * n21 + d * n31,
            a * n02 + b * n12 + c * n22 + d * n32,
            a * n03 + b * n13 + c * n23 + d * n33,
        )
    return tuple(product)


def inverse(m: Affine) -> Affine | None:
    """Return the transform that undoes `m`, or None if `m` flattens space."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    a_minor = e * i - f * h
    b_minor = f * g - d * i
    c_minor = d * h - e * g
    det = a * a_minor + b * b_minor + c * c_minor
    if det == 0.0:
        return None
    j, k, l_ = a_minor / det, (c * h - b * i) / det, (b * f - c * e) / det
    o, p, q = b_minor / det, (a * i - c * g) / det, (c * d - a * f) / det
    r, s, t = c_minor / det, (b * g - a * h) / det, (a * e - b * d) / det
    ux = -(j * tx + k * ty + l_ * tz)
    uy = -(o * tx + p * ty + q * tz)
    uz = -(r * tx + s * ty + t * tz)
    return j, k, l_, ux, o, p, q, uy, r, s, t, uz


def inverse4(m: Mat4) -> Mat4 | None:
    """Return the matrix that undoes `m`, or None if there is none."""
    upper, lower = _minors(m[:8]), _minors(m[8:])
    det = _determinant(upper, lower)
    if det == 0.0:
        return None
    m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23, m30, m31, m32, m33 = m
    s0, s1, s2, s3, s4, s5 = (minor / det for minor in upper)
    c0, c1, c2, c3, c4, c5 = (minor / det for minor in lower)
    return (
        *(m11 * c5 - m12 * c4 + m13 * c3, -m01 * c5 + m02 * c4 - m03 * c3),
        *(m31 * s5 - m32 * s4 + m33 * s3, -m21 * s5 + m22 * s4 - m23 * s3),
        *(-m10 * c5 + m12 * c2 - m13 * c1, m00 * c5 - m02 * c2 + m03 * c1),
        *(-m30 * s5 + m32 * s2 - m33 * s1, m20 * s5 - m22 * s2 + m23 * s1),
        *(m10 * c4 - m11 * c2 + m13 * c0, -m00 * c4 + m01 * c2 - m03 * c0),
        *(m30 * s4 - m31 * s2 + m33 * s0, -m20 * s4 + m21 * s2 - m23 * s0),
        *(-m10 * c3 + m11 * c1 - m12 * c0, m00 * c3 - m01 * c1 + m02 * c0),
        *(-m30 * s3 + m31 * s1 - m32 * s0, m20 * s3 - m21 * s1 + m22 * s0),
    )


def determinant4(m: Mat4) -> float:
    """Return the factor by which `m` scales volumes; zero if it cannot be undone."""
    return _determinant(_minors(m[:8]), _minors(m[8:]))


def transpose4(m: Mat4) -> Mat4:
    """Return `m` with rows and columns exchanged."""
    return m[0::4] + m[1::4] + m[2::4] + m[3::4]


def transpose3(m: Mat3) -> Mat3:
    """Return `m` with rows and columns exchanged."""
    return m[0::3] + m[1::3] + m[2::3]


def normal_matrix(m: Affine) -> Mat3:
    """Return what takes normals along when `m` takes points: the inverse transposed, 3x3.

    Of what cannot be undone it is the identity: there is no right normal.
    """
    undone = inverse(m)
    if undone is None:
        return (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    a, b, c, _, d, e, f, _, g, h, i, _ = undone
    return a, d, g, b, e, h, c, f, i


def volume_scale(m: Affine) -> float:
    """Return by how much `m` enlarges, as one length: the cube root of its determinant."""
    a, b, c, _, d, e, f, _, g, h, i, _ = m
    determinant = a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    return cbrt(abs(determinant))


def to_mat4(m: Affine) -> Mat4:
    """Return `m` with its last row written out."""
    return (*m, 0.0, 0.0, 0.0, 1.0)


def transform_point(m: Affine, x: float, y: float, z: float) -> Vector:
    """Return where `m` takes the point (x, y, z)."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz = m
    return (
        a * x + b * y + c * z + tx,
        d * x + e * y + f * z + ty,
        g * x + h * y + i * z + tz,
    )


def transform4(m: Mat4, x: float, y: float, z: float, w: float = 1.0) -> Mat4:
    """Return the four numbers of m @ (x, y, z, w), undivided."""
    a, b, c, tx, d, e, f, ty, g, h, i, tz, j, k, l_, tw = m
    return (
        a * x + b * y + c * z + tx * w,
        d * x + e * y + f * z + ty * w,
        g * x + h * y + i * z + tz * w,
        j * x + k * y + l_ * z + tw * w,
    )


def look_at(eye: Vector, centre: Vector, up: Vector) -> Affine:
    """Return the modelview of a camera at `eye` that looks at `centre`.

    `up` is the direction that runs *down* the picture: Processing's default is (0, 1, 0).
    """
    z = _unit(tuple(e - c for e, c in zip(eye, centre, strict=True)))
    x = _cross(up, z)
    y = _cross(z, x)
    x, y = _unit(x), _unit(y)
    ex, ey, ez = eye
    return translate((*x, 0.0, *y, 0.0, *z, 0.0), -ex, -ey, -ez)


# Cameras and projections follow Processing's 32-bit steps: where two strokes coincide, the last bit
# of the projection decides which of them shows.


def eye_distance(height: float, fov: float) -> float:
    """Return how far an eye must be to see `height` at the angle `fov`, in radians."""
    return f32(f32(height / 2) / f32(tan(f32(fov / 2))))


def perspective(fov: float, aspect: float, near: float, far: float) -> Mat4:
    """Return the projection of a lens that opens `fov` radians from top to bottom."""
    if fov == 0 or aspect == 0:
        return SEES_NOTHING
    top = f32(f32(near) * f32(tan(f32(f32(fov) / 2))))
    side = f32(top * f32(aspect))
    return frustum(-side, side, -top, top, near, far)


def frustum(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Mat4:
    """Return the projection that sees through the given window in the plane at `near`."""
    left, right, bottom, top, near, far = map(f32, (left, right, bottom, top, near, far))
    width, height, depth = f32(right - left), f32(top - bottom), f32(far - near)
    return (
        *(f32(2 * near / width), 0.0, f32(f32(right + left) / width), 0.0),
        *(0.0, f32(-2 * near / height), f32(f32(top + bottom) / height), 0.0),
        *(0.0, 0.0, f32(-f32(far + near) / depth), f32(-f32(2 * near * far) / depth)),
        *(0.0, 0.0, -1.0, 0.0),
    )


def ortho(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Mat4:
    """Return the projection of a box without perspective, about the camera's axis."""
    left, right, bottom, top, near, far = map(f32, (left, right, bottom, top, near, far))
    width, height, depth = f32(right - left), f32(top - bottom), f32(far - near)
    return (
        *(f32(2 / width), 0.0, 0.0, f32(-f32(right + left) / width)),
        *(0.0, f32(-2 / height), 0.0, f32(-f32(top + bottom) / height)),
        *(0.0, 0.0, f32(-2 / depth), f32(-f32(far + near) / depth)),
        *(0.0, 0.0, 0.0, 1.0),
    )


def _unit(v: tuple[float, ...]) -> Vector:
    x, y, z = v
    length = sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length >= NOTHING else (x, y, z)


def _cross(u: Vector, v: Vector) -> Vector:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def _minors(rows: tuple[float, ...]) -> tuple[float, ...]:
    """Return the six 2x2 determinants of two rows, by pairs of columns: 01 02 03 12 13 23."""
    a, b, c, d, e, f, g, h = rows
    return a * f - b * e, a * g - c * e, a * h - d * e, b * g - c * f, b * h - d * f, c * h - d * g


def _determinant(upper: tuple[float, ...], lower: tuple[float, ...]) -> float:
    """Return the determinant from the minors of the two halves (Laplace's expansion)."""
    s0, s1, s2, s3, s4, s5 = upper
    c0, c1, c2, c3, c4, c5 = lower
    return s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0
