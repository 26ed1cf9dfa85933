"""Curves through every command: report, compare, sweep, export; models that hold curves and surfaces."""

import json
import re

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.analysis.curve_summary import summarise_curve
from quintrig.exchange.curve_drawing import cubic_pieces
from quintrig.exchange.export import export
from quintrig.exchange.imports import contents
from quintrig.model.model import Model

PLANE = {"kind": "curve", "points": [[0, 0], [1, 4], [3, -3], [5, 4], [7, -3], [8, 1]], "shape": [0.5, -1]}
SPACE = {"kind": "curve", "points": [[0, 0, 0], [1, 4, 1], [3, -3, 3], [5, 4, -2], [7, -3, 4], [8, 1, 0]]}
CIRCLE = {"kind": "curve", "basis": "cubic", "points": [[1, 0], [1, 0.5], [0.5, 1], [0, 1]], "shape": [0, 0]}
SPIRAL = {"kind": "curve", "basis": "c_bezier", "points": [[1, 0, 0], [1, 0.5, 1], [0.5, 1, 2], [0, 1, 1]]}
LID = {"kind": "cylinder", "radius": 2, "height": 3}
PIECES = {
    "unit": "mm",
    "patch": [
        PLANE | {"name": "first"},
        {"kind": "curve", "name": "second", "basis": "cubic", "points": [[8, 1], [9, 5], [11, 3], [12, 1]]},
    ],
}
MIXED = {"unit": "mm", "name": "Both", "patch": [LID | {"name": "lid"}, SPACE | {"name": "rail"}]}


def written(tmp_path, keys):
    path = tmp_path / "model.json"
    path.write_text(json.dumps(keys))
    return path


def nurbs(curve):
    """Return points of a NURBS by de Boor's recursion on homogeneous points: an oracle of its own."""
    knots, degree = np.array(curve.knots), curve.degree
    control = np.column_stack([np.array(curve.points) * np.array(curve.weights)[:, None], curve.weights])

    def at(x):
        span = min(max(int(np.searchsorted(knots, x, "right")) - 1, degree), len(control) - 1)
        points = control[span - degree : span + 1].copy()
        for r in range(1, degree + 1):
            for j in range(degree, r - 1, -1):
                i = span - degree + j
                share = (x - knots[i]) / (knots[i + degree + 1 - r] - knots[i])
                points[j] = (1 - share) * points[j - 1] + share * points[j]
        return points[-1, :-1] / points[-1, -1]

    return np.array([at(x) for x in np.linspace(knots[degree], knots[-degree - 1], 41)])


@pytest.mark.parametrize("suffix", [".step", ".iges", ".brep", ".3dm"])
def test_cad_files_hold_the_exact_curves(tmp_path, suffix):
    pytest.importorskip("rhino3dm" if suffix == ".3dm" else "OCP")
    model = Model.from_dict(MIXED | {"patch": [*MIXED["patch"], SPIRAL | {"name": "spiral"}]})
    notes = export(model, tmp_path / f"out{suffix}").notes
    found = contents(tmp_path / f"out{suffix}")
    assert [len(found.faces), len(found.curves)] == [1, 2]
    if suffix != ".brep":
        assert [one.name for one in found.curves] == ["rail", "spiral"]
    rail = model.curve("rail").curve
    for place in nurbs(found.curves[0]):
        assert rail.closest(place).distance < 1e-13 * 10.0
    told = next(line for line in notes if line.startswith("spiral") and "fit" in line)
    deviation = float(re.search(r"largest deviation (\S+)", told)[1])
    away = max(model.curve("spiral").curve.closest(place).distance for place in nurbs(found.curves[1]))
    assert away <= 1.001 * deviation <= 1e-5


def test_a_circle_stays_a_circle_in_a_drawing(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    assert run("export", written(tmp_path, CIRCLE), tmp_path / "c.dxf").code == 0
    (spline,) = ezdxf.readfile(tmp_path / "c.dxf").modelspace()
    assert spline.dxf.degree == 4
    curve = type("Read", (), {})()
    curve.points, curve.weights = np.array(spline.control_points), list(spline.weights)
    curve.knots, curve.degree = list(spline.knots), spline.dxf.degree
    assert np.linalg.norm(nurbs(curve), axis=1) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("keys", [PLANE, SPACE, CIRCLE, SPIRAL])
def test_svg_paths_are_as_near_as_they_say(keys):
    curve = Model.from_dict(keys).curves[0].curve
    pieces, off = cubic_pieces(curve, 1e-4)
    assert off <= 1e-4
    x = np.linspace(0, 1, 9)[:, None]
    flat = quintrig.Curve(curve.points[:, :2], basis=curve.basis, shape=curve.shape) if curve.shape else None
    for piece in pieces:
        a, b, c, d = piece
        place = (1 - x) ** 3 * a + 3 * x * (1 - x) ** 2 * b + 3 * x**2 * (1 - x) * c + x**3 * d
        if flat is not None:
            assert max(flat.closest(one).distance for one in place) <= off * 1.001 + 1e-15
    assert pieces[0, 0] == pytest.approx(curve(0.0)[:2])
    assert pieces[-1, -1] == pytest.approx(curve(1.0)[:2])


def test_svg_is_in_millimetres(tmp_path):
    assert run("export", written(tmp_path, PIECES | {"unit": "in"}), tmp_path / "c.svg").code == 0
    text = (tmp_path / "c.svg").read_text()
    assert text.count("<path") == 2
    start = re.search(r'd="M([\d.]+),([\d.]+)', text)
    first = re.findall(r"C([\d.,\-e ]+)", text.split("<path")[1])[-1].split()[-1]
    x = float(first.split(",")[0]) - float(start[1])
    assert x == pytest.approx(8 * 25.4)


def test_a_mesh_needs_a_surface_and_says_so(tmp_path):
    result = run("export", written(tmp_path, PIECES), tmp_path / "c.stl")
    assert result.code == 2
    assert "a mesh is made of surfaces" in result.err
    assert result.err.count("\n") == 1
    assert run("export", written(tmp_path, PIECES), tmp_path / "c.csv").code == 0
    assert (tmp_path / "c-first.csv").read_text().splitlines()[2] == "0.0,0.0"


def test_surfaces_and_curves_in_one_model(tmp_path):
    path = written(tmp_path, MIXED)
    model = quintrig.load(path)
    again = Model.from_dict(model.to_dict())
    assert [one.name for one in (*again.patches, *again.curves)] == ["lid", "rail"]
    told = run("check", path).out
    assert "circular cylinder" in told
    assert "curve in space" in told
    assert "T_x" in run("table", path, "--patch", "rail").out
    assert run("plot", path, "-o", tmp_path / "both.svg").code == 0
    assert "rail" in (tmp_path / "both.svg").read_text()
    assert run("joins", path).code == 0


@pytest.mark.parametrize("keys", [PIECES, SPACE, MIXED])
def test_report_tells_of_every_curve(tmp_path, keys):
    assert run("report", written(tmp_path, keys), tmp_path / "page.html").code == 0
    page = (tmp_path / "page.html").read_text()
    model = Model.from_dict(keys)
    for index, one in enumerate(model.curves, 1):
        assert f'id="curve-{index}"' in page
        assert f"{one.curve.length():.6g}" in page
    assert "curvature comb" in page.lower()
    assert 'src="http' not in page


def test_compare_shows_what_shape_parameters_do_to_a_curve(tmp_path):
    path = written(tmp_path, SPACE)
    result = run("compare", path, "--shape", "1,1", tmp_path / "out")
    assert result.code == 0
    names = {one.name for one in (tmp_path / "out").iterdir()}
    assert {"index.html", "curve.png", "curvature.png", "torsion.png", "intensities.csv"} <= names
    rows = (tmp_path / "out" / "intensities.csv").read_text().splitlines()
    length = Model.from_dict(SPACE | {"shape": [1, 1]}).curves[0].curve.length()
    assert any(f"{length:.12g}"[:10] in row for row in rows)
    assert run("compare", written(tmp_path, CIRCLE)).code == 0
    wrong = run("compare", written(tmp_path, PLANE | {"basis": "bernstein", "shape": []}))
    assert wrong.code == 2
    assert "no shape parameters" in wrong.err


def test_sweep_finds_the_shortest_curve(tmp_path):
    path, folder = written(tmp_path, PIECES), tmp_path / "s"
    words = ["sweep", path, "--patch", "first", "--vary", "alpha=-2:1:4", "--vary", "zeta=-2:1:3", "-o", folder]
    result = run(*words, "--best", "length", "--top", "1", "--plot", tmp_path / "p.png")
    assert result.code == 0, result.err
    assert "12 of 12 designs" in result.out
    from quintrig.sweep import Question, load_sweep, select

    rows = select(load_sweep(folder), Question(where="bending_energy < 100", best="length"))
    assert rows["length"].tolist() == sorted(rows["length"])
    shape = [rows["alpha"][0], rows["zeta"][0]]
    found = summarise_curve(Model.from_dict(PLANE | {"shape": shape}).curves[0].curve)
    assert rows["length"][0] == pytest.approx(found.length, rel=1e-12)
    assert rows["curvature_max"][0] == pytest.approx(found.curvature_max, rel=1e-12)
    wrong = run("sweep", path, "--patch", "first", "--vary", "alpha1=0:1:2", "-o", tmp_path / "t")
    assert wrong.code == 2
    assert "a curve has alpha, zeta" in wrong.err


def test_curvature_beside_a_standing_end_is_without_bound():
    found = summarise_curve(Model.from_dict(PLANE | {"shape": [0.0, -4.0]}).curves[0].curve)
    assert found.singular == 1
    assert np.inf in (found.curvature_max, -found.curvature_min)
    assert found.bending_energy == np.inf


@pytest.mark.parametrize("what", ["comb", "hull", "torsion"])
def test_pictures_of_a_curve_in_space(tmp_path, what):
    assert run("plot", written(tmp_path, SPACE), "-q", what, "-o", tmp_path / "p.svg").code == 0


def test_curvature_runs_over_arc_length_across_joins(tmp_path):
    figure = quintrig.plot(Model.from_dict(PIECES), "curvature")
    axes = figure.axes[0]
    total = sum(one.curve.length() for one in Model.from_dict(PIECES).curves)
    assert axes.get_xlim()[1] == pytest.approx(total)
    assert "arc length" in axes.get_xlabel()
    single = quintrig.plot(Model.from_dict(PLANE), "curvature").axes[0]
    assert single.get_xlim()[1] == 1.0


def test_table_of_all_curves_of_a_model(tmp_path):
    path = written(tmp_path, PIECES)
    data = run("table", path, "--grid", "3", "-q", "x,κ", "-f", "csv").out.splitlines()
    rows = [line for line in data if not line.startswith("#")]
    assert rows[0] == "patch,t,x,curvature"
    assert [row.split(",")[:2] for row in rows[1:]] == [
        [a, t] for a in ("first", "second") for t in ("0.0", "0.5", "1.0")
    ]
    assert float(rows[6].split(",")[2]) == 12.0
    for words, told in ((("-q", "gaussian"), "found 'gaussian'"), (("--points", "x.csv"), "--at T")):
        wrong = run("table", path, *words)
        assert wrong.code == 2
        assert told in wrong.err


def test_points_for_curves_that_coincide_are_told_with_their_file(tmp_path):
    file = tmp_path / "points.csv"
    file.write_text("0,0\n1,2\n1,2\n")
    wrong = run("new", "curve", "--through", file, "-o", tmp_path / "c.toml")
    assert wrong.code == 2
    assert f"{file}: points[2]" in wrong.err


def test_a_table_of_a_curve_has_the_columns_asked_for(tmp_path):
    file = tmp_path / "c.json"
    quintrig.save(Model.from_dict(PLANE), file)
    head = next(
        line for line in run("table", file, "-q", "κ,tangent_x", "-f", "csv").out.splitlines() if line[:1] == "t"
    )
    assert head.count(",") == 2
    told = run("table", file, "-q", "kurvature")
    assert (told.code, "did you mean 'curvature'" in told.err) == (2, True)
