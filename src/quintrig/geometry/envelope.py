"""The enveloping developable: the strip that a one-parameter family of planes touches (thesis §3.3)."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bernstein import Bernstein, TangentBernstein
from quintrig.basis.functions import Functions
from quintrig.basis.pairs import families, pair
from quintrig.basis.rational import RIGHT_ANGLE, NotRationalError, TangentMap, wedge_points, without_factor
from quintrig.basis.registry import DEFAULT, Choice
from quintrig.geometry.origin import local_origin, moved_plane
from quintrig.geometry.surface import Net, Surface
from quintrig.support import taylor
from quintrig.support.arrays import FloatArray, frozen, parameter
from quintrig.support.pickled import Pickled
from quintrig.support.tolerance import NOISE

ROUNDING = 64.0 * np.finfo(np.float64).eps
"""Share of its terms at or below which the derivative of the plane is only their rounding."""


def developable(
    planes: ArrayLike,
    bounds: ArrayLike,
    shape: Sequence[float] | None = None,
    *,
    basis: Choice = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the strip enveloped by Π(t) = Σ f_i(t; α, ζ) L_i between two bounding planes (thesis §3.3.2).

    ``planes`` (6, 4), or as many as another basis has functions, and ``bounds`` (2, 4) hold (a, b, c, d) of
    a x + b y + c z + d = 0; ``shape`` is (α, ζ). The ruling at u is Π ∩ Π'; v = 0 lies on the first bounding plane,
    v = 1 on the second. K = 0. The edge of regression may fall inside: ask ``regression``. Raises ValueError for wrong
    counts or values, and where the planes envelop no strip at all.
    """
    family = frozen(planes, "planes", (None, 4))
    cuts = frozen(bounds, "bounds", (2, 4))
    (functions,) = families(pair(basis)[:1], (len(family),), ("planes",), shape, unchecked_shape)
    for name, vectors in (("planes", family), ("bounds", cuts)):
        flat = np.flatnonzero(~(np.abs(vectors[:, :3]).max(axis=1) > 0.0))
        if len(flat):
            raise ValueError(f"{name}[{flat[0]}]: expected a plane [a, b, c, d], found one with a = b = c = 0")
    origin = _strip_origin(Envelope(family, cuts, functions))
    rows = Envelope(family, cuts, functions, origin)
    if not rows.meets():
        raise ValueError(
            "planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or "
            "all contain one line that a bounding plane contains too); change the planes or the bounds"
        )
    return Surface(rows, Bernstein(1), flip, origin=origin)


@dataclass(frozen=True, eq=False)
class Envelope(Pickled):
    """The two boundary curves of the strip: where the rulings Π ∩ Π' meet the bounding planes.

    With n and e the normals of Π and Π', and b that of a bounding plane, the boundary A satisfies n·A + d = 0 and
    n·A' = b·A' = 0, so A' = λ b x n with λ from the derivative of Π'. Worked out in this order, A' lies in the tangent
    plane whatever the rounding, and the strip keeps its accuracy near the edge of regression, where A' vanishes.
    Points are as seen from ``origin``, and so are the planes that they are worked out from.
    """

    planes: FloatArray
    bounds: FloatArray
    functions: Functions
    origin: FloatArray = field(default_factory=lambda: np.zeros(3))

    def __repr__(self) -> str:
        """Return one line: planes, family and its parameters."""
        named = "".join(f", {name} {value:g}" for name, value in self.functions.parameters.items())
        return f"<Envelope of {len(self.planes)} planes: {type(self.functions).__name__.lower()}{named}>"

    @property
    def size(self) -> int:
        """Number of rows: two."""
        return 2

    @property
    def dimension(self) -> int:
        """3: points."""
        return 3

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, 2, 3), length¹.

        Not finite where a ruling is parallel to a bounding plane or Π' vanishes inside. Raises ValueError for u
        outside [0, 1].
        """
        plane, slope = self._dual(parameter(u, "u"), order)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            return taylor.derivatives(np.stack([_boundary(plane, slope, cut) for cut in self._local[1]], axis=-2))

    @property
    def homogeneous(self) -> Net:
        """The exact rational form: rows (w x, w y, w z, w), of degree 18 or less in tan(πu/4) for the quintic basis.

        There Π is of degree 10, so Π ∩ Π' is of degree 18, or 14 for α = ζ = 0. Polynomial bases give polynomials in u.
        Where the family of planes stands still at an end, the ruling has a factor that is divided out. Raises
        NotRationalError for a basis that has no such form.
        """
        planes, bounds = self._local
        form = self.functions.rational()
        if form.map not in (RIGHT_ANGLE, TangentMap()):
            raise NotRationalError("strips have an exact rational form over a right angle or in polynomials only")
        growth = 2.0 ** (0.5 * np.arange(form.degree + 1)) if form.map.angle else np.ones(form.degree + 1)
        rulings = wedge_points(growth[:, None] * (form.coefficients @ planes))
        rulings = without_factor(rulings, _stationary(rulings[0]), _stationary(rulings[-1]))
        points = np.stack([_meet(rulings, cut) for cut in bounds], axis=1)
        degree = len(points) - 1
        return Net(points, TangentBernstein(degree) if form.map.angle else Bernstein(degree))

    @cached_property
    def _local(self) -> tuple[FloatArray, FloatArray]:
        """Planes and bounds as seen from the origin."""
        return (
            np.array([moved_plane(plane, self.origin) for plane in self.planes]),
            np.array([moved_plane(plane, self.origin) for plane in self.bounds]),
        )

    def meets(self) -> bool:
        """Return whether some ruling exists and meets both bounding planes in a point."""
        plane, slope = (np.nan_to_num(series[0, :, :3]) for series in self._dual(np.linspace(0.0, 1.0, 33), 0))
        volumes = np.abs(np.cross(plane, slope) @ self.bounds[:, :3].T)
        lengths = [np.linalg.norm(vectors, axis=-1) for vectors in (plane, slope, self.bounds[:, :3])]
        return bool((volumes > NOISE * lengths[0].max() * lengths[1].max() * lengths[2]).any(axis=0).all())

    def _dual(self, u: FloatArray, order: int) -> tuple[FloatArray, FloatArray]:
        """Return the series of Π and of Π', the latter without the factors that vanish where Π stands still."""
        planes = self._local[0]
        edges = self.functions.split(planes)[1:]
        plane = self.functions.derivatives(u, order) @ planes
        _, functions = self.functions.hodograph(u, order, self.functions.standing(edges))
        slope = functions @ edges
        # Where the terms cancel to nothing the planes turn back, and rounding must not choose the ruling.
        terms = np.abs(functions[0]) @ np.abs(edges)
        slope[0, (np.abs(slope[0]) <= ROUNDING * terms).all(axis=-1)] = np.nan
        return taylor.coefficients(plane), taylor.coefficients(slope)


def _strip_origin(rows: Envelope) -> FloatArray:
    """Return an origin near most of a strip: some of its points may lie as good as at infinity."""
    points = rows.derivatives(np.linspace(0.0, 1.0, 17), 0)[0].reshape(-1, 3)
    points = points[np.isfinite(points).all(axis=-1)]
    if not len(points):
        return np.zeros(3)
    quarter, middle = len(points) // 4, len(points) // 2
    ordered: FloatArray = np.sort(points, axis=0)
    return local_origin(ordered[[quarter, middle + quarter]])


def _boundary(plane: FloatArray, slope: FloatArray, cut: FloatArray) -> FloatArray:
    """Return the series of the point common to Π, Π' and ``cut``, from those of the first two (order + 1, ..., 4)."""
    n, e, b = plane[..., :3], slope[..., :3], cut[:3]
    along = np.cross(b, n)
    volume = _dot(e, along)
    result: FloatArray = np.empty_like(along)
    pencil = plane[0, ..., 3:] * np.cross(e[0], b) + slope[0, ..., 3:] * along[0] + cut[3] * np.cross(n[0], e[0])
    result[0] = -pencil / volume[0][..., None]
    rate: FloatArray = np.empty_like(volume)
    for k in range(len(plane) - 1):
        # The derivative of e·A + d = 0 gives λ e·(b x n) = -(e'·A + d').
        rest = -(k + 1) * slope[k + 1, ..., 3]
        for i in range(k + 1):
            rest = rest - (i + 1) * (e[i + 1] * result[k - i]).sum(axis=-1)
        for i in range(k):
            rest = rest - rate[i] * volume[k - i]
        rate[k] = rest / volume[0]
        result[k + 1] = taylor.product(rate[: k + 1, ..., None], along[: k + 1])[k] / (k + 1)
    return result


def _dot(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the series of the scalar product of two vector series (order + 1, ..., 3)."""
    return taylor.product(x, y).sum(axis=-1)


def _stationary(ruling: FloatArray) -> bool:
    """Return whether U ⊗ V (4, 4) is one plane twice, to rounding: there the family of planes stands still."""
    return bool(np.abs(ruling - ruling.T).max() <= 4.0 * np.finfo(np.float64).eps * np.abs(ruling).max())


def _meet(rulings: FloatArray, plane: FloatArray) -> FloatArray:
    """Return the homogeneous points (n, 4) where the rulings meet a plane.

    ``rulings`` are tensor products U ⊗ V of two planes, (n, 4, 4); the point common to three planes is their
    alternating product. It is linear in U ⊗ V, so it acts on each Bernstein coefficient.
    """
    p = rulings - rulings.transpose(0, 2, 1)  # Plücker coordinates u_i v_j - u_j v_i
    a, b, c, d = plane

    # The 3 x 3 minors of (U, V, plane), expanded along the plane: det over columns i, j, k.
    def minor(i: int, j: int, k: int) -> FloatArray:
        e = (a, b, c, d)
        return p[:, i, j] * e[k] - p[:, i, k] * e[j] + p[:, j, k] * e[i]

    return np.stack([minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)], axis=-1)
