"""Models of several patches, whole: tables of all, what shape parameters do to seams, sweeps that carry along."""

import csv
import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.analysis.summary import summarise
from quintrig.model.held import carried
from test_held import CHAIN, keys


@pytest.fixture
def chain(tmp_path):
    """Return the file of three patches, of which each follows the one before."""
    path = tmp_path / "chain.toml"
    quintrig.save(quintrig.Model.from_dict(keys(*CHAIN)), path)
    return path


def test_a_table_has_the_points_of_every_patch(chain, tmp_path):
    assert run("table", chain, "--at", "0.5,0.5", "--at", "0,1", "-q", "mean", "-o", tmp_path / "t.csv").code == 0
    rows = list(csv.DictReader(x for x in (tmp_path / "t.csv").read_text().splitlines() if not x.startswith("#")))
    assert [row["patch"] for row in rows] == list("aabbcc")
    model = quintrig.load(chain)
    for row in rows:
        sample = quintrig.analyse(model.patch(row["patch"]).surface, float(row["u"]), float(row["v"]), ["mean"])
        assert float(row["mean"]) == pytest.approx(float(sample["mean"]), rel=1e-12)


def test_what_follows_is_known_through_others():
    model = quintrig.Model.from_dict(keys(*CHAIN))
    assert carried(model.held, "a") == ("a", "b", "c")
    assert carried(model.held, "b") == ("b", "c")
    assert carried(model.held, "c") == ("c",)


def test_a_comparison_tells_what_becomes_of_the_seams(chain, tmp_path):
    done = run("compare", chain, tmp_path / "out", "--patch", "a", "--shape", "0.5,0.9,0.3,-1", "-q", "mean")
    assert done.code == 0, done.err
    rows = json.loads((tmp_path / "out" / "seams.json").read_text())["rows"]
    assert [(row["first"], row["second"], row["order"]) for row in rows] == [
        ("a:u1", "b:u0", "G2"),
        ("b:u1", "c:u0", "G3"),
    ] * 2
    assert "<h2>Seams</h2>" in (tmp_path / "out" / "index.html").read_text()
    loose = quintrig.Model.from_dict({key: value for key, value in keys(*CHAIN).items() if key != "join"})
    quintrig.save(loose, tmp_path / "loose.toml")
    shown = run("compare", tmp_path / "loose.toml", "--shape", "0.5,0.9,0.3,-1")
    assert shown.code == 0, shown.err
    assert "a carries no other patch along" in shown.out
    page = run("compare", chain, tmp_path / "all", "--shape", "0.5,0.9,0.3,-1", "-q", "mean")
    assert page.code == 0, page.err
    varied = [row["patch"] for row in json.loads((tmp_path / "all" / "intensities.json").read_text())["rows"]]
    assert varied == [name for name in "abc" for _ in range(2)]
    assert {"1-a-surface.png", "3-c-mean.png", "seams.csv"} <= {one.name for one in (tmp_path / "all").iterdir()}


def test_several_curves_are_compared_each(tmp_path):
    curves = [quintrig.Curve([[0, 0], [1, k], [2, 1], [3, -k], [4, 0], [5, 1]]) for k in (1, 2)]
    quintrig.save(quintrig.Model.of_curves(curves), tmp_path / "two.toml")
    done = run("compare", tmp_path / "two.toml", tmp_path / "two.html", "--shape", "0.5,0.5")
    assert done.code == 0, done.err
    page = (tmp_path / "two.html").read_text()
    assert all(f"<h2>curve {k}</h2>" in page for k in (1, 2))


def test_a_sweep_carries_what_follows_along(chain, tmp_path):
    pytest.importorskip("polars")
    from quintrig.sweep import Axis, DesignSpace, Task
    from quintrig.sweep.part import columns, summaries

    model = quintrig.load(chain)
    space = DesignSpace((Axis("zeta1", -1.0, 1.0, 2),))
    rows = summaries(Task(model.to_dict(), "a", space, 24), 0, 2)
    at = {name: k for k, name in enumerate(columns(space))}
    for row, zeta in zip(rows, (-1.0, 1.0), strict=True):
        after = model.with_patch(model.patch("a").with_parameters({"zeta1": zeta}))
        whole = [summarise(one.surface).integrals for one in after.patches]
        assert row[at["area"]] == pytest.approx(sum(one.area.value for one in whole), rel=1e-5)
        alone = summaries(Task(after.to_dict(), "c", DesignSpace((Axis("alpha2", 0.3, 0.3, 1),)), 24), 0, 1)[0]
        assert row[at["mean_max"]] >= alone[1 + at["mean_max"] - 1] - 1e-12
    assert np.abs(np.diff(rows[:, at["area"]])) > 1e-3
    done = run("sweep", chain, "--patch", "a", "--vary", "zeta1=-1:1:2", "--points", 8, "-o", tmp_path / "s")
    assert done.code == 0, done.err


def test_a_sweep_without_a_patch_varies_all_of_them(chain, tmp_path):
    pytest.importorskip("polars")
    from quintrig.sweep import Axis, DesignSpace, Task
    from quintrig.sweep.part import columns, summaries

    model = quintrig.load(chain)
    space = DesignSpace((Axis("zeta1", 0.2, 0.2, 1),))
    (row,) = summaries(Task(model.to_dict(), None, space, 24), 0, 1)
    after = model.replace(*(one.with_parameters({"zeta1": 0.2}) for one in model.patches))
    whole = [summarise(one.surface).integrals.area.value for one in after.patches]
    assert row[columns(space).index("area")] == pytest.approx(sum(whole), rel=1e-5)
    done = run("sweep", chain, "--vary", "zeta1=0.2", "--points", 8, "--prove", "regular", "-o", tmp_path / "s")
    assert done.code == 0, done.err
    wrong = run("sweep", chain, "--vary", "scale=1:2:2", "-o", tmp_path / "t")
    assert wrong.code == 2
    assert "the patches have alpha1" in wrong.err


def test_a_sweep_of_several_curves_sums_them_up(tmp_path):
    from quintrig.sweep import Axis, DesignSpace, Task
    from quintrig.sweep.part import summaries

    curves = [quintrig.Curve([[0, 0], [1, k], [2, 1], [3, -k], [4, 0], [5, 1]]) for k in (1, 2)]
    model = quintrig.Model.of_curves(curves)
    (row,) = summaries(Task(model.to_dict(), None, DesignSpace((Axis("alpha", 0.5, 0.5, 1),))), 0, 1)
    after = [one.with_parameters({"alpha": 0.5}).curve for one in model.curves]
    assert row[1] == pytest.approx(sum(one.length() for one in after), rel=1e-9)
    assert row[3] == pytest.approx(max(one.curvature(np.linspace(0, 1, 4001)).max() for one in after), rel=1e-5)
