"""The bases of the field, as their papers define them: names, sources, ranges and formulas.

The formulas are written so that nothing cancels where a function is small: 1 - λt as r + (1 - λ)t, and the like.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.formulas import MOST_FUNCTIONS, Basis, Parameter
from quintrig.basis.functions import Functions
from quintrig.basis.trigonometric import Trigonometric

ANY, _MANY = range(2, MOST_FUNCTIONS + 1), range(3, MOST_FUNCTIONS + 1)


@dataclass(frozen=True)
class Entry:
    """A basis by name, for any number of control points that it has functions for.

    ``usual`` is that number where nobody says another. ``build`` makes a faster family than the formulas do, from the
    number of points, the parameters' values and whether these may leave their range.
    """

    name: str
    title: str
    source: str
    sizes: Sequence[int]
    usual: int
    formulas: Callable[[int], tuple[tuple[str, ...], tuple[Parameter, ...]]]
    build: Callable[[int, tuple[float, ...], bool], Functions] | None = None
    claims: tuple[str, ...] = ()

    def basis(self, points: int | None = None) -> Basis:
        """Return the basis as data for a number of control points; ValueError where it has none for so many."""
        points = self.usual if points is None else points
        if points not in self.sizes:
            raise ValueError(f"expected {self.counts} for the {self.name} basis, found {points}")
        return _basis(self, points)

    def family(self, points: int, values: Sequence[float] = (), unchecked: bool = False) -> Functions:
        """Return the functions for a number of control points; ValueError where points or values do not fit."""
        found = self.basis(points).family(values, unchecked)
        return self.build(points, found.values, unchecked) if self.build else found

    @property
    def classical(self) -> bool:
        """Whether these are the classical Bernstein polynomials, on which shape parameters do not act."""
        return self.build is _bernstein

    @property
    def counts(self) -> str:
        """How many control points it takes, in words."""
        sizes = self.sizes
        if len(sizes) == 1:
            return f"{sizes[0]} control points"
        if isinstance(sizes, range) and sizes.step == 1:
            end = " or more" if sizes[-1] == MOST_FUNCTIONS else f" to {sizes[-1]}"
            return f"{sizes[0]}{end} control points"
        return f"{', '.join(map(str, sizes[:-1]))} or {sizes[-1]} control points"


def of_basis(basis: Basis) -> Entry:
    """Return the entry of a basis that has one number of functions only."""
    size = basis.size
    formulas: Formulas = basis.functions, basis.parameters
    return Entry(basis.name, basis.name, basis.source, (size,), size, lambda _: formulas, claims=basis.claims)


@lru_cache(maxsize=256)
def _basis(entry: Entry, points: int) -> Basis:
    functions, parameters = entry.formulas(points)
    return Basis(entry.name, functions, parameters, entry.source, entry.claims, vouched=True)


Formulas = tuple[tuple[str, ...], tuple[Parameter, ...]]


def trigonometric(points: int) -> Formulas:
    """Return the trigonometric functions of order 2 to 5 with two shape parameters."""
    n = points - 1
    first = (f"{_power('a', n - 1)}*(1-alpha+alpha*a)", f"s*{_power('a', n - 2)}*({n - 1}+alpha-alpha*s)")
    last = (f"c*{_power('b', n - 2)}*({n - 1}+zeta-zeta*c)", f"{_power('b', n - 1)}*(1-zeta+zeta*b)")
    middle = {
        2: ("2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b",),
        3: (first[1], last[0]),
        4: (first[1], "2*a*b*(2+s+c)", last[0]),
        5: (first[1], "a^2*b*(8*s+3*c+9)", "b^2*a*(8*c+3*s+9)", last[0]),
    }[n]
    low = float(1 - n)
    return (first[0], *middle, last[1]), (Parameter("alpha", low, 1.0), Parameter("zeta", low, 1.0))


def _raised(base: Sequence[str], points: int, down: str, up: str) -> tuple[str, ...]:
    """Return what the recursion f_i <- ``down`` f_i + ``up`` f_(i-1) gives, from the base to so many functions."""
    steps = points - len(base)
    result: list[str] = []
    for i in range(points):
        terms = [
            f"{math.comb(steps, i - j)}*{_power(down, steps - i + j)}*{_power(up, i - j)}*({one})"
            for j, one in enumerate(base)
            if 0 <= i - j <= steps
        ]
        result.append("+".join(terms))
    return tuple(result)


def generalised(down: str, up: str) -> Callable[[int], Formulas]:
    """Return the generalised trigonometric functions of any number, raised by the pair given."""

    def functions(points: int) -> Formulas:
        base = (
            "a*(1-alpha+alpha*a)",
            "2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b",
            "b*(1-zeta+zeta*b)",
        )
        return _raised(base, points, down, up), (Parameter("alpha", -1.0, 1.0), Parameter("zeta", -1.0, 1.0))

    return functions


def bernstein(points: int) -> Formulas:
    """Return the Bernstein polynomials."""
    n = points - 1
    return tuple(f"{math.comb(n, i)}*{_ends(i, n)}" for i in range(points)), ()


def sg_bezier(points: int) -> Formulas:
    """Return the functions of shape-adjustable generalised Bézier curves, n parameters lam1 ... lamn."""
    n, half = points - 1, -(-(points - 1) // 2)
    lam = [f"lam{i}" for i in range(n + 1)]
    functions = [f"{_power('r', n)}*(r+(1-lam1)*t)"]
    for i in range(1, n):
        falling, rising = ("-" if i > half else "+"), ("-" if i < half else "+")
        count = math.comb(n, i)
        functions.append(f"{_ends(i, n)}*(({count}{falling}{lam[i]})*r+({count}{rising}{lam[i + 1]})*t)")
    functions.append(f"{_power('t', n)}*(t+(1-lam{n})*r)")
    ranges = [
        (-math.comb(n, i), math.comb(n, i - 1)) if i <= half else (-math.comb(n, i - 1), math.comb(n, i))
        for i in range(1, n + 1)
    ]
    return tuple(functions), tuple(Parameter(f"lam{i}", *ends) for i, ends in enumerate(ranges, 1))


def lambda_bezier(points: int) -> Formulas:
    """Return the functions of λ-Bézier curves."""
    n = points - 1
    functions = [f"{_power('r', n)}*(r+(1-lam)*t)"]
    for i in range(1, n):
        falling = Fraction((n - 2 * i + 1) * math.comb(n + 1, i), n * n - 1)
        rising = Fraction((n - 2 * i - 1) * math.comb(n + 1, i + 1), n * n - 1)
        count = math.comb(n, i)
        functions.append(f"{_ends(i, n)}*(({count}+{_share(falling)}*lam)*r+({count}-{_share(rising)}*lam)*t)")
    functions.append(f"{_power('t', n)}*(t+(1-lam)*r)")
    return tuple(functions), (Parameter("lam", -1.0, 1.0),)


def alpha_bernstein(points: int) -> Formulas:
    """Return the α-Bernstein polynomials; the Bernstein polynomials for α = 1."""
    n = points - 1
    functions: list[str] = []
    for i in range(points):
        terms = [f"alpha*{math.comb(n, i)}*{_ends(i, n)}"]
        if i <= n - 2:
            terms.append(f"(1-alpha)*{math.comb(n - 2, i)}*{_ends(i, n - 1)}")
        if i >= 2:
            terms.append(f"(1-alpha)*{math.comb(n - 2, i - 2)}*{_ends(i - 1, n - 1)}")
        functions.append("+".join(terms))
    return tuple(functions), (Parameter("alpha", 0.0, 1.0, 1.0),)


def ali_cubic(points: int) -> Formulas:
    """Return Ali's cubic functions: Ball's for p = q = 2, Bézier's for 3."""
    functions = ("r^2*(1+(2-p)*t)", "p*t*r^2", "q*t^2*r", "t^2*(1+(2-q)*r)")
    return functions, (Parameter("p", 0.0, 3.0, 3.0), Parameter("q", 0.0, 3.0, 3.0))


def q_bernstein(points: int) -> Formulas:
    """Return Phillips' q-Bernstein polynomials; the Bernstein polynomials for q = 1."""
    n = points - 1
    functions = [
        "*".join([f"({_gaussian(n, i)})", _power("t", i), *(f"(r+(1-q^{k})*t)" for k in range(n - i))])
        for i in range(points)
    ]
    return tuple(functions), (Parameter("q", 0.0, 1.0, 1.0, (True, False)),)


def normalised_trigonometric(points: int) -> Formulas:
    """Return the normalised B-basis of trigonometric polynomials of order m on [0, β], 2m + 1 functions."""
    m = (points - 1) // 2
    functions: list[str] = []
    for i in range(points):
        terms = [
            f"{math.comb(m, i - k) * math.comb(i - k, k)}*{_power('(2*cos(beta/2))', i - 2 * k)}"
            for k in range(i // 2 + 1)
            if math.comb(m, i - k) * math.comb(i - k, k)
        ]
        ends = f"{_power('sin(beta*r/2)', 2 * m - i)}*{_power('sin(beta*t/2)', i)}"
        functions.append(f"({'+'.join(terms)})*{ends}/sin(beta/2)^{2 * m}")
    return tuple(functions), (Parameter("beta", 0.0, math.pi, 0.5 * math.pi, (True, True)),)


def c_bezier(points: int) -> Formulas:
    """Return the functions of cubic C-Bézier curves, over an arc of ``phi``."""
    factor = "sin(phi/2)^3/(phi/2*(1-cos(phi/2))-(phi/2-sin(phi/2)))"

    def outer(x: str) -> str:
        return f"(phi*{x}-sin(phi*{x}))/(phi-sin(phi))"

    def inner(x: str) -> str:
        return f"{factor}*((1-cos(phi*{x}))/(1-cos(phi))-{outer(x)})"

    functions = (outer("r"), inner("r"), inner("t"), outer("t"))
    return functions, (Parameter("phi", 0.0, math.pi, 0.5 * math.pi, (True, False)),)


def h_bezier(points: int) -> Formulas:
    """Return the functions of cubic H-Bézier curves, the hyperbolic sisters of C-Bézier curves."""
    factor = "sinh(phi/2)^3/(phi/2*(cosh(phi/2)-1)-(sinh(phi/2)-phi/2))"

    def outer(x: str) -> str:
        return f"(sinh(phi*{x})-phi*{x})/(sinh(phi)-phi)"

    def inner(x: str) -> str:
        return f"{factor}*((cosh(phi*{x})-1)/(cosh(phi)-1)-{outer(x)})"

    functions = (outer("r"), inner("r"), inner("t"), outer("t"))
    return functions, (Parameter("phi", 0.0, 8.0, 1.0, (True, False)),)


def _quintic(points: int, values: tuple[float, ...], unchecked: bool) -> Functions:
    return Trigonometric(*values, unchecked=unchecked)


def _bernstein(points: int, values: tuple[float, ...], unchecked: bool) -> Functions:
    return Bernstein(points - 1)


_MISRO = "Misro, Ramli and Ali 2017 (thesis eq. 2.2)"
_HAN = "the family of Han, Ma and Huang 2009"
_BIBI = "BiBi and others 2020, doi:10.1186/s13662-020-03001-4"
_HU = "Han and others 2008; Hu and others 2017, doi:10.1186/s13660-017-1390-3"
_ROTH = "Sánchez-Reyes 1998; Róth 2014"
_NORMALISED = "Normalised trigonometric B-basis"
_SQUARES = "Generalised trigonometric Bézier, with cos² and sin² for 1 - t and t"

LIBRARY: tuple[Entry, ...] = (
    Entry("trigonometric", "Quintic trigonometric Bézier", _MISRO, (6,), 6, trigonometric, _quintic),
    Entry("quadratic", "Quadratic trigonometric Bézier", f"{_HAN}, order 2", (3,), 3, trigonometric),
    Entry("cubic", "Cubic trigonometric Bézier", "Han, Ma and Huang 2009", (4,), 4, trigonometric),
    Entry("quartic", "Quartic trigonometric Bézier", f"{_HAN}, order 4", (5,), 5, trigonometric),
    Entry("quintic", "Quintic trigonometric Bézier", _MISRO, (6,), 6, trigonometric, _quintic),
    Entry("generalised_trigonometric", "Generalised trigonometric Bézier", _BIBI, _MANY, 6, generalised("r", "t")),
    Entry("generalised_trigonometric_squares", _SQUARES, _BIBI, range(3, 35), 6, generalised("c^2", "s^2")),
    Entry("sg_bezier", "Shape-adjustable generalised Bézier", _HU, range(3, 8), 4, sg_bezier),
    Entry("lambda_bezier", "λ-Bézier", "Ye, Long and Zeng 2010", _MANY, 4, lambda_bezier),
    Entry("alpha_bernstein", "α-Bernstein", "Chen, Tan, Liu and Xie 2017", _MANY, 4, alpha_bernstein),
    Entry("ali_cubic", "Ali's cubic", "Ali 1994", (4,), 4, ali_cubic),
    Entry("q_bernstein", "q-Bernstein", "Phillips 1997", range(2, 12), 4, q_bernstein),
    Entry("normalised_trigonometric", _NORMALISED, _ROTH, range(3, 12, 2), 5, normalised_trigonometric),
    Entry("c_bezier", "C-Bézier", "Zhang 1996", (4,), 4, c_bezier),
    Entry("h_bezier", "H-Bézier", "Pottmann 1993", (4,), 4, h_bezier),
    Entry("bernstein", "Bernstein polynomials, classical Bézier", "Bernstein 1912", ANY, 4, bernstein, _bernstein),
)
"""All bases that quintrig brings, the default first."""


def _power(base: str, exponent: int) -> str:
    if not exponent:
        return "1"
    if exponent == 1:
        return base
    raised = base.partition("^")
    return f"{raised[0]}^{int(raised[2]) * exponent}" if raised[2].isdigit() else f"{base}^{exponent}"


def _ends(i: int, n: int) -> str:
    return f"{_power('t', i)}*{_power('r', n - i)}"


def _share(value: Fraction) -> str:
    return f"({value.numerator}/{value.denominator})"


def _gaussian(n: int, i: int) -> str:
    """Return the Gaussian binomial coefficient [n, i]_q as a polynomial in q."""
    rows = [[1]]
    for m in range(1, n + 1):  # [m, k] = [m-1, k-1] + q^k [m-1, k], for one row of k at a time
        old = rows if m > 1 else [[1]]
        rows = [_add(old[k - 1] if k else [], [0] * k + old[k] if k < len(old) else []) for k in range(m + 1)]
    return "+".join(f"{value}*{_power('q', k)}" for k, value in enumerate(rows[i]) if value)


def _add(x: list[int], y: list[int]) -> list[int]:
    size = max(len(x), len(y))
    return [(x[k] if k < len(x) else 0) + (y[k] if k < len(y) else 0) for k in range(size)]
