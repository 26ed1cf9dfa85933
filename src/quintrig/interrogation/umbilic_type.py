"""What an isolated umbilic is: its curvature, index and type, and how lines of curvature leave it."""

from collections.abc import Sequence

import numpy as np

from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import index_about
from quintrig.interrogation.umbilic import Type, Umbilic
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

_FLAT = 1e-7  # of 1 / size: a curvature this small is that of a planar point
_FLAT_FORM = 1e-6  # of the square of the derivative: below it, an umbilic is not a simple one
_WEAK = 1e-4  # of the typical curvature by the size: a change of curvature of which rounding may be a part


def classified(patch: Patch, uv: FloatArray, others: Sequence[FloatArray], typical: float) -> Umbilic:
    """Return the umbilic at parameters (2,); its index is told by turning around it, with ``others`` outside."""
    surface = patch.surface
    local = Local.at(surface, *uv, order=3)
    a, b, c, d = (float(x) for x in local.cubic)
    flat_at = _FLAT / surface.size
    curvature = float(local.mean)
    determinant = a * c - c * c + b * d - b * b
    square = a * a + 3.0 * b * b + 3.0 * c * c + d * d
    index = -0.5 if determinant < 0.0 else 0.5
    simple = abs(determinant) > _FLAT_FORM * square
    if not simple or np.sqrt(square) <= _WEAK * typical / surface.size:
        turned = index_about(surface, uv, others)
        simple = simple and turned in (index, None)
        index = index if simple else float("nan") if turned is None else turned
    roots = _roots(b, 2.0 * c - a, d - 2.0 * b, -c)
    kind: Type = "other"
    if abs(curvature) <= flat_at:
        kind, curvature = "planar", 0.0
    elif simple:
        kind = "star" if determinant < 0.0 else "monstar" if len(roots) == 3 else "lemon"
    return Umbilic(
        patch.name,
        float(uv[0]),
        float(uv[1]),
        surface(*uv),
        curvature,
        index,
        kind,
        tuple(np.degrees(roots).tolist()) if simple else (),
    )


def _roots(p: float, q: float, r: float, s: float) -> list[float]:
    """Return the angles in [0, π) at which p x³ + q x² y + r x y² + s y³ vanishes, x and y being cosine and sine."""
    # By double and single angles: a trigonometric cubic, with at most three zeros in half a turn.
    t = np.linspace(1e-3, 1e-3 + np.pi, 721)  # no simple angle among them

    def at(angle: FloatArray | float) -> FloatArray:
        x, y = np.cos(angle), np.sin(angle)
        return np.asarray(p * x**3 + q * x * x * y + r * x * y * y + s * y**3)

    values = at(t)
    zeros = t[:-1][values[:-1] == 0.0]
    (cross,) = np.nonzero(values[:-1] * values[1:] < 0.0)
    low, high = t[cross], t[cross + 1]
    for _ in range(50):  # halved to the last bit; SciPy's search takes a hundred times longer to import
        middle = 0.5 * (low + high)
        left = at(low) * at(middle) <= 0.0
        low, high = np.where(left, low, middle), np.where(left, middle, high)
    return sorted((np.concatenate([zeros, 0.5 * (low + high)]) % np.pi).tolist())
