"""What signs say: the thesis's tables 3.1 to 3.4 as data, with the names of ``classify``.

The thesis's own tables are printed in a part of it that this project does not have; these are derived from the
definitions of its sources: do Carmo 1976, Besl and Jain 1986, Koenderink and van Doorn 1992, Fujita and Ohsaki 2009.
"""

from dataclasses import dataclass
from fractions import Fraction

from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, SHAPE_CLASSES


@dataclass(frozen=True)
class SignTable:
    """A table in words: ``number`` in the thesis, title, source, the heads of the columns, the rows."""

    number: str
    title: str
    source: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


POINTS = SignTable(
    "3.1",
    "Local geometry of a surface at a point",
    "do Carmo 1976, §3.2-3.3",
    ("point type", "K", "κ1 and κ2", "H", "nearby the surface"),
    (
        ("elliptic", "+", "same sign", "≠ 0", "lies on one side of the tangent plane, like an egg"),
        ("umbilic", "+", "equal, not 0", "≠ 0", "bends alike in all directions, like a sphere"),
        ("hyperbolic", "-", "opposite signs", "any", "crosses the tangent plane, like a saddle"),
        ("parabolic", "0", "one of them 0", "≠ 0", "bends in one direction only, like a cylinder"),
        ("planar", "0", "both 0", "0", "is flat to second order, like a plane"),
    ),
)

_HK_WORDS = {
    "peak": "bulges towards the normal in all directions",
    "ridge": "bulges towards the normal in one direction, straight in the other",
    "saddle ridge": "saddle that mostly bulges towards the normal",
    "flat": "plane",
    "minimal": "saddle, equally bent both ways",
    "impossible": "cannot occur, since H² >= K",
    "pit": "hollow in all directions",
    "valley": "hollow in one direction, straight in the other",
    "saddle valley": "saddle that is mostly hollow",
}

TYPES = SignTable(
    "3.2",
    "Types of surface from the signs of mean and Gaussian curvature, the normal towards the viewer",
    "Besl and Jain 1986",
    ("HK type", "H", "K", "seen from the side the normal points to"),
    # The codes are Besl's numbers 1 + 3 (1 + sgn H) + (1 - sgn K).
    tuple(
        (HK_TYPES[code], "-0+"[(code - 1) // 3], "+0-"[(code - 1) % 3], _HK_WORDS[HK_TYPES[code]])
        for code in range(1, 10)
    ),
)


def _range(code: int) -> str:
    low, high = Fraction(2 * code - 11, 8), Fraction(2 * code - 9, 8)
    low, high = max(low, Fraction(-1)), min(high, Fraction(1))
    # A break belongs to the class nearer to the saddle, as in ``classify.shape_class``.
    left = "[" if code <= 5 else "("
    right = "]" if code >= 5 else ")"
    return f"{left}{low}, {high}{right}"


_SHAPE_WORDS = (
    "hollow of a sphere, S = -1",
    "hollow, more bent one way",
    "gutter, S = -1/2",
    "gutter with a sagging axis",
    "symmetric saddle, S = 0",
    "crest with a sagging axis",
    "crest, S = +1/2",
    "bulge, more bent one way",
    "bulge of a sphere, S = +1",
)

CLASSES = SignTable(
    "3.3",
    "Classes of the shape index S",
    "Koenderink and van Doorn 1992",
    ("shape class", "S", "shape, the normal towards the viewer"),
    (
        *((SHAPE_CLASSES[code], _range(code), _SHAPE_WORDS[code - 1]) for code in range(1, 10)),
        (SHAPE_CLASSES[10], "undefined", "plane, κ1 = κ2 = 0"),
    ),
)

INVARIANTS = SignTable(
    "3.4",
    "What the signs of the six algebraic invariants say of a surface seen as a height field z(x, y)",
    "Fujita and Ohsaki 2009; Iri et al. 2001",
    ("invariant", "negative", "zero", "positive"),
    (
        ("β0", "cannot occur", "level: a top, a bottom or a pass", "sloping"),
        (
            "β1",
            "roof-like: falls away on the whole",
            "bends up and down alike, or not at all",
            "bowl-like: rises on the whole",
        ),
        ("β2", "saddle", "developable, bends in one direction at most", "dome (β1 < 0) or bowl (β1 > 0)"),
        (
            "γ1",
            "the slope steepens downhill (bulging profile)",
            "straight profile, or level",
            "the slope eases downhill (hollow profile)",
        ),
        (
            "γ2",
            "the way of steepest ascent turns right, seen from above",
            "it does not turn: a crest or trough line, or level",
            "the way of steepest ascent turns left",
        ),
        (
            "γ3",
            "spur: falls to both sides along the contour line, which bends uphill",
            "straight contour line, or level",
            "hollow: rises to both sides along the contour line, which bends downhill",
        ),
    ),
)

HEIGHTS = SignTable(
    "3.4 (types)",
    "Types of surface from the signs of β1 and β2, seen from above",
    "Fujita and Ohsaki 2009",
    ("invariant type", "β1", "β2"),
    tuple((INVARIANT_TYPES[code], "-0+"[(code - 1) // 3], "+0-"[(code - 1) % 3]) for code in range(1, 10)),
)

SIGN_TABLES: tuple[SignTable, ...] = (POINTS, TYPES, CLASSES, INVARIANTS, HEIGHTS)
"""Thesis tables 3.1 to 3.4, in order; the last is the part of 3.4 that ``classify.INVARIANT_TYPES`` names."""
