"""The other half of a body: patches mirrored in a plane, and the seams on the plane made smooth."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from quintrig.builders.build import Built, level, seams_of
from quintrig.builders.rims import unused
from quintrig.geometry.constructions import reflected
from quintrig.geometry.surface import Net
from quintrig.model.held import Held, held
from quintrig.model.model import Model
from quintrig.model.outcome import model_of
from quintrig.model.patch import Patch
from quintrig.multipatch.attach import movable
from quintrig.multipatch.boundary import SIDES, Edge, edges
from quintrig.multipatch.match import least_change, rows_of, strip_of
from quintrig.multipatch.nets import as_tensor, handle
from quintrig.support.arrays import FloatArray, frozen
from quintrig.support.errors import ModelError

_WORDS = re.compile(r"\s*([xyz])\s*=\s*([-+]?[0-9.]+(?:e[-+]?[0-9]+)?)\s*", re.IGNORECASE)
_NEAR = 0.05
_EXACT = 1e-9
_ALIKE = 1e-12
_POINTS = 16

Plane = str | Sequence[float]


def mirrored(
    model: Model, plane: Plane = "x=0", order: str = "G1", *, near: float = _NEAR, convert: bool = False
) -> Built:
    """Return the model with the mirror image of every patch: ``plane`` is ``"x=0"`` or (a, b, c, d), ax+by+cz+d = 0.

    Sides that lie on the plane, or off it by less than ``near`` of their patch's size, are laid on it, and their next
    rows moved as little as needed for the seam between the halves to be of ``order``: G0, G1 or G2. Curvatures of
    mirror images are equal, so that what is G1 here is G2 as well. With ``convert`` a patch that cannot stay of its
    kind becomes a tensor-product patch. Images are called NAME_mirror. Raises ModelError or ValueError for a wrong
    plane or order, and for patches that have no image of their kind.
    """
    model.refuse_curves()
    k = min(level(order, "G2"), 1)
    if not 0.0 <= near <= 0.5:
        raise ValueError(f"near: expected a part of a patch's size from 0 to 0.5, found {near:g}")
    abcd = plane_of(plane)
    notes: list[str] = []
    own: list[Patch] = []
    lying = 0
    for patch in model.patches:
        sides = _on(patch, abcd, near)
        lying += len(sides)
        own.append(_laid(patch, sides, abcd, k, convert, notes) if sides else patch)
    if not lying:
        notes.append("no side lies on the plane: the halves do not meet")
    half = replace(model, patches=tuple(own))
    images: list[Patch] = []
    for patch in half.patches:
        name = unused(f"{patch.name}_mirror", model, [one.name for one in images])
        images.append(_image(patch, name, abcd, convert, notes))
    called = {patch.name: image.name for patch, image in zip(half.patches, images, strict=True)}
    everything = (*half.patches, *images)
    rules = _rules(model, called, everything)
    result = replace(half, patches=everything, held=rules)
    pairs = {frozenset(pair) for pair in called.items()}
    seams = tuple(
        one for one in seams_of(result, set(called.values())) if frozenset((one.first.patch, one.second.patch)) in pairs
    )
    return Built(result, tuple(called.values()), seams, tuple(notes))


mirror = model_of(mirrored, "mirror")


def plane_of(plane: Plane) -> FloatArray:
    """Return (a, b, c, d) with (a, b, c) of length 1; ValueError for anything that is no plane."""
    expected = "plane: expected x=0, y=0 or z=0 with any number, or a,b,c,d with a x + b y + c z + d = 0"
    if isinstance(plane, str):
        found = _WORDS.fullmatch(plane)
        try:
            values = [float(x) for x in plane.split(",")] if found is None else []
            at = float(found[2]) if found else 0.0
        except ValueError:
            raise ValueError(f"{expected}, found {plane!r}") from None
        if found:
            values = [float(axis == found[1].lower()) for axis in "xyz"] + [-at]
    else:
        values = list(plane)
    if len(values) != 4:
        raise ValueError(f"{expected}, found {plane!r}")
    result = frozen(values, "plane", (4,))
    length = float(np.linalg.norm(result[:3]))
    if not length > 0.0:
        raise ValueError(f"{expected}, found a zero normal")
    return result / length


def _on(patch: Patch, plane: FloatArray, near: float) -> list[Edge]:
    """Return the sides of a patch that lie on the plane, or nearly."""
    if patch.surface.trim:
        return []
    reach = max(near, 1e-9) * patch.surface.size
    alive, _ = edges([patch.surface])
    return [one for one in alive if np.abs(one.points @ plane[:3] + plane[3]).max() <= reach]


def _laid(patch: Patch, sides: Sequence[Edge], plane: FloatArray, order: int, convert: bool, notes: list[str]) -> Patch:
    """Return the patch with these sides on the plane, and straight across it for order 1, by the least change."""
    normal = plane[:3]
    t = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, _POINTS))
    inside = np.eye(3) - np.outer(normal, normal)
    if _stands(patch, sides, plane, order):
        return patch
    told = ", ".join(f"{patch.name}:{one.side}" for one in sides)
    if handle(patch) is None and as_tensor(patch) is None:
        raise ModelError(f"{told}: a {patch.kind} has no rows that can move to meet its image to G{order}; ask for G0")
    for attempt in (patch, as_tensor(patch) if convert else None):
        if attempt is None:
            break
        own, free = movable(attempt, convert, notes)
        net, linear = free.net(free.values), free.map()
        blocks, right = list[FloatArray](), list[FloatArray]()
        for edge in sides:
            found = strip_of(own.surface, net, edge.side, t, order, outward=True)
            here = rows_of(found.matrix[0], linear).reshape(len(t), 3, -1)
            blocks.append(np.einsum("x,nxp->np", normal, here))
            right.append(-(found.values[0] @ normal + plane[3]))
            if order:
                out = rows_of(found.matrix[1], linear).reshape(len(t), 3, -1)
                blocks.append(np.einsum("yx,nxp->nyp", inside, out).reshape(3 * len(t), -1) / np.pi)
                right.append(-(found.values[1] @ inside).ravel() / np.pi)
        a, b = np.concatenate(blocks), np.concatenate(right)
        moved = least_change(a, b, a.shape[1])
        if np.abs(a @ moved - b).max() <= _EXACT * own.surface.size:
            if attempt is not patch:
                notes.append(f"{patch.name}: made a tensor-product patch")
            return own.rebuilt(**free.keys(free.values + moved))
    if patch.kind != "tensor" and not convert and as_tensor(patch) is not None:
        raise ModelError(
            f"{told}: a {patch.kind} cannot keep its kind and meet its image to G{order}",
            remedy="convert=True makes it a tensor-product patch",
            key="convert",
        )
    raise ModelError(f"{told}: no change of its rows meets its image to G{order}; ask for a lower order")


def _stands(patch: Patch, sides: Sequence[Edge], plane: FloatArray, order: int) -> bool:
    """Return whether the sides meet their images already, to rounding: any kind may, and then nothing moves."""
    normal, t = plane[:3], np.linspace(0.0, 1.0, _POINTS)
    for edge in sides:
        k = SIDES.index(edge.side)
        fixed = np.full_like(t, float(k % 2))
        s = patch.surface.partials(*((fixed, t) if k < 2 else (t, fixed)), 1)
        if np.abs(s[0, 0] @ normal + plane[3]).max() > _EXACT * patch.surface.size:
            return False
        upright = np.cross(s[1, 0], s[0, 1]) @ normal
        if order and np.abs(upright).max() > _EXACT * np.linalg.norm(np.cross(s[1, 0], s[0, 1]), axis=-1).max():
            return False
    return True


@dataclass(frozen=True)
class _Mirror:
    """How the keys of a model file are mirrored: points, planes, and what has no image."""

    plane: FloatArray

    def points(self, value: Any) -> Any:
        return reflected(np.array(value, dtype=np.float64), self.plane).tolist()

    def planes(self, value: Any) -> Any:
        """Return images of planes n·x + d = 0: n - 2 (n·m) m, and d - 2 (n·m) e, for the mirror m·x + e = 0."""
        given = np.array(value, dtype=np.float64)
        along = given[..., :3] @ self.plane[:3]
        return (given - 2.0 * along[..., None] * self.plane).tolist()

    def vectors(self, value: Any) -> Any:
        given = np.array(value, dtype=np.float64)
        return (given - 2.0 * (given @ self.plane[:3])[..., None] * self.plane[:3]).tolist()


def _image(patch: Patch, name: str, plane: FloatArray, convert: bool, notes: list[str]) -> Patch:
    """Return the mirror image of a patch, which looks to the same side of the body."""
    tool = _Mirror(plane)
    keys: dict[str, Any] = {
        "kind": patch.kind,
        **patch.definition.model_dump(exclude_defaults=True, exclude={"kind", "name", "flip"}),
        "flip": not patch.surface.flip,
    }
    match patch.kind:
        case "tensor" | "nurbs":
            keys["points"] = tool.points(keys["points"])
        case "symmetric":
            keys |= {"points": tool.points(keys["points"]), "mirror": tool.planes(keys["mirror"])}
        case "swept":
            keys |= {"section": tool.points(keys["section"]), "trajectory": tool.vectors(keys["trajectory"])}
        case "ruled":
            keys |= {"first": tool.points(keys["first"]), "second": tool.points(keys["second"])}
        case "developable":
            keys |= {"planes": tool.planes(keys["planes"]), "bounds": tool.planes(keys["bounds"])}
        case "swung" if abs(plane[2]) + abs(plane[3]) <= _ALIKE * patch.surface.size:  # through the axis
            flat = np.column_stack([np.array(keys["trajectory"]), np.zeros(len(keys["trajectory"]))])
            keys["trajectory"] = reflected(flat, plane)[:, :2].tolist()
        case "swung" if 1.0 - abs(plane[2]) <= _ALIKE:
            keys["profile"] = [[r, -2.0 * plane[3] / plane[2] - z] for r, z in keys["profile"]]
        case _:
            return _converted(patch, name, plane, convert, notes)
    image = Patch.of(patch.surface, name).rebuilt(**keys)
    if _away(patch, image, plane) > _EXACT * patch.surface.size:  # planes of which the normal turns, say
        raise ModelError(f"{patch.name}: a {patch.kind} has no image of its kind in this plane")
    return image


def _converted(patch: Patch, name: str, plane: FloatArray, convert: bool, notes: list[str]) -> Patch:
    tensor = as_tensor(patch)
    if tensor is None:
        rows = patch.surface.rows
        what = (
            "surface without control points" if not isinstance(rows, Net) or patch.surface.net is None else patch.kind
        )
        raise ModelError(
            f"{patch.name}: a {what} has no image of its kind in a plane; export it as CAD, and import that"
        )
    if not convert:
        raise ModelError(
            f"{patch.name}: a {patch.kind} has no image of its kind",
            remedy="convert=True makes the image a tensor-product patch",
            key="convert",
        )
    notes.append(f"{name}: made a tensor-product patch")
    return _image(replace(tensor, name=patch.name), name, plane, convert, notes)


def _away(patch: Patch, image: Patch, plane: FloatArray) -> float:
    t = np.linspace(0.0, 1.0, 7)
    u, v = (x.ravel() for x in np.meshgrid(t, t))
    with np.errstate(invalid="ignore"):
        away = np.linalg.norm(reflected(patch.surface(u, v), plane) - image.surface(u, v), axis=-1)
    return float(np.nan_to_num(away).max())


def _rules(model: Model, called: dict[str, str], patches: Sequence[Patch]) -> tuple[Held, ...]:
    """Return the joins that hold, and the same of the images."""
    if not model.held:
        return ()

    def image(text: str) -> str:
        name, _, side = text.rpartition(":")
        return f"{called[name]}:{side}"

    tables = [rule.to_dict() for rule in model.held]
    tables += [table | {"first": image(table["first"]), "second": image(table["second"])} for table in tables]
    return held(tables, tuple(patch.name for patch in patches))
