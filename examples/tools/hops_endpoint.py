"""An endpoint for Grasshopper's Hops: a net of points in, a quintrig surface and its least radius out.

Run ``pip install quintrig ghhops-server rhino3dm flask`` and ``python hops_endpoint.py``, and point a Hops component
at http://localhost:5000/tensor. Its inputs are 36 points, row by row, and four shape parameters from -4 to 1.
"""

import ghhops_server as hs
import numpy as np
from flask import Flask

import quintrig

app = Flask(__name__)
hops = hs.Hops(app)


@hops.component(
    "/tensor",
    name="Quintic trigonometric",
    description="A tensor-product quintic trigonometric Bézier surface",
    inputs=[
        hs.HopsPoint("Points", "P", "36 control points, row by row", hs.HopsParamAccess.LIST),
        hs.HopsNumber("Shape", "S", "α1, α2, ζ1, ζ2", hs.HopsParamAccess.LIST),
    ],
    outputs=[
        hs.HopsSurface("Surface", "S", "The same surface, exact"),
        hs.HopsNumber("Radius", "R", "Least radius of curvature, length of the points"),
    ],
)
def tensor(points, shape):
    """Return the surface as NURBS and its least radius of curvature."""
    net = np.array([[point.X, point.Y, point.Z] for point in points]).reshape(6, 6, 3)
    surface = quintrig.tensor(net, shape)
    bent = quintrig.analyse(surface, *quintrig.grid(65, 65), ["k1", "k2"])
    return surface.to_rhino3dm(), float(1.0 / np.maximum(abs(bent["k1"]), abs(bent["k2"])).max())


if __name__ == "__main__":
    app.run()
