"""The bases of the field in 40 digits, from the papers' formulas alone; nothing here knows the product's."""

from mpmath import binomial, cos, cosh, mp, mpf, pi, sin, sinh

mp.dps = 40


def _sc(t):
    return sin(pi * t / 2), cos(pi * t / 2)


def trigonometric(m, t, alpha, zeta):
    """Orders 2 to 5 (Han, Ma and Huang 2009; Misro, Ramli and Ali 2017); m = n + 1 functions."""
    n = m - 1
    s, c = _sc(t)
    f0, fn = (1 - s) ** (n - 1) * (1 - alpha * s), (1 - c) ** (n - 1) * (1 - zeta * c)
    if n == 2:
        return [f0, 1 - f0 - fn, fn]
    f1 = s * (1 - s) ** (n - 2) * (n - 1 + alpha - alpha * s)
    fl = c * (1 - c) ** (n - 2) * (n - 1 + zeta - zeta * c)
    middle = {
        3: [],
        4: [2 * (1 - s) * (1 - c) * (2 + s + c)],
        5: [(1 - s) ** 2 * (1 - c) * (8 * s + 3 * c + 9), (1 - c) ** 2 * (1 - s) * (8 * c + 3 * s + 9)],
    }[n]
    return [f0, f1, *middle, fl, fn]


def generalised_trigonometric(m, t, alpha, zeta):
    """The recursion f_i <- (1 - t) f_i + t f_(i-1) from three functions (BiBi and others 2020)."""
    return _recursion(m, trigonometric(3, t, alpha, zeta), 1 - t, t)


def generalised_trigonometric_squares(m, t, alpha, zeta):
    s, c = _sc(t)
    return _recursion(m, trigonometric(3, t, alpha, zeta), c**2, s**2)


def _recursion(m, f, down, up):
    while len(f) < m:
        f = [down * x + up * y for x, y in zip([*f, 0], [0, *f], strict=True)]
    return f


def bernstein(m, t):
    return [_b(i, m - 1, t) for i in range(m)]


def _b(i, n, t):
    return binomial(n, i) * t**i * (1 - t) ** (n - i) if 0 <= i <= n else mpf(0)


def sg_bezier(m, t, *lam):
    """Hu and others 2017, equation (1), with h = ceil(n/2)."""
    n, h = m - 1, -(-(m - 1) // 2)
    lam = (None, *lam)
    result = [(1 - t) ** n * (1 - lam[1] * t)]
    for i in range(1, n):
        x, y = lam[i], lam[i + 1]
        if i < h:
            inner = binomial(n, i) + x - x * t - y * t
        elif i == h:
            inner = binomial(n, i) + x - x * t + y * t
        else:
            inner = binomial(n, i) - x + x * t + y * t
        result.append(t**i * (1 - t) ** (n - i) * inner)
    return [*result, t**n * (1 - lam[n] + lam[n] * t)]


def lambda_bezier(m, t, lam):
    """Ye, Long and Zeng 2010."""
    n = m - 1
    inner = [
        _b(i, n, t)
        + lam
        * (mpf(n - 2 * i + 1) / (n * n - 1) * _b(i, n + 1, t) - mpf(n - 2 * i - 1) / (n * n - 1) * _b(i + 1, n + 1, t))
        for i in range(1, n)
    ]
    first = _b(0, n, t) - lam / (n + 1) * _b(1, n + 1, t)
    last = _b(n, n, t) - lam / (n + 1) * _b(n, n + 1, t)
    return [first, *inner, last]


def alpha_bernstein(m, t, alpha):
    """Chen and others 2017; 0 < t < 1, as the formula divides by both."""
    n = m - 1

    def count(k, i):
        return binomial(k, i) if 0 <= i <= k else 0

    return [
        (
            count(n - 2, i) * (1 - alpha) * t
            + count(n - 2, i - 2) * (1 - alpha) * (1 - t)
            + count(n, i) * alpha * t * (1 - t)
        )
        * t ** (i - 1)
        * (1 - t) ** (n - i - 1)
        for i in range(m)
    ]


def ali_cubic(m, t, p, q):
    r = 1 - t
    return [r**2 * (1 + (2 - p) * t), p * t * r**2, q * t**2 * r, t**2 * (1 + (2 - q) * r)]


def q_bernstein(m, t, q):
    """Phillips 1997, with q-integers as sums."""
    n = m - 1

    def factorial(k):
        result = mpf(1)
        for j in range(1, k + 1):
            result *= sum(q**e for e in range(j))
        return result

    result = []
    for i in range(m):
        value = factorial(n) / factorial(i) / factorial(n - i) * t**i
        for k in range(n - i):
            value *= 1 - q**k * t
        result.append(value)
    return result


def normalised_trigonometric(m, t, beta):
    """The Bernstein products of order n = (m - 1)/2, normalised so that they sum to 1 (Sanchez-Reyes 1998)."""
    n = (m - 1) // 2
    weights = [mpf(1)]
    for _ in range(n):  # the coefficients of (x² + 2 cos(β/2) x y + y²)^n
        weights = [
            a + 2 * cos(beta / 2) * b + c
            for a, b, c in zip([*weights, 0, 0], [0, *weights, 0], [0, 0, *weights], strict=True)
        ]
    x, y = sin((1 - t) * beta / 2), sin(t * beta / 2)
    return [w * x ** (2 * n - i) * y**i / sin(beta / 2) ** (2 * n) for i, w in enumerate(weights)]


def c_bezier(m, t, phi):
    """Zhang 1996, with θ = φ t."""
    return _cubic(t, phi, sin, cos, lambda: mpf(1) if phi == pi else None)


def h_bezier(m, t, phi):
    return _cubic(t, phi, sinh, cosh, lambda: None)


def _cubic(t, a, sine, cosine, known):
    k = (a - sine(a)) / (1 - cosine(a))
    factor = known() or sine(a) / (a - 2 * k)

    def outer(x):
        return (x - sine(x)) / (a - sine(a))

    def inner(x):
        return factor * ((1 - cosine(x)) / (1 - cosine(a)) - outer(x))

    x, y = a * t, a * (1 - t)
    return [outer(y), inner(y), inner(x), outer(x)]


quadratic = cubic = quartic = quintic = trigonometric
