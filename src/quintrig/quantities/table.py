"""The one table of quantities: what tables, plots, legends, help texts and documentation say of each."""

from dataclasses import dataclass
from typing import Literal

from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, POINT_TYPES, SHAPE_CLASSES
from quintrig.support.errors import ArgumentError, nearest

Parity = Literal["even", "odd", "swap", "mirror"]
"""What turning the normal does: nothing, a new sign, exchange with ``partner`` (κ1 ↔ -κ2), the mirrored class."""

Kind = Literal["scalar", "vector", "class"]
"""What is at a point: a number, three of them, or the code of a class."""

Colour = Literal["diverging", "sequential", "classes", "vector"]


@dataclass(frozen=True)
class Quantity:
    """One row of the table: ``power`` is the power of length in the unit, ``classes`` names the codes 0, 1, ..., n."""

    key: str
    symbol: str
    latex: str
    name: str
    meaning: str
    source: str
    power: int
    parity: Parity
    colour: Colour
    partner: str = ""
    classes: tuple[str, ...] = ()
    kind: Kind = "scalar"

    @property
    def components(self) -> int:
        """3 for a vector, else 1."""
        return 3 if self.kind == "vector" else 1

    def unit(self, length: str) -> str:
        """Return the unit in text, such as ``1/mm²``; empty for a pure number or where the model has no unit."""
        if not length or self.power == 0:
            return ""
        raised = length + {1: "", 2: "²", 3: "³"}[abs(self.power)]
        return raised if self.power > 0 else f"1/{raised}"


_PLANE = "in the metric of the horizontal plane (the definition for a height field)"
_OWN = "in the metric of the surface"
_FUJITA = "Fujita and Ohsaki 2009; Iri et al. 2001"
_CARMO = "do Carmo 1976, §2.5-3.3"
_LARGER = "the most that the surface bends towards the normal: H + R, R = (κ1 - κ2)/2"
_SMALLER = "the least that it bends towards the normal, or the most away from it: H - R, R = (κ1 - κ2)/2"


def _invariants(suffix: str, mark: str, metric: str) -> tuple[Quantity, ...]:
    rows = (
        ("beta0", "β0", r"\beta_0", "squared slope", "square of the slope", 0),
        ("beta1", "β1", r"\beta_1", "Laplacian of the height", "bowl-like (+) or roof-like (-)", -1),
        ("beta2", "β2", r"\beta_2", "Hessian determinant", "dome or bowl (+), developable (0), saddle (-)", -2),
        (
            "gamma1",
            "γ1",
            r"\gamma_1",
            "bending along steepest descent",
            "slope eases (+) or steepens (-) downhill; weighted by slope²",
            -1,
        ),
        (
            "gamma2",
            "γ2",
            r"\gamma_2",
            "twist of steepest descent",
            "0 on crest and trough lines; weighted by slope²",
            -1,
        ),
        (
            "gamma3",
            "γ3",
            r"\gamma_3",
            "bending along the contour",
            "hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope²",
            -1,
        ),
    )
    return tuple(
        Quantity(
            key + suffix,
            symbol + mark,
            latex + (r"^{S}" if mark else ""),
            name,
            f"{meaning}, {metric}",
            _FUJITA,
            power,
            "even",
            "diverging" if key != "beta0" else "sequential",
        )
        for key, symbol, latex, name, meaning, power in rows
    )


QUANTITIES: tuple[Quantity, ...] = (
    Quantity(
        "point",
        "S(u, v)",
        r"\mathbf{S}(u,v)",
        "point",
        "position",
        "thesis eq. 3.1",
        1,
        "even",
        "vector",
        kind="vector",
    ),
    Quantity(
        "normal", "n", r"\mathbf{n}", "unit normal", "S_u × S_v, normalised", _CARMO, 0, "odd", "vector", kind="vector"
    ),
    Quantity("E", "E", "E", "first form E", "S_u · S_u", _CARMO, 2, "even", "sequential"),
    Quantity("F", "F", "F", "first form F", "S_u · S_v", _CARMO, 2, "even", "diverging"),
    Quantity("G", "G", "G", "first form G", "S_v · S_v", _CARMO, 2, "even", "sequential"),
    Quantity("L", "L", "L", "second form L", "S_uu · n", _CARMO, 1, "odd", "diverging"),
    Quantity("M", "M", "M", "second form M", "S_uv · n", _CARMO, 1, "odd", "diverging"),
    Quantity("N", "N", "N", "second form N", "S_vv · n", _CARMO, 1, "odd", "diverging"),
    Quantity(
        "gaussian",
        "K",
        "K",
        "Gaussian curvature",
        "dome or bowl (+), developable (0), saddle (-)",
        _CARMO,
        -2,
        "even",
        "diverging",
    ),
    Quantity(
        "mean",
        "H",
        "H",
        "mean curvature",
        "bends towards the normal (+) or away from it (-)",
        _CARMO,
        -1,
        "odd",
        "diverging",
    ),
    Quantity(
        "k1", "κ1", r"\kappa_1", "larger principal curvature", _LARGER, _CARMO, -1, "swap", "diverging", partner="k2"
    ),
    Quantity(
        "k2", "κ2", r"\kappa_2", "smaller principal curvature", _SMALLER, _CARMO, -1, "swap", "diverging", partner="k1"
    ),
    Quantity(
        "direction1",
        "d1",
        r"\mathbf{d}_1",
        "direction of κ1",
        "unit tangent, NaN at umbilics",
        _CARMO,
        0,
        "swap",
        "vector",
        kind="vector",
        partner="direction2",
    ),
    Quantity(
        "direction2",
        "d2",
        r"\mathbf{d}_2",
        "direction of κ2",
        "unit tangent, NaN at umbilics",
        _CARMO,
        0,
        "swap",
        "vector",
        kind="vector",
        partner="direction1",
    ),
    Quantity(
        "shape_index",
        "S",
        "S",
        "shape index",
        "cup -1, rut -1/2, saddle 0, ridge +1/2, cap +1 (n towards the viewer)",
        "Koenderink and van Doorn 1992",
        0,
        "odd",
        "diverging",
    ),
    Quantity(
        "curvedness",
        "C",
        "C",
        "curvedness",
        "how strongly it bends, whatever the shape",
        "Koenderink and van Doorn 1992",
        -1,
        "even",
        "sequential",
    ),
    *_invariants("", "", _PLANE),
    *_invariants("_surface", "ˢ", _OWN),
    Quantity(
        "point_type",
        "point type",
        r"\mathrm{type}",
        "point type",
        "signs of κ1 and κ2",
        "thesis table 3.1",
        0,
        "even",
        "classes",
        kind="class",
        classes=POINT_TYPES,
    ),
    Quantity(
        "hk_type",
        "HK type",
        "HK",
        "HK type",
        "signs of K and H, n towards the viewer",
        "Besl and Jain 1986; thesis table 3.2",
        0,
        "mirror",
        "classes",
        kind="class",
        classes=HK_TYPES,
    ),
    Quantity(
        "shape_class",
        "shape class",
        r"S\,\mathrm{class}",
        "shape class",
        "nine ranges of the shape index",
        "Koenderink and van Doorn 1992; thesis table 3.3",
        0,
        "mirror",
        "classes",
        kind="class",
        classes=SHAPE_CLASSES,
    ),
    Quantity(
        "invariant_type",
        "invariant type",
        r"\beta\,\mathrm{type}",
        "invariant type",
        "signs of β1 and β2, seen from above",
        "Fujita and Ohsaki 2009; thesis table 3.4",
        0,
        "even",
        "classes",
        kind="class",
        classes=INVARIANT_TYPES,
    ),
)
"""Every quantity, in the order of tables."""

BY_KEY: dict[str, Quantity] = {quantity.key: quantity for quantity in QUANTITIES}

SCALARS: tuple[str, ...] = tuple(q.key for q in QUANTITIES if q.kind == "scalar")
"""Keys of the real-valued quantities, which can be drawn as a colour."""

CLASSES: tuple[str, ...] = tuple(q.key for q in QUANTITIES if q.kind == "class")
"""Keys of the classifications, stored as int8 codes."""


_GREEK = str.maketrans({"κ": "kappa", "β": "beta", "γ": "gamma", **{c: str(i) for i, c in enumerate("₀₁₂₃")}})


def _spelled(symbol: str) -> str:
    """Return a symbol as one types it: κ1, κ₁ and kappa_1 are one, with braces and backslashes of LaTeX or without."""
    return symbol.strip().translate(_GREEK).translate(dict.fromkeys(map(ord, "\\_{}")))


_BY_SYMBOL = {_spelled(symbol): q for q in reversed(QUANTITIES) for symbol in (q.latex, q.symbol)}


def quantity(name: str) -> Quantity:
    """Return the row of a key or a symbol such as K, κ1, β0 or beta_0; ValueError with the nearest names."""
    if name in BY_KEY:
        return BY_KEY[name]
    symbol = _spelled(name)
    found = _BY_SYMBOL.get(symbol) or BY_KEY.get(name.lower()) or _BY_SYMBOL.get(symbol.upper())
    if found is None:
        raise ArgumentError(
            f"unknown quantity {name[:40]!r}{_near(name, symbol)}",
            remedy="quintrig.quantities.table.QUANTITIES has all",
            key="quantities",
        )
    return found


def _near(name: str, symbol: str) -> str:
    """Return a hint: what is spelt most alike, else symbols of the same letter, else some that are often asked for."""
    alike = [q.symbol for spelt, q in _BY_SYMBOL.items() if spelt[:1] == symbol[:1] and len(symbol) <= len(spelt) + 1]
    usual = f"; such as {', '.join([*dict.fromkeys(alike)][:4] or ['K', 'H', 'κ1', 'κ2', 'S', 'C'])}"
    return nearest(name, [*BY_KEY, *(q.symbol for q in QUANTITIES)]) or usual


def mirrored(key: str, code: int) -> int:
    """Return the code that a class becomes when the normal is turned."""
    if BY_KEY[key].parity != "mirror" or code == 0:
        return code
    if key == "shape_class":
        return code if code == 10 else 10 - code
    return code + 6 if code <= 3 else code - 6 if code >= 7 else code
