"""What is proved of a whole patch, in sentences: that it is regular, the sign of K, and certified ranges."""

from dataclasses import dataclass

import numpy as np

from quintrig.enclosures.prove import NoProofError, Prover
from quintrig.enclosures.search import Bounds
from quintrig.enclosures.verdicts import Verdict, Witness
from quintrig.geometry.surface import Surface

RANGES = ("gaussian", "mean", "curvature_radius")
"""Quantities whose certified bounds are told."""

_BOXES = 256
_NO_NORMAL = "regular: refuted, the surface has no normal at {}"


@dataclass(frozen=True)
class Certified:
    """Sentences on a patch, and certified ``bounds`` by quantity; ``reason`` says why there are none."""

    sentences: tuple[str, ...]
    bounds: dict[str, Bounds]
    reason: str = ""


def certify(surface: Surface, unit: str = "", boxes: int = _BOXES) -> Certified:
    """Return what is proved of a surface with at most so many ``boxes`` a claim and chart."""
    try:
        prover = Prover(surface, unit, boxes)
        regular = prover.prove("regular")
        told = [_regular(regular), _sign(prover), *regular.notes[:1]]
        found = {key: prover.bounds(key, most=boxes // 2) for key in RANGES}
    except NoProofError as error:
        return Certified((), {}, str(error))
    except ValueError as error:
        return Certified((), {}, f"no proof for this surface: {error}")
    return Certified(tuple(told), found)


def _regular(verdict: Verdict) -> str:
    if verdict.verdict == "refuted" and verdict.witness:
        return _NO_NORMAL.format(_place(verdict.witness))
    word = "regular on the whole patch, proved"
    return word if verdict.proved else f"regular: undecided, {verdict.why}"


def _sign(prover: Prover) -> str:
    """Return the strongest sentence on the sign of K that is proved."""
    above, below = prover.prove("gaussian >= 0"), prover.prove("gaussian <= 0")
    if above.proved and below.proved:
        return "K = 0 on the whole patch, proved"
    for verdict, sign in ((above, ">"), (below, "<")):
        if verdict.proved:
            strict = prover.prove(f"gaussian {sign} 0")
            return f"K {sign if strict.proved else sign + '='} 0 on the whole patch, proved"
    if above.witness and below.witness:
        ends = (f"K = {at.value:.4g} at {_place(at)}" for at in (above.witness, below.witness))
        return f"K changes its sign, proved: {' and '.join(ends)}"
    return f"sign of K: undecided, {above.why or below.why}"


def _place(at: Witness) -> str:
    return f"(u, v) = ({at.u:.4g}, {at.v:.4g})"


def ranges(found: Certified) -> list[str]:
    """Return the certified bounds in words, one quantity each; those without an end are left out."""
    lines: list[str] = []
    for key, bounds in found.bounds.items():
        low, high = bounds.minimum[0], bounds.maximum[1]
        unit = f" {bounds.unit}" if bounds.unit else ""
        if key == "curvature_radius":
            if np.isfinite(low) and low > 0.0:
                lines.append(f"radius of curvature at least {low:.5g}{unit}")
        elif np.isfinite([low, high]).all():
            lines.append(f"{'K' if key == 'gaussian' else 'H'} from {low:.5g} to {high:.5g}{unit}")
    return lines
