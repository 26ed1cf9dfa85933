"""``quintrig export``, ``import``, ``flatten`` as a user meets them; control nets in and out."""

import json
import os
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import quintrig
import shapes
from cli_runner import quintrig as run
from quintrig.exchange.cad.faces import Contents, Face, SpaceCurve, to_model
from quintrig.exchange.export import EXPORT_SUFFIXES, export
from quintrig.exchange.nets import export_net, model_from_net, polygon, put_into, to_csv
from quintrig.model.toml import to_toml
from quintrig.support.errors import ModelError, QuintrigError

EXAMPLES = Path(__file__).parent.parent / "examples"
LID = EXAMPLES / "car_boot.toml"

if not os.environ.get("CI"):
    for needed, extra in (("OCP", "cad"), ("rhino3dm", "cad"), ("meshio", "mesh"), ("ezdxf", "flat")):
        pytest.importorskip(needed, reason=f"needs the extra {extra}: pip install 'quintrig[{extra}]'")


# ------------------------------------------------------------------------------------------- command line


@pytest.mark.parametrize("suffix", [s for s in EXPORT_SUFFIXES if s not in (".stp", ".igs", ".csv")])
def test_export_writes_every_format_and_says_so(suffix, tmp_path):
    out = tmp_path / f"lid{suffix}"
    done = run("export", LID, out)
    assert (done.code, done.out) == (0, "")
    assert f"wrote {out}" in done.err
    assert out.stat().st_size > 100
    assert [path.name for path in tmp_path.iterdir()] == [out.name]


def test_export_prints_deviation_fit_and_chord(tmp_path):
    exact = run("export", LID, tmp_path / "a.step").err
    deviation = float(re.search(r"largest deviation \S+ \((\S+) of its size\)", exact).group(1))
    assert deviation <= 1e-12
    fitted = run("export", LID, tmp_path / "b.igs", "--fit", 3, "--continuity", 1, "--tolerance", 0.01).err
    assert "fit of degree 3, C1" in fitted
    assert float(re.search(r"largest deviation (\S+) \(allowed 0.01\)", fitted).group(1)) <= 0.01
    meshed = run("export", LID, tmp_path / "c.stl", "--tolerance", 0.5).err
    assert float(re.search(r"chord measured (\S+), allowed 0.5 mm", meshed).group(1)) <= 0.5


def test_every_command_takes_a_face_of_a_cad_file(tmp_path):
    part = tmp_path / "rear.step"
    assert run("export", EXAMPLES / "rear_of_car.toml", part).code == 0
    listed = run("import", part, "--list").out.splitlines()
    names = [patch.name for patch in quintrig.load(EXAMPLES / "rear_of_car.toml").patches]
    assert len(listed) == 1 + len(names)
    assert all(name in line for name, line in zip(names, listed[1:], strict=True))
    table = run("table", part, "--face", 1, "-q", "gaussian,mean", "-f", "csv", "--at", "0.5,0.5")
    model = run(
        "table",
        EXAMPLES / "rear_of_car.toml",
        "--patch",
        names[0],
        "-q",
        "gaussian,mean",
        "-f",
        "csv",
        "--at",
        "0.5,0.5",
    )
    numbers = [[float(x) for x in done.out.splitlines()[-1].split(",")] for done in (table, model)]
    # Sewing may turn a face; the middle of every example stays the middle.
    np.testing.assert_allclose(numbers[0][:5], numbers[1][:5], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(np.abs(numbers[0][5:]), np.abs(numbers[1][5:]), rtol=1e-6)
    assert run("check", part).code == 0
    assert run("plot", part, "--face", 1, "-q", "mean", "-o", tmp_path / "p.png").code == 0


def test_import_makes_models_that_export_again(tmp_path):
    part, model, again = tmp_path / "lid.3dm", tmp_path / "lid.toml", tmp_path / "again.step"
    assert run("export", LID, part).code == 0
    assert run("import", part, "-o", model).code == 0
    assert run("export", model, again).code == 0
    surface, original = quintrig.load(model).surface, quintrig.load(LID).surface
    t = np.array([0.0, 0.5, 1.0])  # where the parameters of both agree
    gap = surface(t[:, None], t[None, :]) - original(t[:, None], t[None, :])
    assert np.abs(gap).max() <= 1e-12 * original.size
    assert quintrig.load(model).unit == "mm"


def test_flatten_writes_patterns_and_refuses_the_rest(tmp_path):
    for suffix in ("dxf", "svg"):
        done = run(
            "flatten", EXAMPLES / "developable.toml", tmp_path / f"p.{suffix}", "--thickness", 0.01, "--k-factor", 0.4
        )
        assert done.code == 0
        assert "area: " in done.err
    assert run("flatten", EXAMPLES / "cylinder.toml", tmp_path / "p.pdf").code == 0
    too_large = run("flatten", EXAMPLES / "developable.toml", tmp_path / "large.pdf")
    assert "a PDF page at most 5080 mm; write DXF or SVG" in too_large.err
    refused = run("flatten", EXAMPLES / "ruled.toml", tmp_path / "no.dxf")
    assert refused.code == 2
    assert "not developable" in refused.err
    assert not (tmp_path / "no.dxf").exists()
    part = tmp_path / "strip.step"
    assert run("export", EXAMPLES / "developable.toml", part).code == 0
    assert run("flatten", part, tmp_path / "from_cad.dxf", "--face", 1).code == 0


MISTAKES = [
    (("export", LID, "a.xyz"), "expected a file ending in .step"),
    (("export", LID, "a.dxf"), "quintrig flatten writes flat patterns"),
    (("export", "none.toml", "a.step"), "none.toml: no such file"),
    (("export", LID, "a.step", "--continuity", "1"), "--continuity: belongs to a fit"),
    (("export", LID, "a.step", "--fit", "40"), "expected 1 to 25, found 40"),
    (("export", LID, "a.step", "--fit", "3", "--continuity", "3"), "expected 0 to 2 for degree 3"),
    (("export", LID, "a.step", "--sew", "-1"), "sewing tolerance"),
    (("export", LID, "a.step", "--face", "1"), "faces are chosen from CAD files"),
    (("export", LID, "a.glb", "--tolerance", "0"), "greater than 0"),
    (("export", LID, "a.glb", "--tolerance", "1", "--grid", "3x3"), "found both"),
    (("export", LID, "a.glb", "--colour", "gaussain"), "did you mean 'gaussian'"),
    (("export", EXAMPLES / "sphere.toml", "a.csv"), "has no control points"),
    (("import", LID, "--list"), "expected a CAD file or a scan to list"),
    (("import", "none.step", "-o", "a.toml"), "none.step: no such file"),
    (("import", "a.dwg", "-o", "a.toml"), "expected a file ending in .step"),
    (("import", EXAMPLES / "from_csv.csv"), "expected where to write"),
    (("flatten", EXAMPLES / "developable.toml", "a.png"), "expected a file ending in .dxf"),
    (("flatten", EXAMPLES / "developable.toml", "a.dxf", "--sheet", "3"), "--sheet: expected width x height"),
    (("flatten", EXAMPLES / "developable.toml", "a.dxf", "--k-factor", "2"), "k-factor: expected 0 to 1"),
    (("flatten", EXAMPLES / "sphere.toml", "a.dxf"), "no straight rulings"),
]


@pytest.mark.parametrize(
    ("arguments", "message"), MISTAKES, ids=[" ".join(map(str, m[0][2:])) or m[0][0] for m in MISTAKES]
)
def test_mistakes_are_one_line_and_leave_no_file(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = run(*arguments)
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


# ------------------------------------------------------------------------------------------- control nets


@pytest.mark.parametrize("name", ["tensor", "swept", "swung", "ruled", "developable", "symmetric"])
def test_nets_as_csv_make_the_same_model_again(name, tmp_path):
    model = quintrig.load(EXAMPLES / f"{name}.toml")
    paths = export_net(model, tmp_path / "net.csv")
    keys = model.to_dict()
    for path in paths:
        key = path.stem.partition("-")[2] or type(model.patches[0].definition).nets[0]
        keys[key] = path.name
    again = quintrig.Model.from_dict(keys, tmp_path)
    np.testing.assert_array_equal(again.surface(0.3, 0.8), model.surface(0.3, 0.8))


@pytest.mark.parametrize("suffix", ["json", "toml"])
@pytest.mark.parametrize("name", ["car_boot", "rear_of_car", "developable", "sphere"])
def test_models_go_out_and_come_in_unchanged(name, suffix, tmp_path):
    model = quintrig.load(EXAMPLES / f"{name}.toml")
    export(model, tmp_path / f"m.{suffix}")
    assert quintrig.load(tmp_path / f"m.{suffix}").to_dict() == model.to_dict()


def test_toml_spells_names_with_any_letters_and_long_lists():
    keys = {
        "schema": 1,
        "name": 'a "b" \\ é\n',
        "knots": [float(k) / 7 for k in range(60)],
        "flip": True,
        "patch": [{"x": [[1.5] * 30]}],
    }
    import tomllib

    text = to_toml(keys)
    assert tomllib.loads(text) == keys
    assert max(len(line) for line in text.splitlines()) <= 120


def test_net_from_csv_and_json_becomes_a_tensor_surface(tmp_path):
    net = shapes.net()
    (tmp_path / "net.csv").write_text(to_csv(net))
    (tmp_path / "net.json").write_text(json.dumps(net.tolist()))
    for name in ("net.csv", "net.json"):
        model = model_from_net(tmp_path / name, {"kind": "tensor"})
        np.testing.assert_array_equal(model.surface(0.2, 0.7), quintrig.tensor(net)(0.2, 0.7))


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "x,y,z\n1,2,3\n", "expected a multiple of 6 rows, got 1"),
        ("a.csv", "x,y,z\n" + "1,2\n" * 36, "points"),
        ("a.csv", "1,2,3\n1,nan,3\n" * 18, "finite"),
        ("a.csv", "1,2,3\nlook,here,now\n", "expected numbers"),
        ("a.csv", "\0\1\2", "a.csv"),
        ("a.json", "[[[1,2,3]]]", "points"),
        ("a.json", "{", "not valid JSON"),
        ("a.json", "[" * 100_000, "nested too deeply"),
    ],
)
def test_bad_nets_name_the_file_and_the_mistake(name, text, message, tmp_path):
    (tmp_path / name).write_text(text)
    with pytest.raises(ModelError, match=message) as caught:
        model_from_net(tmp_path / name, {"kind": "tensor"})
    assert name in str(caught.value)
    assert "\n" not in str(caught.value)


def exact_space_curve(curve):
    from quintrig.geometry.exact import exact_curve

    form = exact_curve(curve)
    return SpaceCurve(1, "c", form.points.tolist(), form.weights.tolist(), form.basis.degree, list(form.basis.knots))


def test_a_curve_that_quintrig_wrote_comes_back_as_its_six_points():
    curve = quintrig.Curve(shapes.CURVE, 0.5, -2.0)
    points, gap = polygon(exact_space_curve(curve), (0.5, -2.0))
    np.testing.assert_allclose(points, shapes.CURVE, rtol=0, atol=1e-11)
    assert gap <= 1e-12


def test_another_curve_is_met_as_near_as_told():
    circle = SpaceCurve(1, "arc", [[5, 0, 0], [5, 5, 0], [0, 5, 0]], [1, np.sqrt(0.5), 1], 2, [0, 0, 0, 1, 1, 1])
    points, gap = polygon(circle)
    radius = np.linalg.norm(quintrig.Curve(points)(np.linspace(0, 1, 999)), axis=1)
    assert 0 < np.abs(radius - 5).max() <= 1.05 * gap
    assert gap <= 1e-2 * 5  # six points with α = ζ = 0 come no nearer at equal parameters


def curves_file(path):
    import rhino3dm

    file = rhino3dm.File3dm()
    file.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Millimeters
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name = "rail"
    points = [rhino3dm.Point3d(*map(float, p)) for p in shapes.CURVE]
    file.Objects.AddCurve(rhino3dm.NurbsCurve.Create(False, 5, points), attributes)
    file.Write(str(path), 7)


def test_a_curve_of_a_3dm_file_goes_into_a_model(tmp_path):
    source, out = tmp_path / "rail.3dm", tmp_path / "lid.toml"
    curves_file(source)
    assert "curve 1: rail: curve of degree 5, 6 points" in run("import", source, "--list").out
    assert run("import", source, "-o", tmp_path / "x.toml").code == 2
    done = run("import", source, "--curve", 1, "--raw", "--into", LID, "--key", "section", "-o", out)
    assert done.code == 0
    np.testing.assert_allclose(quintrig.load(out).to_dict()["section"], shapes.CURVE, atol=1e-12)
    fitted = run("import", source, "--curve", 1, "-o", tmp_path / "rail.csv")
    assert "largest distance from the curve" in fitted.err
    assert len((tmp_path / "rail.csv").read_text().splitlines()) == 8
    assert "expected a curve from 1 to 1, found 4" in run("import", source, "--curve", 4, "-o", tmp_path / "y.csv").err
    assert (
        "has no net 'sektion'; did you mean 'section'"
        in run("import", source, "--curve", 1, "--into", LID, "--key", "sektion", "-o", out).err
    )


def test_a_face_puts_its_net_into_a_model():
    model = quintrig.load(EXAMPLES / "tensor.toml")
    net = shapes.net(3)
    changed = put_into(model, None, "points", net)
    np.testing.assert_array_equal(changed.surface.net, net)
    assert changed.unit == model.unit


# ------------------------------------------------------------------------------------------- imported faces


def face(number, name="side", **keys):
    plain = {"degrees": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": np.arange(12.0).reshape(2, 2, 3).tolist()}
    return Face(number, name, "B-spline", plain | keys)


def test_faces_of_one_name_are_told_apart():
    contents = Contents("part", "mm", (face(1), face(2), face(3, "top")))
    assert [patch.name for patch in to_model(contents, "f").patches] == ["side", "side 2", "top"]
    assert to_model(contents, "f", [3]).patches[0].name == "top"
    assert Contents.from_dict(json.loads(json.dumps(contents.to_dict()))) == contents


def test_faces_that_cannot_be_read_are_left_out_or_named():
    odd = Face(2, "odd", "OffsetSurface", {}, "this kind of surface has no exact NURBS form")
    contents = Contents("part", "mm", (face(1), odd))
    assert len(to_model(contents, "f").patches) == 1
    with pytest.raises(QuintrigError, match="face 2: this kind of surface has no exact NURBS form"):
        to_model(contents, "f", [2])
    with pytest.raises(QuintrigError, match="expected a face from 1 to 2, found 9"):
        to_model(contents, "f", [9])
    with pytest.raises(QuintrigError, match="expected a file with surfaces, found none"):
        to_model(Contents("part", "mm", ()), "f")


def test_trimmed_points_are_marked_in_tables_and_told():
    loop = [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]
    surface = to_model(Contents("part", "mm", (face(1, trim=[loop]),)), "f").surface
    from quintrig.analysis.table import tabulate

    table = tabulate(surface, [0.5, 0.2, 0.1], [0.5, 0.5, 0.5], ["mean"])
    assert table.columns[-1].values == ("inside", "inside", "outside")
    assert any("trimmed" in note for note in table.notes)


# ------------------------------------------------------------------------------------------- what is there already


@pytest.fixture
def here(tmp_path, monkeypatch):
    """A folder with models that have comments: one with numbers, one that names a CSV, and another name for one."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "lid.toml").write_bytes(LID.read_bytes() + b"\n# mine\n")
    (tmp_path / "lid.json").write_text(json.dumps(quintrig.load(LID).to_dict()))
    for name in ("from_csv.toml", "from_csv.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes() + b"\n# mine\n")
    (tmp_path / "other.toml").symlink_to("lid.toml")
    return tmp_path


LOSSES = [
    (("export", "lid.toml", "lid.toml"), "is read here"),
    (("export", "lid.toml", "lid.toml", "--force"), "is read here"),
    (("export", "lid.toml", "./x/../lid.toml"), "is read here"),
    (("export", "other.toml", "lid.toml"), "is read here"),
    (("export", "lid.json", "lid.json", "--force"), "is read here"),
    (("export", "lid.json", "lid.toml"), "exists already and is a model; choose another name, or --force"),
    (("export", "from_csv.toml", "from_csv.csv"), "is read here"),
    (("import", "from_csv.csv", "-o", "lid.toml"), "exists already and is a model"),
    (("import", "from_csv.csv", "-o", "from_csv.csv"), "is read here"),
    (("import", "lid.csv", "--into", "lid.toml", "--key", "section", "-o", "lid.toml"), "is read here"),
    (("import", "lid.csv", "--into", "lid.toml", "--key", "section", "-o", "lid.toml", "--force"), "is read here"),
    (("table", "lid.json", "-o", "lid.json"), "is read here"),
    (("table", "lid.toml", "-o", "lid.json"), "exists already and is a model; choose another name, or remove it"),
    (("table", "from_csv.toml", "-o", "from_csv.csv"), "is read here"),
    (("new", "swept", "-o", "lid.toml"), "exists already and is a model; choose another name, or --force"),
]


@pytest.mark.parametrize(("arguments", "message"), LOSSES, ids=[" ".join(arguments) for arguments, _ in LOSSES])
def test_what_a_user_wrote_is_never_lost(arguments, message, here):
    (here / "x").mkdir()
    (here / "lid.csv").write_text("\n".join(f"{k},0,{k}" for k in range(6)))
    before = {path.name: path.read_bytes() for path in here.iterdir() if path.is_file()}
    done = run(*arguments)
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1
    assert {path.name: path.read_bytes() for path in here.iterdir() if path.is_file()} == before


@pytest.mark.parametrize(
    "arguments",
    [
        ("export", "lid.toml", "out.step"),
        ("export", "lid.toml", "out.ply"),
        ("export", "from_csv.toml", "out.csv"),
        ("flatten", EXAMPLES / "developable.toml", "out.svg"),
        ("table", "lid.toml", "-o", "out.json"),
        ("plot", "lid.toml", "-o", "out.png", "--dpi", "30"),
    ],
    ids=lambda arguments: str(arguments[0]),
)
def test_results_are_made_anew_and_it_is_said(arguments, here):
    assert "\nwrote out." in "\n" + run(*arguments).err
    assert "\nreplaced out." in "\n" + run(*arguments).err


def test_force_replaces_another_model(here):
    done = run("export", "lid.json", "lid.toml", "--force")
    assert (done.code, done.err) == (0, "replaced lid.toml\n")
    assert quintrig.load("lid.toml").to_dict() == quintrig.load("lid.json").to_dict()
    assert run("import", "from_csv.csv", "-o", "lid.json", "--force").err == "replaced lid.json\n"


def test_several_nets_are_several_files_and_each_is_named(here):
    done = run("export", "lid.toml", "net.csv")
    assert done.err == "2 nets of points, a file for each\nwrote net-section.csv\nwrote net-trajectory.csv\n"
    assert sorted(path.name for path in here.glob("net*")) == ["net-section.csv", "net-trajectory.csv"]
    assert run("export", "lid.toml", "net.csv").err.count("replaced net-") == 2


def test_patches_of_almost_one_name_have_a_file_each(tmp_path):
    patch = quintrig.load(EXAMPLES / "tensor.toml").patches[0]
    model = quintrig.Model("m", "", tuple(replace(patch, name=name) for name in ("a b", "a/b", "a_b")))
    paths = export_net(model, tmp_path / "net.csv")
    assert len(set(paths)) == 3
    assert all(path.exists() for path in paths)


def test_several_patches_name_the_option(tmp_path):
    done = run("flatten", EXAMPLES / "rear_of_car.toml", tmp_path / "a.dxf")
    assert done.code == 2
    assert "choose one by its name (--patch NAME)" in done.err
