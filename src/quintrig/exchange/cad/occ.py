"""Access to OpenCASCADE: its modules, its array types, and silence on stdout.

OpenCASCADE prints to the process's standard output from C++, and keeps its settings in global variables. ``quiet``
turns the first away and guards the second. Version 8 renamed the array types; both names are known here.
"""

import ctypes
import os
import sys
import tempfile
import threading
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from quintrig.basis.bspline import BSpline
from quintrig.geometry.exact import ExactCurve, ExactSurface
from quintrig.support.arrays import FloatArray
from quintrig.support.extras import need

_BEFORE_8 = {
    "Array2_gp_Pnt": ("TColgp", "TColgp_Array2OfPnt"),
    "Array1_gp_Pnt": ("TColgp", "TColgp_Array1OfPnt"),
    "Array2_double": ("TColStd", "TColStd_Array2OfReal"),
    "Array1_double": ("TColStd", "TColStd_Array1OfReal"),
    "Array1_int": ("TColStd", "TColStd_Array1OfInteger"),
    "Sequence_TDF_Label": ("TDF", "TDF_LabelSequence"),
    "Sequence_TCollection_AsciiString": ("TColStd", "TColStd_SequenceOfAsciiString"),
}

_lock = threading.RLock()


def module(name: str) -> Any:
    """Return the module ``OCP.name``; QuintrigError with the pip command where OpenCASCADE is missing."""
    return need(f"OCP.{name}", "CAD exchange")


def array_type(name: str) -> Any:
    """Return an array class by its name in version 8."""
    try:
        return getattr(module("collections"), name)
    except Exception:  # before version 8 there was no such module
        older, old_name = _BEFORE_8[name]
        return getattr(module(older), old_name)


@contextmanager
def quiet() -> Generator[None]:
    """Send what C++ prints to stdout while the block runs into a file that is thrown away; one thread at a time."""
    with _lock:
        sys.stdout.flush()
        saved = os.dup(1)
        try:
            with tempfile.TemporaryFile() as sink:
                os.dup2(sink.fileno(), 1)
                try:
                    yield
                finally:
                    _flush()
                    os.dup2(saved, 1)
        finally:
            os.close(saved)


@contextmanager
def settings(values: Mapping[str, str | int]) -> Generator[None]:
    """Have OpenCASCADE's global settings at these values while the block runs; then those of before are put back.

    Others in the process that read and write files go by them too, such as other packages on OpenCASCADE.
    """
    static = module("Interface").Interface_Static
    before = {name: (static.CVal_s if isinstance(one, str) else static.IVal_s)(name) for name, one in values.items()}
    try:
        _set(static, values)
        yield
    finally:
        _set(static, before)


def _set(static: Any, values: Mapping[str, str | int]) -> None:
    for name, one in values.items():
        (static.SetCVal_s if isinstance(one, str) else static.SetIVal_s)(name, one)


def _flush() -> None:
    """Empty C's own buffer of stdout, which Python does not know of."""
    try:
        (ctypes.cdll.msvcrt if os.name == "nt" else ctypes.CDLL(None)).fflush(None)
    except (OSError, AttributeError):  # no such C library: what is left in the buffer shows later
        return


def to_occ(form: ExactSurface) -> Any:
    """Return a Geom_BSplineSurface with the same poles, weights and knots."""
    n, m = form.weights.shape
    poles, weights = array_type("Array2_gp_Pnt")(1, n, 1, m), array_type("Array2_double")(1, n, 1, m)
    point = module("gp").gp_Pnt
    for i in range(n):
        for j in range(m):
            poles.SetValue(i + 1, j + 1, point(*form.points[i, j].tolist()))
            weights.SetValue(i + 1, j + 1, float(form.weights[i, j]))
    (u_knots, u_counts), (v_knots, v_counts) = _knots(form.u), _knots(form.v)
    kind = module("Geom").Geom_BSplineSurface
    if form.rational:
        return kind(poles, weights, u_knots, v_knots, u_counts, v_counts, form.u.degree, form.v.degree)
    return kind(poles, u_knots, v_knots, u_counts, v_counts, form.u.degree, form.v.degree)


def to_occ_curve(form: ExactCurve) -> Any:
    """Return a Geom_BSplineCurve with the same poles, weights and knots; a plane curve lies in z = 0."""
    count = len(form.points)
    poles, weights = array_type("Array1_gp_Pnt")(1, count), array_type("Array1_double")(1, count)
    for k, (point, weight) in enumerate(zip(form.points.tolist(), form.weights.tolist(), strict=True), 1):
        poles.SetValue(k, module("gp").gp_Pnt(*point, *[0.0] * (3 - len(point))))
        weights.SetValue(k, weight)
    knots, counts = _knots(form.basis)
    kind = module("Geom").Geom_BSplineCurve
    if (form.weights != form.weights[0]).any():
        return kind(poles, weights, knots, counts, form.basis.degree)
    return kind(poles, knots, counts, form.basis.degree)


def _knots(basis: BSpline) -> tuple[Any, Any]:
    values, counts = np.unique(basis.knots, return_counts=True)
    knots, multiplicities = array_type("Array1_double")(1, len(values)), array_type("Array1_int")(1, len(values))
    for k, (value, count) in enumerate(zip(values.tolist(), counts.tolist(), strict=True)):
        knots.SetValue(k + 1, value)
        multiplicities.SetValue(k + 1, count)
    return knots, multiplicities


def from_occ(surface: Any) -> tuple[FloatArray, FloatArray, tuple[int, int], tuple[FloatArray, FloatArray]]:
    """Return points (n, m, 3), weights (n, m), degrees and full knot vectors of a Geom_BSplineSurface.

    A periodic direction is opened at its first knot.
    """
    if surface.IsUPeriodic():
        surface.SetUNotPeriodic()
    if surface.IsVPeriodic():
        surface.SetVNotPeriodic()
    n, m = surface.NbUPoles(), surface.NbVPoles()
    points: FloatArray = np.empty((n, m, 3))
    weights: FloatArray = np.empty((n, m))
    for i in range(n):
        for j in range(m):
            pole = surface.Pole(i + 1, j + 1)
            points[i, j] = pole.X(), pole.Y(), pole.Z()
            weights[i, j] = surface.Weight(i + 1, j + 1)
    u = [surface.UKnot(k + 1) for k in range(surface.NbUKnots()) for _ in range(surface.UMultiplicity(k + 1))]
    v = [surface.VKnot(k + 1) for k in range(surface.NbVKnots()) for _ in range(surface.VMultiplicity(k + 1))]
    return points, weights, (surface.UDegree(), surface.VDegree()), (np.array(u), np.array(v))


def down_to(kind: str, shape: Any) -> Any:
    """Return a shape as its own class, such as ``Face``, which every version spells differently."""
    caster = module("TopoDS")
    topods = getattr(caster, "TopoDS", caster)
    for name in (kind, f"{kind}_s"):
        cast = getattr(topods, name, None)
        if cast is not None:
            return cast(shape)
    return getattr(caster, f"TopoDS_{kind}")(shape)


def sequence(name: str, fill: Callable[[Any], object]) -> Sequence[Any]:
    """Return what ``fill`` puts into an OpenCASCADE sequence of the class ``name``."""
    items = array_type(name)()
    fill(items)
    return [items.Value(k + 1) for k in range(items.Length())]


def explored(shape: Any, kind: str) -> list[Any]:
    """Return the parts of a shape of one kind, such as ``FACE``, in the order of the file."""
    kinds = module("TopAbs").TopAbs_ShapeEnum
    explorer = module("TopExp").TopExp_Explorer(shape, getattr(kinds, f"TopAbs_{kind}"))
    result: list[Any] = []
    while explorer.More():
        result.append(explorer.Current())
        explorer.Next()
    return result
