"""Three readings of one surface.

HK types, shape classes and the types of the invariants answer one question, what shape a point has,
each in its own terms.
"""

import quintrig

wavy = quintrig.load("examples/wavy.toml")
picture = quintrig.plot(wavy, ["hk_type", "shape_class", "invariant_type"], width=10)
