"""What is integrated along lines: fields of directions without a sense, and geodesics."""

from abc import ABC, abstractmethod
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Forms, Local
from quintrig.support.arrays import BoolArray, FloatArray

Modes = NDArray[np.intp]

_UMBILIC = 1e-6  # of C and 1 / size: a spread of κ1 and κ2 below which directions have no sense any more


class Flow(Protocol):
    """A field to follow: states (k, d) begin with u and v; ``aim`` (k, 2) are du and dv of the sense to take."""

    @property
    def modes(self) -> tuple[int, ...]:
        """The families there are."""
        ...

    def begin(self, surface: Surface, uv: FloatArray, aim: FloatArray) -> FloatArray:
        """Return states at parameters (k, 2) that head along ``aim``."""
        ...

    def slope(self, surface: Surface, state: FloatArray, aim: FloatArray, mode: Modes) -> FloatArray:
        """Return d(state)/ds by arc length in the sense nearest to ``aim``; its first two are du and dv."""
        ...

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where the field ends (k,)."""
        ...


def forms(surface: Surface, state: FloatArray) -> Forms:
    """Return the forms at states (k, d), those beyond the edges as at the edges."""
    return Forms.of(surface, *_inside(state).T)


def _inside(state: FloatArray) -> FloatArray:
    """Return parameters (k, 2) in the domain for any state; what a try of a step makes of NaN is NaN by its slope."""
    return np.clip(np.nan_to_num(state[:, :2], nan=0.5), 0.0, 1.0)


class _Directions(ABC):
    """A field of directions at an angle from e1: ``angles`` says which."""

    @abstractmethod
    def angles(self, local: Forms, mode: Modes) -> FloatArray:
        """Return the angle of each family from e1, radians."""

    def begin(self, surface: Surface, uv: FloatArray, aim: FloatArray) -> FloatArray:
        """Return the parameters themselves."""
        return uv.copy()

    def slope(self, surface: Surface, state: FloatArray, aim: FloatArray, mode: Modes) -> FloatArray:
        """Return (du, dv)/ds."""
        with np.errstate(divide="ignore", invalid="ignore"):
            local = forms(surface, state)
            step = local.along(self.angles(local, mode))
            e, f, g = local.first
            (du, dv), (x, y) = step.T, aim.T
            cosine = e * du * x + f * (du * y + dv * x) + g * dv * y
            found = np.where(cosine < 0.0, -1.0, 1.0)[:, None] * step
        known = np.asarray(np.isfinite(state).all(axis=1))
        return np.where(known[:, None], found, np.nan)


class Principal(_Directions):
    """Directions of κ1 (mode 1) and κ2 (mode 2)."""

    modes = (1, 2)

    def angles(self, local: Forms, mode: Modes) -> FloatArray:
        """Return the angles from e1."""
        return local.angle + np.where(mode == 2, 0.5 * np.pi, 0.0)

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where κ1 and κ2 are the same."""
        return _umbilic(forms(surface, state), surface)


class Asymptotic(_Directions):
    """Directions in which the surface does not bend, to the one side (mode 1) and to the other (2) of that of κ1."""

    modes = (1, 2)

    def angles(self, local: Forms, mode: Modes) -> FloatArray:
        """Return the angles from e1; NaN where K > 0."""
        half = np.arctan2(np.sqrt(local.curvature(1)), np.sqrt(-local.curvature(2)))
        return local.angle + np.where(mode == 2, -half, half)

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return where K is not below 0, or the point is planar."""
        local = forms(surface, state)
        with np.errstate(invalid="ignore"):
            return _umbilic(local, surface) | ~(local.gaussian < 0.0)


class Geodesic:
    """Geodesics: u, v and their speeds by arc length (do Carmo 1976, §4.4)."""

    modes = (0,)

    def begin(self, surface: Surface, uv: FloatArray, aim: FloatArray) -> FloatArray:
        """Return states of unit speed along ``aim``."""
        local = Local.at(surface, *uv.T, order=1)
        size = np.linalg.norm(local.lifted(aim), axis=1)
        return np.concatenate([uv, aim / size[:, None]], axis=1)

    def slope(self, surface: Surface, state: FloatArray, aim: FloatArray, mode: Modes) -> FloatArray:
        """Return (u', v', u'', v'')."""
        with np.errstate(divide="ignore", invalid="ignore"):
            gamma = Local.at(surface, *_inside(state).T).christoffel
        p, q = state[:, 2:3], state[:, 3:4]
        bend = gamma[..., 0] * p * p + 2.0 * gamma[..., 1] * p * q + gamma[..., 2] * q * q
        return np.concatenate([state[:, 2:], -bend], axis=1)

    def ended(self, surface: Surface, state: FloatArray) -> BoolArray:
        """Return that a geodesic ends nowhere inside."""
        return np.zeros(len(state), dtype=np.bool_)


def _umbilic(local: Forms, surface: Surface) -> BoolArray:
    with np.errstate(invalid="ignore"):
        scale = np.abs(local.mean) + local.spread + 1.0 / surface.size
        return ~(local.spread > _UMBILIC * scale)
