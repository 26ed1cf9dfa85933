"""A model in the format that a file's suffix says: CAD, mesh, or control net."""

from dataclasses import dataclass, field
from pathlib import Path

from quintrig.exchange import curve_drawing, nets
from quintrig.exchange.cad import save as cad
from quintrig.exchange.cad.save import CadOptions, export_cad
from quintrig.exchange.formats import suffixes
from quintrig.exchange.mesh import write as meshes
from quintrig.exchange.mesh.write import MeshOptions, export_mesh
from quintrig.exchange.nets import export_net, net_paths
from quintrig.model.model import Model
from quintrig.support.errors import QuintrigError, nearest

EXPORT_SUFFIXES = (*cad.CAD_WRITTEN, *meshes.MESH_SUFFIXES, *nets.NET_SUFFIXES)
"""Every ending that ``export`` knows; of models with curves also those of drawings."""

_MOST_SEAMS = 8  # that are told one by one


@dataclass(frozen=True)
class ExportOptions:
    """What only some formats ask for."""

    cad: CadOptions = field(default_factory=CadOptions)
    mesh: MeshOptions = field(default_factory=MeshOptions)


@dataclass(frozen=True)
class Written:
    """The files written, mostly one, what to tell about them, one line each, and which were there before."""

    paths: tuple[Path, ...]
    notes: tuple[str, ...]
    replaced: tuple[Path, ...] = ()


def targets(model: Model, path: str | Path) -> tuple[Path, ...]:
    """Return the files that ``export`` writes for a path: it alone, but for a CSV of several nets of points.

    Raises QuintrigError for a CSV of a model without control points.
    """
    return net_paths(model, Path(path))


def export(model: Model, path: str | Path, options: ExportOptions | None = None) -> Written:
    """Write a model to a file, whole or not at all.

    Raises QuintrigError for an unknown suffix, a missing extra or an unwritable target, ValueError where the model
    cannot be written in this format.
    """
    path, options = Path(path), options or ExportOptions()
    suffix = path.suffix.lower()
    replaced = tuple(one for one in targets(model, path) if one.is_file())
    if suffix in cad.CAD_WRITTEN:
        return Written((path,), (*export_cad(model, path, options.cad), *_open_seams(model)), replaced)
    if suffix in curve_drawing.CURVE_DRAWING_SUFFIXES and model.curves:
        return Written((path,), curve_drawing.export_curves(model, path, options.cad.fit), replaced)
    if suffix in meshes.MESH_SUFFIXES:
        if not model.patches:
            names = ", ".join((*cad.CAD_WRITTEN, *curve_drawing.CURVE_DRAWING_SUFFIXES, *nets.NET_SUFFIXES))
            raise QuintrigError(f"{path}: a mesh is made of surfaces, and this model has curves alone; choose {names}")
        left = ("curves are left out: a mesh holds surfaces alone",) if model.curves else ()
        return Written((path,), (*export_mesh(model, path, options.mesh), *left, *_open_seams(model)), replaced)
    if suffix in nets.NET_SUFFIXES:
        paths = export_net(model, path)
        several = (f"{len(paths)} nets of points, a file for each",) if len(paths) > 1 else ()
        return Written(paths, several, replaced)
    expected = f"{path}: expected a file ending in {', '.join(EXPORT_SUFFIXES)}"
    if suffix in suffixes("pattern"):
        raise QuintrigError(expected, remedy="export_pattern writes flat patterns", key="pattern")
    raise QuintrigError(f"{expected}{nearest(suffix, EXPORT_SUFFIXES)}")


def _open_seams(model: Model) -> tuple[str, ...]:
    """Return a line on each seam between patches that is nearly closed: CAD and printers take it for a hole."""
    if len(model.patches) < 2:
        return ()
    found: tuple[str, ...] = model.joins().warnings
    more = (f"and {len(found) - _MOST_SEAMS} more seams are open; the model's joins list them",)
    return (*found[:_MOST_SEAMS], *(more if len(found) > _MOST_SEAMS else ()))
