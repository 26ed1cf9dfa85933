"""Lines of curvature on an ellipsoid.

They turn around its four umbilics, the lemons, where it bends alike in every direction.
"""

import quintrig

ellipsoid = quintrig.ellipsoid(3.0, 2.0, 1.0)
picture = quintrig.plot(ellipsoid, lines="curvature", unit="cm")
