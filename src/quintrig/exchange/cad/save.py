"""A model as a CAD file, read back and compared before it counts as written."""

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from quintrig.exchange.cad.curve_forms import CurveCarrier, curve_carriers
from quintrig.exchange.cad.fit import FitOptions
from quintrig.exchange.cad.forms import Carrier, written_carriers
from quintrig.exchange.cad.isolated import read_here
from quintrig.exchange.cad.readback import Deviation, curve_deviations, deviations
from quintrig.exchange.formats import suffixes
from quintrig.exchange.origin import far, is_far, refuse_point
from quintrig.exchange.units import ASSUMED
from quintrig.model.model import Model
from quintrig.support.errors import QuintrigError
from quintrig.support.files import write_whole

CAD_WRITTEN = suffixes("cad")
"""Endings of the CAD files that can be written."""

_USUAL_SEWING = 5e-7
"""Of the size of a patch: seams up to this wide are sewn anyway."""

_SEPARATE = (
    "3DM: each patch is a surface of its own, for rhino3dm joins none; Join in Rhino makes one polysurface of those "
    "that meet (STEP and IGES hold them sewn)"
)

_LARGEST_DEVIATION = 1e-12
"""Of an exact file from its model, relative to the patch's size and beside what rounding explains; more is a fault."""


@dataclass(frozen=True)
class CadOptions:
    """Protocol of STEP files, a fit in place of the exact form, and the distance for sewing patches, length¹."""

    schema: Literal["ap242", "ap214"] = "ap242"
    fit: FitOptions | None = None
    sew: float | None = None

    def __post_init__(self) -> None:
        """Check once what can be checked alone."""
        if self.sew is not None and not self.sew > 0.0:
            raise ValueError(f"sewing tolerance: expected a length greater than 0, found {self.sew:g}")


def export_cad(model: Model, path: Path, options: CadOptions | None = None) -> tuple[str, ...]:
    """Write a STEP, IGES, BREP or 3DM file, and return what to tell about it, one line each.

    The file is read back, every patch compared at 10,000 points and every curve at 1,000, before it takes its place.
    Plane curves lie in z = 0. Raises QuintrigError for
    a missing extra or an unwritable target, ValueError where a patch is a point or has no such form.
    """
    options = options or CadOptions()
    refuse_point(model)
    parts, curves = written_carriers(model, options.fit), curve_carriers(model, options.fit)
    notes = [f"{part.name}: {part.note}" for part in (*parts, *curves)]
    data, more = _data(model, path.suffix.lower(), parts, curves, options, "; ".join(notes))
    notes += more
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / f"copy{path.suffix.lower()}"
        copy.write_bytes(data)
        notes += _compared(parts, curves, copy, path)
    if not model.unit and path.suffix.lower() != ".brep":
        notes.append(f"the model states no unit; the file says {ASSUMED}")
    if any(part.surface.trim for part in parts):
        notes.append("trimmed faces are written as their whole surfaces")
    write_whole(path, data)
    return tuple(notes)


def _data(
    model: Model,
    suffix: str,
    parts: tuple[Carrier, ...],
    curves: tuple[CurveCarrier, ...],
    options: CadOptions,
    remark: str,
) -> tuple[bytes, tuple[str, ...]]:
    names = [part.name for part in (*parts, *curves)]
    if suffix == ".3dm":
        from quintrig.exchange.cad.rhino import write_3dm

        notes = (_SEPARATE,) if len(parts) > 1 else ()
        forms, written = [part.form for part in parts], [one.written for one in curves]
        return write_3dm(forms, names[: len(parts)], model.unit, remark, written), notes
    from quintrig.exchange.cad import write as cad_write
    from quintrig.exchange.cad.occ import quiet
    from quintrig.exchange.cad.shell import shell, with_edges

    with quiet():
        faces = shell(parts, options.sew or _widest_seam(model), model.unit) if parts else None
        shape = faces if faces and not curves else with_edges(faces, curves)
    if suffix in (".step", ".stp"):
        return cad_write.step(shape, model.name, names, model.unit, options.schema, remark), shape.notes
    if suffix in (".iges", ".igs"):
        return cad_write.iges(shape, model.name, names, model.unit), shape.notes
    return cad_write.brep(shape), (*shape.notes, "BREP holds neither names nor units")


def _widest_seam(model: Model) -> float | None:
    """Return a distance at which all seams that count as closed are sewn; None where the usual one sews them."""
    if len(model.patches) < 2:
        return None
    gaps = [join.gap.most for join in model.joins() if join.order != "open"]
    size = max(patch.surface.size for patch in model.patches)
    return 1.5 * max(gaps) if gaps and max(gaps) > _USUAL_SEWING * size else None


def _compared(parts: tuple[Carrier, ...], curves: tuple[CurveCarrier, ...], copy: Path, path: Path) -> list[str]:
    """Return a line on each patch and curve; QuintrigError where an exact file is not exact."""
    read = read_here(copy)
    lines: list[str] = []
    if len(parts) > 1 and path.suffix.lower() != ".3dm":
        lines.append(f"read back as {'one shell' if read.shells == 1 else f'{read.shells} shells'}")
    for part, found in zip(parts, deviations(parts, read), strict=True) if parts else ():
        lines.append(_told("patch", part.deviation == 0.0, part.surface.size, found, path))
        if is_far(part.surface):
            lines.append(f"{found.name}: {far(part.surface)}; move the model nearer for more digits")
    for one, found in zip(curves, curve_deviations(curves, read), strict=True) if curves else ():
        lines.append(_told("curve", one.deviation == 0.0, one.size, found, path))
    return lines


def _told(what: str, exact: bool, size: float, found: Deviation, path: Path) -> str:
    """Return how far what was read back is from the model; QuintrigError where it should be exact and is not."""
    allowed = _LARGEST_DEVIATION * size + found.rounding
    if exact and not found.distance <= allowed:
        raise QuintrigError(
            f"{path}: not written: read back, {what} {found.name!r} deviates by {found.distance:.2g} "
            f"({found.relative:.1e} of its size), where {allowed:.2g} can be explained; please report this with "
            "the model"
        )
    return f"{found.name}: read back, largest deviation {found.distance:.2g} ({found.relative:.1e} of its size)"
