"""The edge of regression of a developable, where it lies inside the strip: drawn and warned of, never passed over."""

import numpy as np

from quintrig.developables.regression import inner_regression
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray


def regression_note(surface: Surface) -> str:
    """Return a warning where the edge of regression of a developable lies inside the strip, else nothing."""
    found = inner_regression(surface)
    if found is None:
        return ""
    spans = ", ".join(f"{low:.3g} to {high:.3g}" for low, high in found.intervals)
    return (
        f"Warning: the edge of regression (magenta line) lies inside the strip for u from {spans}; "
        "the surface is singular along it"
    )


def regression_lines(surface: Surface) -> list[FloatArray]:
    """Return the pieces (n, 3) of the edge of regression that lie inside the strip of a developable, length¹."""
    return [surface(line[:, 0], line[:, 1]) for line in regression_parameters(surface)]


def regression_parameters(surface: Surface) -> list[FloatArray]:
    """Return the pieces of the edge of regression inside the strip of a developable as (u, v), each (n, 2)."""
    found = inner_regression(surface)
    if found is None:
        return []
    lines: list[FloatArray] = []
    ends = np.flatnonzero(np.diff(np.concatenate([[False], found.inside, [False]]).astype(np.int8)))
    for start, end in zip(ends[::2], ends[1::2], strict=True):
        line = np.stack([found.u[start:end], np.clip(found.v[start:end], 0.0, 1.0)], axis=-1)
        lines.append(line[np.isfinite(line).all(axis=1)])
    return lines
