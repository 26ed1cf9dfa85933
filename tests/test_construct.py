"""The constructions: each surface built in another way too, and what its construction promises."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import quintrig
from catalogue import AROUND, POLE, PROFILE, SHAPES, SURFACES, arch, rail, wave
from closeness import natural, off, sound
from quintrig import Curve
from quintrig.geometry.nurbs import nurbs

rng = np.random.default_rng(3)
U, V = np.array([*rng.random((12, 2)), (0, 0), (0, 1), (1, 0), (1, 1), (0, 0.3), (0.6, 1)]).T
BASES = ("trigonometric", "bernstein")
repeatable = settings(deadline=None, derandomize=True, max_examples=40)

every_shape = pytest.mark.parametrize("shape", SHAPES)
every_basis = pytest.mark.parametrize("basis", BASES)
KEYS = ("gaussian", "mean", "k1", "k2", "curvedness", "normal", "point", "shape_index")


def assert_same(first, second, rounding=1e-11):
    """Both surfaces have the same points everywhere, and the same curvatures where these are well determined."""
    np.testing.assert_allclose(first(U, V), second(U, V), rtol=0, atol=1e-14 * first.size)
    one, two = (quintrig.analyse(surface, U, V) for surface in (first, second))
    fair = sound(one)
    assert fair.sum() >= 6
    for key in KEYS:
        assert off(two[key][fair], one[key][fair], natural(one, key)[fair]) <= rounding, key


def curves(points_u, points_v, shape, basis):
    a1, z1, a2, z2 = shape
    return Curve(points_u, a1, z1, basis=basis), Curve(points_v, a2, z2, basis=basis)


# ---------------------------------------------------------------------------------------------- two ways


@every_basis
@every_shape
def test_tensor_product_is_a_curve_of_curves(shape, basis):
    net = wave()
    surface = quintrig.tensor(net, shape, basis=basis)
    for u, v in zip(U, V, strict=True):
        across = np.array([Curve(net[:, j], *shape[:2], basis=basis)(u) for j in range(6)])
        np.testing.assert_allclose(surface(u, v), Curve(across, *shape[2:], basis=basis)(v), rtol=0, atol=2e-14)


@every_basis
@every_shape
def test_swept_surface_is_the_sum_of_its_curves_and_the_tensor_product_of_sums(shape, basis):
    surface = quintrig.swept(arch(), rail(), shape, basis=basis)
    section, trajectory = curves(arch(), rail(), shape, basis)
    np.testing.assert_allclose(surface(U, V), section(U) + trajectory(V), rtol=0, atol=2e-14)
    assert_same(surface, quintrig.tensor(np.add(arch()[:, None], rail()[None, :]), shape, basis=basis))
    mixed = surface.partials(U, V, 1)[1, 1]
    assert np.abs(mixed).max() <= 1e-12


@every_basis
@every_shape
def test_swung_surface_is_the_product_of_its_curves(shape, basis):
    scale = 1.75
    surface = quintrig.swung(PROFILE, AROUND, shape, scale, basis=basis)
    profile, trajectory = curves(PROFILE, AROUND, shape, basis)
    (r, z), (x, y) = profile(U).T, trajectory(V).T
    np.testing.assert_allclose(surface(U, V), np.stack([scale * r * x, scale * r * y, z], -1), rtol=0, atol=1e-14)
    factors = np.array([[[scale * r * x, scale * r * y, z] for x, y in AROUND] for r, z in PROFILE])
    assert_same(surface, quintrig.tensor(factors, shape, basis=basis))


@every_basis
@every_shape
def test_ruled_surface_joins_its_curves_by_lines(shape, basis):
    surface = quintrig.ruled(arch(), rail(), shape, basis=basis)
    first, second = curves(arch(), rail(), shape, basis)
    line = (1 - V)[:, None] * first(U) + V[:, None] * second(U)
    np.testing.assert_allclose(surface(U, V), line, rtol=0, atol=2e-14)


def test_classical_ruled_surface_is_a_tensor_product_of_degree_one():
    second = np.add(arch(seed=5), (0, 4, 1))
    ruled = quintrig.ruled(arch(), second, basis="bernstein")
    assert_same(ruled, quintrig.tensor(np.stack([arch(), second], axis=1), basis="bernstein"))
    # Between curves of different degree, the lower one raised: cubic to quartic.
    cubic = arch(4)
    raised = np.array([cubic[0], *(k / 4 * cubic[k - 1] + (1 - k / 4) * cubic[k] for k in range(1, 4)), cubic[3]])
    other = np.add(rail(5), (0, 4, 0))
    assert_same(quintrig.ruled(cubic, other, basis="bernstein"), quintrig.ruled(raised, other, basis="bernstein"))


def test_bilinear_tensor_product_is_the_hyperbolic_paraboloid():
    corners = [[[x, y, x * y] for y in (-2, 2)] for x in (-2, 2)]
    assert_same(quintrig.tensor(corners, basis="bernstein"), quintrig.hyperbolic_paraboloid(2.0))


def test_classical_cubic_net_is_enneper():
    """The blossom of Enneper's polynomials over |p|, |q| <= 1 gives its control points."""
    t = np.linspace(-1, 1, 4)
    squares, cubes = np.array([1, -1 / 3, -1 / 3, 1]), np.array([-1, 1, -1, 1])
    p, q = np.meshgrid(t, t, indexing="ij")
    p2, q2 = np.meshgrid(squares, squares, indexing="ij")
    p3, q3 = np.meshgrid(cubes, cubes, indexing="ij")
    net = np.stack([p - p3 / 3 + p * q2, q - q3 / 3 + q * p2, p2 - q2], axis=-1)
    assert_same(quintrig.tensor(net, basis="bernstein"), quintrig.enneper(1.0))


def test_classical_tensor_product_is_a_nurbs_surface():
    net = wave(5, 4)
    assert_same(quintrig.tensor(net, basis="bernstein"), nurbs(net))
    assert_same(quintrig.tensor(net, basis="bernstein"), nurbs(net, np.full((5, 4), 3.0)))
    weights = 1.0 + 1e-15 * np.arange(20).reshape(5, 4)  # not all the same: the rational path
    assert_same(quintrig.tensor(net, basis="bernstein"), nurbs(net, weights), 1e-10)


@every_basis
def test_symmetric_surface_is_the_tensor_product_of_net_and_image(basis):
    half, plane = wave()[:3], np.array([2.0, 0.3, -0.2, -5.0])
    n = plane[:3] / np.linalg.norm(plane[:3])
    image = half - 2 * ((half @ plane[:3] + plane[3]) / np.linalg.norm(plane[:3]))[..., None] * n
    shape = (0.5, -2.0, 1.0, 0.0)
    net = np.concatenate([half, image[::-1]])
    assert_same(quintrig.symmetric(half, plane, shape, basis=basis), quintrig.tensor(net, shape, basis=basis))


@every_basis
@pytest.mark.parametrize("shape", [(0.5, 0.5, 1.0, -3.0), (-4.0, -4.0, 0.0, 0.0)])
def test_symmetric_surface_is_its_own_mirror_image(shape, basis):
    surface = quintrig.symmetric(wave()[:3], [1.0, 0.0, 0.0, -2.5], shape, basis=basis)
    mirrored = surface(1 - U, V) * [-1, 1, 1] + [5.0, 0, 0]
    np.testing.assert_allclose(surface(U, V), mirrored, rtol=0, atol=1e-14)
    here, there = quintrig.analyse(surface, U, V), quintrig.analyse(surface, 1 - U, V)
    fair = sound(here)
    # Running backwards and mirrored: two changes of side, so that even H keeps its sign.
    for key in ("gaussian", "mean", "k1", "k2", "shape_index"):
        assert off(there[key][fair], here[key][fair], natural(here, key)[fair]) <= 1e-11, key


# ---------------------------------------------------------------------------------------------- promises


@repeatable
@given(st.lists(st.floats(-4, 1), min_size=4, max_size=4), st.integers(0, 3), st.floats(0, 1), st.floats(0, 1))
def test_surface_is_affine_in_each_shape_parameter(shape, which, u, v):
    def at(value):
        changed = [*shape]
        changed[which] = value
        return quintrig.tensor(wave(), changed)(u, v)

    share = (shape[which] + 4.0) / 5.0
    np.testing.assert_allclose(at(shape[which]), (1 - share) * at(-4.0) + share * at(1.0), rtol=0, atol=1e-13)


@every_basis
@every_shape
def test_corners_are_control_points(shape, basis):
    net = wave()
    surface = quintrig.tensor(net, shape, basis=basis)
    np.testing.assert_array_equal(surface([[0], [1]], [[0, 1]]), net[::5, ::5])


@every_basis
@every_shape
def test_edges_are_the_curves_of_the_edge_points(shape, basis):
    net, t = wave(), np.linspace(0, 1, 9)
    surface = quintrig.tensor(net, shape, basis=basis)
    for edge, found in ((0, surface(0, t)), (5, surface(1, t))):
        np.testing.assert_allclose(found, Curve(net[edge], *shape[2:], basis=basis)(t), rtol=0, atol=1e-14)
    for edge, found in ((0, surface(t, 0)), (5, surface(t, 1))):
        np.testing.assert_allclose(found, Curve(net[:, edge], *shape[:2], basis=basis)(t), rtol=0, atol=1e-14)


@repeatable
@given(st.lists(st.floats(-4, 1), min_size=4, max_size=4), st.integers(0, 2**32 - 1), st.floats(0, 1), st.floats(0, 1))
def test_surface_stays_in_the_hull_of_its_net(shape, seed, u, v):
    random = np.random.default_rng(seed)
    net, direction = random.normal(size=(6, 6, 3)), random.normal(size=3)
    heights = net @ direction
    assert heights.min() - 1e-14 <= quintrig.tensor(net, shape)(u, v) @ direction <= heights.max() + 1e-14


def test_shape_parameters_change_nothing_of_a_classical_surface():
    plain, shaped = (quintrig.tensor(wave(), shape, basis="bernstein") for shape in (SHAPES[0], SHAPES[4]))
    np.testing.assert_array_equal(plain(U, V), shaped(U, V))


def test_swung_surface_is_singular_only_where_the_radius_vanishes():
    surface = quintrig.swung(POLE, AROUND, SHAPES[4])
    sample = quintrig.analyse(surface, *quintrig.grid(11, 7))
    assert sample.singular[-1].all()
    assert not sample.singular[:-1].any()


@pytest.mark.parametrize("name", ["tensor flipped", "symmetric classical", "swung classical", "developable flipped"])
def test_flip_turns_the_normal_and_nothing_else(name):
    model = SURFACES[name].model
    assert model["flip"]
    surface = SURFACES[name].surface()
    assert surface.sign == -1.0
    p = surface.partials(0.3, 0.6, 1)
    normal = quintrig.analyse(surface, 0.3, 0.6, "normal").normal
    assert normal @ np.cross(p[1, 0], p[0, 1]) < 0


@pytest.mark.parametrize("kind", ["tensor", "swept", "swung", "symmetric"])
def test_net_to_draw_is_the_net_of_the_surface(kind):
    surface = SURFACES[f"{kind} {SHAPES[4]}"].surface()
    np.testing.assert_array_equal(surface.net[::5, ::5], surface([[0], [1]], [[0, 1]]))
    assert surface.net.shape == (6, 6, 3)


def test_coincident_points_give_a_surface_that_is_singular_everywhere():
    surface = quintrig.tensor(np.full((6, 6, 3), 0.1), SHAPES[4])
    sample = quintrig.analyse(surface, *quintrig.grid(5, 5))
    assert sample.singular.all()
    assert (sample["hk_type"] == 0).all()
    np.testing.assert_allclose(sample.point, 0.1, rtol=0, atol=1e-15)


def test_points_on_a_line_give_a_surface_that_is_singular_everywhere():
    net = np.add.outer(np.arange(6.0), np.arange(6.0))[..., None] * [1.0, 2.0, -1.0]
    assert quintrig.analyse(quintrig.tensor(net), *quintrig.grid(5, 5)).singular.all()


@every_basis
def test_plane_net_gives_a_plane(basis):
    net = wave() @ np.array([[1, 0, 0.5], [0, 1, -2.0], [0, 0, 0]])
    sample = quintrig.analyse(quintrig.tensor(net, SHAPES[1], basis=basis), *quintrig.grid(5, 5))
    assert np.abs(sample["curvedness"]).max() <= 1e-12
    assert (sample["point_type"] == 4).all()
    assert (sample["hk_type"] == 5).all()
    assert (sample["shape_class"] == 10).all()
    for key in ("shape_index", "direction1", "direction2"):
        assert np.isnan(sample[key]).all()
