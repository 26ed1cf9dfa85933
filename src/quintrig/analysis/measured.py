"""Integrals and extremes of a surface or of a curve, by the same two names."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np

from quintrig.analysis import extremes, integrate
from quintrig.analysis.extremes import Extremes
from quintrig.analysis.integrate import Integrals
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ArgumentError, nearest

_KEYS = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness")
_SAMPLES = 2001  # at which torsion is looked at


@dataclass(frozen=True)
class CurveIntegrals:
    """The ``length``, length¹, and ``bending_energy`` ∫ κ² ds, length⁻¹, of a curve, infinite where a cusp makes it."""

    length: float
    bending_energy: float


@dataclass(frozen=True, eq=False)
class CurveExtreme:
    """The least or greatest value along a curve, its parameter ``t`` and its point (2,) or (3,), length¹."""

    value: float
    t: float
    point: FloatArray


@dataclass(frozen=True)
class CurveExtremes:
    """Least and greatest ``key``, curvature (signed in the plane, left positive) or torsion, length⁻¹."""

    key: str
    minimum: CurveExtreme
    maximum: CurveExtreme


@overload
def integrals(subject: Surface | Patch | Model, tolerance: float = 1e-9, panels: int = 64) -> Integrals: ...
@overload
def integrals(subject: Curve | NamedCurve, tolerance: float = 1e-9, panels: int = 64) -> CurveIntegrals: ...
def integrals(
    subject: Surface | Patch | Model | Curve | NamedCurve, tolerance: float = 1e-9, panels: int = 64
) -> Integrals | CurveIntegrals:
    """Return the integrals over a surface, of a trimmed face over what its loops hold, or along a curve.

    A patch, a curve with a name and a model of one of them stand for what they hold.
    Of a surface two resolutions agree to ``tolerance``, relative to the integral, with at most ``panels`` a side; of a
    curve panels are halved until that changes nothing. Raises ValueError for a tolerance outside [1e-13, 0.1] or fewer
    than 2 panels.
    """
    if isinstance(subject := _bare(subject), Curve):
        return CurveIntegrals(subject.length(), subject.bending_energy())
    return integrate.integrals(subject, tolerance, panels)


@overload
def find_extremes(
    subject: Surface | Patch | Model, keys: Sequence[str] | str = _KEYS, samples: int = 65, certified: bool = False
) -> dict[str, Extremes]: ...
@overload
def find_extremes(
    subject: Curve | NamedCurve, keys: Sequence[str] | str = _KEYS, samples: int = 65, certified: bool = False
) -> dict[str, CurveExtremes]: ...
def find_extremes(
    subject: Surface | Patch | Model | Curve | NamedCurve,
    keys: Sequence[str] | str = _KEYS,
    samples: int = 65,
    certified: bool = False,
) -> dict[str, Extremes] | dict[str, CurveExtremes]:
    """Return minimum, maximum and mean of scalar quantities of a surface, or extreme curvature and torsion of a curve.

    The result is by key; ``keys`` may be symbols, or a single one, and ``samples`` a side of a surface are refined. The
    extremes of a curve's curvature are refined, those of its torsion, in space, are of 2001 points. ``certified`` adds
    bounds that are proved, for quantities of surfaces that have a proof. Raises ValueError
    for an unknown or vector quantity, and for fewer than 2 samples.
    """
    if isinstance(subject := _bare(subject), Curve):
        known = ("curvature",) if subject.points.shape[1] == 2 else ("curvature", "torsion")
        wanted = known if keys is _KEYS else [keys] if isinstance(keys, str) else keys
        return {key: _along(subject, key) for key in (_key(name, known) for name in wanted)}
    return extremes.find_extremes(subject, keys, samples, certified)


def _bare(subject: Any) -> Surface | Curve:
    """Return the surface or curve of a patch, named curve or model of one; ValueError for what has none."""
    part = subject
    if isinstance(subject, Model):
        part = subject.curve() if not subject.patches else subject.patch()
    found = part.surface if isinstance(part, Patch) else part.curve if isinstance(part, NamedCurve) else part
    if not isinstance(found, Surface | Curve):
        raise ArgumentError(f"expected a surface or a curve, found {type(subject).__name__}", "subject")
    return found


def _key(name: str, known: Sequence[str]) -> str:
    found = {"κ": "curvature", "kappa": "curvature", "τ": "torsion", "tau": "torsion"}.get(name, name)
    if found not in known:
        hint = f"{nearest(name, known)}; this curve has {', '.join(known)}"
        raise ArgumentError(f"unknown quantity {name[:40]!r}{hint}")
    return found


def _along(curve: Curve, key: str) -> CurveExtremes:
    if key == "torsion":
        t = np.linspace(0.0, 1.0, _SAMPLES)
        values = curve.torsion(t)
    else:
        t = np.concatenate([[0.0], curve.curvature_extremes(), [1.0]])
        values = curve.signed_curvature(t) if curve.points.shape[1] == 2 else curve.curvature(t)
    known = np.isfinite(values)
    low = int(np.argmin(np.where(known, values, np.inf)))
    high = int(np.argmax(np.where(known, values, -np.inf)))
    ends = [CurveExtreme(float(values[k]), float(t[k]), curve(float(t[k]))) for k in (low, high)]
    return CurveExtremes(key, *ends)
