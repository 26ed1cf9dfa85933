"""Deviation: against brute force, closed forms, known motions; in Python and on the command line."""

import json

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial import cKDTree

import cli_runner
import quintrig
from quintrig.scan.align import rotation

FLAT = [[[20.0 * i, 20.0 * j, 0.0] for j in range(6)] for i in range(6)]


def crumpled(seed=3):
    """A patch that folds over itself."""
    rng = np.random.default_rng(seed)
    net = np.array(FLAT) / 20.0 + 0.9 * rng.normal(size=(6, 6, 3))
    return quintrig.tensor(net, (0.5, -2.0, -3.5, 1.0))


def brute(surface, points, side=200, starts=3):
    """Distances by a fine grid and another package's minimiser from the best places of it."""
    t = np.linspace(0, 1, side + 1)
    grid = surface(t[:, None], t[None, :]).reshape(-1, 3)
    _, near = cKDTree(grid).query(points, k=starts)
    result = []
    for p, places in zip(points, near, strict=True):

        def gap(x, p=p):
            d = surface.partials(*x, 1)
            r = d[0, 0] - p
            return r @ r, 2 * np.array([r @ d[1, 0], r @ d[0, 1]])

        found = [
            minimize(gap, (t[k // (side + 1)], t[k % (side + 1)]), jac=True, bounds=[(0, 1)] * 2, tol=1e-16)
            for k in places
        ]
        result.append(np.sqrt(min(one.fun for one in found)))
    return np.array(result)


def test_nearest_points_are_those_of_brute_force_at_folds_and_edges():
    surface = crumpled()
    rng = np.random.default_rng(5)
    near = surface(*rng.random((2, 20))) + 0.05 * rng.normal(size=(20, 3))
    points = np.concatenate([near, rng.uniform(-3, 8, (20, 3))])
    found = quintrig.deviation(surface, points)
    assert np.abs(np.abs(found.distance) - brute(surface, points)).max() < 1e-9
    assert np.abs(surface(found.u, found.v) - found.foot).max() < 1e-12
    # Where the foot is no edge, the distance is along the normal.
    d = surface.partials(found.u, found.v, 1)
    inner = ~found.edge
    for slope in (d[1, 0], d[0, 1]):
        slip = np.einsum("ij,ij->i", (points - found.foot)[inner], slope[inner])
        assert np.abs(slip).max() < 1e-6


@pytest.mark.parametrize(
    ("surface", "exact"),
    [
        (quintrig.sphere(2.0), lambda p: np.linalg.norm(p, axis=1) - 2.0),
        (quintrig.torus(3.0, 1.0), lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 3.0, p[:, 2]) - 1.0),
        (quintrig.cylinder(2.0, 50.0), lambda p: np.hypot(p[:, 0], p[:, 1]) - 2.0),
    ],
)
def test_signed_distances_from_closed_forms(surface, exact):
    p = np.random.default_rng(1).uniform(-4, 4, (3000, 3)) + np.array([0, 0, 25 * (surface.size > 50)])
    found = quintrig.deviation(surface, p)
    assert np.abs(found.distance - exact(p)).max() < 1e-9
    assert not found.edge.any()  # a seam is no edge
    assert np.abs(quintrig.deviation(surface, np.zeros((1, 3))).distance).min() > 0.99  # all as near as each other


def test_what_lies_beyond_the_border_is_told_apart_and_patches_are_taken_together():
    plane = quintrig.tensor(FLAT)
    other = quintrig.tensor(np.array(FLAT) + np.array([100.0, 0, 0]))
    p = np.array([[50.0, 50, 3], [50, 50, -4], [103, 50, 4], [150, 20, -1], [0, 0, 2]])
    one = quintrig.deviation(plane, p, tolerance=3.5)
    assert one.distance == pytest.approx([3, -4, 5, -np.hypot(50, 1), 2])
    assert one.edge.tolist() == [False, False, True, True, False]  # a corner's normal reaches the last
    both = quintrig.deviation([plane, other], p, tolerance=3.5)
    assert both.distance == pytest.approx([3, -4, 4, -1, 2])
    assert both.patch.tolist()[2:4] == [1, 1]
    assert both.within == pytest.approx(0.6)
    told = both.to_dict()
    assert (told["min"], told["max"], told["mean"]) == pytest.approx((-4, 4, 0.8))
    assert told["rms"] == pytest.approx(np.sqrt(np.mean([9, 16, 16, 1, 4])))
    assert told["percentiles"]["50"] == pytest.approx(2)


def test_a_moved_scan_is_moved_back():
    surface = quintrig.tensor(np.array(FLAT) + np.random.default_rng(2).normal(size=(6, 6, 3)) * 8)
    p = surface(*np.random.default_rng(3).random((2, 4000)))
    turn = rotation(np.array([0.4, -0.3, 0.8]))
    found = quintrig.deviation(surface, p @ turn.T + [30.0, -80, 10], align=True)
    assert np.abs(found.distance).max() < 1e-7
    assert found.motion.matrix[:3, :3] == pytest.approx(turn.T, abs=1e-9)
    outliers = np.random.default_rng(4).uniform(-100, 200, (60, 3))
    found = quintrig.deviation(surface, np.concatenate([p @ turn.T + [30.0, -80, 10], outliers]), align=True)
    assert np.abs(found.distance[:4000]).max() < 1e-7  # as if they were not there
    assert 0.01 < found.motion.left_out <= 60 / 4060
    for few in (np.ones((1, 3)), np.outer(np.arange(9.0), [1, 2, 3]), np.ones((9, 3))):
        with pytest.raises(ValueError, match="align: expected at least three points that are not on one line"):
            quintrig.deviation(surface, few, align=True)


def test_trimmed_faces_count_only_inside_their_loops():
    hole = 0.5 + 0.25 * np.array([[np.cos(a), np.sin(a)] for a in np.linspace(0, 2 * np.pi, 200)[:-1]])
    square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    from quintrig.geometry.nurbs import nurbs

    knots = [[0, 0, 1, 1]] * 2
    face = nurbs([[[0, 0, 0], [0, 8, 0]], [[8, 0, 0], [8, 8, 0]]], None, [1, 1], knots, trim=[square, hole])
    found = quintrig.deviation(face, [[4.0, 4, 0], [4, 4, 1], [1, 1, 2], [5.5, 4, 0]])
    assert np.abs(found.distance) == pytest.approx([2, np.sqrt(5), 2, 0.5], abs=2e-3)  # the loop is a polygon
    assert found.edge.tolist() == [True, True, False, True]


def test_from_the_model_to_triangles_and_to_surfaces():
    surface = crumpled()
    mesh = np.array([[-20.0, -20, 7], [40, -20, 7], [40, 40, 7], [-20, 40, 7]])
    above = quintrig.deviation(
        quintrig.tensor(np.array(FLAT) / 20), quintrig.Scan(mesh, triangles=np.array([[0, 1, 2], [0, 2, 3]])),
        source="model",
    )  # fmt: skip
    assert above.distance == pytest.approx(np.full(65 * 65, 7.0))
    assert np.abs(quintrig.deviation(surface, surface, source="model").distance).max() < 1e-9
    with pytest.raises(ValueError, match="triangles"):
        quintrig.deviation(surface, mesh, source="model")


def _spiral(count):
    """Points spread evenly over the unit sphere."""
    z = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + 5**0.5) * np.arange(count)
    return np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], axis=1)


def test_on_the_command_line(tmp_path):
    run = cli_runner.quintrig
    model = quintrig.Model.from_dict({"kind": "tensor", "unit": "mm", "points": FLAT})
    quintrig.save(model, tmp_path / "m.toml")
    scan = tmp_path / "scan.xyz"
    scan.write_text("# unit cm\n5 5 0.1\n5 5 -0.3\n5 nan 0\n")
    files = [tmp_path / name for name in ("d.csv", "d.ply", "d.png")]
    asked = [part for file in files for part in ("-o", file)]
    done = run("deviation", tmp_path / "m.toml", scan, "--tolerance", "2", "--json", *asked)
    assert done.code == 0, done.err
    told = json.loads(done.out)
    assert (told["points"], told["unit"], told["within"]) == (2, "mm", 0.5)
    assert (told["min"], told["max"]) == pytest.approx((-3, 1))
    assert "1 of 3 points" in done.err
    assert "multiplied by 10" in done.err
    rows = np.loadtxt(files[0], delimiter=",", skiprows=2)
    assert rows[:, 3] == pytest.approx([1, -3])
    assert quintrig.read_scan(files[1]).points == pytest.approx(np.array([[50, 50, 1], [50, 50, -3]]))
    assert files[2].stat().st_size > 10_000
    ball = quintrig.Model.from_dict({"kind": "sphere", "radius": 20, "unit": "mm"})
    quintrig.save(ball, tmp_path / "ball.toml")
    np.savetxt(tmp_path / "ball.xyz", 21 * _spiral(4000))
    beside = ["-o", tmp_path / "k.csv", "-o", tmp_path / "k.ply"]
    done = run("deviation", tmp_path / "ball.toml", tmp_path / "ball.xyz", "--curvature", "--json", *beside)
    gaps = json.loads(done.out)["curvature"]
    assert gaps["mean"]["mean"] == pytest.approx(1 / 20 - 1 / 21, rel=0.02)  # normals outwards: -1/21 + 1/20
    assert gaps["gaussian"]["mean"] == pytest.approx(1 / 21**2 - 1 / 20**2, rel=0.02)
    columns = np.genfromtxt(tmp_path / "k.csv", delimiter=",", skip_header=1, names=True)
    assert np.nanmedian(columns["mean"]) == pytest.approx(-1 / 21, rel=1e-3)
    assert np.nanmax(np.abs(columns["mean_model"] + 1 / 20)) < 1e-12
    assert b"property double gaussian_error" in (tmp_path / "k.ply").read_bytes()
    far = run("deviation", tmp_path / "m.toml", scan, "--unit", "km")
    assert "check the units" in far.err
    for arguments, words in (
        ([scan, "--unit", "inch"], "unit: expected one of"),
        ([tmp_path / "none.xyz"], "no such file"),
        ([scan, "--tolerance", "0"], "tolerance: expected a length"),
        ([scan, "-o", tmp_path / "d.doc"], "expected a name ending in"),
        ([scan, "--from", "model"], "triangles"),
    ):
        done = run("deviation", tmp_path / "m.toml", *arguments)
        assert (done.code, done.out) == (2, "")
        assert words in done.err
        assert done.err.strip().count("\n") == 0
