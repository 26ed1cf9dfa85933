"""Surfaces of every kind that exchange has to carry, shared by the tests of rational form, CAD, meshes and patterns."""

import numpy as np

import quintrig

SHAPE = (0.5, -1.5, -3.0, 1.0)


def net(seed=0, rows=6, columns=6):
    """A gently waved net of control points, about 10 x 10 x 3."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(0, 10, rows), np.linspace(0, 10, columns), indexing="ij")
    z = 1.5 * np.sin(0.5 * x) * np.cos(0.4 * y) + 0.3 * rng.normal(size=x.shape)
    return np.stack([x, y, z], axis=-1)


def planes(tilt=0.3, turn=60.0, wobble=0.15):
    """Six control planes that envelop a strip a little off a cone, its edge of regression far above."""
    angle = np.radians(np.linspace(0, turn, 6))
    steep = tilt + wobble * np.sin(np.arange(6.0)) / 6
    return np.stack([np.cos(angle), np.sin(angle), steep, -10 - 0.2 * np.arange(6.0)], axis=-1)


PARALLEL = [[0, 0, 1, 0], [0, 0, 1, -5]]
OBLIQUE = [[0, 0, 1, 0], [0.1, 0.05, 1, -5]]
CURVE = np.array([[0, 0, 0], [1, 2, 0], [3, 3, 1], [5, 2, 1], [7, 1, 0], [9, 2, -1.0]])


def developables():
    return {
        "developable": quintrig.developable(planes(), PARALLEL, (0.5, -1.0)),
        "developable oblique": quintrig.developable(planes(), OBLIQUE, (0.5, -1.0)),
        "developable (0, 0)": quintrig.developable(planes(), OBLIQUE),
        "developable (-4, -4)": quintrig.developable(planes(), OBLIQUE, (-4.0, -4.0)),
        "developable flipped": quintrig.developable(planes(), PARALLEL, (1.0, 1.0), flip=True),
    }


def rational():
    """Every surface with an exact rational form, by name."""
    from quintrig.geometry.nurbs import nurbs

    circle = [[2, 0], [2, 1], [1.5, 2], [1, 2.5], [0.8, 3], [0.2, 4]]
    around = [[1, 0], [1, 0.5], [0.8, 0.9], [0.4, 1.1], [0.2, 1.2], [0, 1]]
    weights = np.random.default_rng(5).uniform(0.5, 2, size=(5, 4))
    knots = ([0, 0, 0, 1, 2, 3, 3, 3], [0, 0, 0, 0, 1, 1, 1, 1])
    return {
        "tensor": quintrig.tensor(net(), SHAPE),
        "tensor (0, 0, 0, 0)": quintrig.tensor(net(1)),
        "tensor (-4, -4, -4, -4)": quintrig.tensor(net(1), (-4, -4, -4, -4)),
        "tensor flipped": quintrig.tensor(net(2), (1, 0, 0, 0), flip=True),
        "symmetric": quintrig.symmetric(net()[:3], [1, 0, 0, -5], SHAPE),
        "swept": quintrig.swept(
            CURVE, np.array([0, 1, 0]) * np.arange(6)[:, None] + [[0, 0, z * z / 9] for z in range(6)], SHAPE
        ),
        "swung": quintrig.swung(circle, around, SHAPE, 1.3),
        "swung to a pole": quintrig.swung([*circle[:5], [0, 4]], around, SHAPE),
        "ruled": quintrig.ruled(CURVE, CURVE[::-1] * [-1, 1, 1] + [9, 0, 6], SHAPE),
        "ruled half lowered": quintrig.ruled(CURVE, CURVE + np.array([0, 1, 4]), (0, 0, 1, 0)),
        "classical": quintrig.tensor(net(3, 4, 5), basis="bernstein"),
        "nurbs": nurbs(net(4, 5, 4), weights, (2, 3), knots),
        **developables(),
        "sphere": quintrig.sphere(2.0),
        "ellipsoid": quintrig.ellipsoid(),
        "cylinder": quintrig.cylinder(),
        "cone": quintrig.cone(),
        "torus": quintrig.torus(),
        "hyperbolic paraboloid": quintrig.hyperbolic_paraboloid(),
        "monkey saddle": quintrig.monkey_saddle(),
        "enneper": quintrig.enneper(),
    }
