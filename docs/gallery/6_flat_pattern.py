"""A developable vault, unrolled.

A surface with K = 0 is cut from sheet: its rulings stay straight, and lengths stay what they are.
"""

from matplotlib.figure import Figure

import quintrig

vault = quintrig.load("examples/developable.toml")
pattern = quintrig.unroll(vault.surface)
picture = Figure(figsize=(7, 4))
axes = picture.add_subplot()
axes.fill(*pattern.outline.T, facecolor="#dfe8ee", edgecolor="black", linewidth=1.2)
for start, end in list(zip(pattern.first, pattern.second, strict=True))[:: len(pattern.t) // 20]:
    axes.plot(*zip(start, end, strict=True), color="#1f4e5f", linewidth=0.5)
axes.set_aspect("equal")
axes.set_xlabel(vault.unit)
axes.set_ylabel(vault.unit)
