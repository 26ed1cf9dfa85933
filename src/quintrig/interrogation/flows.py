"""What is integrated along lines: fields of directions without a sense, and geodesics."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local, dot
from quintrig.support.arrays import BoolArray, FloatArray

Modes = NDArray[np.intp]

_UMBILIC = 1e-6  # of C and 1 / size: a spread of κ1 and κ2 below which directions have no sense any more


class Flow(Protocol):
    """A field to follow: states (k, d) begin with u and v, and ``modes`` (k,) say which of its families."""

    modes: tuple[int, ...]

    def begin(self, surface: Surface, uv: FloatArray, towards: FloatArray) -> FloatArray:
        """Return states at parameters (k, 2) that head ``towards`` (k, 3)."""
        ...

    def slope(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return d(state)/ds by arc length in the sense nearest to ``towards``."""
        ...

    def direction(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return the unit vector in space (k, 3)."""
        ...

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where the field ends (k,)."""
        ...


class _Directions:
    """A field of directions at an angle from e1: ``angles`` says which."""

    def angles(self, local: Local, mode: Modes) -> FloatArray:
        """Return the angle of each family from e1, radians."""
        raise NotImplementedError

    def begin(self, surface: Surface, uv: FloatArray, towards: FloatArray) -> FloatArray:
        """Return the parameters themselves."""
        return uv.copy()

    def slope(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return (du, dv)/ds."""
        return self._both(surface, state, towards, mode)[0]

    def direction(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return the unit vector in space."""
        return self._both(surface, state, towards, mode)[1]

    def _both(
        self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes
    ) -> tuple[FloatArray, FloatArray]:
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(surface, *np.clip(state[:, :2], 0.0, 1.0).T)
            step = local.along(self.angles(local, mode))
            vector = local.lifted(step)
            sense = np.where(dot(vector, towards) < 0.0, -1.0, 1.0)[:, None]
        return sense * step, sense * vector


class Principal(_Directions):
    """Directions of κ1 (mode 1) and κ2 (mode 2)."""

    modes = (1, 2)

    def angles(self, local: Local, mode: Modes) -> FloatArray:
        """Return the angles from e1."""
        return local.angle + np.where(mode == 2, 0.5 * np.pi, 0.0)

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where κ1 and κ2 are the same."""
        return _umbilic(Local.at(surface, *np.clip(state[:, :2], 0.0, 1.0).T), surface)


class Asymptotic(_Directions):
    """Directions in which the surface does not bend, to the one side (mode 1) and to the other (2) of that of κ1."""

    modes = (1, 2)

    def angles(self, local: Local, mode: Modes) -> FloatArray:
        """Return the angles from e1; NaN where K > 0."""
        half = np.arctan2(np.sqrt(local.curvature(1)), np.sqrt(-local.curvature(2)))
        return local.angle + np.where(mode == 2, -half, half)

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where K is not below 0, or the point is planar."""
        local = Local.at(surface, *np.clip(state[:, :2], 0.0, 1.0).T)
        return _umbilic(local, surface) | ~(local.gaussian < 0.0)


class Geodesic:
    """Geodesics: u, v and their speeds by arc length (do Carmo 1976, §4.4)."""

    modes = (0,)

    def begin(self, surface: Surface, uv: FloatArray, towards: FloatArray) -> FloatArray:
        """Return states of unit speed along the tangent part of ``towards``."""
        local = Local.at(surface, *uv.T, order=1)
        step = local.lowered(towards)
        size = np.linalg.norm(local.lifted(step), axis=1)
        return np.concatenate([uv, step / size[:, None]], axis=1)

    def slope(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return (u', v', u'', v'')."""
        with np.errstate(divide="ignore", invalid="ignore"):
            gamma = Local.at(surface, *np.clip(state[:, :2], 0.0, 1.0).T).christoffel
        p, q = state[:, 2:3], state[:, 3:4]
        bend = gamma[..., 0] * p * p + 2.0 * gamma[..., 1] * p * q + gamma[..., 2] * q * q
        return np.concatenate([state[:, 2:], -bend], axis=1)

    def direction(self, surface: Surface, state: FloatArray, towards: FloatArray, mode: Modes) -> FloatArray:
        """Return the velocity in space."""
        return Local.at(surface, *np.clip(state[:, :2], 0.0, 1.0).T, order=1).lifted(state[:, 2:])

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return that a geodesic ends nowhere inside."""
        return np.zeros(len(state), dtype=np.bool_)


def _umbilic(local: Local, surface: Surface) -> BoolArray:
    with np.errstate(invalid="ignore"):
        scale = np.abs(local.mean) + local.spread + 1.0 / surface.size
        return ~(local.spread > _UMBILIC * scale)
