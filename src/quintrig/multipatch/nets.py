"""The control points that a join may move: how a kind's net depends on them, and how they go back into its keys."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.geometry.constructions import reflected
from quintrig.geometry.surface import Net
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

Keys = dict[str, Any]


@dataclass(frozen=True, eq=False)
class Handle:
    """Free coordinates ``values`` (p,) of a patch, length¹, and what they make: a net (n, m, 3), affine in them.

    ``keys`` gives the keys of a model file back.
    """

    values: FloatArray
    net: Callable[[FloatArray], FloatArray]
    keys: Callable[[FloatArray], Keys]

    def map(self) -> FloatArray:
        """Return the matrix (n m 3, p) of the net's coordinates by the free ones."""
        start = self.net(np.zeros_like(self.values)).ravel()
        return np.stack([self.net(unit).ravel() - start for unit in np.eye(len(self.values))], axis=-1)


def handle(patch: Patch, sides: Iterable[str] = ()) -> Handle | None:
    """Return what may be moved of a patch and keep it of its kind; None where its kind has no net that is affine.

    The net of a swung surface is, by its profile or by its trajectory alone: ``sides`` that are to move tell which.
    """
    if patch.kind == "swung":
        ways = {side[:1] for side in sides}
        return _swung(patch, ways.pop()) if len(ways) == 1 else None
    build = _HANDLES.get(patch.kind)
    return build(patch) if build else None


def net_of(patch: Patch) -> FloatArray | None:
    """Return the control points (n, m, 3) of S = ΣΣ P_ij f_i(u) g_j(v), length¹; None where the patch has none such."""
    rows = patch.surface.rows
    if not isinstance(rows, Net) or rows.dimension != 3 or rows.points.shape[:2] != (rows.functions.size, rows.size):
        return None
    if patch.surface.net is None or patch.surface.net.shape != rows.points.shape:
        return None
    return rows.points + patch.surface.origin


def as_tensor(patch: Patch) -> Patch | None:
    """Return the same surface as a tensor-product patch; None where it has no net in its basis."""
    net = net_of(patch)
    if net is None:
        return None
    dump = patch.definition.model_dump(exclude_defaults=True)
    kept = {key: dump[key] for key in ("shape", "basis", "flip", "unchecked_shape") if key in dump}
    return patch.rebuilt(kind="tensor", points=net.tolist(), **kept)


def _kept(patch: Patch) -> Keys:
    return {"kind": patch.kind, **patch.definition.model_dump(exclude_defaults=True, exclude={"kind"})}


def _tensor(patch: Patch) -> Handle:
    points = np.array(patch.definition.model_dump()["points"])
    return Handle(
        points.ravel(),
        lambda x: x.reshape(points.shape),
        lambda x: {**_kept(patch), "points": x.reshape(points.shape).tolist()},
    )


def _symmetric(patch: Patch) -> Handle:
    keys = patch.definition.model_dump()
    points, mirror = np.array(keys["points"]), np.array(keys["mirror"], dtype=np.float64)

    def net(x: FloatArray) -> FloatArray:
        half = x.reshape(points.shape)
        return np.concatenate([half, reflected(half, mirror)[::-1]])

    return Handle(points.ravel(), net, lambda x: {**_kept(patch), "points": x.reshape(points.shape).tolist()})


def _swept(patch: Patch) -> Handle:
    keys = patch.definition.model_dump()
    section, trajectory = np.array(keys["section"]), np.array(keys["trajectory"])

    def parts(x: FloatArray) -> tuple[FloatArray, FloatArray]:
        return x[: section.size].reshape(-1, 3), x[section.size :].reshape(-1, 3)

    def net(x: FloatArray) -> FloatArray:
        c, t = parts(x)
        return c[:, None] + t[None, :]

    def back(x: FloatArray) -> Keys:
        c, t = parts(x)
        return {**_kept(patch), "section": c.tolist(), "trajectory": t.tolist()}

    return Handle(np.concatenate([section.ravel(), trajectory.ravel()]), net, back)


def _ruled(patch: Patch) -> Handle:
    """The net has the points of one curve in its first column and those of the other in its second, else zeros."""
    keys = patch.definition.model_dump()
    first, second = np.array(keys["first"]), np.array(keys["second"])

    def net(x: FloatArray) -> FloatArray:
        points: FloatArray = np.zeros((len(first) + len(second), 2, 3))
        points[: len(first), 0] = x[: first.size].reshape(-1, 3)
        points[len(first) :, 1] = x[first.size :].reshape(-1, 3)
        return points

    def back(x: FloatArray) -> Keys:
        a, b = x[: first.size].reshape(-1, 3), x[first.size :].reshape(-1, 3)
        return {**_kept(patch), "first": a.tolist(), "second": b.tolist()}

    return Handle(np.concatenate([first.ravel(), second.ravel()]), net, back)


def _swung(patch: Patch, way: str) -> Handle:
    """Across the sides u = 0 and u = 1 the profile moves, across the others the trajectory."""
    keys = patch.definition.model_dump()
    profile, trajectory = np.array(keys["profile"]), np.array(keys["trajectory"])
    name, own = ("profile", profile) if way == "u" else ("trajectory", trajectory)

    def net(x: FloatArray) -> FloatArray:
        moved = x.reshape(own.shape)
        (r, z), (a, b) = (moved.T, trajectory.T) if way == "u" else (profile.T, moved.T)
        radius = float(keys["scale"]) * r
        return np.stack([np.outer(radius, a), np.outer(radius, b), np.outer(z, np.ones(len(trajectory)))], axis=-1)

    return Handle(own.ravel(), net, lambda x: {**_kept(patch), name: x.reshape(own.shape).tolist()})


def _nurbs(patch: Patch) -> Handle | None:
    return _tensor(patch) if net_of(patch) is not None else None


_HANDLES: dict[str, Callable[[Patch], Handle | None]] = {
    "tensor": _tensor,
    "symmetric": _symmetric,
    "swept": _swept,
    "ruled": _ruled,
    "nurbs": _nurbs,
}
