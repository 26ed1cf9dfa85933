"""How far HK types, shape classes and the types of the invariants agree, point by point (the thesis's third objective).

HK type and shape class are two ways to cut one scale, for with R = (κ1 - κ2)/2

    H / C = -sin(πS/2),   R / C = cos(πS/2),   K / C² = -cos(πS):

K = 0 is S = ±1/2 and H = 0 is S = 0. So they cannot contradict each other. They differ only in the widths of their
bands: Besl's "= 0" is as thin as the threshold, Koenderink's classes are 1/4 wide. A point with S = 0.45 has K < 0, a
saddle ridge, but lies in the class of ridges. Such pairs, whose ranges of S overlap, are called neighbouring.

The invariants look from above. Where n points down, HK type and shape class are turned before they are compared. Then,
in the metric of the plane,

    K = β2 / (1 + β0)²,   H = (β1 + γ3) / (2 (1 + β0)^(3/2)),

so K and β2 always have one sign. H and β1 have one sign too where K >= 0, since there the Hessian has no two signs to
mix. They may differ on a saddle that is steep: a slope weighs the bending along the contour line, γ3, more than that
along steepest descent. (In the metric of the surface β1 = 2 |n_z| H from above, and nothing can differ.)
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.integrate import area_weights, orientation
from quintrig.analysis.sample import analyse
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, SHAPE_CLASSES, Thresholds
from quintrig.quantities.correspondence import (
    AGREE,
    CLASS_VERSUS_HEIGHT,
    CONFLICT,
    HK_VERSUS_CLASS,
    HK_VERSUS_HEIGHT,
    LEVELS,
    NEIGHBOURING,
    UNDEFINED,
)
from quintrig.quantities.table import mirrored
from quintrig.support.arrays import BoolArray, FloatArray, IntArray
from quintrig.support.tolerance import VERTICAL

Counts = NDArray[np.int64]


@dataclass(frozen=True)
class Reason:
    """Why the methods agree or differ at a point: a short name, the level, and the explanation."""

    name: str
    level: int
    text: str


REASONS: tuple[Reason, ...] = (
    Reason("singular", UNDEFINED, "S_u × S_v = 0 here: there is no normal, so no method says anything."),
    Reason("agree", AGREE, "All three methods say the same."),
    Reason("flat", AGREE, "All three methods say flat: the curvedness is below the threshold and S is undefined."),
    Reason(
        "class width",
        NEIGHBOURING,
        "The HK type lies on one side of K = 0 (S = ±1/2) or of H = 0 (S = 0), and the shape class, 1/4 wide in S, "
        "holds both sides.",
    ),
    Reason(
        "zero of K",
        NEIGHBOURING,
        "One of K and β2 = K (1+β0)² counts as zero and the other does not: the thresholds are relative to C² and to "
        "the size of the Hessian, which a slope makes larger.",
    ),
    Reason(
        "zero of H",
        NEIGHBOURING,
        "One of H = (β1+γ3) / (2 (1+β0)^(3/2)) and β1 counts as zero and the other does not: the slope adds γ3.",
    ),
    Reason(
        "flatness",
        NEIGHBOURING,
        "One method counts the point as flat and another does not: the Hessian of a steep surface is larger than its "
        "curvedness.",
    ),
    Reason(
        "slope",
        CONFLICT,
        "H = (β1+γ3) / (2 (1+β0)^(3/2)) and β1 differ in sign, because the surface is a saddle and steep: |γ3| > |β1|.",
    ),
    Reason("rounding", CONFLICT, "Rounding at the edge of a class: K, H and S cannot contradict each other otherwise."),
    Reason(
        "vertical",
        UNDEFINED,
        "The tangent plane is vertical (n_z = 0): the surface is no height field, the invariants are infinite.",
    ),
)
"""Index is the code in ``Agreement.reason``."""
_PLANE = HK_TYPES.index("flat")
_SINGULAR, _AGREE, _FLAT, _WIDTH, _ZERO_K, _ZERO_H, _FLATNESS, _SLOPE, _ROUNDING, _VERTICAL = range(10)

PAIRS: tuple[tuple[str, str], ...] = (
    ("hk_type", "shape_class"),
    ("hk_type", "invariant_type"),
    ("shape_class", "invariant_type"),
)
"""The pairs that are compared, as keys of quantities; in the last two HK type and shape class are seen from above."""


@dataclass(frozen=True, eq=False)
class CrossTable:
    """How often two classifications meet: ``counts`` and ``shares`` of area, shape (rows, columns), by code.

    ``levels`` (rows, columns) says which cells agree: 0 undefined, 1 agree, 2 neighbouring, 3 conflict. ``row_names``
    and ``column_names`` are the names of the codes. The shares are of the whole area.
    """

    rows: str
    columns: str
    row_names: tuple[str, ...]
    column_names: tuple[str, ...]
    levels: IntArray
    counts: Counts
    shares: FloatArray

    def share(self, level: int) -> float:
        """Return the share of a level in the area where both are defined; NaN where there is none."""
        defined = float(self.shares[self.levels != UNDEFINED].sum())
        return float(self.shares[self.levels == level].sum()) / defined if defined > 0.0 else np.nan

    def count(self, level: int) -> int:
        """Return the number of points in cells of this level."""
        return int(self.counts[self.levels == level].sum())


@dataclass(frozen=True, eq=False)
class Agreement:
    """The comparison of the three methods over a grid.

    ``u`` (nu, 1) and ``v`` (1, nv) are the grid; ``reason`` (nu, nv) indexes ``REASONS``, ``level`` (nu, nv)
    ``LEVELS``, ``weights`` (nu, nv) are shares of the area, sum 1, ``inside`` (nu, nv) is false off a trimmed face,
    whose points count nowhere. ``turned`` points were turned to be seen from above.
    """

    u: FloatArray
    v: FloatArray
    reason: IntArray
    weights: FloatArray
    inside: BoolArray
    tables: tuple[CrossTable, CrossTable, CrossTable]
    turned: int
    thresholds: Thresholds
    size: float
    orientation: str

    def __repr__(self) -> str:
        """Return one line: how many points, and the share of the area of each level."""
        agree, near, apart = (100.0 * self.share(level) for level in ("agree", "neighbouring", "conflict"))
        points = " x ".join(map(str, self.reason.shape))
        points += f", {self.count} on the face," if self.count < self.reason.size else ""
        return f"<Agreement at {points} points: {agree:.4g} % agree, {near:.4g} % near, {apart:.4g} % conflict>"

    @property
    def level(self) -> IntArray:
        """Code of the level at every point: the worst of the three comparisons."""
        return np.array([reason.level for reason in REASONS], dtype=np.int8)[self.reason]

    @property
    def count(self) -> int:
        """Number of points that count: those on the face."""
        return int(self.inside.sum())

    def counts(self) -> tuple[int, ...]:
        """Return the number of points of each reason."""
        return tuple(int(n) for n in np.bincount(self.reason[self.inside], minlength=len(REASONS)))

    def shares(self) -> tuple[float, ...]:
        """Return the share of the area of each reason, sum 1."""
        shares = np.bincount(self.reason.reshape(-1), weights=self.weights.reshape(-1), minlength=len(REASONS))
        return tuple(float(share) for share in shares)

    def share(self, level: Literal["undefined", "agree", "neighbouring", "conflict"]) -> float:
        """Return the share of the area of a level, for all three methods together."""
        code = LEVELS.index(level)
        return sum(share for share, reason in zip(self.shares(), REASONS, strict=True) if reason.level == code)

    def describe(self) -> tuple[str, ...]:
        """Return the result in words, one sentence each."""
        if self.counts()[_SINGULAR] == self.count:
            return ("Every point is singular: the surface has no area, and no method says anything.",)
        told = [
            f"The three methods agree on {self.share('agree'):.1%} of the area, name neighbouring classes on "
            f"{self.share('neighbouring'):.1%} and contradict each other on {self.share('conflict'):.1%}; on "
            f"{self.share('undefined'):.1%} one of them is undefined."
        ]
        parts = zip(REASONS, self.shares(), self.counts(), strict=True)
        told += [
            f"{reason.name}: {share:.1%} of the area, {n} points. {reason.text}" for reason, share, n in parts if n
        ]
        if self.turned:
            told.append(
                f"At {self.turned} of {self.count} points the normal points down; there HK type and shape class "
                "were turned over before they were compared with the invariants, which look from above."
            )
        return tuple(told)


def compare_methods(surface: Surface, nu: int = 65, nv: int = 65, thresholds: Thresholds | None = None) -> Agreement:
    """Compare HK types, shape classes and invariant types at nu x nv points; ValueError for fewer than 2 a side.

    Of a trimmed face the grid spans its loops, and only points inside count.
    """
    u, v = face_grid(surface, nu, nv)
    inside = surface.inside(u, v)
    keys = ("hk_type", "shape_class", "invariant_type", "normal", "E", "F", "G")
    sample = analyse(surface, u, v, keys, thresholds=thresholds)
    hk, shape, heights = (sample[key].astype(np.int8) for key in keys[:3])
    nz = sample.normal[..., 2]
    vertical = np.abs(nz) <= VERTICAL
    # Beside n_z = 0 the invariants are rounding; the class that they give there means nothing.
    heights = np.where(vertical, 0, heights).astype(np.int8)
    down = nz < -VERTICAL
    hk_above, shape_above = _turned("hk_type", hk, down), _turned("shape_class", shape, down)
    weights = area_weights(sample)
    tables = (
        _cross(PAIRS[0], hk, shape, weights, inside),
        _cross(PAIRS[1], hk_above, heights, weights, inside),
        _cross(PAIRS[2], shape_above, heights, weights, inside),
    )
    reason = _reasons(hk, shape, hk_above, heights, vertical)
    return Agreement(
        u,
        v,
        reason,
        weights,
        inside,
        tables,
        int((down & inside).sum()),
        sample.thresholds,
        sample.size,
        orientation(surface),
    )


def _turned(key: str, codes: IntArray, where: BoolArray) -> IntArray:
    names = HK_TYPES if key == "hk_type" else SHAPE_CLASSES
    over = np.array([mirrored(key, code) for code in range(len(names))], dtype=np.int8)
    return np.where(where, over[codes], codes).astype(np.int8)


def _reasons(hk: IntArray, shape: IntArray, hk_above: IntArray, heights: IntArray, vertical: BoolArray) -> IntArray:
    """Return the reason at every point; of several, the one that says most."""
    reason = np.full(hk.shape, _AGREE, dtype=np.int8)
    own = HK_VERSUS_CLASS[hk, shape]
    h_sign, k_sign = (hk_above - 1) // 3, (hk_above - 1) % 3
    b1_sign, b2_sign = (heights - 1) // 3, (heights - 1) % 3
    reason[(hk == _PLANE) & (heights == _PLANE)] = _FLAT
    reason[own == NEIGHBOURING] = _WIDTH
    reason[k_sign != b2_sign] = _ZERO_K
    reason[h_sign != b1_sign] = _ZERO_H
    reason[(hk == _PLANE) != (heights == _PLANE)] = _FLATNESS
    reason[(np.abs(h_sign - b1_sign) == 2)] = _SLOPE
    reason[(np.abs(k_sign - b2_sign) == 2) | (own == CONFLICT)] = _ROUNDING
    reason[(heights == 0)] = _VERTICAL
    reason[vertical] = _VERTICAL
    reason[(hk == 0) | (shape == 0)] = _SINGULAR
    return reason


def _cross(
    pair: tuple[str, str], row_codes: IntArray, column_codes: IntArray, weights: FloatArray, inside: BoolArray
) -> CrossTable:
    rows, columns = pair
    names = {"hk_type": HK_TYPES, "shape_class": SHAPE_CLASSES, "invariant_type": INVARIANT_TYPES}
    row_names, column_names = names[rows], names[columns]
    level = {PAIRS[0]: HK_VERSUS_CLASS, PAIRS[1]: HK_VERSUS_HEIGHT, PAIRS[2]: CLASS_VERSUS_HEIGHT}[rows, columns]
    shape = (len(row_names), len(column_names))
    index = row_codes.reshape(-1).astype(np.int64) * shape[1] + column_codes.reshape(-1)
    counts = np.bincount(index[inside.reshape(-1)], minlength=shape[0] * shape[1]).reshape(shape)
    shares: FloatArray = np.zeros(shape[0] * shape[1])
    np.add.at(shares, index, weights.reshape(-1))
    return CrossTable(rows, columns, row_names, column_names, level, counts, shares.reshape(shape))
