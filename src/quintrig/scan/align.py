"""The rigid motion that brings points onto surfaces: iterated closest points, to planes (Chen and Medioni 1992)."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from quintrig.scan.nearest import Feet, Finder
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import shortest

_COARSE, _FINE = 600, 40_000
_STEPS = 80
_STILL = 1e-12  # of the size: a step this small is the last
_FAR = 6.0 * 1.4826  # median distances: farther points are outliers, six standard deviations of Gaussian noise
_MOST_OUT = 0.2  # of the points: where more lie that far, the target is another shape and all of them count


@dataclass(frozen=True, eq=False)
class Motion:
    """A rigid motion (4, 4) of the points, the largest way that one of them went, length¹, and its parts in words.

    ``left_out`` is the share of the points that did not count as outliers, from 0 to 1.
    """

    matrix: FloatArray
    largest: float
    left_out: float = 0.0

    @property
    def angle(self) -> float:
        """How far it turns, in degrees."""
        return float(np.degrees(np.linalg.norm(_turning(self.matrix[:3, :3]))))

    @property
    def axis(self) -> FloatArray:
        """The unit vector that it turns about, (0, 0, 0) where it does not."""
        turning = _turning(self.matrix[:3, :3])
        length = float(np.linalg.norm(turning))
        return turning / length if length > 1e-12 else np.zeros(3)

    def to_dict(self) -> dict[str, object]:
        """Return what was moved, for JSON."""
        return {
            "matrix": self.matrix.tolist(),
            "angle_degrees": self.angle,
            "axis": self.axis.tolist(),
            "translation": self.matrix[:3, 3].tolist(),
            "largest": self.largest,
            "left_out": self.left_out,
        }


def aligned_to(finder: Finder, points: FloatArray) -> Motion:
    """Return the motion that brings points (n, 3), length¹, nearest to surfaces, in the sense of least squares.

    It starts from where the points are and from their principal axes laid on those of the surfaces, and takes the best.
    What slides along the surface without a difference, such as a turn of a sphere, is left as it is. Outliers do not
    count: points farther than six standard deviations of the others. Raises ValueError for points on one line.
    """
    if len(points) < 3 or np.linalg.matrix_rank(points - points.mean(axis=0), rtol=1e-9) < 2:
        raise ValueError("align: expected at least three points that are not on one line; leave out the alignment")
    few, fine = _thinned(points, _COARSE), _thinned(points, _FINE)
    size = max(surface.size for surface in finder.surfaces)
    tried = [_refined(finder, few, start, size, 40) for start in _starts(finder, points)]
    matrix, _ = _refined(finder, fine, min(tried, key=lambda one: one[1])[0], size, _STEPS)
    matrix, left_out = _without_outliers(finder, fine, matrix, size)
    moved = points @ matrix[:3, :3].T + matrix[:3, 3]
    return Motion(matrix, float(np.linalg.norm(moved - points, axis=1).max()), left_out)


def _without_outliers(finder: Finder, points: FloatArray, matrix: FloatArray, size: float) -> tuple[FloatArray, float]:
    """Refine a motion by the points that are near after it, and return it with the share of the others."""
    kept = np.ones(len(points), dtype=bool)
    for _ in range(8):
        away = np.linalg.norm(finder.feet(points @ matrix[:3, :3].T + matrix[:3, 3]).away, axis=1)
        near = away <= max(_FAR * float(np.median(away)), 1e-9 * size)
        if np.array_equal(near, kept) or near.mean() < 1.0 - _MOST_OUT:
            break
        kept = near
        matrix, _ = _refined(finder, points[kept], matrix, size, _STEPS)
    return matrix, 1.0 - float(kept.mean())


def _thinned(points: FloatArray, most: int) -> FloatArray:
    return points if len(points) <= most else points[np.linspace(0, len(points) - 1, most).astype(int)]


def _refined(
    finder: Finder, points: FloatArray, start: FloatArray, size: float, steps: int
) -> tuple[FloatArray, float]:
    matrix = start.copy()
    gap = np.inf
    for _ in range(steps):
        moved = points @ matrix[:3, :3].T + matrix[:3, 3]
        feet = finder.feet(moved)
        gap = float(np.linalg.norm(feet.away, axis=1).mean())  # not squared: few outliers do not decide
        step = _step(moved, feet)
        matrix = step @ matrix
        if np.abs(moved @ step[:3, :3].T + step[:3, 3] - moved).max() <= _STILL * size:
            break
    return matrix, gap


def _step(points: FloatArray, feet: Feet) -> FloatArray:
    """Return the motion that is best for the tangent planes at the feet, and for the feet themselves at borders."""
    centre = points.mean(axis=0)
    reach = float(np.abs(points - centre).max()) or 1.0
    arm = (points - centre) / reach
    rows = np.concatenate([np.cross(arm, feet.normal), feet.normal], axis=1)
    wanted = -np.einsum("ij,ij->i", feet.away, feet.normal)
    if feet.edge.any():
        outer = feet.edge
        each = np.tile(np.eye(3), (int(outer.sum()), 1))
        held = np.concatenate([np.cross(np.repeat(arm[outer], 3, axis=0), each), each], axis=1)
        rows = np.concatenate([rows[~outer], held])
        wanted = np.concatenate([wanted[~outer], -feet.away[outer].ravel()])
    solution = shortest(rows, wanted, rcond=1e-5)
    turn = rotation(solution[:3] / reach)
    result = np.eye(4)
    result[:3, :3] = turn
    result[:3, 3] = centre - turn @ centre + solution[3:]
    return result


def _starts(finder: Finder, points: FloatArray) -> list[FloatArray]:
    t = np.linspace(0.0, 1.0, 15)
    cloud = np.concatenate([surface(t[:, None], t[None, :]).reshape(-1, 3) for surface in finder.surfaces])
    here, there = points.mean(axis=0), cloud.mean(axis=0)
    one, other = (np.linalg.svd(x - x.mean(axis=0), full_matrices=False)[2].T for x in (_thinned(points, 5000), cloud))
    starts = [np.eye(4), np.eye(4)]
    starts[1][:3, 3] = there - here
    for signs in product((1.0, -1.0), repeat=3):
        turn = other @ np.diag(signs) @ one.T
        if np.linalg.det(turn) > 0.0:
            start = np.eye(4)
            start[:3, :3], start[:3, 3] = turn, there - turn @ here
            starts.append(start)
    return starts


def rotation(turning: FloatArray) -> FloatArray:
    """Return the matrix (3, 3) of a turn by |turning| radians about a vector (3,) (Rodrigues)."""
    angle = float(np.linalg.norm(turning))
    x, y, z = turning
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    one = np.sinc(angle / np.pi)
    two = 0.5 * np.sinc(0.5 * angle / np.pi) ** 2
    return np.eye(3) + one * cross + two * cross @ cross


def _turning(turn: FloatArray) -> FloatArray:
    """Return the vector of a rotation matrix, whose length is the angle in radians."""
    from scipy.spatial.transform import Rotation

    found: FloatArray = Rotation.from_matrix(turn).as_rotvec()
    return found
