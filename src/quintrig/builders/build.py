"""What a builder hands back, and how a new patch is fitted to the sides that it starts from."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from quintrig.builders.rims import Rim
from quintrig.model.held import Held, held
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.attach import movable
from quintrig.multipatch.find import joins_of
from quintrig.multipatch.joins import ORDERS, Join
from quintrig.multipatch.match import Condition, match_all

_NEAR = 0.5


@dataclass(frozen=True, eq=False)
class Built:
    """The model with its new patches, by name, the seams between them and the others as measured, and notes."""

    model: Model
    added: tuple[str, ...]
    seams: tuple[Join, ...]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Meeting:
    """A side of the new patch that meets a rim: its own side, whether it runs back along it, and the ratio κ."""

    rim: Rim
    side: str
    reverse: bool
    ratio: float


def level(order: str, most: str = "G3") -> int:
    """Return 0 for G0 and so on; ValueError for another word."""
    allowed = ORDERS[1 : ORDERS.index(most) + 1]
    if order not in allowed:
        raise ValueError(f"order: expected one of {', '.join(allowed)}, found {order!r}")
    return allowed.index(order)


def settled(patch: Patch, meetings: Sequence[Meeting], order: int) -> tuple[Patch, tuple[bool, ...]]:
    """Return the patch moved, as little as needed, to meet all rims, and which of them it meets to rounding."""
    _, handle = movable(patch, False, [])
    conditions = [
        Condition(one.rim.patch.surface, one.rim.side, one.side, order, one.reverse, one.ratio) for one in meetings
    ]
    values, met = match_all(patch.surface, handle, conditions)
    return patch.rebuilt(**handle.keys(values)), met


def finished(
    model: Model,
    patches: Sequence[Patch],
    meetings: Sequence[tuple[Patch, Meeting]] = (),
    order: str = "G0",
    *,
    hold: bool = False,
    notes: Sequence[str] = (),
) -> Built:
    """Return the model with new patches, which are held to the rims on request, and their seams measured."""
    rules, everything = model.held, (*model.patches, *patches)
    if hold:
        tables = [rule.to_dict() for rule in rules]
        tables += [
            Held(one.rim.text, f"{patch.name}:{one.side}", order, one.ratio).to_dict() for patch, one in meetings
        ]
        rules = held(tables, tuple(patch.name for patch in everything))
    result = replace(model, patches=everything, held=rules)
    new = {patch.name for patch in patches}
    return Built(result, tuple(patch.name for patch in patches), seams_of(result, new), tuple(notes))


def seams_of(model: Model, names: set[str]) -> tuple[Join, ...]:
    """Return the seams in which the patches of these names take part."""
    return tuple(joins_of(model, of=names))


def short(meetings: Sequence[Meeting], met: Sequence[bool], order: str) -> list[str]:
    """Return a line on each rim that is met by least squares only."""
    return [
        f"{one.rim.text}: met to {order} by least squares: its functions differ from those along the new patch, or its "
        "ratio does not fit; the seam tells what is reached"
        for one, good in zip(meetings, met, strict=True)
        if not good
    ]
