"""Tangent, normal and Frenet frame of a curve."""

from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import ArrayLike

from quintrig.support.arrays import FloatArray


class Frames(ABC):
    """What a curve that tells its hodograph knows about its directions."""

    points: FloatArray

    @abstractmethod
    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by t, shape (order + 1, *t.shape, 2 or 3), length¹."""

    @abstractmethod
    def hodograph(self, t: ArrayLike, order: int) -> tuple[FloatArray, ...]:
        """Return f, R and derivatives of R, ``order`` + 1 arrays, with z' = f R."""

    def tangent(self, t: ArrayLike) -> FloatArray:
        """Return the unit tangent, shape (*t.shape, 2 or 3); at an end that stands still, its limit; NaN at a cusp."""
        return _unit(self.hodograph(t, 1)[1])

    def normal(self, t: ArrayLike) -> FloatArray:
        """Return the unit normal, shape (*t.shape, 2 or 3).

        In the plane the tangent turned left; in space the principal normal, towards the centre of curvature, NaN where
        the curvature vanishes.
        """
        if self.points.shape[1] == 2:
            tangent = self.tangent(t)
            return np.stack([-tangent[..., 1], tangent[..., 0]], axis=-1)
        return np.cross(self.binormal(t), self.tangent(t))

    def binormal(self, t: ArrayLike) -> FloatArray:
        """Return the unit binormal T x N, shape (*t.shape, 3), NaN where the curvature vanishes.

        Raises ValueError for a plane curve.
        """
        if self.points.shape[1] != 3:
            raise ValueError("binormal: expected a curve in space (n x 3 points), found a plane one")
        _, first, second = self.hodograph(t, 2)
        cross = np.cross(first, second)
        lengths = np.linalg.norm(first, axis=-1) * np.linalg.norm(second, axis=-1)
        straight = np.linalg.norm(cross, axis=-1) <= 1e-13 * lengths
        return np.where(straight[..., None], np.nan, _unit(cross))

    def frame(self, t: ArrayLike) -> FloatArray:
        """Return the Frenet frame, its vectors as rows: (*t.shape, 2, 2) in the plane, (*t.shape, 3, 3) in space."""
        vectors = [self.tangent(t), self.normal(t)]
        return np.stack([*vectors, self.binormal(t)] if self.points.shape[1] == 3 else vectors, axis=-2)


def _unit(vectors: FloatArray) -> FloatArray:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0.0, length, np.nan)
