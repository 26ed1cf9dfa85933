"""Where on a surface a claim is proved, where it is refuted and where open: rectangles of (u, v) that cover it."""

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.charts import Chart
from quintrig.enclosures.claims import Claim, read
from quintrig.enclosures.faces import outside
from quintrig.enclosures.measures import MEASURES, REGULAR, gauss_sign
from quintrig.enclosures.prove import Prover, asked
from quintrig.enclosures.search import Range
from quintrig.geometry.envelope import Envelope
from quintrig.support.arrays import FloatArray

State = Literal["proved", "refuted", "open"]

_FINEST = 2.0**-6  # of a chart: a box that holds both kinds of points is not halved below it
_AT_ONCE = 32  # boxes worked on together
_WORDS = {
    "regular": ("", Range(0.0, np.inf, (True, False))),
    "no fold": ("", Range(0.0, np.inf, (True, False))),
    "convex": ("gaussian", Range(0.0, np.inf)),
    "developable": ("gaussian", Range(0.0, 0.0)),
}


@dataclass(frozen=True, eq=False)
class Regions:
    """Rectangles (k, 4) of u, v where they begin and where they end, and the state of each."""

    rectangles: FloatArray
    states: tuple[State, ...]

    def share(self, state: State) -> float:
        """Return the share of the area of all rectangles that has a state."""
        wide = self.rectangles[:, 2:] - self.rectangles[:, :2]
        area = wide[:, 0] * wide[:, 1]
        chosen = np.array([one == state for one in self.states], dtype=np.bool_)
        return float(area[chosen].sum() / area.sum()) if len(area) else 0.0

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values."""
        return {"rectangles": self.rectangles.tolist(), "states": list(self.states)}


def regions(prover: Prover, text: str | Claim, most: int = 4096, finest: float = _FINEST) -> Regions:
    """Return where a claim holds, where it fails, and what is open after ``most`` boxes a chart.

    All points of a rectangle that is proved satisfy the claim, and no point of one that is refuted does; between both
    there are open ones, narrower than ``finest`` of a chart. ``convex`` is shown by K >= 0. Raises ValueError as
    ``prove`` does, and for what is said of a whole surface only: ``inside hull``, a quantity without a comparison, and
    any claim on a strip of planes.
    """
    claim = read(text, prover.unit) if isinstance(text, str) else text
    if claim.sought or claim.word == "inside hull" or isinstance(prover.surface.rows, Envelope):
        raise ValueError(f"claim {claim.text!r}: has no map, only a verdict on the whole surface")
    if claim.measure:
        (problem, sign_only), wanted = asked(claim, claim.measure), claim.range
    else:
        key, wanted = _WORDS[claim.word]
        problem, sign_only = (gauss_sign if key else REGULAR.problem), True
        claim = replace(claim, measure=MEASURES[key] if key else None)
    rectangles: list[FloatArray] = []
    states: list[State] = []
    for chart, shape in prover.shapes(sign_only):
        forms, enclose = problem(shape, prover.surface.sign, claim.direction)
        whole, away = Boxes.whole([form.ball() for form in forms]), outside(prover.surface, chart)
        waiting, count = [whole], 0
        while waiting:
            now = waiting.pop()
            if len(now) > _AT_ONCE:
                waiting.append(now.take(slice(_AT_ONCE, None)))
                now = now.take(slice(0, _AT_ONCE))
            now = now.take(~away(now.low, now.high))
            if not len(now):
                continue
            count += len(now)
            low, high = enclose(*now.bounds())
            holds, misses = wanted.holds(low, high), wanted.misses(low, high)
            narrow = (now.high - now.low).min(axis=1) <= finest
            done = holds | misses | narrow | (count + sum(map(len, waiting)) >= most)
            rectangles.append(_rectangles(chart, now.take(done)))
            pairs = zip(holds[done].tolist(), misses[done].tolist(), strict=True)
            states.extend(_state(one, other) for one, other in pairs)
            if not done.all():
                waiting.append(now.take(~done).halved())
    return Regions(np.concatenate([np.zeros((0, 4)), *rectangles]), tuple(states))


def _state(holds: bool, misses: bool) -> State:
    return "proved" if holds else "refuted" if misses else "open"


def _rectangles(chart: Chart, boxes: Boxes) -> FloatArray:
    ends = [np.stack(chart.parameters(end[:, 0], end[:, 1]), axis=-1) for end in (boxes.low, boxes.high)]
    return np.concatenate(ends, axis=1)
