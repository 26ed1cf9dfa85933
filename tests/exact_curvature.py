"""Signs and values of curvature in fractions alone, from the definitions: an oracle for proofs.

At t = (4/π) atan(x), x a fraction, sine and cosine of πt/2 are fractions, and so is every derivative by the angle. A
series is a list [f, f', f''/2].
"""

from fractions import Fraction

ONE = [Fraction(1), Fraction(0), Fraction(0)]


def add(x, y, factor=1):
    """Return x + factor y."""
    return [a + factor * b for a, b in zip(x, y, strict=True)]


def times(*factors):
    """Return the product of series."""
    result = ONE
    for y in factors:
        result = [sum((result[i] * y[k - i] for i in range(k + 1)), Fraction(0)) for k in range(3)]
    return result


def quintic(x, alpha, zeta):
    """Return the series of the six functions at t = (4/π) atan(x), by the angle."""
    s, c = 2 * x / (1 + x * x), (1 - x * x) / (1 + x * x)
    s, c = [s, c, -s / 2], [c, -s, -c / 2]
    a, b = add(ONE, s, -1), add(ONE, c, -1)
    four_a, four_z = [4 + alpha, 0, 0], [4 + zeta, 0, 0]
    nine = [Fraction(9), Fraction(0), Fraction(0)]
    return [
        times(a, a, a, a, add(ONE, s, -alpha)),
        times(s, a, a, a, add(four_a, s, -alpha)),
        times(a, a, b, add(add(nine, s, 8), c, 3)),
        times(b, b, a, add(add(nine, c, 8), s, 3)),
        times(c, b, b, b, add(four_z, c, -zeta)),
        times(b, b, b, b, add(ONE, c, -zeta)),
    ]


def partials(points, shape, x, y):
    """Return S_u, S_v, S_uu, S_uv and S_vv by the angles, in fractions."""
    fu, fv = (quintic(t, *map(Fraction, pair)) for t, pair in ((x, shape[:2]), (y, shape[2:])))
    found = []
    for i, j in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)):
        factor = 2 if 2 in (i, j) else 1
        found.append(
            [
                factor * sum(Fraction(float(points[p][q][k])) * fu[p][i] * fv[q][j] for p in range(6) for q in range(6))
                for k in range(3)
            ]
        )
    return found


def dot(x, y):
    """Return the scalar product."""
    return sum(a * b for a, b in zip(x, y, strict=True))


def cross(x, y):
    """Return the vector product."""
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def curvature(points, shape, x, y):
    """Return |S_u x S_v|² by the angles, K, and 2 H |S_u x S_v|³, which has the sign of H."""
    su, sv, suu, suv, svv = partials(points, shape, x, y)
    n = cross(su, sv)
    big, middle, last = dot(suu, n), dot(suv, n), dot(svv, n)
    e, f, g = dot(su, su), dot(su, sv), dot(sv, sv)
    area = dot(n, n)
    return area, (big * last - middle * middle) / area**2 if area else None, e * last - 2 * f * middle + g * big
