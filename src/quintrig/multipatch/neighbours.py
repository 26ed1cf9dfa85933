"""Which edges may run beside each other: by boxes along a sorted axis, then by coarse polygons, all at once."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from quintrig.multipatch.boundary import Edge
from quintrig.support.arrays import FloatArray

_COARSE = 17
_CHUNK = 512
_PARALLEL = 0.7  # least cosine between directions of edges that run beside each other
_PAST = 0.95
_LEAST = 2  # coarse points that must be near: about an eighth of the shorter edge


def candidates(edges: Sequence[Edge], reach: FloatArray) -> list[tuple[int, int]]:
    """Return pairs of edges, the shorter one first, that run beside each other within the lesser of their reaches."""
    if len(edges) < 2:
        return []
    polygons = np.stack([_coarse(edge) for edge in edges])
    slack = np.array([_sagitta(edge, polygon) for edge, polygon in zip(edges, polygons, strict=True)])
    lengths = np.array([edge.length for edge in edges])
    found: list[tuple[int, int]] = []
    for some in _chunks(_boxes(polygons, reach + slack)):
        order = lengths[some[:, 0]] <= lengths[some[:, 1]]
        pairs = np.where(order[:, None], some, some[:, ::-1])
        allowed = np.minimum(reach[pairs[:, 0]], reach[pairs[:, 1]]) + slack[pairs].sum(axis=1)
        near = _beside(polygons[pairs[:, 0]], polygons[pairs[:, 1]], allowed)
        found += [(int(a), int(b)) for a, b in pairs[near]]
    return sorted(found)


def _coarse(edge: Edge) -> FloatArray:
    return edge.points[np.linspace(0, len(edge.points) - 1, _COARSE).round().astype(int)]


def _sagitta(edge: Edge, polygon: FloatArray) -> float:
    """Return how far the edge strays from its coarse polygon, at most, length¹."""
    chords = np.linalg.norm(np.diff(polygon, axis=0), axis=-1)
    return 0.5 * float(max(edge.length - chords.sum(), 0.0)) + 1e-9 * edge.size


def _boxes(polygons: FloatArray, reach: FloatArray) -> Iterator[NDArray[np.intp]]:
    """Yield pairs whose boxes, grown by their reach, meet: sorted along the axis in which they spread most."""
    low: FloatArray = polygons.min(axis=1) - reach[:, None]
    high: FloatArray = polygons.max(axis=1) + reach[:, None]
    spread: FloatArray = np.ptp(low, axis=0) / np.maximum((high - low).mean(axis=0), 1e-300)
    axis = int(spread.argmax())
    order = np.argsort(low[:, axis], kind="stable")
    low, high = low[order], high[order]
    along: FloatArray = low[:, axis]
    ends = np.searchsorted(along, high[:, axis], side="right")
    for i, end in enumerate(ends.tolist()):
        meet = ((low[i + 1 : end] <= high[i]) & (high[i + 1 : end] >= low[i])).all(axis=1)
        others = np.flatnonzero(meet) + i + 1
        if len(others):
            yield np.stack([np.full(len(others), order[i]), order[others]], axis=-1)


def _chunks(parts: Iterator[NDArray[np.intp]]) -> Iterator[NDArray[np.intp]]:
    waiting: list[NDArray[np.intp]] = []
    for part in parts:
        waiting.append(part)
        if sum(map(len, waiting)) >= _CHUNK:
            yield np.concatenate(waiting)
            waiting = []
    if waiting:
        yield np.concatenate(waiting)


def _beside(first: FloatArray, second: FloatArray, reach: FloatArray) -> NDArray[np.bool_]:
    """Return which pairs of polygons (pairs, n, 3) have some points of the first near the second and parallel."""
    start, step = second[:, None, :-1], np.diff(second, axis=1)[:, None]
    square = np.maximum((step**2).sum(axis=-1), 1e-300)
    raw = ((first[:, :, None] - start) * step).sum(axis=-1) / square
    foot = start + np.clip(raw, 0.0, 1.0)[..., None] * step
    away = first[:, :, None] - foot
    distance = np.linalg.norm(away, axis=-1)
    own = np.gradient(first, axis=1)[:, :, None]
    cosine = np.abs((own * step).sum(axis=-1)) / np.maximum(np.linalg.norm(own, axis=-1) * np.sqrt(square), 1e-300)
    # Past the end of the second there is no edge to run beside.
    past = np.abs((away * step).sum(axis=-1)) > _PAST * distance * np.sqrt(square)
    past &= distance > 1e-3 * reach[:, None, None]
    good = (distance <= reach[:, None, None]) & (cosine >= _PARALLEL) & ~past
    return good.any(axis=2).sum(axis=1) >= _LEAST
