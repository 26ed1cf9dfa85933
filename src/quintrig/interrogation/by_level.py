"""Lines along which a curvature has a value, or is greatest or least along its own direction."""

from dataclasses import replace

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.interrogation import fields
from quintrig.interrogation.ask import Ask, few
from quintrig.interrogation.found import COUNT, Found, Level, as_lines, level_lines, of_quantity
from quintrig.interrogation.ridges import NAMES, ridges
from quintrig.interrogation.subject import Subject
from quintrig.quantities.table import quantity
from quintrig.support.arrays import frozen, whole

_NOISE = 1e-10  # of C to the power of the quantity: a curvature that is rounding


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
    return level_lines(
        part, lambda s: fields.quantity_scalar(s, key), [Level(0.0, f"{name} = 0", 0.0)], found, of_quantity(other)
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
            found.lines += as_lines(patch, paths, NAMES[family], values, strength=True)
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
        count = whole(COUNT if ask.count is None else ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        t = np.linspace(0.0, 1.0, 65)
        found = [analyse(s, t[:, None], t[None, :], (q.key,), threads=1)[q.key].ravel() for s in on.surfaces]
        values = np.concatenate(found)
        values = values[np.isfinite(values)]
        low, high = (0.0, 0.0) if not len(values) else np.percentile(values, (1.0, 99.0)).tolist()
        levels = np.linspace(low, high, count + 2)[1:-1]
    unit = q.unit(on.unit)
    wanted = [Level(x, f"{q.symbol} = {x:.6g}{' ' + unit if unit else ''}", x) for x in dict.fromkeys(levels.tolist())]
    return level_lines(on, lambda s: fields.quantity_scalar(s, q.key), wanted, Found(q.name, unit), of_quantity(q.key))
