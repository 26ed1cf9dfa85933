"""The kinds of lines that follow a flow: nets, lines through a point, those that leave umbilics, geodesics."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.ask import MOST, Ask, few, length, place, vector
from quintrig.interrogation.fields import normal_curvature
from quintrig.interrogation.flows import ASYMPTOTIC_DIRECTIONS, GEODESICS, PRINCIPAL_DIRECTIONS, Flow
from quintrig.interrogation.follow import Curve, both_ways
from quintrig.interrogation.found import Found, of_quantity
from quintrig.interrogation.geodesics import between, from_point, tangent
from quintrig.interrogation.line_jit import ENDED, NO_DIRECTION
from quintrig.interrogation.local import Local
from quintrig.interrogation.nets import Net
from quintrig.interrogation.polyline import Values, line_of
from quintrig.interrogation.subject import Subject
from quintrig.interrogation.trace import Seed, Tracer
from quintrig.interrogation.umbilics import umbilics
from quintrig.support.arrays import FloatArray

_SPACING = 1.0 / 12.0  # of the size
_LENGTH = 10.0  # of the size: lines that do not close end there
_LONGEST = 1000.0  # of the size
_NET = 1e-9  # relative error of the steps of a net
_BESIDE = 1e-3  # of the size: from an umbilic, where a line that leaves it is begun

_LABELS = {1: "κ1", 2: "κ2"}
_SIDES = {1: "family 1", 2: "family 2"}


def curvature(on: Subject, ask: Ask) -> Found:
    """Lines of curvature, with their principal curvature."""
    found = Found("principal curvature", on.measure(-1), traced=True)
    if ask.umbilics:
        for name in ("start", "spacing"):
            if getattr(ask, name) is not None:
                raise ValueError(f"{name}: expected the lines that leave umbilics, or others, found both")
        return _leaving(on, ask, found)
    values = {mode: of_quantity(f"k{mode}") for mode in (1, 2)}
    return _of_flow(on, ask, PRINCIPAL_DIRECTIONS, found, _LABELS, values)


def asymptotic(on: Subject, ask: Ask) -> Found:
    """Asymptotic lines, with K."""
    found = Found("Gaussian curvature", on.measure(-2), traced=True)
    values = of_quantity("gaussian")
    found = _of_flow(on, ask, ASYMPTOTIC_DIRECTIONS, found, _SIDES, {1: values, 2: values})
    if not found.lines:
        found.notes.append("there are asymptotic lines only where K < 0")
    return found


def _of_flow(
    on: Subject, ask: Ask, flow: Flow, found: Found, labels: dict[int, str], values: dict[int, Values]
) -> Found:
    reach = _reach(on, ask)
    families = (1, 2) if ask.family is None else (ask.family,)
    if any(family not in (1, 2) for family in families):
        raise ValueError(f"family: expected 1 or 2, found {ask.family}")
    if ask.start is not None:
        if ask.spacing is not None:
            raise ValueError(
                "spacing: expected a start, whose two lines are drawn, or the spacing of a net, found both"
            )
        at, patch = place(ask.start, "start"), on.number(ask.patch)
        _refuse_outside(on, patch, at)
        tracer = Tracer(on.surfaces, flow, on.chord)
        _refuse_no_direction(tracer, patch, at)
        curves = both_ways(tracer, [(patch, at, family) for family in families], reach)
    else:
        part = on if ask.patch is None else _only(on, ask.patch)
        curves, on = _net(part, ask, flow, reach), part
        curves = [curve for curve in curves if curve.modes[0] in families]
        if not curves and flow is PRINCIPAL_DIRECTIONS:
            found.notes.append("there is no line of curvature: every point is an umbilic, or singular")
    return _written(on, curves, found, labels, values)


def _only(on: Subject, name: str) -> Subject:
    return replace(on, patches=(on.patches[on.number(name)],))


def _reach(on: Subject, ask: Ask) -> float:
    reach = length(ask.length, "length", _LENGTH * on.size)
    if reach > _LONGEST * on.size:
        raise ValueError(
            f"length: expected at most {_LONGEST:g} times the size, {_LONGEST * on.size:.6g}, found {reach:g}"
        )
    return reach


def _refuse_outside(on: Subject, patch: int, at: FloatArray) -> None:
    if not bool(on.surfaces[patch].inside(*at)):
        name = on.patches[patch].name
        raise ValueError(f"start: expected a point of the face {name!r}, found {at[0]:g},{at[1]:g} outside its trim")


def _refuse_no_direction(tracer: Tracer, patch: int, at: FloatArray) -> None:
    """Raise ValueError where the flow has no direction at a start."""
    surface, name = tracer.surfaces[patch], f"{at[0]:g},{at[1]:g}"
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, *at)
        area, K = float(local.area), float(local.gaussian)
    if not np.isfinite(area) or not np.isfinite(K):
        raise ValueError(f"start: {name} is a singular point of the surface; begin beside it")
    if tracer.flow is ASYMPTOTIC_DIRECTIONS and not K < 0.0:
        raise ValueError(f"start: {name} has K = {K:.3g}, and asymptotic lines run only where K < 0; begin there")
    if tracer.begun([Seed(patch, at, mode=tracer.flow.modes[0])])[0, ENDED] == NO_DIRECTION:
        raise ValueError(
            f"start: {name} is an umbilic, where directions have no sense; begin beside it, or ask for umbilics"
        )


def _net(on: Subject, ask: Ask, flow: Flow, reach: float) -> list[Curve]:
    spacing = length(ask.spacing, "spacing", _SPACING * on.size)
    few(2.0 * on.size / spacing, "spacing", f"take at least {2.0 * on.size / MOST:.3g}")
    tracer = Tracer(on.surfaces, flow, on.chord, 0.25 * spacing)
    tracer.relative = _NET
    net = Net(tracer, spacing, reach, MOST, on.tell)
    starts = [(k, uv) for k, surface in enumerate(on.surfaces) for uv in _starts(tracer, k) if surface.inside(*uv)]
    return net.fill(starts)


def _starts(tracer: Tracer, patch: int) -> list[FloatArray]:
    """Return where a net begins on a patch: off its middle, where umbilics like to be, then over all of it."""
    t = np.linspace(0.113, 0.913, 5)
    grid: FloatArray = np.stack(np.meshgrid(t, t, indexing="ij"), axis=-1).reshape(-1, 2)
    order = np.argsort(np.abs(grid - 0.3).max(axis=1), kind="stable")
    begun = tracer.begun([Seed(patch, uv, mode=tracer.flow.modes[0]) for uv in grid[order]])
    return [line[:2] for line in begun if line[ENDED] != NO_DIRECTION]


def _leaving(on: Subject, ask: Ask, found: Found) -> Found:
    """Return the lines of curvature that leave umbilics."""
    reach = _reach(on, ask)
    part = on if ask.patch is None else _only(on, ask.patch)
    tracer = Tracer(part.surfaces, PRINCIPAL_DIRECTIONS, on.chord)
    seeds: list[Seed] = []
    for number, patch in enumerate(part.patches):
        surface = patch.surface
        told = umbilics(patch)
        if told.regions:
            found.notes.append(f"{patch.name}: umbilics that are not isolated have no lines that leave them")
        for one in told.umbilics:
            at = np.array([one.u, one.v])
            local = Local.at(surface, *at)
            for angle in [*one.directions, *(x + 180.0 for x in one.directions)]:
                step = local.along(np.asarray(np.radians(angle)))
                beside = at + _BESIDE * surface.size * step
                if ((beside >= 0.0) & (beside <= 1.0)).all():
                    seeds.append(Seed(number, beside, local.lifted(step), _leaves(surface, beside, local.lifted(step))))
    if not seeds:
        found.notes.append("the model has no isolated umbilic")
    curves = [Curve(tuple(t.paths), tuple(t.modes), t.closed, t.ended) for t in tracer.trace(seeds, reach)]
    values = {mode: of_quantity(f"k{mode}") for mode in (1, 2)}
    return _written(part, [curve for curve in curves if curve.paths], found, _LABELS, values)


def _leaves(surface: Surface, at: FloatArray, towards: FloatArray) -> int:
    """Return the family whose direction is nearest to the one in which an umbilic is left."""
    local = Local.at(surface, *at)
    first = local.lifted(local.along(local.angle))
    return 1 if abs(float(first @ towards)) >= np.sqrt(0.5) else 2


def geodesic(on: Subject, ask: Ask) -> Found:
    """A geodesic from a point in a direction, or between two points."""
    patch, at = on.number(ask.patch), place(ask.start, "start")
    _refuse_outside(on, patch, at)
    found = Found("normal curvature", on.measure(-1), traced=True)
    tracer = Tracer(on.surfaces, GEODESICS, on.chord)
    if not np.isfinite(float(Local.at(on.surfaces[patch], *at, order=1).area)):
        raise ValueError(f"start: {at[0]:g},{at[1]:g} is a singular point of the surface; begin beside it")
    if ask.to is not None:
        if ask.direction is not None:
            raise ValueError("direction: expected a direction or a second point, found both")
        end = on.number(ask.to_patch or ask.patch, "to_patch"), place(ask.to, "to")
        gap = on.surfaces[end[0]](*end[1]) - on.surfaces[patch](*at)
        if not np.linalg.norm(gap) > 1e-9 * on.size:
            raise ValueError("to: expected a point away from the start, found the same one")
        curve = between(tracer, (patch, at), end, ask.length)
        if curve is None:
            found.notes.append("no geodesic was found between the two points that stays on the model")
        curves = [] if curve is None else [curve]
    else:
        if ask.direction is None:
            raise ValueError("direction: expected degrees from S_u, a vector X,Y,Z, or a second point, found none")
        towards = _towards(tracer, patch, at, ask.direction)
        curves = [from_point(tracer, patch, at, towards, length(ask.length, "length", on.size))]
    return _written(on, curves, found, {0: "geodesic"}, {0: normal_curvature})


def _towards(tracer: Tracer, patch: int, at: FloatArray, direction: float | Sequence[float]) -> FloatArray:
    if np.ndim(direction) == 0:
        angle = float(direction)  # pyright: ignore[reportArgumentType]
        if not np.isfinite(angle):
            raise ValueError(f"direction: expected degrees from S_u, found {angle:g}")
        return tangent(tracer, patch, at, angle)
    vector_ = vector(direction, "direction")
    local = Local.at(tracer.surfaces[patch], *at, order=1)
    along = local.lifted(local.lowered(vector_))
    if not np.linalg.norm(along) > 1e-9:
        raise ValueError("direction: expected a vector that is not along the normal, found one that is")
    return along


def _written(
    on: Subject, curves: Sequence[Curve], found: Found, labels: dict[int, str], values: dict[int, Values]
) -> Found:
    for chain, curve in enumerate(curves):
        if "more steps" in curve.ended or "more patches" in curve.ended:
            found.notes.append(f"line {chain}: {curve.ended}")
        for path, mode in zip(curve.paths, curve.modes, strict=True):
            patch = on.patches[path.patch]
            for part in path.cut(patch.surface):
                found.lines.append(line_of(patch.surface, patch.name, part, labels[mode], values[mode], chain=chain))
    return found
