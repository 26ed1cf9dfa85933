"""Every LaTeX table that a command writes compiles, plain and with siunitx, whatever the names in it."""

import math
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as command
from quintrig.analysis.table import Column, Table, tabulate
from quintrig.exchange.latex import text, to_latex
from quintrig.quantities.table import BY_KEY

BOOT = Path(__file__).parents[1] / "examples" / "car_boot.toml"


def compiled(tex, folder):
    """Compile a table in an article; the log is shown where that fails."""
    if shutil.which("pdflatex") is None:
        if os.environ.get("CI") == "true":
            pytest.fail("pdflatex is missing in CI")
        pytest.skip("pdflatex is not installed")
    head = re.match(r"% needs (.*)", tex)[1]
    (folder / "table.tex").write_text(
        f"\\documentclass{{article}}\n{head}\n\\begin{{document}}\n{tex}\\end{{document}}\n", encoding="utf-8"
    )
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "table.tex"],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:]
    return done.stdout


@pytest.mark.parametrize("options", [(), ("--siunitx",), ("--digits", "12"), ("--siunitx", "--digits", "3")])
def test_a_table_of_all_quantities_compiles_and_fits_the_page(options, tmp_path):
    keys = ",".join(BY_KEY)
    found = command("table", BOOT, "--grid", "3x3", "-q", keys, "--format", "latex", *options)
    assert found.code == 0, found.err
    assert "Overfull" not in compiled(found.out, tmp_path)


def test_a_table_taller_than_a_page_goes_on_over_pages_under_one_number(tmp_path):
    found = command("table", BOOT, "--grid", "8x8", "-q", "K,H,k1,k2,S,C,hk_type", "--format", "latex")
    log = compiled(found.out, tmp_path)
    assert "Overfull" not in log
    assert "Float too large" not in log
    assert int(re.search(r"\((\d+) pages", log)[1]) > 1
    assert found.out.count(r"\caption") == 1
    parts = found.out.count(r"\begin{longtable}")
    assert parts > 1
    assert found.out.count(r"\addtocounter{table}{-1}") == parts - 1


@pytest.mark.parametrize("siunitx", [False, True])
def test_any_name_and_value_compiles(siunitx, tmp_path):
    name = "50 % & #1_$x$ {y} ~^\\ <|> Ünïcödé ß Ł 字 β α1 κ2 ² ³ × ∞ “q” S_u × S_v \n\t end"
    values = (0.0, -1e-300, math.nan, math.inf, -math.inf, 123456789.0, 1.5)
    words = tuple(name for _ in values)
    columns = (
        Column("a", "a", "a", "a", "mm²", values, values),
        Column("w", "w", "w", name, "", words, words),
        Column("c", "c", r"\kappa_1", "c", "1/µm", values[:0] + (1.0,) * 7, (1.0,) * 7),
    )
    compiled(to_latex(Table(name, (name, "second <= note"), columns, 1), siunitx=siunitx), tmp_path)


@pytest.mark.parametrize("shape", ["1,1,-3,-3"])
def test_compare_writes_latex_that_compiles(shape, tmp_path):
    assert command("compare", BOOT, tmp_path / "out", "--shape", shape, "-q", "mean").code == 0
    compiled((tmp_path / "out" / "intensities.tex").read_text(encoding="utf-8"), tmp_path)


def test_columns_are_those_of_the_csv():
    table = tabulate(quintrig.load(BOOT).surface, 0.5, np.linspace(0, 1, 3), ["K", "H", "k1", "k2", "S", "C", "beta0"])
    tex = to_latex(table)
    for column in table.columns:
        assert f"${column.latex}$" in tex


def test_numbers_of_a_column_have_the_same_decimals():
    values = (0.125, 10.0, -3.5)
    column = Column("a", "a", "a", "a", "", values, values)
    rows = to_latex(Table("", (), (column,), 1)).split(r"\midrule")[1].split(r"\bottomrule")[0]
    assert re.findall(r"\$(.*?)\$", rows) == ["0.125", "10.000", "-3.500"]


def test_the_caption_is_short_and_notes_stand_below():
    column = Column("a", "a", "a", "a", "", (1.0,), (1.0,))
    tex = to_latex(Table("Title", ("A note.",), (column,), 1))
    assert r"\caption{Title}" in tex
    assert tex.index("A note.") > tex.index(r"\bottomrule")


def test_round_numbers_need_no_power_of_ten():
    column = Column("a", "a", "a", "a", "", (100.0, 28.3), (100.0, 28.3))
    assert all("$100$" in to_latex(Table("", (), (column,), 1), digits=digits) for digits in (2, 1))
    assert "\n100 " in to_latex(Table("", (), (column,), 1), digits=2, siunitx=True)


def test_notes_longer_than_a_page_go_on_over_pages(tmp_path):
    column = Column("a", "a", "a", "a", "", (1.0,), (1.0,))
    notes = tuple(f"Patch {i}: the normal points along S_u × S_v, which the words of this note say." for i in range(99))
    log = compiled(to_latex(Table("Many", notes, (column,), 1)), tmp_path)
    assert "Overfull" not in log
    assert "Float too large" not in log


@pytest.mark.parametrize("digits", [0, 18])
def test_digits_have_limits(digits):
    with pytest.raises(ValueError, match="digits: expected 1 to 17"):
        to_latex(Table("", (), (), 0), digits=digits)


def test_greek_and_accents_are_spelled_out():
    assert text("κ1 ζ2 é") == r"$\kappa_1$ $\zeta_2$ \'{e}"
