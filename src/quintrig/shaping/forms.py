"""The fundamental forms of a surface as functions of its derivatives, and gradients taken back through them.

With N = S_u x S_v: E, F, G, D = |N|², l = S_uu·N, m = S_uv·N, n = S_vv·N, and from these N_K = ln - m² and
N_H = En - 2Fm + Gl, so that K = N_K / D² and H = N_H / (2 D^(3/2)). Everything is a polynomial in the derivatives
until it is divided by a power of D, and so is its gradient.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.support.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class Forms:
    """The forms at points: ``derivatives`` (5, ..., 3) are S_u, S_v, S_uu, S_uv, S_vv, length¹; each form (...)."""

    derivatives: FloatArray
    cross: FloatArray
    first: tuple[FloatArray, FloatArray, FloatArray]
    second: tuple[FloatArray, FloatArray, FloatArray]
    area2: FloatArray
    """D = |S_u x S_v|², length⁴."""

    @property
    def gauss(self) -> FloatArray:
        """N_K = ln - m², length⁶."""
        l, m, n = self.second  # noqa: E741
        return l * n - m * m

    @property
    def mean(self) -> FloatArray:
        """N_H = En - 2Fm + Gl, length⁵."""
        (e, f, g), (l, m, n) = self.first, self.second  # noqa: E741
        return e * n - 2.0 * f * m + g * l


def forms(derivatives: FloatArray) -> Forms:
    """Return the forms of derivatives (5, ..., 3)."""
    su, sv, suu, suv, svv = derivatives
    cross = np.cross(su, sv)
    return Forms(
        derivatives,
        cross,
        (_dot(su, su), _dot(su, sv), _dot(sv, sv)),
        (_dot(suu, cross), _dot(suv, cross), _dot(svv, cross)),
        _dot(cross, cross),
    )


def pulled_back(
    at: Forms, gauss: FloatArray, mean: FloatArray, area2: FloatArray, cross: FloatArray | None = None
) -> FloatArray:
    """Return the gradient (5, ..., 3) by the derivatives of what has these partial derivatives by N_K, N_H, D and N."""
    (e, f, g), (l, m, n) = at.first, at.second  # noqa: E741
    by_e, by_f, by_g = mean * n, -2.0 * mean * m, mean * l
    by_l, by_m, by_n = gauss * n + mean * g, -2.0 * gauss * m - 2.0 * mean * f, gauss * l + mean * e
    su, sv, suu, suv, svv = at.derivatives
    by_cross = 2.0 * _wide(area2) * at.cross + _wide(by_l) * suu + _wide(by_m) * suv + _wide(by_n) * svv
    if cross is not None:
        by_cross = by_cross + cross
    return np.stack(
        [
            2.0 * _wide(by_e) * su + _wide(by_f) * sv + np.cross(sv, by_cross),
            _wide(by_f) * su + 2.0 * _wide(by_g) * sv + np.cross(by_cross, su),
            _wide(by_l) * at.cross,
            _wide(by_m) * at.cross,
            _wide(by_n) * at.cross,
        ]
    )


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return (a * b).sum(axis=-1)


def _wide(a: FloatArray) -> FloatArray:
    return a[..., None]
