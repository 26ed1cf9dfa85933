"""Other packages for the same K and H on a grid, each in its own natural way, where the extra ``peers`` is installed.

The surface is the classical biquintic Bézier patch, which all of them hold exactly. Each is checked against quintrig
before it is timed. Peers that work point by point in Python get a smaller grid; times are a point, so that this favours
nobody.
"""

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np

import quintrig
from bench.rivals import curvature, row_blocks
from bench.speed import KH, wavy_net
from bench.timing import race, short, spelt, table
from quintrig.basis.bernstein import Bernstein

Answer = tuple[np.ndarray, np.ndarray]
CLAMPED = [0.0] * 6 + [1.0] * 6


def numpy_blocks(net, u, v) -> Answer:
    """The same formulas in NumPy, in blocks of rows."""
    planes = np.empty((len(u), len(v))), np.empty((len(u), len(v)))
    row_blocks(net, u, v, (0, 0, 0, 0), 16, *planes, basis=lambda *_: Bernstein(5))
    return planes


def splipy(net, u, v) -> Answer:
    """Splipy derivatives on the tensor grid, NumPy formulas."""
    from splipy import BSplineBasis, Surface

    basis = BSplineBasis(6, CLAMPED)
    # Splipy lists control points with u running fastest.
    surface = Surface(basis, basis, net.transpose(1, 0, 2).reshape(-1, 3))
    orders = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    return _formulas(*(surface.derivative(u, v, d=order) for order in orders))


def scipy_bspline(net, u, v) -> Answer:
    """SciPy BSpline in each direction, NumPy formulas."""
    from scipy.interpolate import BSpline

    rows = [BSpline(CLAMPED, net, 5)]
    rows += [rows[0].derivative(1), rows[0].derivative(2)]

    def partial(p, q):
        along = BSpline(CLAMPED, rows[p](u).transpose(1, 0, 2), 5)
        return (along.derivative(q) if q else along)(v).transpose(1, 0, 2)

    return _formulas(partial(1, 0), partial(0, 1), partial(2, 0), partial(1, 1), partial(0, 2))


def scipy_ndbspline(net, u, v) -> Answer:
    """SciPy NdBSpline at the points of the grid, NumPy formulas."""
    from scipy.interpolate import NdBSpline

    spline = NdBSpline((CLAMPED, CLAMPED), net, 5)
    at = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1)
    return _formulas(*(spline(at, nu=order) for order in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))))


def open_cascade(net, u, v) -> Answer:
    """OpenCASCADE GeomLProp_SLProps, point by point from Python."""
    from OCP.Geom import Geom_BezierSurface
    from OCP.GeomLProp import GeomLProp_SLProps
    from OCP.gp import gp_Pnt

    try:
        from OCP.collections import Array2_gp_Pnt as Array
    except ImportError:
        from OCP.TColgp import TColgp_Array2OfPnt as Array
    poles = Array(1, 6, 1, 6)
    for i in range(6):
        for j in range(6):
            poles.SetValue(i + 1, j + 1, gp_Pnt(*net[i, j].tolist()))
    local = GeomLProp_SLProps(Geom_BezierSurface(poles), 2, 1e-12)
    gaussian, mean = np.empty((len(u), len(v))), np.empty((len(u), len(v)))
    across = v.tolist()
    for i, s in enumerate(u.tolist()):
        for j, t in enumerate(across):
            local.SetParameters(s, t)
            local.IsCurvatureDefined()  # without it the first value asked for is that of the point before
            gaussian[i, j] = local.GaussianCurvature()
            mean[i, j] = local.MeanCurvature()
    return gaussian, mean


def geomdl(net, u, v) -> Answer:
    """geomdl derivatives point by point, NumPy formulas."""
    from geomdl import BSpline

    surface = BSpline.Surface()
    surface.degree_u = surface.degree_v = 5
    surface.set_ctrlpts(net.reshape(-1, 3).tolist(), 6, 6)
    surface.knotvector_u = surface.knotvector_v = CLAMPED
    found = np.array([[surface.derivatives(s, t, order=2) for t in v.tolist()] for s in u.tolist()], dtype=object)
    return _formulas(*(found[:, :, p, q].astype(float) for p, q in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))))


PEERS: tuple[tuple[str, str, Callable[..., Answer], int], ...] = (
    ("SciPy BSpline in each direction + NumPy", "scipy", scipy_bspline, 500),
    ("Splipy + NumPy", "splipy", splipy, 500),
    ("SciPy NdBSpline at the points + NumPy", "scipy", scipy_ndbspline, 200),
    ("OpenCASCADE from Python", "OCP", open_cascade, 100),
    ("geomdl + NumPy", "geomdl", geomdl, 20),
)


def _formulas(*partials) -> Answer:
    moved = [np.ascontiguousarray(np.moveaxis(np.asarray(p), -1, 0)) for p in partials]
    planes = np.empty(moved[0].shape[1:]), np.empty(moved[0].shape[1:])
    curvature(*moved, *planes)
    return planes


def report(quick: bool) -> None:
    """Print the table of the peers that are installed."""
    net = wavy_net()
    surface = quintrig.tensor(net, basis="bernstein")
    there = [peer for peer in PEERS if find_spec(peer[1])]
    names = [name for name, *_ in there]
    side = 300 if quick else 500
    grid = np.linspace(0.0, 1.0, side)

    def own(t):
        sample = quintrig.analyse(surface, t[:, None], t[None, :], KH, threads=1)
        return sample["gaussian"], sample["mean"]

    sizes = {name: min(size, side) for name, _, _, size in there}
    off = {}
    for name, _, way, size in there:
        t = np.linspace(0.0, 1.0, min(size, 40))
        off[name] = max(np.abs(a - b).max() / np.abs(b).max() for a, b in zip(way(net, t, t), own(t), strict=True))
    mine, rival = "quintrig, fresh arrays, one thread", "NumPy in blocks of 16 rows"
    ways = {mine: lambda: own(grid), rival: lambda: numpy_blocks(net, grid, grid)}
    for name, _, way, _ in there:
        t = np.linspace(0.0, 1.0, sizes[name])
        ways[name] = lambda way=way, t=t: way(net, t, t)
    count = {mine: side, rival: side} | sizes
    times = {
        name: type(t)(tuple(x / count[name] ** 2 for x in t.rounds))
        for name, t in race(ways, 3 if quick else 5).items()
    }
    rows = [
        (
            name,
            f"{count[name]} x {count[name]}",
            short(times[name].median * 1e9),
            "1" if name == mine else spelt(times[name], times[mine]),
            f"{off[name]:.0e}" if name in off else "-",
        )
        for name in times
    ]
    print(
        "K and H of a classical biquintic patch on a grid, one thread; the largest difference is relative to the "
        "largest value\n"
    )
    table(("way", "grid", "ns a point", "times as slow", "differs by"), rows)
    absent = [name for name, package, *_ in PEERS if name not in names]
    if absent:
        print(f"Not installed: {', '.join(absent)}. Run pip install 'quintrig[peers]'.\n")
