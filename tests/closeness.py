"""What a quantity may be off by rounding: its natural size at each point, and where points are sound enough."""

import numpy as np

from quintrig.quantities.table import BY_KEY

# The invariants in the horizontal plane grow by these powers of 1/n_z; their rounding by one more.
STEEP = {"beta0": 2, "beta1": 3, "beta2": 4, "gamma1": 5, "gamma2": 4, "gamma3": 3}
HEIGHT = tuple(key + suffix for suffix in ("", "_surface") for key in STEEP)
"""Quantities that depend on which way is up, beside ``invariant_type``."""


def sound(sample, speed=0.1, sine=0.1):
    """True where u and v move the point by a fair part of the size, and not in nearly the same direction."""
    e, f, g = sample["E"], sample["F"], sample["G"]
    with np.errstate(invalid="ignore", divide="ignore"):
        moves = (e >= (speed * sample.size) ** 2) & (g >= (speed * sample.size) ** 2)
        return moves & (1 - f * f / (e * g) >= sine**2) & np.isfinite(sample["mean"])


def natural(sample, key):
    """Return the size, at each point, that rounding errors of a quantity are relative to; infinite for no bound."""
    curved = np.maximum(sample["curvedness"], 1e-3 / sample.size)
    u, v = np.sqrt(sample["E"]), np.sqrt(sample["G"])
    lengths = {"E": u * u, "F": u * v, "G": v * v, "L": curved * u * u, "M": curved * u * v, "N": curved * v * v}
    if key in lengths:
        return lengths[key]
    if key == "point":
        return np.full_like(u, sample.size)
    if key == "shape_index":
        return curved / np.maximum(sample["curvedness"], 1e-300)
    if key.startswith("direction"):
        gap = sample["k1"] - sample["k2"]
        return np.where(gap > 1e-3 * curved, curved / np.maximum(gap, 1e-300), np.inf)
    scale = curved ** -BY_KEY[key].power
    if key in STEEP:
        rise = np.abs(sample.normal[..., 2])
        return np.where(rise > 1e-3, scale / np.maximum(rise, 1e-3) ** (STEEP[key] + 1), np.inf)
    return scale


def off(found, expected, scale):
    """Return the largest difference in terms of ``scale``, which has the shape of the points; NaN must meet NaN."""
    found, expected = np.asarray(found), np.asarray(expected)
    if found.ndim > np.ndim(scale):
        scale = np.asarray(scale)[..., None]
    finite = np.broadcast_to(np.isfinite(scale), found.shape)
    found, expected, scale = found[finite], expected[finite], np.broadcast_to(scale, found.shape)[finite]
    same = (found == expected) | (np.isnan(found) & np.isnan(expected))
    with np.errstate(invalid="ignore", divide="ignore"):
        error = np.where(same, 0.0, np.abs(found - expected) / scale)
    return float(np.where(np.isnan(error), np.inf, error).max(initial=0.0))


@np.errstate(invalid="ignore", divide="ignore")
def clear(sample, key):
    """True where a class is so far from the next one that rounding cannot change it."""
    curved = sample["curvedness"]
    away = curved * sample.size > 1e-2
    if key == "shape_class":
        breaks = np.array([-7, -5, -3, -1, 1, 3, 5, 7]) / 8
        return away & (np.abs(sample["shape_index"][..., None] - breaks).min(axis=-1) > 1e-4)
    if key == "invariant_type":
        half, det = 0.5 * sample["beta1"], sample["beta2"]
        root = np.sqrt(np.maximum(2 * half**2 - det, 1e-300))
        return away & (np.abs(sample.normal[..., 2]) > 0.05) & _decided(half / root) & _decided(det / root**2)
    gap = 0.5 * (sample["k1"] - sample["k2"])
    return away & _decided(sample["gaussian"] / curved**2) & _decided(sample["mean"] / curved) & _decided(gap / curved)


def _decided(ratio):
    """True well above the threshold of 1e-6 under which a ratio counts as zero, and well below."""
    return (np.abs(ratio) > 1e-4) | (np.abs(ratio) < 1e-8)
