"""Nets of lines of a flow at a given spacing: first along a crossing line, then wherever gaps are left.

After Jobard and Lefer 1997: a line begins ``spacing`` beside another one, and ends where it comes nearer than half of
that to a line that was there before.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from quintrig.interrogation.follow import Curve, Place, both_ways
from quintrig.interrogation.local import Local
from quintrig.interrogation.near import Near, clear_of_itself, thinned
from quintrig.interrogation.polyline import Path
from quintrig.interrogation.trace import Tracer
from quintrig.support.arrays import FloatArray
from quintrig.support.progress import Progress

_NEAR = 0.5  # of the spacing: nearer to another line, a line ends
_APART = 0.9  # of the spacing: a line begins no nearer to another one
_BACK = 3.0  # of that distance: how far behind a line may be near itself
_AT_ONCE = 24  # lines, after which it is looked which places are still free
_WAVES = 60
_FEW = 0.25  # of the spacing: shorter lines are left out


class Net:
    """The lines of both families that are there, and the points that they keep free."""

    def __init__(self, tracer: Tracer, spacing: float, length: float, most: int, progress: Progress) -> None:
        """Begin without lines."""
        self.tracer, self.spacing, self.length, self.most = tracer, spacing, length, most
        self.progress = progress
        self.curves: list[Curve] = []
        self._near = {mode: Near(_APART * spacing) for mode in tracer.flow.modes}

    def fill(self, starts: Sequence[tuple[int, FloatArray]]) -> list[Curve]:
        """Return the net that begins at the first of the starts (patch, parameters), then at those still free."""
        points = self._points(starts)
        for (patch, uv), point in zip(starts, points, strict=True):
            grown = self._add([(patch, uv, mode) for mode in self.tracer.flow.modes if self._free(mode, point)])
            for _ in range(_WAVES):
                if not grown or len(self.curves) >= self.most:
                    break
                grown = self._add([*self._crossing(grown), *self._beside(grown)])
                self.progress("lines", len(self.curves), self.most)
            if len(self.curves) >= self.most:
                break
        return self.curves

    def _points(self, places: Sequence[tuple[int, FloatArray]]) -> FloatArray:
        """Return the points (n, 3) of places (patch, parameters)."""
        found: FloatArray = np.empty((len(places), 3))
        patches = np.array([patch for patch, _ in places])
        for patch in dict.fromkeys(patches.tolist()):
            here = np.flatnonzero(patches == patch)
            found[here] = self.tracer.surfaces[patch](*np.array([places[k][1] for k in here.tolist()]).T)
        return found

    def _free(self, mode: int, point: FloatArray) -> bool:
        return bool(self._near[mode].free(point[None, :], _APART * self.spacing)[0])

    def _add(self, places: Sequence[Place]) -> list[Curve]:
        """Trace lines from places that are far enough from each other, some at once; return what is left of them."""
        grown: list[Curve] = []
        waiting = self._sparse(places) if places else []
        while waiting and len(self.curves) < self.most:
            for curve in both_ways(self.tracer, waiting[:_AT_ONCE], self.length):
                for part in self._cut(curve)[: self.most - len(self.curves)] if curve.paths else ():
                    self._near[part.modes[0]].add(np.concatenate([self._on(path) for path in part.paths]))
                    self.curves.append(part)
                    grown.append(part)
            waiting = self._sparse(waiting[_AT_ONCE:])
        return grown

    def _sparse(self, places: Sequence[Place]) -> list[Place]:
        """Return places still free, of which no two of a family can be on lines nearer than the spacing."""
        points, apart = self._points([place[:2] for place in places]), _APART * self.spacing
        kept: list[int] = []
        for mode in self.tracer.flow.modes:
            here = np.flatnonzero([place[2] == mode for place in places])
            here = here[self._near[mode].free(points[here], apart)]
            kept += here[thinned(points[here], apart)].tolist()
        return [places[k] for k in sorted(kept)]

    def _crossing(self, curves: Sequence[Curve]) -> list[Place]:
        """Return where lines of the other family begin along these: every ``spacing`` from their middle."""
        found: list[Place] = []
        for curve in curves:
            other = next(mode for mode in self.tracer.flow.modes if mode != curve.modes[0])
            for path in curve.paths:
                points = self._on(path)
                s = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
                middle = 0.5 * s[-1]
                wanted = middle + self.spacing * np.arange(-int(middle / self.spacing), int(middle / self.spacing) + 1)
                at: NDArray[np.intp] = np.minimum(np.asarray(np.searchsorted(s, wanted), dtype=np.intp), len(s) - 1)
                fits = self._near[other].free(points[at], _APART * self.spacing)
                fits &= self.tracer.surfaces[path.patch].inside(*path.uv[at].T)
                found += [(path.patch, uv, other) for uv in path.uv[at[fits]]]
        return found

    def _beside(self, curves: Sequence[Curve]) -> list[Place]:
        """Return where lines of the same family begin beside these: one place a side of each path."""
        found: list[Place] = []
        each = [pair for curve in curves for pair in zip(curve.paths, curve.modes, strict=True)]
        for patch in dict.fromkeys(path.patch for path, _ in each):
            here = [(path, mode) for path, mode in each if path.patch == patch]
            uv, step = self._aside(patch, [path for path, _ in here])
            owner = np.repeat(np.arange(len(here)), [len(path.middles) for path, _ in here])
            modes = np.array([mode for _, mode in here])
            beside = np.concatenate([uv + step, uv - step])
            owner, side = np.tile(owner, 2), np.repeat([0, 1], len(owner))
            fits = np.isfinite(beside).all(axis=1) & ((beside >= 0.0) & (beside <= 1.0)).all(axis=1)
            beside, owner, side = beside[fits], owner[fits], side[fits]
            surface = self.tracer.surfaces[patch]
            free, points = surface.inside(*beside.T), surface(*beside.T)
            for mode in self.tracer.flow.modes:
                own = modes[owner] == mode
                free[own] &= self._near[mode].free(points[own], _APART * self.spacing)
            for k, (_, mode) in enumerate(here):
                for one in (0, 1):
                    rest = beside[free & (owner == k) & (side == one)]
                    if len(rest):
                        found.append((patch, rest[len(rest) // 2], mode))
        return found

    def _aside(self, patch: int, paths: Sequence[Path]) -> tuple[FloatArray, FloatArray]:
        """Return the middles of paths (n, 2), and the steps (n, 2) across that are ``spacing`` long in space."""
        uv = np.concatenate([path.middles for path in paths])
        chord = np.concatenate([np.diff(self._on(path), axis=0) for path in paths])
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(self.tracer.surfaces[patch], *uv.T, order=1)
            away = np.cross(local.up, chord)
            away *= self.spacing / np.linalg.norm(away, axis=1)[:, None]
            return uv, local.lowered(away)

    def _cut(self, curve: Curve) -> list[Curve]:
        """Return the parts of a line that keep their distance from all lines before it, and from itself."""
        parts: list[tuple[list[Path], list[int]]] = [([], [])]
        points = [self._on(path) for path in curve.paths]
        reach = _NEAR * self.spacing
        whole = np.concatenate(points)
        own = np.ones(len(whole), dtype=np.bool_) if curve.closed else clear_of_itself(whole, reach, _BACK * reach)
        each = np.split(own, np.cumsum([len(part) for part in points])[:-1])
        for path, mode, here, clear in zip(curve.paths, curve.modes, points, each, strict=True):
            free = self._near[mode].free(here, reach) & clear
            ends = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
            for first, last in ends.reshape(-1, 2).tolist():
                if first or not free[0]:
                    parts.append(([], []))
                if last - first > 1:
                    parts[-1][0].append(path.part(first, last))
                    parts[-1][1].append(mode)
            if not free[-1]:
                parts.append(([], []))
        found = [Curve(tuple(p), tuple(m), curve.closed and len(parts) == 1, curve.ended) for p, m in parts if p]
        return [part for part in found if self._long(part)]

    def _long(self, curve: Curve) -> bool:
        reach = sum(float(np.linalg.norm(np.diff(self._on(path), axis=0), axis=1).sum()) for path in curve.paths)
        return reach >= _FEW * self.spacing

    def _on(self, path: Path) -> FloatArray:
        return path.on(self.tracer.surfaces[path.patch])[0]
