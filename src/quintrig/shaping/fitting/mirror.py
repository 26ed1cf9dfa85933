"""The plane in which points are nearly their own mirror image."""

from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from quintrig.scan.align import rotation
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
            values, vectors = np.linalg.eig(turn)
            normal = np.real(vectors[:, int(np.argmin(np.real(values)))])
            normal = normal / np.linalg.norm(normal)
            best, least = np.append(normal, -0.5 * float(normal @ shift)), rms
    return best
