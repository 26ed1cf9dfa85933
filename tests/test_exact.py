"""Every surface of the catalogue and random models, at random points, on edges and at corners, against 40 digits."""

import numpy as np
import pytest

import oracle
import quintrig
from catalogue import SURFACES, build

TOLERANCE = 1e-11
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1}
INVARIANTS = {"beta0": 0, "beta1": 1, "beta2": 2, "gamma1": 1, "gamma2": 1, "gamma3": 1}
# With the slope, the invariants of the horizontal plane grow by these powers of 1/n_z, and their rounding by one more.
STEEP = {"beta0": 2, "beta1": 3, "beta2": 4, "gamma1": 5, "gamma2": 4, "gamma3": 3}
FORMS = ("E", "F", "G", "L", "M", "N")
FLATTEST = 1e-3
"""Curvedness times size below which errors are measured against this curvedness, not the point's own (1 if it is 0)."""

EDGES = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))


def parameters(rng, inside):
    """Return u, v: points inside, the four corners, and one point on each edge."""
    on_edges = [(0.0, rng.random()), (1.0, rng.random()), (rng.random(), 0.0), (rng.random(), 1.0)]
    return np.array([*rng.random((inside, 2)), *EDGES, *on_edges]).T


def check_model(model, u, v):
    """Compare everything that ``analyse`` gives with the exact values; return the number of regular points."""
    surface = build(model)
    sample = quintrig.analyse(surface, u, v)
    regular = 0
    for k, (p, q) in enumerate(zip(u, v, strict=True)):
        exact = oracle.values(model, float(p), float(q))
        found = {key: sample[key][k] for key in sample.values}
        place = f"u = {p!r}, v = {q!r}"
        if exact is None:
            check_singular(found, place)
        else:
            check_point(found, exact, sample.size, place)
            regular += 1
    return regular


def check_singular(found, place):
    for key in quintrig.quantity.SCALARS:
        if key not in ("E", "F", "G"):
            assert np.isnan(found[key]), f"{key} at singular {place}"
    assert np.isnan(found["normal"]).all(), place
    assert np.isfinite(found["point"]).all(), place
    for key in quintrig.quantity.CLASSES:
        assert found[key] == 0, f"{key} at singular {place}"


def check_point(found, exact, size, place):
    own = float(exact["curvedness"])
    curved = max(own, (FLATTEST if own * size > 1e-20 else 1.0) / size)

    def assert_near(key, scale):
        error = abs(oracle.number(found[key]) - exact[key])
        assert error <= TOLERANCE * scale, f"{key} at {place}: off by {float(error / scale):.2g} of its scale"

    for key, power in POWERS.items():
        assert_near(key, curved**power)
    if own * size > FLATTEST:
        assert_near("shape_index", 1.0)
    else:
        assert found["hk_type"] == 5 or own * size > 1e-8, f"{place} is flat"
    for key in ("point", "normal"):
        error = max(abs(oracle.number(a) - b) for a, b in zip(found[key], exact[key], strict=True))
        assert error <= 1e-12 * (size if key == "point" else 1.0), f"{key} at {place}: off by {float(error):.2g}"
    speeds = {"E": float(exact["E"]), "G": float(exact["G"])}
    speeds["F"] = (speeds["E"] * speeds["G"]) ** 0.5
    bends = dict(zip(("L", "N", "M"), speeds.values(), strict=True))
    for key in FORMS:
        assert_near(key, speeds[key] if key in speeds else curved * bends[key])
    rise = abs(float(exact["normal"][2]))
    for key, power in INVARIANTS.items():
        assert_near(key + "_surface", curved**power)
        if rise > 1e-6:
            assert_near(key, curved**power / rise ** (STEEP[key] + 1))
    check_directions(found, exact, own, size, place)


def check_directions(found, exact, curved, size, place):
    """The exact directions are eigenvectors of the shape operator: II(d, e) = κ I(d, e) for every tangent e."""
    gap = float(exact["k1"] - exact["k2"]) / 2
    if gap <= 1e-3 * curved or curved * size < FLATTEST:
        return
    p = {order: [float(x) for x in value] for order, value in exact["partials"].items()}
    tangents = np.array([p[1, 0], p[0, 1]]).T
    first = np.array([[exact["E"], exact["F"]], [exact["F"], exact["G"]]], dtype=float)
    second = np.array([[exact["L"], exact["M"]], [exact["M"], exact["N"]]], dtype=float)
    # Scaled, so that both tangents count alike whatever the speeds of u and v.
    scale = 1.0 / np.sqrt(np.diag(first))
    for key, value in (("direction1", exact["k1"]), ("direction2", exact["k2"])):
        d = found[key]
        assert abs(np.linalg.norm(d) - 1.0) <= 1e-12, f"{key} at {place}"
        inside = np.linalg.lstsq(tangents * scale, d, rcond=None)[0] * scale
        defect = scale * (second @ inside - float(value) * (first @ inside))
        lean = np.sqrt(np.prod(np.diag(first)) / np.linalg.det(first))
        assert np.abs(defect).max() <= 1e-10 * curved * lean, f"{key} at {place}"


@pytest.mark.parametrize("name", SURFACES)
def test_catalogue_meets_exact_values(name):
    rng = np.random.default_rng([7, *name.encode()])
    assert check_model(SURFACES[name].model, *parameters(rng, 4)) >= 3


# ---------------------------------------------------------------------------------------------- random models

SCALES = (1e-3, 1.0, 1e3)


def random_shape(rng, count):
    """Random shape parameters, half of them at an end of the range or at 0 or -3."""
    return [
        float(rng.choice([-4.0, 1.0, 0.0, -3.0]) if rng.random() < 0.5 else rng.uniform(-4, 1)) for _ in range(count)
    ]


def plain_net(rng, scale):
    x, y = np.meshgrid(np.linspace(-1, 1, 6), np.linspace(-1, 1, 6), indexing="ij")
    return scale * (np.stack([x, y, 0 * x], axis=-1) + 0.3 * rng.normal(size=(6, 6, 3)))


def random_tensor(rng, scale):
    return {"points": plain_net(rng, scale), "shape": random_shape(rng, 4)}


def random_symmetric(rng, scale):
    return {
        "points": plain_net(rng, scale)[:3],
        "mirror": [1.0, *0.2 * rng.normal(size=3)],
        "shape": random_shape(rng, 4),
    }


def random_swept(rng, scale):
    net = plain_net(rng, scale)
    return {"section": net[:, 0], "trajectory": net[0], "shape": random_shape(rng, 4)}


def random_swung(rng, scale):
    angle = np.linspace(0, rng.uniform(0.5, 3), 6)
    profile = scale * np.stack([1 + rng.random(6), np.linspace(-1, 1, 6)], axis=-1)
    around = np.stack([np.cos(angle), np.sin(angle)], axis=-1) * (1 + 0.2 * rng.normal(size=(6, 1)))
    return {
        "profile": profile,
        "trajectory": around,
        "scale": float(rng.uniform(0.5, 3)),
        "shape": random_shape(rng, 4),
    }


def random_ruled(rng, scale):
    net = plain_net(rng, scale)
    return {"first": net[:, 0], "second": net[:, 5], "shape": random_shape(rng, 4)}


def random_developable(rng, scale):
    angle = np.linspace(-0.6, 0.6, 6)
    normals = np.stack([np.sin(angle), 0.1 * rng.normal(size=6), np.cos(angle)], axis=-1)
    offsets = -scale * (1 + 0.05 * rng.normal(size=6))
    tilt = 0.1 * rng.normal(size=(2, 2))
    bounds = [[tilt[0, 0], 1.0, tilt[0, 1], scale], [tilt[1, 0], 1.0, tilt[1, 1], -scale]]
    # Between -4 and -3.5 a strip may run hundreds of its widths along its first ruling, and lose digits there.
    shape = [value if value == -4.0 else max(value, -3.5) for value in random_shape(rng, 2)]
    return {"planes": np.concatenate([normals, offsets[:, None]], axis=1), "bounds": bounds, "shape": shape}


RANDOM = {
    "tensor": random_tensor,
    "symmetric": random_symmetric,
    "swept": random_swept,
    "swung": random_swung,
    "ruled": random_ruled,
    "developable": random_developable,
}


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("kind", RANDOM)
def test_random_models_meet_exact_values(kind, scale):
    rng = np.random.default_rng([11, *kind.encode()])
    regular = 0
    for _ in range(10):
        model = {"kind": kind, **RANDOM[kind](rng, scale)}
        if kind != "developable" and rng.random() < 0.2:
            model |= {"basis": "bernstein"}
        model["flip"] = bool(rng.random() < 0.5)
        regular += check_model(model, *parameters(rng, 5))
    assert regular >= 60


# ---------------------------------------------------------------------------------------------- far from the origin


def displaced(model, shift):
    """Return the model moved by ``shift``; planes move by their offsets."""
    result = dict(model)
    for key in ("points", "section", "first", "second"):
        if key in model:
            result[key] = np.add(model[key], shift)
    for key in ("planes", "bounds"):
        if key in model:
            planes = np.array(model[key])
            result[key] = np.concatenate([planes[:, :3], planes[:, 3:] - planes[:, :3] @ shift[:, None]], axis=1)
    return result


@pytest.mark.parametrize("distance", [1e1, 1e3, 1e5])
@pytest.mark.parametrize("kind", ["tensor", "swept", "ruled", "developable"])
def test_digits_are_lost_in_proportion_to_the_distance_from_the_origin(kind, distance):
    rng = np.random.default_rng([13, *kind.encode()])
    shift = distance * np.array([1.0, -0.7, 0.4])
    worst = 0.0
    for _ in range(4):
        model = displaced({"kind": kind, **RANDOM[kind](rng, 1.0), "shape": [0.5, -2.0, 1.0, 0.0]}, shift)
        model["shape"] = model["shape"][: 2 if kind == "developable" else 4]
        u, v = parameters(rng, 5)
        surface = build(model)
        sample = quintrig.analyse(surface, u, v)
        for k in range(len(u)):
            exact = oracle.values(model, u[k], v[k])
            lean = float(exact["E"] * exact["G"]) ** 0.5 / float(exact["area"])
            curved = max(float(exact["curvedness"]), 0.1 / sample.size) * lean**2
            worst = max(worst, float(abs(oracle.number(sample["mean"][k]) - exact["mean"])) / curved)
            worst = max(worst, float(abs(oracle.number(sample["gaussian"][k]) - exact["gaussian"])) / curved**2)
    assert worst <= 1e-13 + 1e-14 * distance


def test_curvature_does_not_see_where_the_origin_is():
    net = np.round(64 * plain_net(np.random.default_rng(11), 8.0)) / 64  # so that moving it far away is exact
    u, v = np.random.default_rng(12).random((2, 40))
    at_home, away = (
        quintrig.analyse(quintrig.tensor(net + shift, (1.0, -3.5, -4.0, 0.0)), u, v)
        for shift in (0.0, [2.0**30, -(2.0**28), 2.0**31])
    )
    for key in ("E", "F", "G", "L", "M", "N", "normal", "gaussian", "mean", "k1", "k2", "shape_index", "gamma1"):
        np.testing.assert_array_equal(away[key], at_home[key], err_msg=key)
