"""The kinds of lines that are level sets of a scalar, and parameter lines."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.interrogation import fields
from quintrig.interrogation.ask import Ask, degrees, few, length, vector
from quintrig.interrogation.levels import Grid, Scalar
from quintrig.interrogation.line import Line
from quintrig.interrogation.local import dot
from quintrig.interrogation.polyline import Path, Values, line_of
from quintrig.interrogation.ridges import NAMES, ridges
from quintrig.interrogation.subject import Subject
from quintrig.model.patch import Patch
from quintrig.quantities.table import quantity
from quintrig.support.arrays import FloatArray, frozen, parameter, whole

_COUNT = 10  # levels where nothing else is asked for
_UP = (0.0, 0.0, 1.0)
_NOISE = 1e-10  # of C to the power of the quantity: a curvature that is rounding
_SAME = 1e-13  # of the size of the values: a scalar that does not vary


@dataclass(eq=False)
class Found:
    """Lines, what their values are, and what is to be told; ``traced`` lines have their chain numbers already."""

    quantity: str
    unit: str
    lines: list[Line] = field(default_factory=list[Line])
    notes: list[str] = field(default_factory=list[str])
    traced: bool = False


@dataclass(frozen=True)
class _Level:
    value: float
    label: str
    told: float | None = None


Make = Callable[[Surface], Scalar]


def _levels(on: Subject, make: Make, wanted: Sequence[_Level], found: Found, values: Values, vanish: str = "") -> Found:
    """Add the lines of all levels on all patches; ``vanish`` is said of a patch on which the scalar is a level."""
    few(len(wanted), "levels", "ask for fewer")
    for number, patch in enumerate(on.patches):
        surface = patch.surface
        grid = Grid.of(surface, make(surface))
        f, g, _ = grid.parts
        size = float(np.nanmax(np.abs(f), initial=0.0)) + float(np.nanmax(np.abs(g), initial=0.0))
        for k, level in enumerate(wanted):
            on.tell(f"{patch.name}: {level.label}", number * len(wanted) + k, len(on.patches) * len(wanted))
            here = grid.values(level.value)
            inside = np.isfinite(here) & surface.inside(grid.u[:, None], grid.v[None, :])
            if inside.any() and np.abs(here[inside]).max() <= _SAME * size:
                found.notes.append(f"{patch.name}: {vanish or level.label} on the whole patch, which is no line")
                continue
            paths = grid.paths(number, surface, level.value, on.chord)
            found.lines += _as_lines(patch, paths, level.label, values, level.told)
    if not found.lines and not found.notes:
        found.notes.append("the model has no such line")
    return found


def _as_lines(
    patch: Patch, paths: Sequence[Path], label: str, values: Values, told: float | None = None, strength: bool = False
) -> Iterator[Line]:
    for path in paths:
        for part in path.cut(patch.surface):
            yield line_of(patch.surface, patch.name, part, label, values, level=told, strength=strength)


def of_quantity(key: str) -> Values:
    """Return the values of a quantity of the table along a line."""
    return lambda surface, uv: analyse(surface, uv[:, 0], uv[:, 1], (key,), threads=1)[key]


def _curvature(on: Subject, key: str, other: str, power: int, name: str) -> Found:
    """Return where a curvature is 0; patches on which it is rounding everywhere are told."""
    found = Found(other, on.measure(quantity(other).power))
    kept: list[int] = []
    t = np.linspace(0.0, 1.0, 33)
    for number, patch in enumerate(on.patches):
        sample = analyse(patch.surface, t[:, None], t[None, :], (key, "curvedness"), threads=1)
        values, curved = np.abs(sample[key]), sample["curvedness"]
        good = np.isfinite(values)
        most = float(np.max(curved[good], initial=0.0))
        if good.any() and (values[good] <= _NOISE * most**power).all():
            found.notes.append(f"{patch.name}: {name} = 0 on the whole patch, which is no line")
        else:
            kept.append(number)
    part = replace(on, patches=tuple(on.patches[k] for k in kept))
    return _levels(
        part, lambda s: fields.quantity_scalar(s, key), [_Level(0.0, f"{name} = 0", 0.0)], found, of_quantity(other)
    )


def parabolic(on: Subject, ask: Ask) -> Found:
    """K = 0, with H along it."""
    return _curvature(on, "gaussian", "mean", 2, "K")


def mean_zero(on: Subject, ask: Ask) -> Found:
    """H = 0, with K along it."""
    return _curvature(on, "mean", "gaussian", 1, "H")


def ridge_lines(on: Subject, ask: Ask) -> Found:
    """Crests and troughs, with their principal curvature."""
    found = Found("principal curvature", on.measure(-1))
    for number, patch in enumerate(on.patches):
        for family in _families(ask):
            on.tell(f"{patch.name}: {NAMES[family]}s", 2 * number + family - 1, 2 * len(on.patches))
            paths = ridges(patch.surface, number, family, on.chord)
            if paths is None:
                found.notes.append(f"{patch.name}: κ{family} is constant along its lines of curvature")
                continue
            values = of_quantity(f"k{family}")
            found.lines += _as_lines(patch, paths, NAMES[family], values, strength=True)
    if not found.lines:
        found.notes.append("the model has no crest and no trough")
    found.lines.sort(key=lambda line: -(line.strength or 0.0))
    return found


def _families(ask: Ask) -> tuple[int, ...]:
    if ask.family is None:
        return (1, 2)
    if ask.family not in (1, 2):
        raise ValueError(f"family: expected 1 (that of κ1) or 2 (that of κ2), found {ask.family}")
    return (ask.family,)


def _angle(direction: FloatArray, draft: bool) -> Values:
    """Return the angle of the normal to a direction, or of the tangent plane (draft), degrees."""
    offset = 90.0 if draft else 0.0
    sense = -1.0 if draft else 1.0

    def values(surface: Surface, uv: FloatArray) -> FloatArray:
        cosine = fields.normal_scalar(surface, direction)(*uv.T)[0]
        return offset + sense * np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))

    return values


def _direction(ask: Ask, usual: Sequence[float] | None = _UP) -> FloatArray:
    if ask.direction is None and usual is None:
        raise ValueError("direction: expected a vector X,Y,Z, found none")
    return vector(usual if ask.direction is None else ask.direction, "direction")


def isophotes(on: Subject, ask: Ask) -> Found:
    """Equal angle between the normal and the light: every 10 degrees, or at given angles."""
    direction = _direction(ask)
    if ask.angles is not None:
        angles = degrees(ask.angles, "angles", 0.0, 180.0)
    else:
        count = 17 if ask.count is None else whole(ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        angles = np.linspace(0.0, 180.0, count + 2)[1:-1]
    wanted = [_Level(float(np.cos(np.radians(a))), f"{a:g}°", a) for a in angles.tolist()]
    found = Found("angle to the light", "°")
    return _levels(on, lambda s: fields.normal_scalar(s, direction), wanted, found, _angle(direction, False))


def draft(on: Subject, ask: Ask) -> Found:
    """Equal draft angle, that of the tangent plane with the pull direction, + where the normal points along it."""
    direction = _direction(ask)
    angles = degrees((-5.0, -3.0, 0.0, 3.0, 5.0) if ask.angles is None else ask.angles, "angles", -90.0, 90.0)
    wanted = [_Level(float(np.sin(np.radians(a))), f"{a:g}°", a) for a in angles.tolist()]
    found = Found("draft angle", "°")
    return _levels(on, lambda s: fields.normal_scalar(s, direction), wanted, found, _angle(direction, True))


def _bent(on: Subject) -> Found:
    return Found("normal curvature", on.measure(-1))


def silhouette(on: Subject, ask: Ask) -> Found:
    """The outline seen along a direction, or from a point."""
    if ask.eye is not None and ask.direction is not None:
        raise ValueError("eye: expected either an eye (a point) or a direction, found both")
    level = [_Level(0.0, "silhouette")]
    if ask.eye is not None:
        eye = frozen(ask.eye, "eye", (3,))
        return _levels(on, lambda s: fields.facing_scalar(s, eye), level, _bent(on), fields.normal_curvature)
    direction = _direction(ask, None)
    return _levels(on, lambda s: fields.normal_scalar(s, direction), level, _bent(on), fields.normal_curvature)


def _lights(on: Subject, ask: Ask) -> tuple[FloatArray, FloatArray, list[_Level], FloatArray]:
    """Return a point of the middle light, the lights' direction, their places, and where they are moved."""
    centre = 0.5 * (on.low + on.high)
    light = centre + np.array([0.0, 0.0, 2.0 * on.size]) if ask.light is None else frozen(ask.light, "light", (3,))
    along = vector((0.0, 1.0, 0.0) if ask.along is None else ask.along, "along")
    count = whole(11 if ask.count is None else ask.count, "count", 1)
    few(count, "count", "ask for fewer")
    spacing = length(ask.spacing, "spacing", 0.2 * on.size)
    places = (np.arange(count) - 0.5 * (count - 1)) * spacing
    across = fields.sideways(centre, on.size, light, along)
    return light, along, [_Level(x, f"light {k + 1}", x) for k, x in enumerate(places.tolist())], across


def highlight(on: Subject, ask: Ask) -> Found:
    """Where the normal, as a line without end, meets a line of light."""
    light, along, wanted, across = _lights(on, ask)
    make: Make = lambda s: fields.lights_scalar(s, light, along, across, None)  # noqa: E731
    return _levels(on, make, wanted, _bent(on), fields.normal_curvature)


def reflection(on: Subject, ask: Ask) -> Found:
    """Parallel lights as an eye sees them in the surface: from a point, or from afar."""
    light, along, wanted, across = _lights(on, ask)
    if ask.eye is not None and ask.direction is not None:
        raise ValueError("eye: expected either an eye (a point) or a direction towards it, found both")
    afar = vector((1.0, 0.0, 1.0) if ask.direction is None else ask.direction, "direction")
    eye = None if ask.eye is None else frozen(ask.eye, "eye", (3,))

    def view(points: FloatArray) -> FloatArray:
        if eye is None:
            return np.broadcast_to(afar, points.shape)
        ray = eye - points
        return ray / np.linalg.norm(ray, axis=-1)[..., None]

    make: Make = lambda s: fields.lights_scalar(s, light, along, across, view)  # noqa: E731
    return _levels(on, make, wanted, _bent(on), fields.normal_curvature)


def contour(on: Subject, ask: Ask) -> Found:
    """A quantity of the table at given values, or at ten between its least and greatest."""
    if ask.quantity is None:
        raise ValueError("quantity: expected a quantity such as gaussian, found none")
    q = quantity(ask.quantity)
    if q.kind != "scalar":
        raise ValueError(f"quantity: expected one with a number at every point, found {q.key}, a {q.kind}")
    if ask.levels is not None:
        levels = frozen(ask.levels, "levels", (None,))
    else:
        count = whole(_COUNT if ask.count is None else ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        t = np.linspace(0.0, 1.0, 65)
        found = [analyse(s, t[:, None], t[None, :], (q.key,), threads=1)[q.key].ravel() for s in on.surfaces]
        values = np.concatenate(found)
        values = values[np.isfinite(values)]
        low, high = (0.0, 0.0) if not len(values) else np.percentile(values, (1.0, 99.0)).tolist()
        levels = np.linspace(low, high, count + 2)[1:-1]
    unit = q.unit(on.unit)
    wanted = [_Level(x, f"{q.symbol} = {x:.6g}{' ' + unit if unit else ''}", x) for x in dict.fromkeys(levels.tolist())]
    return _levels(on, lambda s: fields.quantity_scalar(s, q.key), wanted, Found(q.name, unit), of_quantity(q.key))


def section(on: Subject, ask: Ask) -> Found:
    """Cut by a plane, by a stack of planes, or by another surface."""
    if ask.other is not None:
        for name in ("normal", "through", "spacing", "count"):
            if getattr(ask, name) is not None:
                raise ValueError(f"{name}: expected planes or another surface, found both")
        return _by_surface(on, ask)
    if ask.normal is None:
        raise ValueError("normal: expected the normal X,Y,Z of the planes, or another surface, found none")
    normal = vector(ask.normal, "normal")
    centre = 0.5 * (on.low + on.high)
    first = float((centre if ask.through is None else frozen(ask.through, "through", (3,))) @ normal)
    places = [first] if ask.spacing is None and ask.count is None else _stack(on, ask, normal, first)
    wanted = [_Level(x, f"plane at {x:.6g}{' ' + on.unit if on.unit else ''}", x) for x in places]
    return _levels(on, lambda s: fields.plane_scalar(s, normal), wanted, _bent(on), fields.normal_curvature)


def _stack(on: Subject, ask: Ask, normal: FloatArray, first: float) -> list[float]:
    """Return the places n · x of a stack of planes through all of the model, or of ``count`` of them."""
    t = np.linspace(0.0, 1.0, 65)
    heights = np.concatenate([dot(s(t[:, None], t[None, :]), normal).ravel() for s in on.surfaces])
    low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
    if ask.spacing is None:
        count = whole(_COUNT if ask.count is None else ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        return [float(x) for x in np.linspace(low, high, count + 2)[1:-1]]
    spacing = length(ask.spacing, "spacing", 1.0)
    if ask.count is not None:
        count = whole(ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        return (first + spacing * np.arange(count)).tolist()
    few((high - low) / spacing, "spacing", "take a larger one")
    below, above = np.ceil((low - first) / spacing), np.floor((high - first) / spacing)
    return [float(first + spacing * k) for k in range(int(below), int(above) + 1)]


def _by_surface(on: Subject, ask: Ask) -> Found:
    from quintrig.interrogation.umbilics import patches_of

    others = patches_of(ask.other)  # pyright: ignore[reportArgumentType]
    found = _bent(on)
    for other in others:
        make: Make = lambda s, o=other: fields.other_scalar(s, o.surface)  # noqa: E731
        part = _levels(
            on, make, [_Level(0.0, f"with {other.name}")], _bent(on), fields.normal_curvature, f"lies on {other.name}"
        )
        found.lines += part.lines
        found.notes += [note for note in part.notes if "no such line" not in note]
    if not found.lines and not found.notes:
        found.notes.append("the surfaces do not meet")
    return found


def iso(on: Subject, ask: Ask) -> Found:
    """Lines of constant u, and of constant v."""
    us, vs = ask.u, ask.v
    if us is None and vs is None:
        count = whole(7 if ask.count is None else ask.count, "count", 1)
        us = vs = np.linspace(0.0, 1.0, count + 2)[1:-1].tolist()
    elif ask.count is not None:
        raise ValueError("count: expected a count, or u and v, found both")
    found = _bent(on)
    for axis, values in ((0, us), (1, vs)):
        if values is None:
            continue
        fixed = np.atleast_1d(parameter(values, "uv"[axis]))
        few(len(fixed), "uv"[axis], "ask for fewer")
        for number, patch in enumerate(on.patches):
            for at in fixed.tolist():
                path = _iso_path(patch.surface, number, axis, at, on.chord)
                label = f"{'uv'[axis]} = {at:g}"
                found.lines += _as_lines(patch, [path], label, fields.normal_curvature, at)
    return found


def _iso_path(surface: Surface, number: int, axis: int, at: float, chord: float) -> Path:
    """Return a parameter line with as many points as its chords need, between the breaks of the surface."""
    t = np.unique(np.concatenate([np.linspace(0.0, 1.0, 9), surface.breaks(1 - axis)]))
    while True:
        fine = np.empty(2 * len(t) - 1)
        fine[::2], fine[1::2] = t, 0.5 * (t[1:] + t[:-1])
        uv = np.stack([np.full(len(fine), at), fine] if axis == 0 else [fine, np.full(len(fine), at)], axis=1)
        points = surface(*uv.T)
        off = np.linalg.norm(points[1::2] - 0.5 * (points[:-1:2] + points[2::2]), axis=1)
        if np.nanmax(off, initial=0.0) <= chord or len(t) > 4096:
            same = np.linalg.norm(points[0] - points[-1]) <= 1e-9 * surface.size
            return Path(number, uv[::2], uv[1::2], bool(same))
        t = np.sort(np.concatenate([t, (0.5 * (t[1:] + t[:-1]))[off > chord]]))
