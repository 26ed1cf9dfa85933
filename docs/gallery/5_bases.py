"""Bases of the field.

Every basis with four functions draws its own curve on the same polygon.
"""

from matplotlib.figure import Figure

import quintrig

polygon = [[0, 0], [1, 2], [3, 2], [4, 0]]
choices = {"bernstein": (), "cubic": (1, 1), "ali_cubic": (2, 2), "c_bezier": (3,), "lambda_bezier": (1,)}
picture = Figure(figsize=(7, 3.6))
axes = picture.add_subplot()
for basis, shape in choices.items():
    curve = quintrig.Curve(polygon, basis=basis, shape=shape)
    axes.plot(*curve([k / 200 for k in range(201)]).T, label=f"{basis} {shape or ''}")
axes.plot(*zip(*polygon, strict=True), "o--", color="grey", linewidth=0.8, markersize=4)
axes.set_aspect("equal")
axes.legend(frameon=False, loc="lower center")
