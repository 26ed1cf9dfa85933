"""Faces and shells of OpenCASCADE from NURBS surfaces."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from quintrig.exchange.cad.curve_forms import CurveCarrier
from quintrig.exchange.cad.forms import Carrier
from quintrig.exchange.cad.occ import explored, module, to_occ, to_occ_curve
from quintrig.exchange.origin import far
from quintrig.geometry.exact import ExactSurface
from quintrig.support.tolerance import rounding

_SMALLEST = 1e-7
"""OpenCASCADE's own confusion distance: edges shorter than this are points to it."""


@dataclass(frozen=True, eq=False)
class Shell:
    """The shape of the faces, if any, these in the order of the patches, what to tell the user, and edges of curves."""

    shape: Any
    faces: tuple[Any, ...]
    notes: tuple[str, ...]
    edges: tuple[Any, ...] = ()

    @property
    def whole(self) -> Any:
        """Everything as one shape."""
        shapes = [*([self.shape] if self.faces else []), *self.edges]
        if len(shapes) == 1:
            return shapes[0]
        builder, whole = module("BRep").BRep_Builder(), module("TopoDS").TopoDS_Compound()
        builder.MakeCompound(whole)
        for part in shapes:
            builder.Add(whole, part)
        return whole


def shell(parts: Sequence[Carrier], tolerance: float | None = None, unit: str = "") -> Shell:
    """Return one face, or several sewn together where their edges are within ``tolerance`` (length¹).

    By default the tolerance is 1e-6 of the model's size, and at least twice the deviation of a fit and four times what
    rounding moves points by at this distance from the origin. Raises ValueError where OpenCASCADE makes no valid face
    of a patch.
    """
    faces = [_face(part) for part in parts]
    if len(faces) == 1:
        return Shell(_alone(faces[0]), tuple(faces), ())
    size = _size(parts)
    reach = tolerance
    if reach is None:
        rounded = max(rounding(part.form.points) for part in parts)
        reach = max(1e-6 * size, 2.0 * max(part.deviation for part in parts), 4.0 * rounded)
    sewing = module("BRepBuilderAPI").BRepBuilderAPI_Sewing(reach)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    sewn = tuple(sewing.Modified(face) if sewing.IsModified(face) else face for face in faces)
    joined, free = sewing.NbContigousEdges(), sewing.NbFreeEdges()
    length = f"{reach:.3g} {unit}".rstrip()
    notes = [f"sewn within {length}: {joined} shared edges, {free} free edges"]
    inside = explored(sewing.SewedShape(), "FACE")
    turned = [part.name for part, old, new in zip(parts, faces, sewn, strict=True) if _turned(old, new, inside)]
    if turned:
        notes.append(f"normals turned so that the shell has one outside: {', '.join(turned)}")
    return Shell(sewing.SewedShape(), sewn, tuple(notes))


def with_edges(faces: Shell | None, curves: Sequence[CurveCarrier]) -> Shell:
    """Return the shape of curves, or of faces and curves together; ValueError where OpenCASCADE makes no edge."""
    edges: list[Any] = []
    for one in curves:
        maker = module("BRepBuilderAPI").BRepBuilderAPI_MakeEdge(to_occ_curve(one.form))
        if not maker.IsDone():
            raise ValueError(f'curve "{one.name}": OpenCASCADE makes no edge of it; is it collapsed?')
        edges.append(maker.Edge())
    return replace(faces, edges=tuple(edges)) if faces else Shell(None, (), (), tuple(edges))


def _alone(face: Any) -> Any:
    """Return a shell of one face: IGES keeps which way a face looks only in a shell."""
    builder, shape = module("BRep").BRep_Builder(), module("TopoDS").TopoDS_Shell()
    builder.MakeShell(shape)
    builder.Add(shape, face)
    return shape


def _face(part: Carrier) -> Any:
    maker = module("BRepBuilderAPI").BRepBuilderAPI_MakeFace(to_occ(part.form), _tolerance(part.form))
    if not maker.IsDone():
        raise ValueError(f'patch "{part.name}": OpenCASCADE makes no face of it ({maker.Error().name})')
    face = maker.Face()
    # Far from the origin its vertices and edges meet within rounding only, which is more than OpenCASCADE's own least.
    rounded = rounding(part.form.points)
    if rounded > _SMALLEST:
        module("ShapeFix").ShapeFix_ShapeTolerance().LimitTolerance(face, 2.0 * rounded)
    if not module("BRepCheck").BRepCheck_Analyzer(face).IsValid():
        why = f"{far(part.surface)}: move the model nearer" if rounded > _SMALLEST else "is the surface collapsed?"
        raise ValueError(f'patch "{part.name}": OpenCASCADE finds the face invalid; {why}')
    # A reversed face has its normal against S_u x S_v, as a flipped patch has.
    return face.Reversed() if part.form.flip else face


def _tolerance(form: ExactSurface) -> float:
    """Return the distance below which an edge counts as a point; collapsed edges are exact points here."""
    return min(_SMALLEST, 1e-9 * float(np.ptp(form.points, axis=(0, 1)).max()))


def _turned(old: Any, new: Any, inside: Sequence[Any]) -> bool:
    """Return whether the face lies in the shell with its other side out."""
    return any(face.IsSame(new) and face.Orientation() != old.Orientation() for face in inside)


def _size(parts: Sequence[Carrier]) -> float:
    points = np.concatenate([part.form.points.reshape(-1, 3) for part in parts])
    return float(np.linalg.norm(np.ptp(points, axis=0)))
