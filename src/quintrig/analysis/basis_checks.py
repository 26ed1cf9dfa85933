"""What a paper derives of its basis by hand, found by looking: partition of unity, sign, ends, symmetry, space."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from quintrig.analysis.basis_ends import Claim, check_claim, compared, derivative_words, end_formulas
from quintrig.analysis.basis_samples import TIMES, Finding, Samples
from quintrig.analysis.basis_sign import HOW, certified
from quintrig.analysis.basis_space import circles, condition, independence, spans, total_positivity
from quintrig.basis.formula_checks import corners
from quintrig.basis.formulas import MOST_PARAMETERS, Basis
from quintrig.basis.rational import NotRationalError
from quintrig.support.arrays import FloatArray

_TIGHT = 1e-12
_BESIDE = "from the first derivative at that end that is not 0"
_LONGEST = 300  # letters of an end derivative that is told as a formula
_IN_GENERAL = (np.arange(1, MOST_PARAMETERS + 1) * 0.618034) % 0.8 + 0.1  # shares of ranges, none special
_FARTHEST = 16.0  # widths of the range in which a wider one is sought

PROPERTIES = {
    "partition_of_unity": "the functions sum to 1",
    "non_negative": "no function is negative",
    "end_points": "the curve starts at the first control point and ends at the last",
    "symmetry": "f_i(t) = f_(n-i)(1 - t) for the same parameters",
    "symmetry_with_swap": "the same with the parameters in reverse order",
    "independent": "the functions are linearly independent",
    "linear_precision": "t lies in their space, so that a straight segment can run evenly",
    "total_positivity": "no minor of the collocation matrix is negative: the curve wiggles no more than its polygon",
    "lines": "1 and t lie in their space",
    "circles": "1, cos ωt and sin ωt lie in their space",
    "end_torsion": "torsion at both ends can be other than zero",
}
"""What each property says."""


@dataclass(frozen=True)
class BasisReport:
    """What was found of a basis: a ``Finding`` for each of ``PROPERTIES``, and values for the starting parameters.

    ``end_derivatives`` holds, for t = 0 and 1, the coefficients of derivatives 0 to 3 on the control points;
    ``end_formulas`` the same as formulas in the parameters, None without SymPy; ``claims`` what the source says of
    them.
    """

    name: str
    source: str
    size: int
    functions: tuple[str, ...]
    parameters: dict[str, dict[str, Any]]
    findings: dict[str, Finding]
    non_negative_range: dict[str, tuple[float | None, float | None]]
    end_derivatives: dict[str, list[list[float]]]
    rational_degree: int | None
    condition: float
    end_formulas: dict[str, list[list[str]]] | None = None
    claims: tuple[Claim, ...] = ()

    def derivative(self, end: str, order: int) -> str:
        """Return an end derivative in words: by formulas, or by numbers for the starting parameters."""
        if self.end_formulas is not None:
            words = derivative_words(self.end_formulas[end][order])
            if len(words) <= _LONGEST:
                return words
        row = self.end_derivatives[end][order]
        terms = " ".join(f"{c:+.6g}*P{i}" for i, c in enumerate(row) if abs(c) > 1e-9) or "0"
        return f"{terms} for the starting parameters" if self.parameters else terms

    def as_json(self) -> dict[str, Any]:
        """Return plain data: each property true or false by its name, and under ``found`` how far off and where."""
        data = asdict(self)
        found = data.pop("findings")
        truth = {key: finding.pop("holds") for key, finding in found.items()}
        head = {key: data[key] for key in ("name", "source", "size", "parameters")}
        if not math.isfinite(self.condition):
            data["condition"] = None  # JSON has no infinity
        return head | truth | {"found": found} | data


def check_basis(basis: Basis, claims: Sequence[str] = ()) -> BasisReport:
    """Return what samples of [0, 1] and of the whole range of the parameters say of a basis, and of ``claims``.

    That no function is negative is proved where the formulas allow it. Claims are those of the basis, and these too;
    ValueError for text that is none.
    """
    samples = Samples(basis)
    values = samples.functions
    sums = samples.worst(np.abs(values.sum(axis=-1) - 1.0), _TIGHT)
    sign = samples.worst(-values.min(axis=-1), _TIGHT)
    line = spans(samples, TIMES)
    below = np.argwhere(samples.below(samples.values))
    if sign.holds and len(below):
        sign = replace(sign, holds=False, at={"t": float(below[0][1])} | samples.named(int(below[0][0])), how=_BESIDE)
    elif sign.holds and certified(basis):
        sign = replace(sign, how=HOW)
    formulas = end_formulas(basis)
    findings = {
        "partition_of_unity": sums,
        "non_negative": replace(sign, worst=-sign.worst),
        "end_points": _end_points(samples),
        "symmetry": _symmetry(samples, samples.values),
        "symmetry_with_swap": _symmetry(samples, samples.values[:, ::-1]),
        "independent": independence(samples),
        "linear_precision": line,
        "total_positivity": total_positivity(samples),
        "lines": spans(samples, np.ones_like(TIMES), TIMES),
        "circles": circles(samples),
        "end_torsion": _end_torsion(samples),
    }
    start = samples.values[:1]
    ends = samples.derivatives(start, np.array([0.0, 1.0]), 3)[:, 0]
    return BasisReport(
        basis.name,
        basis.source,
        basis.size,
        basis.functions,
        {p.name: {"low": p.low, "high": p.high, "start": p.start, "range": p.range} for p in basis.parameters},
        findings,
        {one.name: _range(samples, i, sign.holds) for i, one in enumerate(basis.parameters)},
        {str(end): ends[:, end].tolist() for end in (0, 1)},
        _degree(basis),
        condition(samples),
        formulas,
        tuple(check_claim(basis, text, formulas) for text in (*basis.claims, *claims)),
    )


def _end_points(samples: Samples) -> Finding:
    ends = samples.functions[:, [0, -1]]
    wanted = np.zeros(ends.shape[1:])
    wanted[0, 0] = wanted[1, -1] = 1.0
    return samples.worst(np.abs(ends - wanted).max(axis=-1), _TIGHT, np.array([0.0, 1.0]))


def _symmetry(samples: Samples, mirrored: FloatArray) -> Finding:
    there = samples.derivatives(mirrored, TIMES, 0)[0][:, ::-1, ::-1]
    scale = np.maximum(1.0, np.abs(there).max(axis=-1))
    return samples.worst(np.abs(samples.functions - there).max(axis=-1) / scale, 1e-11)


def _end_torsion(samples: Samples) -> Finding:
    """Torsion is det(z', z'', z'''): nought for every polygon where the three rows of coefficients are dependent."""
    ends = samples.derivatives(samples.values[:1], np.array([0.0, 1.0]), 3)[1:, 0].transpose(1, 0, 2)
    rows = ends / np.maximum(np.linalg.norm(ends, axis=-1, keepdims=True), 1e-300)
    ratios = np.linalg.svd(rows, compute_uv=False)
    least = ratios[:, 2] if samples.basis.size > 3 else np.zeros(2)  # three points span a plane
    worst = int(least.argmin())
    at = {"t": float(worst)} | samples.named(0)
    return Finding(bool(least[worst] > 1e-9), float(least[worst]), at, "at the starting parameters")


def _range(samples: Samples, index: int, others: bool) -> tuple[float | None, float | None]:
    """Return the widest range of a parameter without negative functions, to about 3 digits; None for no end met.

    The other parameters take all of their range where that holds no negative function, their starting values otherwise.
    """
    one = samples.basis.parameters[index]
    rest = corners(samples.basis.parameters) if others else samples.values[:1]

    def fine(value: float) -> bool:
        at = rest.copy()
        at[:, index] = value
        least = samples.derivatives(at, TIMES, 0).min()
        return bool(np.isfinite(least) and least >= -_TIGHT and not samples.below(at).any())

    start = float(one.start or 0.0)
    if not fine(start):
        return None, None
    return tuple(_last(fine, start, start + side * _FARTHEST * (one.high - one.low)) for side in (-1.0, 1.0))  # pyright: ignore[reportReturnType]


def _last(fine: Any, inside: float, outside: float) -> float | None:
    if fine(outside):
        return None
    for _ in range(40):
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if fine(middle) else (inside, middle)
    return inside


def _degree(basis: Basis) -> int | None:
    """Return the degree for parameters in general: at some, such as the quintic's (0, 0), it is lower."""
    values = [one.low + share * (one.high - one.low) for one, share in zip(basis.parameters, _IN_GENERAL, strict=False)]
    try:
        family = basis.family(values)
        family.rational()
        return family.rational_degree()
    except NotRationalError:
        return None


def check_end_derivative(basis: Basis, end: int, order: int, claimed: Sequence[str]) -> Finding:
    """Return whether claimed coefficients, formulas in the parameters, are those of a derivative at t = 0 or 1.

    ``worst`` is the largest miss relative to the largest coefficient over the range; ``at`` names the control
    point ``i`` too.
    ValueError for another number of coefficients than functions, or formulas that cannot be read.
    """
    if len(claimed) != basis.size:
        raise ValueError(f"coefficients: expected {basis.size}, one for each control point, found {len(claimed)}")
    samples, time = Samples(basis), np.array([float(end)])
    told = Samples(Basis(basis.name, tuple(claimed), basis.parameters)).derivatives(samples.values, time, 0)[0, :, 0]
    true = samples.derivatives(samples.values, time, order)[order, :, 0]
    return compared(basis, samples, told, true, end)
