"""The kind of a curve, in the plane or in space: it has no surface, and so stands beside the kinds of surfaces."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from quintrig.basis.pairs import check_count
from quintrig.geometry.curve import Curve
from quintrig.model.kinds.definition import Based, Keys, Outline, Polygon


class CurveKind(Based):
    """Curve."""

    title = "Curve"
    words = "A curve in the plane or in space, from the first control point to the last, inside their convex hull."
    formula = r"\mathbf{z}(t)=\sum_{i=0}^{5}\mathbf{P}_i\,f_i(t;\alpha,\zeta)"
    starter: ClassVar[Keys] = {"points": [[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]]}
    shape_names: ClassVar[tuple[str, ...]] = ("alpha", "zeta")
    nets = ("points",)
    kind: Literal["curve"] = "curve"
    points: Outline | Polygon = Field(description="6 control points, all [x, y] or all [x, y, z]")
    close: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="End in the first control point, which is then not given again as the last"
    )
    flip: Annotated[bool, Field(strict=True)] = Field(default=False, description="Run from the other end")

    @property
    def point_counts(self) -> tuple[int, ...]:
        """Number of control points: with ``close`` the first counts once more, as the last."""
        return (len(self.points) + self.close,)

    def curve(self) -> Curve:
        """Build the curve; ValueError for a wrong number of points or shape parameters outside their range."""
        (choice,), (wanted,) = self.choices, self.point_counts
        try:
            check_count(choice, wanted, "points")
        except ValueError as error:
            closed = "; close = true adds the first once more, as the last" if self.close else ""
            raise ValueError(f"{error}{closed}") from None
        points: list[list[float]] = [*self.points, *self.points[: self.close]]
        values = self.shape_values
        if self.flip:
            if not (self.classical or self.standard):
                raise ValueError("flip: expected the quintic or the Bernstein basis, whose ends can be exchanged")
            points, values = points[::-1], values[::-1]
        if self.classical:
            return Curve(points, basis="bernstein")
        if self.standard:
            return Curve(points, values[0], values[1], unchecked_shape=self.unchecked_shape)
        return Curve(points, basis=choice, shape=values, unchecked_shape=self.unchecked_shape)
