"""``[[join]]`` tables: which side of a patch is held to which, how smoothly."""

from dataclasses import dataclass
from typing import Any, cast

from quintrig.model.explain import spell
from quintrig.support.errors import ModelError, nearest

_KEYS = ("first", "second", "order", "ratio")
ORDERS = ("G0", "G1", "G2", "G3")
SIDES = ("u0", "u1", "v0", "v1")


@dataclass(frozen=True)
class Held:
    """The side ``second`` (``patch:side``) is held to ``first``, to ``order`` with the ratio κ of speeds across."""

    first: str
    second: str
    order: str = "G1"
    ratio: float = 1.0

    def to_dict(self) -> dict[str, Any]:
        """Return the keys of a ``[[join]]`` table."""
        table: dict[str, Any] = {"first": self.first, "second": self.second, "order": self.order}
        return table | ({"ratio": self.ratio} if self.ratio != 1.0 else {})

    @property
    def patches(self) -> tuple[str, str]:
        """The names of the patches: the one that leads, and the one that follows."""
        return self.first.rpartition(":")[0], self.second.rpartition(":")[0]


def held(tables: Any, names: tuple[str, ...]) -> tuple[Held, ...]:
    """Return the joins of a model file, whose patches are called ``names``, those that lead first.

    Raises ModelError for wrong keys, unknown patches, a side held twice, and joins that run in a circle.
    """
    if not isinstance(tables, list) or not tables:
        raise ModelError(f"join: expected one or more [[join]] tables, got {spell(tables)}")
    rules = tuple(_rule(table, k, names) for k, table in enumerate(cast(list[Any], tables), 1))
    seen: dict[str, Held] = {}
    for rule in rules:
        if rule.second in seen:
            raise ModelError(
                f"join: {rule.second} is held to {seen[rule.second].first} and to {rule.first}; leave one of them out"
            )
        seen[rule.second] = rule
    return _in_order(rules, names)


def carried(rules: tuple[Held, ...], name: str) -> tuple[str, ...]:
    """Return the names of a patch and of all that follow it, directly or through others; ``rules`` as from ``held``."""
    found = [name]
    for rule in rules:  # those that lead come first
        first, second = rule.patches
        if first in found and second not in found:
            found.append(second)
    return tuple(found)


def _rule(table: Any, number: int, names: tuple[str, ...]) -> Held:
    place = f"join {number}"
    if not isinstance(table, dict):
        raise ModelError(f"{place}: expected a table of keys, got {spell(table)}")
    keys = cast(dict[str, Any], table)
    for key in keys:
        if key not in _KEYS:
            raise ModelError(f"{place}: unknown key {key!r}{nearest(key, _KEYS)}; it has {', '.join(_KEYS)}")
    first, second = (_side(keys.get(key), f"{place}: {key}", names) for key in ("first", "second"))
    order, ratio = keys.get("order", "G1"), keys.get("ratio", 1.0)
    if order not in ORDERS:
        raise ModelError(f"{place}: order: expected one of {', '.join(ORDERS)}, got {spell(order)}")
    if isinstance(ratio, bool) or not isinstance(ratio, int | float) or not 0.0 < ratio < float("inf"):
        raise ModelError(f"{place}: ratio: expected a finite number greater than 0, got {spell(ratio)}")
    rule = Held(first, second, str(order), float(ratio))
    if rule.patches[0] == rule.patches[1]:
        raise ModelError(f"{place}: {first} and {second}: expected sides of two patches, got two of one")
    return rule


def _side(value: Any, place: str, names: tuple[str, ...]) -> str:
    if not isinstance(value, str) or value.rpartition(":")[2] not in SIDES or ":" not in value:
        raise ModelError(f'{place}: expected "PATCH:SIDE" with a side of {", ".join(SIDES)}, got {spell(value)}')
    name = value.rpartition(":")[0]
    if name not in names:
        raise ModelError(f"{place}: no patch {name!r}{nearest(name, names)}; the model has {', '.join(names[:12])}")
    return value


def _in_order(rules: tuple[Held, ...], names: tuple[str, ...]) -> tuple[Held, ...]:
    """Return the joins so that every patch is moved before others follow it."""
    waiting, result = list(rules), list[Held]()
    while waiting:
        moving = {rule.patches[1] for rule in waiting}
        ready = [rule for rule in waiting if rule.patches[0] not in moving]
        if not ready:
            circle = ", ".join(f"{rule.first} leads {rule.second}" for rule in waiting)
            raise ModelError(f"join: the joins run in a circle ({circle}); leave one of them out")
        # A patch held on several sides moves once, when all that lead it stand.
        later = {rule.patches[1] for rule in waiting if rule not in ready}
        now = [rule for rule in ready if rule.patches[1] not in later] or ready
        result += sorted(now, key=lambda rule: names.index(rule.patches[1]))
        waiting = [rule for rule in waiting if rule not in now]
    return tuple(result)
