"""Continuity across a seam, measured from points alone: no partial derivative of the library is used."""

import numpy as np

_REACH, _NODES = 0.4, 18
_ZERO_TO_ONE = 0.5 - 0.5 * np.cos(np.pi * np.arange(_NODES) / (_NODES - 1))


def seam(first, second, count=5):
    """Return the largest gap, angle of normals (degrees) and relative jump of normal curvature across two sides.

    ``first`` and ``second`` are (surface, side). For points of the first side the nearest ones of the second are
    sought; each patch is sampled on a polynomial patch beside them, on its own side of the seam.
    """
    worst = np.zeros(3)
    one, two = first[0], second[0]
    t = np.linspace(0.06, 0.94, count)
    here = one(*_place(first[1], t, 0.0))
    feet = _feet(two, second[1], here)
    for a, b, point in zip(t, feet, here, strict=True):
        p, x, y, k = _local(one, first[1], a)
        q, z, w, l = _local(two, second[1], b, y)  # noqa: E741
        n, m = np.cross(x, y), np.cross(z, w)
        if n @ m < 0:
            m = -m
            l = -l  # noqa: E741
        n, m = n / np.linalg.norm(n), m / np.linalg.norm(m)
        angle = np.degrees(np.arctan2(np.linalg.norm(np.cross(n, m)), n @ m))
        jump = abs(k - l) / max(abs(k) + abs(l), 1e-3 / min(one.size, two.size))
        worst = np.maximum(worst, [np.linalg.norm(p - q), angle, jump])
        assert np.allclose(p, point)
    return worst


def _place(side, t, s):
    """Parameters at t along a side and s inside it."""
    across = s if side[1] == "0" else 1.0 - s
    return (across + 0 * t, t + 0 * s) if side[0] == "u" else (t + 0 * s, across + 0 * t)


def _feet(surface, side, points):
    """Parameters along a side of the nearest points: the best of many, then refined by thirds."""
    t = np.linspace(0, 1, 201)
    curve = surface(*_place(side, t, 0.0))
    found = []
    for point in points:
        k = np.linalg.norm(curve - point, axis=-1).argmin()
        low, high = t[max(k - 1, 0)], t[min(k + 1, 200)]
        # The distance squared is as good as a parabola there: Newton's steps by differences of its slope.
        x = t[k]
        for _ in range(6):
            tangent, bend = _derivatives(surface, side, x)
            away = surface(*_place(side, np.array(x), 0.0)) - point
            x = float(np.clip(x - away @ tangent / (tangent @ tangent + away @ bend), low, high))
        found.append(x)
    return np.array(found)


def _fit(nodes, values, x):
    """Value and first two derivatives at x of the polynomial through values at nodes."""
    low, high = nodes.min(), nodes.max()
    scale = 2.0 / (high - low)
    powers = np.polynomial.chebyshev.chebvander((nodes - low) * scale - 1.0, len(nodes) - 1)
    c = np.linalg.solve(powers, values)
    series = [np.polynomial.chebyshev.chebder(c, k) for k in range(3)]
    return [np.polynomial.chebyshev.chebval((x - low) * scale - 1.0, one) * scale**k for k, one in enumerate(series)]


def _derivatives(surface, side, x):
    nodes = _nodes(x)
    return _fit(nodes, surface(*_place(side, nodes, 0.0)), x)[1:]


def _nodes(x):
    """Parameters along a side about x."""
    low, high = max(0.0, x - _REACH), min(1.0, x + _REACH)
    return low + (high - low) * _ZERO_TO_ONE


def _local(surface, side, x, like=None):
    """Point, way across, tangent, and normal curvature across the seam (signed by across x tangent)."""
    depth, nodes = _REACH * _ZERO_TO_ONE, _nodes(x)
    s, t = np.meshgrid(depth, nodes, indexing="ij")
    points = surface(*_place(side, t, s))
    rows = [_fit(depth, points[:, j], 0.0) for j in range(_NODES)]
    value, first, second = (np.array([row[k] for row in rows]) for k in range(3))
    p, tangent, along = _fit(nodes, value, x)
    across, twist = _fit(nodes, first, x)[:2]
    bend = _fit(nodes, second, x)[0]
    if like is not None and tangent @ like < 0:
        tangent, twist = -tangent, -twist
    n = np.cross(across, tangent)
    n /= np.linalg.norm(n)
    # d = across - c tangent, at right angles to the tangent: II(d, d) / I(d, d).
    c = (across @ tangent) / (tangent @ tangent)
    d = across - c * tangent
    second = (bend - 2 * c * twist + c * c * along) @ n
    return p, across, tangent, second / (d @ d)
