"""The inventory of what is rebuilt: which figure or table, what it shows, from which model."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, cast

from quintrig.model.model import Model
from quintrig.support.errors import ArgumentError, nearest
from quintrig.support.parsing import parse

_NAME = re.compile(r"(?:(?P<kind>fig|tab)[a-z]*\.?[\s-]*)?(?P<number>a?\d+(?:\.\d+)?)")
"""Such as ``4.3``, ``Fig. 4.3`` or ``table-a1``, in small letters."""


@dataclass(frozen=True)
class Item:
    """A numbered figure or table: ``number`` and ``title`` are the thesis's, ``draw`` names what builds it.

    ``parts`` are the captions of (a), (b), ...; ``shapes`` and ``scales`` what is varied, as the builder reads it;
    ``note`` says where the control points come from.
    """

    kind: str
    number: str
    title: str
    draw: str
    note: str
    models: tuple[str, ...]
    parts: tuple[str, ...]
    shapes: tuple[Any, ...]
    scales: tuple[float, ...]

    @property
    def name(self) -> str:
        """Name for people, such as ``Figure 4.3``."""
        return f"{self.kind.capitalize()} {self.number}"

    @property
    def key(self) -> str:
        """Name for files and anchors, such as ``figure-4.3``."""
        return f"{self.kind}-{self.number}"


@cache
def inventory() -> tuple[Item, ...]:
    """Return every item, in the order of the thesis."""
    data = _data()
    origin = cast(dict[str, str], data["origin"])
    return tuple(_item(row, origin) for row in cast(list[dict[str, Any]], data["item"]))


@cache
def labelled_points() -> dict[str, tuple[float, float]]:
    """Return the corresponding points that the surfaces of chapter 4 are compared at: (u, v) by label."""
    return {label: (float(u), float(v)) for label, (u, v) in _data()["points"].items()}


def model_text(name: str) -> str:
    """Return the text of a model file of the reproduction."""
    return (files("quintrig.reproduce") / "models" / f"{name}.toml").read_text(encoding="utf-8")


@cache
def model(name: str) -> Model:
    """Return a model of the reproduction by the name of its file."""
    return Model.from_dict(parse(model_text(name), ".toml"))


def chosen(numbers: Sequence[str]) -> frozenset[str]:
    """Return the keys of items by number (all that have it), name or key, such as ``4.3`` or ``Fig. 4.3``.

    ValueError for one that is not in the inventory.
    """
    found: set[str] = set()
    for text in numbers:
        named = _NAME.fullmatch(text.strip().casefold())
        kind, number = (named["kind"] or "", named["number"]) if named else ("", "")
        keys = {one.key for one in inventory() if one.number.casefold() == number and one.key.startswith(kind)}
        if not keys:
            every = list(dict.fromkeys(name for item in inventory() for name in (item.number, item.key)))
            raise ArgumentError(
                f"expected the number of a figure or table, such as 4.3 or table-4.1, found {text!r}"
                f"{nearest(text, every)}",
                "only",
                remedy="quintrig.reproduce.inventory() has all",
                key="inventory",
            )
        found |= keys
    return frozenset(found)


def inventory_text() -> str:
    """Return the inventory as a table in plain text: number, what builds it, models, title."""
    rows = [(item.name, item.draw, ", ".join(item.models) or "-", item.title) for item in inventory()]
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    lines = [
        "  ".join([*(cell.ljust(width) for cell, width in zip(row, widths, strict=False)), row[3]]) for row in rows
    ]
    return "\n".join([*lines, f"{len(rows)} items, all of which are built"])


def _item(row: dict[str, Any], origin: dict[str, str]) -> Item:
    models = row.get("models", [row["model"]] if "model" in row else [])
    shapes = row.get("shapes", [row["shape"]] if "shape" in row else [])
    return Item(
        str(row["kind"]),
        str(row["number"]),
        str(row["title"]),
        str(row["draw"]),
        origin[str(row["origin"])],
        tuple(models),
        tuple(row.get("parts", ())),
        tuple(shapes),
        tuple(row.get("scales", ())),
    )


@cache
def _data() -> dict[str, Any]:
    return parse((files("quintrig.reproduce") / "inventory.toml").read_text(encoding="utf-8"), ".toml")
