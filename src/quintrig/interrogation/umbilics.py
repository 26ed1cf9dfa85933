"""Umbilics: points where κ1 = κ2, with index and type; curves and regions of them are told as such.

An umbilic is where the vector ((M11 - M22)/2, M12) of the shape operator vanishes. Seeds are the cells of a grid
around which it turns, and its least values; Newton's iteration, with the derivative of the second form, does the rest
(index by D = ac - c² + bd - b²; Berry and Hannay 1977, Darboux 1896). Then the search is proved: each umbilic is alone
in a box and there is none elsewhere. What the proof leaves open is searched too.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from quintrig.enclosures.umbilics import MOST, Umbilical, prove
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import RIM, along_boundary, index_about
from quintrig.interrogation.umbilic import Region, Type, Umbilic, Umbilics
from quintrig.interrogation.umbilic_pole import at_pole, poles_of
from quintrig.interrogation.umbilic_search import apart, beside, curve_through, is_flat, seeds_of, umbilics_near
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

_CELLS = 97
_POLE = 1e-3  # of the size: nearer to a pole that is an umbilic, rounding makes others
_SEEDS = 100  # of what the proof leaves open
_ROUND = 1e-9  # of the scale: a spread of κ1 and κ2 that is rounding
_FLAT = 1e-7  # of 1 / size: a curvature this small is that of a planar point
_FLAT_FORM = 1e-6  # of the square of the derivative: below it, an umbilic is not a simple one
_WEAK = 1e-4  # of the typical curvature by the size: a change of curvature of which rounding may be a part


def umbilics(subject: Surface | Patch | Model) -> Umbilics:
    """Return the umbilics of a surface, or of all patches of a model, and whether these are proved to be all."""
    unit = subject.unit if isinstance(subject, Model) else ""
    found = [_of_patch(patch) for patch in patches_of(subject)]
    return Umbilics(
        tuple(one for each in found for one in each.umbilics),
        tuple(one for each in found for one in each.regions),
        all(each.complete for each in found),
        tuple(each.told for each in found if each.told),
        tuple(note for each in found for note in each.notes),
        unit,
    )


def patches_of(subject: Surface | Patch | Model) -> tuple[Patch, ...]:
    """Return the patches of a model, a patch itself, or one that holds the surface."""
    if isinstance(subject, Model):
        subject.refuse_curves()
        return subject.patches
    if isinstance(subject, Patch):
        return (subject,)
    if not isinstance(subject, Surface):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise ValueError(f"subject: expected a Surface, Patch or Model, got {type(subject).__name__}")  # noqa: TRY004
    return (Patch.of(subject),)


@dataclass
class _Found:
    """What there is on a patch."""

    umbilics: list[Umbilic] = field(default_factory=list[Umbilic])
    regions: list[Region] = field(default_factory=list[Region])
    complete: bool = False
    told: dict[str, Any] = field(default_factory=dict[str, Any])
    notes: list[str] = field(default_factory=list[str])


def _of_patch(patch: Patch) -> _Found:
    surface, name = patch.surface, patch.name
    if not surface.size > 0.0:
        return _Found(notes=[f"{name}: a single point, which has no curvature"])
    u, v = face_grid(surface, _CELLS + 1, _CELLS + 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, u, v)
        a, b = local.half
    inside = surface.inside(u, v)
    scale = np.abs(local.mean) + local.spread + 1.0 / surface.size
    defined = np.isfinite(local.spread) & inside
    if not defined.any():
        return _Found(notes=[f"{name}: no point has a curvature"])
    typical = float(np.median(scale[defined]))
    if (local.spread[defined] <= _ROUND * scale[defined]).all():
        certain = prove(surface, np.zeros((0, 2)), 1)
        return _Found([], [_whole(patch, local, defined)], certain is not None and certain.all)
    seeds = np.array(seeds_of(u[:, 0], v[0], a, b, scale, inside)).reshape(-1, 2)
    flat = poles_of(surface)
    apexes = [surface(*((end, 0.0) if axis == 0 else (0.0, end))) for axis, end in flat]
    met = _met(surface, seeds, typical, apexes)
    ones, regions, certain = _sorted_out(patch, met, typical)
    if certain and len(certain.open) and not regions:
        more = apart(surface, [*met, *_met(surface, _middles(certain.open), typical, apexes)])
        if len(more) > len(apart(surface, met)):
            ones, regions, certain = _sorted_out(patch, more, typical)
    found = _Found(ones, regions)
    poles = [at_pole(patch, axis, end) for axis, end in sorted(flat | (certain.poles if certain else flat))]
    found.complete = certain is not None and bool(certain.alone.all()) and not len(certain.open) and not regions
    found.told = _compared(patch, ones, poles, regions)
    found.umbilics = sorted([*ones, *poles], key=lambda one: (round(one.u, 9), round(one.v, 9)))
    for axis, end in sorted(certain.untold) if certain else []:
        found.notes.append(f"{name}: a tangent vanishes along {'uv'[axis]} = {end:g}; no umbilic is told on this edge")
    if not np.isfinite(local.spread[inside]).all() and not found.complete:
        found.notes.append(f"{name}: has singular points, at which no umbilic is told")
    if found.told and found.told["agree"] is False:
        found.notes.append(
            f"{name}: the indices do not sum to the rotation along the boundary; look closer at this patch"
        )
    if not found.complete:
        found.notes.append(f"{name}: {_why_not(certain, ones, regions)}")
    return found


def _met(surface: Surface, seeds: FloatArray, typical: float, poles: Sequence[FloatArray]) -> list[FloatArray]:
    """Return umbilics near seeds; beside a pole that is one, what is met is the pole."""
    found = [uv for uv in umbilics_near(surface, seeds, typical) if np.isfinite(uv).all()]
    reach = _POLE * surface.size
    return [uv for uv in found if all(np.linalg.norm(surface(*uv) - pole) > reach for pole in poles)]


def _middles(rectangles: FloatArray) -> FloatArray:
    """Return the middles of rectangles (n, 4) in u, v, spread evenly over them where there are many."""
    middles = 0.5 * (rectangles[:, :2] + rectangles[:, 2:])
    return middles[:: max(1, len(middles) // _SEEDS)]


def _sorted_out(
    patch: Patch, met: Sequence[FloatArray], typical: float
) -> tuple[list[Umbilic], list[Region], Umbilical | None]:
    """Return isolated umbilics, curves of them, and what is certain of both, for places found."""
    surface = patch.surface
    simple: list[FloatArray] = []
    flat: list[FloatArray] = []
    for uv in apart(surface, met):
        (flat if is_flat(surface, uv) else simple).append(uv)
    regions: list[Region] = []
    for uv in flat:
        if any(beside(surface, uv, region.points) for region in regions):
            continue
        line = curve_through(surface, uv, typical)
        if line is None:
            simple.append(uv)
        else:
            points = surface(*line.T)
            curvature = float(Local.at(surface, *line[len(line) // 2]).mean)
            regions.append(Region(patch.name, "curve", curvature, line, points))
    others = [uv for uv in simple if not any(beside(surface, uv, region.points) for region in regions)]
    ones = [_classified(patch, uv, others, typical) for uv in others]
    return ones, regions, prove(surface, np.array(others).reshape(-1, 2), 1 if regions else MOST)


def _why_not(certain: Umbilical | None, ones: Sequence[Umbilic], regions: Sequence[Region]) -> str:
    """Return why it is not proved that there are no other umbilics."""
    if certain is None:
        return "no proof, as its functions are neither polynomials nor trigonometric forms of one angle"
    if regions:
        return "no proof beside a curve of umbilics"
    double = next((one for one, alone in zip(ones, certain.alone.tolist(), strict=True) if not alone), None)
    if double:
        return f"no proof around the umbilic at (u, v) = ({double.u:.6g}, {double.v:.6g}), which is not a simple one"
    place = ", ".join(f"{x:.6g}" for x in (0.5 * (certain.open[0, :2] + certain.open[0, 2:])).tolist())
    return f"{len(certain.open)} boxes of the proof are left open, one around (u, v) = ({place})"


def _whole(patch: Patch, local: Local, defined: np.ndarray[Any, np.dtype[np.bool_]]) -> Region:
    low, high = window(patch.surface.trim)
    corners = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    return Region(patch.name, "region", float(np.median(local.mean[defined])), corners, patch.surface(*corners.T))


def _classified(patch: Patch, uv: FloatArray, others: Sequence[FloatArray], typical: float) -> Umbilic:
    surface = patch.surface
    local = Local.at(surface, *uv, order=3)
    a, b, c, d = (float(x) for x in local.cubic)
    flat_at = _FLAT / surface.size
    curvature = float(local.mean)
    determinant = a * c - c * c + b * d - b * b
    square = a * a + 3.0 * b * b + 3.0 * c * c + d * d
    index = -0.5 if determinant < 0.0 else 0.5
    simple = abs(determinant) > _FLAT_FORM * square
    if not simple or np.sqrt(square) <= _WEAK * typical / surface.size:
        turned = index_about(surface, uv, others)
        simple = simple and turned in (index, None)
        index = index if simple else float("nan") if turned is None else turned
    roots = _roots(b, 2.0 * c - a, d - 2.0 * b, -c)
    kind: Type = "other"
    if abs(curvature) <= flat_at:
        kind, curvature = "planar", 0.0
    elif simple:
        kind = "star" if determinant < 0.0 else "monstar" if len(roots) == 3 else "lemon"
    return Umbilic(
        patch.name,
        float(uv[0]),
        float(uv[1]),
        surface(*uv),
        curvature,
        index,
        kind,
        tuple(np.degrees(roots).tolist()) if simple else (),
    )


def _roots(p: float, q: float, r: float, s: float) -> list[float]:
    """Return the angles in [0, π) at which p x³ + q x² y + r x y² + s y³ vanishes, x and y being cosine and sine."""
    # By double and single angles: a trigonometric cubic, with at most three zeros in half a turn.
    t = np.linspace(1e-3, 1e-3 + np.pi, 721)  # no simple angle among them

    def at(angle: FloatArray | float) -> FloatArray:
        x, y = np.cos(angle), np.sin(angle)
        return np.asarray(p * x**3 + q * x * x * y + r * x * y * y + s * y**3)

    values = at(t)
    zeros = t[:-1][values[:-1] == 0.0]
    (cross,) = np.nonzero(values[:-1] * values[1:] < 0.0)
    low, high = t[cross], t[cross + 1]
    for _ in range(50):  # halved to the last bit; SciPy's search takes a hundred times longer to import
        middle = 0.5 * (low + high)
        left = at(low) * at(middle) <= 0.0
        low, high = np.where(left, low, middle), np.where(left, middle, high)
    return sorted((np.concatenate([zeros, 0.5 * (low + high)]) % np.pi).tolist())


def _compared(
    patch: Patch, found: Sequence[Umbilic], poles: Sequence[Umbilic], regions: Sequence[Region]
) -> dict[str, Any]:
    """Return the sum of the indices and the rotation along the boundary of the patch, where both mean something.

    Poles that are umbilics are counted on both sides: with their index, and as no part of the boundary.
    """
    surface = patch.surface
    if regions:
        return {}
    total, free = along_boundary(surface)
    around = sum(one.index for one in poles)
    total += around
    rounded = round(2.0 * total) / 2.0 if np.isfinite(total) and abs(2.0 * total - round(2.0 * total)) < 0.2 else None
    on_rim = any(abs((one.u, one.v)[axis] - end) <= RIM for one in found for axis, end in free)
    summed = float(sum(one.index for one in found)) + around
    known = rounded is not None and bool(np.isfinite(summed)) and not on_rim
    return {
        "patch": patch.name,
        "index_sum": summed if np.isfinite(summed) else None,
        "boundary_rotation": rounded,
        "agree": rounded == summed if known else None,
    }
