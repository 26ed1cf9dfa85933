"""Random models of every kind that is built from control points or planes, and parameters to try them at."""

import numpy as np

EDGES = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))


def parameters(rng, inside):
    """Return u, v: points inside, the four corners, and one point on each edge."""
    on_edges = [(0.0, rng.random()), (1.0, rng.random()), (rng.random(), 0.0), (rng.random(), 1.0)]
    return np.array([*rng.random((inside, 2)), *EDGES, *on_edges]).T


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


def displaced(model, shift):
    """Return the model moved by ``shift``; planes move by their offsets, a swung one moves along its axis."""
    result = dict(model)
    for key in ("points", "section", "first", "second"):
        if key in model:
            result[key] = np.add(model[key], shift)
    if "profile" in model:
        result["profile"] = np.add(model["profile"], [0.0, shift[2]])
    if "mirror" in model:
        result["mirror"] = [*model["mirror"][:3], model["mirror"][3] - np.dot(model["mirror"][:3], shift)]
    for key in ("planes", "bounds"):
        if key in model:
            planes = np.array(model[key])
            result[key] = np.concatenate([planes[:, :3], planes[:, 3:] - planes[:, :3] @ shift[:, None]], axis=1)
    return result
