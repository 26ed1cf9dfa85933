"""What an exported notebook shows in place of the interactive view: a picture, and a line that says what it is."""

from collections import Counter

import numpy as np

from quintrig.model.model import Model
from quintrig.quantities.table import quantity
from quintrig.support.tolerance import rounding

_FACETS, _MOST = 60, 36_000  # a side, and in all: a notebook should not wait long for its picture


def png(model: Model, key: str) -> bytes:
    """Return a picture of all patches, coloured by the quantity ``key`` or plain with ``none``; or of all curves."""
    # matplotlib is slow to import, and only pictures need it.
    from quintrig.figure import Scene, plane_curves, space_curves, space_picture, to_png_bytes

    if not model.patches:
        curves = [one.curve for one in model.curves]
        draw = plane_curves if curves[0].points.shape[1] == 2 else space_curves
        return to_png_bytes(
            draw(curves, [one.name for one in model.curves], title=model.name, unit=model.unit), dpi=110
        )

    cells = max(8, min(_FACETS, int((_MOST / len(model.patches)) ** 0.5)))
    surfaces = [patch.surface for patch in model.patches]
    colour = None if key == "none" else key
    figure = space_picture(surfaces, colour, Scene(cells=cells), title=model.name, unit=model.unit)
    return to_png_bytes(figure, dpi=110)


def text(model: Model, key: str) -> str:
    """Return what is shown in one line: name, kinds, size and the quantity that colours it."""
    if not model.patches:
        count = len(model.curves)
        parts = ", ".join(f"{one.curve.length():.4g} {model.unit}".rstrip() for one in model.curves[:4])
        what = "one curve, length" if count == 1 else f"{count} curves, lengths"
        return (
            f"{model.name}: {what} {parts}{', ...' if count > 4 else ''}; interactive in Jupyter while its kernel runs"
        )
    kinds = Counter(patch.kind for patch in model.patches)
    parts = ", ".join(kind if count == 1 else f"{count} {kind}" for kind, count in kinds.items())
    what = f"one patch ({parts})" if len(model.patches) == 1 else f"{len(model.patches)} patches ({parts})"
    colour = "without colours" if key == "none" else f"coloured by {quantity(key).name} {quantity(key).symbol}"
    return f"{model.name}: {what}, {_size(model)}, {colour}; interactive in Jupyter while its kernel runs"


def _size(model: Model) -> str:
    t = np.linspace(0.0, 1.0, 33)
    points = np.concatenate([patch.surface(t[:, None], t[None, :]).reshape(-1, 3) for patch in model.patches])
    points = points[np.isfinite(points).all(axis=-1)]
    if not len(points):
        return "of no finite size"
    rounded = rounding(points)
    sides = " × ".join(f"{side if side > rounded else 0.0:.4g}" for side in np.ptp(points, axis=0))
    return f"{sides} {model.unit}".rstrip()
