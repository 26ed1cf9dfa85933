"""Joins that hold: every side of a model that follows another one, moved to it, all sides of a patch at once."""

from dataclasses import replace
from itertools import groupby

import numpy as np

from quintrig.model.held import Held
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.attach import edge_of, movable, runs_back, side_of
from quintrig.multipatch.joins import ORDERS
from quintrig.multipatch.match import Condition, match_all
from quintrig.multipatch.strips import attach_strip
from quintrig.support.errors import ModelError

_STANDS = 1e-12  # share of a patch's size: less than that is no move


def hold(model: Model) -> Model:
    """Return the model with the sides that follow moved, by the least change, to those that lead them.

    Raises ModelError for sides that cannot be joined, and by name for joins that cannot all be met at once.
    """
    for _, group in groupby(model.held, key=lambda rule: rule.patches[1]):
        moved = _followed(model, list(group))
        model = replace(model, patches=tuple(moved if one.name == moved.name else one for one in model.patches))
    return model


def _followed(model: Model, rules: list[Held]) -> Patch:
    """Return the patch that these joins hold, moved."""
    patch = model.patch(rules[0].patches[1])
    if patch.kind == "developable":
        if len(rules) > 1:
            raise _contradiction(rules)
        (lead, side), own = side_of(model, rules[0].first), side_of(model, rules[0].second)[1]
        return attach_strip(lead, side, patch, own, _level(rules[0]), rules[0].ratio).patch
    patch, handle = movable(patch, False, [], [rule.second.rpartition(":")[2] for rule in rules])
    conditions = [_condition(model, rule) for rule in rules]
    values, met = match_all(patch.surface, handle, conditions)
    if not all(met) and len(rules) > 1:
        alone = [match_all(patch.surface, handle, [one])[1][0] for one in conditions]
        if all(alone):
            raise _contradiction(rules)
    if np.abs(values - handle.values).max() <= _STANDS * patch.surface.size:
        return model.patch(patch.name)  # it is met already, and rounding is no reason to move
    return patch.rebuilt(**handle.keys(values))


def _condition(model: Model, rule: Held) -> Condition:
    (lead, side), (own, own_side) = side_of(model, rule.first), side_of(model, rule.second)
    back = runs_back(edge_of(lead, side), edge_of(own, own_side))
    return Condition(lead.surface, side, own_side, _level(rule), back, rule.ratio)


def _level(rule: Held) -> int:
    return ORDERS.index(rule.order) - 1


def _contradiction(rules: list[Held]) -> ModelError:
    told = " and ".join(f"{rule.second} to {rule.first} ({rule.order})" for rule in rules)
    return ModelError(f"join: {told} contradict each other: lower an order, equal the ratios, or leave one out")
