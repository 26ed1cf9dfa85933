"""Flat patterns: a developable strip laid out in the plane without stretching, and the proof that nothing stretched.

On a developable the normal n is the same all along a ruling. With e the ruling's direction and g = n x e, the pattern
follows from integrating along the strip (do Carmo 1976, §4-4: isometries keep geodesic curvature)

    θ' = e'·g,     a' = (A'·e) e(θ) + (A'·g) e⊥(θ),     b = a + |B - A| e(θ),

A and B the boundaries, a and b their images. The integrals are spectral, so lengths agree to rounding.
"""

from dataclasses import dataclass, replace

import numpy as np

from quintrig.developables.loops import face_area, flat_loops, loops_area
from quintrig.developables.panels import Panels
from quintrig.developables.rulings import Rulings, rulings
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import rounding

ALLOWED = 1e-9
"""Largest relative change of a length or of the area, beside rounding, that still counts as none."""

_MOST_PANELS = 2048


@dataclass(frozen=True)
class Sheet:
    """The material: ``thickness``, length¹; the neutral layer lies ``k_factor`` of it from the inside of a bend.

    ``side`` says where the model's surface is in the sheet: in its ``middle``, or its face on the ``back`` or the
    ``front``, seen along the normal: with ``back`` the sheet lies on the side the normal points to.
    """

    thickness: float = 0.0
    k_factor: float = 0.5
    side: str = "middle"

    def __post_init__(self) -> None:
        """Check once that the values make sense."""
        if not 0.0 <= self.thickness < np.inf:
            raise ValueError(f"thickness: expected a length of 0 or more, found {self.thickness:g}")
        if not 0.0 <= self.k_factor <= 1.0:
            raise ValueError(f"k-factor: expected 0 to 1, found {self.k_factor:g}")
        if self.side not in ("middle", "back", "front"):
            raise ValueError(f"side: expected middle, back or front, found {self.side!r}")

    def offset(self, upward: BoolArray) -> FloatArray:
        """Return where along the normal the neutral layer lies, length¹; ``upward``: the sheet bends towards it."""
        middle = {"middle": 0.0, "back": 0.5, "front": -0.5}[self.side]
        inner = np.where(upward, 0.5 - self.k_factor, self.k_factor - 0.5)
        return self.thickness * (middle + inner)


@dataclass(frozen=True)
class Isometry:
    """Lengths of both boundaries and area of the neutral layer, and their relative changes in the pattern.

    Of a trimmed face the area is that of the face, its change that of the polygons.
    """

    first: float
    second: float
    area: float
    first_change: float
    second_change: float
    ruling_change: float
    area_change: float

    @property
    def worst(self) -> float:
        """The largest relative change."""
        return max(self.first_change, self.second_change, self.ruling_change, self.area_change)


@dataclass(frozen=True, eq=False)
class Pattern:
    """A flat pattern, seen from the side that the normal points to.

    At parameters ``t`` (n,) along the strip: the boundary points ``first`` and ``second`` (n, 2), length¹, and ``bend``
    (n,), by how much the normal has turned since t = 0 in radians, counted without sign; ``upward`` (n,) tells where
    the sheet bends towards the viewer. ``along`` names the parameter, ``u`` or ``v``. A trimmed face has ``loops``
    (n, 2) too, its outline and holes, and lies between the two values ``span`` of the parameter.
    """

    t: FloatArray
    first: FloatArray
    second: FloatArray
    bend: FloatArray
    upward: BoolArray
    along: str
    sheet: Sheet
    isometry: Isometry
    loops: tuple[FloatArray, ...] = ()
    span: tuple[float, float] = (0.0, 1.0)

    @property
    def outline(self) -> FloatArray:
        """The closed outline, counter-clockwise, (n, 2); the longest loop of a trimmed face."""
        strip = np.concatenate([self.first, self.second[::-1]])
        loop = max(self.loops, key=_perimeter, default=strip)
        x, y = loop.T
        turns = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum()
        return loop if turns > 0.0 else loop[::-1]


def unroll(
    surface: Surface, sheet: Sheet | None = None, *, chord: float | None = None, allowed: float = ALLOWED
) -> Pattern:
    """Return the flat pattern of a developable surface with straight rulings along u or v.

    Its polygons are within ``chord`` (length¹, by default 1e-5 of the size) of the true outline. That of a trimmed
    face has its outline and holes (``surface.carrier`` gives that of the whole strip). Raises ValueError for
    a single point, a surface without straight rulings, one that is not developable, with the measured distortion, and
    one whose edge of regression lies inside the strip, with the parameters between which it does.
    """
    if not surface.size > 0.0:
        raise ValueError("all of the surface is a single point, which has no flat pattern")
    sheet = sheet or Sheet()
    lines = rulings(surface, sheet.offset)
    size = surface.size
    corners = np.array([0.0, 0.5, 1.0])
    rounded = rounding(surface(corners[:, None], corners))
    panels = Panels(lines, 4)
    while True:
        finer = Panels(lines, 2 * panels.per_piece)
        moved = np.abs(finer.end - panels.end).max()
        panels = finer
        if moved <= 1e-13 * size + rounded or panels.per_piece >= _MOST_PANELS:
            break
    isometry = _isometry(lines, panels)
    if not isometry.worst <= allowed + rounded / size:
        raise ValueError(_refusal(lines, isometry, allowed))
    t = _sites(panels, chord if chord is not None else 1e-5 * size)
    span = window(surface.trim)[:, 0 if lines.along == "u" else 1]
    t = np.union1d(t, span)  # bend lines of a trimmed face start and end there
    first, second, bend, upward = panels.at(t)
    pattern = Pattern(t, first, second, bend, upward, lines.along, sheet, isometry)
    return _trimmed(pattern, lines, panels, chord if chord is not None else 1e-5 * size) if surface.trim else pattern


def _trimmed(pattern: Pattern, lines: Rulings, panels: Panels, chord: float) -> Pattern:
    """Return the pattern with the loops of the face, and their area in place of the whole strip's."""
    surface = lines.surface
    loops = flat_loops(lines, panels, chord)
    area = face_area(lines)
    if not area > 0.0:
        raise ValueError("the trim loops hold no area; export the face again")
    change = abs(loops_area(surface, loops) - area) / area
    low, high = window(surface.trim)[:, 0 if lines.along == "u" else 1].tolist()
    isometry = replace(pattern.isometry, area=area, area_change=change)
    return replace(pattern, loops=loops, span=(low, high), isometry=isometry)


def _perimeter(loop: FloatArray) -> float:
    return float(np.sqrt(((loop - np.roll(loop, 1, axis=0)) ** 2).sum(-1)).sum())


def _isometry(lines: Rulings, panels: Panels) -> Isometry:
    """Compare pattern and surface: lengths by differentiating the pattern's curves, the area by Green's theorem."""
    local = lines.at(panels.t.ravel())
    shape = panels.t.shape
    first_speed, second_speed = local.speed.reshape(2, *shape)
    first_slope, second_slope = panels.slopes(panels.first), panels.slopes(panels.second)
    first, second = panels.total(first_speed), panels.total(second_speed)
    flat_first = panels.total(np.sqrt((first_slope**2).sum(-1)))
    flat_second = panels.total(np.sqrt((second_slope**2).sum(-1)))
    gaps = np.sqrt(((panels.second - panels.first) ** 2).sum(-1))
    area = panels.total(local.area.reshape(shape))
    # Green's theorem: the strip between the boundaries, the end rulings being straight.
    sweep = panels.total(_cross(panels.first, first_slope) - _cross(panels.second, second_slope))
    start, end, _, _ = panels.at(np.array([0.0, 1.0]))
    flat_area = 0.5 * abs(sweep + float(_cross(start[1], end[1]) - _cross(start[0], end[0])))
    longest = max(first, second)
    return Isometry(
        first,
        second,
        area,
        abs(flat_first - first) / longest,
        abs(flat_second - second) / longest,
        float(np.abs(gaps / local.length.reshape(shape) - 1.0).max()),
        abs(flat_area - area) / area,
    )


def _refusal(lines: Rulings, isometry: Isometry, allowed: float) -> str:
    twist = np.degrees(lines.twist)
    return (
        f"the surface is not developable: flattened, its boundaries would change by {100 * isometry.first_change:.3g} "
        f"% and {100 * isometry.second_change:.3g} % in length and its area by {100 * isometry.area_change:.3g} %, "
        f"more than the {100 * allowed:.3g} % allowed; its normal turns by up to {twist:.3g}° along a ruling"
    )


def _sites(panels: Panels, chord: float) -> FloatArray:
    """Return parameters whose polygons are within ``chord`` of both boundaries, panel edges included."""
    t = panels.edges
    for _ in range(30):
        inner = [t[:-1] + share * np.diff(t) for share in (0.25, 0.5, 0.75)]
        first, second, _, _ = panels.at(t)
        far = np.zeros(len(t) - 1)
        for sites in inner:
            a, b, _, _ = panels.at(sites)
            far = np.maximum(far, np.maximum(_off(a, first), _off(b, second)))
        if far.max() <= chord:
            return t
        t = np.sort(np.concatenate([t, inner[1][far > chord]]))
    return t


def _off(points: FloatArray, polygon: FloatArray) -> FloatArray:
    along = np.diff(polygon, axis=0)
    length = np.sqrt((along**2).sum(-1))
    away = np.abs(_cross(along, points - polygon[:-1]))
    near = np.sqrt(((points - polygon[:-1]) ** 2).sum(-1))
    return np.divide(away, length, out=near, where=length > 0.0)


def _cross(x: FloatArray, y: FloatArray) -> FloatArray:
    return x[..., 0] * y[..., 1] - x[..., 1] * y[..., 0]
