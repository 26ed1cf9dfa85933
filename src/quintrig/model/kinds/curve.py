"""The kind of a curve, in the plane or in space: it has no surface, and so stands beside the kinds of surfaces."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from quintrig.basis.registry import BasisName
from quintrig.geometry.curve import Curve
from quintrig.model.kinds.definition import Definition, Keys, Outline, Polygon, Two


class CurveKind(Definition):
    """Curve."""

    title = "Curve"
    words = "A curve in the plane or in space, from the first control point to the last, inside their convex hull."
    formula = r"\mathbf{z}(t)=\sum_{i=0}^{5}\mathbf{P}_i\,f_i(t;\alpha,\zeta)"
    starter: ClassVar[Keys] = {"points": [[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]]}
    shape_names: ClassVar[tuple[str, ...]] = ("alpha", "zeta")
    nets = ("points",)
    kind: Literal["curve"] = "curve"
    points: Outline | Polygon = Field(description="6 control points, all [x, y] or all [x, y, z]")
    shape: Two = Field(default=[0.0, 0.0], description="Shape parameters (α, ζ), each in [-4, 1]")
    close: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="End in the first control point, which is then not given again as the last"
    )
    basis: BasisName = Field(default="trigonometric", description="'bernstein' gives the classical curve")
    unchecked_shape: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="Allow shape parameters outside [-4, 1]; the convex-hull property is then lost"
    )
    flip: Annotated[bool, Field(strict=True)] = Field(default=False, description="Run from the other end")

    @property
    def classical(self) -> bool:
        """Whether the classical Bernstein basis is used, on which shape parameters do not act."""
        return self.basis == "bernstein"

    def curve(self) -> Curve:
        """Build the curve; ValueError for a wrong number of points or shape parameters outside their range."""
        if self.close and not self.classical and len(self.points) != 5:
            raise ValueError(f"points: expected 5 with close = true, which ends in the first, got {len(self.points)}")
        points: list[list[float]] = [*self.points, *self.points[: self.close]]
        alpha, zeta = self.shape
        if self.flip:
            points, alpha, zeta = points[::-1], zeta, alpha
        return Curve(points, alpha, zeta, basis=self.basis, unchecked_shape=self.unchecked_shape)
