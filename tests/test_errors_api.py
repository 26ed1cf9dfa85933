"""Misuse of the library: a ValueError of one line that names the place, what was expected and what was found."""

import re

import numpy as np
import pytest

import quintrig
from catalogue import CALM, LEVEL, PROFILE, SURFACES, arch, wave
from quintrig import Curve
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.trigonometric import Trigonometric

NET = wave().tolist()
INF, NAN = float("inf"), float("nan")


def refused(call, *parts):
    """Check that ``call`` raises a ValueError of one line with these parts in it."""
    with pytest.raises(ValueError) as caught:
        call()
    message = str(caught.value)
    assert "\n" not in message
    assert len(message) < 900
    for part in parts:
        assert part in message, message


def with_point(value):
    net = [[list(point) for point in row] for row in NET]
    net[1][2][0] = value
    return net


# ---------------------------------------------------------------------------------------------- parameters

OUTSIDE = [-1e-300, -1.0, 1.0000000000000002, 1.5, 1e300, INF, -INF, NAN]
USERS = {
    "analyse u": lambda t: quintrig.analyse(SURFACES["torus"].surface(), t, 0.5),
    "analyse v": lambda t: quintrig.analyse(SURFACES["torus"].surface(), 0.5, t),
    "analyse grid": lambda t: quintrig.analyse(SURFACES["torus"].surface(), [[0.5], [t]], [[0.5, 0.6]]),
    "surface": lambda t: SURFACES["developable oblique"].surface()(t, 0.5),
    "partials": lambda t: SURFACES["nurbs"].surface().partials(0.5, t),
    "curve": Curve(arch()),
    "curvature": lambda t: Curve(arch()).curvature([0.5, t]),
    "torsion": lambda t: Curve(arch()).torsion(t),
    "length": lambda t: Curve(arch()).length(0.0, t),
    "basis": lambda t: Trigonometric().derivatives(t, 1),
    "slopes": lambda t: Trigonometric().slopes(t, 1),
    "bernstein": lambda t: Bernstein(3).derivatives(t, 1),
}


@pytest.mark.parametrize("t", OUTSIDE)
@pytest.mark.parametrize("user", USERS)
def test_parameters_outside_the_domain_are_refused(user, t):
    with pytest.raises(ValueError) as caught:
        USERS[user](t)
    found = re.match(r"[uvt](\[\d\])* = (\S+) is outside the domain \[0, 1\]", str(caught.value))
    np.testing.assert_array_equal(float(found[2]), t)  # to the last digit


def test_the_message_tells_which_and_how_many():
    t = np.full((3, 4), 0.5)
    t[1, 2] = t[2, 0] = 1.25
    refused(lambda: quintrig.analyse(SURFACES["torus"].surface(), t, 0.5), "u[1][2] = 1.25", "(2 such)")
    refused(lambda: quintrig.analyse(SURFACES["torus"].surface(), 0.5, t), "v[1][2] = 1.25")


@pytest.mark.parametrize(
    "t", ["0.5", ["0.5"], True, [True, False], [True, 0.5], None, [None], 0.5j, [[0.1], [0.2, 0.3]], {}]
)
@pytest.mark.parametrize("user", USERS)
def test_parameters_that_are_no_numbers_are_refused(user, t):
    if user == "analyse grid" and not isinstance(t, (bool, str, complex, type(None))):
        return
    refused(lambda: USERS[user](t), "expected")


def test_ends_of_the_domain_are_inside():
    for user in USERS.values():
        user(0.0)
        user(1.0)
        user(-0.0)
        user(5e-324)


def test_shapes_that_do_not_broadcast():
    refused(
        lambda: quintrig.analyse(SURFACES["torus"].surface(), np.zeros(3), np.zeros(4)), "(3,)", "(4,)", "broadcast"
    )


# ---------------------------------------------------------------------------------------------- control points

VALUES = {
    "nan": (NAN, "points[1][2][0]", "finite number", "nan"),
    "infinity": (-INF, "points[1][2][0]", "-inf"),
    "too large": (1e60, "points[1][2][0]", "at most 1e+50", "1e+60"),
    "too large an integer": (10**400, "points[1][2][0]", "at most 1e+50"),
    "text": ("1.0", "points", "expected real numbers", "text"),
    "none": (None, "points", "expected real numbers", "None"),
    "true": (True, "points", "expected real numbers", "True"),
    "complex": (1j, "points", "expected real numbers", "complex"),
    "list": ([1.0], "points", "rows of equal length"),
}


@pytest.mark.parametrize("name", VALUES)
def test_points_that_are_no_finite_numbers(name):
    value, *parts = VALUES[name]
    refused(lambda: quintrig.tensor(with_point(value)), *parts)


def test_large_integers_are_numbers():
    np.testing.assert_array_equal(quintrig.tensor(with_point(10**30)).net[1, 2], [1e30, *NET[1][2][1:]])


COUNTS = {
    "five rows": (lambda: quintrig.tensor(NET[:5]), "points: expected 6 control points", "found 5"),
    "five columns": (lambda: quintrig.tensor([row[:5] for row in NET]), "points[0]: expected 6", "found 5"),
    "two coordinates": (lambda: quintrig.tensor(np.zeros((6, 6, 2))), "n x n x 3", "6 x 6 x 2"),
    "no list of lists": (lambda: quintrig.tensor([1.0, 2.0]), "n x n x 3", "found 2"),
    "nothing": (lambda: quintrig.tensor([]), "n x n x 3", "found 0"),
    "ragged": (lambda: quintrig.tensor([*NET[:5], NET[5][:4]]), "points: expected rows of equal length"),
    "ragged point": (lambda: quintrig.tensor([*NET[:5], [*NET[5][:5], [0, 0]]]), "points: expected rows of equal"),
    "one classical row": (lambda: quintrig.tensor(NET[:1], basis="bernstein"), "expected 2 or more", "found 1"),
    "symmetric": (lambda: quintrig.symmetric(NET, [1, 0, 0, 0]), "expected 3 rows, half of the net", "found 6"),
    "mirror": (lambda: quintrig.symmetric(NET[:3], [1, 0, 0]), "mirror: expected 4 numbers, found 3 numbers"),
    "no mirror": (lambda: quintrig.symmetric(NET[:3], [0, 0, 0, 1]), "mirror", "not all zero"),
    "section": (lambda: quintrig.swept(arch(5), arch()), "section: expected 6", "found 5"),
    "trajectory": (lambda: quintrig.swept(arch(), arch(7)), "trajectory: expected 6", "found 7"),
    "profile": (lambda: quintrig.swung(arch(), arch()[:, :2]), "profile: expected n x 2", "6 x 3"),
    "scale": (lambda: quintrig.swung(PROFILE, PROFILE, scale=INF), "scale: expected a finite number", "inf"),
    "scale text": (lambda: quintrig.swung(PROFILE, PROFILE, scale="2"), "scale: expected real numbers", "text"),
    "first": (lambda: quintrig.ruled(arch()[:, :2], arch()), "first: expected n x 3", "6 x 2"),
    "second": (lambda: quintrig.ruled(arch(), arch(4)), "second: expected 6", "found 4"),
    "planes": (lambda: quintrig.developable(CALM[:5], LEVEL), "planes: expected 6 control planes", "found 5"),
    "bounds": (lambda: quintrig.developable(CALM, LEVEL[:1]), "bounds: expected 2 x 4", "1 x 4"),
    "no plane": (lambda: quintrig.developable([[0, 0, 0, 1], *CALM[1:]], LEVEL), "planes[0]", "a = b = c = 0"),
    "no bound": (lambda: quintrig.developable(CALM, [LEVEL[0], [0, 0, 0, 1]]), "bounds[1]", "a = b = c = 0"),
    "curve": (lambda: Curve(arch(5)), "expected 6 control points", "found 5"),
    "curve in 4-D": (lambda: Curve(np.zeros((6, 4))), "points: expected n x 2 numbers or n x 3 numbers", "6 x 4"),
    "curve of one point": (lambda: Curve([[0, 0]], basis="bernstein"), "expected 2 or more control points", "found 1"),
}


@pytest.mark.parametrize("name", COUNTS)
def test_wrong_counts(name):
    call, *parts = COUNTS[name]
    refused(call, *parts)


# ---------------------------------------------------------------------------------------------- shape parameters

BUILDERS = {
    "tensor": lambda shape, **more: quintrig.tensor(NET, shape, **more),
    "symmetric": lambda shape, **more: quintrig.symmetric(NET[:3], [1, 0, 0, 0], shape, **more),
    "swept": lambda shape, **more: quintrig.swept(arch(), arch(), shape, **more),
    "swung": lambda shape, **more: quintrig.swung(PROFILE, PROFILE, shape, **more),
    "ruled": lambda shape, **more: quintrig.ruled(arch(), arch(seed=9), shape, **more),
    "developable": lambda shape, **more: quintrig.developable(CALM, LEVEL, shape[2:], **more),
}


@pytest.mark.parametrize("value", [1.0000000000000002, 1.5, -4.000000000000001, -5.0, 1e50])
@pytest.mark.parametrize("kind", BUILDERS)
def test_shape_outside_the_range_is_refused_and_allowed_on_request(kind, value):
    shape = [0.0, 0.0, 0.0, value]
    refused(lambda: BUILDERS[kind](shape), "shape[", "zeta", "outside [-4, 1]", "unchecked_shape = true", "convex-hull")
    if abs(value) < 10:
        surface = BUILDERS[kind](shape, unchecked_shape=True)
        assert np.isfinite(surface(0.3, 0.7)).all()


@pytest.mark.parametrize("kind", BUILDERS)
def test_ends_of_the_range_are_allowed(kind):
    BUILDERS[kind]([-4, 1, -4, 1])
    BUILDERS[kind](np.array([1.0, -4.0, 1.0, -4.0]))


NO_SHAPES = [(1, 1, 1), (1,) * 5, 1.0, "1111", [[1, 1], [1, 1]], {}]


@pytest.mark.parametrize("shape", [*NO_SHAPES, *([1, 1, 1, value] for value in (NAN, True, "1", None))])
def test_shape_that_is_not_four_numbers(shape):
    refused(lambda: quintrig.tensor(NET, shape), "shape")
    refused(lambda: quintrig.tensor(NET, shape, unchecked_shape=True), "shape")
    refused(lambda: quintrig.developable(CALM, LEVEL, shape), "shape")


@pytest.mark.parametrize("name", ["alpha", "zeta"])
@pytest.mark.parametrize("value", [1.1, -4.1, NAN, INF, "1", True, None, [1.0]])
def test_shape_parameters_of_curves_and_bases(name, value):
    refused(lambda: Curve(arch(), **{name: value}), name)
    refused(lambda: Trigonometric(**{name: value}), name)


def test_unchecked_curve():
    assert Curve(arch(), 3.0, unchecked_shape=True)(0.5).shape == (3,)


@pytest.mark.parametrize("basis", ["trigonometri", "", "Bernstein", None, 5])
def test_unknown_basis(basis):
    refused(lambda: quintrig.tensor(NET, basis=basis), "basis: expected", "trigonometric", "bernstein", repr(basis))
    refused(lambda: Curve(arch(), basis=basis), "basis: expected")


# ---------------------------------------------------------------------------------------------- everything else

OTHER = {
    "unknown quantity": (lambda s: quintrig.analyse(s, 0.5, 0.5, "gausian"), "'gausian'; did you mean 'gaussian'?"),
    "one of several": (lambda s: quintrig.analyse(s, 0.5, 0.5, ["mean", "gausian"]), "did you mean 'gaussian'?"),
    "no surface": (lambda _: quintrig.analyse("x", 0.1, 0.2), "surface: expected a Surface, such as load(path)", "str"),
    "no path": (lambda _: quintrig.load(5), "load: expected the path of a model file, got 5"),
    "tiny radius": (lambda _: quintrig.sphere(1e-300), "radius: expected a number of size at least 1e-50"),
    "no threads": (lambda s: quintrig.analyse(s, 0.5, 0.5, threads=0), "threads: expected", "found 0"),
    "half a thread": (lambda s: quintrig.analyse(s, 0.5, 0.5, threads=1.5), "threads: expected", "1.5"),
    "grid of one": (lambda _: quintrig.grid(1, 5), "nu: expected 2 or more in whole numbers", "found 1"),
    "grid of true": (lambda _: quintrig.grid(5, True), "nv: expected 2 or more in whole numbers", "True"),
    "grid of halves": (lambda _: quintrig.grid(5, 2.5), "nv: expected 2 or more in whole numbers", "2.5"),
    "negative order": (lambda s: s.partials(0.5, 0.5, -1), "order: expected 0 or more", "-1"),
    "half an order": (lambda s: s.partials(0.5, 0.5, 0.5), "order: expected", "0.5"),
    "order of a curve": (lambda _: Curve(arch()).derivatives(0.5, -2), "order: expected", "-2"),
    "degree": (lambda _: Bernstein(-1), "degree: expected 0 or more", "-1"),
    "half a degree": (lambda _: Bernstein(2.5), "degree: expected", "2.5"),
    "tolerance": (lambda _: Curve(arch()).length(tolerance=0.0), "tolerance: expected a number greater than 0"),
    "comb": (lambda _: Curve(arch()).comb(0.5, "long"), "scale: expected real numbers", "text"),
    "comb of nan": (lambda _: Curve(arch()).comb(0.5, NAN), "scale: expected a finite number"),
    "signed in space": (lambda _: Curve(arch()).signed_curvature(0.5), "plane curve"),
}


@pytest.mark.parametrize("name", OTHER)
def test_other_misuse(name):
    call, *parts = OTHER[name]
    refused(lambda: call(SURFACES["torus"].surface()), *parts)


REFERENCES = {
    "sphere": ("radius",),
    "ellipsoid": ("a", "b", "c"),
    "cylinder": ("radius", "height"),
    "cone": ("radius", "height"),
    "torus": ("major", "minor"),
    "catenoid": ("waist", "height"),
    "helicoid": ("radius",),
    "hyperbolic_paraboloid": ("size",),
    "monkey_saddle": ("size",),
    "enneper": ("size",),
}


@pytest.mark.parametrize("value", [0.0, -1.0, NAN, INF, "1", True, None, [1.0], 1e51])
@pytest.mark.parametrize("kind", REFERENCES)
def test_lengths_of_reference_surfaces_are_positive_numbers(kind, value):
    for name in REFERENCES[kind]:
        refused(lambda name=name: getattr(quintrig, kind)(**{name: value}), f"{name}: expected")
    if kind == "helicoid" and value not in (0.0, -1.0):
        refused(lambda: quintrig.helicoid(pitch=value), "pitch: expected")


def test_messages_name_no_internals():
    for call in (
        lambda: quintrig.tensor(with_point("x")),
        lambda: quintrig.analyse(SURFACES["torus"].surface(), "x", 0),
    ):
        with pytest.raises(ValueError) as caught:
            call()
        assert not re.search(r"dtype|ufunc|<U|object|inhomogeneous|Traceback", str(caught.value))
