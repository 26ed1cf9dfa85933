"""Sections by planes and by other surfaces, and parameter lines."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation import fields
from quintrig.interrogation.ask import Ask, few, length, vector
from quintrig.interrogation.found import COUNT, Found, Level, Make, as_lines, bent, level_lines
from quintrig.interrogation.local import dot
from quintrig.interrogation.polyline import Path
from quintrig.interrogation.subject import Subject
from quintrig.support.arrays import FloatArray, frozen, parameter, whole


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
    wanted = [Level(x, f"plane at {x:.6g}{' ' + on.unit if on.unit else ''}", x) for x in places]
    return level_lines(on, lambda s: fields.plane_scalar(s, normal), wanted, bent(on), fields.normal_curvature)


def _stack(on: Subject, ask: Ask, normal: FloatArray, first: float) -> list[float]:
    """Return the places n · x of a stack of planes through all of the model, or of ``count`` of them."""
    t = np.linspace(0.0, 1.0, 65)
    heights = np.concatenate([dot(s(t[:, None], t[None, :]), normal).ravel() for s in on.surfaces])
    low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
    if ask.spacing is None:
        count = whole(COUNT if ask.count is None else ask.count, "count", 1)
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
    found = bent(on)
    for other in others:
        make: Make = lambda s, o=other: fields.other_scalar(s, o.surface)  # noqa: E731
        part = level_lines(
            on, make, [Level(0.0, f"with {other.name}")], bent(on), fields.normal_curvature, f"lies on {other.name}"
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
    found = bent(on)
    for axis, values in ((0, us), (1, vs)):
        if values is None:
            continue
        fixed = np.atleast_1d(parameter(values, "uv"[axis]))
        few(len(fixed), "uv"[axis], "ask for fewer")
        for number, patch in enumerate(on.patches):
            for at in fixed.tolist():
                path = _iso_path(patch.surface, number, axis, at, on.chord)
                label = f"{'uv'[axis]} = {at:g}"
                found.lines += as_lines(patch, [path], label, fields.normal_curvature, at)
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
