"""The curvature formulas, written once as scalar functions that Numba inlines into every driver.

At a point they start from the first and second partial derivatives. e1, e2 are the orthonormal tangent frame along
S_u, and a, b, c the second fundamental form in it, n = ± S_u x S_v / |S_u x S_v|. From these follow (do Carmo 1976,
§3.2-3.3)

    H = (a + c)/2,   R = hypot((a - c)/2, b),   κ1, κ2 = H ± R,   K = a c - b²,

which, unlike sqrt(H² - K), stay real at umbilics.
"""

import numpy as np

from quintrig.support.compiled import scalar

Three = tuple[float, float, float]


@scalar
def dot(a: Three, b: Three) -> float:
    """Return a · b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@scalar
def cross(a: Three, b: Three) -> Three:
    """Return a x b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@scalar
def inverse_area(normal: Three, tiny: float) -> float:
    """Return 1/W, W = |S_u x S_v|, length⁻²; NaN where W <= ``tiny`` (length²)."""
    area = np.sqrt(dot(normal, normal))
    return 1.0 / area if area > tiny else np.nan


@scalar
def form_in_frame(
    du: Three, dv: Three, duu: Three, duv: Three, dvv: Three, normal: Three, inverse: float, sign: float
) -> Three:
    """Return a, b, c, length⁻¹, from ``normal`` = S_u x S_v, not yet of length 1, and ``inverse`` = 1/W."""
    first = dot(du, du)
    over = 1.0 / first
    ratio = dot(du, dv) * over
    el, em, en = dot(duu, normal), dot(duv, normal), dot(dvv, normal)
    side = sign * inverse
    scale = side * inverse
    mixed = em - ratio * el
    return el * (side * over), mixed * scale, (en - ratio * (em + mixed)) * ((first * inverse) * scale)


@scalar
def gaussian(a: float, b: float, c: float) -> float:
    """Return K, length⁻²."""
    return a * c - b * b


@scalar
def mean(a: float, c: float) -> float:
    """Return H, length⁻¹."""
    return 0.5 * (a + c)


@scalar
def half_difference(a: float, b: float, c: float) -> float:
    """Return R = (κ1 - κ2)/2, length⁻¹."""
    d = 0.5 * (a - c)
    return np.sqrt(d * d + b * b)


@scalar
def shape_index(mean: float, half_difference: float, curvedness: float, flat: float) -> float:
    """Return S = -(2/π) atan2(H, R), in [-1, 1], cap +1 (Koenderink and van Doorn 1992, with n outwards).

    NaN where the curvedness is not above ``flat`` (length⁻¹), rounding of a plane.
    """
    return -2.0 / np.pi * _angle(mean, half_difference) if curvedness > flat else np.nan


@scalar
def _angle(y: float, x: float) -> float:
    """Return atan2(y, x) for x >= 0, within 2 units in the last place.

    A library call would keep the loop from vectorising. The angle to the nearest of 0, ±π/4 and ±π/2 has a tangent t
    with |t| <= tan(π/8); the polynomial is the Chebyshev fit of (atan(t)/t - 1)/t² there, to 6e-18.
    """
    size = abs(y)
    low = size <= 0.41421356237309503 * x
    high = x <= 0.41421356237309503 * size
    over = size if low else (-x if high else size - x)
    under = x if low else (size if high else size + x)
    base = 0.0 if low else (0.5 * np.pi if high else 0.25 * np.pi)
    t = over / under
    z = t * t
    p = -0.019176872294336067
    p = 0.039231646190551486 + z * p
    p = -0.05085449318930035 + z * p
    p = 0.05858148832731273 + z * p
    p = -0.06664511438164644 + z * p
    p = 0.07692183190171728 + z * p
    p = -0.09090904578095735 + z * p
    p = 0.11111111015255669 + z * p
    p = -0.14285714284666534 + z * p
    p = 0.1999999999999552 + z * p
    p = -0.3333333333333333 + z * p
    angle = base + (t + t * (z * p))
    return angle if y >= 0.0 else -angle


@scalar
def principal_direction(a: float, b: float, c: float, half_difference: float) -> tuple[float, float]:
    """Return cos θ, sin θ of the direction of κ1 in the frame e1, e2."""
    d = 0.5 * (a - c)
    # Of the two equal forms of the eigenvector, take the one without cancellation.
    x = half_difference + d if d >= 0.0 else b
    y = b if d >= 0.0 else half_difference - d
    inverse = 1.0 / np.sqrt(x * x + y * y)
    return x * inverse, y * inverse
