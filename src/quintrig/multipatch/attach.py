"""``join``: two patches of a model made to meet along a side of each, to a wanted order."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from quintrig.model.held import Held, held
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.beside import broken, ratio_along, seams_beside
from quintrig.multipatch.boundary import SIDES, Edge, edges
from quintrig.multipatch.find import joins_of
from quintrig.multipatch.joins import ORDERS, Join
from quintrig.multipatch.match import Condition, Match, layers, match, match_all
from quintrig.multipatch.nets import Handle, as_tensor, handle, net_of
from quintrig.multipatch.strips import attach_strip
from quintrig.support.errors import ModelError, nearest

_LONGEST = 20.0
"""Edges that differ more than this in length are not joined."""


@dataclass(frozen=True, eq=False)
class Attached:
    """The model after a join, and what it took.

    ``join`` is the seam as measured, None where the patches no longer meet; ``ratio`` is κ, ``moved`` the norm of the
    change of the control points (length¹, planes: of a unit), ``exact`` tells whether the order is met to rounding.
    ``notes`` tell what else came of it, one line each.
    """

    model: Model
    join: Join | None
    ratio: float
    moved: float
    exact: bool
    notes: tuple[str, ...]


def join(
    model: Model,
    first: str,
    second: str,
    order: str = "G1",
    ratio: float | None = None,
    *,
    both: bool = False,
    convert: bool = False,
    hold: bool = False,
) -> Model:
    """Return the model with the second side moved, as little as needed, to join the first: ``"a:u1"``, ``"b:u0"``.

    ``order`` is G0, G1, G2 or G3; ``ratio`` > 0 that of the speeds across the seam, second to first, by default that
    of the seam which this one goes on from at a corner, else the one of least change. Other seams of the second patch
    are kept where all can be met at once. With ``both`` the first patch moves too; with ``convert`` a patch that cannot
    stay of its kind becomes a tensor-product patch; with ``hold`` the model keeps the join from now on. Raises
    ModelError or ValueError for sides that cannot be joined.
    """
    return attach(model, first, second, order, ratio, both=both, convert=convert, hold=hold).model


def attach(
    model: Model,
    first: str,
    second: str,
    order: str = "G1",
    ratio: float | None = None,
    *,
    both: bool = False,
    convert: bool = False,
    hold: bool = False,
) -> Attached:
    """Do what ``join`` does, and tell what came of it."""
    level = _order(order)
    if ratio is not None and not 0.0 < ratio < float("inf"):
        raise ValueError(f"ratio: expected a finite number greater than 0, found {ratio:g}")
    (one, side1), (two, side2) = side_of(model, first), side_of(model, second)
    if one.name == two.name:
        raise ModelError(f"{first} and {second}: expected sides of two patches; a patch is not joined to itself")
    reverse = runs_back(edge_of(one, side1), edge_of(two, side2))
    if two.kind == "developable":
        if both:
            raise ModelError(f"{second}: of two developable strips only the second moves; leave out both")
        found = attach_strip(one, side1, two, side2, level, ratio)
        changed, ratio_used, moved, exact, notes = {two.name: found.patch}, found.ratio, found.moved, True, found.notes
    else:
        stay = {} if both else seams_beside(replace(model, held=()), two, side2)
        wanted = ratio if ratio is not None or level == 0 else ratio_along(replace(model, held=()), one, side1)
        changed, done, notes = _matched(one, side1, two, side2, level, wanted, reverse, both, convert, stay)
        ratio_used, moved, exact = done.ratio, done.moved, done.exact
    rules = model.held
    if hold:
        table = Held(first, second, order, ratio_used).to_dict()
        rules = held([*(rule.to_dict() for rule in rules), table], tuple(patch.name for patch in model.patches))
    result = replace(model, patches=tuple(changed.get(patch.name, patch) for patch in model.patches), held=rules)
    seam = _seam(result, (one.name, side1), (two.name, side2))
    worse = tuple(_worse(model, result, set(changed), {(one.name, side1), (two.name, side2)}))
    return Attached(result, seam, ratio_used, moved, exact, (*notes, *worse))


def side_of(model: Model, text: str) -> tuple[Patch, str]:
    """Return the patch and side that a text such as ``a:u1`` names; a patch's name may hold colons itself."""
    name, colon, side = text.rpartition(":")
    if not colon or side not in SIDES:
        raise ModelError(f"{text}: expected PATCH:SIDE with a side of {', '.join(SIDES)}, such as a:u1")
    known = [patch.name for patch in model.patches]
    if name not in known:
        raise ModelError(f"{text}: no patch {name!r}{nearest(name, known)}; the model has {', '.join(known[:12])}")
    return model.patch(name), side


def _order(order: str) -> int:
    if order not in ORDERS[1:]:
        raise ValueError(f"order: expected one of {', '.join(ORDERS[1:])}, found {order!r}")
    return ORDERS.index(order) - 1


def edge_of(patch: Patch, side: str) -> Edge:
    """Return the edge along a side of a whole patch; ModelError where it is a pole, trimmed or not finite."""
    if patch.surface.trim:
        raise ModelError(
            f"{patch.name}:{side}: the face is trimmed, and its sides are not its edges; join whole patches"
        )
    alive, poles = edges([patch.surface])
    for edge in poles:
        if edge.side == side:
            raise ModelError(f"{patch.name}:{side}: the side is a single point (a pole); join another side")
    for edge in alive:
        if edge.side == side:
            return edge
    raise ModelError(f"{patch.name}:{side}: the side has points that are not finite; check the patch")


def runs_back(first: Edge, second: Edge) -> bool:
    """Return whether the second edge runs the other way; ModelError where their lengths do not go together."""
    ratio = max(first.length, second.length) / min(first.length, second.length)
    if ratio > _LONGEST:
        raise ModelError(
            f"sides of {first.length:.3g} and {second.length:.3g} in length: expected at most {_LONGEST:g} times; "
            "split the longer one"
        )
    at = [0, 16, 48, 64]
    here = first.points[at]
    ahead, back = (np.linalg.norm(here - second.points[::step][at], axis=-1).sum() for step in (1, -1))
    return bool(back < ahead)


def _matched(
    one: Patch,
    side1: str,
    two: Patch,
    side2: str,
    level: int,
    ratio: float | None,
    reverse: bool,
    both: bool,
    convert: bool,
    stay: dict[str, Condition],
) -> tuple[dict[str, Patch], Match, tuple[str, ...]]:
    """Return the patches changed, by name, what the match took, and notes; ``stay`` are seams to keep if possible."""
    notes: list[str] = []
    two, own = movable(two, convert, notes, (side2,))
    one, other = movable(one, convert, notes, (side1,)) if both else (one, None)
    for patch, side in ((two, side2), *(((one, side1),) if both else ())):
        count = layers(patch.surface, side)
        if count <= level:
            raise ModelError(
                f"{patch.name}:{side}: expected more than {level} rows of control points across it for G{level}, found "
                f"{count}; raise the degree or ask for G{count - 1}"
            )
        if count == level + 1:
            notes.append(f"{patch.name}: all {count} rows are held by the join: the side opposite moves too")

    def solve() -> Match:
        alone = match(one.surface, side1, two.surface, side2, own, level, reverse=reverse, ratio=ratio, other=other)
        if not stay or not alone.exact:
            return alone
        wanted = Condition(one.surface, side1, side2, level, reverse, alone.ratio)
        values, met = match_all(two.surface, own, [wanted, *stay.values()])
        shift = float(np.linalg.norm(values - own.values))
        return Match(None, values, alone.ratio, shift, True) if all(met) else alone

    done = solve()
    if not done.exact and two.kind == "ruled":
        raise ModelError(
            f"{two.name}:{side2}: straight lines cannot join {one.name}:{side1} to G{level}; ask for a lower order, "
            "give both edges the same shape parameters, or take a tensor-product patch"
        )
    if not done.exact and two.kind != "tensor":
        tensor = as_tensor(two)
        if tensor is not None:
            if not convert:
                raise ModelError(
                    f"{two.name}:{side2}: a {two.kind} cannot keep its kind and join {one.name}:{side1} to G{level}",
                    remedy="convert=True makes it a tensor-product patch",
                    key="convert",
                )
            notes.append(f"{two.name}: made a tensor-product patch")
            two, own = movable(tensor, convert, notes)
            done = solve()
    if not done.exact:
        notes.append(_why(one, side1, two, side2, reverse))
    changed = {two.name: two.rebuilt(**own.keys(done.second))}
    for name in broken(stay, changed[two.name]):
        notes.append(
            f"{name} no longer meet exactly: with this join they cannot; four patches meet smoothly at a corner where "
            "the ratio is the same along each line of patches, as it is if left out"
        )
    if other is not None and done.first is not None:
        changed[one.name] = one.rebuilt(**other.keys(done.first))
    return changed, done, tuple(notes)


def movable(patch: Patch, convert: bool, notes: list[str], sides: Iterable[str] = ()) -> tuple[Patch, Handle]:
    """Return a patch, and what may be moved of it to join at these sides; ModelError where that is nothing."""
    found = handle(patch, sides)
    if found is not None:
        return patch, found
    tensor = as_tensor(patch)
    if tensor is None or (found := handle(tensor)) is None:
        what = "a NURBS surface with weights" if patch.kind == "nurbs" else f"a {patch.kind}"
        raise ModelError(
            f"{patch.name}: {what} has no control points that a join may move; join the other patch to it instead "
            "(name it second)"
        )
    if not convert:
        raise ModelError(
            f"{patch.name}: a {patch.kind} is not held by rows that can move",
            remedy="convert=True makes it a tensor-product patch, exactly the same before it moves",
            key="convert",
        )
    notes.append(f"{patch.name}: made a tensor-product patch")
    return tensor, found


def _why(one: Patch, side1: str, two: Patch, side2: str, reverse: bool) -> str:
    """Say why a join is by least squares only."""
    t = np.linspace(0.0, 1.0, 9)
    families = [_family(patch, side) for patch, side in ((one, side1), (two, side2))]
    if all(family is not None for family in families):
        mine, theirs = (family.derivatives(t, 0)[0] for family in families if family is not None)
        there = theirs[::-1, ::-1] if reverse else theirs
        if mine.shape == there.shape and np.allclose(mine, there, atol=1e-12):
            return "met by least squares: the basis cannot meet all conditions at once with this ratio"
    return "met by least squares: the functions along the two edges differ; give both the same shape parameters there"


def _family(patch: Patch, side: str):
    if net_of(patch) is None:
        return None
    return patch.surface.blend if SIDES.index(side) < 2 else getattr(patch.surface.rows, "functions", None)


def _seam(model: Model, first: tuple[str, str], second: tuple[str, str]) -> Join | None:
    pair = replace(model, patches=(model.patch(first[0]), model.patch(second[0])), held=())
    for found in joins_of(pair, near=0.5):
        if {(end.patch, end.side) for end in (found.first, found.second)} == {first, second}:
            return found
    return None


def _worse(before: Model, after: Model, changed: set[str], seam: set[tuple[str, str]]) -> list[str]:
    """Return a line on each other seam of the patches moved that has lost some of its order."""

    def seams(model: Model) -> dict[frozenset[tuple[str, str]], Join]:
        found: dict[frozenset[tuple[str, str]], Join] = {}
        for one in joins_of(model, of=changed):
            ends = frozenset((end.patch, end.side) for end in (one.first, one.second))
            if set(ends) != seam:
                found[ends] = one
        return found

    now = seams(after)
    lines: list[str] = []
    for ends, old in seams(before).items():
        new = now.get(ends)
        order = new.order if new else "open"
        if ORDERS.index(order) < ORDERS.index(old.order):
            gap = f" by {new.gap.most:.3g} {after.unit}".rstrip() if new and order == "open" else ""
            lines.append(f"{old.first} and {old.second}: {old.order} before, now {order}{gap}; join them again")
    return lines
