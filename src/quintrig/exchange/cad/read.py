"""STEP, IGES and BREP files through OpenCASCADE: faces as NURBS with names, units and trim loops, and free curves."""

import math
from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

import numpy as np

from quintrig.exchange.cad.faces import Contents, Face, SpaceCurve
from quintrig.exchange.cad.occ import array_type, down_to, explored, from_occ, module, quiet, sequence, settings
from quintrig.exchange.cad.parameters import Box, Places, places
from quintrig.exchange.cad.trim import simplified, without_border
from quintrig.exchange.units import ASSUMED, UNITS, named
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.polygon import polygon
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError

_MOST_FACES = 100_000
_ROUNDING = 1e-9  # of a carrier's period or extent: nearer to its bounds, a face ends there
_MOST_NAMED = 2_000  # matching names to faces takes the square of their number
_EXACT_KINDS = {
    "BSplineSurface": "B-spline",
    "BezierSurface": "Bézier",
    "Plane": "plane",
    "CylindricalSurface": "cylinder",
    "ConicalSurface": "cone",
    "SphericalSurface": "sphere",
    "ToroidalSurface": "torus",
    "SurfaceOfRevolution": "surface of revolution",
    "SurfaceOfLinearExtrusion": "extrusion",
}


def read_cad(
    path: Path, skip: Collection[int] = (), plain: bool = False, begin: Callable[[int], None] = lambda _: None
) -> Contents:
    """Return the faces and free curves of a STEP, IGES or BREP file.

    ``begin`` is told the number of each face before it is read; faces of the numbers ``skip``, on which an earlier try
    broke down, are not. ``plain`` leaves out names and assembly, whose reader breaks down on some STEP files.
    QuintrigError for a file that is none. A hostile file may crash OpenCASCADE: ``isolated`` reads in a process of its
    own.
    """
    step = _plain_step if plain else _step
    readers = {".step": step, ".stp": step, ".iges": _iges, ".igs": _iges, ".brep": _brep}
    with quiet():
        shapes, unit, notes = readers[path.suffix.lower()](path)
        faces: list[Face] = []
        curves: list[SpaceCurve] = []
        for name, shape, label_of in shapes:
            for shape_face in explored(shape, "FACE"):
                if len(faces) == _MOST_FACES:
                    raise QuintrigError(f"{path}: expected at most {_MOST_FACES} faces; split the file")
                number = len(faces) + 1
                begin(number)
                if number in skip:
                    faces.append(Face(number, f"face {number}", "unknown", {}, "OpenCASCADE breaks down on it"))
                else:
                    faces.append(_face(number, label_of(shape_face), down_to("Face", shape_face)))
            for shape_edge in _free_edges(shape):
                curve = _curve(len(curves) + 1, label_of(shape_edge) or name, down_to("Edge", shape_edge))
                curves += [curve] if curve else []
    # OpenCASCADE calls what nobody named after itself.
    named_shapes = [name for name, _, _ in shapes if name and not name.startswith("Open CASCADE")]
    title = named_shapes[0] if len(named_shapes) == 1 else path.stem
    shells = sum(len(explored(shape, "SHELL")) for _, shape, _ in shapes)
    return Contents(title, unit, tuple(faces), tuple(curves), tuple(notes), shells)


def faces_of(shape: Any, place: str) -> tuple[Face, ...]:
    """Return the faces of a shape of OpenCASCADE in memory; QuintrigError, naming ``place``, for what is none."""
    whole = isinstance(shape, module("TopoDS").TopoDS_Shape) and not shape.IsNull()
    found = explored(shape, "FACE") if whole else []
    if not found:
        kind = "none" if whole else type(shape).__name__
        raise QuintrigError(f"{place}: expected a shape with faces, found {kind}; hand over a face or solid")
    if len(found) > _MOST_FACES:
        raise QuintrigError(f"{place}: expected at most {_MOST_FACES} faces, found {len(found):,}; hand over parts")
    return tuple(_face(k, "", down_to("Face", one)) for k, one in enumerate(found, 1))


def _read_file(reader: Any, path: Path, kind: str) -> None:
    if int(reader.ReadFile(str(path)).value) != 1:  # IFSelect_RetDone
        raise QuintrigError(f"{path}: expected {kind} file, found something else or a damaged one; export it again")


def _step(path: Path) -> tuple[list[Any], str, list[str]]:
    module("STEPCAFControl").STEPCAFControl_Controller.Init_s()
    with settings({"read.stepcaf.subshapes.name": 1}):
        return _named_step(path)


def _named_step(path: Path) -> tuple[list[Any], str, list[str]]:
    reader = module("STEPCAFControl").STEPCAFControl_Reader()
    reader.SetNameMode(True)
    _read_file(reader, path, "a STEP")
    inner = reader.ChangeReader()
    names = "Sequence_TCollection_AsciiString"
    angles, solid_angles = array_type(names)(), array_type(names)()
    found = [item.ToCString() for item in sequence(names, lambda s: inner.FileUnits(s, angles, solid_angles))]
    unit = named("step", found[0]) if found else ""
    notes = _unit_notes(unit, found)
    unit = unit or ASSUMED
    inner.SetSystemLengthUnit(UNITS[unit].millimetres)
    return _transferred(reader, unit, path), unit, notes


def _plain_step(path: Path) -> tuple[list[Any], str, list[str]]:
    """Return the shapes alone, in millimetres, by the reader that looks at no names, colours or assembly."""
    reader = module("STEPControl").STEPControl_Reader()
    _read_file(reader, path, "a STEP")
    reader.TransferRoots()
    shape = reader.OneShape()
    if shape.IsNull():
        raise QuintrigError(f"{path}: OpenCASCADE finds no shape in it; export the faces as NURBS")
    return [("", shape, _nameless)], ASSUMED, ["names could not be read: OpenCASCADE breaks down on them"]


def _iges(path: Path) -> tuple[list[Any], str, list[str]]:
    module("IGESControl").IGESControl_Controller.Init_s()
    reader = module("IGESCAFControl").IGESCAFControl_Reader()
    reader.SetNameMode(True)
    _read_file(reader, path, "an IGES")
    section = reader.Model().GlobalSection()
    millimetres = float(section.UnitValue())
    unit = next((key for key, one in UNITS.items() if abs(one.millimetres - millimetres) < 1e-9 * millimetres), "")
    notes = _unit_notes(unit, [f"unit of {millimetres:g} mm"])
    unit = unit or ASSUMED
    with settings({"xstep.cascade.unit": UNITS[unit].opencascade}):
        shapes = _transferred(reader, unit, path)
    return _with_iges_names(shapes, reader.Model()), unit, notes


def _with_iges_names(shapes: list[Any], model: Any) -> list[Any]:
    """Return the shapes with the names of the file's face entities, where there are as many as faces.

    OpenCASCADE hands on the names of whole shapes only.
    """
    faces = [face for _, shape, _ in shapes for face in explored(shape, "FACE")]
    entities = [model.Entity(k + 1) for k in range(model.NbEntities())]
    if len(faces) > _MOST_NAMED:
        return shapes
    for kind in (510, 144, 128):  # face of a shell, trimmed surface, B-spline surface
        named_ones = [item for item in entities if item.TypeNumber() == kind]
        if len(named_ones) == len(faces):
            names = [item.NameValue().ToCString().strip() if item.HasName() else "" for item in named_ones]

            def part_name(part: Any, names: list[str] = names) -> str:
                return next((name for face, name in zip(faces, names, strict=True) if face.IsSame(part)), "")

            return [(name, shape, part_name) for name, shape, _ in shapes]
    return shapes


def _brep(path: Path) -> tuple[list[Any], str, list[str]]:
    shape = module("TopoDS").TopoDS_Shape()
    read = module("BRepTools").BRepTools.Read_s(shape, str(path), module("BRep").BRep_Builder())
    if not read or shape.IsNull():
        raise QuintrigError(f"{path}: expected a BREP file, found something else or a damaged one; export it again")
    return [("", shape, _nameless)], "", []


def _nameless(_: Any) -> str:
    return ""


def _unit_notes(unit: str, found: list[str]) -> list[str]:
    if unit:
        return []
    what = f"unit {found[0]!r}" if found else "no unit"
    return [f"the file has {what}; lengths are given in {ASSUMED}"]


def _transferred(reader: Any, unit: str, path: Path) -> list[Any]:
    """Return (name, shape, function from a part of it to its name) of each free shape."""
    text = module("TCollection").TCollection_ExtendedString
    kind = text("BinXCAF")
    document = module("TDocStd").TDocStd_Document(kind)
    module("XCAFApp").XCAFApp_Application.GetApplication_s().NewDocument(kind, document)
    tools = module("XCAFDoc").XCAFDoc_DocumentTool
    tools.SetLengthUnit_s(document, UNITS[unit].millimetres * 1e-3)
    if not reader.Transfer(document):
        raise QuintrigError(f"{path}: OpenCASCADE finds no shape in it; export the faces as NURBS")
    shapes = tools.ShapeTool_s(document.Main())

    def entry(label: Any) -> tuple[str, Any, Callable[[Any], str]]:
        def part_name(part: Any, _keep: Any = document) -> str:  # labels live as long as their document
            return _part_name(shapes, label, part)

        return _name(label), shapes.GetShape_s(label), part_name

    return [entry(label) for label in sequence("Sequence_TDF_Label", shapes.GetFreeShapes)]


def _name(label: Any) -> str:
    names = module("TDataStd").TDataStd_Name
    found = names()
    # OpenCASCADE's binding crashes where it looks for an attribute that the label has not.
    if not label.IsAttribute(names.GetID_s()) or not label.FindAttribute(names.GetID_s(), found):
        return ""
    return str(found.Get().ToExtString())


def _part_name(shapes: Any, label: Any, part: Any) -> str:
    if part.IsSame(shapes.GetShape_s(label)):
        return _name(label)
    found = module("TDF").TDF_Label()
    return _name(found) if shapes.FindSubShape(label, part, found) and not found.IsNull() else ""


def _face(number: int, name: str, face: Any) -> Face:
    tool = module("BRep").BRep_Tool
    carrier = tool.Surface_s(face)
    name = name or f"face {number}"
    if carrier is None:
        return Face(number, name, "mesh", {}, "it has a triangulation but no surface")
    kind = carrier.DynamicType().Name().removeprefix("Geom_")
    if kind == "RectangularTrimmedSurface":
        carrier = carrier.BasisSurface()
        kind = carrier.DynamicType().Name().removeprefix("Geom_")
    if kind not in _EXACT_KINDS:
        return Face(number, name, kind, {}, "this kind of surface has no exact NURBS form")
    try:
        spline, box = _as_spline(face, carrier, kind)
        points, weights, degrees, knots = from_occ(spline)
        keys: dict[str, Any] = {
            "degrees": list(degrees),
            "knots": [knots[0].tolist(), knots[1].tolist()],
            "points": points.tolist(),
        }
        if (weights != weights[0, 0]).any():
            keys["weights"] = weights.tolist()
        carried = nurbs(points, weights, degrees, knots)
        loops = _loops(face, places(carrier, kind, carried, box))
        trim = without_border([simplified(loop) for loop in loops or ()])
        nurbs(points, weights, degrees, knots, trim=trim)  # a damaged file may hold anything
    except ValueError as error:
        return Face(number, name, _EXACT_KINDS[kind], {}, _short(error))
    except Exception as error:  # whatever OpenCASCADE throws: this face cannot be read, others may
        return Face(number, name, _EXACT_KINDS[kind], {}, f"OpenCASCADE fails on it ({_short(error)})")
    if trim:
        keys["trim"] = [loop.tolist() for loop in trim]
    reversed_ = face.Orientation() == module("TopAbs").TopAbs_Orientation.TopAbs_REVERSED
    if reversed_:
        keys["flip"] = True
    note = "" if loops is not None else "its trim cannot be read: an edge has no curve in (u, v)"
    return Face(number, name, _EXACT_KINDS[kind], keys, note=note)


def _as_spline(face: Any, carrier: Any, kind: str) -> tuple[Any, Box]:
    """Return the carrier as B-spline and its domain (u0, u1, v0, v1): all of a spline, else the face's own part."""
    if kind in ("BSplineSurface", "BezierSurface"):
        box = carrier.Bounds()
        spline = carrier.Copy() if kind == "BSplineSurface" else _converted(carrier)
        return spline, box
    box = _inside(carrier, module("BRepTools").BRepTools.UVBounds_s(face))
    trimmed = module("Geom").Geom_RectangularTrimmedSurface(carrier, *box)
    return _converted(trimmed), box


def _inside(carrier: Any, box: Box) -> Box:
    """Return the domain of a face without what rounding put outside its carrier's, or beyond a full turn."""
    u0, u1, v0, v1 = carrier.Bounds()
    around = (bool(carrier.IsUPeriodic()), bool(carrier.IsVPeriodic()))
    first = _interval((box[0], box[1]), (u0, u1), around[0])
    second = _interval((box[2], box[3]), (v0, v1), around[1])
    return (*first, *second)


def _interval(part: tuple[float, float], whole: tuple[float, float], periodic: bool) -> tuple[float, float]:
    """Return ``part`` inside ``whole``; on a periodic carrier it may start elsewhere, but turns once at most."""
    (low, high), (start, end) = part, whole
    near = _ROUNDING * (end - start)
    if periodic and high - low >= end - start - near and abs(low - start) > near:
        high = low + (end - start)  # a full turn from another start
        while high - low > end - start:
            high = math.nextafter(high, low)
        return low, high
    if not periodic or low >= start - near:
        low = max(low, start)
    if not periodic or high <= end + near:
        high = min(high, end)
    return low, high


def _converted(surface: Any) -> Any:
    return module("GeomConvert").GeomConvert.SurfaceToBSplineSurface_s(surface)


def _loops(face: Any, places: Places) -> list[FloatArray] | None:
    """Return the boundary loops in (u, v) over [0, 1]², as polygons along the face's own parameter curves.

    None where an edge has no such curve.
    """
    tool = module("BRep").BRep_Tool
    back = module("TopAbs").TopAbs_Orientation.TopAbs_REVERSED
    result: list[FloatArray] = []
    for wire in explored(face, "WIRE"):
        explorer = module("BRepTools").BRepTools_WireExplorer(down_to("Wire", wire), face)
        loop: list[FloatArray] = []
        while explorer.More():
            edge = explorer.Current()
            curve: Any = tool.CurveOnSurface_s(edge, face, 0.0, 1.0)
            if curve is None:
                return None
            ends = _pieces(edge, face)

            def place(values: FloatArray, curve: Any = curve) -> FloatArray:
                at = [curve.Value(t) for t in values.tolist()]
                return places(np.array([(p.X(), p.Y()) for p in at]))

            points = place(ends) if _along_axis(curve) else polygon(place, ends)
            loop.append((points[::-1] if edge.Orientation() == back else points)[:-1])
            explorer.Next()
        if sum(map(len, loop)) >= 3:
            result.append(np.concatenate(loop))
    return result


def _along_axis(curve: Any) -> bool:
    """Return whether a curve in (u, v) is a line along u or v."""
    if curve.DynamicType().Name() != "Geom2d_Line":
        return False
    direction = curve.Direction()
    return min(abs(direction.X()), abs(direction.Y())) <= _ROUNDING


def _pieces(edge: Any, face: Any) -> FloatArray:
    """Return the parameters between which the edge's curve in the face's parameters is smooth, its ends included."""
    adaptor = module("BRepAdaptor").BRepAdaptor_Curve2d(edge, face)
    smooth = module("GeomAbs").GeomAbs_Shape.GeomAbs_C2
    count = int(adaptor.NbIntervals(smooth))
    values = array_type("Array1_double")(1, count + 1)
    adaptor.Intervals(values, smooth)
    return np.array([values.Value(k + 1) for k in range(count + 1)])


def _free_edges(shape: Any) -> list[Any]:
    """Return the edges that bound no face."""
    kinds = module("TopAbs").TopAbs_ShapeEnum
    explorer = module("TopExp").TopExp_Explorer(shape, kinds.TopAbs_EDGE, kinds.TopAbs_FACE)
    result: list[Any] = []
    while explorer.More():
        result.append(explorer.Current())
        explorer.Next()
    return result


def _curve(number: int, name: str, edge: Any) -> SpaceCurve | None:
    adaptor = module("BRepAdaptor").BRepAdaptor_Curve(edge)
    try:
        curve = adaptor.BSpline() if adaptor.GetType().name == "GeomAbs_BSplineCurve" else None
        if curve is None:
            basis: Any = module("BRep").BRep_Tool.Curve_s(edge, 0.0, 1.0)
            part = module("Geom").Geom_TrimmedCurve(basis, adaptor.FirstParameter(), adaptor.LastParameter())
            curve = module("GeomConvert").GeomConvert.CurveToBSplineCurve_s(part)
        if curve.IsPeriodic():
            curve.SetNotPeriodic()
    except Exception:  # a curve that OpenCASCADE cannot convert is left out
        return None
    poles = [curve.Pole(k + 1) for k in range(curve.NbPoles())]
    knots = [curve.Knot(k + 1) for k in range(curve.NbKnots()) for _ in range(curve.Multiplicity(k + 1))]
    weights = [curve.Weight(k + 1) for k in range(curve.NbPoles())]
    return SpaceCurve(
        number, name or f"curve {number}", [[p.X(), p.Y(), p.Z()] for p in poles], weights, curve.Degree(), knots
    )


def _short(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0][:120]
