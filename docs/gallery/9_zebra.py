"""Stripes across a seam.

The stripes of a striped room, reflected in the rear window and the boot lid of a car: they break where both meet in a crease.
"""

import quintrig

rear = quintrig.load("examples/rear_of_car.toml")
picture = quintrig.plot(rear, "zebra")
