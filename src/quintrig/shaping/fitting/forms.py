"""What is fitted: nets of control points that depend on fewer unknowns, by the kind of surface.

A form says which functions blend the net at given shape parameters, how the net follows from its unknowns q, and what
the keys of a model file are. All but the swung surface are affine in q.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.formulas import Parameter
from quintrig.basis.functions import Functions
from quintrig.basis.joined import Joined
from quintrig.basis.library import Entry
from quintrig.basis.pairs import families, names, pair, parameters
from quintrig.basis.registry import Choice, entry
from quintrig.geometry.constructions import reflected
from quintrig.geometry.surface import Net, Surface
from quintrig.shaping.fitting.corners import through
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import sparse_

KINDS = ("tensor", "symmetric", "swept", "swung", "ruled")
"""Kinds of control points that can be fitted."""

USUAL = 6
"""Control points of a direction where the basis takes so many and nobody says another number."""


@dataclass(frozen=True)
class Form:
    """A kind on bases in u and v, with so many control points each way, in ``grid`` patches joined with ``order``.

    ``corners`` (4, 3) are passed through at (u, v) = (0, 0), (1, 0), (1, 1) and (0, 1).
    """

    kind: str
    choices: tuple[Choice, Choice]
    counts: tuple[int, int]
    grid: tuple[int, int] = (1, 1)
    order: int = 2
    mirror: FloatArray | None = field(default=None, compare=False)
    values: tuple[float, ...] = ()
    corners: FloatArray | None = field(default=None, compare=False)

    @cached_property
    def ranges(self) -> dict[str, Parameter]:
        """The shape parameters by name."""
        own = [one for choice, n in zip(self.choices, self.counts, strict=True) for one in parameters(choice, n)]
        return dict(zip(names(self.choices, self.counts), own, strict=True))

    @cached_property
    def energies(self) -> dict[bytes, FloatArray]:
        """The quadratic form of the thin-plate energy of a patch, by the shape parameters that were asked for last."""
        return {}

    @property
    def places(self) -> tuple[str, str]:
        """What the two polygons are called in errors."""
        two = {"ruled": ("first", "second"), "swept": ("section", "trajectory"), "swung": ("profile", "trajectory")}
        return two.get(self.kind, ("points", "points[0]"))

    def families(self, theta: FloatArray) -> tuple[Functions, Functions]:
        """Return the functions in u and v of every patch, at values of the shape parameters."""
        values = theta.tolist() if len(theta) else None
        u, v = families(self.choices, self.counts, self.places, values, False)
        return (Joined((u, v)), Bernstein(1)) if self.kind == "ruled" else (u, v)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the net of one patch."""
        return (sum(self.counts), 2) if self.kind == "ruled" else self.counts

    @property
    def patches(self) -> int:
        """Number of patches."""
        return self.grid[0] * self.grid[1]

    @cached_property
    def affine(self) -> tuple[Any, FloatArray]:
        """The matrix and the constant part by which all nets, in one row, follow from the unknowns."""
        if self.corners is None:
            return self._unheld
        other = np.array([one.low + 0.37 * (one.high - one.low) for one in self.ranges.values()])
        u, v = self._ends(self.starts)
        if any(np.abs(one - two).max() > 1e-9 for one, two in zip((u, v), self._ends(other), strict=True)):
            raise ValueError("corners: expected a basis whose corners stay where shape parameters change; take another")
        return through(self.corners, self._unheld, (u, v), self.grid, self.kind)

    def _ends(self, theta: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the values of the functions in u and v at 0 and 1."""
        u, v = (one.derivatives(np.array([0.0, 1.0]), 0)[0] for one in self.families(theta))
        return u, v

    @cached_property
    def _unheld(self) -> tuple[Any, FloatArray]:
        n, m = self.shape
        if self.kind == "tensor":
            u, v = self.families(self.starts)
            one, other = joined_space(u, self.grid[0], self.order), joined_space(v, self.grid[1], self.order)
            both: Any = sparse_.kron(sparse_.csr_matrix(one), sparse_.csr_matrix(other), format="csr")
            # Rows run over (patch in u, i, patch in v, j); nets want (patch in u, patch in v, i, j).
            at: Any = (
                np.arange(self.grid[0] * n * self.grid[1] * m)
                .reshape(self.grid[0], n, self.grid[1], m)
                .transpose(0, 2, 1, 3)
                .ravel()
            )
            matrix: Any = sparse_.kron(both[at], sparse_.identity(3), format="csr")
            return matrix, np.zeros(int(matrix.shape[0]))
        if self.kind == "symmetric":
            half = n // 2
            unknowns = 3 * half * m
            base = self._whole(np.zeros((half, m, 3))).ravel()
            columns = [self._whole(row.reshape(half, m, 3)).ravel() - base for row in np.eye(unknowns)]
            return sparse_.csr_matrix(np.array(columns).T), base
        if self.kind == "swept":
            section = np.kron(np.repeat(np.eye(n), m, axis=0), np.eye(3))
            trajectory = np.kron(np.tile(np.eye(m), (n, 1))[:, 1:], np.eye(3))
            matrix: Any = sparse_.csr_matrix(np.concatenate([section, trajectory], axis=1))
            return matrix, np.zeros(int(matrix.shape[0]))
        first, second = self.counts  # ruled: the rest of the net is zero
        chosen = [2 * i for i in range(first)] + [2 * i + 1 for i in range(first, first + second)]
        pick = np.zeros((2 * (first + second), first + second))
        pick[chosen, np.arange(first + second)] = 1.0
        return sparse_.csr_matrix(np.kron(pick, np.eye(3))), np.zeros(6 * (first + second))

    def _whole(self, half: FloatArray) -> FloatArray:
        plane = self.mirror if self.mirror is not None else np.array([1.0, 0.0, 0.0, 0.0])
        return np.concatenate([half, reflected(half, plane)[::-1]])

    @property
    def starts(self) -> FloatArray:
        """The values that the shape parameters start from, or are fixed to."""
        if self.values:
            return np.array(self.values)
        return np.array([float(one.start or 0.0) for one in self.ranges.values()])

    def at(self, values: FloatArray) -> "Form":
        """Return the form that starts from these values of the shape parameters; ValueError outside their range."""
        for (name, one), value in zip(self.ranges.items(), values.tolist(), strict=True):
            one.value(value, f"shape ({name})")
        return replace(self, values=tuple(values.tolist()))

    def nets(self, q: FloatArray) -> FloatArray:
        """Return the nets (patches, rows, columns, 3) of unknowns."""
        n, m = self.shape
        if self.kind == "swung":
            r, z, x, y = np.split(q, np.cumsum([n, n, m]))
            return np.stack([np.outer(r, x), np.outer(r, y), np.outer(z, np.ones(m))], axis=-1)[None]
        matrix, base = self.affine
        return np.asarray(matrix @ q + base).reshape(self.patches, n, m, 3)

    def slopes(self, q: FloatArray) -> Any:
        """Return the derivatives of all nets, in one row, by the unknowns, as a sparse matrix."""
        if self.kind != "swung":
            return self.affine[0]
        n, m = self.shape
        r, _, x, y = np.split(q, np.cumsum([n, n, m]))
        result = np.zeros((n, m, 3, 2 * n + 2 * m))
        for i in range(n):
            result[i, :, 0, i], result[i, :, 1, i], result[i, :, 2, n + i] = x, y, 1.0
        for j in range(m):
            result[:, j, 0, 2 * n + j], result[:, j, 1, 2 * n + m + j] = r, r
        return sparse_.csr_matrix(result.reshape(-1, 2 * n + 2 * m))

    def surfaces(self, q: FloatArray, theta: FloatArray) -> list[Surface]:
        """Return the surfaces of all patches."""
        u, v = self.families(theta)
        return [Surface(Net(net, u), v) for net in self.nets(q)]

    def keys(self, q: FloatArray, theta: FloatArray, scale: float, centre: FloatArray) -> list[dict[str, Any]]:
        """Return the keys of every patch in a model file, of lengths scaled back and moved back to a centre."""
        labels = [str(getattr(choice, "name", choice)) for choice in self.choices]
        common: dict[str, Any] = {"kind": self.kind}
        if labels != ["trigonometric"] * 2:
            common["basis"] = labels[0] if labels[0] == labels[1] else labels
        if len(theta):
            common["shape"] = theta.tolist()
        net = self.nets(q)
        n, m = self.shape
        if self.kind == "tensor":
            return [common | {"points": (one * scale + centre).tolist()} for one in net]
        if self.kind == "symmetric":
            plane = self.mirror if self.mirror is not None else np.array([1.0, 0.0, 0.0, 0.0])
            offset = plane[3] * scale - float(plane[:3] @ centre)
            half = net[0, : n // 2] * scale + centre
            return [common | {"points": half.tolist(), "mirror": [*plane[:3].tolist(), float(offset)]}]
        if self.kind == "swept":
            section = net[0, :, 0] * scale + centre
            trajectory = (net[0, 0] - net[0, 0, 0]) * scale
            return [common | {"section": section.tolist(), "trajectory": trajectory.tolist()}]
        if self.kind == "swung":
            r, z, x, y = np.split(q, np.cumsum([n, n, m]))
            turn = float(np.hypot(x, y).mean()) or 1.0
            profile = np.stack([r * turn * scale, z * scale + centre[2]], axis=1)
            return [common | {"profile": profile.tolist(), "trajectory": (np.stack([x, y], axis=1) / turn).tolist()}]
        first = self.counts[0]
        ends = {"first": net[0, :first, 0], "second": net[0, first:, 1]}
        return [common | {name: (points * scale + centre).tolist() for name, points in ends.items()}]


def form_of(
    kind: str,
    basis: str | Sequence[str],
    counts: tuple[int, int] | None,
    grid: tuple[int, int],
    order: int,
) -> Form:
    """Return a form by the names of its kind and bases; ValueError where they do not go together."""
    chosen = pair(basis if isinstance(basis, str) else list(basis))
    choices = (
        entry(chosen[0]) if isinstance(chosen[0], str) else chosen[0],
        entry(chosen[1]) if isinstance(chosen[1], str) else chosen[1],
    )
    sizes = counts or (_usual(choices[0]), _usual(choices[1]))
    if grid != (1, 1) and kind != "tensor":
        raise ValueError(f"patches: expected 1x1 for a {kind} surface, got {grid[0]}x{grid[1]}; take kind tensor")
    if kind == "symmetric" and sizes[0] % 2:
        raise ValueError(f"size: expected an even number of points in u for a symmetric surface, got {sizes[0]}")
    form = Form(kind, choices, (int(sizes[0]), int(sizes[1])), grid, order)
    _ = form.families(form.starts)  # which says where a basis does not take so many points
    return form


def _usual(choice: Choice) -> int:
    if isinstance(choice, Entry):
        return USUAL if USUAL in choice.sizes else choice.usual
    return getattr(choice, "size", USUAL)


def joined_space(functions: Functions, pieces: int, order: int) -> FloatArray:
    """Return a matrix (pieces x size, unknowns): coefficients of neighbours that join with ``order`` derivatives.

    The pieces are of equal length, so that derivatives by the parameter of each agree as they are. Its columns span all
    such coefficients; where the derivatives at an end are those of the points next to it alone, as with most bases,
    each unknown acts on one piece or two.
    """
    size, few = functions.size, order + 1
    if pieces == 1:
        return np.eye(size)
    ends = functions.derivatives(np.array([0.0, 1.0]), order)
    head, tail = ends[:, 0, :few], ends[:, 1, -few:]
    alone = np.abs(ends[:, 0, few:]).max(initial=0.0) + np.abs(ends[:, 1, :-few]).max(initial=0.0)
    if size >= 2 * few and alone <= 1e-12 * np.abs(ends).max() and np.linalg.cond(head) < 1e6:
        onward = np.linalg.solve(head, tail)  # from the last points of a piece to the first of the next
        free = size - few
        result = np.zeros((pieces * size, size + (pieces - 1) * free))
        result[:size, :size] = np.eye(size)
        for k in range(1, pieces):
            before, own = size + (k - 1) * free, size + k * free
            result[k * size : k * size + few, before - few : before] = onward
            result[k * size + few : (k + 1) * size, own - free : own] = np.eye(free)
        return result
    rows = np.zeros(((pieces - 1) * (order + 1), pieces * size))
    for seam in range(pieces - 1):
        for k in range(order + 1):
            row = rows[seam * (order + 1) + k]
            reach = float(np.abs(ends[k]).max()) or 1.0
            row[seam * size : (seam + 1) * size] = ends[k, 1] / reach
            row[(seam + 1) * size : (seam + 2) * size] = -ends[k, 0] / reach
    _, values, right = np.linalg.svd(rows, full_matrices=True)
    rank = int((values > 1e-12 * values[0]).sum())
    return right[rank:].T
