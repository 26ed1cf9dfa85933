"""Models of curves: read, told, drawn, and refused where a surface is wanted."""

import json
from itertools import pairwise

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.model.model import Model
from quintrig.model.starter import starter
from quintrig.support.errors import ModelError

POINTS = [[0, 0], [1, 4], [3, -3], [5, 4], [7, -3], [8, 1]]


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "c.toml"
    path.write_text(starter("curve"))
    return path


def test_a_curve_is_read_and_written_back(model, tmp_path):
    loaded = quintrig.load(model)
    assert loaded.patches == ()
    (one,) = loaded.curves
    again = Model.from_dict(loaded.to_dict())
    assert again.curves[0].curve(0.3) == pytest.approx(one.curve(0.3))
    (tmp_path / "p.csv").write_text("x,y\n" + "\n".join(f"{x},{y}" for x, y in POINTS))
    (tmp_path / "d.toml").write_text('kind = "curve"\npoints = "p.csv"\n')
    assert quintrig.load(tmp_path / "d.toml").curves[0].curve.points == pytest.approx(np.array(POINTS))


def test_close_and_flip():
    closed = Model.from_dict({"kind": "curve", "points": POINTS[:5], "close": True}).curves[0].curve
    assert closed.closed
    keys = {"kind": "curve", "points": POINTS, "shape": [0.5, -2.0]}
    plain, turned = (Model.from_dict({**keys, "flip": flip}).curves[0].curve for flip in (False, True))
    t = np.linspace(0.0, 1.0, 11)
    assert turned(t) == pytest.approx(plain(1.0 - t), abs=1e-13)
    assert turned.signed_curvature(t) == pytest.approx(-plain.signed_curvature(1.0 - t))


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"points": POINTS[:4]}, "6 control points"),
        ({"points": POINTS, "close": True}, "found 7; close = true adds the first once more"),
        ({"points": POINTS, "shape": [2, 0]}, "alpha"),
        ({"points": [*POINTS[:5], [1, 2, 3]]}, "points"),
        ({}, "points"),
        ({"points": POINTS, "pionts": 1}, "pionts"),
        ({"points": "/etc/passwd"}, ".csv file beside"),
    ],
)
def test_mistakes_are_told_in_one_line(keys, message):
    with pytest.raises(ModelError, match=message) as error:
        Model.from_dict({"kind": "curve", **keys})
    assert "\n" not in str(error.value)


def test_several_curves_of_one_dimension():
    one = {"kind": "curve", "name": "a", "points": POINTS}
    assert len(Model.from_dict({"patch": [one, one | {"name": "b"}]}).curves) == 2
    for other, message in (
        (one, "this name"),
        (one | {"name": "c", "points": [[*p, 0] for p in POINTS]}, "both in one model"),
    ):
        with pytest.raises(ModelError, match=message):
            Model.from_dict({"patch": [one, other]})


def test_check_tells_length_and_curvature(model):
    result = run("check", str(model))
    curve = quintrig.load(model).curves[0].curve
    assert result.code == 0
    assert f"{curve.length():.6g} mm" in result.out
    assert f"{curve.inflections()[0]:.6g}" in result.out
    assert "∫κ² ds" in result.out


@pytest.mark.parametrize("what", ["curve", "comb", "hull", "curvature"])
def test_plot_draws_a_curve(model, tmp_path, what):
    picture = tmp_path / f"{what}.svg"
    assert run("plot", str(model), "-q", what, "-o", str(picture)).code == 0
    assert "<svg" in picture.read_text()


def test_commands_of_surfaces_refuse_a_curve_in_one_line(model, tmp_path):
    for words in (
        ["joins", str(model)],
        ["flatten", str(model), str(tmp_path / "c.svg")],
        ["grid", str(model), str(tmp_path / "c.parquet")],
    ):
        result = run(*words)
        assert result.code == 2, words
        assert "expected a surface, found curves" in result.err
        assert result.err.count("\n") == 1
    with pytest.raises(ModelError, match="found curves"):
        _ = quintrig.load(model).surface
    assert sorted(path.name for path in tmp_path.iterdir()) == ["c.toml"]


def test_the_schema_accepts_a_curve():
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(run("schema").out)
    jsonschema.validate({"kind": "curve", "points": POINTS}, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"kind": "curve", "points": [[0]]}, schema)


def test_join_writes_curves_that_share_curvature(model, tmp_path):
    out = tmp_path / "joined.toml"
    assert run("join", model, model, model, "--order", "G3", "--ratio", "0.8", "-o", out).code == 0
    curves = [one.curve for one in quintrig.load(out).curves]
    assert len(curves) == 3
    for one, other in pairwise(curves):
        assert one(1.0) == pytest.approx(other(0.0))
        assert one.signed_curvature(1.0) == pytest.approx(other.signed_curvature(0.0), rel=1e-10)
    assert run("plot", out, "-q", "curvature", "-o", tmp_path / "k.svg").code == 0
    alone = run("join", model)
    assert alone.code == 2
    assert "two or more curves" in alone.err


def test_new_curve_through_points(tmp_path):
    (tmp_path / "p.csv").write_text("x,y\n" + "\n".join(f"{x},{y}" for x, y in POINTS))
    out = tmp_path / "s.toml"
    assert run("new", "curve", "--through", tmp_path / "p.csv", "--closed", "-o", out).code == 0
    curves = [one.curve for one in quintrig.load(out).curves]
    assert np.array([curve.points[0] for curve in curves]) == pytest.approx(np.array(POINTS))
    assert curves[-1](1.0) == pytest.approx(curves[0](0.0))
    wrong = run("new", "sphere", "--through", tmp_path / "p.csv", "-o", "-")
    assert wrong.code == 2
    assert "--through" in wrong.err


def test_a_table_of_a_curve_has_what_the_curve_says(tmp_path):
    file = tmp_path / "arc.toml"
    file.write_text('kind = "curve"\nunit = "mm"\npoints = [[0, 0], [1, 2], [2, 3], [4, 3], [5, 1], [6, 0]]\n')
    told = run("table", file, "--grid", "5", "--format", "json")
    assert told.code == 0, told.err
    rows = json.loads(told.out)["rows"]
    curve = quintrig.load(file).curves[0].curve
    for row in rows:
        assert [row["x"], row["y"]] == pytest.approx(curve(row["t"]).tolist(), abs=1e-14)
        assert row["curvature"] == pytest.approx(float(curve.signed_curvature(row["t"])))
        assert row["s"] == pytest.approx(curve.length(0.0, row["t"]), abs=1e-10)
        assert np.hypot(row["tangent_x"], row["tangent_y"]) == pytest.approx(1.0)
    for words, said in ((("--grid", "5x5"), "--grid: expected a number"), (("--at", "0.5,0.5"), "--at: expected 1")):
        told = run("table", file, *words)
        assert (told.code, told.err.count("\n")) == (2, 1)
        assert said in told.err
