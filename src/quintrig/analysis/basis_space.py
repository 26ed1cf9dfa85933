"""What the space of a basis holds, and how well its functions span it."""

from dataclasses import replace
from typing import Any

import numpy as np

from quintrig.analysis.basis_samples import TIMES, Finding, Samples
from quintrig.support.arrays import FloatArray

_TIGHT = 1e-10
_MINORS = 60  # of each size and each sample of the parameters


def independence(samples: Samples) -> Finding:
    """Return whether the functions are independent; ``worst`` is the least ratio of their singular values."""
    sizes = np.linalg.svd(samples.functions, compute_uv=False)
    ratio = sizes[:, -1] / sizes[:, 0]
    found = samples.worst(-ratio, -1e-13)
    return replace(found, worst=-found.worst)


def condition(samples: Samples) -> float:
    """Return the condition number of the sampled functions at the starting parameters."""
    sizes = np.linalg.svd(samples.functions[0], compute_uv=False)
    return float(sizes[0] / sizes[-1]) if sizes[-1] > 0.0 else float("inf")


def spans(samples: Samples, *targets: FloatArray) -> Finding:
    """Return whether functions given at the sampled times lie in the space, over the whole range."""
    wanted = np.stack(targets, axis=-1)
    missed: list[FloatArray] = []
    for functions in samples.functions:
        missed.append(_missed(functions, wanted))
    return samples.worst(np.stack(missed), _TIGHT)


def circles(samples: Samples) -> Finding:
    """Return whether 1, cos ωt and sin ωt lie in the space for ω = π/2, π, 2π or a parameter, at the starting ones."""
    functions = samples.functions[0]
    rates = [0.5 * np.pi, np.pi, 2.0 * np.pi, *(value for value in samples.basis.starts if value > 0.01)]
    best = Finding(False, float("inf"), {})
    for rate in rates:
        wanted = np.stack([np.ones_like(TIMES), np.cos(rate * TIMES), np.sin(rate * TIMES)], axis=-1)
        off = _missed(functions, wanted)
        worst = float(off.max())
        if worst < best.worst:
            at = {"t": float(TIMES[off.argmax()]), "omega": float(rate)} | samples.named(0)
            best = Finding(worst <= _TIGHT, worst, at, "sampled at the starting parameters")
    return best


def total_positivity(samples: Samples) -> Finding:
    """Return whether sampled minors of the collocation matrix are non-negative; ``worst`` is the least, scaled."""
    random, size = np.random.default_rng(7), samples.basis.size
    worst: list[FloatArray] = []
    for functions in samples.functions:
        least = np.inf
        scaled = functions / np.maximum(np.abs(functions).max(axis=0), 1e-300)
        for order in range(1, min(size, 6) + 1):
            rows = np.sort(random.random((_MINORS, len(TIMES))).argsort(axis=1)[:, :order], axis=1)
            columns = np.sort(random.random((_MINORS, size)).argsort(axis=1)[:, :order], axis=1)
            minors = np.linalg.det(scaled[rows[:, :, None], columns[:, None, :]])
            least = min(least, float(minors.min()))
        worst.append(np.asarray(-least))
    found = samples.worst(np.array(worst), 1e-12)
    return replace(found, worst=-found.worst, how="sampled minors")


def _missed(functions: FloatArray, wanted: FloatArray) -> FloatArray:
    """Return by how much the best sums of functions miss what is wanted at each time, the largest of the columns."""
    solver: Any = np.linalg.lstsq  # its stubs leave the result untyped
    fitted: FloatArray = solver(functions, wanted, rcond=None)[0]
    return np.abs(functions @ fitted - wanted).max(axis=-1)
