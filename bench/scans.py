"""Measured points beside other packages: fits of the same points, deviation by brute force, curvature of a torus."""

from importlib.util import find_spec

import numpy as np

import quintrig
from bench.speed import wavy_net
from bench.timing import race, short, spelt, table


def report(quick: bool) -> None:
    """Print the tables."""
    surface = quintrig.tensor(wavy_net())
    _fits(surface, quick)
    _deviation(surface, quick)
    _curvature(quick)


def _titled(title, head, rows):
    print(f"\n### {title}\n")
    table(head, rows)


def _grid(surface, side, noise):
    t = np.linspace(0.0, 1.0, side)
    points = surface(t[:, None], t[None, :])
    return points + noise * np.random.default_rng(0).normal(size=points.shape)


def _fits(surface, quick):
    side, noise = 30, 1e-3 * surface.size
    points = _grid(surface, side, noise)
    flat = points.reshape(-1, 3)

    def ours():
        return quintrig.fit(flat).model.surface

    def scipy_splines():
        from scipy.interpolate import SmoothBivariateSpline

        return SmoothBivariateSpline(*flat.T, kx=5, ky=5, s=len(flat) * noise**2)

    ways = {"quintrig.fit": ours, "scipy SmoothBivariateSpline, heights only": scipy_splines}
    if find_spec("geomdl"):
        from geomdl.fitting import approximate_surface

        def geomdl_fit():
            return approximate_surface(flat.tolist(), side, side, 5, 5, ctrlpts_size_u=6, ctrlpts_size_v=6)

        ways["geomdl approximate_surface, points of a grid"] = geomdl_fit
    times = race(ways, 2 if quick else 3)
    errors = {"quintrig.fit": _error(surface, ours())}
    t = np.linspace(0.03, 0.97, 60)
    true = surface(t[:, None], t[None, :]).reshape(-1, 3)
    spline = scipy_splines()
    heights = spline.ev(true[:, 0], true[:, 1])
    errors["scipy SmoothBivariateSpline, heights only"] = float(np.sqrt(np.mean((heights - true[:, 2]) ** 2)))
    if "geomdl approximate_surface, points of a grid" in ways:
        found = geomdl_fit()
        exact = quintrig.tensor(np.array(found.ctrlpts).reshape(6, 6, 3), basis="bernstein")
        errors["geomdl approximate_surface, points of a grid"] = _error(surface, exact)
    base = times["quintrig.fit"]
    rows = [
        (name, spelt(times[name], base), short(errors[name] / noise * np.sqrt(len(flat))))
        for name in ways
    ]  # fmt: skip
    _titled(
        f"Fits of {len(flat)} points with noise: time of each over quintrig's, error of the surface over noise/√n",
        ("way", "time", "error"),
        rows,
    )


def _error(surface, found):
    """The rms distance of the true surface from the fitted one."""
    t = np.linspace(0.03, 0.97, 60)
    return quintrig.deviation(found, surface(t[:, None], t[None, :]).reshape(-1, 3)).rms


def _deviation(surface, quick):
    from scipy.spatial import cKDTree

    count = 100_000 if quick else 1_000_000
    points = surface(*np.random.default_rng(0).random((2, count))) + 1e-3 * surface.size
    t = np.linspace(0.0, 1.0, 1001)
    cloud = surface(t[:, None], t[None, :]).reshape(-1, 3)
    ways = {
        "quintrig.deviation": lambda: quintrig.deviation(surface, points),
        "scipy KD-tree of a million points of the surface": lambda: cKDTree(cloud).query(points, workers=-1),
    }
    times = race(ways, 2)
    found = np.abs(quintrig.deviation(surface, points).distance)
    off = cKDTree(cloud).query(points, workers=-1)[0] - found
    base = times["quintrig.deviation"]
    rows = [
        ("quintrig.deviation", spelt(base, base), "0"),
        (
            "scipy KD-tree of a million points of the surface",
            spelt(times[next(reversed(ways))], base),
            f"{off.max():.1e}",
        ),
    ]
    _titled(f"Distances of {count:,} points: time over quintrig's, and how much too long", ("way", "time", "off"), rows)


def _curvature(quick):
    """Errors of K on a jittered torus, where theory gives the order."""
    rows = []
    for count in (2_000, 8_000) if quick else (2_000, 8_000, 32_000):
        rng = np.random.default_rng(0)
        m = round(np.sqrt(count / 3))
        u, v = np.meshgrid(np.arange(m) / m, np.arange(3 * m) / (3 * m), indexing="ij")
        u = ((u + rng.uniform(-0.3, 0.3, u.shape) / m) % 1).ravel()
        v = ((v + rng.uniform(-0.3, 0.3, v.shape) / (3 * m)) % 1).ravel()
        points = quintrig.torus(3.0, 1.0)(u, v)
        true = np.cos(2 * np.pi * u) / (3 + np.cos(2 * np.pi * u))
        row = [f"{len(points):,}"]
        for degree, neighbours in ((2, 20), (3, 26), (4, 40)):
            found = quintrig.scan_curvature(points, degree=degree, neighbours=neighbours)
            row.append(f"{np.sqrt(np.mean((found['gaussian'] - true) ** 2)):.1e}")
        rows.append(tuple(row))
    _titled("K of a jittered torus by jets: rms error", ("points", "degree 2", "degree 3", "degree 4"), rows)
