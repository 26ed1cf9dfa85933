"""The enveloping developable: its tangent planes, rulings, boundaries, and its edge of regression."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import oracle
import quintrig
from catalogue import ACROSS, CALM, CUSPED, LEVEL, PAIRS, SURFACES, TILTED
from quintrig.basis.trigonometric import Trigonometric

STRIPS = {
    f"{name} {pair}": (planes, bounds, pair)
    for name, planes, bounds in (("calm", CALM, TILTED), ("cusped", CUSPED, ACROSS))
    for pair in PAIRS
}
every_strip = pytest.mark.parametrize("name", STRIPS)
unit = st.floats(0.0, 1.0)
repeatable = settings(deadline=None, derandomize=True, max_examples=10)


def exact_plane(planes, shape, u, order):
    """Π and its derivatives to 40 digits, each (a, b, c, d)."""
    rows = oracle.vectors(planes)
    return [
        [oracle.mp.fsum(f * row[x] for f, row in zip(values, rows, strict=True)) for x in range(4)]
        for values in oracle.trigonometric(u, *shape, order)
    ]


def height(plane, point):
    """The distance of a point from a plane, as a float."""
    lifted = [*(oracle.number(x) for x in point), oracle.ONE]
    return float(oracle.dot(plane, lifted) / oracle.norm(plane[:3]))


@every_strip
@repeatable
@given(unit, unit)
def test_point_lies_in_the_plane_and_the_normal_is_the_planes(name, u, v):
    planes, bounds, shape = STRIPS[name]
    strip = quintrig.developable(planes, bounds, shape)
    plane = exact_plane(planes, shape, u, 0)[0]
    sample = quintrig.analyse(strip, u, v, ["point", "normal", "gaussian", "mean"])
    reach = np.abs(strip.rows.derivatives(u, 0)).max()
    assert abs(height(plane, sample.point)) <= 1e-14 * reach * 10
    if not sample.singular and strip.size > 1e-3 * reach:
        n = np.array([float(x) for x in plane[:3]])
        p = strip.partials(u, v, 1)
        sine = np.linalg.norm(np.cross(p[1, 0], p[0, 1])) / np.linalg.norm(p[1, 0]) / np.linalg.norm(p[0, 1])
        lean = np.linalg.norm(np.cross(sample.normal, n / np.linalg.norm(n)))
        assert lean <= 1e-14 / sine * 10


@every_strip
@repeatable
@given(unit)
def test_rulings_run_from_the_first_bound_to_the_second(name, u):
    planes, bounds, shape = STRIPS[name]
    strip = quintrig.developable(planes, bounds, shape)
    ends = strip(u, [0.0, 1.0])
    reach = np.abs(ends).max()
    for end, bound in zip(ends, bounds, strict=True):
        assert abs(height(oracle.vectors(bound), end)) <= 1e-14 * reach * 10
    v = np.linspace(0, 1, 5)
    np.testing.assert_allclose(strip(u, v), np.outer(1 - v, ends[0]) + np.outer(v, ends[1]), rtol=0, atol=1e-13 * reach)
    # A ruling lies in Π' too: to be seen where Π' does not vanish.
    slope = exact_plane(planes, shape, u, 1)[1]
    if oracle.norm(slope) > 1e-3:
        for end in ends:
            assert abs(height(slope, end)) <= 1e-12 * reach


@pytest.mark.parametrize("planes", [CALM, CUSPED])
def test_where_a_shape_parameter_is_minus_four_the_ruling_is_the_limit(planes):
    """FORMULAS: with ζ = -4 the last ruling is Π(1) ∩ (3 L3 + 2 L4 - 5 L5); likewise at the start."""
    strip = quintrig.developable(planes, TILTED, (-4.0, -4.0))
    rows = oracle.vectors(planes)
    for u, (a, b, c) in ((0.0, rows[2::-1]), (1.0, rows[3:])):
        other = [3 * x + 2 * y - 5 * z for x, y, z in zip(a, b, c, strict=True)]
        for point in strip(u, [0.0, 0.3, 1.0]):
            assert abs(height(c, point)) <= 1e-13 * strip.size
            assert abs(height(other, point)) <= 1e-12 * strip.size
    # It is where rulings nearby tend to.
    near = strip([1e-7, 1 - 1e-7], [[0.0], [1.0]])
    assert np.abs(near - strip([0.0, 1.0], [[0.0], [1.0]])).max() <= 1e-5 * strip.size


def test_two_equal_planes_at_an_end_do_not_stop_the_strip():
    still = quintrig.developable((CALM[0], *CALM[:5]), LEVEL, (0.5, -1.0))
    assert np.isfinite(still([[0.0], [1e-9], [1e-3]], [[0.0, 0.5, 1.0]])).all()
    at_rest = quintrig.analyse(still, [0.0, 1e-3], 0.5)
    np.testing.assert_array_equal(at_rest.singular, [True, False])


@every_strip
def test_homogeneous_form_is_the_same_strip(name):
    planes, bounds, shape = STRIPS[name]
    rows = quintrig.developable(planes, bounds, shape).rows
    form = rows.homogeneous
    assert form.functions.degree <= 18
    for u in np.linspace(0, 1, 21):
        point = rows.derivatives(u, 0)[0]
        lifted = form.derivatives(u, 0)[0]
        defect = lifted[:, :3] - lifted[:, 3:] * point
        assert np.abs(defect).max() <= 1e-10 * np.abs(lifted).max(), u


@pytest.mark.parametrize("factor", [1e-6, -3.0, 1e8])
def test_planes_may_be_multiplied_by_a_common_factor(factor):
    here = quintrig.developable(CALM, TILTED, (0.5, -2.0))
    there = quintrig.developable(factor * np.array(CALM), np.array(TILTED) * [[factor], [7.0]], (0.5, -2.0))
    u, v = np.random.default_rng(1).random((2, 20))
    np.testing.assert_allclose(there(u, v), here(u, v), rtol=0, atol=1e-13 * here.size)
    one, two = quintrig.analyse(here, u, v, "mean"), quintrig.analyse(there, u, v, "mean")
    np.testing.assert_allclose(two["mean"], one["mean"], rtol=1e-10)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_calm_strip_has_no_edge_of_regression_inside(pair):
    found = quintrig.regression(quintrig.developable(CALM, LEVEL, pair))
    assert found.intervals == ()
    assert not found.inside.any()


@pytest.mark.parametrize("pair", [pair for pair in PAIRS if -4.0 not in pair])
def test_edge_of_regression_is_where_three_planes_meet(pair):
    """The point on the ruling with n''·x + d'' = 0 (FORMULAS), in 40 digits."""
    strip = quintrig.developable(CUSPED, ACROSS, pair)
    found = quintrig.regression(strip)
    for u, v, inside in list(zip(found.u, found.v, found.inside, strict=True))[16:-16:16]:
        plane = exact_plane(CUSPED, pair, u, 2)
        normals = oracle.mp.matrix([row[:3] for row in plane])
        cusp = oracle.mp.lu_solve(normals, oracle.mp.matrix([-row[3] for row in plane]))
        first, second = (np.array(end) for end in strip(u, [0.0, 1.0]))
        along = float(
            oracle.dot([x - oracle.number(a) for x, a in zip(cusp, first, strict=True)], oracle.vectors(second - first))
        )
        share = along / ((second - first) @ (second - first))
        assert v == pytest.approx(share, rel=1e-8, abs=1e-8)
        assert inside == (0.0 <= share <= 1.0)


def test_intervals_end_where_the_edge_crosses_a_boundary():
    strip = quintrig.developable(CUSPED, ACROSS, (1.0, 1.0))
    found = quintrig.regression(strip, samples=257)
    assert found.intervals
    for interval in found.intervals:
        assert interval[0] < interval[1]
        for end in interval:
            if end not in (0.0, 1.0):
                speeds = np.linalg.norm(strip.partials(end, [0.0, 1.0], 1)[1, 0], axis=-1)
                assert speeds.min() <= 1e-7 * speeds.max() + 1e-6 * strip.size
    finer = quintrig.regression(strip, samples=2049)
    np.testing.assert_allclose(found.intervals, finer.intervals, rtol=0, atol=1e-9)


def test_a_point_on_the_edge_of_regression_is_singular():
    strip = quintrig.developable(CUSPED, ACROSS, (0.0, 0.0))
    found = quintrig.regression(strip)
    k = int(np.flatnonzero(found.inside)[len(found.u) // 16])
    u, v = float(found.u[k]), float(found.v[k])
    assert 0 < v < 1
    p = strip.partials(u, v, 1)
    area = np.linalg.norm(np.cross(p[1, 0], p[0, 1]))
    assert area <= 1e-12 * strip.size**2
    assert quintrig.analyse(strip, u, v).singular


def test_regression_of_a_ruled_cone_is_its_apex_and_of_a_cylinder_at_infinity():
    base = np.array([[2, 0, 0], [2, 1, 0], [1.5, 2, 0], [1, 2.5, 0], [0.5, 2.7, 0], [0, 3, 0.0]])
    apex = np.array([0.0, 0.0, 4.0])
    half = quintrig.ruled(base, 0.5 * (base + apex), (0.5, 0.5, 0.5, 0.5))
    np.testing.assert_allclose(quintrig.regression(half).v, 2.0, rtol=1e-10)
    assert quintrig.regression(half).intervals == ()
    whole = quintrig.ruled(base, 1.5 * apex - 0.5 * base, (0.5, 0.5, 0.5, 0.5))
    np.testing.assert_allclose(quintrig.regression(whole).v, 2 / 3, rtol=1e-10)
    assert quintrig.regression(whole).intervals == ((0.0, 1.0),)
    cylinder = quintrig.ruled(base, base + apex)
    assert np.abs(quintrig.regression(cylinder).v).min() > 1e12
    assert quintrig.regression(cylinder).intervals == ()


@pytest.mark.parametrize("name", ["ruled cone", "developable standing still"])
def test_a_ruling_that_stands_still_is_no_edge_of_regression(name):
    """At an end with shape parameter -4 all of the ruling is singular; the edge crosses none of these strips."""
    strip = SURFACES[name].surface()
    assert quintrig.analyse(strip, [[0.0], [1.0]], [[0.2, 0.8]]).singular.any()
    found = quintrig.regression(strip)
    assert found.intervals == ()
    assert not found.inside.any()
    assert np.isnan(found.v).sum() == 1
    assert found.still == ((1.0,) if "cone" in name else (0.0,))


def test_a_strip_that_turns_back_has_a_ruling_that_stands_still():
    """Its planes come back the way they went: at u = 1/2 all of the ruling is singular."""
    there = np.array(CALM[:3])
    strip = quintrig.developable([*there, *there[::-1]], LEVEL, (0.5, 0.5))
    found = quintrig.regression(strip, samples=512)  # no sample at 1/2
    assert found.still == pytest.approx([0.5], abs=1e-5)  # Π' vanishes too: the ruling is a quotient of small numbers
    assert found.intervals == ()
    assert quintrig.analyse(strip, 0.5, [0.0, 0.5, 1.0]).singular.all()
    assert quintrig.regression(strip, samples=513).still == (0.5,)


def test_regression_is_of_developables_only():
    with pytest.raises(ValueError, match="straight rulings"):
        quintrig.regression(quintrig.sphere())
    for name in ("ruled (0.0, 0.0, 0.0, 0.0)", "ruled (-4.0, -4.0, -4.0, -4.0)"):
        with pytest.raises(ValueError, match="the tangent plane turns along the ruling at u = "):
            quintrig.regression(SURFACES[name].surface())


@pytest.mark.parametrize("width", [1e-2, 1e-4, 1e-7])
def test_an_edge_that_crosses_between_two_samples_is_found(width):
    """Narrow bounds cut from the cusped family a strip that its edge of regression crosses within ``width`` of u."""
    whole = quintrig.regression(quintrig.developable(CUSPED, ACROSS, (0.0, 0.0)))
    k = int(np.flatnonzero(whole.inside & (whole.v > 0.3) & (whole.v < 0.7))[0])
    y = 10.0 * 0.5 * float(whole.v[k] + whole.v[k + 1])
    thin = quintrig.developable(CUSPED, [[0, 1, 0, -y], [0, 1, 0, -y - width]], (0.0, 0.0))
    found = quintrig.regression(thin)
    ((low, high),) = [ends for ends in found.intervals if whole.u[k] < ends[0] < whole.u[k + 1]]
    assert low < high < low + width
    for end in (low, high):
        p = thin.partials([end, whole.u[k]], [[0.0], [1.0]], 1)
        area = np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1)
        assert area[:, 0].min() <= 1e-5 * area[:, 1].min()


BAD = {
    "equal planes": (np.tile(CALM[0], (6, 1)), LEVEL),
    "parallel planes": ([[0, 0, 1, k] for k in range(6)], LEVEL),
    "a pencil through a line of the bound": ([[1, 0, k, 0] for k in range(6)], [[1, 0, 1, 0], [0, 1, 0, 1]]),
    "rulings parallel to a bound": ([[1, k, 0, k * k] for k in range(6)], [[1, 1, 0, 0], [0, 0, 1, 0]]),
}


@pytest.mark.parametrize("name", BAD)
def test_planes_without_a_strip_are_refused(name):
    with pytest.raises(ValueError, match="envelop no strip"):
        quintrig.developable(*BAD[name])


def test_a_cylindrical_strip():
    """Planes whose normals lie in one plane envelop a cylinder: κ1 κ2 = 0 and one direction is that of all rulings."""
    angle = np.linspace(-0.5, 0.8, 6)
    planes = np.stack([np.sin(angle), 0 * angle, np.cos(angle), -1 - 0.05 * np.arange(6)], axis=-1)
    strip = quintrig.developable(planes, ACROSS, (1.0, 0.5))
    sample = quintrig.analyse(strip, *quintrig.grid(9, 5))
    assert np.abs(sample["gaussian"]).max() <= 1e-14
    straight = np.where(
        (np.abs(sample["k1"]) < np.abs(sample["k2"]))[..., None], sample["direction1"], sample["direction2"]
    )
    np.testing.assert_allclose(np.abs(straight), np.broadcast_to([0, 1, 0], straight.shape), rtol=0, atol=1e-12)


def test_functions_are_those_of_the_shape():
    assert quintrig.developable(CALM, LEVEL, (0.5, -2.0)).rows.functions == Trigonometric(0.5, -2.0)
