"""The plane in which points are nearly their own mirror image."""

from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from quintrig.scan.align import rotation
from quintrig.scan.nearest import Finder
from quintrig.shaping.fitting.primitives import normals_of
from quintrig.support.arrays import FloatArray


def mirror_of(points: FloatArray) -> FloatArray:
    """Return the plane (a, b, c, d), (a, b, c) of length 1, that points (n, 3) are nearest to symmetric in.

    Each principal plane is tried: the image in it is moved onto the points by closest points to planes, and image and
    motion together are a reflection nearly, whose plane it is.
    """
    few = points if len(points) <= 4000 else points[np.random.default_rng(0).permutation(len(points))[:4000]]
    tree: Any = cKDTree(points)
    normals = normals_of(points, points)
    centre = few.mean(axis=0)
    best, least = np.array([1.0, 0.0, 0.0, 0.0]), np.inf
    for axis in np.linalg.eigh((few - centre).T @ (few - centre))[1].T:
        turn = np.eye(3) - 2.0 * np.outer(axis, axis)
        shift = centre - turn @ centre
        rms = np.inf
        for _ in range(30):
            image = few @ turn.T + shift
            near = np.asarray(tree.query(image)[1])
            gap = np.einsum("ij,ij->i", points[near] - image, normals[near])
            kept = np.abs(gap) <= 4.0 * 1.4826 * np.median(np.abs(gap)) + 1e-12
            rms = float(np.sqrt(np.mean(((points[near] - image) ** 2).sum(axis=1))))
            arm = image - centre
            rows = np.concatenate([np.cross(arm, normals[near]), normals[near]], axis=1)[kept]
            step = np.linalg.lstsq(rows, gap[kept], rcond=1e-6)[0]
            more = rotation(step[:3])
            shift = more @ (shift - centre) + centre + step[3:]
            turn = more @ turn
            if np.abs(step).max() < 1e-12:
                break
        if rms < least:
            best, least = _plane_of(turn, shift), rms
    return best


def refined_mirror(finder: Finder, points: FloatArray, plane: FloatArray) -> FloatArray:
    """Return the plane by the images' orthogonal distances from a surface through the points, which noise moves less."""
    few = points if len(points) <= 20_000 else points[np.random.default_rng(0).permutation(len(points))[:20_000]]
    centre = few.mean(axis=0)
    for _ in range(25):
        normal, offset = plane[:3], plane[3]
        turn, shift = np.eye(3) - 2.0 * np.outer(normal, normal), -2.0 * offset * normal
        image = few @ turn.T + shift
        feet = finder.feet(image)
        inner = ~feet.edge
        if inner.sum() < 10:
            return plane
        arm = image - centre
        rows = np.concatenate([np.cross(arm, feet.normal), feet.normal], axis=1)[inner]
        gap = -np.einsum("ij,ij->i", feet.away, feet.normal)[inner]
        off = np.abs(gap)
        rows, gap = rows[off <= 6.0 * 1.4826 * np.median(off) + 1e-15], gap[off <= 6.0 * 1.4826 * np.median(off) + 1e-15]
        step = np.linalg.lstsq(rows, gap, rcond=1e-6)[0]
        more = rotation(step[:3])
        plane = _plane_of(more @ turn, more @ (shift - centre) + centre + step[3:])
        if np.abs(step[:3]).max() < 1e-13:
            break
    return plane


def _plane_of(turn: FloatArray, shift: FloatArray) -> FloatArray:
    """Return the plane of a reflection, or nearly one, x -> turn x + shift."""
    values, vectors = np.linalg.eig(turn)
    normal = np.real(vectors[:, int(np.argmin(np.real(values)))])
    normal = normal / np.linalg.norm(normal)
    return np.append(normal, -0.5 * float(normal @ shift))
