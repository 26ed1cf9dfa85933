"""The curvature formulas, written once as scalar functions that Numba inlines into every driver.

At a point they start from the first and second partial derivatives. e1, e2 are the orthonormal tangent frame along
S_u, and a, b, c the second fundamental form in it, n = ± S_u x S_v / |S_u x S_v|. From these follow (do Carmo 1976,
§3.2-3.3)

    H = (a + c)/2,   R = hypot((a - c)/2, b),   κ1, κ2 = H ± R,   K = a c - b²,

which, unlike sqrt(H² - K), stay real at umbilics.
"""

import numpy as np

from quintrig.compiled import scalar


@scalar
def first_form(ux: float, uy: float, uz: float, vx: float, vy: float, vz: float) -> tuple[float, float, float]:
    """Return E, F, G = S_u·S_u, S_u·S_v, S_v·S_v, length²."""
    return ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz


@scalar
def unit_normal(
    ux: float, uy: float, uz: float, vx: float, vy: float, vz: float, sign: float, tiny: float
) -> tuple[float, float, float, float]:
    """Return n = sign S_u x S_v / W and 1/W; all NaN where W <= ``tiny`` (length²), the singular points."""
    x = uy * vz - uz * vy
    y = uz * vx - ux * vz
    z = ux * vy - uy * vx
    area = np.sqrt(x * x + y * y + z * z)
    inverse = 1.0 / area if area > tiny else np.nan
    scale = sign * inverse
    return x * scale, y * scale, z * scale, inverse


@scalar
def second_form_in_frame(
    e: float, f: float, inverse: float, el: float, em: float, en: float
) -> tuple[float, float, float]:
    """Return a, b, c from E, F, 1/W and L, M, N; length⁻¹."""
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
