"""What came of each demand of a design: met or not, binding or not, where it is worst, and whether it is proved."""

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.model.patch import Patch
from quintrig.shaping.conditions import Condition, InTotal, OnSurface, Worst
from quintrig.shaping.demands import ANGLES, CURVATURES, TOTALS
from quintrig.shaping.places import TangentPlane, Twist
from quintrig.shaping.search import met

_BINDS = 1e-3  # scaled: a demand that is met with less to spare holds the design back
_NOT_PROVED = "not proved"


@dataclass(frozen=True)
class Outcome:
    """What came of a demand: whether it is ``met``, whether it ``binds``, the ``worst`` value and where.

    ``missed`` is by how much it is not met, 1 being natural for a patch of this size. ``verdict`` is proved, refuted,
    undecided, or "not proved" where there is no proof of such a demand: it is met at 65 x 65 points then.
    """

    demand: str
    met: bool
    binds: bool
    worst: float
    missed: float
    unit: str
    u: float | None
    v: float | None
    point: tuple[float, ...] | None
    verdict: str

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values; what is not finite is null."""
        worst = self.worst if np.isfinite(self.worst) else None
        return {
            "demand": self.demand,
            "met": self.met,
            "binds": self.binds,
            "worst": worst,
            "missed": self.missed if np.isfinite(self.missed) else None,
            "unit": self.unit,
            "u": self.u,
            "v": self.v,
            "point": None if self.point is None else list(self.point),
            "verdict": self.verdict,
        }


def outcome(one: Condition, worst: Worst, patch: Patch, unit: str, prove: bool) -> Outcome:
    """Return what came of a condition on the patch as it was found, which is ``worst`` there."""
    missed = max(-worst.slack, 0.0)
    place = None
    if worst.u is not None and worst.v is not None:
        place = tuple(patch.surface(worst.u, worst.v).tolist())
    reached = met(missed)
    verdict = _NOT_PROVED
    if prove and isinstance(one, OnSurface):
        verdict = _verdict(one, patch)
    reached = reached and verdict != "refuted"
    near_bound = abs(worst.slack) <= _BINDS
    return Outcome(one.name, reached, one.equal or near_bound, worst.value, missed, _unit(one, unit), worst.u, worst.v,
                   place, verdict)  # fmt: skip


def _verdict(one: OnSurface, patch: Patch) -> str:
    """Return what a proof comes to, where there are proofs."""
    try:
        proofs = import_module("quintrig.analysis.proofs")
    except ModuleNotFoundError:
        return _NOT_PROVED
    try:
        return str(proofs.prove(patch, one.demand.claim).verdict)
    except ValueError:
        return _NOT_PROVED


def _unit(one: Condition, unit: str) -> str:
    """Return the unit of what is told of a condition."""
    if isinstance(one, TangentPlane | Twist):
        return "deg"
    power = 1
    if isinstance(one, OnSurface | InTotal):
        if one.demand.key in ANGLES:
            return "deg"
        power = {**CURVATURES, **TOTALS}[one.demand.key]
    if not unit or not power:
        return ""
    raised = unit + {1: "", 2: "²", 3: "³"}[abs(power)]
    return raised if power > 0 else f"1/{raised}"
