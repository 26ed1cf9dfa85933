"""Curves for other programs: each as an exact NURBS, or as a fit with its measured deviation."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from quintrig.basis.bspline import clamped
from quintrig.basis.rational import NotRationalError, TangentMap
from quintrig.exchange.cad.faces import SpaceCurve
from quintrig.exchange.cad.fit import MOST_SPANS, FitOptions, fit_sites, solved
from quintrig.geometry.curve import Curve
from quintrig.geometry.exact import ExactCurve, exact_curve
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class CurveCarrier:
    """One curve: name, curve of the model, NURBS to write, how that came about, and a fit's deviation, length¹."""

    name: str
    curve: Curve
    form: ExactCurve
    deviation: float
    note: str

    @property
    def size(self) -> float:
        """Diagonal of the box around the control points, length¹."""
        return float(np.linalg.norm(np.ptp(self.curve.points, axis=0)))

    @property
    def written(self) -> SpaceCurve:
        """The NURBS with points in space: a plane curve lies in z = 0."""
        form = self.form
        return SpaceCurve(
            0,
            self.name,
            in_space(form.points).tolist(),
            form.weights.tolist(),
            form.basis.degree,
            list(form.basis.knots),
        )


def in_space(points: FloatArray) -> FloatArray:
    """Return points (..., 2 or 3) as points in space, those of the plane with z = 0."""
    return np.pad(points, [(0, 0)] * (points.ndim - 1) + [(0, 3 - points.shape[-1])])


def curve_carriers(model: Model, options: FitOptions | None = None) -> tuple[CurveCarrier, ...]:
    """Return every curve of a model, exact where it can be and unless a fit is asked for.

    A curve without a rational form is fitted with degree 5 to 1e-6 of its size; the note says so. Raises ValueError
    naming the curve that is a single point or cannot be fitted.
    """
    return tuple(_carrier(one.name, one.curve, options) for one in model.curves)


def _carrier(name: str, curve: Curve, options: FitOptions | None) -> CurveCarrier:
    if not np.ptp(curve.points, axis=0).max() > 0.0:
        raise ValueError(f'curve "{name}": all of it is a single point; are its control points equal?')
    try:
        why = ""
        if options is None:
            try:
                form = exact_curve(curve)
                rational = "rational " * bool((form.weights != form.weights[0]).any())
                return CurveCarrier(name, curve, form, 0.0, f"exact {rational}B-spline of degree {form.basis.degree}")
            except NotRationalError as error:
                options, why = FitOptions(5), f"{error}; "
        form, deviation, spans, tolerance = fitted(curve, curve, options)
    except ValueError as error:
        raise ValueError(f'curve "{name}": {error}') from None
    note = (
        f"{why}fit of degree {options.degree}, C{options.smoothness}, {spans} spans, "
        f"largest deviation {deviation:.3g} (allowed {tolerance:.3g})"
    )
    return CurveCarrier(name, curve, form, deviation, note)


def fitted(
    curve: Curve, place: Callable[[FloatArray], FloatArray], options: FitOptions
) -> tuple[ExactCurve, float, int, float]:
    """Return a least-squares fit of points ``place``(t) that keeps the ends, its deviation, spans and tolerance.

    The deviation is measured between points of equal parameters, four times as dense as the fit needs, so it is an
    upper bound of the distance there. Raises ValueError where 256 spans are not enough.
    """
    tolerance = options.tolerance or 1e-6 * float(np.linalg.norm(np.ptp(curve.points, axis=0)))
    spans = 1
    while True:
        basis = clamped(np.linspace(0.0, 1.0, spans + 1), options.degree, options.degree - options.smoothness)
        at, fine = fit_sites(basis, 2), fit_sites(basis, 8)
        control = solved(basis, at, place(at))
        off = float(np.linalg.norm(basis.derivatives(fine, 0)[0] @ control - place(fine), axis=-1).max())
        if off <= tolerance:
            return ExactCurve(basis, control, np.ones(len(control)), TangentMap()), off, spans, tolerance
        if 2 * spans > MOST_SPANS:
            raise ValueError(
                f"the fit of degree {options.degree} deviates by {off:.3g} with {spans} spans, more than "
                f"{tolerance:.3g}; choose a larger tolerance or a higher degree"
            )
        spans *= 2
