"""Many integral curves at once: the method of Dormand and Prince of order 8, each curve with its own steps.

The coefficients and the dense output are SciPy's (``scipy.integrate.DOP853``; Hairer, Nørsett and Wanner 1993, II.5),
which integrates one system with one step.
"""

from collections.abc import Callable
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from quintrig.support.arrays import FloatArray

Slope = Callable[[FloatArray, NDArray[np.intp]], FloatArray]
"""dy/dt (k, d) at states (k, d) of the curves with these numbers (k,)."""


class Steps:
    """One try of a step of several curves, ``y`` to ``end`` (k, d), with the relative ``error`` of each (k,)."""

    def __init__(
        self, slope: Slope, which: NDArray[np.intp], y: FloatArray, h: FloatArray, relative: float, absolute: float
    ) -> None:
        """Evaluate the twelve stages."""
        tables = _tables()
        self.slope, self.which, self.y, self.h = slope, which, y, h
        self.stages: list[FloatArray] = [slope(y, which)]
        for row in tables.A[1 : tables.n_stages]:
            self.stages.append(slope(self._at(row), which))
        self.end = self._at(tables.B)
        self.stages.append(slope(self.end, which))
        scale = absolute + relative * np.maximum(np.abs(y), np.abs(self.end))
        five, three = (self._sum(e) / scale for e in (tables.E5, tables.E3))
        square5, square3 = (five**2).sum(axis=1), (three**2).sum(axis=1)
        bottom = np.sqrt((square5 + 0.01 * square3) * y.shape[1])
        with np.errstate(divide="ignore", invalid="ignore"):
            self.error: FloatArray = np.where(square5 > 0.0, np.abs(h) * square5 / bottom, square5)

    def factor(self) -> FloatArray:
        """Return by how much the next step, or try, should be longer (k,)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            wanted = 0.9 * self.error ** (-1.0 / 8.0)
        return np.where(np.isfinite(self.error), np.clip(np.nan_to_num(wanted, nan=0.2, posinf=10.0), 0.2, 10.0), 0.2)

    def dense(self) -> FloatArray:
        """Return the coefficients (k, 8, d) of the dense output, as ``dense_at`` takes them."""
        tables = _tables()
        for row in tables.A_EXTRA:
            self.stages.append(self.slope(self._at(row), self.which))
        gain, h = self.end - self.y, self.h[:, None]
        first, last = self.stages[0], self.stages[12]
        rest = [h * self._sum(row) for row in tables.D]
        return np.stack([self.y, gain, h * first - gain, 2.0 * gain - h * (last + first), *rest], axis=1)

    def _sum(self, weights: FloatArray) -> FloatArray:
        terms = [w * stage for w, stage in zip(weights.tolist(), self.stages, strict=False) if w]
        return cast(FloatArray, sum(terms)) if terms else np.zeros_like(self.y)

    def _at(self, weights: FloatArray) -> FloatArray:
        return self.y + self.h[:, None] * self._sum(weights)


def dense_at(coefficients: FloatArray, x: FloatArray) -> FloatArray:
    """Return states (..., d) at shares x (...) of steps with coefficients (..., 8, d)."""
    x = x[..., None]
    result = np.zeros_like(coefficients[..., 0, :])
    for i in range(7):
        result = (result + coefficients[..., 7 - i, :]) * (x if i % 2 == 0 else 1.0 - x)
    return result + coefficients[..., 0, :]


def _tables() -> Any:
    from scipy import integrate

    return cast(Any, integrate).DOP853
