"""Stripes across a seam.

A striped room, reflected in the rear window and the boot lid of a car: the stripes break where both meet in a crease.
"""

import quintrig

rear = quintrig.load("examples/rear_of_car.toml")
picture = quintrig.plot(rear, "zebra")
