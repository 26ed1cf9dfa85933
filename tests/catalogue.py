"""Every surface and every family of functions that the property tests run over: add a new kind, and all apply to it.

A surface is a model, a dictionary with the keys of a model file, so that ``oracle`` can work out the same one.
"""

from dataclasses import dataclass

import numpy as np

import quintrig
from quintrig.basis.bernstein import Bernstein, TangentBernstein
from quintrig.basis.bspline import normalised
from quintrig.basis.elementary import Circular, Hyperbolic, Powers
from quintrig.basis.joined import Joined
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry import closed_forms as reference
from quintrig.geometry import constructions as construct
from quintrig.geometry.nurbs import nurbs

# ---------------------------------------------------------------------------------------------- functions

PAIRS = ((0.0, 0.0), (1.0, 1.0), (-4.0, -4.0), (-4.0, 1.0), (0.5, -3.25), (-3.999, 0.999))
"""Shape parameters (α, ζ): the ends of the range, its middle, and close to its ends."""

BASES = {f"trigonometric {pair}": Trigonometric(*pair) for pair in PAIRS} | {
    f"bernstein {degree}": Bernstein(degree) for degree in (0, 1, 2, 5, 11)
}
"""Non-negative functions that sum to 1."""

FAMILIES = BASES | {
    "b-spline": normalised([0, 0, 0, 0, 1, 2, 4, 4, 4, 4], 3),
    "trigonometric, unchecked": Trigonometric(2.0, -7.5, unchecked=True),
    "tangent bernstein 10": TangentBernstein(10),
    "circular": Circular(-1.0, 4.0),
    "hyperbolic": Hyperbolic(-1.5, 0.5),
    "powers": Powers(-2.0, 1.0, 3),
    "joined": Joined((Circular(0.0, 4.0), Powers(0.0, 1.0, 1), Trigonometric(1.0, -4.0))),
}
"""All families of functions."""

# ---------------------------------------------------------------------------------------------- surfaces

SHAPES = (
    (0.0, 0.0, 0.0, 0.0),
    (1.0, 1.0, 1.0, 1.0),
    (-4.0, -4.0, -4.0, -4.0),
    (1.0, -4.0, -4.0, 0.25),
    (0.5, -1.5, -3.25, 0.9),
)


@dataclass(frozen=True)
class Entry:
    """A model, and what is known of it: K <= 0 (``ruled``) or K = 0 (``developable``) everywhere."""

    model: dict
    ruled: bool = False
    developable: bool = False

    def surface(self):
        """Build the surface."""
        return build(self.model)


def build(model):
    """Build the surface of a model straight from the constructions, without the reader of model files."""
    arguments = {key: value for key, value in model.items() if key != "kind"}
    if model["kind"] == "developable":
        return quintrig.developable(**arguments)
    if model["kind"] == "nurbs":
        return nurbs(**arguments)
    if model["kind"] == "symmetric":
        arguments["half_net"] = arguments.pop("points")
    home = construct if model["kind"] in ("tensor", "symmetric", "swept", "swung", "ruled") else reference
    return getattr(home, model["kind"])(**arguments)


def wave(rows=6, columns=6, seed=1, roughness=0.15):
    """A waved net over a 5 x 4 rectangle."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(0, 5, rows), np.linspace(0, 4, columns), indexing="ij")
    z = np.sin(0.9 * x) * np.cos(0.7 * y)
    return np.stack([x, y, z], axis=-1) + roughness * rng.normal(size=(rows, columns, 3))


def arch(points=6, seed=2):
    """A space curve rising and falling along x."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, points)
    return np.stack([4 * t, 0.8 * t**2, 3 * t * (1 - t)], axis=-1) + 0.1 * rng.normal(size=(points, 3))


def rail(points=6, seed=3):
    """A space curve along y."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, points)
    return np.stack([0.5 * t, 3 * t, np.cos(2 * t)], axis=-1) + 0.1 * rng.normal(size=(points, 3))


PROFILE = ((2.0, 0.0), (2.2, 0.8), (1.6, 1.7), (1.2, 2.2), (1.5, 3.1), (1.1, 4.0))
POLE = ((2.0, 0.0), (2.0, 0.8), (1.7, 1.7), (1.2, 2.4), (0.7, 2.6), (0.0, 2.6))
AROUND = ((1.0, 0.0), (1.0, 0.5), (0.8, 0.9), (0.4, 1.1), (0.2, 1.2), (0.0, 1.1))

CALM = (
    (1.0, 0.1, 0.3, -10.0),
    (1.0, 0.3, 0.32, -10.2),
    (0.9, 0.6, 0.34, -10.3),
    (0.7, 0.8, 0.33, -10.6),
    (0.5, 0.9, 0.31, -10.7),
    (0.3, 1.0, 0.28, -11.0),
)
"""Control planes whose edge of regression lies far above the bounds."""

CUSPED = ((0, 1, 4, -20), (1, 1, 5, -24), (2, 1, 4, -30), (3, 0, 4, -33), (4, 1, 3, -40), (5, 2, 4, -44))
"""Control planes whose edge of regression crosses the strip."""

LEVEL = ((0, 0, 1, 0), (0, 0, 1, -5))
TILTED = ((0.1, 0, 1, 0), (0, 0.05, 1, -5))
ACROSS = ((0, 1, 0, 0), (0, 1, 0, -10))


def _models():
    tensor = {"kind": "tensor", "points": wave()}
    for shape in SHAPES:
        yield f"tensor {shape}", {**tensor, "shape": shape}
    yield "tensor flipped", {**tensor, "shape": SHAPES[4], "flip": True}
    yield "tensor unchecked", {**tensor, "shape": (2.0, -6.0, 0.0, 1.5), "unchecked_shape": True}
    yield "tensor classical", {**tensor, "shape": SHAPES[0], "basis": "bernstein"}
    yield "tensor classical 3 x 9", {"kind": "tensor", "points": wave(3, 9), "shape": SHAPES[0], "basis": "bernstein"}
    yield "tensor bilinear", {"kind": "tensor", "points": wave(2, 2), "shape": SHAPES[0], "basis": "bernstein"}
    half = {"kind": "symmetric", "points": wave()[:3], "mirror": (1.0, 0.0, 0.0, -2.5)}
    for shape in SHAPES:
        yield f"symmetric {shape}", {**half, "shape": shape}
    yield "symmetric oblique", {**half, "mirror": (2.0, 0.3, -0.2, -5.0), "shape": (1.0, 1.0, 0.0, -2.0)}
    yield "symmetric classical", {**half, "shape": SHAPES[0], "basis": "bernstein", "flip": True}
    swept = {"kind": "swept", "section": arch(), "trajectory": rail()}
    for shape in SHAPES:
        yield f"swept {shape}", {**swept, "shape": shape}
    yield "swept classical", {**swept, "trajectory": rail(4), "shape": SHAPES[0], "basis": "bernstein"}
    swung = {"kind": "swung", "profile": PROFILE, "trajectory": AROUND}
    for shape, scale in zip(SHAPES, (1.0, 1.5, 0.3, -2.0, 1.0), strict=True):
        yield f"swung {shape}", {**swung, "shape": shape, "scale": scale}
    yield "swung to a pole", {**swung, "profile": POLE, "shape": SHAPES[4], "scale": 1.2}
    yield "swung classical", {**swung, "shape": SHAPES[0], "basis": "bernstein", "flip": True}
    ruled = {"kind": "ruled", "first": arch(), "second": np.add(arch(seed=4) * (1.0, -1.0, 0.7), (0.5, 5.0, 1.0))}
    for shape in SHAPES:
        yield f"ruled {shape}", {**ruled, "shape": shape}
    yield "ruled classical", {**ruled, "first": arch(4), "shape": SHAPES[0], "basis": "bernstein"}
    yield "ruled cylinder", {**ruled, "second": np.add(arch(), (0.3, 2.0, 1.0)), "shape": (0.5, -2.0, 0.5, -2.0)}
    yield "ruled cone", {**ruled, "second": np.add(0.4 * arch(), (0.0, 3.0, 2.0)), "shape": (1.0, -4.0, 1.0, -4.0)}
    for pair in PAIRS:
        yield f"developable {pair}", {"kind": "developable", "planes": CALM, "bounds": LEVEL, "shape": pair}
        yield f"developable cusped {pair}", {"kind": "developable", "planes": CUSPED, "bounds": ACROSS, "shape": pair}
    calm = {"kind": "developable", "planes": CALM, "bounds": TILTED, "shape": (-2.5, 0.75)}
    yield "developable oblique", calm
    yield "developable flipped", {**calm, "flip": True}
    yield "developable standing still", {**calm, "planes": (CALM[0], *CALM[:5])}
    rng = np.random.default_rng(8)
    yield (
        "nurbs",
        {
            "kind": "nurbs",
            "points": wave(6, 5),
            "weights": rng.uniform(0.6, 1.6, (6, 5)),
            "degrees": (3, 2),
            "knots": ([0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [0, 0, 0, 0.5, 1.5, 2, 2, 2]),
        },
    )
    yield "sphere", {"kind": "sphere", "radius": 2.5}
    yield "sphere flipped", {"kind": "sphere", "radius": 1.0, "flip": True}
    yield "ellipsoid", {"kind": "ellipsoid", "a": 3.0, "b": 2.0, "c": 1.5}
    yield "cylinder", {"kind": "cylinder", "radius": 1.25, "height": 3.0}
    yield "cone", {"kind": "cone", "radius": 1.5, "height": 2.0}
    yield "torus", {"kind": "torus", "major": 3.0, "minor": 1.0}
    yield "torus through itself", {"kind": "torus", "major": 1.0, "minor": 1.5, "flip": True}
    yield "catenoid", {"kind": "catenoid", "waist": 1.0, "height": 2.5}
    yield "helicoid", {"kind": "helicoid", "radius": 1.5, "pitch": 2.0}
    yield "helicoid, left-handed", {"kind": "helicoid", "radius": 1.0, "pitch": -4.0}
    yield "hyperbolic paraboloid", {"kind": "hyperbolic_paraboloid", "size": 1.0}
    yield "monkey saddle", {"kind": "monkey_saddle", "size": 0.8}
    yield "enneper", {"kind": "enneper", "size": 1.2}


def _is(name, *starts):
    return name.startswith(starts)


SURFACES = {
    name: Entry(
        {key: value.tolist() if isinstance(value, np.ndarray) else value for key, value in model.items()},
        ruled=_is(name, "ruled", "developable", "cylinder", "cone", "helicoid", "hyperbolic"),
        developable=_is(name, "ruled cylinder", "ruled cone", "developable", "cylinder", "cone"),
    )
    for name, model in _models()
}
"""Every surface by name."""
