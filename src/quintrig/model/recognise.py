"""A bare surface as the keys of a model, so that a notebook can show and change one that no file holds."""

from typing import Any

from quintrig.basis.bspline import BSpline
from quintrig.basis.functions import Functions, Joined
from quintrig.basis.trigonometric import Bernstein, Trigonometric
from quintrig.geometry.envelope import Envelope
from quintrig.geometry.surface import Net, Surface
from quintrig.model.model import Model, Patch
from quintrig.model.recognise_closed import closed_form
from quintrig.support.arrays import FloatArray

Subject = Model | Patch | Surface


def as_model(subject: Subject, unit: str = "") -> Model:
    """Return a model of what is to be shown.

    A surface becomes the tensor-product, ruled, developable or NURBS patch on what it was built from, or the closed
    form that it is. Raises ValueError for one made of other rows by hand: show a model.
    """
    if isinstance(subject, Model):
        return subject
    if isinstance(subject, Patch):
        header = {"unit": unit} if unit else {}
        keys = subject.definition.model_dump(exclude_defaults=True, exclude={"kind", "name"})
        return Model.from_dict({**header, "name": subject.name, "kind": subject.kind, **keys})
    keys = _keys(subject)
    if keys is None:
        raise ValueError(
            "this surface is of rows that no kind of model has, so the studio cannot show it; make a Model near it "
            "(quintrig.Model.from_dict) and show that"
        )
    return Model.from_dict({"name": "surface", **({"unit": unit} if unit else {}), "flip": subject.flip, **keys})


def _keys(surface: Surface) -> dict[str, Any] | None:
    rows = surface.rows
    if isinstance(rows, Envelope):
        planes = {"planes": rows.planes.tolist(), "bounds": rows.bounds.tolist()}
        return _bezier({"kind": "developable", **planes}, _shape(rows.functions) or (), bernstein=False)
    if not isinstance(rows, Net):
        return None
    points = rows.points
    if isinstance(rows.functions, Joined) and surface.blend == Bernstein(1) and len(rows.functions.parts) == 2:
        return _ruled(points, rows.functions.parts, surface.origin)
    pair = (rows.functions, surface.blend)
    shapes = [_shape(one) for one in pair]
    if points.shape[2] == 3 and all(shape is not None for shape in shapes):
        first, second = shapes[0] or (), shapes[1] or ()
        bernstein = not isinstance(pair[0], Trigonometric)
        if bernstein == (not isinstance(pair[1], Trigonometric)):
            return _bezier(
                {"kind": "tensor", "points": (points + surface.origin).tolist()}, (*first, *second), bernstein
            )
    if isinstance(pair[0], BSpline) and isinstance(pair[1], BSpline):
        return _nurbs(points, pair[0], pair[1], surface.origin)
    return closed_form(surface)


def _ruled(points: FloatArray, parts: tuple[Functions, ...], origin: FloatArray) -> dict[str, Any] | None:
    shapes = [_shape(one) for one in parts]
    if any(shape is None for shape in shapes):
        return None
    n = parts[0].size
    ends = {"first": points[:n, 0] + origin, "second": points[n:, 1] + origin}
    keys = {"kind": "ruled", **{name: end.tolist() for name, end in ends.items()}}
    return _bezier(keys, (*(shapes[0] or ()), *(shapes[1] or ())), not isinstance(parts[0], Trigonometric))


def _bezier(keys: dict[str, Any], shape: tuple[float, ...], bernstein: bool) -> dict[str, Any]:
    if bernstein:
        return keys | {"basis": "bernstein"}
    outside = any(not -4.0 <= x <= 1.0 for x in shape)
    return keys | {"shape": list(shape)} | ({"unchecked_shape": True} if outside else {})


def _shape(functions: Functions) -> tuple[float, ...] | None:
    """Return the shape parameters of a basis of the models; none, for another family of functions, is None."""
    if isinstance(functions, Trigonometric):
        return (functions.alpha, functions.zeta)
    return () if isinstance(functions, Bernstein) else None


def _nurbs(points: FloatArray, u: BSpline, v: BSpline, origin: FloatArray) -> dict[str, Any]:
    keys: dict[str, Any] = {"kind": "nurbs", "degrees": [u.degree, v.degree], "knots": [list(u.knots), list(v.knots)]}
    if points.shape[2] == 3:
        return keys | {"points": (points + origin).tolist()}
    weights = points[..., 3]
    return keys | {"points": (points[..., :3] / weights[..., None] + origin).tolist(), "weights": weights.tolist()}
