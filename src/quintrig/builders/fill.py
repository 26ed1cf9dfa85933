"""A hole with four sides filled by one patch: Coons's sum of nets, bent to meet its neighbours."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.basis.functions import Functions
from quintrig.builders.build import Built, Meeting, finished, level, settled
from quintrig.builders.loops import Bound, in_a_loop
from quintrig.builders.rims import Rim, T, common, fitted, rim, tensor, turned, unused
from quintrig.builders.strips import flipped
from quintrig.geometry.curve import Curve
from quintrig.model.model import Model
from quintrig.model.outcome import model_of
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_OWN = ("v0", "u1", "v1", "u0")
_STIFF = 0.05  # weight of staying where Coons puts a point, beside that of an angle


@dataclass(frozen=True, eq=False)
class _Border:
    """One border of the hole in the direction of the new patch's parameter: points, functions, and its rim if any."""

    text: str
    points: FloatArray
    functions: Functions
    exact: bool
    rim: Rim | None
    back: bool

    @property
    def tangents(self) -> FloatArray:
        """Tangents in the direction of the new patch's parameter, as fast as it, (n, 3)."""
        if self.rim is None:
            raise TypeError("curves are met to G0 only")
        found = self.rim.edge.curve(T)[1]
        return -found[::-1] if self.back else found


def filled(
    boundary: Model | Sequence[Curve],
    *sides: str,
    order: str = "G0",
    name: str = "fill",
    hold: bool = False,
) -> Built:
    """Return the model with the hole between four sides, ``"a:u1"``, ..., filled by a patch that meets them.

    ``order`` is G0 or G1. ``boundary`` may be four curves, or a model of curves with the names of four, in place of a
    model of patches: the result is then a model of the patch alone, and the order G0. The net is Coons's sum of ruled
    nets (Coons 1967; Farin 2002, §22); for G1 it moves by the least change. Raises ModelError where the sides do
    not form a loop.
    """
    k = level(order, "G1")
    if not isinstance(boundary, Model) or boundary.curves:
        if k:
            raise ModelError("order: curves have no tangent planes; expected G0, or sides of patches")
        unit = boundary.unit if isinstance(boundary, Model) else ""
        patch, notes = _coons(_of_curves(boundary, sides), name)
        return Built(Model(name, unit, (patch,)), (name,), (), tuple(notes))
    if len(sides) != 4:
        raise ModelError(f"fill: expected four sides, such as a:u1 b:v0 c:u0 d:v1, found {len(sides)}")
    if len(set(sides)) < 4:
        raise ModelError("fill: expected four different sides, found one twice")
    rims = [rim(boundary, side) for side in sides]
    borders = _borders([(one.text, one.points, one.functions, one) for one in rims])
    patch, notes = _coons(borders, unused(name, boundary))
    lead = borders[0].rim
    if lead is not None and not flipped(lead):  # v leaves the first side, along which u runs
        patch = patch.rebuilt(**{**patch.definition.model_dump(exclude_defaults=True), "kind": "tensor", "flip": True})
    meetings = [
        Meeting(one.rim, own, one.back, _ratio(k, borders, at))
        for at, (one, own) in enumerate(zip(borders, _OWN, strict=True))
        if one.rim is not None
    ]
    if k:
        bent, met = settled(patch, meetings, k)
        if all(met):
            patch = bent
        else:
            patch = _softened(patch, meetings)
            notes.append(
                f"{patch.name}: meets its sides to G0, and to G1 by least squares: their ways across and the sides "
                "beside them do not go together at the corners; the seams tell the angles"
            )
            hold = False
    return finished(boundary, [patch], [(patch, one) for one in meetings], order, hold=hold, notes=notes)


fill = model_of(filled, "fill")


def _of_curves(boundary: Model | Sequence[Curve], names: Sequence[str]) -> list[_Border]:
    """Return the borders that four curves make; ModelError where there are not four, or not in space."""
    if isinstance(boundary, Model):
        named = [boundary.curve(name) for name in names] if names else list(boundary.curves)
        curves = [(one.name, one.curve) for one in named]
    else:
        curves = [(f"curve {k}", one) for k, one in enumerate(boundary, 1)]
    if len(curves) != 4:
        raise ModelError(f"fill: expected four curves, found {len(curves)}")
    if any(one.points.shape[1] != 3 for _, one in curves):
        raise ModelError("fill: expected curves in space, found one in the plane")
    return _borders([(text, curve(T), curve.functions, None) for text, curve in curves])


def _borders(found: Sequence[tuple[str, FloatArray, Functions, Rim | None]]) -> list[_Border]:
    """Return the borders v0, u1, v1, u0 in the direction of the parameter, each pair with one set of functions."""
    loop = in_a_loop([Bound(text, points) for text, points, _, _ in found])
    runs = [back != (k > 1) for k, (_, back) in enumerate(loop)]  # v1 and u0 are run against the loop
    own = [found[i][2] for i, _ in loop]
    ways = [turned(f) or f if back else f for f, back in zip(own, runs, strict=True)]
    points = [found[i][1][::-1] if back else found[i][1] for (i, _), back in zip(loop, runs, strict=True)]
    pairs = [common([ways[k], ways[k + 2]], [points[k], points[k + 2]]) for k in (0, 1)]
    return [
        _Border(found[i][0], points[k], *pairs[k % 2], found[i][3], runs[k]) for k, (i, _) in enumerate(loop)
    ]  # fmt: skip


def _coons(borders: Sequence[_Border], name: str) -> tuple[Patch, list[str]]:
    """Return the patch of Coons's net, and a line on each border that it meets by least squares only."""
    bottom, right, top, left = (fitted(one.functions, one.points) for one in borders)
    corners = [[bottom[0], left[0]], [bottom[-1], right[0]], [top[0], left[-1]], [top[-1], right[-1]]]
    for ends, (a, i), (b, j) in zip(
        corners, ((bottom, 0), (bottom, -1), (top, 0), (top, -1)), ((left, 0), (right, 0), (left, -1), (right, -1)),
        strict=True,
    ):  # fmt: skip
        a[i] = b[j] = 0.5 * (ends[0] + ends[1])
    u, v = borders[0].functions, borders[1].functions
    x, y = _places(u)[:, None, None], _places(v)[None, :, None]
    ruled = (1 - y) * bottom[:, None] + y * top[:, None] + (1 - x) * left[None] + x * right[None]
    twice = (1 - x) * ((1 - y) * bottom[0] + y * top[0]) + x * ((1 - y) * bottom[-1] + y * top[-1])
    net = ruled - twice
    net[:, 0], net[:, -1], net[0], net[-1] = bottom, top, left, right
    notes = [
        f"{one.text}: met by least squares: no functions at hand hold it and the side opposite"
        for one in borders
        if not one.exact
    ]
    return tensor(name, u, v, net), notes


def _places(functions: Functions) -> FloatArray:
    """Return control values of t itself as nearly as the functions have it: 0 first, 1 last."""
    line = np.stack([T, np.zeros_like(T), np.zeros_like(T)], axis=-1)
    places = fitted(functions, line)[:, 0]
    return (places - places[0]) / (places[-1] - places[0])


def _ratio(order: int, borders: Sequence[_Border], at: int) -> float:
    """Return the κ of a border: what its neighbours' tangents at its two corners ask for, in the mean."""
    one = borders[at].rim
    if order == 0 or one is None:
        return 1.0
    _ = one.speed
    out = one.across[1][::-1] if borders[at].back else one.across[1]
    before, after = (3, 1) if at % 2 == 0 else (0, 2)
    own = -1 if _OWN[at] in ("v1", "u1") else 0
    sign = 1.0 if own == 0 else -1.0
    asked: list[float] = []
    for corner, beside in ((0, before), (-1, after)):
        tangent = sign * borders[beside].tangents[own]
        asked.append(float(tangent @ out[corner]) / float(out[corner] @ out[corner]))
    good = [x for x in asked if x > 0.0]
    if good:
        return float(np.mean(good))
    return float(np.linalg.norm(borders[before].points[0] - borders[before].points[-1])) / one.speed


def _softened(patch: Patch, meetings: Sequence[Meeting]) -> Patch:
    """Return the patch with its inner points moved so that it lies in the tangent planes of its rims as well as may be.

    The borders stay. Linear: along every rim n·∂S = 0 across it, n the rim's normal.
    """
    surface = patch.surface
    u, v = getattr(surface.rows, "functions"), surface.blend  # noqa: B009 - a net's rows have some
    net = np.array(surface.net)
    inner = np.zeros(net.shape[:2], dtype=bool)
    inner[1:-1, 1:-1] = True
    blocks, right = list[FloatArray](), list[FloatArray]()
    for one in meetings:
        first = one.side in ("u0", "u1")
        across, along = (u, v) if first else (v, u)
        cross = across.derivatives(float(one.side[1]), 1)[1]
        values = along.derivatives(T, 0)[0]
        matrix = np.einsum("i,nj->nij" if first else "j,ni->nij", cross, values)
        normal = _normals(one)
        row = np.einsum("nij,nx->nijx", matrix, normal)
        scale = 1.0 / float(np.linalg.norm(np.einsum("nij,ijx->nx", matrix, net), axis=-1).mean())
        right.append(-scale * np.einsum("nijx,ijx->n", row, net))
        part: FloatArray = np.reshape(row[:, inner], (len(T), -1))
        blocks += [scale * part]
    count = int(blocks[0].shape[1])
    stiff: FloatArray = np.zeros((count, count))
    np.fill_diagonal(stiff, _STIFF / surface.size)
    blocks += [stiff]
    none: FloatArray = np.zeros(count)
    right.append(none)
    found = np.linalg.lstsq(np.concatenate(blocks), np.concatenate(right), rcond=None)[0]
    net[inner] += found.reshape(-1, 3)
    return tensor(patch.name, u, v, net, surface.flip)


def _normals(one: Meeting) -> FloatArray:
    """Return the unit normals of a rim in the direction of the new patch's parameter, (n, 3)."""
    normal = np.cross(one.rim.edge.curve(T)[1], one.rim.across[1])
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-300)
    return normal[::-1] if one.reverse else normal
