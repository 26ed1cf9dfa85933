"""Integrals over a surface, each with its measured error: area, total curvatures, bending and thin-plate energy.

The domain is cut at the knots, and each part into p x p panels with 16 x 16 Gauss-Legendre nodes each, fewer where
there are many parts; p is doubled until two results agree.
The error stated is their difference, which is that of the coarser one, so the value is better than it says. Nodes never
lie on an edge, so an integrand that stays bounded there (the pole of a sphere, the apex of a cone for ∫H dA) does no
harm. One that does not (κ² at an apex, at an edge with α = -4, at an edge of regression) makes the results grow with
every doubling: the status then says so, and the value is only the last one reached. Just above α = -4 an integral is
finite, however large: panels graded to the edge resolve it (``layers``).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from quintrig.analysis.edge_layers import Layers, layers_at_edges
from quintrig.analysis.quadrature import (
    MOST_NODES,
    Density,
    Integral,
    Panels,
    Status,
    checked_tolerance,
    converge,
    graded,
    node_sums,
    nodes_for,
    panel_sums,
)
from quintrig.analysis.sample import Sample, analyse
from quintrig.analysis.singular_edges import CURVATURES, limits
from quintrig.developables.regression import inner_regression
from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import Nodes, nodes_inside
from quintrig.quantities.table import BY_KEY, Quantity, quantity
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import NOISE, SINGULAR

INTEGRALS: tuple[Quantity, ...] = (
    Quantity("area", "A", "A", "area", "∫dA", "do Carmo 1976, §2.5", 2, "even", "sequential"),
    Quantity(
        "total_gaussian",
        "∫K dA",
        r"\int K\,\mathrm{d}A",
        "total Gaussian curvature",
        "area of the Gauss image, with sign",
        "do Carmo 1976, §3.3",
        0,
        "even",
        "diverging",
    ),
    Quantity(
        "total_mean",
        "∫H dA",
        r"\int H\,\mathrm{d}A",
        "total mean curvature",
        "bends towards the normal (+) or away from it (-) on the whole; changes sign with the normal",
        "do Carmo 1976, §3.3",
        1,
        "odd",
        "diverging",
    ),
    Quantity(
        "bending_energy",
        "∫(κ1²+κ2²) dA",
        r"\int (\kappa_1^2+\kappa_2^2)\,\mathrm{d}A",
        "bending energy",
        "how strongly it bends on the whole; does not depend on the parameters or the size",
        "Hagen and Schulze 1987",
        0,
        "even",
        "sequential",
    ),
    Quantity(
        "thin_plate_energy",
        "∬(|S_uu|²+2|S_uv|²+|S_vv|²) du dv",
        r"\iint (|S_{uu}|^2+2|S_{uv}|^2+|S_{vv}|^2)\,\mathrm{d}u\,\mathrm{d}v",
        "thin-plate energy",
        "stretch and bend of the parameter net: depends on the parametrisation, not on the shape alone",
        "Greiner 1994",
        2,
        "even",
        "sequential",
    ),
)
"""The integrals, in the order of tables; ``parity`` and ``power`` as for the quantities at a point."""

Region = Literal["trimmed", "whole"]
"""Whether numbers are those of a trimmed face, or of the whole surface."""

_LAST = 1e-14  # of the coordinates
# Units in the last place that are no more than a point, as in ``cautions``
_POINT = SINGULAR / np.finfo(np.float64).eps


@dataclass(frozen=True)
class Integrals:
    """The integrals of a surface; ``integrals["area"]`` or ``integrals.area``.

    ``points`` is the number of nodes of the last resolution; ``undefined`` the share of the domain whose nodes are
    singular, which adds nothing to the integrals of curvature. ``units`` is the surface's size in units in the last
    place of its coordinates. ``orientation`` says which way the normal points, ``region`` whether they are those of
    the ``trimmed`` face or of the ``whole`` surface.
    """

    area: Integral
    total_gaussian: Integral
    total_mean: Integral
    bending_energy: Integral
    thin_plate_energy: Integral
    tolerance: float
    points: int
    undefined: float
    units: float
    orientation: str
    region: Region = "whole"

    def __getitem__(self, key: str) -> Integral:
        """Return an integral by its key in ``INTEGRALS``; KeyError where there is none."""
        if key not in INTEGRAL_BY_KEY:
            raise KeyError(f"unknown integral {key!r}; known are {', '.join(INTEGRAL_BY_KEY)}")
        return getattr(self, key)

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader must know beside the numbers, one sentence each."""
        return (
            f"The total mean curvature changes sign with the normal; here {self.orientation}.",
            "The thin-plate energy depends on the parametrisation: compare it only between surfaces built alike.",
            *(["The integrals are those of the trimmed face."] if self.region == "trimmed" else []),
        )

    @property
    def cautions(self) -> tuple[str, ...]:
        """What is wrong with the numbers, one sentence for each that did not converge; empty where all did."""
        if self.units <= _POINT:
            return ("The surface is a single point, to rounding: it has no curvature to integrate.",)
        notes: list[str] = []
        for row in INTEGRALS:
            integral = self[row.key]
            if integral.status == "grows without bound":
                notes.append(
                    f"The {row.name} is probably infinite: every refinement adds to it, the last one "
                    f"{integral.error:.3g}, because the curvature is unbounded at a singular point or edge."
                )
            elif integral.status == "not converged":
                notes.append(
                    f"The {row.name} is not resolved to the tolerance {self.tolerance:g}: the last two resolutions "
                    f"differ by {integral.error:.3g}, as beside a fold, a singular point or a sharp crease, or where "
                    "rounding is as large."
                )
            elif integral.status == "undefined":
                notes.append(f"The {row.name} is undefined, since every point is singular.")
        if 0.0 < self.undefined < 1.0:
            notes.append(f"{self.undefined:.3%} of the domain is singular and left out of the integrals of curvature.")
        return tuple(notes)


INTEGRAL_BY_KEY: dict[str, Quantity] = {row.key: row for row in INTEGRALS}


def integrals(surface: Surface, tolerance: float = 1e-9, panels: int = 64) -> Integrals:
    """Return the integrals over the surface, of a trimmed face over what its loops hold (``carrier`` has all of it).

    Two resolutions must agree to ``tolerance`` relative to the area A, the bending or thin-plate energy themselves,
    and, since they may cancel to zero, T = ∫C dA for ∫H dA and T²/A for ∫K dA. ``panels`` is the largest number a side.
    Raises ValueError for a tolerance outside [1e-13, 0.1] or fewer than 2 panels.
    """
    tolerance = checked_tolerance(tolerance)
    size = surface.size
    # What is left of the points' last digits where differences of them should vanish, as on a surface that is a point.
    reach = float(np.abs(surface(*grid(3, 3))).max())
    rounding = (_LAST * reach) ** 2 * np.array([1.0, 0.0, 0.0, 0.0, 1e4, 0.0])

    layers = layers_at_edges(surface)
    domain = region_share(surface)

    def measure(count: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        area, total, mean, bending, plate, curvedness, undefined = _sums(
            surface, lambda u, v: _densities(surface, u, v), _panels(surface, count, layers)
        )
        undefined /= domain
        plane = NOISE / size * area if size > 0.0 else 0.0  # ∫C dA that is rounding of a plane
        root = curvedness**2 / area if area > 0.0 else 0.0
        scales = np.array([area, root, curvedness, bending, plate, 1.0])
        bent = NOISE * root + (plane**2 / area if area > 0.0 else 0.0)
        noise = np.array([NOISE * size**2, bent, plane, bent, (NOISE * size) ** 2, 1.0])
        return np.array([area, total, mean, bending, plate, undefined]), scales, noise + rounding

    results, count = converge(measure, tolerance, _most(surface, panels, layers))
    units = size / float(np.spacing(reach)) if reach > 0.0 else 0.0
    undefined = 1.0 if units <= _POINT else min(results[5].value, 1.0)
    if undefined > 1.0 - 1e-9:
        results[1:4] = [Integral(np.nan, np.nan, "undefined")] * 3
        undefined = 1.0
    results = [replace(r, value=0.0) if abs(r.value) <= x else r for r, x in zip(results, rounding, strict=True)]
    area, total, mean, bending, plate = results[:5]
    bending = replace(bending, status=_energy_status(surface, bending.status))
    # The others are areas and angles, of the Gauss image too: finite even where curvature has no bound.
    area, total, mean, plate = (_bounded(result) for result in (area, total, mean, plate))
    points = _points(surface, _panels(surface, count, layers))
    region = "trimmed" if surface.trim else "whole"
    return Integrals(
        area, total, mean, bending, plate, tolerance, points, undefined, units, orientation(surface), region
    )


def area_means(surface: Surface, keys: Sequence[str], tolerance: float = 1e-5, panels: int = 16) -> dict[str, Integral]:
    """Return the area-weighted mean ∫q dA / ∫dA of scalar quantities, over the points where q is defined.

    Two resolutions must agree to ``tolerance`` relative to the mean of |q|, or of C or C² for a curvature.
    Raises ValueError for an unknown or vector quantity, and as ``integrals`` does.
    """
    tolerance = checked_tolerance(tolerance)
    rows = [_scalar(key) for key in keys]
    size = surface.size
    per_size = 1.0 / size if size > 0.0 else 0.0
    layers = layers_at_edges(surface)

    def measure(count: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        sums = _sums(surface, lambda u, v: _moments(surface, keys, u, v), _panels(surface, count, layers))
        n = len(keys)
        with np.errstate(divide="ignore", invalid="ignore"):
            means, sizes, curved = (
                sums[:n] / sums[n : 2 * n],
                sums[2 * n : 3 * n] / sums[n : 2 * n],
                sums[-2] / sums[-1],
            )
        natural = np.array([_natural(row, curved) for row in rows])
        rounding = NOISE * np.array([_natural(row, curved + per_size) for row in rows])
        loose = 1e-2 * sizes + rounding  # the mean of |q| need only exist
        return np.append(means, sizes), np.append(np.fmax(sizes, natural), sizes), np.append(rounding, loose)

    results, _ = converge(measure, tolerance, _most(surface, panels, layers))
    pairs = zip(results[: len(keys)], results[len(keys) :], strict=True)
    # Where ∫|q| dA is infinite, halves of opposite sign may still cancel by symmetry: that is no mean.
    means = [mean if size.converged else replace(mean, status=size.status) for mean, size in pairs]
    # Only what is undefined where the tangent plane is vertical has no mean; ∫|K| dA and ∫C dA are finite.
    means = [_bounded(mean) if row.key in CURVATURES else mean for row, mean in zip(rows, means, strict=True)]
    return dict(zip(keys, means, strict=True))


def area_weights(sample: Sample) -> FloatArray:
    """Return the share of the area that each point of a grid stands for, shape (nu, nv), sum 1 (0 for no area).

    By the trapezium rule, from E, F and G, which the sample must have. Points outside the trim loops stand for none.
    """
    e, f, g = sample["E"], sample["F"], sample["G"]
    density = np.sqrt(np.maximum(np.nan_to_num(e * g - f * f), 0.0))
    density *= sample.surface.inside(sample.u, sample.v)
    weights = density * _trapezium(sample.u[:, 0])[:, None] * _trapezium(sample.v[0])[None, :]
    total = weights.sum()
    return weights / total if total > 0.0 else weights


def orientation(surface: Surface) -> str:
    """Return in words which way the normal points."""
    return "the normal points against S_u × S_v (flipped)" if surface.flip else "the normal points along S_u × S_v"


def _energy_status(surface: Surface, seen: Status) -> Status:
    """Return the status of the bending energy: one that seems to grow has no bound only where curvature has none."""
    if seen not in ("not converged", "grows without bound"):
        return seen
    # Beside an edge of regression κ grows as 1/distance; panels that it runs through aslant show it by leaps only.
    if inner_regression(surface) is not None:
        return "grows without bound"
    found = limits(surface) if seen == "grows without bound" else None
    return seen if found and found["curvedness", -1.0].unbounded else "not converged"


def _bounded(found: Integral) -> Integral:
    return replace(found, status="not converged") if found.status == "grows without bound" else found


def _panels(surface: Surface, count: int, layers: Layers) -> Panels:
    """Return the panels, ``count`` a side between two knots, and more where there are layers."""
    u, v = (surface.breaks(axis) for axis in range(2))
    nodes = nodes_for(max(len(u), len(v)) - 1)
    return Panels(graded(count, *layers[:2], u), graded(count, *layers[2:], v), nodes)


def _most(surface: Surface, panels: int, layers: Layers) -> int:
    """Return the largest number of panels a side between two knots, at most ``panels``, that takes a few seconds."""
    while panels > 2 and _points(surface, _panels(surface, panels, layers)) > MOST_NODES:
        panels //= 2
    return panels


def _points(surface: Surface, panels: Panels) -> int:
    return len(_nodes(surface, panels).u) if surface.trim else panels.points


def _nodes(surface: Surface, panels: Panels) -> Nodes:
    return nodes_inside(surface.trim, panels.u, panels.v, surface.breaks(1), panels.nodes)


def _sums(surface: Surface, density: Density, panels: Panels) -> FloatArray:
    """Return the integrals (k,) over the surface, of a trimmed face over what its loops hold."""
    return node_sums(density, _nodes(surface, panels)) if surface.trim else panel_sums(density, panels)


def region_share(surface: Surface) -> float:
    """Return the share of the domain inside the trim loops, 1 where there are none."""
    if not surface.trim:
        return 1.0
    whole = np.array([0.0, 1.0])
    return float(nodes_inside(surface.trim, whole, whole, whole, 2).weights.sum())


def _densities(surface: Surface, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the integrands of the five integrals, of ∫C dA and of the singular share, (7, nu, nv)."""
    p = surface.partials(u, v, 2)
    area = _area_element(p[1, 0], p[0, 1])
    sample = analyse(surface, u, v, ("gaussian", "mean", "curvedness"))
    singular = np.isnan(sample["curvedness"])
    gaussian, mean, curvedness = (np.where(singular, 0.0, sample[key]) for key in ("gaussian", "mean", "curvedness"))
    plate = (p[2, 0] ** 2 + 2.0 * p[1, 1] ** 2 + p[0, 2] ** 2).sum(axis=-1)
    squares = 2.0 * curvedness * curvedness  # κ1² + κ2²
    return np.stack(
        [area, gaussian * area, mean * area, squares * area, plate, curvedness * area, singular.astype(np.float64)]
    )


def _moments(surface: Surface, keys: Sequence[str], u: FloatArray, v: FloatArray) -> FloatArray:
    """Return q dA, the area where q is defined and |q| dA, one after the other for all keys, then C dA and its area."""
    p = surface.partials(u, v, 1)
    area = _area_element(p[1, 0], p[0, 1])
    sample = analyse(surface, u, v, tuple(dict.fromkeys((*keys, "curvedness"))))
    defined = [np.isfinite(sample[key]) for key in (*keys, "curvedness")]
    values = [np.where(d, sample[key], 0.0) * area for d, key in zip(defined, (*keys, "curvedness"), strict=True)]
    areas = [d * area for d in defined]
    return np.stack([*values[:-1], *areas[:-1], *(np.abs(x) for x in values[:-1]), values[-1], areas[-1]])


def _area_element(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return |S_u × S_v|, without the cancellation of sqrt(EG - F²)."""
    normal = np.cross(first, second)
    return np.sqrt((normal * normal).sum(axis=-1))


def _trapezium(t: FloatArray) -> FloatArray:
    gaps = np.diff(t)
    return 0.5 * (np.append(gaps, 0.0) + np.append(0.0, gaps))


def _natural(row: Quantity, curvedness: float) -> float:
    """Return the size that a value of this quantity is measured against where it may cancel: C, C², or 1."""
    return curvedness ** (-row.power) if row.power < 0 else float(row.power == 0)


def _scalar(key: str) -> Quantity:
    row = quantity(key)
    if row.kind != "scalar":
        known = ", ".join(q.key for q in BY_KEY.values() if q.kind == "scalar")
        raise ValueError(f"{key}: expected a scalar quantity, one of {known}")
    return row
