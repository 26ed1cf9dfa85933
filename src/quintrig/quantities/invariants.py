"""Six algebraic invariants of a surface seen as a height field z.

Source: Fujita and Ohsaki (2009), after Iri et al. (2001).

With h = e_z - n_z n, the tangent vector of steepest ascent (components z1, z2 in the frame e1, e2), let Γ1, Γ2, Γ3 be
the second fundamental form of (h, h), (h, Jh), (Jh, Jh), J the quarter turn about n. Since the covariant Hessian of z
in the metric of the surface is n_z II, and the Hessian of the height field is II / n_z on horizontal projections, every
invariant is one of the Γ, K or H times a power of n_z. None depends on the side that n points to.
"""

from quintrig.support.compiled import scalar
from quintrig.support.tolerance import VERTICAL

Six = tuple[float, float, float, float, float, float]


@scalar
def slope_forms(a: float, b: float, c: float, z1: float, z2: float, sign: float) -> tuple[float, float, float]:
    """Return Γ1, Γ2, Γ3, length⁻¹; ``sign`` is that of n against e1 x e2."""
    first = a * z1 * z1 + 2.0 * b * z1 * z2 + c * z2 * z2
    third = a * z2 * z2 - 2.0 * b * z1 * z2 + c * z1 * z1
    second = sign * ((c - a) * z1 * z2 + b * (z1 * z1 - z2 * z2))
    return first, second, third


@scalar
def planar(gamma1: float, gamma2: float, gamma3: float, slope: float, mean: float, gaussian: float, nz: float) -> Six:
    """Return β0, β1, β2, γ1, γ2, γ3 in the metric of the horizontal plane; ``slope`` is 1 - n_z² = z1² + z2².

    The definition for a height field, in any parametrisation; infinite or NaN where |n_z| <= ``VERTICAL``.
    """
    i = 1.0 / (nz if abs(nz) > VERTICAL else 0.0)
    i2 = i * i
    i3 = i2 * i
    return (
        slope * i2,
        (gamma1 + 2.0 * mean * nz * nz) * i3,
        gaussian * i2 * i2,
        gamma1 * i3 * i2,
        gamma2 * i2 * i2,
        gamma3 * i3,
    )


@scalar
def surface(gamma1: float, gamma2: float, gamma3: float, slope: float, mean: float, gaussian: float, nz: float) -> Six:
    """Return β0, β1, β2, γ1, γ2, γ3 in the metric of the surface; bounded everywhere."""
    return (
        slope,
        2.0 * nz * mean,
        nz * nz * gaussian,
        nz * gamma1,
        abs(nz) * gamma2,
        nz * gamma3,
    )
