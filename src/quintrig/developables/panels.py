"""The integrals along a developable strip that lay it out in the plane (``unroll`` has the formulas)."""

import numpy as np

from quintrig.developables.rulings import Rulings
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.legendre import legendre

_NODES = 16


class Panels:
    """The integrals on panels between the breaks of the strip, as Legendre series of each panel."""

    def __init__(self, lines: Rulings, per_piece: int) -> None:
        """Integrate along the strip, with so many panels between two breaks."""
        self.per_piece = per_piece
        steps = np.linspace(0.0, 1.0, per_piece, endpoint=False)
        pieces = [low + (high - low) * steps for low, high in zip(lines.breaks[:-1], lines.breaks[1:], strict=True)]
        self.edges: FloatArray = np.concatenate([*pieces, [1.0]])
        half = 0.5 * np.diff(self.edges)
        nodes, self.weights = legendre(_NODES)
        self.t = 0.5 * (self.edges[1:] + self.edges[:-1])[:, None] + half[:, None] * nodes
        self._to_series = np.linalg.inv(np.polynomial.legendre.legvander(nodes, _NODES - 1))
        self.half = half
        local = lines.at(self.t.ravel())
        shape = self.t.shape
        self.length = local.length.reshape(shape)
        turning, self.turning_at_nodes = self._integral(local.turning.reshape(shape), nodes)
        self._turning, self._turning_start = turning
        c, s = np.cos(self.turning_at_nodes), np.sin(self.turning_at_nodes)
        along, across = local.along[0].reshape(shape), local.across[0].reshape(shape)
        (self._x, self._x_start), x = self._integral(along * c - across * s, nodes)
        (self._y, self._y_start), y = self._integral(along * s + across * c, nodes)
        (self._bend, self._bend_start), _ = self._integral(np.abs(local.bend).reshape(shape), nodes)
        self._length = self._series(self.length)
        self._upward = self._series(local.upward.reshape(shape).astype(np.float64))
        self.first = np.stack([x, y], axis=-1)
        self.second = self.first + self.length[..., None] * np.stack([c, s], axis=-1)

    @property
    def end(self) -> FloatArray:
        """Both ends of the last ruling, (2, 2), to see whether the integrals have settled."""
        first, second, _, _ = self.at(np.ones(1))
        return np.concatenate([first, second])

    def at(self, t: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, BoolArray]:
        """Return both boundary points, the bend so far and its direction at parameters (n,)."""
        k = np.clip(np.searchsorted(self.edges, t, side="right") - 1, 0, len(self.half) - 1)
        local = (t - self.edges[k]) / self.half[k] - 1.0
        basis = np.polynomial.legendre.legvander(local, _NODES)

        def value(series: FloatArray, start: FloatArray) -> FloatArray:
            return start[k] + (basis[:, : series.shape[1]] * series[k]).sum(axis=1)

        angle = value(self._turning, self._turning_start)
        first = np.stack([value(self._x, self._x_start), value(self._y, self._y_start)], axis=-1)
        none = np.zeros(len(self.half))
        reach = value(self._length, none)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        upward = value(self._upward, none) > 0.5
        return first, first + reach, value(self._bend, self._bend_start), upward

    def slopes(self, values: FloatArray) -> FloatArray:
        """Return the derivatives by t at the nodes of functions given there, (panels, nodes, ...)."""
        series = np.einsum("ij,pj...->pi...", self._to_series, values)
        derived = np.polynomial.legendre.legder(np.eye(_NODES), axis=0)
        back = np.linalg.inv(self._to_series)[:, : _NODES - 1] @ derived
        return np.einsum("ij,pj...->pi...", back, series) / self.half.reshape(-1, *[1] * (values.ndim - 1))

    def total(self, values: FloatArray) -> float:
        """Return the integral over the strip of a function given at the nodes."""
        return float((self.half * (values @ self.weights)).sum())

    def _series(self, values: FloatArray) -> FloatArray:
        return values @ self._to_series.T

    def _integral(self, values: FloatArray, nodes: FloatArray) -> tuple[tuple[FloatArray, FloatArray], FloatArray]:
        """Return the integral from t = 0 as (series, value at the start of each panel), and its values at the nodes."""
        series = np.polynomial.legendre.legint(self._series(values), axis=1, lbnd=-1) * self.half[:, None]
        ends = series.sum(axis=1)  # every Legendre polynomial is 1 at the end of its panel
        start = np.concatenate([[0.0], np.cumsum(ends)[:-1]])
        at_nodes = start[:, None] + series @ np.polynomial.legendre.legvander(nodes, _NODES).T
        return (series, start), at_nodes
