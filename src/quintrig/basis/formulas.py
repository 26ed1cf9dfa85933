"""A basis as data: name, source, parameters with ranges, and its functions as formulas in the small grammar."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.expression import series, values_of
from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.basis.grammar import RESERVED, Node, parse
from quintrig.basis.rational import NotRationalError, TangentMap
from quintrig.support import taylor
from quintrig.support.arrays import FloatArray, number, parameter

if TYPE_CHECKING:
    from quintrig.basis.exact_forms import Span
    from quintrig.basis.tape import Tape

MOST_FUNCTIONS, MOST_PARAMETERS = 64, 24
"""Most functions and most parameters of a basis."""


@dataclass(frozen=True)
class Parameter:
    """A shape parameter: its name, its range (ends that are ``open`` left out) and the value that it starts from."""

    name: str
    low: float
    high: float
    start: float | None = None
    open: tuple[bool, bool] = (False, False)

    def __post_init__(self) -> None:
        """Check the name and the range once, at birth."""
        if not (isinstance(self.name, str) and self.name.isidentifier() and self.name.isascii()):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise ValueError(f"parameters: expected a name of letters, digits and _, found {str(self.name)[:60]!r}")
        if len(self.name) > 30 or self.name in RESERVED:
            why = "longer than 30 letters" if len(self.name) > 30 else "taken by the grammar"
            raise ValueError(f"parameters: {self.name[:40]!r} is {why}; choose another name")
        for end in ("low", "high"):
            object.__setattr__(self, end, number(getattr(self, end), f"parameters.{self.name}"))
        if not self.low < self.high:
            raise ValueError(
                f"parameters.{self.name}: expected a range [low, high] with low < high, "
                f"found [{self.low:g}, {self.high:g}]"
            )
        start = self.start
        if start is None:
            start = 0.0 if self.holds(0.0) else 0.5 * (self.low + self.high)
        object.__setattr__(self, "start", start)

    def holds(self, value: float) -> bool:
        """Return whether a value is in the range."""
        above = value > self.low if self.open[0] else value >= self.low
        return above and (value < self.high if self.open[1] else value <= self.high)

    def value(self, value: float, name: str = "", unchecked: bool = False) -> float:
        """Return a value as float; ValueError, naming ``name``, outside the range unless ``unchecked``."""
        value, name = number(value, name or self.name), name or self.name
        if not unchecked and not self.holds(value):
            raise ValueError(
                f"{name} = {value:g} is outside {self.range}, the range of this basis; choose a value in the range, "
                "or set unchecked_shape = true and lose what the range warrants, such as the convex-hull property"
            )
        return value

    @property
    def range(self) -> str:
        """The range in words, such as ``[-4, 1]``."""
        left, right = "(" if self.open[0] else "[", ")" if self.open[1] else "]"
        return f"{left}{self.low:g}, {self.high:g}{right}"


@dataclass(frozen=True)
class Basis:
    """Functions on [0, 1] as formulas: what a paper, a model file or an installed package says of a basis.

    Raises ValueError naming the function, the character, what was expected and what was found, also for formulas that
    divide by zero, leave the real numbers or overflow somewhere in the range of the parameters.
    """

    name: str
    functions: tuple[str, ...]
    parameters: tuple[Parameter, ...] = ()
    source: str = ""
    claims: tuple[str, ...] = ()
    """What the source says of end derivatives, such as ``z'(0) = 3*(P1 - P0)``: the referee looks whether it is so."""
    vouched: bool = field(default=False, repr=False, compare=False)
    """Whether the formulas are quintrig's own, whose values the tests check, so that no command need do it again."""

    def __post_init__(self) -> None:
        """Parse the formulas once, at birth."""
        if isinstance(self.functions, str):
            raise ValueError(  # noqa: TRY004 — a mistake in a file, told as one
                f"functions: expected a list of formulas, found {self.functions[:60]!r}"
            )
        object.__setattr__(self, "functions", tuple(self.functions))
        object.__setattr__(self, "parameters", tuple(self.parameters))
        count, names = len(self.functions), [one.name for one in self.parameters]
        if not 2 <= count <= MOST_FUNCTIONS:
            raise ValueError(f"functions: expected 2 to {MOST_FUNCTIONS} formulas, found {count}")
        if len(names) > MOST_PARAMETERS:
            raise ValueError(f"parameters: expected at most {MOST_PARAMETERS}, found {len(names)}")
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise ValueError(f"parameters: {twice!r} is listed twice; give each a name of its own")
        if not self.vouched:
            from quintrig.basis.formula_checks import check_values

            check_values(self.trees, self.parameters)

    @property
    def size(self) -> int:
        """Number of functions."""
        return len(self.functions)

    @cached_property
    def trees(self) -> tuple[Node, ...]:
        """The functions, parsed."""
        names = [one.name for one in self.parameters]
        result: list[Node] = []
        for i, text in enumerate(self.functions):
            try:
                result.append(parse(text, names))
            except ValueError as error:
                raise ValueError(f"functions[{i}]: {error}") from None
        return tuple(result)

    @cached_property
    def partition(self) -> bool:
        """Whether the functions sum to 1 on all of [0, 1] and of the range, as far as samples show."""
        return self.off_sum[0] <= 1e-12

    @cached_property
    def off_sum(self) -> tuple[float, str]:
        """By how much the sum misses 1 at worst, in samples of [0, 1] and of the range, and what it is where."""
        from quintrig.basis.formula_checks import sums

        return sums(self.trees, self.parameters)

    def family(self, values: Sequence[float] = (), unchecked: bool = False) -> "Formulas":
        """Return the functions at values of the parameters, their starting ones if there are none given."""
        return Formulas(self, tuple(values) or self.starts, unchecked)

    @property
    def starts(self) -> tuple[float, ...]:
        """The values that the parameters start from."""
        return tuple(float(one.start or 0.0) for one in self.parameters)


@dataclass(frozen=True)
class Formulas(Functions):
    """The functions of a basis given by formulas, at ``values`` of its parameters.

    Values outside their range raise ValueError unless ``unchecked``.
    """

    basis: Basis
    values: tuple[float, ...] = ()
    unchecked: bool = False

    def __post_init__(self) -> None:
        """Check the values once, at birth."""
        wanted = self.basis.parameters
        if len(self.values) != len(wanted):
            names = f" ({', '.join(one.name for one in wanted)})" if wanted else ""
            raise ValueError(
                f"shape: expected {len(wanted)} shape parameters{names} for the basis {self.basis.name!r}, "
                f"found {len(self.values)}"
            )
        checked = (one.value(value, unchecked=self.unchecked) for one, value in zip(wanted, self.values, strict=True))
        object.__setattr__(self, "values", tuple(checked))

    @property
    def name(self) -> str:
        """The name of the basis."""
        return self.basis.name

    @property
    def label(self) -> str:
        """The name of the basis, under which constructions take it."""
        return self.basis.name

    @property
    def outside(self) -> bool:
        """Whether a shape parameter is outside its range."""
        return not all(one.holds(value) for one, value in zip(self.basis.parameters, self.values, strict=True))

    @property
    def caveats(self) -> tuple[str, ...]:
        """That the surface moves with the origin, and that parameters lie outside their range, where it is so."""
        told: list[str] = []
        if not self.partition:
            told.append(
                f"The functions of the basis {self.label} do not sum to 1 ({self.basis.off_sum[1]}): the surface "
                "moves with the origin, and its shape hangs on where that is."
            )
        wrong = [
            f"{one.name} = {value:g} outside {one.range}"
            for one, value in zip(self.basis.parameters, self.values, strict=True)
            if not one.holds(value)
        ]
        if wrong:
            told.append(f"{', '.join(wrong)}: the convex-hull property may be lost.")
        return tuple(told)

    @property
    def size(self) -> int:
        """Number of functions."""
        return self.basis.size

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1."""
        return self.basis.partition

    @property
    def parameters(self) -> dict[str, float]:
        """The shape parameters by name."""
        return {one.name: value for one, value in zip(self.basis.parameters, self.values, strict=True)}

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        return taylor.derivatives(series(self.basis.trees, t, order, values_of(self.parameters)))

    def increments(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` of the F_i, (order + 1, *t.shape, terms); ValueError outside [0, 1].

        F_i' = f_{i+1}' + ... + f_n' = -(f_0' + ... + f_i'): summed over the functions that vanish at the nearer end,
        where the others would cancel.
        """
        t = parameter(t, "t")
        derived = self.derivatives(t, order)
        if not self.partition:
            return derived
        result = np.cumsum(derived[..., :0:-1], axis=-1)[..., ::-1]
        if order:
            result[1:] = np.where((t < 0.5)[..., None], result[1:], -np.cumsum(derived[1:, ..., :-1], axis=-1))
        return result

    def fill(self, t: FloatArray, out: FloatArray, still: Still = MOVING) -> None:
        """Write derivatives 0 to 2 of the F_i at blocks of BLOCK parameters (blocks, BLOCK) to ``out``, compiled."""
        self._tape.fill(t, self.partition, out)

    @cached_property
    def _tape(self) -> "Tape":
        from quintrig.basis.tape import tape

        return tape(self.basis.trees, self.parameters)

    def tangent_map(self) -> TangentMap | None:
        """Return the change of parameter that the rational form needs; NotRationalError where there is none."""
        from quintrig.basis import formula_rational

        try:
            found = formula_rational.tangent_map(self.basis.trees, self.parameters)
            formula_rational.forms(self.basis.trees, self.parameters, found or TangentMap())
        except NotRationalError as error:
            raise NotRationalError(
                f"the functions of the basis {self.label!r} have no exact rational form: {error}"
            ) from None
        return found

    def rational_degree(self) -> int:
        """Return the degree of the rational form as the formulas give it; NotRationalError where there is none."""
        from quintrig.basis import formula_rational

        to = self.tangent_map() or TangentMap()
        return max(len(form) - 1 for form in formula_rational.forms(self.basis.trees, self.parameters, to))

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the numerators' coefficients (n, size) in ``degree`` over the common weights of ``to``."""
        from quintrig.basis import formula_rational

        return formula_rational.numerators(self.basis.trees, self.parameters, to, degree)

    def exact(self) -> "tuple[Span, ...]":
        """Return the functions as forms with exact coefficients; NotRationalError where they are none."""
        from quintrig.basis import formula_exact

        return formula_exact.spans(self.basis.trees, self.parameters, self.tangent_map())
