"""Every surface of the catalogue and random models, at random points, on edges and at corners, against 40 digits."""

import numpy as np
import pytest

import oracle
import quintrig
from catalogue import SURFACES, build
from quintrig.quantities import table
from random_models import RANDOM, parameters

TOLERANCE = 1e-11
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1}
INVARIANTS = {"beta0": 0, "beta1": 1, "beta2": 2, "gamma1": 1, "gamma2": 1, "gamma3": 1}
# With the slope, the invariants of the horizontal plane grow by these powers of 1/n_z, and their rounding by one more.
STEEP = {"beta0": 2, "beta1": 3, "beta2": 4, "gamma1": 5, "gamma2": 4, "gamma3": 3}
FORMS = ("E", "F", "G", "L", "M", "N")
FLATTEST = 1e-3
"""Curvedness times size below which errors are measured against this curvedness, not the point's own (1 if it is 0)."""


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
    for key in table.SCALARS:
        if key not in ("E", "F", "G"):
            assert np.isnan(found[key]), f"{key} at singular {place}"
    assert np.isnan(found["normal"]).all(), place
    assert np.isfinite(found["point"]).all(), place
    for key in table.CLASSES:
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
