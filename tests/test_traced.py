"""What lines are traced with: surfaces by polynomials over cells, the integrator, and points that keep others away."""

import numpy as np
import pytest
from scipy.integrate import DOP853

import quintrig
from quintrig.geometry.nurbs import nurbs
from quintrig.interrogation.dop853 import coefficients
from quintrig.interrogation.flows import GEODESICS, PRINCIPAL_DIRECTIONS
from quintrig.interrogation.line_jit import AIM, ENDED, NO_DIRECTION, POINT, TOWARDS
from quintrig.interrogation.near import Near, clear_of_itself, thinned
from quintrig.interrogation.trace import Seed, Tracer

RNG = np.random.default_rng(1448)
GRID = np.stack([*np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij"), np.zeros((6, 6))], axis=-1)
NET = GRID + 0.5 * RNG.normal(size=(6, 6, 3))
CURVE = np.array([[0, 0, 0], [1, 0, 1], [2, 0, 2], [3, 1, 2], [4, 1, 1], [5, 0, 0.0]])

W = RNG.uniform(0.5, 2.0, (6, 6))

SURFACES = {
    "tensor": quintrig.tensor(NET, (0.3, -2.0, 1.0, -3.5)),
    "at -4": quintrig.tensor(NET, (-4, 0, 0.2, -4)),
    "nearly -4": quintrig.tensor(NET, (-3.9999, 0, 0.2, -4)),
    "swept": quintrig.swept(CURVE, CURVE[:, [1, 0, 2]]),
    "ruled": quintrig.ruled(CURVE, CURVE[::-1] * [1, -1, 2] + [0, 5, 1]),
    "Bézier": quintrig.tensor(NET, basis="bernstein"),
    "B-spline": nurbs(
        NET + 2 * GRID, W, (3, 4), ([0, 0, 0, 0, 0.2, 0.6, 1, 1, 1, 1], [0, 0, 0, 0, 0, 0.5, 1, 1, 1, 1, 1])
    ),
    "rational": quintrig.sphere(2),
    "ellipsoid": quintrig.ellipsoid(3, 2, 1),
    "far away": quintrig.tensor(NET + 1e7, (0.3, -2.0, 1.0, -3.5)),
    "small": quintrig.tensor(1e-5 * NET, (0.3, -2.0, 1.0, -3.5)),
}


@pytest.mark.parametrize("name", SURFACES)
def test_the_compiled_surface_is_the_surface(name):
    surface = SURFACES[name]
    uv = np.concatenate(
        [RNG.uniform(0.0, 1.0, (40, 2)), RNG.uniform(0.0, 1e-3, (5, 2)), 1 - RNG.uniform(0, 1e-3, (5, 2))]
    )
    sample = quintrig.analyse(surface, *uv.T)
    for mode, key in ((1, "direction1"), (2, "direction2")):
        lines = Tracer([surface], PRINCIPAL_DIRECTIONS, 1.0).begun([Seed(0, one, mode=mode) for one in uv])
        told = lines[:, ENDED] != NO_DIRECTION
        assert told.any() == (name != "rational")  # a sphere has no direction
        reach = np.abs(sample.point).max()
        assert np.abs(lines[:, POINT : POINT + 3] - sample.point).max() <= 1e-14 * reach + 1e-13 * surface.size
        spread = sample["k1"] - sample["k2"]
        cosine = np.abs(np.sum(lines[:, TOWARDS : TOWARDS + 3] * sample[key], axis=1))
        clear = told & (spread * surface.size > 1e-3)
        assert np.abs(cosine[clear] - 1.0).max(initial=0.0) < 1e-9


def test_a_seed_is_turned_onto_the_tangent_plane():
    surface = SURFACES["ellipsoid"]
    towards = np.array([0.3, -0.5, 0.8])
    line = Tracer([surface], GEODESICS, 1.0).begun([Seed(0, np.array([0.3, 0.2]), towards)])[0]
    normal = quintrig.analyse(surface, 0.3, 0.2, ("normal",)).normal
    wanted = towards - (towards @ normal) * normal
    np.testing.assert_allclose(line[TOWARDS : TOWARDS + 3], wanted / np.linalg.norm(wanted), atol=1e-13)
    p = surface.partials(0.3, 0.2, 1)
    np.testing.assert_allclose(line[AIM] * p[1, 0] + line[AIM + 1] * p[0, 1], line[TOWARDS : TOWARDS + 3], atol=1e-13)


def test_the_integrator_is_that_of_hairer():
    table = coefficients()
    np.testing.assert_array_equal(table[:12, :12], DOP853.A)
    np.testing.assert_array_equal(table[12, :12], DOP853.B)
    np.testing.assert_array_equal(table[13:16], DOP853.A_EXTRA)
    np.testing.assert_array_equal(table[16, :13], DOP853.E5)
    np.testing.assert_array_equal(table[17, :13], DOP853.E3)
    np.testing.assert_array_equal(table[18:], DOP853.D)


@pytest.mark.parametrize("scale", [1e-8, 1.0, 1e9])
def test_points_keep_others_away_as_all_distances_say(scale):
    points, asked = scale * RNG.uniform(-3, 3, (400, 3)), scale * RNG.uniform(-3, 3, (300, 3))
    near = Near(0.5 * scale)
    for part in np.array_split(points, 7):
        near.add(part)
    apart = np.linalg.norm(asked[:, None] - points[None], axis=2).min(axis=1)
    for reach in (0.5 * scale, 0.2 * scale):
        np.testing.assert_array_equal(near.free(asked, reach), apart >= reach)
    assert not near.free(np.array([[np.nan, 0, 0]]), scale * 0.1)[0]
    kept = []
    for point in points:
        if all(np.linalg.norm(point - other) >= scale for other in kept):
            kept.append(point)
    np.testing.assert_array_equal(points[thinned(points, scale)], kept)


def test_a_hairpin_is_cut_where_it_comes_back_beside_itself():
    t = np.linspace(0.0, 5.0, 101)
    there, back = np.stack([t, 0 * t, 0 * t], axis=1), np.stack([5.0 - t, 0.3 + 0 * t, 0 * t], axis=1)
    clear = clear_of_itself(np.concatenate([there, back]), 0.5, 1.5)
    assert clear[:101].all()
    assert not clear[101 + 20 :].any()  # near the turn it is near itself, as every turn is
    assert clear_of_itself(np.concatenate([there, back + np.array([0, 0.3, 0])]), 0.5, 1.5).all()


def test_a_geodesic_of_given_length_ends_on_the_edge_or_before_it():
    plane = quintrig.tensor(GRID, basis="bernstein")  # x = 5 u, y = 5 v
    for angle, length in (
        (0.0, 2.0),
        (0.0, 2.5),
        (30.0, 2.5 / np.cos(np.pi / 6)),
        (45.0, 10.0),
        (44.9, 10.0),
        (80.0, 1.0),
    ):
        line = quintrig.lines(plane, "geodesic", start=(0.5, 0.5), direction=angle, length=length)[0]
        way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        reach = min(length, 2.5 / way.max())
        assert line.length == pytest.approx(reach, rel=1e-9)
        np.testing.assert_allclose(line.points[-1, :2], 2.5 + reach * way, atol=1e-8)


def test_lines_along_an_edge_run_along_all_of_it():
    strip = quintrig.load("examples/developable.toml").patches[0].surface  # its edge u = 0 is a ruling
    for surface, kind in (
        (quintrig.enneper(1), "curvature"),
        (quintrig.helicoid(1, 2), "asymptotic"),
        (strip, "curvature"),
    ):
        found = quintrig.lines(surface, kind, start=(0.0, 0.3), tolerance=1e-5 * surface.size)
        along = [line for line in found if np.ptp(line.uv[:, 0]) < 1e-9]
        t = np.linspace(0.0, 1.0, 4001)
        wanted = np.linalg.norm(np.diff(surface(0.0 * t, t), axis=0), axis=1).sum()
        assert [line.length for line in along] == [pytest.approx(wanted, rel=1e-6)]
        assert (np.diff(along[0].uv[:, 1]) > 0).all() or (np.diff(along[0].uv[:, 1]) < 0).all()
