"""Whether curvature has a bound beside singular edges, by its extremes on two rings close to the edges.

With α = -4 (or two coinciding rows of points) an edge stands still: S = P + x² A + x³ B + ... at the distance x, so
the curvature across it grows as det(A, B, S_v) / x. A singular corner of a ruled surface and the apex of a cone do so
too.
An extreme that has at least doubled from the ring at 2^-14 to that at 2^-18, and is more than rounding, has no bound.
This is the one place where that is decided: for extremes, integrals and sweeps.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.quantities.table import quantity
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import SINGULAR

NEAR, NEARER = 14, 18
"""Octaves: the rings are lines at these powers of 1/2 from the edges."""

CURVATURES = ("gaussian", "mean", "k1", "k2", "curvedness")
"""Quantities that this decides; C, which all the others are measured against, is the last."""

_POINTS = 32  # on a line
_ROUNDING = 64.0 * np.finfo(np.float64).eps * 4.0**NEARER  # that of S_uu·n beside |S_u|², which vanishes as x²
_CANCELLED = 1e-10  # share of C or C² that is rounding of zero


@dataclass(frozen=True)
class Limit:
    """What becomes of an extreme beside singular edges: has it no bound, and its value and place on the nearer ring."""

    unbounded: bool
    value: float
    u: float
    v: float


def across(octave: int) -> FloatArray:
    """Return the distances of a ring's lines from both ends, (2,)."""
    return np.array([0.5**octave, 1.0 - 0.5**octave])


def along(octave: int) -> FloatArray:
    """Return the points on a ring's line, as dense near its ends as these are near the edges: one in each octave."""
    return 1.0 / (1.0 + 2.0 ** np.linspace(0.5 - octave, octave - 0.5, _POINTS))


def has_no_bound(near: FloatArray, nearer: FloatArray, curved: FloatArray, noise: FloatArray, power: int) -> BoolArray:
    """Tell where a greatest value has no bound, from that on both rings.

    ``curved`` is the greatest C on the nearer ring and ``noise`` reach / area, the coordinates' size by the surface's;
    ``power`` of 1/length is 2 for K and 1 for others. For least values, give both with the other sign.
    """
    with np.errstate(invalid="ignore"):
        floor = _ROUNDING * noise * curved ** (power - 1) + _CANCELLED * curved**power
        return (nearer - near > 0.5 * nearer) & (nearer > floor)


def limits(surface: Surface) -> dict[tuple[str, float], Limit] | None:
    """Return the limits of least (sense 1.0) and greatest (-1.0) curvatures beside the edges, by (key, sense).

    None where no edge is singular, or where the nearer ring is.
    """
    area = _area(surface)
    if not has_singular_edge(surface) or not area > 0.0:
        return None
    rings = [_ring(surface, octave) for octave in (NEAR, NEARER)]
    if np.isnan(rings[1][2]).any():
        return None
    noise = np.array(float(np.abs(surface.local_partials(*grid(9, 9), 0)).max()) / area)
    curved = rings[1][2][-1].max()
    u, v = rings[1][:2]
    result: dict[tuple[str, float], Limit] = {}
    for q, key in enumerate(CURVATURES):
        for sense in (1.0, -1.0):
            near, nearer = (np.nanmax(-sense * ring[2][q], initial=-np.inf) for ring in rings)
            at = int((sense * rings[1][2][q]).argmin())
            endless = bool(has_no_bound(near, nearer, curved, noise, -quantity(key).power))
            result[key, sense] = Limit(endless, float(rings[1][2][q, at]), float(u[at]), float(v[at]))
    return result


def has_singular_edge(surface: Surface) -> bool:
    """Tell whether S_u × S_v = 0, to rounding, somewhere on an edge."""
    t = np.linspace(0.0, 1.0, _POINTS + 1)
    tiny = SINGULAR * surface.size**2
    for end in (np.zeros_like(t), np.ones_like(t)):
        for u, v in ((end, t), (t, end)):
            p = surface.partials(u, v, 1)
            if (np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1) <= tiny).any():
                return True
    return False


def _area(surface: Surface) -> float:
    """Return roughly the area, length²."""
    t = (np.arange(_POINTS) + 0.5) / _POINTS
    p = surface.partials(t[:, None], t[None, :], 1)
    return float(np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1).mean())


def _ring(surface: Surface, octave: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return u, v and the curvatures (keys, n) of all points of a ring."""
    t, ends = along(octave), across(octave)
    fixed, running = (x.reshape(-1) for x in np.meshgrid(ends, t, indexing="ij"))
    u, v = np.concatenate([fixed, running]), np.concatenate([running, fixed])
    sample = analyse(surface, u, v, CURVATURES)
    return u, v, np.stack([sample[key] for key in CURVATURES])
