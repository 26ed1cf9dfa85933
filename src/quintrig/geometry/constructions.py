"""The constructions from control points: tensor product, symmetric, swept, swung and ruled surfaces.

Each is a net computed in a line or two. ``shape`` is (α1, ζ1, α2, ζ2): the first pair acts in u, the second in v.
The enveloping developable, which starts from planes, is in ``envelope``.
"""

from collections.abc import Sequence
from typing import TypedDict

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.joined import Joined
from quintrig.basis.registry import BasisName, family
from quintrig.basis.trigonometric import shape_parameter
from quintrig.geometry.origin import local_origin, moved_plane
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import FloatArray, frozen, number

Shape = Sequence[float]


class Options(TypedDict):
    """The keyword arguments that every construction takes."""

    basis: BasisName
    flip: bool
    unchecked_shape: bool


SHAPE_NAMES = ("alpha1", "zeta1", "alpha2", "zeta2")


def tensor(
    points: ArrayLike,
    shape: Shape = (0.0, 0.0, 0.0, 0.0),
    *,
    basis: BasisName = "trigonometric",
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = ΣΣ P_ij f_i(u; α1, ζ1) f_j(v; α2, ζ2) (thesis eq. 3.1); ``points`` (6, 6, 3), length¹.

    With ``basis="bernstein"`` any (n, m, 3). Raises ValueError for wrong counts, values or shape parameters.
    """
    net = frozen(points, "points", (None, None, 3))
    origin = local_origin(net)
    return _tensor(net - origin, origin, shape, Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape), net)


def symmetric(
    half_net: ArrayLike,
    mirror: ArrayLike,
    shape: Shape = (0.0, 0.0, 0.0, 0.0),
    *,
    basis: BasisName = "trigonometric",
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the tensor-product surface on three rows (3, 6, 3) and their images in a plane (thesis §4.3.1).

    ``mirror`` is (a, b, c, d) of the plane a x + b y + c z + d = 0. Rows 3, 4, 5 of the net are the images of
    rows 2, 1, 0, so the whole surface is its own mirror image where α1 = ζ1.
    """
    half = frozen(half_net, "points", (None, None, 3))
    plane = frozen(mirror, "mirror", (4,))
    if basis == "trigonometric" and half.shape[:2] != (3, 6):
        raise ValueError(f"points: expected 3 rows of 6 points, found {half.shape[0]} rows of {half.shape[1]}")
    origin = local_origin(half)
    local, seen = half - origin, moved_plane(plane, origin)
    net = np.concatenate([local, reflected(local, seen)[::-1]])
    return _tensor(net, origin, shape, Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape))


def swept(
    section: ArrayLike,
    trajectory: ArrayLike,
    shape: Shape = (0.0, 0.0, 0.0, 0.0),
    *,
    basis: BasisName = "trigonometric",
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the translational sweep S = C(u) + T(v) of two space curves of 6 points each (thesis §3.2.2)."""
    c = _polygon(section, "section", 3, basis)
    t = _polygon(trajectory, "trajectory", 3, basis)
    origins = local_origin(c), local_origin(t)
    local = (c - origins[0])[:, None] + (t - origins[1])[None, :]
    steps = np.zeros_like(local)  # those of each curve, without the sum of both
    steps[0, 0], steps[1:, 0], steps[0, 1:] = local[0, 0], np.diff(c, axis=0), np.diff(t, axis=0)
    options = Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape)
    return _tensor(local, origins[0] + origins[1], shape, options, c[:, None] + t[None, :], steps)


def swung(
    profile: ArrayLike,
    trajectory: ArrayLike,
    shape: Shape = (0.0, 0.0, 0.0, 0.0),
    scale: float = 1.0,
    *,
    basis: BasisName = "trigonometric",
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = (λ r x, λ r y, z) from a profile (r, z)(u) and a trajectory (x, y)(v), λ = ``scale`` (thesis §3.2.3).

    Six pairs each. The surface is singular where r = 0: all of that row is one point.
    """
    r, z = _polygon(profile, "profile", 2, basis).T
    x, y = _polygon(trajectory, "trajectory", 2, basis).T
    radius = number(scale, "scale") * r
    net = np.stack([np.outer(radius, x), np.outer(radius, y), np.outer(z, np.ones_like(x))], axis=-1)
    origin = local_origin(net)
    # Increments of the profile times those of the trajectory.
    along, across = (np.concatenate([values[:1], np.diff(values)]) for values in (radius, z))
    around = [np.concatenate([values[:1], np.diff(values)]) for values in (x, y, np.ones_like(x))]
    steps = np.stack([np.outer(a, b) for a, b in zip((along, along, across), around, strict=True)], axis=-1)
    steps[0, 0] = net[0, 0] - origin
    options = Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape)
    return _tensor(net - origin, origin, shape, options, net, steps)


def ruled(
    first: ArrayLike,
    second: ArrayLike,
    shape: Shape = (0.0, 0.0, 0.0, 0.0),
    *,
    basis: BasisName = "trigonometric",
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = (1 - v) A(u) + v B(u), A with (α1, ζ1) and B with (α2, ζ2), 6 points each (thesis §3.2.4)."""
    a = _polygon(first, "first", 3, basis)
    b = _polygon(second, "second", 3, basis)
    a1, z1, a2, z2 = _shape(shape, unchecked_shape)
    functions = Joined((family(basis, len(a), a1, z1, unchecked_shape), family(basis, len(b), a2, z2, unchecked_shape)))
    origin = local_origin(np.concatenate([a, b]))
    points = np.zeros((len(a) + len(b), 2, 3))
    points[: len(a), 0] = a - origin
    points[len(a) :, 1] = b - origin
    net = np.stack([a, b], axis=1) if len(a) == len(b) else None
    return Surface(Net(points, functions), Bernstein(1), flip, net, origin=origin)


def reflected(points: FloatArray, plane: FloatArray) -> FloatArray:
    """Return the mirror images of points (..., 3) in the plane (a, b, c, d); ValueError where (a, b, c) vanishes."""
    normal, offset = plane[:3], plane[3]
    square = float(normal @ normal)
    if not square > 0.0:
        raise ValueError("mirror: expected [a, b, c, d] with (a, b, c) not all zero, found a zero normal")
    return points - 2.0 * ((points @ normal + offset) / square)[..., None] * normal


def _tensor(
    local: FloatArray,
    origin: FloatArray,
    shape: Shape,
    options: Options,
    net: FloatArray | None = None,
    steps: FloatArray | None = None,
) -> Surface:
    """Return the surface on points as seen from an origin, (n, m, 3); ``net`` holds them as they are, to be drawn."""
    basis, unchecked = options["basis"], options["unchecked_shape"]
    a1, z1, a2, z2 = _shape(shape, unchecked)
    _count(local, 0, "points", basis)
    _count(local, 1, "points[0]", basis)
    u = family(basis, local.shape[0], a1, z1, unchecked)
    v = family(basis, local.shape[1], a2, z2, unchecked)
    frozen(local, "points", (None, None, 3))  # sums and products may have no finite value
    return Surface(Net(local, u, steps), v, options["flip"], local + origin if net is None else net, origin=origin)


def _shape(shape: Shape, unchecked: bool) -> tuple[float, float, float, float]:
    values = frozen(shape, "shape", (4,))
    a1, z1, a2, z2 = (
        shape_parameter(float(value), f"shape[{i}] ({name})", unchecked)
        for i, (name, value) in enumerate(zip(SHAPE_NAMES, values, strict=True))
    )
    return a1, z1, a2, z2


def _polygon(points: ArrayLike, name: str, dimension: int, basis: BasisName) -> FloatArray:
    array = frozen(points, name, (None, dimension))
    _count(array, 0, name, basis)
    return array


def _count(points: FloatArray, axis: int, name: str, basis: BasisName) -> None:
    found = points.shape[axis]
    if basis == "trigonometric" and found != 6:
        raise ValueError(f"{name}: expected 6 control points for the trigonometric basis, found {found}")
    if found < 2:
        raise ValueError(f"{name}: expected 2 or more control points, found {found}")
