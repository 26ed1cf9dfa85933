"""What goals come to on a patch: the conditions that a design is to meet, and what is to be least."""

import numpy as np

from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.model.reading import read_net
from quintrig.shaping.conditions import Condition, Integral, InTotal, integral, on_surface
from quintrig.shaping.energies import ENERGIES, measured
from quintrig.shaping.goals import Goals, Target, read_goals
from quintrig.shaping.outcomes import Outcome, outcome
from quintrig.shaping.places import Near, Passing, TangentPlane, Twist, near, near_given
from quintrig.shaping.unknowns import as_it_is
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError
from quintrig.support.late import call


def judged(model: Model, patch: str, demand: str, target: FloatArray | None = None) -> list[Outcome]:
    """Return what comes of one demand, such as ``gaussian >= 0``, on a patch as it is, without a proof.

    ``deviation`` is that from the points of ``target`` (n, 3), length¹. Raises ModelError or ValueError for words that
    are no demand.
    """
    aim = [] if target is None else [{"points": target.tolist()}]
    keys = {"model": model, "patch": patch, "vary": {"points": 1.0}, "demands": [demand], "target": aim}
    goals = read_goals(keys)
    chosen = model.patch(patch)
    state = as_it_is(chosen)
    conditions = conditions_of(goals, chosen)
    return [outcome(one, one.worst(state), chosen, model.unit, prove=False) for one in conditions]


def conditions_of(goals: Goals, patch: Patch) -> list[Condition]:
    """Return what goals demand of a patch, in the order in which they are told."""
    size = patch.surface.size
    found: list[Condition] = []
    targets = [(_points(one, goals), one, index) for index, one in enumerate(goals.targets, 1)]
    for one in goals.demands:
        if one.key == "deviation":
            within = max(one.bound, 1e-9 * size)
            if targets:
                cloud = np.concatenate([points for points, _, _ in targets])
                found.append(near(one.text, cloud, within, patch.surface))
            else:
                found.append(near_given(one.text, within, patch.surface))
        elif one.total:
            value = integral(one.key, patch.surface)
            now = abs(measured(patch.surface, one.key)) if one.key in ENERGIES else size ** {"area": 2}.get(one.key, 3)
            scale = max(now if np.isfinite(now) else 1.0, abs(one.bound), np.finfo(float).tiny)
            found.append(InTotal(one, value, scale))
        else:
            found.append(on_surface(one, patch.surface))
    for points, one, index in targets:
        if one.within is not None:
            name = f"target {index} {one.file or ''}".strip()
            found.append(near(f"{name} within {one.within:g}", points, one.within, patch.surface))
    for index, one in enumerate(goals.through, 1):
        at = None if one.u is None or one.v is None else (one.u, one.v)
        name = f"through {index} ({', '.join(f'{x:g}' for x in one.point)})"
        found.append(Passing(name, np.array(one.point, dtype=np.float64), at, size))
    for index, one in enumerate(goals.tangent, 1):
        normal = np.array(one.normal, dtype=np.float64)
        found.append(TangentPlane(f"tangent {index}", (one.u, one.v), normal / np.linalg.norm(normal)))
    if goals.developable is not None:
        if not _ruled(patch):
            raise ModelError(
                f'developable: patch "{patch.name}" has no straight lines u = const, along which normals turn; take a '
                "ruled patch, or demand gaussian within a range"
            )
        found.append(Twist(f"developable within {goals.developable:g}°", goals.developable))
    return found


def _ruled(patch: Patch) -> bool:
    t = np.linspace(0.0, 1.0, 9)
    lines = patch.surface(t[:, None], t)
    middle = lines[:, :1] + t[:, None] * (lines[:, -1:] - lines[:, :1])
    return bool(np.abs(lines - middle).max() <= 1e-9 * patch.surface.size)


def _points(one: Target, goals: Goals) -> FloatArray:
    """Return a target's points in the model's unit."""
    unit = one.unit or goals.model.unit
    if one.file is None:
        points = np.array(one.points or [], dtype=np.float64)
    else:
        path = goals.folder / one.file
        try:
            points: FloatArray = np.asarray(call("open_target", path, unit).points, dtype=np.float64)
        except KeyError:  # without the readers of scans: tables alone
            points = np.array([row[:3] for row in read_net(path)], dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 1 or not np.isfinite(points).all():
        raise ModelError(f"target {one.file or ''}: expected points [x, y, z], found none such")
    return points


def objective_of(goals: Goals, patch: Patch) -> tuple[Integral | Near | None, float]:
    """Return what goals minimise, None for the least change, and the scale of it."""
    surface = patch.surface
    if goals.minimise == "none":
        return None, 1.0
    if goals.minimise == "deviation":
        if goals.targets:
            cloud = np.concatenate([_points(one, goals) for one in goals.targets])
            found = near("deviation", cloud, surface.size, surface)
        else:
            found = near_given("deviation", surface.size, surface)
            found.seen = np.arange(len(found.points))
        return found, 0.01 * surface.size
    what = integral(goals.minimise, surface)
    now = measured(surface, goals.minimise) if goals.minimise in ENERGIES else surface.size**2
    floor = {"bending": 1e-3}.get(goals.minimise, 1e-6 * surface.size**2)
    return what, max(now, floor) if np.isfinite(now) else floor
