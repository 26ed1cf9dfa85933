"""What a reader of a surface's numbers must be warned of, in words, one sentence each."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.analysis.extremes import Extremes
from quintrig.analysis.integrate import region_share
from quintrig.analysis.sample import Sample
from quintrig.basis.functions import Functions
from quintrig.basis.joined import Joined
from quintrig.basis.trigonometric import SHAPE_RANGE, Trigonometric
from quintrig.developables.regression import inner_regression
from quintrig.geometry.surface import Net, Surface
from quintrig.quantities.table import quantity
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import SINGULAR, VERTICAL

EDGES = ("u = 0", "u = 1", "v = 0", "v = 1")
CORNERS = ("(0, 0)", "(0, 1)", "(1, 0)", "(1, 1)")

_ALONG = 33  # points on an edge


@dataclass(frozen=True)
class Singular:
    """Where the samples of a grid have S_u × S_v = 0, and so no normal.

    ``count`` of ``samples``; the ``edges`` that are singular from end to end, the ``corners`` that are singular and not
    on such an edge, and how many other points are, ``on_edges`` of the domain and ``inside``.
    """

    count: int
    samples: int
    edges: tuple[str, ...]
    corners: tuple[str, ...]
    on_edges: int
    inside: int

    def describe(self) -> str:
        """Return number and place in words; empty where there are none."""
        if not self.count:
            return ""
        if self.count == self.samples:
            return (
                f"All {self.samples} sample points are singular: S_u × S_v = 0 to rounding, so there is no curvature."
            )
        places = [f"all of the edge {edge}" for edge in self.edges]
        places += [f"the corner (u, v) = {corner}" for corner in self.corners]
        places += [f"{self.on_edges} more on edges"] if self.on_edges else []
        places += [f"{self.inside} inside"] if self.inside else []
        are = "is" if self.count == 1 else "are"
        return (
            f"{self.count} of {self.samples} sample points {are} singular (S_u × S_v = 0, so no normal and no "
            f"curvature): {', '.join(places)}."
        )


def find_singular(sample: Sample) -> Singular:
    """Return where a sample over a grid, edges included, is singular."""
    bad = sample.singular
    if sample.surface.trim:  # its edges are its loops, not those of the domain
        inside = sample.surface.inside(sample.u, sample.v)
        count = int((bad & inside).sum())
        return Singular(count, int(inside.sum()), (), (), 0, count)
    strips = (bad[0], bad[-1], bad[:, 0], bad[:, -1])
    whole = tuple(bool(strip.all()) for strip in strips)
    edges = tuple(edge for edge, full in zip(EDGES, whole, strict=True) if full)
    rest = bad.copy()
    for full, place in zip(whole, ((0, ...), (-1, ...), (..., 0), (..., -1)), strict=True):
        if full:
            rest[place] = False
    corners = tuple(
        name for name, place in zip(CORNERS, ((0, 0), (0, -1), (-1, 0), (-1, -1)), strict=True) if rest[place]
    )
    inside = int(rest[1:-1, 1:-1].sum())
    on_edges = int(rest.sum()) - inside - len(corners)
    return Singular(int(bad.sum()), bad.size, edges, corners, on_edges, inside)


def shape_parameters(surface: Surface) -> dict[str, Trigonometric]:
    """Return the trigonometric bases of a surface by the place they act: ``u`` and ``v``, or ``v = 0`` and ``v = 1``.

    Empty for surfaces built otherwise; that of an enveloping developable has gone into its exact form.
    """
    named: list[tuple[str, Functions]] = []
    if isinstance(surface.rows, Net):
        functions = surface.rows.functions
        if isinstance(functions, Joined) and len(functions.parts) == 2:
            named += list(zip(("v = 0", "v = 1"), functions.parts, strict=True))
        else:
            named.append(("u", functions))
    named.append(("v", surface.blend))
    return {name: functions for name, functions in named if isinstance(functions, Trigonometric)}


def find_cautions(
    surface: Surface, sample: Sample, extremes: Mapping[str, Extremes], unit: str = ""
) -> tuple[str, ...]:
    """Return all warnings of a surface; ``sample`` is a grid with at least "point", "normal" and "mean"."""
    size = sample.size
    if size <= SINGULAR * float(np.abs(sample.point).max()):
        return ("The whole surface is a single point.",)
    singular = find_singular(sample)
    if singular.count == singular.samples > 0:
        return (singular.describe(), *_points(surface))
    told = [*_singular(surface, singular, size), *_parameters(surface, unit), *surface.caveats, *_points(surface)]
    regressive = _regression(surface)
    told += regressive or _folds(sample)
    told += _unbounded(extremes)
    return tuple(line for line in told if line)


def find_notes(sample: Sample) -> tuple[str, ...]:
    """Return what is no fault of the surface but explains missing values; ``sample`` has at least "normal"."""
    surface = sample.surface
    inside = surface.inside(sample.u, sample.v)
    told: list[str] = []
    if surface.trim:
        share = 100.0 * region_share(surface)
        told.append(
            f"The face is trimmed: its loops hold {share:.4g} % of the domain of its surface. Integrals, means, shares "
            "and extremes are those of the face; the whole surface, its carrier, has others."
        )
    count = int(((np.abs(sample.normal[..., 2]) <= VERTICAL) & inside).sum())
    if count:
        told.append(
            f"At {count} of {int(inside.sum())} sample points the tangent plane is vertical: the invariants in the "
            "metric of the plane are infinite there; those in the metric of the surface are not."
        )
    return tuple(told)


def _singular(surface: Surface, singular: Singular, size: float) -> list[str]:
    """Singular points: their number and place, once, and what becomes of the edges that are singular as a whole."""
    points, still = _edges(surface, size) if not surface.trim else ([], {})
    lines = list(still.values())
    if points:
        one = len(points) == 1
        where = f"The edge {points[0]} is a single point" if one else f"The edges {_listed(points)} are single points"
        them = "it" if one else "them"
        told = f"{where}, such as a pole or an apex: S_u × S_v = 0 all along {them}, so no curvature is defined there."
        lines.insert(0, told)
    others = len(singular.corners) + singular.on_edges + singular.inside
    if not lines or others or not set(singular.edges) <= {*points, *still}:
        return [singular.describe(), *lines]
    lines[-1] += f" In all {singular.count} of {singular.samples} sample points are singular."
    return lines


def _listed(words: Sequence[str]) -> str:
    return " and ".join((", ".join(words[:-1]), words[-1]))


def _edges(surface: Surface, size: float) -> tuple[list[str], dict[str, str]]:
    """Edges that collapse to a point, and what is to be said of those across which the derivative vanishes."""
    t = np.linspace(0.0, 1.0, _ALONG)
    bases = shape_parameters(surface)
    points: list[str] = []
    still: dict[str, str] = {}
    for edge in EDGES:
        name, end = edge[0], float(edge[-1])
        there = np.full_like(t, end)
        partials = surface.partials(there, t, 1) if name == "u" else surface.partials(t, there, 1)
        if np.ptp(partials[0, 0], axis=0).max() <= SINGULAR * size:
            points.append(edge)
        across = partials[1, 0] if name == "u" else partials[0, 1]
        if np.abs(across).max() <= SINGULAR * size:
            still[edge] = (
                f"S_{name} vanishes along the edge {edge}{_cause(bases.get(name), name, end)}: the surface is singular "
                "there, and the curvature beside it is in general unbounded."
            )
    return points, still


def _cause(basis: Trigonometric | None, name: str, end: float) -> str:
    if basis is None:
        return ""
    value, letter = (basis.alpha, "α") if end == 0.0 else (basis.zeta, "ζ")
    return f" ({letter}{'1' if name == 'u' else '2'} = -4)" if value == SHAPE_RANGE[0] else ""


def _parameters(surface: Surface, unit: str) -> list[str]:
    """Shape parameters at -4 on the boundary curves of a ruled surface, or outside their range."""
    told: list[str] = []
    low, high = SHAPE_RANGE
    outside: list[str] = []
    for place, basis in shape_parameters(surface).items():
        index = "1" if place in ("u", "v = 0") else "2"
        for letter, value, end in (("α", basis.alpha, 0), ("ζ", basis.zeta, 1)):
            if not low <= value <= high:
                outside.append(f"{letter}{index} = {value:g}")
            if value == low and "=" in place:
                told.append(f"{letter}{index} = -4: S_u vanishes at the corner u = {end}, {place}.")
    if outside:
        told.append(
            f"{', '.join(outside)}: outside [-4, 1] the basis turns negative and the convex-hull property is lost; "
            + _departure(surface, unit)
        )
    return told


def _departure(surface: Surface, unit: str) -> str:
    if surface.net is None:
        return "there is no net to measure it against."
    from quintrig.enclosures.convex_hull import check_hull  # it needs SciPy, which only this rare case should load

    check = check_hull(surface)
    if check.inside:
        return f"none of {check.samples} sample points leaves the hull of the net, however."
    distance = f"{check.distance:.3g} {unit}".rstrip()
    return f"{check.outside} of {check.samples} sample points leave the hull of the net, by up to {distance}."


def _points(surface: Surface) -> list[str]:
    """Neighbouring control points that coincide."""
    net = surface.net
    if net is None or surface.size == 0.0:
        return []
    extent = float(np.ptp(net.reshape(-1, net.shape[-1]), axis=0).max())
    same_u, same_v = _coincident(net, 0, extent), _coincident(net, 1, extent)
    count = int(same_u.sum() + same_v.sum())
    if not count:
        return []
    i, j = (int(x) for x in np.argwhere(same_u)[0]) if same_u.any() else (int(x) for x in np.argwhere(same_v)[0])
    other = f"[{i + 1}][{j}]" if same_u.any() else f"[{i}][{j + 1}]"
    pairs = "1 pair" if count == 1 else f"{count} pairs"
    return [
        f"{pairs} of neighbouring control points coincide (within {SINGULAR:.0e} of the net's extent), the first "
        f"points[{i}][{j}] and points{other}."
    ]


def _coincident(net: FloatArray, axis: int, extent: float) -> BoolArray:
    return np.abs(np.diff(net, axis=axis)).max(axis=-1) <= SINGULAR * extent


def _regression(surface: Surface) -> list[str]:
    """The edge of regression of a ruled developable."""
    found = inner_regression(surface)
    if found is None:
        return []
    ranges = " and ".join(f"[{low:.6g}, {high:.6g}]" for low, high in found.intervals)
    return [
        f"The edge of regression lies inside the strip or on its boundary for u in {ranges}: the surface is "
        "singular along it and folds back on itself; take other bounding planes or boundaries, or trim."
    ]


def _folds(sample: Sample) -> list[str]:
    """Places where the normal turns over between two samples."""
    normal = np.where(sample.surface.inside(sample.u, sample.v)[..., None], sample.normal, np.nan)
    turns_u = (normal[1:] * normal[:-1]).sum(axis=-1) < 0.0
    turns_v = (normal[:, 1:] * normal[:, :-1]).sum(axis=-1) < 0.0
    count = int(turns_u.sum() + turns_v.sum())
    if not count:
        return []
    i, j = (int(x) for x in (np.argwhere(turns_u)[0] if turns_u.any() else np.argwhere(turns_v)[0]))
    places = "1 place" if count == 1 else f"{count} places"
    return [
        f"The normal turns by more than 90° between neighbouring samples at {places}, first near (u, v) = "
        f"({sample.u[i, 0]:.4g}, {sample.v[0, j]:.4g}): a fold or a singular curve runs between them."
    ]


def _unbounded(extremes: Mapping[str, Extremes]) -> list[str]:
    symbols: list[str] = []
    places: list[tuple[float, float]] = []
    for key, found in extremes.items():
        poles = [end for end in (found.minimum, found.maximum) if end.status == "unbounded"]
        symbols += [quantity(key).symbol] if poles else []
        places += [(end.u, end.v) for end in poles]
    if not symbols:
        return []
    u, v = places[0]
    grow = "grows" if len(symbols) == 1 else "grow"
    return [
        f"{', '.join(symbols)} {grow} without bound beside singular points, as near (u, v) = "
        f"({u:.4g}, {v:.4g}): the largest values found there are no extremes."
    ]
