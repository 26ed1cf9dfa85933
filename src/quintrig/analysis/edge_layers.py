"""Layers along the edges of the domain, in which a surface nearly stands still and so changes within a short way.

With α a little above -4 the speed across an edge is (π/2)(4 + α) at the edge and has twice that at a distance of about
(4 + α)/40: curvature changes over a layer of this width. Rows of control points that nearly coincide, a cone cut off
beside its apex and a corner of a ruled surface do the same.
"""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import SINGULAR

Layers = tuple[float, float, float, float]
"""Widths at u = 0, u = 1, v = 0 and v = 1, in the parameter."""

_ALONG = 17  # points on an edge
_CLEAR = 1 / 4  # from a singular point, such as a corner, whose nearness is no layer
_THIN = 1 / 32  # equal panels resolve wider layers


def layers_at_edges(surface: Surface) -> Layers:
    """Return the widths of thin layers along the edges, infinite where there is none.

    The width is |N| / |∂N| across the edge, N = S_u × S_v, at the point of the edge where it is least. Points where
    N = 0 to rounding, and those near them, are left out: there no width is small enough.
    """
    t = np.linspace(0.0, 1.0, _ALONG)
    tiny = SINGULAR * surface.size**2
    widths: list[float] = []
    for axis in range(2):
        for end in (0.0, 1.0):
            place = np.full_like(t, end)
            p = surface.partials(place, t, 2) if axis == 0 else surface.partials(t, place, 2)
            widths.append(_width(p, axis, tiny, t))
    return widths[0], widths[1], widths[2], widths[3]


def _width(p: FloatArray, axis: int, tiny: float, t: FloatArray) -> float:
    normal = np.cross(p[1, 0], p[0, 1])
    second, mixed = ((2, 0), (1, 1)) if axis == 0 else ((1, 1), (0, 2))
    rate = np.linalg.norm(np.cross(p[second], p[0, 1]) + np.cross(p[1, 0], p[mixed]), axis=-1)
    area = np.linalg.norm(normal, axis=-1)
    away = np.abs(t[:, None] - t[area <= tiny]).min(axis=1, initial=np.inf)
    regular = (area > tiny) & (rate > 0.0) & (away >= _CLEAR)
    if not regular.any():
        return np.inf
    width = float((area[regular] / rate[regular]).min())
    return width if width < _THIN else np.inf
