"""Values to 40 digits, worked out from the definitions alone: nothing here comes from quintrig.

Bases, constructions and reference surfaces are written from the thesis (eq. 2.2, §3.2-3.3) and the textbook,
derivatives are taken of the formulas themselves, and curvature and invariants follow the textbook definitions, such as
K = (LN - M²)/(EG - F²), rather than the forms that suit floating point. A model is a dictionary with the keys of a
model file.
"""

from functools import cache

from mpmath import MPContext

mp = MPContext()
mp.dps = 60

Vector = list  # of three mpf
Polynomial = dict  # {(i, j): coefficient of x^i y^j}

ZERO, ONE = mp.mpf(0), mp.mpf(1)


def number(value):
    """Return a float, an int or an mpf exactly."""
    return mp.mpf(value) if isinstance(value, (int, mp.mpf)) else mp.mpf(float(value))


def vectors(rows):
    """Return nested lists of floats as nested lists of mpf."""
    return [vectors(row) for row in rows] if hasattr(rows, "__len__") else number(rows)


# ---------------------------------------------------------------------------------------------- bases


def _times(*factors):
    result = {(0, 0): ONE}
    for factor in factors:
        product = {}
        for (i, j), x in result.items():
            for (k, m), y in factor.items():
                product[i + k, j + m] = product.get((i + k, j + m), ZERO) + x * y
        result = product
    return result


def _turning(polynomial):
    """Differentiate by t a polynomial in sin(πt/2) and cos(πt/2)."""
    result = {}
    for (i, j), x in polynomial.items():
        for key, value in (((i - 1, j + 1), i * x), ((i + 1, j - 1), -j * x)):
            if value:
                result[key] = result.get(key, ZERO) + value * mp.pi / 2
    return result


def _running(polynomial):
    """Differentiate by t a polynomial in t and 1 - t."""
    result = {}
    for (i, j), x in polynomial.items():
        for key, value in (((i - 1, j), i * x), ((i, j - 1), -j * x)):
            if value:
                result[key] = result.get(key, ZERO) + value
    return result


@cache
def _trigonometric(alpha, zeta, order):
    """Thesis eq. 2.2, and the derivatives up to ``order``, as polynomials in s and c."""
    a, z = number(alpha), number(zeta)
    s, c = {(1, 0): ONE}, {(0, 1): ONE}
    rest_s, rest_c = {(0, 0): ONE, (1, 0): -ONE}, {(0, 0): ONE, (0, 1): -ONE}
    f = [
        _times(rest_s, rest_s, rest_s, rest_s, {(0, 0): ONE, (1, 0): -a}),
        _times(s, rest_s, rest_s, rest_s, {(0, 0): 4 + a, (1, 0): -a}),
        _times(rest_s, rest_s, rest_c, {(1, 0): number(8), (0, 1): number(3), (0, 0): number(9)}),
        _times(rest_c, rest_c, rest_s, {(0, 1): number(8), (1, 0): number(3), (0, 0): number(9)}),
        _times(c, rest_c, rest_c, rest_c, {(0, 0): 4 + z, (0, 1): -z}),
        _times(rest_c, rest_c, rest_c, rest_c, {(0, 0): ONE, (0, 1): -z}),
    ]
    return _chain(f, _turning, order)


@cache
def _bernstein(degree, order):
    return _chain(
        [{(i, degree - i): mp.binomial(degree, i)} for i in range(degree + 1)],
        _running,
        order,
    )


def _chain(functions, differentiate, order):
    result = [functions]
    for _ in range(order):
        result.append([differentiate(f) for f in result[-1]])
    return result


def _evaluate(families, x, y):
    highest = max((max(key) for family in families for f in family for key in f), default=0)
    xs, ys = [x**k for k in range(highest + 1)], [y**k for k in range(highest + 1)]
    return [[mp.fsum(a * xs[i] * ys[j] for (i, j), a in f.items()) for f in family] for family in families]


def trigonometric(t, alpha, zeta, order=0):
    """Return derivatives 0 to ``order`` of the six functions of thesis eq. 2.2: a list of lists of six."""
    t = number(t)
    return _evaluate(_trigonometric(alpha, zeta, order), mp.sinpi(t / 2), mp.cospi(t / 2))


def bernstein(t, degree, order=0):
    """Return derivatives 0 to ``order`` of the Bernstein polynomials."""
    t = number(t)
    return _evaluate(_bernstein(degree, order), t, 1 - t)


def basis(name, count, alpha, zeta, t, order):
    """Return derivatives 0 to ``order`` of the basis called ``name`` on ``count`` points."""
    return bernstein(t, count - 1, order) if name == "bernstein" else trigonometric(t, alpha, zeta, order)


def b_spline(t, knots, degree, order=0):
    """Return derivatives 0 to ``order`` of B-splines, t in [0, 1] mapped to the knots' domain (Cox, de Boor)."""
    knots = vectors(knots)
    low, high = knots[degree], knots[-degree - 1]
    x = low + (high - low) * number(t)

    def ratio(above, below):
        return above / below if below != 0 else ZERO

    def value(i, p):
        if p == 0:
            last = knots[i + 1] == high and knots[i] < high and x == high
            return ONE if knots[i] <= x < knots[i + 1] or last else ZERO
        rising = ratio(x - knots[i], knots[i + p] - knots[i]) * value(i, p - 1)
        return rising + ratio(knots[i + p + 1] - x, knots[i + p + 1] - knots[i + 1]) * value(i + 1, p - 1)

    def derivative(i, p, k):
        if k == 0:
            return value(i, p)
        if p == 0:
            return ZERO
        rising = ratio(p * derivative(i, p - 1, k - 1), knots[i + p] - knots[i])
        return rising - ratio(p * derivative(i + 1, p - 1, k - 1), knots[i + p + 1] - knots[i + 1])

    count = len(knots) - degree - 1
    return [[(high - low) ** k * derivative(i, degree, k) for i in range(count)] for k in range(order + 1)]


# ---------------------------------------------------------------------------------------------- vectors


def dot(x, y):
    """Return the scalar product."""
    return mp.fsum(a * b for a, b in zip(x, y, strict=True))


def cross(x, y):
    """Return the vector product."""
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def norm(x):
    """Return the length."""
    return mp.sqrt(dot(x, x))


def _sum(weights, points):
    return [mp.fsum(w * p[x] for w, p in zip(weights, points, strict=True)) for x in range(len(points[0]))]


def _add(*points):
    return [mp.fsum(parts) for parts in zip(*points, strict=True)]


def _by(factor, point):
    return [factor * x for x in point]


# ---------------------------------------------------------------------------------------------- curves


def curve(points, alpha, zeta, t, order=0, basis_name="trigonometric"):
    """Return derivatives 0 to ``order`` of a Bézier curve: a list of points."""
    points = vectors(points)
    return [_sum(f, points) for f in basis(basis_name, len(points), alpha, zeta, t, order)]


def curvature(points, alpha, zeta, t):
    """Return |z' x z''| / |z'|³ of a space curve."""
    _, first, second = curve(points, alpha, zeta, t, 2)
    return norm(cross(first, second)) / norm(first) ** 3


def torsion(points, alpha, zeta, t):
    """Return det(z', z'', z''') / |z' x z''|² of a space curve."""
    _, first, second, third = curve(points, alpha, zeta, t, 3)
    normal = cross(first, second)
    return dot(normal, third) / dot(normal, normal)


def length(points, alpha, zeta):
    """Return the arc length of a whole curve, to some 25 digits."""
    return mp.quad(lambda t: norm(curve(points, alpha, zeta, t, 1)[1]), mp.linspace(0, 1, 5))


# ---------------------------------------------------------------------------------------------- surfaces

ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))


def partials(model, u, v):
    """Return {(i, j): ∂^(i+j)S / ∂u^i ∂v^j} for i + j <= 2."""
    return _KINDS[model["kind"]](model, number(u), number(v))


def _families(model, counts, u, v):
    a1, z1, a2, z2 = model["shape"]
    name = model.get("basis", "trigonometric")
    return basis(name, counts[0], a1, z1, u, 2), basis(name, counts[1], a2, z2, v, 2)


def _product(net, fu, fv):
    return {(i, j): _sum(fv[j], [_sum(fu[i], column) for column in zip(*net, strict=True)]) for i, j in ORDERS}


def _tensor(model, u, v):
    net = vectors(model["points"])
    return _product(net, *_families(model, (len(net), len(net[0])), u, v))


def _symmetric(model, u, v):
    half, (a, b, c, d) = vectors(model["points"]), vectors(model["mirror"])
    n = [a, b, c]

    def image(point):
        return _add(point, _by(-2 * (dot(n, point) + d) / dot(n, n), n))

    net = half + [[image(point) for point in row] for row in reversed(half)]
    return _product(net, *_families(model, (len(net), len(net[0])), u, v))


def _swept(model, u, v):
    section, trajectory = vectors(model["section"]), vectors(model["trajectory"])
    fu, fv = _families(model, (len(section), len(trajectory)), u, v)
    c, t = [_sum(f, section) for f in fu], [_sum(f, trajectory) for f in fv]
    nothing = [ZERO] * 3
    return {(0, 0): _add(c[0], t[0]), (1, 0): c[1], (2, 0): c[2], (1, 1): nothing, (0, 1): t[1], (0, 2): t[2]}


def _swung(model, u, v):
    profile, trajectory = vectors(model["profile"]), vectors(model["trajectory"])
    fu, fv = _families(model, (len(profile), len(trajectory)), u, v)
    scale = number(model.get("scale", 1.0))
    p, t = [_sum(f, profile) for f in fu], [_sum(f, trajectory) for f in fv]
    return {
        (i, j): [scale * p[i][0] * t[j][0], scale * p[i][0] * t[j][1], p[i][1] if j == 0 else ZERO] for i, j in ORDERS
    }


def _ruled(model, u, v):
    a1, z1, a2, z2 = model["shape"]
    first, second, name = vectors(model["first"]), vectors(model["second"]), model.get("basis", "trigonometric")
    a = [_sum(f, first) for f in basis(name, len(first), a1, z1, u, 2)]
    b = [_sum(f, second) for f in basis(name, len(second), a2, z2, u, 2)]
    return _between(a, b, v)


def _between(a, b, v):
    result = {(i, 0): _add(_by(1 - v, a[i]), _by(v, b[i])) for i in range(3)}
    result |= {(i, 1): _add(b[i], _by(-ONE, a[i])) for i in range(2)}
    return result | {(0, 2): [ZERO] * 3}


def _developable(model, u, v):
    alpha, zeta = model["shape"]
    planes, bounds = vectors(model["planes"]), vectors(model["bounds"])
    derived = [_sum(f, planes) for f in trigonometric(u, alpha, zeta, 4)]
    family = [_by(ONE / mp.factorial(k), x) for k, x in enumerate(derived)]  # Taylor coefficients of Π
    slope = [_by(k, x) for k, x in enumerate(family)][1:]  # and of Π'
    if norm(slope[0]) < mp.mpf(10) ** -40 * norm(family[0]):
        slope = slope[1:]  # Π' vanishes at an end: Π'/(t - t0) is the plane that makes the ruling there
    curves = [_meeting([family, slope, [bound]]) for bound in bounds]
    return _between(*curves, v)


def _meeting(series):
    """Return derivatives 0 to 2 of the point common to three planes given as Taylor series."""

    def term(rows, k):
        return rows[k] if k < len(rows) else [ZERO] * 4

    first = mp.matrix([term(rows, 0)[:3] for rows in series])
    found = []
    for k in range(3):
        right = [
            -term(rows, k)[3] - mp.fsum(dot(term(rows, i)[:3], found[k - i]) for i in range(1, k + 1))
            for rows in series
        ]
        found.append(list(mp.lu_solve(first, mp.matrix(right))))
    return [_by(mp.factorial(k), x) for k, x in enumerate(found)]


def _nurbs(model, u, v):
    points, weights = vectors(model["points"]), vectors(model["weights"])
    net = [[[*_by(w, p), w] for p, w in zip(*row, strict=True)] for row in zip(points, weights, strict=True)]
    families = (b_spline(t, k, p, 2) for t, k, p in zip((u, v), model["knots"], model["degrees"], strict=True))
    h = _product(net, *families)
    top, w = {o: x[:3] for o, x in h.items()}, {o: x[3] for o, x in h.items()}
    s = {(0, 0): _by(1 / w[0, 0], top[0, 0])}
    for o in ((1, 0), (0, 1)):
        s[o] = _by(1 / w[0, 0], _add(top[o], _by(-w[o], s[0, 0])))
    for o, a, b in (((2, 0), (1, 0), (1, 0)), ((1, 1), (1, 0), (0, 1)), ((0, 2), (0, 1), (0, 1))):
        rest = _add(top[o], _by(-w[o], s[0, 0]), _by(-w[a], s[b]), _by(-w[b], s[a]))
        s[o] = _by(1 / w[0, 0], rest)
    return s


def _position(kind):
    """Turn S(model, u, v) into partials, by central differences in 150 digits or so."""

    def partial(model, u, v):
        return {
            order: [mp.diff(lambda p, q, x=x: kind(model, p, q)[x], (u, v), order) for x in range(3)]
            if any(order)
            else kind(model, u, v)
            for order in ORDERS
        }

    return partial


def _around(r, z, v):
    return [r * mp.cospi(2 * v), r * mp.sinpi(2 * v), z]


def _ellipsoid(model, u, v):
    a, b, c = (number(model[key]) for key in "abc")
    latitude = u - number(0.5)
    x, y, z = _around(mp.cospi(latitude), mp.sinpi(latitude), v)
    return [a * x, b * y, c * z]


def _sphere(model, u, v):
    radius = model["radius"]
    return _ellipsoid({"a": radius, "b": radius, "c": radius}, u, v)


def _cylinder(model, u, v):
    return _around(number(model["radius"]), number(model["height"]) * u, v)


def _cone(model, u, v):
    return _around(number(model["radius"]) * (1 - u), number(model["height"]) * u, v)


def _torus(model, u, v):
    r, minor = number(model["major"]), number(model["minor"])
    return _around(r + minor * mp.cospi(2 * u), minor * mp.sinpi(2 * u), v)


def _catenoid(model, u, v):
    a, z = number(model["waist"]), number(model["height"]) * (u - number(0.5))
    return _around(a * mp.cosh(z / a), z, v)


def _helicoid(model, u, v):
    return _around(number(model["radius"]) * (2 * u - 1), number(model["pitch"]) * v, v)


def _square(model, u, v):
    size = number(model["size"])
    return size * (2 * u - 1), size * (2 * v - 1)


def _hyperbolic_paraboloid(model, u, v):
    x, y = _square(model, u, v)
    return [x, y, x * y]


def _monkey_saddle(model, u, v):
    x, y = _square(model, u, v)
    return [x, y, x**3 - 3 * x * y**2]


def _enneper(model, u, v):
    p, q = _square(model, u, v)
    return [p - p**3 / 3 + p * q**2, q - q**3 / 3 + q * p**2, p**2 - q**2]


_KINDS = {
    "tensor": _tensor,
    "symmetric": _symmetric,
    "swept": _swept,
    "swung": _swung,
    "ruled": _ruled,
    "developable": _developable,
    "nurbs": _nurbs,
    "sphere": _position(_sphere),
    "ellipsoid": _position(_ellipsoid),
    "cylinder": _position(_cylinder),
    "cone": _position(_cone),
    "torus": _position(_torus),
    "catenoid": _position(_catenoid),
    "helicoid": _position(_helicoid),
    "hyperbolic_paraboloid": _position(_hyperbolic_paraboloid),
    "monkey_saddle": _position(_monkey_saddle),
    "enneper": _position(_enneper),
}


TURNED = ("sphere", "ellipsoid", "cylinder", "cone", "torus", "catenoid")
"""Surfaces of revolution, whose normal points outwards: with u along the profile and v around, along S_v x S_u."""


# ---------------------------------------------------------------------------------------------- analysis


def values(model, u, v):
    """Return every real quantity of quintrig's table at a point, by key; None where the point is singular.

    Beside those, ``partials`` and ``area`` = |S_u x S_v|.
    """
    p = partials(model, u, v)
    su, sv, suu, suv, svv = (p[order] for order in ORDERS[1:])
    normal = cross(su, sv)
    area = norm(normal)
    if area <= mp.mpf(10) ** -38 * max(norm(su), norm(sv)) ** 2 or area == 0:
        return None
    n = _by(ONE / area, normal)
    if model.get("flip", False) != (model["kind"] in TURNED):
        n = _by(-ONE, n)
    e, f, g = dot(su, su), dot(su, sv), dot(sv, sv)
    el, em, en = dot(suu, n), dot(suv, n), dot(svv, n)
    gaussian = (el * en - em**2) / (e * g - f**2)
    mean = (e * en - 2 * f * em + g * el) / (2 * (e * g - f**2))
    radius = mp.sqrt(max(mean**2 - gaussian, ZERO))
    k1, k2 = mean + radius, mean - radius
    curved = mp.sqrt((k1**2 + k2**2) / 2)
    result = {
        "point": p[0, 0],
        "normal": n,
        "E": e,
        "F": f,
        "G": g,
        "L": el,
        "M": em,
        "N": en,
        "gaussian": gaussian,
        "mean": mean,
        "k1": k1,
        "k2": k2,
        "shape_index": mp.nan if curved == 0 else -2 / mp.pi * mp.atan2(mean, radius),
        "curvedness": curved,
        "partials": p,
        "area": area,
    }
    result |= invariants(p, horizontal=True, suffix="")
    return result | invariants(p, horizontal=False, suffix="_surface")


def invariants(p, horizontal, suffix):
    """Return the six invariants of the height z in the metric of the horizontal plane, or in that of the surface.

    From the covariant Hessian z_ij - Γ^k_ij z_k; infinite ones, where n_z = 0, are left out.
    """
    axes = range(2) if horizontal else range(3)
    d = {order: [p[order][x] for x in axes] for order in ORDERS}
    first, second = (d[1, 0], d[0, 1]), ((d[2, 0], d[1, 1]), (d[1, 1], d[0, 2]))
    metric = [[dot(x, y) for y in first] for x in first]
    det = metric[0][0] * metric[1][1] - metric[0][1] ** 2
    if det <= mp.mpf(10) ** -38 * (metric[0][0] + metric[1][1]) ** 2:
        return {}
    inverse = [[metric[1][1] / det, -metric[0][1] / det], [-metric[0][1] / det, metric[0][0] / det]]
    slope = (p[1, 0][2], p[0, 1][2])
    heights = ((p[2, 0][2], p[1, 1][2]), (p[1, 1][2], p[0, 2][2]))

    def christoffel(k, i, j):
        return mp.fsum(inverse[k][m] * dot(second[i][j], first[m]) for m in range(2))

    hessian = [
        [heights[i][j] - mp.fsum(christoffel(k, i, j) * slope[k] for k in range(2)) for j in range(2)] for i in range(2)
    ]
    up = mp.sign(p[1, 0][0] * p[0, 1][1] - p[1, 0][1] * p[0, 1][0])
    raised = [mp.fsum(inverse[i][j] * slope[j] for j in range(2)) for i in range(2)]
    turned = [-up * slope[1] / mp.sqrt(det), up * slope[0] / mp.sqrt(det)]

    def form(x, y):
        return mp.fsum(x[i] * hessian[i][j] * y[j] for i in range(2) for j in range(2))

    results = {
        "beta0": dot(raised, slope),
        "beta1": mp.fsum(inverse[i][j] * hessian[i][j] for i in range(2) for j in range(2)),
        "beta2": (hessian[0][0] * hessian[1][1] - hessian[0][1] ** 2) / det,
        "gamma1": form(raised, raised),
        "gamma2": form(raised, turned),
        "gamma3": form(turned, turned),
    }
    return {key + suffix: value for key, value in results.items()}
