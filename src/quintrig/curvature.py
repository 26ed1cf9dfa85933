"""The curvature formulas, written once as scalar functions that Numba inlines into every driver.

At a point they start from the first and second partial derivatives. e1, e2 are the orthonormal tangent frame along
S_u, and a, b, c the second fundamental form in it, n = ± S_u x S_v / |S_u x S_v|. From these follow (do Carmo 1976,
§3.2-3.3)

    H = (a + c)/2,   R = hypot((a - c)/2, b),   κ1, κ2 = H ± R,   K = a c - b²,

which, unlike sqrt(H² - K), stay real at umbilics.
"""

import numpy as np

from quintrig.compiled import scalar

Three = tuple[float, float, float]
Frame = tuple[Three, float, Three, Three]
"""n, 1/W, (E, F, G), (L, M, N) of a point."""


@scalar
def dot(a: Three, b: Three) -> float:
    """Return a · b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@scalar
def frame(du: Three, dv: Three, duu: Three, duv: Three, dvv: Three, sign: float, tiny: float) -> Frame:
    """Return the normal, 1/W and both fundamental forms; all NaN where W = |S_u x S_v| <= ``tiny`` (length²)."""
    x = du[1] * dv[2] - du[2] * dv[1]
    y = du[2] * dv[0] - du[0] * dv[2]
    z = du[0] * dv[1] - du[1] * dv[0]
    area = np.sqrt(x * x + y * y + z * z)
    inverse = 1.0 / area if area > tiny else np.nan
    scale = sign * inverse
    n = (x * scale, y * scale, z * scale)
    first = (dot(du, du), dot(du, dv), dot(dv, dv))
    return n, inverse, first, (dot(duu, n), dot(duv, n), dot(dvv, n))


@scalar
def form_in_frame(at: Frame) -> Three:
    """Return a, b, c, length⁻¹."""
    _, inverse, (e, f, _), (el, em, en) = at
    over = 1.0 / e
    ratio = f * over
    a = el * over
    b = (em - ratio * el) * inverse
    c = (en - 2.0 * ratio * em + ratio * ratio * el) * (e * inverse) * inverse
    return a, b, c


@scalar
def mean_and_radius(a: float, b: float, c: float) -> tuple[float, float]:
    """Return H and R = (κ1 - κ2)/2, length⁻¹."""
    d = 0.5 * (a - c)
    return 0.5 * (a + c), np.sqrt(d * d + b * b)


@scalar
def shape_index(mean: float, radius: float, curvedness: float, flat: float) -> float:
    """Return S = -(2/π) atan2(H, R), in [-1, 1], cap +1 (Koenderink and van Doorn 1992, with n outwards).

    NaN where the curvedness is not above ``flat`` (length⁻¹), rounding of a plane.
    """
    return -2.0 / np.pi * np.arctan2(mean, radius) if curvedness > flat else np.nan


@scalar
def principal_direction(a: float, b: float, c: float, radius: float) -> tuple[float, float]:
    """Return cos θ, sin θ of the direction of κ1 in the frame e1, e2."""
    d = 0.5 * (a - c)
    # Of the two equal forms of the eigenvector, take the one without cancellation.
    x = radius + d if d >= 0.0 else b
    y = b if d >= 0.0 else radius - d
    length = np.sqrt(x * x + y * y)
    return x / length, y / length
