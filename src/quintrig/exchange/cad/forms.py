"""What goes into a CAD file: each patch as an exact NURBS, or as a fit with its measured deviation."""

from dataclasses import dataclass

from quintrig.basis.rational import NotRationalError
from quintrig.exchange.cad.fit import FitOptions, fit
from quintrig.geometry.exact import ExactSurface, exact_surface
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model


@dataclass(frozen=True, eq=False)
class Carrier:
    """One patch: name, surface of the model, NURBS to write, how that came about, and a fit's deviation, length¹."""

    name: str
    surface: Surface
    form: ExactSurface
    deviation: float
    note: str


def written_carriers(model: Model, options: FitOptions | None = None) -> tuple[Carrier, ...]:
    """Return every patch of a model, exact where it can be and unless a fit is asked for.

    A surface without a rational form is fitted with degree 5 to 1e-6 of its size; the note says so. Raises ValueError
    naming the patch where neither can be done.
    """
    return tuple(_carrier(patch.name, patch.surface, options) for patch in model.patches)


def _carrier(name: str, surface: Surface, options: FitOptions | None) -> Carrier:
    try:
        if options is None:
            try:
                form = exact_surface(surface)
            except NotRationalError as error:
                return _fitted(name, surface, FitOptions(5), f"{error}; ")
            degrees = f"({form.degrees[0]}, {form.degrees[1]})"
            return Carrier(name, surface, form, 0.0, f"exact {'rational ' * form.rational}B-spline of degree {degrees}")
        return _fitted(name, surface, options, "")
    except ValueError as error:
        raise ValueError(f'patch "{name}": {error}') from None


def _fitted(name: str, surface: Surface, options: FitOptions, why: str) -> Carrier:
    result = fit(surface, options)
    note = (
        f"{why}fit of degree {options.degree}, C{options.smoothness}, {result.spans[0]} x {result.spans[1]} spans, "
        f"largest deviation {result.deviation:.3g} (allowed {result.tolerance:.3g})"
    )
    return Carrier(name, surface, result.form, result.deviation, note)
