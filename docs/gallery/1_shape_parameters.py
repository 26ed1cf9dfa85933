"""What a shape parameter does to a curve.

The same six control points, α and ζ from -4 to 1: the larger, the closer the curve follows its polygon.
"""

from matplotlib.figure import Figure

import quintrig

points = [[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]]
picture = Figure(figsize=(7, 3.6))
axes = picture.add_subplot()
for shape in (-4, -2, 0, 1):
    curve = quintrig.Curve(points, alpha=shape, zeta=shape)
    axes.plot(*curve([k / 200 for k in range(201)]).T, label=f"α = ζ = {shape}")
axes.plot(*zip(*points, strict=True), "o--", color="grey", linewidth=0.8, markersize=4)
axes.set_aspect("equal")
axes.legend(frameon=False, loc="upper right")
