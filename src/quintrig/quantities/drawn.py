"""Which quantities a picture shows, read before anything that draws is imported."""

from collections.abc import Sequence

from quintrig.quantities.table import quantity
from quintrig.support.errors import ArgumentError


def read_quantities(names: Sequence[str]) -> list[str | None]:
    """Return the keys of quantities, None for the plain surface; ValueError for what no colour shows."""
    if "zebra" in names:
        raise ArgumentError("zebra stripes are drawn alone, in one view in space", "quantity")
    keys = [None if name == "surface" else quantity(name).key for name in names]
    for key in keys:
        if key is not None and quantity(key).kind == "vector":
            raise ArgumentError(f"{key!r} is a vector, which no colour shows", "quantity")
    return keys
