"""Umbilics: points where κ1 = κ2, with index and type; curves and regions of them are told as such.

An umbilic is where the vector ((M11 - M22)/2, M12) of the shape operator vanishes. Seeds are the cells of a grid
around which it turns, and its least values; Newton's iteration, with the derivative of the second form, does the rest
(FORMULAS: index by D = ac - c² + bd - b²; Berry and Hannay 1977, Darboux 1896).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.interrogation.local import Local
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.pickled import Pickled

_CELLS = 97
_STEPS = 60
_ROUND = 1e-9  # of the scale: a spread of κ1 and κ2 that is rounding
_MET = 1e-8  # of the scale: what is left of it at an umbilic
_FLAT = 1e-7  # of 1 / size: a curvature this small is that of a planar point
_POLE = 1e-6  # of the square of the size: |S_u × S_v| at which a point counts as a pole
_ONE = 1e-6  # of the size: umbilics this near are one
_FLAT_FORM = 1e-6  # of the square of the derivative: below it, an umbilic is not a simple one
_WEAK = 1e-4  # of the typical curvature by the size: a change of curvature of which rounding may be a part
_AROUND = 720
_RIM = 1e-9  # of parameters or of the size: on the boundary
_INSET = 1e-3  # from a pole, where the rotation around it is taken

Type = Literal["star", "lemon", "monstar", "planar", "other"]


@dataclass(frozen=True, eq=False)
class Umbilic(Pickled):
    """An isolated umbilic: parameters, point (3,), curvature κ1 = κ2 (1/length), index and type.

    ``directions`` are the angles in degrees from S_u in which lines of curvature leave it.
    """

    patch: str
    u: float
    v: float
    point: FloatArray
    curvature: float
    index: float
    type: Type
    directions: tuple[float, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        return {
            "patch": self.patch,
            "u": self.u,
            "v": self.v,
            "point": self.point.tolist(),
            "curvature": self.curvature,
            "index": self.index,
            "type": self.type,
            "directions": list(self.directions),
        }


@dataclass(frozen=True, eq=False)
class Region(Pickled):
    """Umbilics that are not isolated: all of a patch (``region``), or along a line in (u, v), (n, 2) (``curve``)."""

    patch: str
    kind: Literal["region", "curve"]
    curvature: float
    uv: FloatArray
    points: FloatArray

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        return {
            "patch": self.patch,
            "kind": self.kind,
            "curvature": self.curvature,
            "uv": self.uv.tolist(),
            "points": self.points.tolist(),
        }


@dataclass(frozen=True, eq=False)
class Umbilics(Pickled):
    """What there is on the patches of a model; ``sums`` compares, by patch, the indices with the boundary's rotation.

    ``complete`` is true only where a proof says that there are no others.
    """

    umbilics: tuple[Umbilic, ...]
    regions: tuple[Region, ...]
    complete: bool
    sums: tuple[dict[str, Any], ...]
    notes: tuple[str, ...]
    unit: str = ""

    def __len__(self) -> int:
        """Return the number of isolated umbilics."""
        return len(self.umbilics)

    def __repr__(self) -> str:
        """Return one line: how many."""
        return f"<Umbilics: {len(self)} isolated, {len(self.regions)} curves and regions, complete: {self.complete}>"

    def to_dict(self) -> dict[str, Any]:
        """Return everything as plain values, to go through JSON."""
        return {
            "umbilics": [one.to_dict() for one in self.umbilics],
            "complete": self.complete,
            "regions": [one.to_dict() for one in self.regions],
            "index_sums": list(self.sums),
            "unit": self.unit,
            "notes": list(self.notes),
        }


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
    seeds = np.array(_seeds(u[:, 0], v[0], a, b, scale, inside)).reshape(-1, 2)
    met = [uv for uv in _newton(surface, seeds, typical) if np.isfinite(uv).all()]
    simple: list[FloatArray] = []
    flat: list[FloatArray] = []
    for uv in _apart(surface, met):
        (flat if _is_flat(surface, uv) else simple).append(uv)
    notes: list[str] = []
    regions: list[Region] = []
    for uv in flat:
        if any(_near(surface, uv, region.points) for region in regions):
            continue
        line = _curve(surface, uv, typical)
        if line is None:
            simple.append(uv)
        else:
            points = surface(*line.T)
            curvature = float(Local.at(surface, *line[len(line) // 2]).mean)
            regions.append(Region(name, "curve", curvature, line, points))
    others = [uv for uv in simple if not any(_near(surface, uv, region.points) for region in regions)]
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


def _seeds(
    u: FloatArray, v: FloatArray, a: FloatArray, b: FloatArray, scale: FloatArray, inside: np.ndarray[Any, Any]
) -> list[FloatArray]:
    """Return where to begin: cells around which the vector turns, and where its length is least among neighbours."""
    angle = np.arctan2(b, a)
    ring = [angle[:-1, :-1], angle[1:, :-1], angle[1:, 1:], angle[:-1, 1:]]
    turn = sum(_wrapped(ring[(k + 1) % 4] - ring[k]) for k in range(4))
    near = inside[:-1, :-1] | inside[1:, :-1] | inside[1:, 1:] | inside[:-1, 1:]
    found = [
        np.array([0.5 * (u[i] + u[i + 1]), 0.5 * (v[j] + v[j + 1])])
        for i, j in np.argwhere((np.abs(turn) > 1.0) & near).tolist()
    ]
    share = np.pad(np.where(np.isfinite(a), np.hypot(a, b) / scale, np.inf), 1, constant_values=np.inf)
    middle: FloatArray = share[1:-1, 1:-1]
    least = np.isfinite(middle) & (middle < 0.3) & inside
    for di in (-1, 0, 1):
        for dj in (-1, 0, 1):
            if di or dj:
                least &= middle <= share[1 + di : share.shape[0] - 1 + di, 1 + dj : share.shape[1] - 1 + dj]
    order = sorted(np.argwhere(least).tolist(), key=lambda place: middle[place[0], place[1]])
    return found + [np.array([u[i], v[j]]) for i, j in order[:200]]


def _wrapped(angle: FloatArray) -> FloatArray:
    return (angle + np.pi) % (2.0 * np.pi) - np.pi


def _newton(surface: Surface, seeds: FloatArray, typical: float) -> list[FloatArray]:
    """Return the umbilics (2,) near seeds (n, 2) that lie on the face and not at a pole; NaN (2,) where none is met."""
    uv = seeds.copy()
    best, least = uv.copy(), np.full(len(uv), np.inf)
    for _ in range(_STEPS):
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(surface, *uv.T, order=3)
            value = np.stack(local.half, axis=-1)
            size = np.hypot(*value.T)
            better = size < least
            best, least = np.where(better[:, None], uv, best), np.where(better, size, least)
            matrix = _derivative(local)
            usable = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(size)
            u, s, vt = np.linalg.svd(np.where(usable[:, None, None], matrix, 0.0))
            inverse = np.where(s > 1e-7 * s[:, :1], 1.0 / s, 0.0)
            step = -np.einsum("nji,nj,nkj,nk->ni", vt, inverse, u.transpose(0, 2, 1), value)
            p, q, r = local.frame
            move = np.stack([p * step[:, 0] + q * step[:, 1], r * step[:, 1]], axis=1)
            reach = np.abs(move).max(axis=1)
            move *= np.where(reach > 0.05, 0.05 / reach, 1.0)[:, None]
        going = np.asarray(np.isfinite(move).all(axis=1)) & np.asarray(size > 1e-15 * typical)
        move = np.where(going[:, None], move, 0.0)
        moved = np.clip(uv + move, 0.0, 1.0)
        if np.abs(moved - uv).max(initial=0.0) <= 1e-16:
            break
        uv = moved
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, *best.T)
        met = least <= _MET * np.maximum(np.abs(local.mean) + 1.0 / surface.size, typical)
        met &= (local.area > _POLE * surface.size**2) & surface.inside(*best.T)
    return [one if good else np.full(2, np.nan) for one, good in zip(best, met.tolist(), strict=True)]


def _derivative(local: Local) -> FloatArray:
    """Return the derivatives of ((M11 - M22)/2, M12) along e1 and e2, (..., 2, 2), 1/length²; true at umbilics."""
    a, b, c, d = local.cubic
    return np.stack([np.stack([0.5 * (a - c), 0.5 * (b - d)], axis=-1), np.stack([b, c], axis=-1)], axis=-2)


def _is_flat(surface: Surface, uv: FloatArray) -> bool:
    local = Local.at(surface, *uv, order=3)
    singular = np.linalg.svd(_derivative(local), compute_uv=False)
    scale = max(abs(float(local.mean)), 1.0 / surface.size) / surface.size
    return bool(singular[1] <= 1e-4 * max(float(singular[0]), scale))


def _apart(surface: Surface, found: Sequence[FloatArray]) -> list[FloatArray]:
    kept: list[FloatArray] = []
    points: list[FloatArray] = []
    for uv in found:
        point = surface(*uv)
        if not any(np.linalg.norm(point - other) <= _ONE * surface.size for other in points):
            kept.append(uv)
            points.append(point)
    return kept


def _near(surface: Surface, uv: FloatArray, points: FloatArray) -> bool:
    apart = np.linalg.norm(points - surface(*uv), axis=1)
    step = np.linalg.norm(np.diff(points, axis=0), axis=1).max(initial=0.0)
    return bool(apart.min() <= max(step, _ONE * surface.size))


def _curve(surface: Surface, uv: FloatArray, typical: float) -> FloatArray | None:
    """Return the curve of umbilics (n, 2) through one whose derivative is singular; None where it is isolated."""
    halves: list[list[FloatArray]] = []
    stride = 0.01 * surface.size
    for sense in (1.0, -1.0):
        here, before, line = uv, None, [uv]
        for _ in range(2000):
            local = Local.at(surface, *here, order=3)
            _, s, vt = np.linalg.svd(_derivative(local))
            if not s[0] > 0.0:
                break
            p, q, r = (float(x) for x in local.frame)
            way = np.array([p * vt[1, 0] + q * vt[1, 1], r * vt[1, 1]])
            space = local.lifted(way)
            turned = sense if before is None else np.sign(float(space @ before)) or 1.0
            following = _newton(surface, np.clip(here + turned * stride * way, 0.0, 1.0)[None, :], typical)[0]
            if not np.isfinite(following).all():
                break
            if not 0.2 * stride < np.linalg.norm(surface(*following) - surface(*here)) < 3.0 * stride:
                break
            line.append(following)
            here, before = following, turned * space
            if len(line) > 8 and np.linalg.norm(surface(*here) - surface(*uv)) < stride:
                line.append(uv)
                return np.array(line)
        halves.append(line)
    whole = np.array([*reversed(halves[1]), *halves[0][1:]])
    return whole if len(whole) >= 6 else None


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
        turned = _rotation_about(surface, uv, others)
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


def _rotation_about(surface: Surface, uv: FloatArray, others: Sequence[FloatArray]) -> float | None:
    """Return the index by turning once around an umbilic, at a distance where it is alone; None on an edge."""
    alone = [float(np.abs(uv - other).max()) for other in others if other is not uv]
    reach = min(1e-2, *(0.3 * apart for apart in alone)) if alone else 1e-2
    reach = min([reach, *(x for x in (*uv, *(1.0 - uv)) if x > 1e-9)])
    angle = np.linspace(0.0, 2.0 * np.pi, _AROUND + 1)
    ring = uv + reach * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    inside = ((ring >= 0.0) & (ring <= 1.0)).all(axis=1)
    if not inside.all():
        return None
    found = _rotation(surface, ring)
    return found if np.isfinite(found) else None


def _rotation(surface: Surface, ring: FloatArray) -> float:
    """Return the turns of the principal directions, against e1, along a closed line (n, 2) of parameters."""
    turned = _turned(surface, ring)
    return round(2.0 * turned) / 2.0 if np.isfinite(turned) else turned


def _turned(surface: Surface, line: FloatArray) -> float:
    """Return the turn of the principal directions against e1 along a line (n, 2); NaN where it cannot be told."""
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = Local.at(surface, *line.T).half
    turn = _wrapped(np.diff(np.arctan2(b, a)))
    if not np.isfinite(turn).all() or np.abs(turn).max() > 2.5:
        return float("nan")
    return float(turn.sum()) / (4.0 * np.pi)


def _compared(patch: Patch, found: Sequence[Umbilic], regions: Sequence[Region]) -> dict[str, Any]:
    """Return the sum of the indices and the rotation along the boundary of the patch, where both mean something."""
    surface = patch.surface
    if regions:
        return {}
    total, free = _along_loops(surface) if surface.trim else _along_sides(surface)
    rounded = round(2.0 * total) / 2.0 if np.isfinite(total) and abs(2.0 * total - round(2.0 * total)) < 0.2 else None
    on_rim = any(abs((one.u, one.v)[axis] - end) <= _RIM for one in found for axis, end in free)
    summed = float(sum(one.index for one in found))
    known = rounded is not None and bool(np.isfinite(summed)) and not on_rim
    return {
        "patch": patch.name,
        "index_sum": summed if np.isfinite(summed) else None,
        "boundary_rotation": rounded,
        "agree": rounded == summed if known else None,
    }


def _along_loops(surface: Surface) -> tuple[float, list[tuple[int, float]]]:
    """Return the rotation along the loops of a face, each with the face on its left."""
    loops = [_dense(loop) for loop in surface.trim]
    areas = [_area(loop) for loop in loops]
    outer = int(np.argmax(np.abs(areas)))
    senses = [(1.0 if area > 0.0 else -1.0) * (1.0 if k == outer else -1.0) for k, area in enumerate(areas)]
    return sum(sense * _turned(surface, loop) for sense, loop in zip(senses, loops, strict=True)), []


def _along_sides(surface: Surface) -> tuple[float, list[tuple[int, float]]]:
    """Return the rotation along the sides of the domain, and the sides (axis, end) that count.

    The two sides of a seam, where a closed surface meets itself, cancel. Beside a pole the side is moved inwards.
    """
    t = np.linspace(0.0, 1.0, 2001)
    total, free = 0.0, list[tuple[int, float]]()
    ends = {(axis, end): _side(axis, end, t) for axis in (0, 1) for end in (0.0, 1.0)}
    points = {key: surface(*line.T) for key, line in ends.items()}
    poles = {key: bool(np.linalg.norm(np.ptp(p, axis=0)) <= _RIM * surface.size) for key, p in points.items()}
    low, high = (
        np.array([_INSET if poles[axis, 0.0] else 0.0 for axis in (0, 1)]),
        np.array([1.0 - _INSET if poles[axis, 1.0] else 1.0 for axis in (0, 1)]),
    )
    for (axis, end), line in ends.items():
        if np.abs(points[axis, 0.0] - points[axis, 1.0]).max() <= _RIM * surface.size and not poles[axis, end]:
            continue
        sense = 1.0 if (axis == 0) == (end == 1.0) else -1.0  # against the clock: up at u = 1, back at v = 1
        total += sense * _turned(surface, low + line * (high - low))
        free.append((axis, end))
    return total, free


def _side(axis: int, end: float, t: FloatArray) -> FloatArray:
    same = np.full(len(t), end)
    return np.stack([same, t] if axis == 0 else [t, same], axis=1)


def _dense(loop: FloatArray) -> FloatArray:
    closed = np.concatenate([loop, loop[:1]])
    share = np.linspace(0.0, 1.0, 33)[:-1]
    between = closed[:-1, None] + share[None, :, None] * np.diff(closed, axis=0)[:, None]
    return np.concatenate([between.reshape(-1, 2), closed[:1]])


def _area(loop: FloatArray) -> float:
    x, y = loop.T
    return 0.5 * float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
