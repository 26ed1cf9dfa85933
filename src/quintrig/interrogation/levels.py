"""Level sets of a scalar over the parameters: marched over a grid, then met to rounding on its edges and between.

A scalar may know its sign only up to the sense of an axis (the change of a curvature along its own direction): signs
of two points are compared after their axes are turned the same way. What is missed is a pair of lines, or a loop,
inside one cell of the grid.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.interrogation.polyline import Path, strayed
from quintrig.support.arrays import BoolArray, FloatArray

CELLS = 107
"""Cells a side: a prime number, so that no node lies where symmetric surfaces have their zeros."""

_ROUNDS = 60  # of regula falsi on an edge
_SAME = 1e-13  # of an edge: a bracket so narrow is a root
_DEEPEST = 12  # times that a chord is halved
_SECANTS, _STILL = 30, 1e-12  # steps to the line, of which those where two levels nearly cross need many
_FAR = 0.95  # of the chord: how far from its middle the line may be; at a right corner it is half of it
_FALLS = 1e-5  # of the values beside it: a sign that changes without a zero is no level

Parts = tuple[FloatArray, FloatArray | float, FloatArray | None]
Scalar = Callable[[FloatArray, FloatArray], Parts]
"""At parameters that broadcast: f and g, of which f - level g is followed, and the axis (..., 3) where there is one."""


@dataclass(frozen=True, eq=False)
class Grid:
    """A scalar at nodes u (n,) and v (m,)."""

    scalar: Scalar
    u: FloatArray
    v: FloatArray
    parts: Parts

    @staticmethod
    def of(surface: Surface, scalar: Scalar, cells: int = CELLS) -> "Grid":
        """Return the scalar on a grid over the window of the face, with the surface's breaks among its nodes."""
        (u0, v0), (u1, v1) = window(surface.trim)
        u, v = _nodes(u0, u1, surface.breaks(0), cells), _nodes(v0, v1, surface.breaks(1), cells)
        return Grid(scalar, u, v, scalar(u[:, None], v[None, :]))

    def values(self, level: float) -> FloatArray:
        """Return f - level g (n, m)."""
        f, g, _ = self.parts
        return np.broadcast_to(f - level * g, (len(self.u), len(self.v)))

    def paths(self, patch: int, surface: Surface, level: float, chord: float) -> list[Path]:
        """Return the lines of a level, with their chords within ``chord`` (length¹) where that can be had."""
        found = _Marched(self, level).lines()
        return [_filled(self.scalar, surface, patch, uv, level, chord) for uv in found]


def _nodes(low: float, high: float, breaks: FloatArray, cells: int) -> FloatArray:
    inner = breaks[(breaks > low) & (breaks < high)]
    return np.unique(np.concatenate([np.linspace(low, high, cells + 1), inner]))


def signed(parts: Parts, level: float, reference: FloatArray | None) -> FloatArray:
    """Return f - level g with its axis turned along ``reference`` (..., 3)."""
    f, g, axis = parts
    values = f - level * g
    if axis is None or reference is None:
        return values
    return values * np.where(np.einsum("...k,...k->...", axis, reference) < 0.0, -1.0, 1.0)


class _Marched:
    """The crossings of one level with the edges of a grid, and how the cells connect them."""

    def __init__(self, grid: Grid, level: float) -> None:
        self.grid, self.level = grid, level
        self.axis = grid.parts[2]
        self.values = grid.values(level)
        n, m = self.values.shape
        along_u, along_v = self._crossed(0), self._crossed(1)
        self.number: list[NDArray[np.intp]] = [np.full(along_u.shape, -1), np.full(along_v.shape, -1)]
        i, j = np.nonzero(along_u)
        k, m_ = np.nonzero(along_v)
        starts = np.concatenate([np.stack([i, j], axis=1), np.stack([k, m_], axis=1)])
        ends = starts + np.repeat([[1, 0], [0, 1]], [len(i), len(k)], axis=0)
        self.places, real = self._met(starts, ends)
        numbers = np.where(real, np.arange(len(starts)), -1)
        self.number[0][i, j], self.number[1][k, m_] = numbers[: len(i)], numbers[len(i) :]
        self.shape = n - 1, m - 1

    def _crossed(self, direction: int) -> BoolArray:
        first = np.s_[:-1, :] if direction == 0 else np.s_[:, :-1]
        second = np.s_[1:, :] if direction == 0 else np.s_[:, 1:]
        a, b = self.values[first], self.values[second]
        turned = np.ones(a.shape)
        if self.axis is not None:
            turned = np.where(np.einsum("...k,...k->...", self.axis[first], self.axis[second]) < 0.0, -1.0, 1.0)
        b = b * turned
        return np.isfinite(a) & np.isfinite(b) & ((a >= 0.0) != (b >= 0.0))

    def _met(self, start: NDArray[np.intp], end: NDArray[np.intp]) -> tuple[FloatArray, BoolArray]:
        """Return where the level is met on edges (k, 2), and whether it is, not only jumped over."""
        low = np.stack([self.grid.u[start[:, 0]], self.grid.v[start[:, 1]]], axis=1)
        high = np.stack([self.grid.u[end[:, 0]], self.grid.v[end[:, 1]]], axis=1)
        if not len(low):
            return low, np.zeros(0, dtype=np.bool_)
        reference = None if self.axis is None else self.axis[start[:, 0], start[:, 1]]

        def at(t: FloatArray, some: NDArray[np.intp]) -> FloatArray:
            uv = low[some] + t[:, None] * (high[some] - low[some])
            return signed(
                self.grid.scalar(uv[:, 0], uv[:, 1]), self.level, None if reference is None else reference[some]
            )

        t, value, scale = _falsi(at, len(low))
        return low + t[:, None] * (high - low), np.abs(value) <= _FALLS * scale

    def lines(self) -> list[FloatArray]:
        """Return the polylines (n, 2) of parameters; a closed one ends where it begins."""
        n, m = self.shape
        lower, upper = self.number[0][:, :m], self.number[0][:, 1:]
        before, after = self.number[1][:n, :], self.number[1][1:, :]
        sides = np.stack([lower, after, upper, before], axis=-1)
        count = (sides >= 0).sum(axis=-1)
        pairs = [row[row >= 0] for row in sides[count == 2]]
        for i, j in np.argwhere(count == 4).tolist():
            low, right, high, left = sides[i, j]
            alike = self._middle_like_corner(i, j)
            pairs += [(low, right), (high, left)] if alike else [(low, left), (high, right)]
        beside: dict[int, list[int]] = {}
        for one, other in pairs:
            beside.setdefault(int(one), []).append(int(other))
            beside.setdefault(int(other), []).append(int(one))
        return [self.places[order] for order in _strung(beside) if len(order) > 1]

    def _middle_like_corner(self, i: int, j: int) -> bool:
        u, v = 0.5 * (self.grid.u[i] + self.grid.u[i + 1]), 0.5 * (self.grid.v[j] + self.grid.v[j + 1])
        reference = None if self.axis is None else self.axis[i, j]
        middle = signed(self.grid.scalar(np.array(u), np.array(v)), self.level, reference)
        return bool((middle >= 0.0) == (self.values[i, j] >= 0.0))


def _falsi(
    at: Callable[[FloatArray, NDArray[np.intp]], FloatArray], count: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return roots in [0, 1] of functions of different signs at its ends, values there, and a scale of each.

    ``at`` gives the values of those with some numbers. Regula falsi as of Illinois (Dowell and Jarratt 1971), with a
    halving every third round; whose root is met takes no part any more.
    """
    every: NDArray[np.intp] = np.arange(count)
    a: FloatArray = np.zeros(count)
    b: FloatArray = np.ones(count)
    fa, fb = at(a, every), at(b, every)
    scale = np.abs(fa) + np.abs(fb) + np.finfo(np.float64).tiny
    root, value = np.where(np.abs(fa) < np.abs(fb), a, b), np.where(np.abs(fa) < np.abs(fb), fa, fb)
    rising = np.asarray(fa >= 0.0)
    open_ = every
    for k in range(_ROUNDS):
        with np.errstate(divide="ignore", invalid="ignore"):
            guess = (a * fb - b * fa) / (fb - fa)
        guess: FloatArray = np.where((guess > a) & (guess < b) & (k % 3 != 2), guess, 0.5 * (a + b))
        found = at(guess, open_)
        better = np.abs(found) <= np.abs(value[open_])
        root[open_[better]], value[open_[better]] = guess[better], found[better]
        like_a = (found >= 0.0) == rising[open_]
        fa, fb = np.where(like_a, found, 0.5 * fa), np.where(like_a, 0.5 * fb, found)
        a, b = np.where(like_a, guess, a), np.where(like_a, b, guess)
        left = (np.abs(value[open_]) > 1e-15 * scale[open_]) & (b - a > _SAME)
        open_ = open_[left]
        a, b, fa, fb = a[left], b[left], fa[left], fb[left]
        if not len(open_):
            break
    return root, value, scale


def _strung(beside: dict[int, list[int]]) -> list[list[int]]:
    """Return the chains of a graph in which every node has one or two neighbours, open ones first."""
    lines: list[list[int]] = []
    left = dict.fromkeys(sorted(beside, key=lambda node: len(beside[node])))
    while left:
        node = next(iter(left))
        line = [node]
        del left[node]
        while True:
            following = next((other for other in beside[node] if other in left), None)
            if following is None:
                break
            line.append(following)
            del left[following]
            node = following
        if len(line) > 2 and line[0] in beside[node]:
            line.append(line[0])
        lines.append(line)
    return lines


def _filled(scalar: Scalar, surface: Surface, patch: int, uv: FloatArray, level: float, chord: float) -> Path:
    """Return the path with points put in until the line is within ``chord`` of its chords, at three places of each."""
    apart = np.concatenate([[True], np.abs(np.diff(uv, axis=0)).max(axis=1) > 1e-13])
    uv = uv[apart] if apart.sum() > 1 else uv
    middles = between(scalar, uv[:-1], uv[1:], level)
    quarters = _quarters(scalar, np.stack([uv[:-1], middles, uv[1:]], axis=1), level)
    for _ in range(_DEEPEST):
        beside = np.concatenate([middles[:, None], quarters], axis=1)
        off = strayed(surface(*uv.T), surface(beside[..., 0], beside[..., 1]))
        coarse = np.flatnonzero(off > chord)
        if not len(coarse):
            break
        halves, fifth = quarters[coarse], [uv[coarse], middles[coarse], uv[coarse + 1]]
        stops = np.stack([fifth[0], halves[:, 0], fifth[1], halves[:, 1], fifth[2]], axis=1)
        finer = [_quarters(scalar, stops[:, k : k + 3], level) for k in (0, 2)]
        new = coarse + np.arange(len(coarse))
        uv = np.insert(uv, coarse + 1, fifth[1], axis=0)
        middles, quarters = (
            np.insert(parts, coarse + 1, second, axis=0)
            for parts, second in ((middles, halves[:, 1]), (quarters, finer[1]))
        )
        middles[new], quarters[new] = halves[:, 0], finer[0]
    gap = float(np.linalg.norm(surface(*uv[0]) - surface(*uv[-1])))
    closed = len(uv) > 3 and gap <= 1e-9 * max(surface.size, 1e-300)
    return Path(patch, uv, middles, closed, quarters=quarters)


def _quarters(scalar: Scalar, stops: FloatArray, level: float) -> FloatArray:
    """Return the points (k, 2, 2) of the line between each two of three (k, 3, 2) of its points."""
    start, end = stops[:, :-1].reshape(-1, 2), stops[:, 1:].reshape(-1, 2)
    return between(scalar, start, end, level).reshape(-1, 2, 2)


def between(scalar: Scalar, start: FloatArray, end: FloatArray, level: float) -> FloatArray:
    """Return points of the line (k, 2) halfway between its points: from the middle of the chord across it, by secants.

    Where they find none near, the middle of the chord stands.
    """
    middle, chord = 0.5 * (start + end), end - start
    across = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    reference: FloatArray | None = None
    with np.errstate(divide="ignore", invalid="ignore"):
        width = np.linalg.norm(chord, axis=1)
        across = across / np.where(width > 0.0, width, 1.0)[:, None]  # two crossings may meet in a node
        first = scalar(middle[:, 0], middle[:, 1])
        reference = first[2]

        def at(t: FloatArray) -> FloatArray:
            uv = np.clip(middle + t[:, None] * across, 0.0, 1.0)
            return signed(scalar(uv[:, 0], uv[:, 1]), level, reference)

        a: FloatArray = np.zeros(len(start))
        b: FloatArray = np.asarray(1e-3 * width)
        fa, fb = signed(first, level, reference), at(b)
        for _ in range(_SECANTS):
            c: FloatArray = b - fb * (b - a) / (fb - fa)
            c = np.where(np.isfinite(c), np.clip(c, -width, width), b)
            a, fa, b = b, fb, c
            fb = at(b)
            if (np.abs(b - a) <= _STILL * width).all():
                break
    found = np.isfinite(fb) & (np.abs(b) < _FAR * width)
    return np.clip(np.where(found[:, None], middle + b[:, None] * across, middle), 0.0, 1.0)
