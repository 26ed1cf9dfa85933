"""What a curve measures in all: length, extreme curvature and torsion, inflections, bending energy, and cautions."""

from dataclasses import dataclass

import numpy as np

from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray

_SAMPLES = 2001  # at which torsion is looked at


@dataclass(frozen=True)
class CurveSummary:
    """Numbers of one curve; curvature is signed in the plane, positive where it turns left. NaN where undefined.

    ``length`` is in length¹, curvature, torsion and ``bending_energy``, ∫ κ² ds, in length⁻¹; ``lowest`` and
    ``highest`` are the parameters of the extremes, ``inflections`` those of a plane curve's.
    """

    plane: bool
    closed: bool
    length: float
    curvature_min: float
    curvature_max: float
    lowest: float
    highest: float
    torsion_min: float
    torsion_max: float
    inflections: tuple[float, ...]
    bending_energy: float
    singular: int
    cautions: tuple[str, ...]


def summarise_curve(curve: Curve) -> CurveSummary:
    """Return what a curve measures; extremes of curvature are refined, those of torsion are of 2001 points."""
    plane = curve.points.shape[1] == 2
    t = np.linspace(0.0, 1.0, _SAMPLES)
    ends = np.concatenate([[0.0], curve.curvature_extremes(), [1.0]])
    bends = curve.signed_curvature(ends) if plane else curve.curvature(ends)
    bends = np.where(np.isfinite(bends), bends, _growth(curve, ends, plane))
    known = ~np.isnan(bends)
    low = int(np.argmin(np.where(known, bends, np.inf)))
    high = int(np.argmax(np.where(known, bends, -np.inf)))
    twist = np.zeros(1) if plane else curve.torsion(t)
    twist = twist[np.isfinite(twist)]
    twist = np.where(np.abs(twist) <= 1e-13 * np.abs(twist).max(initial=0.0), 0.0, twist)
    nothing = not known.any()
    return CurveSummary(
        plane,
        curve.closed,
        curve.length(),
        np.nan if nothing else float(bends[low]),
        np.nan if nothing else float(bends[high]),
        float(ends[low]),
        float(ends[high]),
        float(twist.min()) if twist.size else np.nan,
        float(twist.max()) if twist.size else np.nan,
        tuple(curve.inflections().tolist()),
        curve.bending_energy(),
        int((~np.isfinite(bends)).sum()),
        _cautions(curve, np.isfinite(bends), t[1:-1]),
    )


def _growth(curve: Curve, ends: FloatArray, plane: bool) -> FloatArray:
    """Return ±∞ for each parameter beside which curvature grows without bound, NaN for the others."""
    inward = np.where(ends < 0.5, 1.0, -1.0)
    near, nearer = (
        curve.signed_curvature(ends + step * inward) if plane else curve.curvature(ends + step * inward)
        for step in (1e-4, 1e-6)
    )
    return np.where(np.abs(nearer) > 3.0 * np.abs(near), np.copysign(np.inf, nearer), np.nan)


def _cautions(curve: Curve, known: FloatArray, inner: FloatArray) -> tuple[str, ...]:
    told = list(curve.caveats)
    if not known.all():
        told.append("The curve stands still at an end: curvature is not defined there.")
    if not curve.caveats and curve.functions.derivatives(inner, 0)[0].min() < -1e-12:
        told.append("Shape parameters outside their range: the curve may leave the convex hull of its points.")
    if not (np.linalg.norm(np.diff(curve.points, axis=0), axis=-1) > 0.0).all():
        told.append("Neighbouring control points coincide.")
    slow = np.linalg.norm(curve.derivatives(inner, 1)[1], axis=-1)
    if float(slow.min()) < 1e-3 * curve.length():
        told.append(f"Nearly a cusp at t = {inner[int(np.argmin(slow))]:.4g}: the curve all but stands still there.")
    return tuple(told)


def curve_facts(found: CurveSummary, unit: str) -> list[tuple[str, str]]:
    """Return what a curve measures in words: what, and its value with its unit."""
    per = f" 1/{unit}" if unit else ""
    facts = [
        ("kind", f"curve in {'the plane' if found.plane else 'space'}, {'closed' if found.closed else 'open'}"),
        ("length", f"{found.length:.6g}{f' {unit}' if unit else ''}"),
    ]
    name = "κ signed, left positive," if found.plane else "κ"
    for word, value, at in (
        ("lowest", found.curvature_min, found.lowest),
        ("highest", found.curvature_max, found.highest),
    ):
        if not np.isnan(value):
            facts.append(("curvature", f"{name} {word} {_told(value)}{per} at t = {at:.4g}"))
    if not found.plane and np.isfinite(found.torsion_min):
        span = f"from {_told(found.torsion_min, 4)} to {_told(found.torsion_max, 4)}{per} at {_SAMPLES} points"
        facts.append(("torsion", span))
    turns = ", ".join(f"{t:.6g}" for t in found.inflections)
    facts.append(("inflections", f"at t = {turns}" if turns else "none"))
    facts.append(("bending", f"∫κ² ds = {_told(found.bending_energy)}{per}"))
    return facts


def _told(value: float, digits: int = 6) -> str:
    return f"{value:.{digits}g}".replace("inf", "∞")
