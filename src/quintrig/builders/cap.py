"""A closed edge, of one side or of several, capped by patches that meet in a point."""

import numpy as np

from quintrig.builders.build import Built, Meeting, finished, level, settled, short
from quintrig.builders.hermite import relaxed
from quintrig.builders.loops import Bound, in_a_loop
from quintrig.builders.rims import Rim, common, rim, tensor, unused
from quintrig.builders.strips import ACROSS, bend, flipped, rows_net, ways
from quintrig.model.model import Model
from quintrig.model.outcome import model_of
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_FULL = 0.5  # height of a cap on a tube, in radii


def capped(
    model: Model,
    *sides: str,
    order: str = "G1",
    height: float | None = None,
    name: str = "cap",
    hold: bool = False,
) -> Built:
    """Return the model with a closed edge capped: that of one side, ``"a:u1"``, or of several that form a loop.

    A patch goes from each side to one point, in which all have one tangent plane; they meet their sides to ``order``.
    ``height`` (length¹) is that of the point over the edge's middle, out of the patches; without, one that goes with
    the way in which they leave off. Raises ModelError for an edge that is not closed.
    """
    k = level(order)
    if height is not None and not abs(height) < float("inf"):
        raise ValueError(f"height: expected a finite number, found {height:g}")
    if not sides:
        raise ModelError("cap: expected a closed side, or several that form a loop, such as a:u1")
    rims = [rim(model, side) for side in sides]
    loop = in_a_loop([Bound(one.text, one.points) for one in rims])
    ring = np.concatenate([(rims[i].edge.points[::-1] if back else rims[i].edge.points)[:-1] for i, back in loop])
    middle, normal, radius = _disc(ring)
    out = np.concatenate([one.across[1] for one in rims])
    out = out / (float(np.linalg.norm(out, axis=-1).mean()) or 1.0)
    lift = float((out @ normal).mean())
    if lift < 0.0:
        normal, lift = -normal, -lift
    top = middle + normal * ((_FULL * radius * lift if k else 0.0) if height is None else height)
    meridian = float(np.linalg.norm(ring - top, axis=-1).mean())
    pairs, notes = list[tuple[Patch, Meeting]](), list[str]()
    drift = float(np.mean([one.drift for one in rims])) if k > 1 else 0.0
    kappa = meridian / float(np.mean([one.speed for one in rims])) if k else 1.0
    wanted = [(0.0, 0), (1.0, 0), *([(0.0, 1), (1.0, 1)] if k else []), *([(0.0, 2)] if k > 1 else [])]
    given = [_given(one, top, normal, kappa, drift)[: len(wanted)] for one in rims]
    along = [common([one.functions], values)[0] for one, values in zip(rims, given, strict=True)]
    nets = [rows_net(functions, wanted, values) for functions, values in zip(along, given, strict=True)]
    if k > 1:
        nets = relaxed(nets, [ways(f, wanted, values) for f, values in zip(along, given, strict=True)], ACROSS)
    names: list[str] = []
    for number, (one, functions, net) in enumerate(zip(rims, along, nets, strict=True), 1):
        names.append(unused(name if len(rims) == 1 else f"{name}-{number}", model, names))
        patch = tensor(names[-1], ACROSS, functions, net, flipped(one))
        meeting = Meeting(one, "u0", False, kappa)
        patch, met = settled(patch, [meeting], k)
        notes += short([meeting], met, order)
        pairs.append((patch, meeting))
    return finished(model, [patch for patch, _ in pairs], pairs, order, hold=hold, notes=notes)


cap = model_of(capped, "cap")


def _given(one: Rim, top: FloatArray, normal: FloatArray, kappa: float, drift: float) -> list[FloatArray]:
    """Return points, the top, and derivatives at both ends: the same sum for all sides, which so keep together."""
    spokes = top - one.points
    flat = spokes - (spokes @ normal)[:, None] * normal
    there = np.broadcast_to(top, one.points.shape)
    return [one.points, there, kappa * one.across[1], flat * np.pi / 2.0, kappa**2 * bend(one.across, drift)]


def _disc(ring: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Return middle, unit normal and mean radius of a closed polygon (n, 3); ModelError where it has no area."""
    steps = np.roll(ring, -1, axis=0) - ring
    weights = np.linalg.norm(steps, axis=-1)
    middle = (0.5 * (ring + np.roll(ring, -1, axis=0)) * weights[:, None]).sum(axis=0) / weights.sum()
    area = 0.5 * np.cross(ring - middle, np.roll(ring, -1, axis=0) - middle).sum(axis=0)
    size = float(np.linalg.norm(area))
    radius = float(np.linalg.norm(ring - middle, axis=-1).mean())
    if not size > 1e-6 * radius**2:
        raise ModelError("cap: expected an edge that runs round a hole, found one without area; join its sides instead")
    return middle, area / size, radius
