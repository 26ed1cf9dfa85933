"""Nets of lines of a flow at a given spacing: first along a crossing line, then wherever gaps are left.

After Jobard and Lefer 1997: a line begins ``spacing`` beside another one, and ends where it comes nearer than half of
that to a line that was there before.
"""

from collections.abc import Sequence
from typing import Any, cast

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.follow import Curve, Place, both_ways
from quintrig.interrogation.local import Local
from quintrig.interrogation.polyline import Path
from quintrig.interrogation.trace import Tracer
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.progress import Progress

_NEAR = 0.5  # of the spacing: nearer to another line, a line ends
_APART = 0.9  # of the spacing: a line begins no nearer to another one
_WAVES = 60
_FEW = 0.25  # of the spacing: shorter lines are left out
_SHARE = 0.1  # of all lines, those that a later wave may still add before the net counts as full


class Net:
    """The lines of both families that are there, and the points that they keep free."""

    def __init__(self, tracer: Tracer, spacing: float, length: float, most: int, progress: Progress) -> None:
        """Begin without lines."""
        self.tracer, self.spacing, self.length, self.most = tracer, spacing, length, most
        self.progress = progress
        self.curves: list[Curve] = []
        self._clouds: dict[int, list[FloatArray]] = {mode: [] for mode in tracer.flow.modes}

    def fill(self, starts: Sequence[tuple[int, FloatArray]]) -> list[Curve]:
        """Return the net that begins at the starts (patch, parameters)."""
        modes = self.tracer.flow.modes
        places: list[Place] = []
        for patch, uv in starts:
            for mode in modes:
                if self._free(mode, self.tracer.surfaces[patch](*uv)):
                    places.append((patch, uv, mode))
        grown = self._add(places)
        for _ in range(_WAVES):
            places = self._crossing(grown) if grown else []
            places += self._beside(grown)
            grown = self._add(places)
            self.progress("lines", len(self.curves), self.most)
            if not grown or len(self.curves) >= self.most:
                break
        return self.curves

    def _add(self, places: Sequence[Place]) -> list[Curve]:
        """Trace lines from places that are far enough from each other; return what is left of them."""
        if not places:
            return []
        grown: list[Curve] = []
        for curve in both_ways(self.tracer, self._sparse(places), self.length):
            if not curve.paths or len(self.curves) >= self.most:
                continue
            for part in self._cut(curve):
                mode = part.modes[0]
                self._clouds.setdefault(mode, []).append(self._points(part))
                self.curves.append(part)
                grown.append(part)
        return grown

    def _sparse(self, places: Sequence[Place]) -> list[Place]:
        """Return places of which no two of a family can be on lines nearer than the spacing."""
        kept: list[Place] = []
        points: list[tuple[int, FloatArray]] = []
        for patch, uv, mode in places:
            point = self.tracer.surfaces[patch](*uv)
            near = any(m == mode and np.linalg.norm(point - p) < _APART * self.spacing for m, p in points)
            if not near and np.isfinite(point).all():
                kept.append((patch, uv, mode))
                points.append((mode, point))
        return kept

    def _crossing(self, curves: Sequence[Curve]) -> list[Place]:
        """Return where lines of the other family begin along these: every ``spacing`` from their middle."""
        found: list[Place] = []
        for curve in curves:
            other = self._other(curve.modes[0])
            for path in curve.paths:
                surface = self.tracer.surfaces[path.patch]
                points = surface(*path.uv.T)
                s = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
                middle = 0.5 * s[-1]
                wanted = middle + self.spacing * np.arange(-int(middle / self.spacing), int(middle / self.spacing) + 1)
                for k in np.asarray(np.searchsorted(s, wanted), dtype=np.intp).tolist():
                    uv = path.uv[min(k, len(s) - 1)]
                    if self._inside(surface, uv) and self._free(other, surface(*uv)):
                        found.append((path.patch, uv, other))
        return found

    def _beside(self, curves: Sequence[Curve]) -> list[Place]:
        """Return where lines of the same family begin beside these: one place a side of each path."""
        found: list[Place] = []
        for curve in curves:
            for path, mode in zip(curve.paths, curve.modes, strict=True):
                surface = self.tracer.surfaces[path.patch]
                local = Local.at(surface, *path.middles.T, order=1)
                chord = np.diff(surface(*path.uv.T), axis=0)
                with np.errstate(divide="ignore", invalid="ignore"):
                    away = np.cross(local.up, chord)
                    away *= self.spacing / np.linalg.norm(away, axis=1)[:, None]
                    step = local.lowered(away)
                for side in (step, -step):
                    uv = path.middles + side
                    fits = np.isfinite(uv).all(axis=1) & ((uv >= 0.0) & (uv <= 1.0)).all(axis=1)
                    where = uv[fits]
                    if not len(where):
                        continue
                    free = self._all_free(mode, surface(*where.T)) & surface.inside(*where.T)
                    if free.any():
                        rest = where[free]
                        found.append((path.patch, rest[len(rest) // 2], mode))
        return found

    def _cut(self, curve: Curve) -> list[Curve]:
        """Return the parts of a line that keep their distance from all lines before it."""
        parts: list[tuple[list[Path], list[int]]] = [([], [])]
        for path, mode in zip(curve.paths, curve.modes, strict=True):
            free = self._all_free(mode, self.tracer.surfaces[path.patch](*path.uv.T), _NEAR)
            ends = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
            for first, last in ends.reshape(-1, 2).tolist():
                if first or not free[0]:
                    parts.append(([], []))
                if last - first > 1:
                    whole = last - first == len(path.uv)
                    closed = path.closed and whole
                    parts[-1][0].append(Path(path.patch, path.uv[first:last], path.middles[first : last - 1], closed))
                    parts[-1][1].append(mode)
            if not free[-1]:
                parts.append(([], []))
        found = [Curve(tuple(p), tuple(m), curve.closed and len(parts) == 1, curve.ended) for p, m in parts if p]
        return [part for part in found if self._long(part)]

    def _long(self, curve: Curve) -> bool:
        reach = sum(float(np.linalg.norm(np.diff(self._on(path), axis=0), axis=1).sum()) for path in curve.paths)
        return reach >= _FEW * self.spacing

    def _on(self, path: Path) -> FloatArray:
        return self.tracer.surfaces[path.patch](*path.uv.T)

    def _points(self, curve: Curve) -> FloatArray:
        return np.concatenate([self._on(path) for path in curve.paths])

    def _free(self, mode: int, point: FloatArray) -> bool:
        return bool(self._all_free(mode, point[None, :])[0])

    def _all_free(self, mode: int, points: FloatArray, share: float = _APART) -> BoolArray:
        from scipy import spatial

        clouds = self._clouds.get(mode)
        good: BoolArray = np.asarray(np.isfinite(points).all(axis=1))
        if not clouds:
            return good
        tree = cast(Any, spatial).KDTree(np.concatenate(clouds))
        near: FloatArray = tree.query(np.where(good[:, None], points, 0.0))[0]
        return good & (near >= share * self.spacing)

    def _other(self, mode: int) -> int:
        return next(m for m in self.tracer.flow.modes if m != mode)

    def _inside(self, surface: Surface, uv: FloatArray) -> bool:
        return bool(surface.inside(*uv))
