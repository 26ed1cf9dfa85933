"""Surfaces far from the coordinate origin: their curvature is that of their coordinates, however far these lie."""

import numpy as np
import pytest

import oracle
import quintrig
from catalogue import SURFACES, build
from quintrig.geometry.exact import exact_surface
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.origin import local_origin, moved_plane
from random_models import RANDOM, displaced, parameters, plain_net

WAY = np.array([1.0, -0.7, 0.4])
KINDS = [*RANDOM, "nurbs"]
NEAR_FOUR = [-4.0 + 1e-4, -3.99, -4.0 + 1e-5, -3.999]


def far(kind, distance, seed=13):
    """Three models at a distance, with shape parameters inside the range, near -4 and at it."""
    rng = np.random.default_rng([seed, *kind.encode()])
    for shape in ([0.5, -2.0, 1.0, 0.0], NEAR_FOUR, [-4.0, 0.5, 0.0, -4.0]):
        model = dict(SURFACES["nurbs"].model) if kind == "nurbs" else {"kind": kind, **RANDOM[kind](rng, 1.0)}
        if kind == "developable":  # near -4 its first ruling runs far away
            model["shape"] = shape[:2] if shape is not NEAR_FOUR else [-2.0, -3.0]
        elif kind != "nurbs":
            model["shape"] = shape
        yield displaced(model, distance * WAY)


@pytest.mark.parametrize("distance", [0.0, 1e1, 1e3, 1e6, 1e9, 1e12])
@pytest.mark.parametrize("kind", KINDS)
def test_curvature_loses_nothing_to_the_distance_from_the_origin(kind, distance):
    rng = np.random.default_rng(5)
    for model in far(kind, distance):
        u, v = parameters(rng, 5)
        surface = build(model)
        sample = quintrig.analyse(surface, u, v)
        allowed = 2e-12 if kind == "developable" else 2e-13  # whose boundaries are quotients
        partials = surface.partials(u, v, 1)
        for k in range(len(u)):
            exact = oracle.values(model, u[k], v[k])
            if exact is None:
                assert np.isnan(sample["mean"][k])
                continue
            lean = float(exact["E"] * exact["G"]) ** 0.5 / float(exact["area"])
            curved = max(float(exact["curvedness"]), 0.1 / surface.size) * lean**2
            assert abs(oracle.number(sample["mean"][k]) - exact["mean"]) <= allowed * curved
            assert abs(oracle.number(sample["gaussian"][k]) - exact["gaussian"]) <= allowed * curved**2
            for found, wanted in zip(sample.point[k], exact["point"], strict=True):
                assert abs(oracle.number(found) - wanted) <= 1e-14 * (distance + surface.size)
            for order in ((1, 0), (0, 1)):
                wanted = [float(x) for x in exact["partials"][order]]
                assert np.abs(partials[order][k] - wanted).max() <= 1e-12 * np.linalg.norm(wanted)


NET = np.round(64 * plain_net(np.random.default_rng(11), 8.0)) / 64
"""So short numbers that moving it far away is exact."""

SAME_BITS = {
    "tensor": lambda shift: quintrig.tensor(NET + shift, (1.0, -3.5, -4.0, 0.0)),
    "swept": lambda shift: quintrig.swept(NET[:, 0] + shift, NET[0], (1.0, -3.5, -4.0, 0.0)),
    "ruled": lambda shift: quintrig.ruled(NET[:, 0] + shift, NET[:, 5] + shift, (1.0, -3.5, -4.0, 0.0)),
    "swung": lambda shift: quintrig.swung(NET[:, 0, ::2] + [9.0, shift[2]], NET[0, :, :2], (1.0, -3.5, -2.0, 0.0)),
    "nurbs without weights": lambda shift: nurbs(NET + shift, None, (3, 2), KNOTS),
}
KNOTS = ([0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [0, 0, 0, 1, 2, 3, 4, 4, 4])


@pytest.mark.parametrize("name", SAME_BITS)
def test_curvature_does_not_see_where_the_origin_is(name):
    u, v = np.random.default_rng(12).random((2, 40))
    at_home, away = (
        quintrig.analyse(SAME_BITS[name](np.array(shift)), u, v)
        for shift in ([0.0, 0.0, 0.0], [2.0**30, -(2.0**28), 2.0**31])
    )
    for key in ("E", "F", "G", "L", "M", "N", "normal", "gaussian", "mean", "k1", "k2", "shape_index", "gamma1"):
        np.testing.assert_array_equal(away[key], at_home[key], err_msg=key)


def carried(surface, shift):
    """The exact rational form of a surface, moved."""
    form = exact_surface(surface)
    return nurbs(form.points + shift, form.weights, form.degrees, (form.u.knots, form.v.knots), flip=form.flip)


@pytest.mark.parametrize("distance", [0.0, 1e3, 1e5, 1e7])
@pytest.mark.parametrize("way", [(1.0, 1.0, 1.0), (1.0, -0.7, 0.4), (0.0, 0.0, 1.0)])
def test_poles_of_a_sphere_stay_poles_wherever_it_lies(distance, way):
    sphere = carried(quintrig.sphere(2.5), distance * np.array(way))
    v = np.linspace(0.0, 1.0, 65)[None, :]
    assert quintrig.analyse(sphere, [[0.0], [1.0]], v).singular.all()
    beside = quintrig.analyse(sphere, [[1e-3], [0.2], [0.9], [1.0 - 1e-3]], v)
    np.testing.assert_allclose(beside["gaussian"], 0.16, rtol=1e-9)
    np.testing.assert_allclose(np.abs(beside["mean"]), 0.4, rtol=1e-9)


@pytest.mark.parametrize("distance", [0.0, 1e3, 1e5, 1e7])
def test_the_apex_of_a_cone_is_its_one_singular_point(distance):
    cone = carried(quintrig.cone(1.0, 2.0), distance * WAY)
    sample = quintrig.analyse(cone, *quintrig.grid(9, 33))
    np.testing.assert_array_equal(sample.singular.sum(axis=1), [0] * 8 + [33])
    assert np.nanmax(np.abs(sample["gaussian"])) <= 1e-20


@pytest.mark.parametrize("distance", [1e4, 1e6, 1e8])
def test_the_exact_form_of_a_far_surface_is_as_far(distance):
    for name in ("nurbs", "swung (0.5, -1.5, -3.25, 0.9)", "developable oblique", "ruled (1.0, 1.0, 1.0, 1.0)"):
        surface = build(displaced(SURFACES[name].model, distance * WAY))
        form = exact_surface(surface)
        x, y = np.random.default_rng(3).random((2, 9))
        gap = form.surface()(x, y) - surface(*form.from_exact(x, y))
        assert np.abs(gap).max() <= 1e-14 * distance + 1e-12 * surface.size, name


def test_the_origin_is_a_round_number_near_the_points():
    points = plain_net(np.random.default_rng(2), 1.0)
    np.testing.assert_array_equal(local_origin(points), 0.0)
    away = points + 1e6 * WAY
    origin = local_origin(away)
    assert np.abs(away - origin).max() <= 16.0
    np.testing.assert_array_equal((away - origin) + origin, away)
    np.testing.assert_array_equal(local_origin(np.full((4, 3), 7.5)), 7.5)
    np.testing.assert_array_equal(local_origin(np.array([[np.inf, 0.0], [np.nan, 1.0]])), 0.0)


def test_a_plane_seen_from_an_origin_is_rounded_once():
    plane, origin = np.array([0.1, 0.2, 0.3, -6e5]), np.array([1e6, 1e6, 1e6])
    exact = sum(oracle.number(n) * oracle.number(o) for n, o in zip(plane, [*origin, 1.0], strict=True))
    np.testing.assert_array_equal(moved_plane(plane, origin), [0.1, 0.2, 0.3, float(exact)])
    assert moved_plane(plane, np.zeros(3)) is plane
