"""Tables of quantities: the right numbers, every digit in CSV and JSON, readable Markdown and LaTeX."""

import csv
import json
import math
import re

import numpy as np
import pytest

import quintrig
from quintrig.analysis.table import STANDARD, tabulate
from quintrig.exchange.latex import to_latex
from quintrig.exchange.tables import WRITERS, shown, to_csv, to_json, to_markdown
from quintrig.quantities.table import BY_KEY, QUANTITIES

SECTION = [[0, 0, 0], [2, 0, 1], [4, 0, 3], [6, 0, 3], [8, 0, 1], [10, 0, 0]]
TRAJECTORY = [[0, 0, 0], [0, 1, 3], [0, 3, 5], [0, 5, 5], [0, 7, 3], [0, 8, 0]]
SWEPT = quintrig.swept(SECTION, TRAJECTORY, (1, 0, -2, -3))


def column(table, key):
    return next(one for one in table.columns if one.key == key)


def test_a_sphere_has_the_curvatures_of_its_closed_form():
    table = tabulate(quintrig.sphere(20.0), 0.3, [0.1, 0.9], unit="mm")
    np.testing.assert_allclose(column(table, "gaussian").values, 1 / 400, rtol=1e-12)
    np.testing.assert_allclose(column(table, "mean").values, -1 / 20, rtol=1e-12)
    assert column(table, "shape_class").values == ("spherical cap", "spherical cap")
    assert column(table, "point_type").values == ("umbilic", "umbilic")


def test_every_quantity_is_what_analyse_gives():
    u, v = [0.0, 0.25, 1.0], [0.5, 0.75, 0.0]
    keys = [q.key for q in QUANTITIES]
    table = tabulate(SWEPT, u, v, keys, metric="planar")
    sample = quintrig.analyse(SWEPT, u, v)
    assert column(table, "u").values == tuple(u)
    assert column(table, "v").values == tuple(v)
    for q in QUANTITIES:
        if q.key == "point":
            found = np.transpose([column(table, axis).values for axis in "xyz"])
        elif q.components == 3:
            found = np.transpose([column(table, f"{q.key}_{axis}").values for axis in "xyz"])
        elif q.colour == "classes":
            found = [q.classes.index(name) for name in column(table, q.key).values]
        else:
            found = column(table, q.key).values
        np.testing.assert_array_equal(found, sample[q.key])


def test_without_keys_it_holds_all_that_the_thesis_tabulates():
    keys = [one.key for one in tabulate(SWEPT, 0.5, 0.5).columns]
    assert keys == ["u", "v", "x", "y", "z", *STANDARD]
    assert {"gaussian", "mean", "k1", "k2", "shape_index", "curvedness"} <= set(keys)
    assert {"point_type", "hk_type", "shape_class", "invariant_type"} <= set(keys)
    assert {"beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3"} <= set(keys)


def test_a_grid_is_listed_row_by_row():
    table = tabulate(SWEPT, *quintrig.grid(2, 3), ["gaussian"])
    assert column(table, "u").values == (0.0, 0.0, 0.0, 1.0, 1.0, 1.0)
    assert column(table, "v").values == (0.0, 0.5, 1.0, 0.0, 0.5, 1.0)
    one = quintrig.analyse(SWEPT, 1.0, 0.5, ["gaussian"])["gaussian"]
    assert column(table, "gaussian").values[4] == pytest.approx(float(one), rel=1e-12)


@pytest.mark.parametrize(
    ("metric", "keys"),
    [
        ("planar", ["beta1"]),
        ("surface", ["beta1_surface"]),
        ("both", ["beta1", "beta1_surface"]),
    ],
)
def test_the_metric_chooses_the_invariants(metric, keys):
    table = tabulate(SWEPT, 0.2, 0.3, ["beta1"], metric=metric)
    assert [one.key for one in table.columns[5:]] == keys


def test_units_stand_in_the_headings():
    table = tabulate(SWEPT, 0.5, 0.5, unit="mm")
    headings = [one.heading for one in table.columns]
    assert headings[:6] == ["u", "v", "x (mm)", "y (mm)", "z (mm)", "K (1/mm²)"]
    assert "κ1 (1/mm)" in headings
    assert "S" in headings


@pytest.mark.parametrize("form", ["csv", "json", "md", "latex"])
def test_every_form_states_unit_normal_metric_and_what_is_zero(form):
    text = WRITERS[form](tabulate(SWEPT, 0.5, 0.5, unit="cm", title="Canopy"))
    assert "Canopy" in text
    assert "Lengths in cm" in text
    assert "normal" in text
    assert "along" in text
    assert "metric of the horizontal plane" in text
    assert "flat where the curvedness" in text


def test_a_turned_normal_is_said_and_turns_the_signs():
    turned = quintrig.swept(SECTION, TRAJECTORY, (1, 0, -2, -3), flip=True)
    table, other = tabulate(SWEPT, 0.5, 0.5), tabulate(turned, 0.5, 0.5)
    assert any("against S_u × S_v" in note for note in other.notes)
    assert not any("against S_u × S_v" in note for note in table.notes)
    assert column(other, "mean").values[0] == -column(table, "mean").values[0]


def test_without_a_unit_it_says_so():
    table = tabulate(SWEPT, 0.5, 0.5)
    assert table.notes[0] == "Lengths are plain numbers: the model states no unit."
    assert not any(one.unit for one in table.columns)


def test_csv_gives_every_number_back():
    table = tabulate(SWEPT, *quintrig.grid(4, 3), unit="mm", title="a, b\nc")
    lines = [line for line in to_csv(table).splitlines() if not line.startswith("#")]
    rows = list(csv.reader(lines))
    assert rows[0] == [one.key for one in table.columns]
    assert len(rows) == 13
    for row, values in zip(rows[1:], table.rows, strict=True):
        assert all(
            cell == value if isinstance(value, str) else float(cell) == value
            for cell, value in zip(row, values, strict=True)
        )


def test_json_gives_every_number_back():
    table = tabulate(SWEPT, *quintrig.grid(3, 3), unit="mm")
    document = json.loads(to_json(table))
    keys = [one["key"] for one in document["columns"]]
    assert [tuple(row[key] for key in keys) for row in document["rows"]] == list(table.rows)
    assert next(one for one in document["columns"] if one["key"] == "gaussian")["unit"] == "1/mm²"


def test_singular_points_are_empty_null_or_a_dash_and_counted():
    table = tabulate(quintrig.sphere(), [0.0, 0.5], 0.25, ["gaussian"])
    assert math.isnan(column(table, "gaussian").values[0])
    assert any(note.startswith("1 of 2 points is singular") for note in table.notes)
    last = [line for line in to_csv(table).splitlines() if not line.startswith("#")]
    assert list(csv.reader(last))[1][-1] == ""
    assert json.loads(to_json(table))["rows"][0]["gaussian"] is None
    assert to_markdown(table).splitlines()[-2].endswith("| – |")
    assert "-- \\\\" in to_latex(table)


def test_infinite_invariants_stay_infinite():
    # A vertical tangent plane: the height is no function of x and y there.
    table = tabulate(quintrig.torus(3, 1), 0.0, 0.0, ["beta0"])
    assert column(table, "beta0").values == (math.inf,)
    assert to_csv(table).splitlines()[-1].endswith(",inf")
    strict = json.loads(to_json(table), parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    assert strict["rows"][0]["beta0"] == "inf"
    assert "∞" in to_markdown(table)
    assert r"$\infty$" in to_latex(table)


def test_rounding_is_shown_as_zero_but_kept_in_the_data():
    # The same profile along a slanting line: a cylinder, so K = 0, and what is computed is rounding.
    profile = ((0, 0), (1, 7), (4, 9), (6, 9), (9, 7), (10, 0))
    vault = quintrig.tensor([[[x + 0.1 * i, 1.7 * i, z + 0.3 * i] for x, z in profile] for i in range(6)])
    table = tabulate(vault, *quintrig.grid(5, 5), ["gaussian"])
    k = column(table, "gaussian")
    assert any(k.values)
    assert not any(k.rounded)
    assert max(map(abs, k.values)) < 1e-13


def test_small_but_real_values_are_shown():
    # K = 1e-12 of a sphere of radius 1e6 is no rounding.
    k = column(tabulate(quintrig.sphere(1e6), 0.4, 0.2, ["gaussian"]), "gaussian")
    assert k.rounded == k.values
    assert k.rounded[0] == pytest.approx(1e-12, rel=1e-10)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (1 / 3, "0.333333"),
        (-123456.789, "-123457"),
        (1.5e-9, "1.5e-9"),
        (2e20, "2e20"),
        (math.nan, "–"),
        (-math.inf, "−∞"),
        ("pit", "pit"),
    ],
)
def test_people_read_six_figures(value, text):
    assert shown(value) == text


def test_markdown_is_one_table_with_a_cell_for_every_column():
    table = tabulate(SWEPT, *quintrig.grid(3, 2), title="Bars | and *stars*")
    lines = [line for line in to_markdown(table).splitlines() if line.startswith("|")]
    assert len(lines) == 2 + 6
    assert {line.count("|") for line in lines} == {len(table.columns) + 1}
    assert r"**Bars \| and \*stars\***" in to_markdown(table)


def test_markdown_takes_nothing_of_a_title_or_unit_for_its_own():
    title = "A & B [see](x) <b> $m$ `c` ~~d~~ \\ |e| _f_\nline"
    text = to_markdown(tabulate(SWEPT, 0.5, 0.5, ["gaussian"], title=title, unit="m|m & $x$"))
    first = text.splitlines()[0]
    assert first.startswith("**A ")
    assert first.endswith("line**")
    bare = re.sub(r"\\.", "", text.replace("**", ""))  # without what is escaped
    bare = "".join(line for line in bare.splitlines(keepends=True) if not line.startswith("|"))
    assert not set("&[]<>$`~|_*\\") & set(bare)
    row = next(line for line in text.splitlines() if line.startswith("| u"))
    assert len(re.findall(r"(?<!\\)\|", row)) == 7


def test_a_title_of_two_lines_is_one_in_markdown():
    text = to_markdown(tabulate(SWEPT, 0.5, 0.5, ["gaussian"], title="a\nb"))
    assert "**a b**" in text


def test_latex_is_well_formed():
    table = tabulate(SWEPT, *quintrig.grid(3, 2), metric="both", unit="mm", title="50% of A&B_1 {x} #2")
    text = to_latex(table)
    begun, ended = (re.findall(rf"\\{word}{{(\w+)}}", text) for word in ("begin", "end"))
    assert sorted(begun) == sorted(ended)
    assert text.count("{") - text.count(r"\{") == text.count("}") - text.count(r"\}")
    assert r"50\% of A\&B\_1 \{x\} \#2}" in text
    assert r"$\kappa_1$ (1/mm)" in text
    assert r"$\beta_0^{S}$" in text
    assert text.isascii()
    for kinds, body in re.findall(r"\\begin{tabular}{(\w+)}(.*?)\\end{tabular}", text, flags=re.DOTALL):
        rows = [line for line in body.splitlines() if line.endswith(r"\\")]
        assert len(rows) == 7
        assert all(row.count("&") == len(kinds) - 1 for row in rows)
        assert len(kinds) <= 8
        assert rows[0].startswith("$u$ & $v$ &")


def test_latex_parts_hold_every_column_once():
    table = tabulate(SWEPT, 0.5, 0.5)
    headings = [
        cell.strip() for row in re.findall(r"\\toprule\n(.*?) \\\\", to_latex(table)) for cell in row.split("&")[2:]
    ]
    assert headings == [one.name if one.is_text else f"${one.latex}$" for one in table.columns[2:]]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"quantities": ["gausian"]}, "unknown quantity 'gausian'; did you mean 'gaussian'"),
        ({"metric": "flat"}, "metric: expected planar, surface or both, got 'flat'"),
    ],
)
def test_wrong_choices_are_refused(arguments, message):
    with pytest.raises(ValueError, match=re.escape(message)):
        tabulate(SWEPT, 0.5, 0.5, **arguments)


@pytest.mark.parametrize("u", [-1e-9, 1.0000001, math.nan, math.inf])
def test_parameters_outside_the_domain_are_refused(u):
    with pytest.raises(ValueError, match=r"outside the domain \[0, 1\]"):
        tabulate(SWEPT, u, 0.5)


def test_symbols_and_names_come_from_the_one_table():
    for one in tabulate(SWEPT, 0.5, 0.5, metric="both").columns[5:]:
        q = BY_KEY[one.key]
        assert (one.symbol, one.name, one.latex) == (q.symbol, q.name, q.latex)
