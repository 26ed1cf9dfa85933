"""Lines as a command and as files: what is written is read back and holds the lines."""

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as command

BOOT = Path(__file__).parents[1] / "examples" / "car_boot.toml"


@pytest.fixture(scope="module")
def found():
    return quintrig.lines(quintrig.load(BOOT), "section", normal=(1, 0, 0), spacing=200)


def test_csv_and_json_hold_every_point(found, tmp_path):
    quintrig.write_lines(found, tmp_path / "s.csv")
    rows = list(csv.reader(io.StringIO((tmp_path / "s.csv").read_text(encoding="utf-8"))))
    assert rows[0][:6] == ["line", "chain", "patch", "label", "u", "v"]
    assert rows[0][6] == "x [mm]"
    assert len(rows) - 1 == sum(len(line.uv) for line in found)
    assert float(rows[1][7]) == found[0].points[0, 1]
    quintrig.write_lines(found, tmp_path / "s.json")
    told = json.loads((tmp_path / "s.json").read_text(encoding="utf-8"))
    assert told["unit"] == "mm"
    assert told["lines"][0]["points"] == found[0].points.tolist()
    assert told["chord_error"] == found.chord_error <= 1.05 * found.tolerance


def test_dxf_and_svg(found, tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    quintrig.write_lines(found, tmp_path / "s.dxf")
    document = ezdxf.readfile(tmp_path / "s.dxf")
    drawn = document.modelspace().query("POLYLINE")
    assert len(drawn) == len(found)
    assert document.header["$INSUNITS"] == 4
    first = np.array([vertex.dxf.location.xyz for vertex in drawn[0].vertices])
    assert np.abs(first - found[0].points).max() < 1e-9
    quintrig.write_lines(found, tmp_path / "s.svg", "top")
    text = (tmp_path / "s.svg").read_text(encoding="utf-8")
    assert text.count("<polyline") == len(found)
    assert "mm" in text.split("\n")[1]


@pytest.mark.parametrize("ending", ["step", "3dm"])
def test_fitted_curves_are_as_near_as_is_stated(found, ending, tmp_path):
    pytest.importorskip("OCP" if ending == "step" else "rhino3dm")
    from scipy.interpolate import BSpline

    from quintrig.exchange.cad.isolated import read_here
    from quintrig.exchange.lines import fitted

    (note, *_) = quintrig.write_lines(found, tmp_path / f"s.{ending}")
    assert "B-spline" in note
    held = read_here(tmp_path / f"s.{ending}")
    assert held.unit == "mm"
    assert len(held.curves) == len(found)
    for line, curve in zip(found, held.curves, strict=True):
        spline = BSpline(np.array(curve.knots), np.array(curve.points), curve.degree)
        t = np.linspace(curve.knots[0], curve.knots[-1], 4001)
        apart = np.linalg.norm(spline(t)[None] - line.points[:, None], axis=2).min(axis=1)
        stated = fitted(line, found.tolerance).error
        assert apart.max() <= 1.01 * stated + 1e-3 * found.tolerance + line.length / 4000
        assert stated <= 2 * found.tolerance


def test_the_command_says_what_it_finds(tmp_path):
    said = command("lines", BOOT, "parabolic", "--json")
    assert said.code == 0
    told = json.loads(said.out)
    assert told["kind"] == "parabolic"
    assert len(told["lines"]) == told["count"] == 2
    said = command("lines", BOOT, "geodesic", "--from", "0.3,0.3", "--direction", "30", "--length", "200")
    assert "200 mm in all" in said.out
    said = command("lines", BOOT, "section", "--plane", "1,0,0", "--with", BOOT)
    assert said.code == 2
    assert said.err.count("\n") == 1
    for arguments, words in (
        (("ridgs",), "did you mean 'ridges'"),
        (("section",), "expected the normal"),
        (("curvature", "--from", "0.5"), "expected 2 numbers"),
        (("curvature", "-o", tmp_path / "x.txt"), ".csv, .json"),
        (("curvature", "--spacing", "1e-6"), "of at most 1,000"),
    ):
        said = command("lines", BOOT, *arguments)
        assert said.code == 2
        assert words in said.err
        assert said.err.count("\n") == 1


def test_lines_are_drawn(tmp_path):
    said = command("plot", BOOT, "--lines", "parabolic", "-o", tmp_path / "p.svg")
    assert said.code == 0, said.err
    assert "parabolic lines" in (tmp_path / "p.svg").read_text(encoding="utf-8")
    assert command("plot", BOOT, "--lines", "101", "-o", tmp_path / "p.svg").code == 2
    assert "did you mean" in command("plot", BOOT, "--lines", "parabolik", "-o", tmp_path / "p.svg").err
