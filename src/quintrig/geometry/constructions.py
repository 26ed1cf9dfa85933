"""The constructions from control points: tensor product, symmetric, swept, swung and ruled surfaces.

Each is a net computed in a line or two. ``basis`` is a name, a family of functions, or a pair of them for u and v, and
says how many points there are. ``shape`` holds the shape parameters of the basis in u, then those in v: for the quintic
trigonometric basis (α1, ζ1, α2, ζ2).
The enveloping developable, which starts from planes, is in ``envelope``.
"""

from collections.abc import Sequence
from typing import TypedDict

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.joined import Joined
from quintrig.basis.library import Entry
from quintrig.basis.pairs import Bases, check_count, families, pair
from quintrig.basis.registry import DEFAULT, Choice
from quintrig.geometry.origin import local_origin, moved_plane
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import FloatArray, frozen, number

Shape = Sequence[float] | None
"""Values of the shape parameters; none for those that the basis starts from."""


class Options(TypedDict):
    """The keyword arguments that every construction takes."""

    basis: Bases
    flip: bool
    unchecked_shape: bool


SHAPE_NAMES = ("alpha1", "zeta1", "alpha2", "zeta2")


def tensor(
    points: ArrayLike,
    shape: Shape = None,
    *,
    basis: Bases = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = ΣΣ P_ij f_i(u; α1, ζ1) f_j(v; α2, ζ2) (thesis eq. 3.1); ``points`` (6, 6, 3), length¹.

    Other bases take (n, m, 3), as many as they have functions. Raises ValueError for wrong counts, values or shape
    parameters.
    """
    net = frozen(points, "points", (None, None, 3))
    origin = local_origin(net)
    return _tensor(net - origin, origin, shape, Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape), net)


def symmetric(
    half_net: ArrayLike,
    mirror: ArrayLike,
    shape: Shape = None,
    *,
    basis: Bases = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the tensor-product surface on three rows (3, 6, 3) and their images in a plane (thesis §4.3.1).

    ``mirror`` is (a, b, c, d) of the plane a x + b y + c z + d = 0. Rows 3, 4, 5 of the net are the images of
    rows 2, 1, 0, so the whole surface is its own mirror image where α1 = ζ1.
    """
    half = frozen(half_net, "points", (None, None, 3))
    plane = frozen(mirror, "mirror", (4,))
    rows = len(half)
    odd = mirrored(pair(basis)[0], rows) % 2 == 1
    origin = local_origin(half)
    local, seen = half - origin, moved_plane(plane, origin)
    image = reflected(local, seen)[::-1]
    if odd:
        away = float(np.abs(image[0] - local[-1]).max())
        if away > 1e-9 * float(np.abs(local).max()):
            raise ValueError(
                f"points[{rows - 1}]: expected points on the mirror plane, as this basis has a middle row, "
                f"found them {0.5 * away:.3g} away"
            )
        image = image[1:]
    net = np.concatenate([local, image])
    return _tensor(net, origin, shape, Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape))


def swept(
    section: ArrayLike,
    trajectory: ArrayLike,
    shape: Shape = None,
    *,
    basis: Bases = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the translational sweep S = C(u) + T(v) of two space curves of 6 points each (thesis §3.2.2)."""
    c = _polygon(section, "section", 3, basis, 0)
    t = _polygon(trajectory, "trajectory", 3, basis, 1)
    origins = local_origin(c), local_origin(t)
    local = (c - origins[0])[:, None] + (t - origins[1])[None, :]
    steps = np.zeros_like(local)  # those of each curve, without the sum of both
    steps[0, 0], steps[1:, 0], steps[0, 1:] = local[0, 0], np.diff(c, axis=0), np.diff(t, axis=0)
    options = Options(basis=basis, flip=flip, unchecked_shape=unchecked_shape)
    return _tensor(local, origins[0] + origins[1], shape, options, c[:, None] + t[None, :], steps)


def swung(
    profile: ArrayLike,
    trajectory: ArrayLike,
    shape: Shape = None,
    scale: float = 1.0,
    *,
    basis: Bases = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = (λ r x, λ r y, z) from a profile (r, z)(u) and a trajectory (x, y)(v), λ = ``scale`` (thesis §3.2.3).

    Six pairs each. The surface is singular where r = 0: all of that row is one point.
    """
    r, z = _polygon(profile, "profile", 2, basis, 0).T
    x, y = _polygon(trajectory, "trajectory", 2, basis, 1).T
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
    shape: Shape = None,
    *,
    basis: Bases = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return S = (1 - v) A(u) + v B(u), A with (α1, ζ1) and B with (α2, ζ2), 6 points each (thesis §3.2.4)."""
    a = _polygon(first, "first", 3, basis, 0)
    b = _polygon(second, "second", 3, basis, 1)
    functions = Joined(families(pair(basis), (len(a), len(b)), ("first", "second"), shape, unchecked_shape))
    still = all(part.partition for part in functions.parts)
    origin = local_origin(np.concatenate([a, b])) if still else np.zeros(3)
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
    counts, places = local.shape[:2], ("points", "points[0]")
    u, v = families(pair(options["basis"]), counts, places, shape, options["unchecked_shape"])
    if not (
        u.partition and v.partition
    ):  # then the surface moves with the coordinate origin, and only that one is meant
        local, origin, steps = local + origin, np.zeros(3), None
    frozen(local, "points", (None, None, 3))  # sums and products may have no finite value
    return Surface(Net(local, u, steps), v, options["flip"], local + origin if net is None else net, origin=origin)


def _polygon(points: ArrayLike, name: str, dimension: int, basis: Bases, direction: int) -> FloatArray:
    array = frozen(points, name, (None, dimension))
    check_count(pair(basis)[direction], len(array), name)
    return array


def mirrored(choice: Choice, rows: int) -> int:
    """Return how many rows a net has of which so many, half of them, are given: the last is the middle one if odd.

    Raises ValueError where the basis in u has no functions for such a number.
    """
    for whole in (2 * rows, 2 * rows - 1):
        if _takes(choice, whole):
            return whole
    sizes = choice.sizes if isinstance(choice, Entry) else (len(choice) if isinstance(choice, str) else choice.size,)
    halves = sorted({(n + 1) // 2 for n in sizes})
    told = " or ".join(map(str, halves)) if len(halves) < 4 else f"{halves[0]} to {halves[-1]}"
    raise ValueError(f"points: expected {told} rows, half of the net, found {rows}")


def _takes(choice: Choice, points: int) -> bool:
    return (
        points in choice.sizes if isinstance(choice, Entry) else not isinstance(choice, str) and choice.size == points
    )
