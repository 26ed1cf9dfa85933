"""A model as a mesh file, coloured by a quantity."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from quintrig.analysis.integrate import orientation
from quintrig.exchange.formats import suffixes
from quintrig.exchange.mesh import files as mesh_files
from quintrig.exchange.origin import distance, refuse_point
from quintrig.exchange.units import stated
from quintrig.mesh.triangulate import Mesh, mesh
from quintrig.model.model import Model
from quintrig.quantities.table import Quantity, quantity
from quintrig.support.arrays import FloatArray
from quintrig.support.files import write_whole

MESH_SUFFIXES = suffixes("mesh")
"""Endings of the mesh files that can be written."""

_ROUNDED = 0.25
"""Share of the tolerance that the rounding of the file's numbers may take."""

QUANTITIES = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness")
"""Stored with each point where the format can."""


@dataclass(frozen=True)
class MeshOptions:
    """Chordal ``tolerance``, length¹, or a ``grid`` of points along u and v; ``colour`` by a quantity or None.

    ``ends`` are the values at the ends of the colour map, without them those of the figures.
    """

    tolerance: float | None = None
    grid: tuple[int, int] | None = None
    colour: str | None = "gaussian"
    quantities: tuple[str, ...] = QUANTITIES
    ends: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        """Check the names once."""
        for key in (*self.quantities, *([self.colour] if self.colour else [])):
            if quantity(key).kind == "vector":
                raise ValueError(f"{key} is a vector; choose a quantity with one value at a point, such as gaussian")
        if self.tolerance is not None and self.grid is not None:
            raise ValueError("mesh: expected a tolerance or a grid, found both")
        if self.tolerance is not None and not 0.0 < self.tolerance < np.inf:
            raise ValueError(f"tolerance: expected a length greater than 0, found {self.tolerance:g}")
        if self.ends is not None and not -np.inf < self.ends[0] < self.ends[1] < np.inf:
            low, high = self.ends
            raise ValueError(f"colours: expected a lower and a higher value at their ends, found {low:g} and {high:g}")


def export_mesh(model: Model, path: Path, options: MeshOptions | None = None) -> tuple[str, ...]:
    """Write an STL, OBJ, PLY, GLB or VTU file, and return what to tell about it, one line each.

    The chord that is told and kept to the tolerance is that of the file: the rounding of its numbers counts in. Raises
    ValueError for a tolerance that takes too many points or that the file's numbers cannot keep, QuintrigError for an
    unwritable target.
    """
    refuse_point(model)
    options = options or MeshOptions()
    keys = list(options.quantities)
    if options.colour and options.colour not in keys:
        keys.append(options.colour)
    suffix = path.suffix.lower()
    result = _kept(model, suffix, options, keys)
    moved = _moved(result.points, suffix)
    result = replace(result, chord=result.chord + moved)
    colours, legend = (
        (None, "") if options.colour is None else _colours(result, model, quantity(options.colour), options.ends)
    )
    remarks = _remarks(model, result, legend if suffix not in (".stl", ".vtu") else "")
    write_whole(path, _data(suffix, result, colours, remarks, stated(model.unit).millimetres * 1e-3))
    asked = "" if options.grid else f", allowed {_tolerance(options, model):.3g}"
    lines = [
        f"{len(result.points):,} points, {len(result.triangles):,} triangles, "
        f"chord measured {result.chord:.3g}{asked}{_unit(model)}",
        "watertight" if result.open_edges == 0 else f"{result.open_edges:,} triangle sides lie on open borders",
    ]
    if moved > 0.01 * result.chord:
        lines.append(f"float32 moves points by up to {moved:.2g}{_unit(model)}, which is in the chord measured")
    return (*lines, *result.notes, *([legend] if legend and suffix not in (".stl", ".vtu") else []))


def _kept(model: Model, suffix: str, options: MeshOptions, keys: Sequence[str]) -> Mesh:
    """Return a mesh that is within the tolerance as the file will hold it; ValueError naming formats that can."""
    surfaces = [patch.surface for patch in model.patches]
    result = mesh(surfaces, tolerance=options.tolerance, grid=options.grid, quantities=keys)
    moved, allowed = _moved(result.points, suffix), _tolerance(options, model)
    if not moved <= _ROUNDED * allowed:
        keeping = [one for one in MESH_SUFFIXES if _moved(result.points, one) <= _ROUNDED * allowed]
        raise ValueError(
            f"{suffix[1:].upper()} holds float32, which {distance(surfaces[0]):.3g}{_unit(model)} from the origin "
            f"would move points by up to {moved:.2g}, more than a tolerance of {allowed:.3g} allows; write "
            f"{', '.join(keeping)}, which keep them, or move the model nearer"
        )
    if options.grid is None and result.chord + moved > allowed:  # finer triangles leave room for the rounding
        return mesh(surfaces, tolerance=allowed - 2.0 * moved, quantities=keys)
    return result


def _moved(points: FloatArray, suffix: str) -> float:
    """Return the largest distance by which a file's numbers move the points of a mesh, length¹."""
    return float(np.sqrt(((mesh_files.stored(points, suffix) - points) ** 2).sum(axis=-1)).max(initial=0.0))


def _data(suffix: str, result: Mesh, colours: FloatArray | None, remarks: Sequence[str], metres: float) -> bytes:
    if suffix == ".stl":
        return mesh_files.stl(result, remarks)
    if suffix == ".obj":
        return mesh_files.obj(result, colours, remarks)
    if suffix == ".ply":
        return mesh_files.ply(result, colours, remarks)
    if suffix == ".glb":
        return mesh_files.glb(result, colours, remarks, metres)
    return mesh_files.vtu(result, remarks)


def _tolerance(options: MeshOptions, model: Model) -> float:
    return options.tolerance or 1e-3 * min(patch.surface.size for patch in model.patches)


def _colours(result: Mesh, model: Model, shown: Quantity, ends: tuple[float, float] | None) -> tuple[FloatArray, str]:
    """Return sRGB colours (n, 3) of the points and a line that explains them."""
    from quintrig.figure import palette

    values = result.values[shown.key]
    singular = int((~np.isfinite(result.values["mean"])).sum()) if "mean" in result.values else 0
    grey = f"; {singular} singular points grey" if singular else ""
    if shown.kind == "class":
        return palette.class_colours(values, shown.key), f"colours show the {shown.name}{grey}"
    real = np.asarray(values, dtype=np.float64)
    stretch = palette.limits(real, shown) if ends is None else palette.between(real, *ends)
    unit = shown.unit(model.unit)
    spread = f"{stretch.low:.4g} to {stretch.high:.4g}{' ' + unit if unit else ''}"
    clipped = f", {100 * stretch.clipped_share:.2g} % of the points beyond" if stretch.clipped_share else ""
    return palette.real_colours(
        values, shown, stretch
    ), f"colours show {shown.name} {shown.symbol}, {spread}{clipped}{grey}"


def _remarks(model: Model, result: Mesh, legend: str) -> list[str]:
    """Return what a reader of the file has to know: one line each, without line breaks."""
    unit = model.unit or "none stated"
    sides = {patch.name: orientation(patch.surface) for patch in model.patches}
    alike = len(set(sides.values())) == 1
    side = next(iter(sides.values())) if alike else "; ".join(f"{name}: {words}" for name, words in sides.items())
    lines = [
        f"{model.name}, unit {unit}, by quintrig",
        f"{side.replace('×', 'x')}; counter-clockwise triangles show that side",
        f"chordal deviation measured {result.chord:.6g}",
        legend,
    ]
    return [" ".join(line.split()) for line in lines if line]


def _unit(model: Model) -> str:
    return f" {model.unit}" if model.unit else ""
