"""Umbilics: points where κ1 = κ2, with index and type; curves and regions of them are told as such.

An umbilic is where the vector ((M11 - M22)/2, M12) of the shape operator vanishes. Seeds are the cells of a grid
around which it turns, and its least values; Newton's iteration, with the derivative of the second form, does the rest
(index by D = ac - c² + bd - b²; Berry and Hannay 1977, Darboux 1896). Then the search is proved: each umbilic is alone
in a box and there is none elsewhere. What the proof leaves open is searched too.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from quintrig.enclosures.umbilics import MOST, Umbilical, clusters, prove
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import RIM, along_boundary
from quintrig.interrogation.umbilic import Region, Umbilic, Umbilics
from quintrig.interrogation.umbilic_pole import at_pole, poles_of
from quintrig.interrogation.umbilic_regions import Parts, parts_of
from quintrig.interrogation.umbilic_search import (
    apart,
    beside,
    clearest,
    curve_through,
    is_flat,
    seeds_of,
    umbilics_near,
)
from quintrig.interrogation.umbilic_type import classified
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import BoolArray, FloatArray

_CELLS = 97
_POLE = 1e-3  # of the size: nearer to a pole that is an umbilic, rounding makes others
_MADE = 1e-6  # of the size: so near to a pole they are made of rounding
_PLANAR = 1e-5  # of 1 / size: the same where the place is not known to rounding
_WALKS = 24  # along what may be a curve of umbilics
_SEEDS = 100  # of what the proof leaves open
_ROUND = 1e-9  # of the scale: a spread of κ1 and κ2 that is rounding


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
        all(each.elsewhere for each in found),
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
    elsewhere: bool = False
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
        every = certain is not None and certain.all
        return _Found([], [_whole(patch, local, defined)], every, every)
    parts = parts_of(name, surface, u[:, 0], v[0], local, np.where(defined, scale, np.nan))
    seeds = np.array(seeds_of(u[:, 0], v[0], a, b, scale, inside & ~parts.nodes)).reshape(-1, 2)
    flat = poles_of(surface)
    look = _Look(patch, parts, typical, [surface(*((end, 0.0) if axis == 0 else (0.0, end))) for axis, end in flat])
    met = look.met(seeds)
    ones, regions, certain = look.sorted_out(met)
    if certain and len(certain.open) and not regions:
        more = apart(surface, [*met, *look.met(_middles(certain.open))])
        if len(more) > len(apart(surface, met)):
            ones, regions, certain = look.sorted_out(more)
    if certain and flat - certain.poles and len(certain.open):
        beside_poles = look.beside_poles(met, certain.open)
        if beside_poles:
            ones, certain = beside_poles
            flat = certain.poles
    found = _Found(ones, regions)
    poles = [at_pole(patch, axis, end) for axis, end in sorted(flat | (certain.poles if certain else flat))]
    found.elsewhere = certain is not None and not len(certain.open) and not regions and all(one.proved for one in ones)
    found.complete = found.elsewhere and all(one.proved == "alone" for one in ones)
    found.told = _compared(patch, ones, poles, regions)
    found.umbilics = sorted([*ones, *poles], key=lambda one: (round(one.u, 9), round(one.v, 9)))
    for axis, end in sorted(certain.untold) if certain else []:
        found.notes.append(f"{name}: a tangent vanishes along {'uv'[axis]} = {end:g}; no umbilic is told on this edge")
    if not np.isfinite(local.spread[inside]).all() and not found.elsewhere:
        found.notes.append(f"{name}: has singular points, at which no umbilic is told")
    if found.told and found.told["agree"] is False:
        found.notes.append(
            f"{name}: the indices do not sum to the rotation along the boundary; look closer at this patch"
        )
    if not found.complete:
        found.notes += [f"{name}: {why}" for why in _why_not(certain, ones, regions)]
    return found


@dataclass(frozen=True, eq=False)
class _Look:
    """A patch looked through: its regions of umbilics, the typical curvature, and the poles (3,) that are one."""

    patch: Patch
    parts: Parts
    typical: float
    poles: Sequence[FloatArray]

    def met(self, seeds: FloatArray, poles: bool = True) -> list[FloatArray]:
        """Return umbilics near seeds (n, 2), outside regions; beside a pole that is one, what is met is the pole."""
        surface = self.patch.surface
        seeds = np.array([uv for uv in seeds if not self.parts.hold(uv)]).reshape(-1, 2)
        found = [uv for uv in umbilics_near(surface, seeds, self.typical) if np.isfinite(uv).all()]
        away = [uv for uv in found if not self.parts.hold(uv)]
        return [uv for uv in away if not poles or not self._near_pole(uv, _POLE)]

    def _near_pole(self, uv: FloatArray, share: float) -> bool:
        surface = self.patch.surface
        return any(np.linalg.norm(surface(*uv) - pole) <= share * surface.size for pole in self.poles)

    def sorted_out(self, met: Sequence[FloatArray]) -> tuple[list[Umbilic], list[Region], Umbilical | None]:
        """Return isolated umbilics, curves and regions of them, and what is certain of all, for places found."""
        surface = self.patch.surface
        places = apart(surface, met)
        regions = list(self.parts.regions)
        lines: list[FloatArray] = []  # the points of curves, and of what looked like one and is none
        walks = iter(range(_WALKS))
        for uv in places:
            if not is_flat(surface, uv) or any(beside(surface, uv, points) for points in lines):
                continue
            if next(walks, None) is None:
                break
            line, ends = curve_through(surface, uv, self.typical, self.parts.hold)
            if line is None:
                continue
            lines.append(surface(*line.T))
            if ends:
                curvature = float(Local.at(surface, *line[len(line) // 2]).mean)
                regions.append(Region(self.patch.name, "curve", curvature, line, lines[-1]))
        curves = [region.points for region in regions if region.kind == "curve"]
        others = [uv for uv in places if not any(beside(surface, uv, points) for points in curves)]
        certain = prove(surface, np.array(others).reshape(-1, 2), 1 if regions else MOST)
        return _told(self.patch, others, certain, self.typical), regions, certain

    def beside_poles(self, met: Sequence[FloatArray], open_: FloatArray) -> tuple[list[Umbilic], Umbilical] | None:
        """Return the umbilics beside what looked like one at a pole, where these are proved to be all there are.

        Those that rounding makes lie nearer to it.
        """
        found = [*met, *self.met(_middles(open_), poles=False)]
        if any(self._near_pole(uv, _MADE) for uv in found):
            return None
        ones, regions, certain = self.sorted_out(found)
        proved = certain is not None and not len(certain.open) and all(one.proved == "alone" for one in ones)
        return (ones, certain) if certain and proved and not regions else None


def _middles(rectangles: FloatArray) -> FloatArray:
    """Return the middles of rectangles (n, 4) in u, v, spread evenly over them where there are many."""
    middles = 0.5 * (rectangles[:, :2] + rectangles[:, 2:])
    return middles[:: max(1, len(middles) // _SEEDS)]


def _told(patch: Patch, places: Sequence[FloatArray], certain: Umbilical | None, typical: float) -> list[Umbilic]:
    """Return the umbilics at places; of those that are not simple and near each other, one for all."""
    surface = patch.surface
    simple = np.array([not is_flat(surface, uv) for uv in places], dtype=np.bool_)
    alone: BoolArray = simple if certain is None else certain.alone
    found: list[Umbilic] = []
    left: BoolArray = np.logical_not(alone)
    for group in certain.groups if certain else ():
        left[list(group.members)] = False
        one = classified(patch, clearest(surface, [places[k] for k in group.members], typical), (), typical)
        told = one.index
        one = replace(one, index=group.index, proved="index", box=(*group.low.tolist(), *group.high.tolist()))
        if abs(one.curvature) <= _PLANAR / surface.size:
            one = replace(one, type="planar", curvature=0.0)
        elif told != group.index or len(group.members) > 1:
            one = replace(one, type="other")
        found.append(replace(one, directions=()) if one.type in ("planar", "other") else one)
    for members in clusters(np.array(places).reshape(-1, 2), np.flatnonzero(left)):
        mine: list[int] = members.tolist()
        here = clearest(surface, [places[k] for k in mine], typical)
        rest = [uv for k, uv in enumerate(places) if k not in mine]
        found.append(classified(patch, here, rest, typical))
    for k in np.flatnonzero(alone).tolist():
        one = classified(patch, places[k], [uv for uv in places if uv is not places[k]], typical)
        found.append(replace(one, proved="alone") if certain else one)
    return found


def _why_not(certain: Umbilical | None, ones: Sequence[Umbilic], regions: Sequence[Region]) -> Iterator[str]:
    """Yield why it is not proved that there are no other umbilics, and what is proved all the same."""
    if certain is None:
        yield "no proof, as its functions are neither polynomials nor trigonometric forms of one angle"
        return
    for one in ones:
        if one.proved == "index":
            at = f"the umbilic at (u, v) = ({one.u:.6g}, {one.v:.6g})"
            yield f"the index {one.index:+g} of a box around {at} is proved, not whether this is the only one in it"
    open_ = [one for one in ones if not one.proved]
    if open_:
        more = f", and {len(open_) - 1} more" if len(open_) > 1 else ""
        at = f"the umbilic at (u, v) = ({open_[0].u:.6g}, {open_[0].v:.6g})"
        yield f"no proof around {at}, which is not a simple one{more}"
    if regions:
        yield f"no proof beside a {regions[0].kind} of umbilics"
    elif len(certain.open):
        place = ", ".join(f"{x:.6g}" for x in (0.5 * (certain.open[0, :2] + certain.open[0, 2:])).tolist())
        yield f"{len(certain.open)} boxes of the proof are left open, one around (u, v) = ({place})"


def _whole(patch: Patch, local: Local, defined: np.ndarray[Any, np.dtype[np.bool_]]) -> Region:
    low, high = window(patch.surface.trim)
    corners = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    return Region(patch.name, "region", float(np.median(local.mean[defined])), corners, patch.surface(*corners.T))


def _compared(
    patch: Patch, found: Sequence[Umbilic], poles: Sequence[Umbilic], regions: Sequence[Region]
) -> dict[str, Any]:
    """Return the sum of the indices and the rotation along the boundary of the patch, where both mean something.

    Poles that are umbilics are counted on both sides: with their index, and as no part of the boundary.
    """
    surface = patch.surface
    if regions:
        return {}
    total, free = along_boundary(surface, [np.array([one.u, one.v]) for one in found])
    around = sum(one.index for one in poles)
    total += around
    rounded = round(2.0 * total) / 2.0 if np.isfinite(total) and abs(2.0 * total - round(2.0 * total)) < 0.2 else None
    on_rim = any(_is_on(one, axis, end) for one in found for axis, end in free)
    summed = float(sum(one.index for one in found)) + around
    known = rounded is not None and bool(np.isfinite(summed)) and not on_rim
    return {
        "patch": patch.name,
        "index_sum": summed if np.isfinite(summed) else None,
        "boundary_rotation": rounded,
        "agree": rounded == summed if known else None,
    }


def _is_on(one: Umbilic, axis: int, end: float) -> bool:
    """Return whether an umbilic, or the box around it, is on a side of the domain."""
    over = bool(one.box) and (one.box[axis] < 0.0 if end == 0.0 else one.box[axis + 2] > 1.0)
    return over or abs((one.u, one.v)[axis] - end) <= RIM
