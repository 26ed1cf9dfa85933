"""Light running over a boot lid.

Parallel tubes of light, as an eye sees them in the lid: where they crowd, it bends.
"""

import quintrig

boot = quintrig.load("examples/car_boot.toml")
lights = quintrig.reflection_lines(
    boot, direction=(0.4, -0.5, 1), light=(0, 0, 3000), along=(1, 0, 0), spacing=300, count=21
)
picture = quintrig.plot(boot, lines=lights)
