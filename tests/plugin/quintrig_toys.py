"""What a package brings that adds a kind and a reference surface: two classes, and two entry points."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from quintrig import Surface, swept
from quintrig.basis.elementary import Powers
from quintrig.geometry.surface import Net
from quintrig.model.kinds.definition import Bezier, Definition, Keys, Polygon, Positive


class Scroll(Bezier):
    """Section swept along the z axis by a height."""

    title = "Scroll"
    words = "A section that is lifted straight up."
    formula = r"\mathbf{S}(u,v)=\mathbf{C}(u;\alpha_1,\zeta_1)+h\,v\,\mathbf{e}_z"
    starter: ClassVar[Keys] = {"section": [[10 * i, 5 * i * (5 - i), 0] for i in range(6)], "height": 30}
    nets = ("section",)
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"section": (6,)}
    kind: Literal["scroll"] = "scroll"
    section: Polygon = Field(description="6 points [x, y, z] of the section curve, along u")
    height: Positive = Field(default=1.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        lift = np.outer(np.linspace(0.0, self.height, len(self.section)), (0.0, 0.0, 1.0))
        return swept(self.section, lift, self.shape, **self.options)


class Bowl(Definition):
    """Paraboloid z = (x² + y²) / 2r over a square."""

    kind: Literal["bowl"] = "bowl"
    radius: Positive = Field(default=2.0, description="Radius of curvature at the bottom")

    def surface(self) -> Surface:
        """Build the surface."""
        points = np.zeros((3, 3, 3))
        points[1, 0, 0] = points[0, 1, 1] = 1.0
        points[2, 0, 2] = points[0, 2, 2] = 0.5 / self.radius
        powers = Powers(-self.radius, self.radius, 2)
        return Surface(Net(points, powers), powers, self.flip)
