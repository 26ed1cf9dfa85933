"""A car boot lid, and what α and ζ do to it.

One net of control points, four sets of shape parameters, one scale of colours.
"""

from matplotlib.figure import Figure

import quintrig

boot = quintrig.load("examples/car_boot.toml")
picture = Figure(figsize=(10, 7))
for place, shape in enumerate([(1, 1, 1, 1), (1, 1, -3, -3), (1, -3, 1, -3), (1, 0, -2, -3)], start=1):
    axes = picture.add_subplot(2, 2, place)
    quintrig.plot(boot.with_shape(shape), "H", axes=axes, limits=(-0.02, 0.02))
    axes.set_title(f"(α₁, ζ₁, α₂, ζ₂) = {shape}", fontsize=10)
