"""The plane in which points are nearly their own mirror image."""

import numpy as np

from quintrig.scan.align import rotation
from quintrig.scan.nearest import Finder
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import shortest

_TURNS = 8
"""Planes through the shortest principal axis that are tried."""


def mirror_of(finder: Finder, points: FloatArray) -> FloatArray:
    """Return the plane (a, b, c, d), (a, b, c) of length 1, that points (n, 3) are nearest to symmetric in.

    ``finder`` is that of a surface through the points: images are measured to it, which noise moves less than points.
    Image and the small motion that brings it onto the surface are together a reflection nearly, whose plane it is.
    """
    few, many = (_some(points, count) for count in (800, 20_000))
    centre = points.mean(axis=0)
    _, axes = np.linalg.eigh((many - centre).T @ (many - centre))
    angles = np.pi * np.arange(_TURNS) / _TURNS
    normals = [np.cos(a) * axes[:, 2] + np.sin(a) * axes[:, 1] for a in angles] + [axes[:, 0]]
    tried = [_refined(finder, few, np.append(normal, -normal @ centre), 12) for normal in normals]
    best = min(tried, key=lambda one: one[1])[0]
    return _refined(finder, many, best, 25)[0]


def _some(points: FloatArray, most: int) -> FloatArray:
    return points if len(points) <= most else points[np.random.default_rng(0).permutation(len(points))[:most]]


def _refined(finder: Finder, points: FloatArray, plane: FloatArray, rounds: int) -> tuple[FloatArray, float]:
    centre = points.mean(axis=0)
    best, least = plane, np.inf
    for _ in range(rounds):
        normal, offset = plane[:3], plane[3]
        turn, shift = np.eye(3) - 2.0 * np.outer(normal, normal), -2.0 * offset * normal
        image = points @ turn.T + shift
        feet = finder.feet(image)
        rms = float(np.sqrt((feet.away**2).sum(axis=1).mean()))
        if rms < least:
            best, least = plane, rms
        inner = ~feet.edge
        if inner.sum() < 10:
            break
        rows = np.concatenate([np.cross(image - centre, feet.normal), feet.normal], axis=1)[inner]
        gap = -np.einsum("ij,ij->i", feet.away, feet.normal)[inner]
        step = shortest(rows, gap, rcond=1e-6)
        more = rotation(step[:3])
        plane = _plane_of(more @ turn, more @ (shift - centre) + centre + step[3:])
        if np.abs(step[:3]).max() < 1e-13:
            break
    return best, least


def _plane_of(turn: FloatArray, shift: FloatArray) -> FloatArray:
    """Return the plane of a reflection, or nearly one, x -> turn x + shift."""
    values, vectors = np.linalg.eig(turn)
    normal = np.real(vectors[:, int(np.argmin(np.real(values)))])
    normal = normal / np.linalg.norm(normal)
    return np.append(normal, -0.5 * float(normal @ shift))
