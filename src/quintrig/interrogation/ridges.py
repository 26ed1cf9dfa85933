"""Crests and troughs: lines on which a principal curvature is extreme along its own direction.

With the normal towards the viewer, a crest is where κ2 < 0 is least along its line of curvature and outweighs κ1, a
trough where κ1 > 0 is greatest and outweighs κ2 (Koenderink 1990; Ohtake, Belyaev and Seidel 2004, eq. 2 to 4). The
strength of a ridge is ∫|κ| ds, a pure number.
"""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.fields import ridge_scalar
from quintrig.interrogation.levels import Grid, Scalar, between, signed
from quintrig.interrogation.local import Local
from quintrig.interrogation.polyline import Path, changes, straight
from quintrig.support.arrays import BoolArray, FloatArray

NAMES = {1: "trough", 2: "crest"}

_HALVINGS = 20  # of a chord, to find where a ridge ends
_STEP = 1e-4  # of the domain: at which the change along a line is told
_NOISE = 1e-9  # of C²: a change of curvature that is rounding


def ridges(surface: Surface, patch: int, family: int, chord: float) -> list[Path] | None:
    """Return the crests (``family`` 2) or troughs (1) of a patch; None where the curvature is constant along lines."""
    scalar = ridge_scalar(surface, family)
    grid = Grid.of(surface, scalar)
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, grid.u[:, None], grid.v[None, :])
        curved = np.hypot(local.curvature(1), local.curvature(2)) / np.sqrt(2.0)
    values = np.abs(grid.values(0.0))
    both = np.isfinite(values) & np.isfinite(curved)
    if not both.any() or np.median(values[both]) <= _NOISE * float(np.max(curved[both])) ** 2:
        return None
    paths = grid.paths(patch, surface, 0.0, chord)
    kept = [_extreme(surface, path.uv, scalar, family) for path in paths]
    ends = iter(_ends(surface, paths, kept, scalar, family))
    return [
        part
        for path, use in zip(paths, kept, strict=True)
        for part in path.parts(use, [next(ends) for _ in changes(use)])
    ]


def _extreme(surface: Surface, uv: FloatArray, scalar: Scalar, family: int) -> BoolArray:
    """Return at which parameters (n, 2) the curvature is extreme, of the right sign, and the larger of the two."""
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, *uv.T)
        step = local.along(local.angle + (0.5 * np.pi if family == 2 else 0.0))
        step *= _STEP / np.abs(step).max(axis=1)[:, None]
        axis = local.lifted(step)
        here, there = (np.clip(uv + sense * step, 0.0, 1.0) for sense in (-1.0, 1.0))
        rise = signed(scalar(*there.T), 0.0, axis) - signed(scalar(*here.T), 0.0, axis)
        one, two = local.curvature(1), local.curvature(2)
        if family == 1:
            return (rise < 0.0) & (one > 0.0) & (one >= np.abs(two))
        return (rise > 0.0) & (two < 0.0) & (-two >= np.abs(one))


def _ends(surface: Surface, paths: list[Path], kept: list[BoolArray], scalar: Scalar, family: int) -> list[FloatArray]:
    """Return the crossings (9, 2) where the curvature ceases to be extreme, or the larger one."""
    pairs = [path.uv[[k, k + 1]] for path, use in zip(paths, kept, strict=True) for k in changes(use)]
    if not pairs:
        return []
    first = np.concatenate([use[changes(use)] for use in kept])[:, None]
    both = np.stack(pairs)
    start, end = both[:, 0], both[:, 1]
    good, bad = np.where(first, start, end), np.where(first, end, start)
    for _ in range(_HALVINGS):
        middle = between(scalar, good, bad, 0.0)
        still = _extreme(surface, middle, scalar, family)[:, None]
        good, bad = np.where(still, middle, good), np.where(still, bad, middle)
    return [straight(*places) for places in zip(start, good, end, strict=True)]
