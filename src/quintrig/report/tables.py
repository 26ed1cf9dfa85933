"""Tables of the page: heads with symbols and units, columns of numbers whose decimal points align."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup, escape

from quintrig.analysis.agreement import REASONS, Agreement, CrossTable
from quintrig.analysis.extremes import Extreme, Extremes
from quintrig.analysis.integrate import INTEGRALS
from quintrig.analysis.summary import Summary
from quintrig.analysis.table import INVARIANTS, Column, Table
from quintrig.figure.palette import CLASS_COLOURS
from quintrig.multipatch.joins import ORDERS, Joins
from quintrig.quantities.correspondence import LEVELS, UNDEFINED
from quintrig.quantities.table import BY_KEY, CLASSES, QUANTITIES
from quintrig.report.facts import Facts, rounding
from quintrig.report.kinds import Net
from quintrig.report.mathml import mathml
from quintrig.report.wording import aligned, digits_of, measure, pair, percent, prose, ten
from quintrig.shaping.shape_effect import AS_GIVEN, Variant, intensities

LEVEL_MARKS = ("", "✓", "≈", "✗")
"""A sign for each level of agreement, so that it does not rest on colour alone."""


@dataclass(frozen=True)
class Grid:
    """A table as the page shows it: ``heads``, and ``rows`` of cells, of which ``words`` are text, not numbers."""

    caption: str
    heads: tuple[Markup, ...]
    rows: tuple[tuple[Markup, ...], ...]
    words: tuple[bool, ...]
    notes: tuple[Markup, ...] = ()


CURVATURES = tuple(q.key for q in QUANTITIES if q.key in ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness"))
POINT_TABLES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("Place and normal", ("normal",)),
    ("Curvature", CURVATURES),
    ("Types", CLASSES),
    ("The six invariants, in the metric of the horizontal plane", INVARIANTS),
    ("The six invariants, in the metric of the surface", tuple(f"{key}_surface" for key in INVARIANTS)),
    ("First and second fundamental form", ("E", "F", "G", "L", "M", "N")),
    ("Principal directions", ("direction1", "direction2")),
)
"""The tables of labelled points: title and keys; together they hold every quantity."""


def point_tables(table: Table, labels: Sequence[str]) -> tuple[Grid, ...]:
    """Split a table of every quantity at labelled points into parts that can be read."""
    by_key = {column.key: column for column in table.columns}
    lead = [("point", [Markup("<b>{}</b>").format(label) for label in labels])]
    grids: list[Grid] = []
    for index, (title, keys) in enumerate(POINT_TABLES):
        names = ["u", "v", *("xyz" if index == 0 else "")]
        for key in keys:
            names += [f"{key}_{axis}" for axis in "xyz"] if BY_KEY[key].components == 3 else [key]
        grids.append(from_columns(title, [by_key[name] for name in names], lead))
    return tuple(grids)


def from_columns(caption: str, columns: Sequence[Column], lead: Sequence[tuple[str, Sequence[Markup]]]) -> Grid:
    """Return columns as a grid, after leading columns of words."""
    heads = [prose(title) for title, _ in lead]
    cells: list[Sequence[Markup]] = [values for _, values in lead]
    words = [True] * len(lead)
    for column in columns:
        if column.is_text:
            heads.append(prose(column.name))
            cells.append([escape(str(value)) for value in column.rounded])
        else:
            power, texts = aligned([float(value) for value in column.rounded])
            heads.append(head(prose(column.symbol), column.unit, power))
            cells.append([escape(text) for text in texts])
        words.append(column.is_text)
    return Grid(caption, tuple(heads), tuple(zip(*cells, strict=True)), tuple(words))


def head(symbol: Markup, unit: str, power: int = 0) -> Markup:
    """Return the head of a column: symbol over power of ten and unit."""
    inside = [ten(power)] if power else []
    inside += [escape(unit)] if unit else []
    if not inside:
        return symbol
    return symbol + Markup('<span class="unit">{}</span>').format(Markup("\u202f").join(inside))


def extremes_table(summary: Summary) -> Grid:
    """Return least and greatest value, each with where it is taken, and the mean of every quantity of a summary."""
    rows: list[tuple[Markup, ...]] = []
    for key, found in summary.extremes.items():
        q = BY_KEY[key]
        noise = rounding(summary, key)
        values = [end.value if end.status in _REACHED else _endless(end, sign) for end, sign in _ends(found)]
        mean = found.mean
        values.append(float("inf") if mean.status == "grows without bound" else mean.value)
        power, texts = aligned([0.0 if abs(value) <= noise else value for value in values])
        least, most, average = (escape(text.strip("\u2007\u2008")) for text in texts)
        name = head(prose(f"{q.name} {q.symbol}"), q.unit(summary.unit), power)
        rows.append(
            (name, least, _place(found.minimum, summary.size), most, _place(found.maximum, summary.size), average)
        )
    unit = Markup("\u00a0") + escape(summary.unit) if summary.unit else Markup("")
    at = Markup('at (<i>u</i>, <i>v</i>)<span class="unit">(<i>x</i>, <i>y</i>, <i>z</i>){}</span>').format(unit)
    heads = (Markup("quantity"), Markup("least"), at, Markup("greatest"), at, Markup("mean"))
    remarks = [
        Markup("{}, {}: {}.").format(prose(f"{BY_KEY[key].name} {BY_KEY[key].symbol}"), end, prose(extreme.describe()))
        for key, found in summary.extremes.items()
        for end, extreme in (("least", found.minimum), ("greatest", found.maximum))
        if extreme.status != "attained"
    ]
    if any(not end.unique for found in summary.extremes.values() for end in (found.minimum, found.maximum)):
        remarks.insert(
            0, Markup("† taken at several places, of which this is the first in order of <i>u</i>, then <i>v</i>.")
        )
    return Grid("Extremes and means", heads, tuple(rows), (True, False, True, False, True, False), tuple(remarks))


_REACHED = ("attained", "approached")


def _ends(found: Extremes) -> tuple[tuple[Extreme, float], tuple[Extreme, float]]:
    return (found.minimum, -1.0), (found.maximum, 1.0)


def _endless(end: Extreme, sign: float) -> float:
    return float("nan") if end.status == "undefined" else sign * float("inf")


def _place(found: Extreme, size: float) -> Markup:
    """Return the parameters of an extreme over its point, to five digits of the size of the surface."""
    if found.status == "undefined":
        return Markup("")
    near = Markup("near ") if found.status == "unbounded" else Markup("")
    star = Markup("") if found.unique or near else Markup("\u202f†")
    decimals = 4 - math.floor(math.log10(size)) if size > 0.0 else 0
    point = Markup(",\u00a0").join(digits_of(round(float(x), decimals) + 0.0, 5) for x in found.point)
    return near + pair(found.u, found.v) + star + Markup('<span class="unit">({})</span>').format(point)


def _extreme(found: Extreme, unit: str, sign: str, noise: float) -> Markup:
    if found.status == "undefined":
        return digits_of(float("nan"))
    if found.status == "unbounded":
        return Markup(f"{sign}∞")
    return measure(0.0 if abs(found.value) <= noise else found.value, unit, 4)


def integrals_table(summary: Summary) -> Grid:
    """Return the integrals with their measured errors."""
    rows: list[tuple[Markup, ...]] = []
    for q in INTEGRALS:
        found = summary.integrals[q.key]
        unit = q.unit(summary.unit)
        grows = found.status == "grows without bound"
        value = Markup("∞") if grows else measure(0.0 if abs(found.value) <= found.error else found.value, unit, 8)
        error = escape(found.status) if not found.converged else Markup("± ") + digits_of(found.error, 1)
        name = prose(q.name) + Markup('<span class="unit says">{}</span>').format(prose(q.meaning))
        rows.append((name, mathml(q.latex), value, error))
    heads = tuple(Markup(text) for text in ("integral", "definition", "value", "error"))
    return Grid("Integrals", heads, tuple(rows), (True, True, False, False), tuple(map(prose, summary.integrals.notes)))


@dataclass(frozen=True)
class Shares:
    """How much of the area is of each class of one classification: name, colour, share 0 to 1, the share in words."""

    title: str
    rows: tuple[tuple[str, str, float, str], ...]


def shares(summary: Summary) -> tuple[Shares, ...]:
    """Return the shares of every classification."""
    return tuple(
        Shares(
            BY_KEY[key].name,
            tuple(
                (part.name, CLASS_COLOURS[key][BY_KEY[key].classes.index(part.name)], part.share, percent(part.share))
                for part in parts
            ),
        )
        for key, parts in summary.shares.items()
    )


def intensity_tables(variants: Sequence[Variant]) -> tuple[Grid, Grid]:
    """Return the intensities of several sets of shape parameters, curvatures and integrals."""
    table = intensities(variants)
    labels = [
        prose(one.parameters) + (Markup(' <span class="of">{}</span>').format(AS_GIVEN) if one.own else Markup(""))
        for one in variants
    ]
    lead = [("shape parameters", labels)]
    whole = {q.key for q in INTEGRALS}
    first = from_columns(
        "Least, greatest and mean curvature", [c for c in table.columns[1:] if c.key not in whole], lead
    )
    second = from_columns("Integrals", [c for c in table.columns[1:] if c.key in whole], lead)
    return first, replace(second, notes=tuple(prose(note) for note in table.notes))


@dataclass(frozen=True)
class Cell:
    """A cell of a cross table: its text, and the name of its level of agreement, empty where no point falls in it."""

    text: str
    level: str


@dataclass(frozen=True)
class Cross:
    """A cross table of two classifications, limited to the classes that occur."""

    rows: str
    columns: str
    heads: tuple[str, ...]
    lines: tuple[tuple[str, tuple[Cell, ...]], ...]
    verdict: str


def cross_tables(agreement: Agreement) -> tuple[Cross, ...]:
    """Return the three cross tables."""
    return tuple(_cross(table) for table in agreement.tables)


def _cross(table: CrossTable) -> Cross:
    rows = [i for i in range(len(table.row_names)) if table.counts[i].any()]
    columns = [j for j in range(len(table.column_names)) if table.counts[:, j].any()]
    lines = tuple((table.row_names[i], tuple(_cell(table, i, j) for j in columns)) for i in rows)
    above = "" if (table.rows, table.columns) == ("hk_type", "shape_class") else ", seen from above"
    verdict = ", ".join(
        f"{words} on {percent(table.share(level))}"
        for words, level in (("agree", 1), ("neighbouring", 2), ("in conflict", 3))
        if table.count(level)
    )
    heads = tuple(table.column_names[j] for j in columns)
    verdict = verdict or "nowhere defined both"
    return Cross(BY_KEY[table.rows].name + above, BY_KEY[table.columns].name, heads, lines, verdict)


def _cell(table: CrossTable, i: int, j: int) -> Cell:
    count = int(table.counts[i, j])
    if not count:
        return Cell("", "")
    level = int(table.levels[i, j])
    share = percent(float(table.shares[i, j]))
    return Cell(f"{share} {LEVEL_MARKS[level]}".strip(), LEVELS[level] if level != UNDEFINED else "undefined")


def reasons(agreement: Agreement) -> Iterable[tuple[str, str, str, Markup]]:
    """Return name, level, share and explanation of every reason that occurs."""
    for reason, share, count in zip(REASONS, agreement.shares(), agreement.counts(), strict=True):
        if count:
            yield reason.name, LEVELS[reason.level], percent(share), prose(reason.text)


def plain(net: Net) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Return the rows of a net with the decimal points of every column aligned, all digits kept."""
    columns = [aligned(values, 12)[1] if small else [f"{x:.12g}" for x in values] for values, small in _columns(net)]
    for (label, _), cells in zip(net.rows, zip(*columns, strict=True), strict=True):
        yield label, cells


def _columns(net: Net) -> Iterator[tuple[tuple[float, ...], bool]]:
    for values in zip(*(point for _, point in net.rows), strict=True):
        largest = max(abs(x) for x in values)
        yield values, largest == 0.0 or 0.01 <= largest < 1e5  # beyond, a power of ten would leave the column's head


def patches_table(every: Sequence[Facts]) -> Grid:
    """Return one row for each patch of a model with several."""
    rows: list[tuple[Markup, ...]] = []
    for one in every:
        summary = one.summary
        common = summary.shares["hk_type"][0]
        gaussian, floor = summary.extremes["gaussian"], rounding(summary, "gaussian")
        unit = BY_KEY["gaussian"].unit(one.unit)
        rows.append(
            (
                escape(one.patch.name),
                escape(one.patch.definition.title),
                measure(summary.integrals.area.value, f"{one.unit}²" if one.unit else ""),
                _extreme(gaussian.minimum, unit, "−", floor),
                _extreme(gaussian.maximum, unit, "", floor),
                escape(f"{common.name}, {percent(common.share)}"),
                escape(str(len(summary.warnings) or "none")),
            )
        )
    names = ("patch", "kind", "area", "least K", "greatest K", "most common HK type", "warnings")
    words = (True, True, False, False, False, True, False)
    return Grid("Patches", tuple(prose(name) for name in names), tuple(rows), words)


_MOST_SEAMS = 200


def seams_table(joins: Joins) -> Grid:
    """Return one row for each seam, the roughest first where there are too many for a page."""
    table = joins.table()
    notes = [prose(note) for note in table.notes]
    rows = list(range(len(joins)))
    if len(rows) > _MOST_SEAMS:
        rows = sorted(rows, key=lambda k: (ORDERS.index(joins[k].order), -joins[k].angle.most))[:_MOST_SEAMS]
        notes.append(prose(f"The {_MOST_SEAMS} roughest of {len(joins)} seams; the joins of the model list all."))
    columns = [
        replace(column, values=tuple(column.values[k] for k in rows), rounded=tuple(column.rounded[k] for k in rows))
        for column in table.columns
    ]
    return replace(from_columns("Seams", columns, ()), notes=tuple(notes))
