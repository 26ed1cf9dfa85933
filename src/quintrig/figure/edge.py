"""The edge of regression of a developable, where it lies inside the strip: drawn and warned of, never passed over."""

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.envelope import regression
from quintrig.sample import analyse, grid
from quintrig.surface import Surface

_DEVELOPABLE = 1e-8  # |K| within this share of C² everywhere: an edge of regression means something


def regression_intervals(surface: Surface) -> tuple[tuple[float, float], ...]:
    """Return the ranges of u where the edge of regression is inside; none where it is no ruled developable."""
    try:
        found = regression(surface)
    except ValueError:
        return ()
    sample = analyse(surface, *grid(17, 5), ("gaussian", "curvedness"))
    bent = np.abs(sample["gaussian"]) > _DEVELOPABLE * sample["curvedness"] ** 2
    return () if np.any(bent) else found.intervals


def regression_note(surface: Surface) -> str:
    """Return a warning where the edge of regression of a developable lies inside the strip, else nothing."""
    intervals = regression_intervals(surface)
    if not intervals:
        return ""
    spans = ", ".join(f"{low:.3g} to {high:.3g}" for low, high in intervals)
    return (
        f"Warning: the edge of regression (magenta line) lies inside the strip for u from {spans}; "
        "the surface is singular along it"
    )


def regression_lines(surface: Surface) -> list[FloatArray]:
    """Return the pieces (n, 3) of the edge of regression that lie inside the strip of a developable, length¹."""
    return [surface(line[:, 0], line[:, 1]) for line in regression_parameters(surface)]


def regression_parameters(surface: Surface) -> list[FloatArray]:
    """Return the pieces of the edge of regression inside the strip of a developable as (u, v), each (n, 2)."""
    if not regression_intervals(surface):
        return []
    found = regression(surface)
    lines: list[FloatArray] = []
    ends = np.flatnonzero(np.diff(np.concatenate([[False], found.inside, [False]]).astype(np.int8)))
    for start, end in zip(ends[::2], ends[1::2], strict=True):
        line = np.stack([found.u[start:end], np.clip(found.v[start:end], 0.0, 1.0)], axis=-1)
        lines.append(line[np.isfinite(line).all(axis=1)])
    return lines
