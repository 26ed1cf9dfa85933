"""3DM files of Rhino through rhino3dm: each patch an object with its name, and the model's unit."""

import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from quintrig.exchange.cad.faces import Contents, Face, SpaceCurve
from quintrig.exchange.cad.trim import simplified, without_border
from quintrig.exchange.units import named, stated
from quintrig.geometry.closest_point import projected
from quintrig.geometry.exact import ExactSurface
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.polygon import polygon
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need

_VERSION = 7
_MOST_OBJECTS = 100_000
_OTHERS = {"Mesh": "meshes", "SubD": "SubD", "Point": "points", "PointCloud": "point clouds"}


def write_3dm(
    forms: Sequence[ExactSurface], names: Sequence[str], unit: str, remark: str, curves: Sequence[SpaceCurve] = ()
) -> bytes:
    """Return a 3DM file with one object for each patch and curve; a flipped patch has its face turned."""
    rhino = need("rhino3dm", "3DM exchange")
    file = _new_file(rhino, unit, remark)
    for form, name in zip(forms, names, strict=True):
        solid = rhino.Brep.CreateFromSurface(to_rhino(rhino, form))
        if solid is None:
            raise ValueError(f'patch "{name}": rhino3dm makes no face of it')
        if form.flip:
            solid.Flip()
        file.Objects.AddBrep(solid, _called(rhino, name))
    for curve in curves:
        file.Objects.AddCurve(_to_rhino_curve(rhino, curve), _called(rhino, curve.name))
    return _bytes(file)


def write_3dm_curves(
    curves: Sequence[tuple[int, FloatArray, FloatArray]], names: Sequence[str], unit: str, remark: str
) -> bytes:
    """Return a 3DM file of B-spline curves: degree, full knot vector and poles (n, 3) of each."""
    rhino = need("rhino3dm", "3DM exchange")
    file = _new_file(rhino, unit, remark)
    for (degree, knots, poles), name in zip(curves, names, strict=True):
        curve = rhino.NurbsCurve(3, False, degree + 1, len(poles))
        for k, point in enumerate(poles.tolist()):
            curve.Points[k] = rhino.Point4d(*point, 1.0)
        for k, value in enumerate(knots[1:-1].tolist()):  # Rhino leaves out the first and the last
            curve.Knots[k] = value
        file.Objects.AddCurve(curve, _called(rhino, name))
    return _bytes(file)


def _new_file(rhino: Any, unit: str, remark: str) -> Any:
    file = rhino.File3dm()
    file.ApplicationName = "quintrig"
    file.ApplicationDetails = remark
    file.Settings.ModelUnitSystem = getattr(rhino.UnitSystem, stated(unit).rhino)
    return file


def _called(rhino: Any, name: str) -> Any:
    attributes = rhino.ObjectAttributes()
    attributes.Name = name
    return attributes


def _bytes(file: Any) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.3dm"
        if not file.Write(str(path), _VERSION):
            raise ValueError("rhino3dm did not finish writing")
        return path.read_bytes()


def read_3dm(path: Path) -> Contents:
    """Return the surfaces and curves of a 3DM file; QuintrigError for a file that is none."""
    rhino = need("rhino3dm", "3DM exchange")
    file = rhino.File3dm.Read(str(path))
    if file is None:
        raise QuintrigError(f"{path}: expected a 3DM file, found something else or a damaged one; save it again")
    system = str(file.Settings.ModelUnitSystem).rpartition(".")[2]
    unit = named("rhino", system)
    notes = () if unit else (f"the file's unit is {system}, which models do not have; lengths are as in the file",)
    faces: list[Face] = []
    curves: list[SpaceCurve] = []
    others: Counter[str] = Counter()
    try:
        placed = list(islice(_placed(rhino, file), _MOST_OBJECTS + 1))
    except RecursionError:
        raise QuintrigError(f"{path}: its blocks hold each other without end; explode them in Rhino") from None
    if len(placed) > _MOST_OBJECTS:
        raise QuintrigError(f"{path}: expected at most {_MOST_OBJECTS:,} objects, blocks placed; split the file")
    for shape, name in placed:
        if isinstance(shape, rhino.Extrusion):
            shape = shape.ToBrep(False)  # noqa: PLW2901
        if isinstance(shape, rhino.Brep):
            for index in range(len(shape.Faces)):
                label = name if len(shape.Faces) == 1 else f"{name or 'face'} {index + 1}"
                faces.append(_face(len(faces) + 1, label, shape, shape.Faces[index]))
        elif isinstance(shape, rhino.Surface):
            faces.append(_surface(len(faces) + 1, name, shape, False, ()))
        elif isinstance(shape, rhino.Curve):
            curve = shape.ToNurbsCurve()
            if curve is not None:
                curves.append(_curve(len(curves) + 1, name, curve))
        else:
            others[_OTHERS.get(type(shape).__name__, type(shape).__name__)] += 1
    if others and not faces and not curves:
        held = " and ".join(f"{count} {what}" for what, count in others.items())
        raise QuintrigError(f"{path}: expected surfaces or curves, found only {held}; convert them to NURBS in Rhino")
    left = tuple(f"left out: {count} {what}, which hold no NURBS surface" for what, count in others.items())
    title = file.Objects[0].Attributes.Name if len(file.Objects) == 1 else ""
    return Contents(title or path.stem, unit, tuple(faces), tuple(curves), (*notes, *left))


def _placed(rhino: Any, file: Any) -> Iterator[tuple[Any, str]]:
    """Yield geometry and name of every object as it stands in space: those of blocks wherever the block is placed."""
    inside = {str(identity) for block in file.InstanceDefinitions for identity in block.GetObjectIds()}
    for item in file.Objects:
        if str(item.Attributes.Id) not in inside and item.Attributes.Mode != rhino.ObjectMode.InstanceDefinitionObject:
            yield from _expanded(rhino, file, item, ())


def _expanded(rhino: Any, file: Any, item: Any, steps: tuple[Any, ...]) -> Iterator[tuple[Any, str]]:
    """Yield an object moved by ``steps``, the innermost last; in a block's place its objects, blocks among them."""
    shape, name = item.Geometry, item.Attributes.Name
    if not isinstance(shape, rhino.InstanceReference):
        if steps:
            shape = shape.Duplicate()
            for step in reversed(steps):
                shape.Transform(step)
        yield shape, name
        return
    block = file.InstanceDefinitions.FindId(shape.ParentIdefId)
    if block is None:
        return
    for identity in block.GetObjectIds():
        part = file.Objects.FindId(str(identity))
        if part is not None:
            yield from _expanded(rhino, file, part, (*steps, shape.Xform))


def to_rhino(rhino: Any, form: ExactSurface) -> Any:
    """Return a rhino3dm.NurbsSurface with the same points, weights and knots; which way it faces is lost."""
    n, m = form.weights.shape
    result = rhino.NurbsSurface.Create(3, form.rational, form.u.degree + 1, form.v.degree + 1, n, m)
    homogeneous = np.concatenate([form.points * form.weights[..., None], form.weights[..., None]], axis=-1)
    for i in range(n):
        for j in range(m):
            result.Points[i, j] = rhino.Point4d(*homogeneous[i, j].tolist())
    for knots, basis in ((result.KnotsU, form.u), (result.KnotsV, form.v)):
        for k, value in enumerate(basis.knots[1:-1]):  # Rhino leaves out the first and the last
            knots[k] = value
    return result


def _to_rhino_curve(rhino: Any, curve: SpaceCurve) -> Any:
    result = rhino.NurbsCurve(3, len(set(curve.weights)) > 1, curve.degree + 1, len(curve.points))
    for k, ((x, y, z), weight) in enumerate(zip(curve.points, curve.weights, strict=True)):
        result.Points[k] = rhino.Point4d(x * weight, y * weight, z * weight, weight)
    for k, value in enumerate(curve.knots[1:-1]):  # Rhino leaves out the first and the last
        result.Knots[k] = value
    return result


def _face(number: int, name: str, solid: Any, face: Any) -> Face:
    carrier = face.UnderlyingSurface()
    flip = bool(face.OrientationIsReversed)
    if solid.IsSurface:  # one face, all of its surface
        return _surface(number, name, carrier, flip, ())
    loops = [[(trim.EdgeIndex, trim.IsReversed) for trim in _items(loop.Trims)] for loop in _items(face.Loops)]
    indices = [index for loop in loops for index, _ in loop]
    if -1 in indices or len(set(indices)) < len(indices):
        # At a pole or along a seam a point has several parameters, and the edge does not tell which.
        return replace(_surface(number, name, carrier, flip, ()), note="trim along a seam or pole is not read")
    edges = [[(solid.Edges[index], back) for index, back in loop] for loop in loops]
    return _surface(number, name, carrier, flip, edges)


def _surface(number: int, name: str, carrier: Any, flip: bool, edges: Sequence[Sequence[tuple[Any, bool]]]) -> Face:
    name = name or f"face {number}"
    spline = carrier.ToNurbsSurface()
    if spline is None:
        return Face(number, name, type(carrier).__name__, {}, "rhino3dm gives no NURBS form of it")
    points, weights, degrees, knots = _from_rhino(spline)
    keys: dict[str, Any] = {
        "degrees": list(degrees),
        "knots": [list(knots[0]), list(knots[1])],
        "points": points.tolist(),
    }
    if (weights != weights[0, 0]).any():
        keys["weights"] = weights.tolist()
    if flip:
        keys["flip"] = True
    try:
        surface = nurbs(points, weights, degrees, knots)
    except ValueError as error:
        return Face(number, name, "NURBS", {}, str(error))
    trim = without_border([simplified(_loop(surface, loop)) for loop in edges])
    if trim:
        keys["trim"] = [loop.tolist() for loop in trim]
    return Face(number, name, "NURBS", keys)


def _from_rhino(spline: Any) -> tuple[FloatArray, FloatArray, tuple[int, int], tuple[tuple[float, ...], ...]]:
    n, m = spline.Points.CountU, spline.Points.CountV
    homogeneous: FloatArray = np.array(
        [[(p.X, p.Y, p.Z, p.W) for p in (spline.Points.GetControlPoint(i, j) for j in range(m))] for i in range(n)]
    )
    weights = homogeneous[..., 3] if spline.IsRational else np.ones((n, m))
    points = homogeneous[..., :3] / weights[..., None]
    degrees = spline.OrderU - 1, spline.OrderV - 1
    return points, weights, degrees, (_full(spline.KnotsU.ToList()), _full(spline.KnotsV.ToList()))


def _loop(surface: Surface, edges: Sequence[tuple[Any, bool]]) -> FloatArray:
    """Return one loop in (u, v): rhino3dm gives no curves in parameters, so points of the edges are projected."""
    loop: list[FloatArray] = []
    for edge, back in edges:

        def place(values: FloatArray, edge: Any = edge) -> FloatArray:
            at = [edge.PointAt(t) for t in values.tolist()]
            return projected(surface, np.array([(p.X, p.Y, p.Z) for p in at]))

        points = polygon(place, np.array([edge.Domain.T0, edge.Domain.T1]))
        loop.append((points[::-1] if back else points)[:-1])
    return np.concatenate(loop) if loop else np.empty((0, 2))


def _curve(number: int, name: str, curve: Any) -> SpaceCurve:
    knots = [curve.Knots[k] for k in range(len(curve.Knots))]
    count = len(curve.Points)
    control = [curve.Points[k] for k in range(count)]
    weights = [p.W if curve.IsRational else 1.0 for p in control]
    points = [[p.X / w, p.Y / w, p.Z / w] for p, w in zip(control, weights, strict=True)]
    return SpaceCurve(number, name or f"curve {number}", points, weights, curve.Degree, list(_full(knots)))


def _full(knots: Sequence[float]) -> tuple[float, ...]:
    """Return the knots with the first and the last, which Rhino leaves out."""
    return (knots[0], *knots, knots[-1])


def _items(table: Any) -> list[Any]:
    return [table[k] for k in range(len(table))]
