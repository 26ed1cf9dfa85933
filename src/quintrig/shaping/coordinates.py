"""The coordinates of a patch's control points, or planes, in one row, and those that a user names."""

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError, nearest

_AXES = {2: ("xy", "rz"), 3: ("xyz",), 4: ("abcd",)}


def control_points(patch: Patch) -> dict[str, FloatArray]:
    """Return the nets and polygons of a patch, or its planes, by their keys."""
    definition = patch.definition
    names = definition.nets or tuple(key for key in ("points",) if hasattr(definition, key))
    return {key: np.array(getattr(definition, key), dtype=np.float64) for key in names}


def flattened(patch: Patch) -> FloatArray:
    """Return all coordinates of control points, or planes, in the order of the kind's keys."""
    arrays = control_points(patch)
    if not arrays:
        raise ModelError(f"vary: points: a {patch.kind} has no control points to vary; vary its {_has(patch)}")
    return np.concatenate([one.ravel() for one in arrays.values()])


def nets_of(patch: Patch, flat: FloatArray) -> dict[str, Any]:
    """Return the keys of a patch of such coordinates."""
    keys: dict[str, Any] = {}
    for key, array in control_points(patch).items():
        keys[key], flat = flat[: array.size].reshape(array.shape).tolist(), flat[array.size :]
    return keys


def _has(patch: Patch) -> str:
    return ", ".join(patch.definition.parameters) or "nothing"


def chosen_by(patch: Patch, only: Sequence[str], place: str = "only") -> NDArray[np.int64]:
    """Return the indices of the coordinates that ``only`` names, all where it is empty.

    Such as ``points[2][3]``, ``section[1].z`` or ``z``. Raises ModelError, beginning with ``place``, for others.
    """
    total = len(flattened(patch))
    if not only:
        return np.arange(total)
    taken: FloatArray = np.zeros(total)
    for text in only:
        taken += _named(patch, text, place)
    return np.flatnonzero(taken)


def _named(patch: Patch, text: str, place: str) -> FloatArray:
    """Return 1 for the coordinates that a text names, else 0."""
    arrays = control_points(patch)
    example = f"{next(iter(arrays))}[1], {next(iter(arrays))}[1].z or z"
    wrong = ModelError(f"{place}: expected control points or coordinates such as {example}, found {text[:60]!r}")
    found = re.fullmatch(r"\s*(?:([a-z_]+)((?:\[\d+\])*))?(?:\.?([a-z]))?\s*", text)
    if text.strip() in {letter for words in _AXES.values() for word in words for letter in word}:
        name, places, axis = None, "", text.strip()
    elif found is None or found[1] is None:
        raise wrong
    else:
        name, places, axis = found[1], found[2] or "", found[3]
        if name not in arrays and axis and "." not in text:
            name, axis = name + axis, None
        if name not in arrays:
            raise ModelError(f"{place}: no control points {name!r}{nearest(name, arrays)}; a {patch.kind} has "
                             f"{', '.join(arrays)}")  # fmt: skip
    index = tuple(int(part) for part in re.findall(r"\d+", places))
    parts: list[FloatArray] = []
    for key, array in arrays.items():
        mark = np.zeros_like(array)
        if name in (None, key):
            if len(index) > array.ndim - 1 or any(k >= size for k, size in zip(index, array.shape, strict=False)):
                raise ModelError(f"{place}: {text!r}: {key} has {' x '.join(map(str, array.shape[:-1]))} of them, "
                                 "counted from 0")  # fmt: skip
            mark[index] = 1.0
            if axis:
                letters = next((word for word in _AXES[array.shape[-1]] if axis in word), None)
                if letters is None:
                    raise wrong
                kept = mark[..., letters.index(axis)].copy()
                mark[:] = 0.0
                mark[..., letters.index(axis)] = kept
        parts.append(mark.ravel())
    return np.concatenate(parts)
