"""Points that an integral takes, with panels that end at the inner knots and with panels that run over them."""

import numpy as np

import quintrig
from bench.timing import table
from quintrig.analysis.quadrature import Panels, panel_sums
from quintrig.geometry.nurbs import nurbs

RADIUS, HEIGHT = 10.0, 20.0
AREA = 2.0 * np.pi * RADIUS * HEIGHT


def cylinder() -> quintrig.Surface:
    """Return a full turn in three arcs, as CAD programs write it: double knots at each third."""
    angles = np.arange(7) * np.pi / 3.0
    weights = np.where(np.arange(7) % 2, 0.5, 1.0)
    ring = np.stack([np.cos(angles), np.sin(angles), 0.0 * angles], axis=-1) * (RADIUS / weights)[:, None]
    points = np.stack([ring, ring + np.array([0.0, 0.0, HEIGHT])], axis=1)
    knots = ([0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [0, 0, 1, 1])
    return nurbs(points, np.stack([weights, weights], axis=1), (2, 1), knots)


def report(quick: bool) -> None:
    """Print the error of the area of a cylinder and the points it took."""
    surface = cylinder()

    def element(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        p = surface.partials(u, v, 1)
        return np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1)[None]

    found = quintrig.integrals(surface)
    rows = [("panels end at knots", f"{found.points:,}", f"{abs(found.area.value / AREA - 1.0):.1e}")]
    for count in (4, 16) if quick else (4, 16, 64):  # powers of two never meet a third
        panels = Panels(*2 * (np.linspace(0.0, 1.0, count + 1),))
        area = float(panel_sums(element, panels)[0])
        rows.append((f"{count} × {count} panels over them", f"{panels.points:,}", f"{abs(area / AREA - 1.0):.1e}"))
    print("Integrals: the area of a cylinder of three rational arcs\n")
    table(("panels", "points", "relative error"), rows)
