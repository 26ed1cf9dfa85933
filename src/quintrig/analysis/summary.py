"""Everything about one surface that a report or a comparison tells in numbers and words."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from quintrig.analysis.cautions import Singular, find_cautions, find_notes, find_singular
from quintrig.analysis.extremes import Extremes, find_extremes
from quintrig.analysis.integrate import Integrals, area_weights, integrals, orientation
from quintrig.analysis.sample import Sample, analyse
from quintrig.geometry.bounding_box import bounding_box
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import quantity
from quintrig.support.arrays import FloatArray
from quintrig.support.pickled import Pickled

EXTREMES = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness")
"""Keys of the quantities whose minimum, maximum and mean a summary holds."""
CLASSIFIED = ("point_type", "hk_type", "shape_class", "invariant_type")
"""Keys of the classifications whose shares a summary holds."""


@dataclass(frozen=True)
class ClassShare:
    """How much of a surface is of one class: share of the area, and number of samples."""

    name: str
    share: float
    count: int


@dataclass(frozen=True, eq=False)
class Summary(Pickled):
    """A surface in numbers and words.

    ``box`` (2, 3) holds the least and greatest coordinates of the samples and ``size`` the diagonal that thresholds
    refer to, length¹ in ``unit`` (empty: plain numbers). ``shares`` gives, for each of ``CLASSIFIED``, the classes that
    occur, largest first. ``thresholds`` says in words when a curvature counts as zero, ``orientation`` which way the
    normal points, ``warnings`` what to beware of, and ``notes`` what is worth knowing but no fault of the surface.
    """

    unit: str
    size: float
    box: FloatArray
    orientation: str
    thresholds: str
    integrals: Integrals
    extremes: Mapping[str, Extremes]
    shares: Mapping[str, tuple[ClassShare, ...]]
    singular: Singular
    warnings: tuple[str, ...]
    notes: tuple[str, ...]

    def __repr__(self) -> str:
        """Return one line: area, ranges of K and H, and how many warnings there are."""
        ends = ((key, self.extremes[key]) for key in ("gaussian", "mean"))
        ranges = "; ".join(f"{key} from {one.minimum.value:.4g} to {one.maximum.value:.4g}" for key, one in ends)
        area = f"area {self.integrals.area.value:.4g}{f' {self.unit}²' if self.unit else ''}"
        return f"<Summary: {area}; {ranges}; {len(self.warnings)} warnings>"


def summarise(
    surface: Surface,
    unit: str = "",
    thresholds: Thresholds | None = None,
    samples: int = 65,
    tolerance: float = 1e-9,
) -> Summary:
    """Return the summary of a surface.

    ``samples`` a side are classified and searched for extremes; ``tolerance`` is that of the integrals.
    Of a trimmed face it is that of the face; ``surface.carrier`` is all of its surface. Raises ValueError for fewer
    than 2 samples or an unfit tolerance.
    """
    u, v = face_grid(surface, samples, samples)
    keys = ("point", "normal", "mean", "E", "F", "G", *CLASSIFIED)
    sample = analyse(surface, u, v, keys, thresholds=thresholds)
    found = integrals(surface, tolerance)
    extremes = find_extremes(surface, EXTREMES, samples)
    weights = area_weights(sample)
    shares = {key: class_shares(sample, key, weights) for key in CLASSIFIED}
    box = bounding_box(surface, u[:, 0], v[0], sample.point)
    singular = find_singular(sample)
    size = sample.size
    words = sample.thresholds.describe(size, unit) if size > 0.0 else "none: the surface is a single point"
    return Summary(
        unit,
        size,
        box,
        orientation(surface),
        words,
        found,
        MappingProxyType(extremes),
        MappingProxyType(shares),
        singular,
        (
            *find_cautions(surface, sample, extremes, unit),
            *(found.cautions if singular.count < sample.singular.size else ()),
        ),
        find_notes(sample),
    )


def class_shares(sample: Sample, key: str, weights: FloatArray) -> tuple[ClassShare, ...]:
    """Return the classes of ``key`` that occur in a grid sample, largest first; ``weights`` from ``area_weights``."""
    names = quantity(key).classes
    inside = sample.surface.inside(sample.u, sample.v)
    codes, weights = sample[key][inside], weights[inside]
    counts = np.bincount(codes, minlength=len(names))
    areas = np.zeros(len(names))
    np.add.at(areas, codes, weights)
    found = [ClassShare(names[i], float(areas[i]), int(counts[i])) for i in range(len(names)) if counts[i]]
    return tuple(sorted(found, key=lambda part: (-part.share, -part.count)))
