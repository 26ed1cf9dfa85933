"""Surfaces in the form that the browser evaluates: for kinds and rows that its own engine cannot build.

Rows of a net and families that the browser knows go over as their coefficients, exactly. Anything else goes over as
Chebyshev series of its values and of its first two derivatives, each to rounding.
"""

import dataclasses
import itertools
from collections.abc import Callable, Iterable, Mapping
from typing import Any, cast

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.bspline import BSpline
from quintrig.basis.elementary import Circular, Hyperbolic, Powers
from quintrig.basis.formulas import Formulas
from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.basis.joined import Joined
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.envelope import Envelope
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.registry import OWN
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.studio.bases import beyond
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError

FAMILIES: dict[type[Functions], str] = {
    Trigonometric: "trigonometric",
    Bernstein: "bernstein",
    BSpline: "bspline",
    Circular: "circular",
    Hyperbolic: "hyperbolic",
    Powers: "powers",
    Joined: "joined",
    Formulas: "formulas",
}
"""Families that the browser evaluates from their own parameters, by their names there (numerics/families.ts)."""

_DEGREE = 24
_CLOSE = 1e-13  # of the largest value: what is left between nodes is rounding
_NODES = np.cos(np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1))
_BETWEEN = np.linspace(-0.99, 0.99, 2 * _DEGREE)
_PLACES = np.concatenate([_NODES, _BETWEEN])
_FIT = np.linalg.inv(chebvander(_NODES, _DEGREE))  # whose columns are orthogonal: it loses nothing
_NARROWEST = 2.0**-8  # of the domain: a piece that needs more is no smooth function


def for_page(model: Model) -> dict[str, Any]:
    """Return the keys of a model for a page, with the surfaces and bases that it does not know, where there are any."""
    built = [_entry(patch) for patch in model.patches if not drawn_there(patch)]
    library = beyond(model)
    return model.to_dict() | ({"built": built} if built else {}) | ({"library": library} if library else {})


def drawn_there(patch: Patch) -> bool:
    """Return whether the browser builds a patch by itself, from its keys."""
    return type(patch.definition) is OWN.get(patch.kind)


def rebuilt(patches: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Return the surfaces of patches, each given by its keys, as ``for_page`` does; or in words why there is none."""
    result: list[dict[str, Any]] = []
    for keys in patches:
        try:
            result.append(_entry(Model.from_dict(keys).patch()) | {"keys": dict(keys)})
        except QuintrigError as error:
            result.append({"keys": dict(keys), "error": str(error)})
    return result


def surface(built: Surface) -> dict[str, Any]:
    """Return rows, blend and what else a surface holds, as JSON takes it; ValueError where it is not smooth."""
    rows, blend = built.rows, built.blend
    result: dict[str, Any] = {"flip": bool(built.flip), "origin": built.origin.tolist(), "dimension": rows.dimension}
    result["net"] = None if built.net is None else built.net.tolist()
    if isinstance(rows, Net):
        steps = rows.increments(blend)
        along = rows.functions.standing(steps[1:]) if not built.rational else MOVING
        across = blend.standing(steps[:, 1:].swapaxes(0, 1)) if not built.rational else MOVING
        result |= {"points": rows.points.tolist(), "functions": functions(rows.functions, along)}
        return result | {"blend": functions(blend, across)}
    result["blend"] = functions(blend)
    if type(rows) is Envelope:
        return result | {
            "planes": rows.planes.tolist(),
            "bounds": rows.bounds.tolist(),
            "functions": functions(rows.functions),
        }
    return result | {"functions": _series(rows.derivatives, np.array([0.0, 1.0]))}


def functions(family: Functions, still: Still = MOVING) -> dict[str, Any]:
    """Return a family by name and parameters, or as series; ``still`` tells at which ends a surface on it stands."""
    name = FAMILIES.get(type(family))
    if name is None:
        return _series(family.derivatives, family.breaks)
    if isinstance(family, Joined):
        return {"family": name, "parts": [functions(part, still) for part in family.parts]}
    if isinstance(family, Formulas):
        return {"family": name, "functions": list(family.basis.functions)} | {
            "names": list(family.parameters),
            "values": list(family.values),
        }
    keys = {
        field.name: np.asarray(getattr(family, field.name)).tolist()  # numbers of NumPy's types are JSON's then
        for field in dataclasses.fields(cast(Any, family))
    }
    return {"family": name, **keys, "still": list(still)}


def _entry(patch: Patch) -> dict[str, Any]:
    keys = {"kind": patch.kind, **patch.definition.model_dump(exclude_defaults=True, exclude={"kind", "name"})}
    try:
        return {"keys": keys, "surface": surface(patch.surface)}
    except ValueError as error:
        return {"keys": keys, "error": f'patch "{patch.name}": {error}'}


def _series(derivatives: Callable[[FloatArray, int], FloatArray], breaks: FloatArray) -> dict[str, Any]:
    """Return Chebyshev series of derivatives 0 to 2, piece by piece, halved until they are right between the nodes."""
    waiting = list(itertools.pairwise(breaks.tolist()))[::-1]
    ends: list[float] = [0.0]
    pieces: list[Any] = []
    scale = np.zeros((3, 1, 1))
    while waiting:
        a, b = waiting.pop()
        values = derivatives(0.5 * (a + b) + 0.5 * (b - a) * _PLACES, 2).reshape(3, len(_PLACES), -1)
        if not bool(np.isfinite(values).all()):
            raise ValueError("a page cannot draw a surface whose rows or blend are infinite somewhere")
        scale = np.maximum(scale, np.abs(values).max(axis=(1, 2), keepdims=True))
        at_nodes, between = values[:, : len(_NODES)], values[:, len(_NODES) :]
        series = _FIT @ at_nodes
        if bool((np.abs(chebvander(_BETWEEN, _DEGREE) @ series - between) <= _CLOSE * scale).all()):
            ends.append(b)
            pieces.append(series.tolist())
        elif b - a <= _NARROWEST:
            raise ValueError("a page cannot draw a surface whose rows or blend are not smooth between their breaks")
        else:
            waiting += [(0.5 * (a + b), b), (a, 0.5 * (a + b))]
    return {"family": "chebyshev", "breaks": ends, "series": pieces}
