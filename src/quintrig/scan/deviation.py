"""How far measured points are from surfaces: signed orthogonal distances, and what they come to."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.scan.align import Motion, aligned_to
from quintrig.scan.mesh_distance import MeshFinder
from quintrig.scan.nearest import Finder
from quintrig.scan.scan import Scan, scan_of
from quintrig.support.arrays import FloatArray, number
from quintrig.support.late import call
from quintrig.support.progress import Progress

PERCENTILES = (1, 5, 25, 50, 75, 95, 99)

SIGN = "positive where the target lies on the side that the model's normal points to"
"""What the sign of a distance means."""

Subject = Model | Patch | Surface | Sequence[Surface]
Target = Scan | Model | Patch | Surface | str | Path | ArrayLike
"""Besides, what other tools hold: ``from_pyvista``, ``from_trimesh``, ``from_compas``, ``from_build123d`` say what."""


@dataclass(frozen=True, eq=False)
class Deviation:
    """Distances (n,), length¹, of ``points`` (n, 3) from their ``foot`` (n, 3); the sign is that of ``SIGN``.

    ``patch`` (n,), ``u`` and ``v`` (n,) are the place on the model. ``edge`` (n,) is true where the foot lies on a
    border and the distance is not orthogonal. ``motion`` is what aligned the target first.
    """

    points: FloatArray
    distance: FloatArray
    foot: FloatArray
    patch: NDArray[np.int64]
    u: FloatArray
    v: FloatArray
    edge: NDArray[np.bool_]
    surfaces: tuple[Surface, ...]
    names: tuple[str, ...]
    unit: str = ""
    tolerance: float | None = None
    motion: Motion | None = None
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        """Return the number of points."""
        return len(self.distance)

    def __repr__(self) -> str:
        """Return one line: points, rms and range."""
        unit = f" {self.unit}" if self.unit else ""
        return f"<Deviation of {len(self):,} points: rms {self.rms:.4g}, {self.min:.4g} to {self.max:.4g}{unit}>"

    @cached_property
    def min(self) -> float:
        """The lowest distance, length¹."""
        return float(self.distance.min())

    @cached_property
    def max(self) -> float:
        """The greatest distance, length¹."""
        return float(self.distance.max())

    @cached_property
    def mean(self) -> float:
        """The mean of the signed distances, length¹."""
        return float(self.distance.mean())

    @cached_property
    def rms(self) -> float:
        """The root of the mean of the squared distances, length¹."""
        return _rms(self.distance)

    @cached_property
    def percentiles(self) -> dict[int, float]:
        """Percentiles of the signed distances, length¹."""
        return dict(zip(PERCENTILES, np.percentile(self.distance, PERCENTILES).tolist(), strict=True))

    @property
    def within(self) -> float | None:
        """The share of the points within the tolerance, from 0 to 1; None without one."""
        return None if self.tolerance is None else float((np.abs(self.distance) <= self.tolerance).mean())

    def to_dict(self) -> dict[str, Any]:
        """Return the statistics for JSON: of all points, of those with an orthogonal distance, of those at edges."""
        size = np.abs(self.distance)
        worst = np.argsort(-size)[:5]
        result: dict[str, Any] = {
            "points": len(self),
            "unit": self.unit,
            "sign": SIGN,
            **_numbers(self.distance),
            "percentiles": {str(key): value for key, value in self.percentiles.items()},
            "absolute": {
                "mean": float(size.mean()),
                **{str(q): float(np.percentile(size, q)) for q in (50, 90, 95, 99)},
                "max": float(size.max()),
            },
            "tolerance": self.tolerance,
            "within": self.within,
            "orthogonal": _numbers(self.distance[~self.edge]),
            "edge": _numbers(self.distance[self.edge]),
            "patches": [
                {"name": name, **_numbers(self.distance[self.patch == index])} for index, name in enumerate(self.names)
            ],
            "worst": [
                {
                    "point": self.points[k].tolist(),
                    "distance": float(self.distance[k]),
                    "patch": self.names[self.patch[k]],
                    "u": float(self.u[k]),
                    "v": float(self.v[k]),
                    "edge": bool(self.edge[k]),
                }
                for k in worst
            ],
            "moved": None if self.motion is None else self.motion.to_dict(),
            "notes": list(self.notes),
        }
        return result


def deviation(
    model: Subject,
    target: Target,
    *,
    tolerance: float | None = None,
    align: bool = False,
    unit: str = "",
    source: Literal["target", "model"] = "target",
    progress: Progress | None = None,
) -> Deviation:
    """Return the signed orthogonal distance of every point of a target from a model's surfaces.

    ``target`` is a ``Scan``, points (n, 3) or normals besides, a file that ``read_scan`` or ``open_model`` reads, a
    mesh or points of PyVista, trimesh or COMPAS, or another model, surface or shape of build123d, which is then
    sampled. ``unit`` is the target's unit of length where it says none. ``tolerance``, length¹, gives the share within
    it. ``align`` moves the target onto the model first. With ``source`` "model" the distances are those of 65 x 65
    points a patch from the target's triangles or surfaces. Raises ValueError, ModelError or QuintrigError in one line.
    """
    if tolerance is not None and not number(tolerance, "tolerance") > 0.0:
        raise ValueError(f"tolerance: expected a length greater than 0, found {tolerance:g}")
    surfaces, names, length = _surfaces(model)
    finder = Finder(surfaces)
    target = own(target)
    scan = target_of(target, unit).in_unit(length)
    if scan.points.shape[1] != 3:
        raise ValueError("target: expected points in space, three numbers each, found two")
    motion = aligned_to(finder, scan.points) if align else None
    if motion is not None:
        scan = scan.moved(motion.matrix)
    told: dict[str, Any] = {"names": names, "unit": length or scan.unit, "tolerance": tolerance, "motion": motion}
    notes = (*scan.notes, *_far(scan, surfaces))
    if source == "model":
        others = _surfaces_of(target)
        if others and motion is not None:
            raise ValueError("align: expected a scan to move, found surfaces, to which distances are measured")
        return _from_model(surfaces, others, scan, notes, told)
    feet = finder.feet(scan.points, progress)
    return Deviation(
        scan.points, feet.distance, feet.point, feet.which, feet.u, feet.v, feet.edge, surfaces, notes=notes, **told
    )


def own(target: Target) -> Target:
    """Return what another tool holds as a scan or a model, and everything else as it is."""
    if isinstance(target, (Scan, Model, Patch, Surface, str, Path)):
        return target
    found: Scan | Model | None = call("foreign", target)
    return target if found is None else found


def target_of(target: Target, unit: str = "") -> Scan:
    """Return any target as a scan; see ``deviation``."""
    target = own(target)
    if isinstance(target, Scan):
        return replace(target, unit=unit) if unit else target
    if isinstance(target, (str, Path)):
        found: Scan = call("open_target", target, unit)
        return found
    if isinstance(target, (Model, Patch, Surface)):
        model = target if isinstance(target, Model) else Model("target", unit, _patches(target))
        sampled: Scan = call("sampled_target", model, unit)
        return sampled
    return scan_of(target, unit=unit)


def _patches(one: Patch | Surface) -> tuple[Patch, ...]:
    return (one if isinstance(one, Patch) else Patch.of(one),)


def _surfaces_of(target: Target) -> tuple[Surface, ...]:
    """Return the surfaces of a target that has some."""
    if isinstance(target, (str, Path)) and Path(target).suffix.lower() not in call("scan_suffixes"):
        found: Model = call("open_model", target)
        return tuple(patch.surface for patch in found.patches)
    if isinstance(target, (Model, Patch, Surface)):
        return _surfaces(target)[0]
    return ()


def _surfaces(model: Subject) -> tuple[tuple[Surface, ...], tuple[str, ...], str]:
    """Return surfaces, their names and the unit."""
    if isinstance(model, Model):
        model.refuse_curves()
        return tuple(p.surface for p in model.patches), tuple(p.name for p in model.patches), model.unit
    if isinstance(model, Patch):
        return (model.surface,), (model.name,), ""
    surfaces = (model,) if isinstance(model, Surface) else tuple(model)
    if not surfaces or not all(isinstance(one, Surface) for one in surfaces):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise ValueError("model: expected a model, a patch, a surface or several surfaces")
    names = tuple(f"surface {k}" for k in range(1, len(surfaces) + 1)) if len(surfaces) > 1 else ("surface",)
    return surfaces, names, ""


def _from_model(
    surfaces: tuple[Surface, ...], others: tuple[Surface, ...], scan: Scan, notes: tuple[str, ...], told: dict[str, Any]
) -> Deviation:
    if not others and scan.triangles is None:
        raise ValueError(
            "source: distances from the model need a mesh or surfaces to be measured to, found points without triangles"
        )
    t = np.linspace(0.0, 1.0, 65)
    u, v = (grid.ravel() for grid in np.meshgrid(t, t, indexing="ij"))
    parts: list[tuple[FloatArray, ...]] = []
    whose: list[NDArray[np.int64]] = []
    finder = Finder(surfaces)
    for index, surface in enumerate(surfaces):
        kept = surface.inside(u, v)
        here = surface(u[kept], v[kept])
        own = finder.at(here, np.full(len(here), index), u[kept], v[kept])
        parts.append((here, own.normal, u[kept], v[kept]))
        whose.append(np.full(len(here), index, dtype=np.int64))
    points, normals, us, vs = (np.concatenate(part) for part in zip(*parts, strict=True))
    if others:
        feet = Finder(others).feet(points)
        foot, edge = feet.point, feet.edge
    else:
        foot, edge = MeshFinder(scan).nearest(points)
    side = np.einsum("ij,ij->i", foot - points, normals)
    distance = np.where(side < 0.0, -1.0, 1.0) * np.linalg.norm(foot - points, axis=1)
    return Deviation(points, distance, foot, np.concatenate(whose), us, vs, edge, surfaces, notes=notes, **told)


def _far(scan: Scan, surfaces: tuple[Surface, ...]) -> tuple[str, ...]:
    """Say where the target lies so far away, or is so much smaller or larger, that a unit or a place is wrong."""
    t = np.linspace(0.0, 1.0, 9)
    cloud = np.concatenate([surface(t[:, None], t[None, :]).reshape(-1, 3) for surface in surfaces])
    cloud = cloud[np.isfinite(cloud).all(axis=1)]
    size = float(np.linalg.norm(np.ptp(cloud, axis=0)))
    notes: list[str] = []
    away = float(np.linalg.norm(scan.points.mean(axis=0) - cloud.mean(axis=0)))
    if size > 0.0 and away > 2.0 * (size + scan.size):
        notes.append(
            f"the target lies {away / size:.3g} sizes of the model away from it: align it first, or check the units"
        )
    if size > 0.0 and len(scan.points) > 3 and not 0.01 < scan.size / size < 100.0:
        notes.append(f"the target is {scan.size / size:.3g} times the model's size: check the units")
    return tuple(notes)


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2))) if len(values) else 0.0


def _numbers(values: FloatArray) -> dict[str, Any]:
    if not len(values):
        return {"points": 0, "min": None, "max": None, "mean": None, "rms": None}
    return {
        "points": len(values),
        "min": float(values.min()),
        "max": float(values.max()),
        "mean": float(values.mean()),
        "rms": _rms(values),
    }
