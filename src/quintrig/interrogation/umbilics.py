"""Umbilics: points where κ1 = κ2, with index and type; curves and regions of them are told as such.

An umbilic is where the vector ((M11 - M22)/2, M12) of the shape operator vanishes. Seeds are the cells of a grid
around which it turns, and its least values; Newton's iteration, with the derivative of the second form, does the rest
(FORMULAS: index by D = ac - c² + bd - b²; Berry and Hannay 1977, Darboux 1896).
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import RIM, along_boundary, index_about
from quintrig.interrogation.umbilic import Region, Type, Umbilic, Umbilics
from quintrig.interrogation.umbilic_search import apart, beside, curve_through, is_flat, seeds_of, umbilics_near
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

_CELLS = 97
_ROUND = 1e-9  # of the scale: a spread of κ1 and κ2 that is rounding
_FLAT = 1e-7  # of 1 / size: a curvature this small is that of a planar point
_FLAT_FORM = 1e-6  # of the square of the derivative: below it, an umbilic is not a simple one
_WEAK = 1e-4  # of the typical curvature by the size: a change of curvature of which rounding may be a part


def umbilics(subject: Surface | Patch | Model) -> Umbilics:
    """Return the umbilics of a surface, or of all patches of a model."""
    unit = subject.unit if isinstance(subject, Model) else ""
    found = [_of_patch(patch) for patch in patches_of(subject)]
    return Umbilics(
        tuple(one for points, _, _, _ in found for one in points),
        tuple(one for _, regions, _, _ in found for one in regions),
        all(regions and regions[0].kind == "region" for _, regions, _, _ in found),
        tuple(told for _, _, told, _ in found if told),
        tuple(note for _, _, _, notes in found for note in notes),
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


Found = tuple[list[Umbilic], list[Region], dict[str, Any], list[str]]


def _of_patch(patch: Patch) -> Found:
    surface, name = patch.surface, patch.name
    if not surface.size > 0.0:
        return [], [], {}, [f"{name}: a single point, which has no curvature"]
    u, v = face_grid(surface, _CELLS + 1, _CELLS + 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, u, v)
        a, b = local.half
    inside = surface.inside(u, v)
    scale = np.abs(local.mean) + local.spread + 1.0 / surface.size
    defined = np.isfinite(local.spread) & inside
    if not defined.any():
        return [], [], {}, [f"{name}: no point has a curvature"]
    typical = float(np.median(scale[defined]))
    if (local.spread[defined] <= _ROUND * scale[defined]).all():
        return [], [_whole(patch, local, defined)], {}, []
    seeds = np.array(seeds_of(u[:, 0], v[0], a, b, scale, inside)).reshape(-1, 2)
    met = [uv for uv in umbilics_near(surface, seeds, typical) if np.isfinite(uv).all()]
    simple: list[FloatArray] = []
    flat: list[FloatArray] = []
    for uv in apart(surface, met):
        (flat if is_flat(surface, uv) else simple).append(uv)
    notes: list[str] = []
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
            regions.append(Region(name, "curve", curvature, line, points))
    others = [uv for uv in simple if not any(beside(surface, uv, region.points) for region in regions)]
    ones = [
        _classified(patch, uv, others, typical)
        for uv in sorted(others, key=lambda uv: (round(uv[0], 9), round(uv[1], 9)))
    ]
    told = _compared(patch, ones, regions)
    if not np.isfinite(local.spread[inside]).all():
        notes.append(f"{name}: has singular points, at which no umbilic is told")
    if told and told["agree"] is False:
        notes.append(f"{name}: the indices do not sum to the rotation along the boundary; look closer at this patch")
    return ones, regions, told, notes


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
        index = index if simple or turned is None else turned
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

    from scipy import optimize

    values = at(t)
    found: list[float] = []
    for k in range(720):
        if values[k] == 0.0:
            found.append(float(t[k]))
        elif values[k] * values[k + 1] < 0.0:
            found.append(float(optimize.brentq(lambda x: float(at(x)), t[k], t[k + 1], xtol=1e-15)))  # pyright: ignore
    return sorted(angle % np.pi for angle in found)


def _compared(patch: Patch, found: Sequence[Umbilic], regions: Sequence[Region]) -> dict[str, Any]:
    """Return the sum of the indices and the rotation along the boundary of the patch, where both mean something."""
    surface = patch.surface
    if regions:
        return {}
    total, free = along_boundary(surface)
    rounded = round(2.0 * total) / 2.0 if np.isfinite(total) and abs(2.0 * total - round(2.0 * total)) < 0.2 else None
    on_rim = any(abs((one.u, one.v)[axis] - end) <= RIM for one in found for axis, end in free)
    summed = float(sum(one.index for one in found))
    known = rounded is not None and bool(np.isfinite(summed)) and not on_rim
    return {
        "patch": patch.name,
        "index_sum": summed if np.isfinite(summed) else None,
        "boundary_rotation": rounded,
        "agree": rounded == summed if known else None,
    }
