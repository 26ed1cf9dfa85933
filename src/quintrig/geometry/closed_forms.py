"""Surfaces with curvature in closed form, to validate the code against (thesis §4.2) and to compare with.

All are rows and a blend like every other surface, over (u, v) in [0, 1]²; all lengths in the model's unit.
u runs along the profile of a surface of revolution and v once around it. The normal points outwards there, and along
S_u x S_v on the others; ``flip`` turns it.
"""

import numpy as np

from quintrig.basis.elementary import Circular, Hyperbolic, Powers
from quintrig.basis.functions import Functions
from quintrig.basis.joined import Joined
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import SMALLEST, FloatArray, number

_ONE = Powers(0.0, 1.0, 0)
_Row = list[tuple[float, float, float]]


def sphere(radius: float = 1.0, *, flip: bool = False) -> Surface:
    """Return a sphere, K = 1/r², from the south pole (u = 0) to the north; the poles are singular points.

    The normal points outwards, so H = -1/r.
    """
    r = _positive(radius, "radius")
    return ellipsoid(r, r, r, flip=flip)


def ellipsoid(a: float = 3.0, b: float = 2.0, c: float = 1.0, *, flip: bool = False) -> Surface:
    """Return x²/a² + y²/b² + z²/c² = 1, K = 1/(a² b² c² q²), q = x²/a⁴ + y²/b⁴ + z²/c⁴; normal outwards."""
    a, b, c = _positive(a, "a"), _positive(b, "b"), _positive(c, "c")
    return _turned(Circular(-1.0, 1.0), [(a, b, 0.0), (0.0, 0.0, c)], not flip)


def cylinder(radius: float = 1.0, height: float = 2.0, *, flip: bool = False) -> Surface:
    """Return a circular cylinder, K = 0, H = -1/(2r) with the normal outwards."""
    r, h = _positive(radius, "radius"), _positive(height, "height")
    return _turned(Powers(0.0, 1.0, 1), [(r, r, 0.0), (0.0, 0.0, h)], not flip)


def cone(radius: float = 1.0, height: float = 2.0, *, flip: bool = False) -> Surface:
    """Return a cone from its base (u = 0) to its apex, a singular point; K = 0, normal outwards."""
    r, h = _positive(radius, "radius"), _positive(height, "height")
    return _turned(Powers(0.0, 1.0, 1), [(r, r, 0.0), (-r, -r, h)], not flip)


def torus(major: float = 3.0, minor: float = 1.0, *, flip: bool = False) -> Surface:
    """Return a torus, tube angle w = 2πu: K = cos w / (r (R + r cos w)), normal outwards."""
    big, small = _positive(major, "major"), _positive(minor, "minor")
    rows: _Row = [(small, small, 0.0), (0.0, 0.0, small), (big, big, 0.0)]
    return _turned(Joined((Circular(0.0, 4.0), _ONE)), rows, not flip)


def catenoid(waist: float = 1.0, height: float = 2.0, *, flip: bool = False) -> Surface:
    """Return the minimal surface of revolution r = a cosh(z/a), |z| <= height/2: H = 0, K = -1/(a² cosh⁴(z/a))."""
    a, h = _positive(waist, "waist"), _positive(height, "height")
    end = 0.5 * h / a
    rows: _Row = [(a, a, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, a)]
    return _turned(Joined((Hyperbolic(-end, end), Powers(-end, end, 1))), rows, not flip)


def helicoid(radius: float = 1.0, pitch: float = 2.0, *, flip: bool = False) -> Surface:
    """Return one turn of (ρ cos w, ρ sin w, c w), |ρ| <= radius, c = pitch/2π: H = 0, K = -c²/(c² + ρ²)²."""
    r, c = _positive(radius, "radius"), number(pitch, "pitch") / (2.0 * np.pi)
    points = np.zeros((2, 4, 3))  # blend: cos w, sin w, 1, w
    points[1, 0, 0] = points[1, 1, 1] = 1.0
    points[0, 3, 2] = c
    return Surface(Net(points, Powers(-r, r, 1)), Joined((Circular(0.0, 4.0), Powers(0.0, 2.0 * np.pi, 1))), flip)


def hyperbolic_paraboloid(size: float = 1.0, *, flip: bool = False) -> Surface:
    """Return z = x y over the square |x|, |y| <= size: with W² = 1 + x² + y², K = -1/W⁴, H = -x y / W³."""
    return _polynomial(size, {(1, 0): (1, 0, 0), (0, 1): (0, 1, 0), (1, 1): (0, 0, 1)}, flip)


def monkey_saddle(size: float = 1.0, *, flip: bool = False) -> Surface:
    """Return z = x³ - 3 x y² over |x|, |y| <= size: K = -36 ρ² / (1 + 9 ρ⁴)², ρ² = x² + y²; flat at the origin."""
    return _polynomial(size, {(1, 0): (1, 0, 0), (0, 1): (0, 1, 0), (3, 0): (0, 0, 1), (1, 2): (0, 0, -3)}, flip)


def enneper(size: float = 1.0, *, flip: bool = False) -> Surface:
    """Return Enneper's minimal surface over |p|, |q| <= size: H = 0, K = -4 / (1 + p² + q²)⁴."""
    third = 1.0 / 3.0
    terms = {
        (1, 0): (1.0, 0.0, 0.0),
        (3, 0): (-third, 0.0, 0.0),
        (1, 2): (1.0, 0.0, 0.0),
        (0, 1): (0.0, 1.0, 0.0),
        (0, 3): (0.0, -third, 0.0),
        (2, 1): (0.0, 1.0, 0.0),
        (2, 0): (0.0, 0.0, 1.0),
        (0, 2): (0.0, 0.0, -1.0),
    }
    return _polynomial(size, terms, flip)


def _turned(profile: Functions, coefficients: _Row, flip: bool) -> Surface:
    """Return (Σ a_i p_i cos w, Σ b_i p_i sin w, Σ c_i p_i), w = 2πv, from coefficients (a_i, b_i, c_i)."""
    points = np.stack([np.diag(row) for row in coefficients]).astype(np.float64)
    return Surface(Net(points, profile), Joined((Circular(0.0, 4.0), _ONE)), flip)


def _polynomial(size: float, terms: dict[tuple[int, int], tuple[float, float, float]], flip: bool) -> Surface:
    """Return Σ c_pq x^p y^q over |x|, |y| <= size."""
    size = _positive(size, "size")
    degrees = [max(key[axis] for key in terms) for axis in (0, 1)]
    points: FloatArray = np.zeros((degrees[0] + 1, degrees[1] + 1, 3))
    for key, value in terms.items():
        points[key] = value
    return Surface(Net(points, Powers(-size, size, degrees[0])), Powers(-size, size, degrees[1]), flip)


def _positive(value: float, name: str) -> float:
    value = number(value, name)
    if not value > 0.0:
        raise ValueError(f"{name}: expected a number greater than 0, found {value:g}")
    if value < SMALLEST:
        raise ValueError(f"{name}: expected a number of size at least {SMALLEST:g}, found {value:g}")
    return value
