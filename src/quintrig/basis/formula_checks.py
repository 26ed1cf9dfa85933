"""What can be wrong with formulas that are well spelt: division by zero, complex or infinite values, a wrong sum."""

import itertools
from collections.abc import Iterator, Sequence
from typing import Protocol

import numpy as np

from quintrig.basis.expression import node_series, series
from quintrig.basis.grammar import Binary, Call, Node, ordered
from quintrig.support.arrays import FloatArray

_MOST_CORNERS = 64
_INSET = 1e-3  # of the range, where an end of it is left out
_ZERO = 1e-9  # of the largest value: below, a denominator vanishes

_LARGEST = 1e12  # value of a function

_SAMPLES: FloatArray = 0.5 - 0.5 * np.cos(np.pi * np.linspace(0.0, 1.0, 65))
"""Parameters t, denser at the ends."""


class Ranged(Protocol):
    """A parameter with its range; ``formulas.Parameter``."""

    @property
    def name(self) -> str: ...  # noqa: D102
    @property
    def low(self) -> float: ...  # noqa: D102
    @property
    def high(self) -> float: ...  # noqa: D102
    @property
    def open(self) -> tuple[bool, bool]: ...  # noqa: D102


def corners(parameters: Sequence[Ranged]) -> FloatArray:
    """Return samples (n, len(parameters)) of the range: its corners (some of many), its centre and points between."""
    low = np.array([one.low + _INSET * (one.high - one.low) * one.open[0] for one in parameters])
    high = np.array([one.high - _INSET * (one.high - one.low) * one.open[1] for one in parameters])
    count = len(parameters)
    random = np.random.default_rng(20260101)
    if 2**count <= _MOST_CORNERS:
        ends = np.array(list(itertools.product((0.0, 1.0), repeat=count))).reshape(2**count, count)
    else:
        some = random.integers(0, 2, (_MOST_CORNERS - 2, count)).astype(np.float64)
        ends = np.concatenate([np.zeros((1, count)), np.ones((1, count)), some])
    between = random.random((7 if count else 0, count))
    return low + (high - low) * np.concatenate([ends, np.full((1, count), 0.5), between])


def check_values(trees: Sequence[Node], parameters: Sequence[Ranged]) -> None:
    """Raise ValueError, naming function and place, where formulas have no finite real value in the range."""
    nodes, samples = ordered(trees), corners(parameters)
    found = node_series(nodes, _SAMPLES[None, :], 0, _columns(parameters, samples))
    for node, inner, what in _delicate(nodes):
        shape = (len(samples), len(_SAMPLES))
        values = np.broadcast_to(found[inner][0] if found[inner].ndim else found[inner], shape)
        at = _zero(inner, isinstance(node, Call), values, samples, parameters)
        if at is not None:
            index = next(i for i, tree in enumerate(trees) if node in ordered([tree]))
            raise ValueError(f"functions[{index}]: {what} {at}; rewrite it, or narrow the range of the parameters")
    for index, tree in enumerate(trees):
        values = found[tree][0] if found[tree].ndim else found[tree]
        bad = np.argwhere(~np.broadcast_to(np.isfinite(values) & (np.abs(values) <= _LARGEST), (len(samples), 65)))
        if len(bad):
            at = _told(parameters, samples[bad[0][0]], float(_SAMPLES[bad[0][1]]))
            raise ValueError(
                f"functions[{index}]: expected values of size at most {_LARGEST:g}, found none such {at}; "
                "rewrite it, or narrow the range"
            )


def sums(trees: Sequence[Node], parameters: Sequence[Ranged]) -> tuple[float, str]:
    """Return by how much the sum of the functions misses 1 at worst, relative to the largest, and what it is where."""
    samples = corners(parameters)
    values = series(trees, _SAMPLES[None, :], 0, _columns(parameters, samples))[0]
    off = np.abs(values.sum(axis=-1) - 1.0) / np.maximum(1.0, np.abs(values).max(axis=-1))
    off, found = (np.broadcast_to(one, (len(samples), len(_SAMPLES))) for one in (off, values.sum(axis=-1)))
    row, column = np.unravel_index(int(off.argmax()), off.shape)
    where = _told(parameters, samples[row], float(_SAMPLES[column]))
    return float(off[row, column]), f"their sum is {found[row, column]:.12g} {where}"


def _columns(parameters: Sequence[Ranged], samples: FloatArray) -> dict[str, FloatArray]:
    return {one.name: samples[:, i, None] for i, one in enumerate(parameters)}


def _delicate(nodes: Sequence[Node]) -> Iterator[tuple[Node, Node, str]]:
    for node in nodes:
        if isinstance(node, Binary) and node.sign == "/":
            yield node, node.right, "divides by zero"
        if isinstance(node, Call) and node.function == "sqrt":
            yield node, node.argument, "takes the root of a number that is not positive"


def _zero(inner: Node, root: bool, values: FloatArray, samples: FloatArray, parameters: Sequence[Ranged]) -> str | None:
    """Return where a denominator, or the radicand of a ``root``, vanishes or changes sign, or None."""
    if not np.isfinite(values).all():
        return None  # told as a value that is not finite
    row, column = np.unravel_index(int(values.argmin() if root else np.abs(values).argmin()), values.shape)
    # Parameters may scale a row, so that each has its own measure of small.
    largest = np.abs(values).max(axis=1, keepdims=True)
    small = np.argwhere((np.abs(values) <= _ZERO * largest) | (root & (values < 0.0)))
    if len(small):
        row, column = small[0]
        return _told(parameters, samples[row], float(_SAMPLES[column]))
    if values.min() < 0.0 < values.max():
        sign = np.sign(values)
        turn = np.argwhere(sign[:, 1:] != sign[:, :-1])
        if len(turn):
            row, column = turn[0]
            return _told(parameters, samples[row], 0.5 * float(_SAMPLES[column] + _SAMPLES[column + 1]), "near ")
        return _told(parameters, samples[row], _SAMPLES[column], "near ")
    # It may touch zero between two samples: look closer around the least value of the worst row.
    low, high = float(_SAMPLES[max(column - 1, 0)]), float(_SAMPLES[min(column + 1, 64)])
    at = dict(zip([one.name for one in parameters], map(np.asarray, samples[row]), strict=True))
    for _ in range(4):
        t = np.linspace(low, high, 65)
        near = np.abs(series([inner], t, 0, at)[0, :, 0])
        best = int(near.argmin())
        low, high = float(t[max(best - 1, 0)]), float(t[min(best + 1, 64)])
        if near[best] <= _ZERO * largest[row, 0]:
            return _told(parameters, samples[row], float(t[best]), "near ")
    return None


def _told(parameters: Sequence[Ranged], sample: FloatArray, t: float, near: str = "at ") -> str:
    values = ", ".join(f"{one.name} = {value:.4g}" for one, value in zip(parameters, sample, strict=True))
    return f"{near}t = {t:.4g}" + (f", {values}" if values else "")
