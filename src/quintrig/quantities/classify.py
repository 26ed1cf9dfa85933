"""Classes of points: point type, HK type, shape class and invariant type (thesis tables 3.1-3.4).

Every decision that a curvature is zero is made here, with thresholds that scale with the surface.
"""

from dataclasses import dataclass

from quintrig.support.arrays import number
from quintrig.support.compiled import scalar
from quintrig.support.tolerance import NOISE

POINT_TYPES = ("undefined", "elliptic", "hyperbolic", "parabolic", "planar", "umbilic")
"""Index is the code. An umbilic is an elliptic point with κ1 = κ2 (do Carmo 1976, §3.2)."""

HK_TYPES = (
    "undefined",
    "peak",
    "ridge",
    "saddle ridge",
    "impossible",
    "flat",
    "minimal",
    "pit",
    "valley",
    "saddle valley",
)
"""Index is Besl's number 1 + 3 (1 + sgn H) + (1 - sgn K) (Besl and Jain 1986), 0 where undefined."""

SHAPE_CLASSES = (
    "undefined",
    "spherical cup",
    "trough",
    "rut",
    "saddle rut",
    "saddle",
    "saddle ridge",
    "ridge",
    "dome",
    "spherical cap",
    "planar",
)
"""Index is the code: Koenderink's nine from S = -1 to S = +1, breaks at ±7/8, ±5/8, ±3/8, ±1/8; 10 where flat."""

SHAPE_BREAKS = (0.125, 0.375, 0.625, 0.875)
"""Where |S| passes from one of Koenderink's classes to the next; a break belongs to the class nearer to S = 0."""

INVARIANT_TYPES = (
    "undefined",
    "dome",
    "roof",
    "saddle roof",
    "impossible",
    "level or tilted plane",
    "balanced saddle",
    "bowl",
    "trough",
    "saddle trough",
)
"""What the signs of β1 and β2 say of the height field, numbered like Besl's types (β1 for H, β2 for K)."""


LEAST_THRESHOLD = NOISE
"""Below this, rounding decides: a plane would get shapes."""


@dataclass(frozen=True)
class Thresholds:
    """When a curvature counts as zero.

    A point is flat where C times the surface's ``size`` (diagonal of its bounding box) is at most ``flat``. Elsewhere
    K is zero where |K| <= ``relative`` C², H where |H| <= ``relative`` C, and κ1 = κ2 where (κ1 - κ2)/2 <= ``relative``
    C. Both are pure numbers, so the classes do not change with the unit or the size. Raises ValueError for values
    outside [1e-12, 0.1].
    """

    relative: float = 1e-6
    flat: float = 1e-6

    def __post_init__(self) -> None:
        """Check both once, at birth."""
        for name in ("relative", "flat"):
            value = number(getattr(self, name), name)
            if not LEAST_THRESHOLD <= value <= 0.1:
                raise ValueError(f"{name}: expected a number from {LEAST_THRESHOLD:g} to 0.1, found {value:g}")

    def describe(self, size: float, unit: str = "") -> str:
        """Return the thresholds in words, for a surface of this size (length¹)."""
        if not size > 0.0:
            return "none: the surface is a single point"
        per = f" 1/{unit}" if unit else ""
        return (
            f"flat where the curvedness C <= {self.flat / size:.3g}{per} ({self.flat:g} / size); elsewhere K = 0 means "
            f"|K| <= {self.relative:g} C², H = 0 means |H| <= {self.relative:g} C, and κ1 = κ2 means "
            f"(κ1 - κ2)/2 <= {self.relative:g} C"
        )


@scalar
def besl(gaussian: float, mean: float, curvedness: float, relative: float, flat: float) -> int:
    """Return Besl's number of the signs of K and H; 0 for NaN. ``flat`` is a curvedness, length⁻¹."""
    k_zero = relative * curvedness * curvedness
    h_zero = relative * curvedness
    k_sign = 0 if abs(gaussian) <= k_zero else (1 if gaussian > 0.0 else -1)
    h_sign = 0 if abs(mean) <= h_zero else (1 if mean > 0.0 else -1)
    code = 1 + 3 * (1 + h_sign) + (1 - k_sign)
    code = 5 if curvedness <= flat else code
    return code if abs(curvedness) < 1e300 else 0


@scalar
def point_type(code: int, gaussian: float, half_difference: float, curvedness: float, relative: float) -> int:
    """Return the point type from Besl's number and K; umbilic where R <= relative C."""
    bent = 5 if half_difference <= relative * curvedness else 1
    result = bent if gaussian > 0.0 else 2
    result = 3 if abs(gaussian) <= relative * curvedness * curvedness else result
    result = 4 if code == 5 else result
    return 0 if code == 0 else result


@scalar
def shape_class(index: float, code: int) -> int:
    """Return Koenderink's class of a shape index; 10 where Besl's number says flat, 0 where undefined."""
    first, second, third, fourth = SHAPE_BREAKS
    result = 1 + (index >= -fourth) + (index >= -third) + (index >= -second) + (index >= -first)
    result = result + (index > first) + (index > second) + (index > third) + (index > fourth)
    result = 10 if code == 5 else result
    return 0 if code == 0 else result
