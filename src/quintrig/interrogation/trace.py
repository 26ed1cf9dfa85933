"""Integral curves through all patches of a model, many at once.

The last step before an edge takes the parameter that leaves as its variable, so that it ends on the edge exactly
(Hénon 1982).
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.interrogation.flows import Flow
from quintrig.interrogation.local import Local
from quintrig.interrogation.polyline import Path
from quintrig.interrogation.runge_kutta import Steps, dense_at
from quintrig.interrogation.seams import Seams
from quintrig.support.arrays import FloatArray

RELATIVE = 1e-11
"""Relative error of a step."""

_MOST_STEPS = 4000  # of all lines in one patch together
_MOST_PIECES = 64  # patches and seams that one line crosses
_LONGEST = 0.1  # of the size: a step
_SHORTEST = 1e-10  # of the size: a step; a line that needs shorter ones ends
_MEETS = 1e-6  # of the size: nearer than this to its start, a line is closed
_AWAY = 1e-2  # of the size: before this no line comes back
_FINEST = 256  # chords of one step


@dataclass(frozen=True, eq=False)
class Seed:
    """Where a line begins, and towards where (3,): ``mode`` is the family of the flow."""

    patch: int
    uv: FloatArray
    towards: FloatArray
    mode: int = 0


@dataclass(eq=False)
class Trail:
    """A line as it was traced: its paths in the patches that it crosses, and why it ended."""

    paths: list[Path] = field(default_factory=list[Path])
    modes: list[int] = field(default_factory=list[int])
    closed: bool = False
    ended: str = ""


@dataclass(eq=False)
class _Walk:
    """One line under way."""

    trail: Trail
    patch: int
    state: FloatArray
    aim: FloatArray
    mode: int
    left: float
    home: FloatArray
    heading: FloatArray
    gone: float = 0.0
    step: float = 0.0
    exit: tuple[int, float] | None = None
    steps: list[FloatArray] = field(default_factory=list[FloatArray])
    running: bool = True


class Tracer:
    """Follows a flow over the surfaces of a model, with chords within ``chord`` (length¹)."""

    def __init__(self, surfaces: Sequence[Surface], flow: Flow, chord: float, longest: float = np.inf) -> None:
        """Look at the seams once; no chord is longer than ``longest``."""
        self.surfaces, self.flow, self.chord, self.longest = surfaces, flow, chord, longest
        self.relative = RELATIVE
        self.seams = Seams(surfaces)
        self.size = self.seams.size

    def trace(self, seeds: Sequence[Seed], length: float | Sequence[float]) -> list[Trail]:
        """Return the lines from the seeds, at most ``length`` long (length¹), in their order."""
        lengths = [length] * len(seeds) if isinstance(length, float | int) else list(length)
        walks: list[_Walk] = []
        for seed, reach in zip(seeds, lengths, strict=True):
            surface = self.surfaces[seed.patch]
            local = Local.at(surface, *seed.uv, order=1)
            state, aim = self._begun(seed.patch, seed.uv, local.lowered(seed.towards), seed.mode)
            heading = local.lifted(aim)
            walk = _Walk(Trail(), seed.patch, state, aim, seed.mode, float(reach), local.point, heading)
            if not np.isfinite(heading).all() or self.flow.ended(surface, state[None, :])[0]:
                walk.running, walk.trail.ended = False, "begins where the field has no direction"
            walks.append(walk)
        for _ in range(_MOST_PIECES):
            for patch in sorted({walk.patch for walk in walks if walk.running}):
                self._in_patch(patch, [walk for walk in walks if walk.running and walk.patch == patch])
            for walk in walks:
                self._land(walk)
            if not any(walk.running for walk in walks):
                break
        for walk in walks:
            if not walk.trail.closed:
                walk.trail.ended = walk.trail.ended or "crosses more patches than are followed"
        return [walk.trail for walk in walks]

    def _begun(self, patch: int, uv: FloatArray, aim: FloatArray, mode: int) -> tuple[FloatArray, FloatArray]:
        """Return the state at parameters (2,), and du and dv by arc length in the sense of ``aim`` (2,)."""
        surface, aims = self.surfaces[patch], aim[None, :]
        state = self.flow.begin(surface, uv[None, :], aims)
        return state[0], self.flow.slope(surface, state, aims, np.array([mode], dtype=np.intp))[0, :2]

    def _land(self, walk: _Walk) -> None:
        """Write down the path in the patch just crossed, and move the line on into the next."""
        if walk.steps:
            path = self._sampled(walk)
            walk.trail.paths.append(path)
            walk.trail.modes.append(walk.mode)
            walk.steps = []
        if not walk.running:
            return
        uv = np.clip(walk.state[:2], 0.0, 1.0)
        local = Local.at(self.surfaces[walk.patch], *uv, order=1)
        towards = local.lifted(walk.aim)
        towards = towards / np.linalg.norm(towards)
        if self._is_home(walk, local.point, towards):
            walk.running, walk.trail.closed = False, True
            return
        found = self.seams.enter(walk.patch, uv, towards)
        if found is None:
            walk.running, walk.trail.ended = False, "ends at an edge"
            return
        walk.patch, place = found
        local = Local.at(self.surfaces[walk.patch], *place, order=1)
        best = -2.0
        for mode in self.flow.modes:  # a neighbour's normal may point the other way
            state, aim = self._begun(walk.patch, place, local.lowered(towards), mode)
            cosine = float(local.lifted(aim) @ towards)
            if np.isfinite(aim).all() and cosine > best:
                best, walk.mode, walk.state, walk.aim = cosine, mode, state, aim
        walk.exit = None
        if best == -2.0 or self.flow.ended(self.surfaces[walk.patch], walk.state[None, :])[0]:
            walk.running, walk.trail.ended = False, "ends where the field has no direction"

    def _is_home(self, walk: _Walk, point: FloatArray, towards: FloatArray) -> bool:
        near = np.linalg.norm(point - walk.home) <= _MEETS * self.size
        return bool(near and walk.gone > _AWAY * self.size and towards @ walk.heading > 0.5)

    def _in_patch(self, patch: int, walks: list[_Walk]) -> None:
        """Follow lines until each leaves the patch, closes, or ends."""
        surface = self.surfaces[patch]
        for walk in walks:
            walk.step = walk.step or 0.02 * self.size
        active = walks
        for _ in range(_MOST_STEPS):
            active = [walk for walk in active if walk.running and walk.exit is None]
            if not active:
                break
            self._step(surface, active)
        for walk in active:
            if walk.running and walk.exit is None:
                walk.running, walk.trail.ended = False, "takes more steps than are followed"
        leaving = [walk for walk in walks if walk.running and walk.exit is not None]
        if leaving:
            self._leave(surface, leaving)

    def _step(self, surface: Surface, walks: list[_Walk]) -> None:
        y = np.stack([walk.state for walk in walks])
        aims = np.stack([walk.aim for walk in walks])
        modes = np.array([walk.mode for walk in walks], dtype=np.intp)
        h = np.array([min(walk.step, walk.left, _LONGEST * self.size) for walk in walks])

        def slope(state: FloatArray, which: NDArray[np.intp]) -> FloatArray:
            return self.flow.slope(surface, state, aims[which], modes[which])

        step = Steps(slope, np.arange(len(walks)), y, h, self.relative, 0.01 * self.relative)
        outside = _outside(step.end)
        good = (step.error < 1.0) & ~outside
        factor = step.factor()
        dense = step.dense() if good.any() else np.empty((len(walks), 8, y.shape[1]))
        good &= np.isfinite(dense).all(axis=(1, 2))
        ends = np.where(good[:, None], step.end, y)
        stopped = self.flow.ended(surface, ends)
        u, v = np.clip(ends[:, :2], 0.0, 1.0).T  # of a step that is taken, or its start
        points = analyse(surface, u, v, ("point",), threads=1).point
        for k, walk in enumerate(walks):
            leaves = _exit(y[k], step.stages[0][k], 1.5 * h[k]) if outside[k] else None
            if leaves is not None:
                walk.exit = leaves
            elif not good[k]:
                walk.step = h[k] * (min(0.5, factor[k]) if outside[k] else min(0.9, factor[k]))
                if walk.step < _SHORTEST * self.size:
                    walk.running, walk.trail.ended = False, "ends where the field has no direction"
            else:
                self._take(walk, surface, dense[k], h[k], points[k], step.stages[12][k, :2], bool(stopped[k]))
                walk.step = h[k] * factor[k]

    def _take(
        self,
        walk: _Walk,
        surface: Surface,
        dense: FloatArray,
        h: float,
        point: FloatArray,
        aim: FloatArray,
        stopped: bool,
    ) -> None:
        if walk.gone > _AWAY * self.size and np.linalg.norm(point - walk.home) < 1.5 * h:
            share = self._home(walk, surface, dense)
            if share is not None:
                walk.steps.append(_shortened(dense, share))
                walk.running, walk.trail.closed = False, True
                return
        walk.steps.append(dense)
        walk.state, walk.aim = dense_at(dense, np.array(1.0)), aim
        walk.gone += h
        walk.left -= h
        if stopped:
            walk.running, walk.trail.ended = False, "ends where the field has no direction"
        elif walk.left <= 1e-12 * self.size:
            walk.running, walk.trail.ended = False, "has the length asked for"

    def _home(self, walk: _Walk, surface: Surface, dense: FloatArray) -> float | None:
        """Return the share of a step at which the line is back at its start, if it is."""
        low, high = 0.0, 1.0
        while True:
            x = np.linspace(low, high, 17)
            uv = np.clip(dense_at(np.broadcast_to(dense, (len(x), *dense.shape)), x)[:, :2], 0.0, 1.0)
            points = surface(*uv.T)
            apart = np.linalg.norm(points - walk.home, axis=1)
            k = int(apart.argmin())
            if high - low < 1e-9:
                break
            width = (high - low) / 16.0
            low, high = max(float(x[k]) - width, 0.0), min(float(x[k]) + width, 1.0)
        along = points[min(k + 1, 16)] - points[max(k - 1, 0)]
        return float(x[k]) if apart[k] <= _MEETS * self.size and along @ walk.heading > 0.0 else None

    def _leave(self, surface: Surface, walks: list[_Walk]) -> None:
        """Take every line onto the edge that it leaves through."""
        exits = [walk.exit for walk in walks if walk.exit is not None]
        axes, ends = np.array([axis for axis, _ in exits]), np.array([end for _, end in exits])
        rows = np.arange(len(walks))
        y = np.stack([walk.state for walk in walks])
        reach = ends - y[rows, axes]
        aims = np.stack([walk.aim for walk in walks])
        modes = np.array([walk.mode for walk in walks], dtype=np.intp)

        def slope(state: FloatArray, which: NDArray[np.intp]) -> FloatArray:
            by_s = self.flow.slope(surface, state[:, :-1], aims[which], modes[which])
            with np.errstate(divide="ignore", invalid="ignore"):
                per = (reach[which] / by_s[np.arange(len(which)), axes[which]])[:, None]
                return np.concatenate([by_s * per, per], axis=1)  # the last is arc length

        state = np.concatenate([y, np.zeros((len(y), 1))], axis=1)
        x, h = np.zeros(len(walks)), np.ones(len(walks))
        open_ = reach != 0.0
        for _ in range(200):
            which = np.flatnonzero(open_)
            if not len(which):
                break
            step = Steps(slope, which, state[which], h[which], self.relative, 0.01 * self.relative)
            dense, factor = step.dense(), step.factor()
            for k, i in enumerate(which.tolist()):
                if step.error[k] < 1.0 and np.isfinite(dense[k]).all():
                    walks[i].steps.append(dense[k, :, :-1])
                    state[i], x[i] = step.end[k], x[i] + h[i]
                    open_[i] = x[i] < 1.0 - 1e-12
                elif h[i] * factor[k] < 1e-9:
                    open_[i] = False
                h[i] = min(h[i] * factor[k], 1.0 - x[i])
        state[rows, axes] = ends
        last = self.flow.slope(surface, state[:, :-1], aims, modes)[:, :2]
        for k, walk in enumerate(walks):
            walk.state, walk.gone = state[k, :-1], walk.gone + state[k, -1]
            walk.left -= state[k, -1]
            walk.aim = last[k] if np.isfinite(last[k]).all() else walk.aim
            if walk.left <= 1e-9 * self.size:
                walk.running, walk.trail.ended = False, "has the length asked for"

    def _sampled(self, walk: _Walk) -> Path:
        """Return the path of a line's steps, each cut into as many chords as it needs."""
        surface, steps = self.surfaces[walk.patch], np.stack(walk.steps)
        x = np.linspace(0.0, 1.0, 9)
        uv = dense_at(steps[:, None], np.broadcast_to(x, (len(steps), 9)))[..., :2]
        points = surface(*np.clip(uv, 0.0, 1.0).reshape(-1, 2).T).reshape(len(steps), 9, 3)
        off = np.linalg.norm(points[:, 1::2] - 0.5 * (points[:, 0:-1:2] + points[:, 2::2]), axis=2).max(axis=1)
        reach = np.linalg.norm(np.diff(points, axis=1), axis=2).sum(axis=1) / self.longest
        counts = np.clip(np.ceil(np.maximum(4.4 * np.sqrt(off / self.chord), reach)), 1, _FINEST).astype(int)
        shares: list[FloatArray] = [np.arange(2 * n) / (2.0 * n) for n in map(int, counts)]
        share = np.concatenate([*shares, np.ones(1)])
        which = np.concatenate([np.repeat(np.arange(len(steps)), 2 * counts), [len(steps) - 1]])
        found = np.clip(dense_at(steps[which], share)[:, :2], 0.0, 1.0)
        return Path(walk.patch, found[::2], found[1::2])


def _outside(state: FloatArray) -> NDArray[np.bool_]:
    uv = state[:, :2]
    return np.asarray(((uv < -1e-13) | (uv > 1.0 + 1e-13)).any(axis=1))


def _exit(state: FloatArray, slope: FloatArray, reach: float) -> tuple[int, float] | None:
    """Return the axis and end through which a line leaves if it goes straight on, within ``reach``, length¹."""
    best: tuple[float, int, float] | None = None
    for axis in (0, 1):
        speed = float(slope[axis])
        if speed != 0.0 and np.isfinite(speed):
            end = 1.0 if speed > 0.0 else 0.0
            s = (end - float(state[axis])) / speed
            if s <= reach and (best is None or s < best[0]):
                best = s, axis, end
    return None if best is None else best[1:]


def _shortened(dense: FloatArray, share: float) -> FloatArray:
    """Return a step cut at a share of it, as a dense output of its own: its polynomial met at eight places."""
    x = 0.5 - 0.5 * np.cos(np.pi * np.arange(8) / 7.0)
    basis = np.stack([dense_at(np.eye(8)[k][:, None], t[None])[0] for k in range(8) for t in x]).reshape(8, 8)
    wanted = dense_at(np.broadcast_to(dense, (8, *dense.shape)), share * x)
    return np.asarray(np.linalg.solve(basis.T, wanted), dtype=np.float64)
