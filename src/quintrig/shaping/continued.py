"""A strip continued across its rail, which is the only developable that meets it smoothly there.

Along a curve that is no ruling, a developable is known by its tangent planes: it is what they envelop (do Carmo 1976,
§3-5). So two developables that are tangent along a rail are one, and a smooth seam is there exactly where the second
strip continues the rulings of the first. Else its next rail is missed.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from quintrig.shaping.matching import Pace
from quintrig.shaping.rails import Rail, spline
from quintrig.shaping.strip import away
from quintrig.support.arrays import FloatArray

_SECTION = 129  # rulings between two breaks that are continued
_JUMP = 20.0  # of the usual step from one ruling's end to the next


@dataclass(frozen=True, eq=False)
class Continued(Rail):
    """The rail at which rulings end that are continued across ``over``; its parameter is that of ``over``."""

    sections: tuple[tuple[float, float, Any], ...] = ()

    @property
    def breaks(self) -> FloatArray:
        """Parameters between two of which the rail is smooth."""
        return np.array([0.0, *(end for _, end, _ in self.sections)])

    @property
    def alone(self) -> None:
        """It is no curve of a model."""
        return None

    def derivatives(self, t: FloatArray, left: bool = False) -> FloatArray:
        """Return points and first derivatives (2, n, 3) at parameters (n,); ``left`` takes those before a break."""
        breaks = self.breaks
        index = np.clip(np.searchsorted(breaks, t, "left" if left else "right") - 1, 0, len(self.sections) - 1)
        result = np.empty((2, len(t), 3))
        for k, (_, _, curve) in enumerate(self.sections):
            here = index == k
            result[0, here], result[1, here] = curve(t[here]), curve(t[here], 1)
        return result

    def misses(self, rail: Rail) -> float:
        """Return how far this rail and another are apart where they are farthest, length¹."""
        t = np.linspace(0.0, 1.0, 501)
        return max(away(self(t), rail), away(rail(t), self))


def continued(first: Rail, over: Rail, pace: Pace, towards: Rail, cuts: FloatArray) -> Continued | None:
    """Return where rulings from ``first`` end that are continued across ``over`` to be nearest to ``towards``.

    ``cuts`` are the parameters on ``over`` between which it is smooth. None where a ruling does not come near.
    """
    sections: list[tuple[float, float, Any]] = []
    ends: list[FloatArray] = []
    grid = np.linspace(0.0, 1.0, 401)
    cloud = towards(grid)
    spans: list[tuple[float, float]] = list(pairwise(cuts.tolist()))
    for low, high in spans:
        t: FloatArray = np.linspace(low, high, _SECTION)
        base = over(t)
        way = base - first(pace.inverse(t))
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        gap = cloud - base[:, None]
        ahead = (gap * way[:, None]).sum(axis=-1)
        off = np.linalg.norm(gap - np.maximum(ahead, 0.0)[..., None] * way[:, None], axis=-1)
        at = grid[off.argmin(axis=1)]
        for _ in range(20):
            d = towards.derivatives(at)
            gap = d[0] - base
            aside = gap - (gap * way).sum(-1, keepdims=True) * way
            across = d[1] - (d[1] * way).sum(-1, keepdims=True) * way
            at = np.clip(at - (aside * across).sum(-1) / np.maximum((across**2).sum(-1), 1e-300), 0.0, 1.0)
        reach = ((towards(at) - base) * way).sum(axis=-1)
        if not reach.min() > 1e-6 * float(np.linalg.norm(np.ptp(cloud, axis=0))):
            return None
        end = base + reach[:, None] * way
        ends.append(end)
        sections.append((low, high, spline(t, end)))
    steps = np.concatenate([np.linalg.norm(np.diff(end, axis=0), axis=1) for end in ends])
    if steps.max() > _JUMP * max(float(np.median(steps)), 1e-12):
        return None
    return Continued((), (), tuple(sections))
