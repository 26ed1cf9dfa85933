"""The trim loops of a developable face in its flat pattern, and the area that they hold."""

import numpy as np

from quintrig.developables.panels import Panels
from quintrig.developables.rulings import Rulings
from quintrig.geometry.polygon import balanced, refined
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import Inside, along, nodes_inside
from quintrig.support.arrays import FloatArray


def flat_loops(lines: Rulings, panels: Panels, chord: float) -> tuple[FloatArray, ...]:
    """Return the loops (n, 2) in the plane, within ``chord`` of the true ones, length¹."""
    found: list[FloatArray] = []
    for loop in lines.surface.trim:

        def curve(t: FloatArray, loop: FloatArray = loop) -> FloatArray:
            return _laid(lines, panels, along(loop, t))

        t = refined(curve, np.arange(len(loop) + 1.0), chord)
        inner = t != np.rint(t)  # vertices of the loop stay
        found.append(balanced(curve(t), curve(0.5 * (t[:-1] + t[1:])), inner)[:-1])
    return tuple(found)


def _laid(lines: Rulings, panels: Panels, at: FloatArray) -> FloatArray:
    """Return where points at (u, v) (n, 2) lie in the pattern: as far along their ruling as on the surface."""
    t = at[:, 0] if lines.along == "u" else at[:, 1]
    first, second, _, _ = panels.at(t)
    reach = second - first
    return first + reach * _share(lines, at)[:, None]


def _share(lines: Rulings, at: FloatArray) -> FloatArray:
    """Return how far along their ruling points at (u, v) (n, 2) lie, as a share of its length."""
    ends: list[FloatArray] = []
    for end in (0.0, 1.0):
        edge = at.copy()
        edge[:, 1 if lines.along == "u" else 0] = end
        ends.append(lines.surface(edge[:, 0], edge[:, 1]))
    ruling = ends[1] - ends[0]
    return ((lines.surface(at[:, 0], at[:, 1]) - ends[0]) * ruling).sum(-1) / (ruling**2).sum(-1)


def face_area(lines: Rulings) -> float:
    """Return the area of the neutral layer that the loops hold, from the surface's derivatives, length²."""
    surface = lines.surface
    ends = [np.unique(np.concatenate([surface.breaks(axis), np.linspace(0.0, 1.0, 9)])) for axis in (0, 1)]
    nodes = nodes_inside(surface.trim, ends[0], ends[1], surface.breaks(1), 12)
    total = 0.0
    for part in nodes.parts:
        at = np.stack([nodes.u[part], nodes.v[part]], axis=-1)
        frame = lines.at(at[:, 0] if lines.along == "u" else at[:, 1])
        share = _share(lines, at)
        across = (1.0 - share) * frame.across[0] + share * frame.across[1]
        partials = surface.partials(at[:, 0], at[:, 1], 1)
        along_it = partials[0, 1] if lines.along == "u" else partials[1, 0]
        total += float((np.abs(across) * np.sqrt((along_it**2).sum(-1))) @ nodes.weights[part])
    return total


def loops_area(surface: Surface, loops: tuple[FloatArray, ...]) -> float:
    """Return the area that the images of a face's loops hold together: outlines count, holes in them do not."""
    total = 0.0
    for k, (loop, image) in enumerate(zip(surface.trim, loops, strict=True)):
        others = [Inside([other]) for j, other in enumerate(surface.trim) if j != k]
        depth = sum(bool(other(loop[:1, 0], loop[:1, 1])[0]) for other in others)
        x, y = image.T
        total += (-1.0) ** depth * 0.5 * abs(float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()))
    return total
