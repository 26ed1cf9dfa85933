"""The kind of faces of CAD files."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from quintrig.basis.bspline import BSpline
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.definition import Definition, Keys, Number, Pair, Point, Positive

Degree = Annotated[int, Field(strict=True, ge=1, le=25)]
Knots = Annotated[list[Number], Field(min_length=4, max_length=2048)]


class Nurbs(Definition):
    """Rational B-spline surface (NURBS), such as a face read from a CAD file."""

    title = "NURBS surface"
    words = "A rational B-spline surface, such as a face read from a CAD file."
    formula = (
        r"\mathbf{S}(u,v)=\frac{\sum_{i,j}w_{ij}\,N_i(u)\,N_j(v)\,\mathbf{P}_{ij}}{\sum_{i,j}w_{ij}\,N_i(u)\,N_j(v)}"
    )
    starter: ClassVar[Keys] = {
        "degrees": [2, 2],
        "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]],
        "points": [
            [[x, y, z + rise] for y, z in ((0, 0), (50, 50), (100, 0))] for x, rise in ((0, 0), (50, 30), (100, 0))
        ],
        "weights": [[1, 0.7, 1], [1, 0.7, 1], [1, 0.7, 1]],
    }
    kind: Literal["nurbs"] = "nurbs"
    degrees: Annotated[list[Degree], Field(min_length=2, max_length=2)] = Field(description="Degrees (p, q) in u and v")
    knots: Annotated[list[Knots], Field(min_length=2, max_length=2)] = Field(
        description="Full knot vectors in u and v: control points + degree + 1 numbers each; u, v in [0, 1] span them"
    )
    points: Annotated[list[Annotated[list[Point], Field(min_length=2, max_length=2048)]], Field(max_length=2048)] = (
        Field(min_length=2, description="Control points [x, y, z]; points[i][j] with i along u, j along v")
    )
    weights: Annotated[list[list[Positive]], Field(max_length=2048)] | None = Field(
        default=None, description="Weights of the control points, all 1 when left out"
    )
    trim: list[Annotated[list[Pair], Field(min_length=3)]] = Field(
        default=[], description="Closed loops of [u, v] that bound the face on its surface"
    )

    def surface(self) -> Surface:
        """Build the surface."""
        return nurbs(self.points, self.weights, self.degrees, self.knots, flip=self.flip, trim=self.trim)

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys of which this kind would build the surface, or None."""
        rows, v = surface.rows, surface.blend
        if not isinstance(rows, Net) or not isinstance(rows.functions, BSpline) or not isinstance(v, BSpline):
            return None
        u, points = rows.functions, rows.points
        keys: Keys = {"degrees": [u.degree, v.degree], "knots": [list(u.knots), list(v.knots)]}
        keys |= {"trim": [loop.tolist() for loop in surface.trim]} if surface.trim else {}
        if rows.dimension == 3:
            return keys | {"points": (points + surface.origin).tolist()}
        weights = points[..., 3]
        return keys | {
            "points": (points[..., :3] / weights[..., None] + surface.origin).tolist(),
            "weights": weights.tolist(),
        }
