"""Strips between and beyond sides: a blend from one side to another, and a patch extended past a side."""

from collections.abc import Sequence

import numpy as np

from quintrig.basis.functions import Functions
from quintrig.basis.trigonometric import Trigonometric
from quintrig.builders.build import Built, Meeting, finished, level, settled, short
from quintrig.builders.hermite import going_on, relaxed, rows_from
from quintrig.builders.rims import Rim, common, fitted, rim, tensor, turned, unused
from quintrig.model.model import Model
from quintrig.model.outcome import model_of
from quintrig.multipatch.attach import runs_back
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_STEEPEST = np.radians(160.0)  # turn of a blend up to which it is as long as the arc
ACROSS = Trigonometric()
"""The functions across new patches."""


def blended(
    model: Model,
    first: str,
    second: str,
    order: str = "G1",
    fullness: float = 1.0,
    *,
    name: str = "blend",
    hold: bool = False,
) -> Built:
    """Return the model with a strip from one side to another, ``"a:u1"`` to ``"b:u0"``, that meets both to ``order``.

    The strip starts at the first side with u = 0 and ends at the second with u = 1. ``fullness`` > 0 scales the speeds
    at both ends: 1 is about a circular arc, less is sharper. With ``hold`` it follows both sides from now on. Raises
    ModelError or ValueError for sides that cannot be blended.
    """
    k = level(order)
    _positive(fullness, "fullness")
    one, two = rim(model, first), rim(model, second)
    if (one.patch.name, one.side) == (two.patch.name, two.side):
        raise ModelError(f"{first}: expected two sides to blend, found one twice")
    reverse = runs_back(one.edge, two.edge, (first, second), model.unit)
    far = two.across[:, ::-1] if reverse else two.across
    chord = float(np.linalg.norm(far[0] - one.points, axis=-1).mean())
    if not chord > 1e-9 * max(one.patch.surface.size, two.patch.surface.size):
        raise ModelError(f"{first} and {second} coincide, which leaves no room for a strip; join them instead")
    speeds = [fullness * chord * _bow(one.across[1], -far[1]) / side.speed if k else 1.0 for side in (one, two)]
    wanted = [(0.0, 0), (1.0, 0)]
    given = [one.points, far[0]]
    if k:
        wanted += [(0.0, 1), (1.0, 1)]
        given += [speeds[0] * one.across[1], -speeds[1] * far[1]]
    if k > 1:
        wanted += [(0.0, 2), (1.0, 2)]
        given += [speeds[0] ** 2 * bend(one.across, one.drift), speeds[1] ** 2 * bend(far, two.drift)]
    theirs = turned(two.functions) if reverse else two.functions
    functions, _ = common([one.functions, theirs or one.functions], given)
    net = rows_net(functions, wanted, given)
    if k > 1:
        net = relaxed([net], [ways(functions, wanted, given)], ACROSS)[0]
    patch = tensor(unused(name, model), ACROSS, functions, net, flipped(one))
    meetings = [Meeting(one, "u0", False, speeds[0]), Meeting(two, "u1", reverse, speeds[1])]
    patch, met = settled(patch, meetings, k)
    notes = short(meetings, met, order)
    return finished(model, [patch], [(patch, m) for m in meetings], order, hold=hold, notes=notes)


blend = model_of(blended, "blend")


def extended(
    model: Model, side: str, length: float, order: str = "G1", *, name: str = "extension", hold: bool = False
) -> Built:
    """Return the model with a patch that goes on past a side, ``"a:u1"``, for ``length`` (length¹), to ``order``.

    G0 and G1 go straight on, G2 and G3 keep their bend. The new patch starts at the side with u = 0. With ``hold`` it
    follows the side from now on. Raises ModelError or ValueError for sides that cannot be extended.
    """
    k = level(order)
    _positive(length, "length")
    one = rim(model, side)
    kappa = length / one.speed
    given = [one.points, kappa * one.across[1], kappa**2 * bend(one.across, one.drift)][: 3 if k > 1 else 2]
    functions, _ = common([one.functions], given)
    controls = [fitted(functions, values) for values in given]
    net = np.einsum("ij,jmx->imx", going_on(ACROSS, k > 1), np.stack(controls))
    patch = tensor(unused(name, model), ACROSS, functions, net, flipped(one))
    meeting = Meeting(one, "u0", False, kappa)
    patch, met = settled(patch, [meeting], k)
    return finished(
        model, [patch], [(patch, meeting)], order, hold=hold, notes=short([meeting], met, order)
    )  # fmt: skip


extend = model_of(extended, "extend")


def rows_net(along: Functions, wanted: Sequence[tuple[float, int]], given: Sequence[FloatArray]) -> FloatArray:
    """Return the net (6, m, 3) with derivatives wanted at (u, k), each given at points along a side."""
    controls = np.stack([fitted(along, values) for values in given])
    return np.einsum("ij,jkx->ikx", rows_from(ACROSS, wanted, 2), controls)


def ways(along: Functions, wanted: Sequence[tuple[float, int]], given: Sequence[FloatArray]) -> list[FloatArray]:
    """Return what S'' = S' at each end that has both would add to the net: the free μ of its G2 join."""
    result: list[FloatArray] = []
    for at, (end, k) in enumerate(wanted):
        if k == 2:
            first = given[wanted.index((end, 1))]
            only = [first if j == at else np.zeros_like(first) for j in range(len(wanted))]
            result.append(rows_net(along, wanted, only))
    return result


def bend(across: FloatArray, drift: float) -> FloatArray:
    """Return second derivatives without their part along the first: the μ of a G2 join that keeps the pace."""
    return across[2] - drift * across[1]


def _bow(out: FloatArray, back: FloatArray) -> float:
    """Return how much longer than its chord an arc is that turns from one way into another."""
    a, b = (x / np.maximum(np.linalg.norm(x, axis=-1, keepdims=True), 1e-300) for x in (out, back))
    half = 0.5 * min(float(np.arccos(np.clip((a * b).sum(axis=-1), -1.0, 1.0)).mean()), float(_STEEPEST))
    return half / np.sin(half) if half > 1e-6 else 1.0


def flipped(one: Rim) -> bool:
    """Return whether a patch whose u leaves this side must be flipped to look where its neighbour does."""
    return (one.patch.surface.sign < 0.0) != (one.side in ("u0", "v1"))


def _positive(value: float, name: str) -> None:
    if not 0.0 < value < float("inf"):
        raise ValueError(f"{name}: expected a finite number greater than 0, found {value:g}")
