"""Design spaces: which values the parameters of a patch take in a sweep."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, cast

import numpy as np

from quintrig.basis.pairs import key_of
from quintrig.model.patch import NamedCurve, Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ArgumentError, ModelError, nearest
from quintrig.support.numerals import real, whole

Sampling = Literal["grid", "latin", "sobol"]
LARGEST_SPACE = 10**9
LARGEST_LATIN = 10**6
"""A Latin hypercube is drawn whole, in memory; a Sobol sequence part by part."""


@dataclass(frozen=True)
class Axis:
    """One parameter from ``low`` to ``high``; ``count`` values in a grid.

    Raises ValueError for NaN, an infinity, an empty or a reversed range.
    """

    name: str
    low: float
    high: float
    count: int

    def __post_init__(self) -> None:
        """Check once, at birth."""
        name, low, high, count = self.name, self.low, self.high, self.count
        if not (math.isfinite(low) and math.isfinite(high)):
            raise self._refused("expected a finite number for either end")
        if high < low:
            raise self._refused(f"the range is reversed; write {name}={high:g}:{low:g}:{count}")
        if count < 1:
            raise self._refused(f"the range is empty; expected a count of 1 or more, got {count}")
        if high == low and count > 1:
            raise self._refused(f"the range is empty; write {name}={low:g} to hold it fixed")
        if count == 1 and high > low:
            raise self._refused("one value cannot span a range; expected a count of 2 or more")

    def _refused(self, message: str) -> ArgumentError:
        return ArgumentError(message, "axis", f"{self.name}={self.low:g}:{self.high:g}:{self.count}")

    @property
    def values(self) -> FloatArray:
        """The grid's values, both ends included."""
        return np.linspace(self.low, self.high, self.count)


def parse_axis(text: str) -> Axis:
    """Return the axis that ``name=low:high:count`` says; ``name=low:high`` has 11 values, ``name=value`` one.

    Raises ValueError for anything else, an empty or a reversed range.
    """
    name, found, rest = text.partition("=")
    name, parts = key_of(name.strip()), rest.split(":")
    form = ArgumentError("expected name=low:high:count, such as alpha1=-4:1:21", "axis", repr(text))
    if not found or not name or len(parts) not in (1, 2, 3):
        raise form
    try:
        low, high = real(parts[0]), real(parts[min(1, len(parts) - 1)])
        count = whole(parts[2]) if len(parts) == 3 else 1 if len(parts) == 1 else 11
    except ValueError:
        raise form from None
    return Axis(name, low, high, count)


@dataclass(frozen=True)
class DesignSpace:
    """Designs, numbered from 0: all combinations of the axes' values, or a sample of ``samples`` points.

    The last axis varies fastest in a grid. Raises ValueError for no axes, two of one name, or too many designs.
    """

    axes: tuple[Axis, ...]
    sampling: Sampling = "grid"
    samples: int = 0
    seed: int = 0

    def __post_init__(self) -> None:
        """Check once, at birth."""
        names = [axis.name for axis in self.axes]
        if not names:
            raise ArgumentError("expected at least one parameter", "axes", remedy="give an Axis", key="axes")
        twice = [name for name in names if names.count(name) > 1]
        if twice:
            raise ArgumentError(f"{twice[0]!r} is given twice; give each parameter once", "axes")
        if self.sampling != "grid" and self.samples < 1:
            raise ArgumentError(f"expected 1 or more for {self.sampling} sampling, got {self.samples}", "samples")
        if self.sampling == "grid" and self.samples:
            raise ArgumentError(
                "a grid has as many designs as its axes say",
                "samples",
                remedy="take the sampling 'sobol' or 'latin'",
                key="sample",
            )
        if self.seed < 0:
            raise ArgumentError(f"expected 0 or more, got {self.seed}", "seed")
        if self.sampling == "latin" and self.samples > LARGEST_LATIN:
            raise ArgumentError(
                f"expected at most {LARGEST_LATIN:,} for latin sampling, got {self.samples:,}",
                "samples",
                remedy="take the sampling 'sobol'",
                key="sobol",
            )
        if self.count > LARGEST_SPACE:
            raise ArgumentError(
                f"{self.count:,} designs are more than {LARGEST_SPACE:,}",
                "axes",
                remedy="take fewer values, or the sampling 'sobol'",
                key="space",
            )

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the varied parameters."""
        return tuple(axis.name for axis in self.axes)

    @property
    def count(self) -> int:
        """Number of designs."""
        return math.prod(axis.count for axis in self.axes) if self.sampling == "grid" else self.samples

    def designs(self, start: int, stop: int) -> FloatArray:
        """Return designs ``start`` to ``stop`` as (n, axes); each depends on its number only."""
        low = np.array([axis.low for axis in self.axes])
        high = np.array([axis.high for axis in self.axes])
        if self.sampling == "grid":
            index = np.unravel_index(np.arange(start, stop), [axis.count for axis in self.axes])
            return np.stack([axis.values[i] for axis, i in zip(self.axes, index, strict=True)], axis=-1)
        draw = _latin if self.sampling == "latin" else _sobol
        return low + (high - low) * draw(len(self.axes), self.samples, self.seed, start, stop)

    def to_dict(self) -> dict[str, Any]:
        """Return plain data that ``from_dict`` reads."""
        return {
            "axes": [[axis.name, axis.low, axis.high, axis.count] for axis in self.axes],
            "sampling": self.sampling,
            "samples": self.samples,
            "seed": self.seed,
        }

    @staticmethod
    def from_dict(data: dict[str, Any]) -> "DesignSpace":
        """Return the space that ``to_dict`` described."""
        return DesignSpace(
            tuple(Axis(str(n), float(a), float(b), int(c)) for n, a, b, c in data["axes"]),
            cast(Sampling, data["sampling"]),
            int(data["samples"]),
            int(data["seed"]),
        )


def check(space: DesignSpace, parts: Sequence[Patch | NamedCurve]) -> None:
    """Raise ValueError where no patch has such a parameter, or an end of a range is no value for one that has it."""
    known = list(dict.fromkeys(name for part in parts for name in part.definition.parameters))
    first, alone = parts[0], len(parts) == 1
    if not known and not alone:
        raise ValueError(f"none of the {len(parts)} patches has parameters to vary")
    if not known:
        basis = " in the Bernstein basis" if first.definition.classical else ""
        raise ValueError(f'patch "{first.name}": a {first.kind}{basis} has no parameters to vary')
    for axis in space.axes:
        if axis.name not in known:
            whose = f"a {first.kind} has" if alone else "the patches have"
            raise ArgumentError(
                f"unknown parameter{nearest(axis.name, known)}; {whose} {', '.join(known)}", "axis", axis.name
            )
        for part in parts:
            if axis.name in part.definition.parameters:
                _check_ends(axis, part)


def _check_ends(axis: Axis, part: Patch | NamedCurve) -> None:
    span = f"{axis.name}={axis.low:g}:{axis.high:g}"
    one = part.definition.ranges.get(axis.name)
    unchecked = bool(getattr(part.definition, "unchecked_shape", False))
    if one is not None and not unchecked and not (one.holds(axis.low) and one.holds(axis.high)):
        raise ArgumentError(f"the range leaves {one.range}; narrow it", "axis", span)
    for value in (axis.low, axis.high):
        try:
            part.with_parameters({axis.name: value})
        except ModelError as error:
            raise ArgumentError(str(error), "axis", span) from None


def _latin(dimension: int, count: int, seed: int, start: int, stop: int) -> FloatArray:
    """Return points ``start`` to ``stop`` of a Latin hypercube in the unit cube, (n, dimension)."""
    from scipy.stats import qmc

    return np.asarray(qmc.LatinHypercube(dimension, rng=seed).random(count)[start:stop], dtype=np.float64)


def _sobol(dimension: int, count: int, seed: int, start: int, stop: int) -> FloatArray:
    """Return points ``start`` to ``stop`` of a scrambled Sobol sequence, (n, dimension)."""
    from scipy.stats import qmc

    stop = min(stop, count)
    sequence = qmc.Sobol(dimension, rng=seed)
    if start:
        points = sequence.fast_forward(start).random(stop - start)
    else:
        # Drawn as a full power of two, which the sequence's balance wants, then cut.
        points = sequence.random_base2(max(0, math.ceil(math.log2(stop))))[:stop]
    return np.asarray(points, dtype=np.float64)
