"""Gaussian and mean curvature.

On a torus K changes its sign along the two circles on which a plane would lie flat.
"""

import quintrig

picture = quintrig.plot(quintrig.torus(3.0, 1.0), ["K", "H"], unit="cm", width=8)
