"""What matters most about a patch, in a few plain sentences made from its numbers."""

import math
from collections.abc import Iterator

from markupsafe import Markup

from quintrig.analysis.agreement import REASONS, Agreement
from quintrig.analysis.certified import ranges
from quintrig.analysis.extremes import Extreme
from quintrig.analysis.summary import Summary
from quintrig.developables.regression import inner_regression
from quintrig.quantities.table import BY_KEY
from quintrig.report.facts import Facts, rounding, standard
from quintrig.report.wording import digits_of, listed, measure, pair, percent, prose, span
from quintrig.shaping.shape_effect import Variant

_FORMS = (
    ("dome- or bowl-shaped", ("elliptic", "umbilic")),
    ("saddle-shaped", ("hyperbolic",)),
    ("bent in one direction only", ("parabolic",)),
    ("flat", ("planar",)),
)
_SIDES = (
    ("bulges out", ("peak", "ridge", "saddle ridge")),
    ("is hollow", ("pit", "valley", "saddle valley")),
    ("bends equally both ways", ("minimal",)),
)
_ALL = 1.0 - 1e-9
_TRACE = 5e-4  # of the area: less is a line or a point


def findings(facts: Facts) -> tuple[Markup, ...]:
    """Return the key findings, one or two sentences each."""
    if facts.summary.singular.count == facts.summary.singular.samples:
        return (Markup("The surface has no tangent plane anywhere, so nothing can be said of its curvature."),)
    told = [
        *_shape(facts),
        *_bend(facts.summary),
        *_range(facts.summary),
        *_proved(facts),
        methods(facts.agreement),
        *_effect(facts),
    ]
    return tuple(told)


def total(summary: Summary, key: str, names: tuple[str, ...]) -> float:
    """Return the share of the area of several classes together, 0 to 1."""
    return sum(part.share for part in summary.shares[key] if part.name in names)


def _shape(facts: Facts) -> Iterator[Markup]:
    summary = facts.summary
    forms = _parts(summary, "point_type", _FORMS)
    if len(forms) == 1:
        sentence = f"The surface is {forms[0][0]} everywhere"
    else:
        spelt = [f"{name} over {percent(share)}" for name, share in forms]
        sentence = f"The surface is {listed([spelt[0] + ' of its area', *spelt[1:]])}"
    if not total(summary, "point_type", ("elliptic", "umbilic", "hyperbolic")):
        flat = total(summary, "point_type", ("planar",)) >= _ALL
        if inner_regression(facts.patch.surface) is not None:
            sentence += ": K\u00a0=\u00a00, but it folds back at its edge of regression and does not unroll whole"
        elif not flat:
            sentence += ": K\u00a0=\u00a00, so it unrolls into a plane without stretching"
    yield prose(sentence + ".")
    sides = _parts(summary, "hk_type", _SIDES)
    if sides:
        spelt = [name if len(sides) == 1 else f"{name} over {percent(share)}" for name, share in sides]
        yield prose(f"Seen from the side that the normal points to, it {listed(spelt)}.")


def _parts(summary: Summary, key: str, groups: tuple[tuple[str, tuple[str, ...]], ...]) -> list[tuple[str, float]]:
    """Return the groups of classes that occur, largest first; traces below a thousandth are left out."""
    found = [(name, total(summary, key, names)) for name, names in groups]
    shown = [(name, share) for name, share in found if share >= 1e-3]
    return sorted(shown, key=lambda part: -part[1])


def tightest(summary: Summary) -> Extreme:
    """Return the principal curvature that is largest in size, with where."""
    ends = (summary.extremes["k1"].maximum, summary.extremes["k2"].minimum)
    return max(ends, key=lambda end: (end.status == "unbounded", abs(end.value)))


def _bend(summary: Summary) -> Iterator[Markup]:
    end = tightest(summary)
    if end.status == "undefined" or abs(end.value) * summary.size <= 1e-9:
        return
    place = Markup("(<i>u</i>, <i>v</i>) = ") + pair(end.u, end.v)
    if end.status == "unbounded":
        yield Markup("Its curvature grows without bound near {}.").format(place)
        return
    side = "towards the normal" if end.value > 0 else "away from the normal"
    radius = measure(1.0 / abs(end.value), summary.unit, 3)
    bends = summary.extremes["curvedness"]
    if bends.maximum.value - bends.minimum.value <= 1e-9 * bends.maximum.value:
        yield Markup("It bends alike everywhere, {}, with a tightest radius of {}.").format(side, radius)
        return
    others = "" if end.unique else ", among other places"
    yield Markup("The tightest bend has a radius of {}, at {}{}; there the surface curves {}.").format(
        radius, place, others, side
    )


def _range(summary: Summary) -> Iterator[Markup]:
    found = summary.extremes["gaussian"]
    area = summary.integrals.area
    if not area.converged:
        return
    sentence = Markup("Its area is {}").format(measure(area.value, f"{summary.unit}²" if summary.unit else "", 4))
    noise = rounding(summary, "gaussian")
    low, high = (0.0 if abs(end.value) <= noise else end.value for end in (found.minimum, found.maximum))
    if {found.minimum.status, found.maximum.status} & {"undefined", "unbounded"} or low == high == 0.0:
        yield sentence + "."
        return
    unit = BY_KEY["gaussian"].unit(summary.unit)
    alike = high - low <= 1e-9 * max(abs(high), abs(low))
    spread = Markup("is {} everywhere").format(measure(high, unit, 3)) if alike else "runs " + span(low, high, unit)
    yield Markup("{}; the Gaussian curvature {}.").format(sentence, spread)


def _proved(facts: Facts) -> Iterator[Markup]:
    """Return what holds on the whole patch and not only at samples."""
    told = [line[0].upper() + line[1:] for line in facts.certified.sentences[:2]]
    bounds = ranges(facts.certified)
    if bounds:
        told.append(f"Certified bounds: {listed(bounds)}")
    if told:
        yield prose(". ".join(told) + ".")


def methods(found: Agreement) -> Markup:
    """Return how far the methods agree where they are defined, and where they are not, in a sentence or two."""
    undefined = found.share("undefined")
    vertical = sum(share for share, reason in zip(found.shares(), REASONS, strict=True) if reason.name == "vertical")
    steep = "the tangent plane is vertical, where the invariants of a height field are infinite"
    if undefined >= _ALL:
        same = found.tables[0].share(1)
        if vertical <= 0.0 or math.isnan(same):
            return Markup("At no point are all three methods defined, so nothing can be compared.")
        only = "only HK types and shape classes can be compared, and they say the same"
        return prose(f"Everywhere {steep}: {only} on {percent(same)} of the area.")
    defined = 1.0 - undefined
    agree, conflict = found.share("agree") / defined, found.share("conflict") / defined
    words = f"say the same on {percent(agree)} of the area"
    words += f" and contradict each other on {percent(conflict)}" if conflict else " and nowhere contradict each other"
    words = "say the same everywhere" if agree >= _ALL else words
    told = f"HK types, shape classes and invariants {words}."
    if undefined > _TRACE:
        told = f"Where all three are defined, {told[0]}{told[1:-1]}; on {percent(undefined)} of the area "
        told += f"{steep}." if vertical >= _ALL * undefined else "one of them is undefined."
    return prose(told)


def _effect(facts: Facts) -> Iterator[Markup]:
    """Name the set of the thesis that bends the surface least, where that is less than its own does."""
    bounded = [one for one in standard(facts) if one.summary.integrals.bending_energy.converged]
    own = facts.summary.integrals.bending_energy
    if not bounded or not own.converged:
        return

    def bending(one: Variant) -> float:
        return one.summary.integrals.bending_energy.value

    least = min(bounded, key=bending)
    if own.value > 1.001 * bending(least):
        yield Markup(
            "Of the thesis’s sets of shape parameters, {} bends it least: the bending energy is {} against {} with "
            "its own."
        ).format(prose(least.parameters), digits_of(bending(least), 3), digits_of(own.value, 3))
