"""Where two edges run beside each other: the feet of one's points on the other, and the stretch they share."""

from dataclasses import dataclass

import numpy as np

from quintrig.multipatch.boundary import SAMPLES, Edge
from quintrig.multipatch.continuity import surface_distance
from quintrig.support.arrays import BoolArray, FloatArray

_STEPS = 10
_SIDEWAYS = 0.7  # part of the distance from an end of an edge that may point along it: more is past the end
_CORNERS = 0.95  # the same between ends of both edges
_BESIDE = 0.1  # of an edge: a foot this near to its end is beside the corner
_CONVERGED = 1e-14
_PARALLEL = 0.8
_SAME = 1e-10  # distance, in sizes, of samples that are one point: no foot need be sought
_SHORTEST = 0.05  # part of the shorter edge along which both must meet
_SHORTEST_NEAR = 0.5  # and along which they must be near, to count as a near miss


@dataclass(frozen=True, eq=False)
class Contact:
    """A stretch of one edge and the feet of its points on another one: parameters (n,) on both, distances, length¹."""

    t: FloatArray
    feet: FloatArray
    distance: FloatArray
    reversed: bool

    @property
    def gap(self) -> float:
        """The largest distance, length¹."""
        return float(self.distance.max())


def contact(first: Edge, second: Edge, reach: float, tolerance: float) -> Contact | None:
    """Return the stretch along which two edges are within ``reach`` of each other, or None.

    A stretch that ends in the middle of both edges, where they part, counts as far as it is within ``tolerance``.
    """
    fast = _same(first, second)
    if fast is not None:
        return fast
    t = first.t
    tolerance, reach = tolerance + first.slack + second.slack, max(reach, tolerance)
    feet, distance, valid = _feet(first, second, t, reach, tolerance)
    ends = np.array([0.0, 1.0])
    back, _, met = _feet(second, first, ends, reach, tolerance)
    for corner in (0, -1):  # where the edges are apart there, the gap is that of the corners
        end = round(float(feet[corner]))
        between = float(np.linalg.norm(first.points[corner] - second.points[-end]))
        if valid[corner] and distance[corner] > tolerance and abs(feet[corner] - end) < _BESIDE and between <= reach:
            feet[corner], distance[corner] = float(end), between
    low, high, clean = _stretch(t, valid, back[met])
    if not clean:
        low, high, clean = _stretch(t, valid & (distance <= tolerance), back[met])
        clean = high > low
    if not high > low or not clean:
        return None
    if low > 0.0 or high < 1.0:
        t = np.linspace(low, high, SAMPLES)
        feet, distance, valid = _feet(first, second, t, reach, tolerance)
        valid[[0, -1]] = True
    slack = first.slack + second.slack
    if slack > 0.0:  # polylines stray from the edges: their points lie on the surfaces
        near = valid & (distance <= tolerance)
        distance = distance.copy()
        distance[near] = surface_distance(second.surface, second.place(feet[near])[0], first.curve(t[near])[0])
    t, feet, distance = t[valid], feet[valid], distance[valid]
    if len(t) < 3:
        return None
    found = Contact(t, feet, distance, bool(np.median(np.diff(feet)) < 0.0))
    share = (high - low) * first.length / min(first.length, second.length)
    least = _SHORTEST if found.gap <= tolerance else _SHORTEST_NEAR
    moved = float(np.ptp(feet)) > 0.5 * least * first.length / max(second.length, first.length)
    return found if share >= least and moved and _parallel(first, second, found) else None


def _same(first: Edge, second: Edge) -> Contact | None:
    """Return the contact of edges whose samples are the same points, one way or the other."""
    if first.points.shape != second.points.shape:
        return None
    limit = _SAME * min(first.size, second.size)
    for backwards in (False, True):
        apart = np.linalg.norm(first.points - second.points[:: -1 if backwards else 1], axis=-1)
        if apart.max() <= limit:
            return Contact(first.t, second.t[:: -1 if backwards else 1], apart, backwards)
    return None


def _feet(
    first: Edge, second: Edge, t: FloatArray, reach: float, tolerance: float
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Return the nearest points on the second edge: parameters, distances, and which lie beside it within reach."""
    points = first.points if t is first.t else first.curve(t)[0]
    foot, low, high = _on_polygon(points, second)
    best, least, slope = foot, np.full(len(t), np.inf), np.zeros_like(points)
    place = slope
    for _ in range(_STEPS):
        there, way = second.curve(foot)
        away = points - there
        distance = np.linalg.norm(away, axis=-1)
        nearer = distance < least
        best, least = np.where(nearer, foot, best), np.where(nearer, distance, least)
        place, slope = (np.where(nearer[:, None], new, old) for new, old in ((there, place), (way, slope)))
        square = np.maximum((way**2).sum(axis=-1), (1e-12 * second.length) ** 2)
        following = np.clip(foot + (away * way).sum(axis=-1) / square, low, high)
        if np.abs(following - foot).max() <= _CONVERGED:
            break
        foot = following
    along = np.abs(((points - place) * slope).sum(axis=-1)) / np.maximum(np.linalg.norm(slope, axis=-1), 1e-300)
    at_end = (best <= 0.0) | (best >= 1.0)
    sideways = np.where((t <= 0.0) | (t >= 1.0), _CORNERS, _SIDEWAYS)
    beside = ~at_end | (along <= sideways * least) | (least <= tolerance)
    return best, least, (least <= reach) & beside


def _on_polygon(points: FloatArray, second: Edge) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the parameters of the feet on the second edge's polygon, and those of the samples around them."""
    start, step = second.points[:-1], np.diff(second.points, axis=0)
    square = np.maximum((step**2).sum(axis=-1), 1e-300)
    part = np.clip((points @ step.T - (start * step).sum(axis=-1)) / square, 0.0, 1.0)
    away = points[:, None] - start - part[..., None] * step
    k = (away**2).sum(axis=-1).argmin(axis=1)
    part = part[np.arange(len(k)), k]
    t, last = second.t, len(second.t) - 1
    foot = t[k] + part * (t[k + 1] - t[k])
    return np.clip(foot, 0.0, 1.0), t[np.maximum(k - 1, 0)], t[np.minimum(k + 2, last)]


def _stretch(t: FloatArray, valid: BoolArray, inner: FloatArray) -> tuple[float, float, bool]:
    """Return the longest run of valid parameters, and whether both its ends are those of the one edge or the other.

    ``inner`` holds the feet of the other's ends: a run is drawn out to those that lie between its last and the next.
    """
    if not valid.any():
        return 0.0, 0.0, False
    padded = np.concatenate([[False], valid, [False]]).astype(int)
    starts, stops = np.flatnonzero(np.diff(padded) == 1), np.flatnonzero(np.diff(padded) == -1) - 1
    k = int(np.argmax(t[stops] - t[starts]))
    i, j = int(starts[k]), int(stops[k])
    low, high = float(t[i]), float(t[j])
    last = len(t) - 1
    lower = inner[(inner >= t[max(i - 2, 0)]) & (inner <= t[min(i + 2, last)])]
    upper = inner[(inner <= t[min(j + 2, last)]) & (inner >= t[max(j - 2, 0)])]
    # A sample of the first edge's own end counts as its end unless the other edge ends just before it.
    clean = (i == 0 or len(lower) > 0) and (j == last or len(upper) > 0)
    return (
        float(lower.min()) if i and len(lower) else low,
        float(upper.max()) if j < last and len(upper) else high,
        clean,
    )


def _parallel(first: Edge, second: Edge, found: Contact) -> bool:
    a, b = first.curve(found.t)[1], second.curve(found.feet)[1]
    lengths = np.linalg.norm(a, axis=-1) * np.linalg.norm(b, axis=-1)
    cosine = np.abs((a * b).sum(axis=-1)) / np.maximum(lengths, 1e-300)
    return bool(np.median(cosine) >= _PARALLEL)
