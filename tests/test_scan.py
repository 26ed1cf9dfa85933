"""Scans: what is read of every format, and the curvature of points against closed forms, with its errors."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

import cli_runner
import quintrig
from quintrig.support.errors import ModelError, QuintrigError

RUN = cli_runner.quintrig
EXAMPLES = Path(__file__).parent.parent / "examples"
TABLES = {
    "x,y,z\n1,2,3\n4,5,6\n": [[1, 2, 3], [4, 5, 6]],
    "1 2 3\n\n# between\n4\t5  6\n": [[1, 2, 3], [4, 5, 6]],
    "X;Y;Z\n1,5;2;3\n4;5;6\n": [[1.5, 2, 3], [4, 5, 6]],
    "// a remark\n2\n1 2 3\n4 5 6": [[1, 2, 3], [4, 5, 6]],
    "weight,z,y,x\n1,3,2,1\n2,6,5,4\n": [[1, 2, 3], [4, 5, 6]],
    "\ufeff1,2,3\r\n4,5,nan\r\n": [[1, 2, 3]],
    "1,2\n4,5\n": [[1, 2], [4, 5]],
    "scan 7\nX [mm];Y [mm];Z [mm]\n1,5;2;3\n1.004,25;5;6\n": [[1.5, 2, 3], [1004.25, 5, 6]],
    "1,5 2 3\n4\t5,25 6\n": [[1.5, 2, 3], [4, 5.25, 6]],
    "Temp,Points:0,Points:1,Points:2\n9,1,2,3\n9,4,5,6\n": [[1, 2, 3], [4, 5, 6]],
    "# R G B X Y Z\n9 9 9 1 2 3\n9 9 9 4 5 6\n": [[1, 2, 3], [4, 5, 6]],
    "P1|1|2|3\nP2|4|5|6\n": [[1, 2, 3], [4, 5, 6]],
    '"x","y","z",\n"1","2","3",\n#N/A,nan,,\n"4","5","6",\n': [[1, 2, 3], [4, 5, 6]],
    "1.D0 2.D0 3.D0 ! remark\r4.D0 5.D0 6.D0\r": [[1, 2, 3], [4, 5, 6]],
    "7 1 2 3\n8 4 5 6\n9 7 8 9\n10 0 0 1": [[1, 2, 3], [4, 5, 6], [7, 8, 9], [0, 0, 1]],
}


@pytest.mark.parametrize("text", TABLES, ids=range(len(TABLES)))
@pytest.mark.parametrize("suffix", [".csv", ".xyz"])
def test_tables_of_points(text, suffix, tmp_path):
    file = tmp_path / f"p{suffix}"
    file.write_text(text, encoding="utf-8", newline="")
    found = quintrig.read_scan(file)
    assert found.points.tolist() == TABLES[text]
    assert bool(found.notes) == ("nan" in text or text.startswith("7 1"))
    file.write_bytes(text.strip("\ufeff").encode("utf-16"))
    assert quintrig.read_scan(file).points.tolist() == TABLES[text]


def test_normals_weights_and_units_are_read(tmp_path):
    file = tmp_path / "p.csv"
    file.write_text("# unit cm\nx,y,z,nx,ny,nz,weight\n1,2,3,0,0,2,0.5\n4,5,6,0,3,0,1\n")
    found = quintrig.read_scan(file)
    assert (found.unit, found.weights.tolist()) == ("cm", [0.5, 1])
    assert found.normals.tolist() == [[0, 0, 1], [0, 1, 0]]
    assert found.in_unit("mm").points[0].tolist() == [10, 20, 30]
    assert quintrig.read_scan(file, "m").unit == "m"
    file.write_text("x (in),y (in),z (in),r,g,b,Normal:0,Normal:1,Normal:2\n1,2,3,9,9,9,0,0,2\n")
    found = quintrig.read_scan(file)
    assert (found.unit, found.normals.tolist()) == ("in", [[0, 0, 1]])
    file.write_text("# Units: Inches\n1 2 3 250 9 9 0 0 1\n4 5 6 250 9 9 0 1 0\n")
    found = quintrig.read_scan(file)
    assert (found.unit, found.normals.tolist()) == ("in", [[0, 0, 1], [0, 1, 0]])


@pytest.mark.parametrize("suffix", [".ply", ".stl", ".obj"])
def test_meshes_come_back(suffix, tmp_path):
    model = quintrig.Model.from_dict({"kind": "sphere", "radius": 2, "unit": "mm"})
    quintrig.export(model, tmp_path / f"ball{suffix}")
    found = quintrig.read_scan(tmp_path / f"ball{suffix}")
    assert np.linalg.norm(found.points, axis=1) == pytest.approx(np.full(len(found.points), 2), abs=1e-6)
    corners = found.points[found.triangles]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    assert volume == pytest.approx(4 / 3 * np.pi * 8, rel=0.05)


@pytest.mark.parametrize(
    ("name", "raw", "words"),
    [
        ("a.csv", b"", "empty"),
        ("a.xyz", b"# nothing\n", "no line of numbers"),
        ("a.csv", b"1,2,3\n4,5\n", "row 2: expected 3 numbers"),
        ("a.csv", b"x,y,z\n1,2,3\n4,five,6\n", "row 3: expected a number, got 'five'"),
        ("a.csv", b"1,2,3,4,5\n", "found 5"),
        ("a.csv", b"depth,temp,p,q\n1,2,3,4\n", "expected columns with the names x, y and z, found depth, temp, p, q"),
        ("a.csv", b"x (mm),y (mm),z (in)\n1,2,3\n", "expected one unit for x, y and z"),
        ("a.csv", b'"7","8","9"\n"1,234","5","6"\n', "expected a number, got '1,234'"),
        ("a.csv", b"nan,nan,nan\n", "at least one finite point"),
        ("a.csv", bytes(range(200)), "a.csv: "),
        ("a.ply", b"ply\nformat ascii 1.0\nelement", "a damaged file"),
        ("a.stl", b"solid nothing\nendsolid", "found none"),
        ("a.obj", b"v 1 2\nf 9 9 9\n", "a.obj: "),
    ],
)
def test_what_is_no_scan_is_told_in_one_line(name, raw, words, tmp_path):
    file = tmp_path / name
    file.write_bytes(raw)
    with pytest.raises((ModelError, QuintrigError), match=re.escape(words)) as told:
        quintrig.read_scan(file)
    assert "\n" not in str(told.value)


def torus(count, seed=0):
    """Jittered points on a torus, with K and H (normal outwards)."""
    rng = np.random.default_rng(seed)
    m = round(np.sqrt(count / 3))
    u, v = np.meshgrid(np.arange(m) / m, np.arange(3 * m) / (3 * m), indexing="ij")
    u = (u + rng.uniform(-0.3, 0.3, u.shape) / m).ravel() % 1
    v = (v + rng.uniform(-0.3, 0.3, v.shape) / (3 * m)).ravel() % 1
    gaussian = np.cos(2 * np.pi * u) / (3 + np.cos(2 * np.pi * u))
    return quintrig.torus(3.0, 1.0)(u, v), gaussian, -0.5 * (1 + gaussian)


@pytest.mark.parametrize(("degree", "neighbours"), [(2, 20), (3, 26), (4, 40)])
def test_curvature_converges_at_the_order_of_theory(degree, neighbours):
    """Cazals and Pouget 2005: degree d gives curvature with an error of the order d - 1."""
    errors = []
    for count in (3000, 12000):
        points, gaussian, mean = torus(count)
        found = quintrig.scan_curvature(points, degree=degree, neighbours=neighbours)
        errors.append([np.sqrt(np.mean((found[k] - x) ** 2)) for k, x in (("gaussian", gaussian), ("mean", mean))])
    orders = np.log2(np.array(errors[0]) / errors[1])  # four times the points are half as far apart
    assert orders.min() > degree - 1.3


@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_errors_hold_what_they_promise(noise):
    points, gaussian, mean = torus(6000)
    scatter = np.random.default_rng(1).normal(size=points.shape)
    found = quintrig.scan_curvature(points + noise * scatter)
    assert (np.abs(found["gaussian"] - gaussian) <= found.errors["gaussian"]).mean() > 0.9
    assert (np.abs(found["mean"] - mean) <= found.errors["mean"]).mean() > 0.9
    assert np.median(found.errors["mean"]) < 0.1  # and are no excuse
    assert not found.border.any()
    assert found["k1"] - found["k2"] == pytest.approx(
        2 * np.sqrt(np.maximum(found["mean"] ** 2 - found["gaussian"], 0))
    )
    d1, n = found["direction1"], found["normal"]
    known = np.isfinite(d1).all(axis=1)
    assert np.abs(np.einsum("ij,ij->i", d1, n)[known]).max() < 1e-9


def test_noise_does_not_hide_what_the_degree_misses():
    """A band of a sphere with few points: the error is that of the polynomials, beside a little noise."""
    rng = np.random.default_rng(5)
    around, z = rng.uniform(0, 2 * np.pi, 900), rng.uniform(-0.95, 0.95, 900)
    ball = np.stack([np.sqrt(1 - z * z) * np.cos(around), np.sqrt(1 - z * z) * np.sin(around), z], axis=1)
    for noise in (2e-5, 2e-3):
        found = quintrig.scan_curvature(ball + noise * rng.normal(size=ball.shape))
        inner = ~found.border
        assert (np.abs(found["gaussian"] - 1) <= found.errors["gaussian"])[inner].mean() > 0.93
        assert (np.abs(z[found.border]) > 0.7).all()
        assert found.border[np.abs(z) > 0.93].mean() > 0.5  # also among many neighbours, which reach over the hole


def test_large_scans_are_taken_in_blocks_and_at_some_of_their_points(monkeypatch):
    points, _, _ = torus(1200)
    asked = {"degree": 2, "neighbours": 20}
    whole = quintrig.scan_curvature(points, **asked)
    monkeypatch.setattr("quintrig.scan.curvature._BLOCK", 500)
    told = []
    blocks = quintrig.scan_curvature(points, **asked, progress=lambda *word: told.append(word[1:]))
    assert told == [(500, 1200), (1000, 1200), (1200, 1200)]
    at = np.linspace(0, len(points) - 1, 400).astype(int)
    some = [quintrig.scan_curvature(one, **asked, most=400) for one in (points, whole.scan)]
    assert some[0].scan.points.tolist() == points[at].tolist()
    for found, where in ((blocks, slice(None)), (some[0], at), (some[1], at)):
        np.testing.assert_allclose(found["mean"], whole["mean"][where], atol=1e-12)
        np.testing.assert_allclose(found["normal"], whole["normal"][where], atol=1e-12)


def test_points_on_a_line_have_no_curvature(tmp_path):
    with pytest.raises(ValueError, match="found all on a line"):
        quintrig.scan_curvature(np.arange(60.0).reshape(20, 3))
    (tmp_path / "p.xyz").write_text("1 2 3\n" * 20)
    assert "p.xyz: expected points apart from each other" in RUN("table", tmp_path / "p.xyz").err


def test_signs_sides_and_borders():
    t = np.linspace(-1, 1, 41)
    x, y = (a.ravel() for a in np.meshgrid(t, t))
    bowl = np.stack([x, y, 0.5 * (x * x + y * y)], axis=-1)
    found = quintrig.scan_curvature(bowl)
    middle = int(np.argmin(np.abs(x) + np.abs(y)))
    assert found["normal"][middle] == pytest.approx([0, 0, 1], abs=1e-6)  # upwards, and a bowl bends towards it
    assert found["mean"][middle] == pytest.approx(1, abs=found.errors["mean"][middle] + 1e-9)
    assert found["shape_index"][middle] == pytest.approx(-1, abs=0.01)
    rim = np.maximum(np.abs(x), np.abs(y)) > 0.999
    assert found.border[rim].mean() > 0.95
    assert not found.border[np.maximum(np.abs(x), np.abs(y)) < 0.8].any()
    down = quintrig.Scan(bowl, normals=np.tile([0.0, 0, -1], (len(bowl), 1)))
    assert quintrig.scan_curvature(down)["mean"][middle] == pytest.approx(-found["mean"][middle])
    flat = quintrig.scan_curvature(np.stack([x, y, 0 * x], axis=-1))
    assert set(flat["point_type"].tolist()) == {4}  # planar
    with pytest.raises(ValueError, match="at least 10"):
        quintrig.scan_curvature(bowl[:5])
    with pytest.raises(ValueError, match="scan has"):
        found["beta0"]


def test_import_lists_a_scan_of_any_format(tmp_path):
    for name, text in (("a.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n"), ("b.xyz", "# unit mm\n0 0 0\n1 0 0\n0 1 0\n")):
        (tmp_path / name).write_text(text, encoding="utf-8")
        assert "points 3" in RUN("import", tmp_path / name, "--list").out


def test_commands_take_a_scan_as_they_take_a_model(tmp_path):
    points, gaussian, _ = torus(1200)
    file = tmp_path / "scan.xyz"
    np.savetxt(file, points)
    done = RUN("table", file, "-q", "gaussian,mean", "--unit", "mm", "-o", tmp_path / "t.json")
    assert done.code == 0, done.err
    told = json.loads((tmp_path / "t.json").read_text())
    row = told["rows"][7]
    assert abs(row["gaussian"] - gaussian[7]) < 5 * row["gaussian_error"]
    assert next(one["unit"] for one in told["columns"] if one["key"] == "gaussian_error") == "1/mm²"
    assert "border" in RUN("table", file).out
    assert RUN("plot", file, "-q", "gaussian,point_type", "-o", tmp_path / "p.png").code == 0
    assert RUN("report", file, tmp_path / "page.html").code == 0
    assert "Polynomials of degree" in (tmp_path / "page.html").read_text()
    assert RUN("export", file, tmp_path / "k.ply").code == 0
    assert quintrig.read_scan(tmp_path / "k.ply").points == pytest.approx(points)
    assert RUN("import", file, "-o", tmp_path / "points.csv").code == 0
    assert quintrig.read_scan(tmp_path / "points.csv").points == pytest.approx(points, rel=1e-15)
    assert "points 1,200" in RUN("import", file, "--list").out
    for arguments, words in (
        (["table", file, "--at", "0,0"], "belong to surfaces"),
        (["table", file, "-q", "beta0"], "a scan has"),
        (["table", file, "--degree", "9"], "degree: expected 2 to 5"),
        (["export", file, tmp_path / "k.step"], "expected a name ending in"),
    ):
        done = RUN(*arguments)
        assert (done.code, done.out) == (2, "")
        assert words in done.err


def test_a_scan_its_curvature_and_a_deviation_are_plotted():
    t = np.linspace(0, 1, 12)
    surface = quintrig.sphere(5.0)
    scan = quintrig.Scan(surface(0.2 + 0.2 * t[:, None], 0.2 * t).reshape(-1, 3), unit="mm", name="cap")
    found = quintrig.scan_curvature(scan)
    for subject, names, axes in ((scan, "surface", 1), (scan, ["K", "mean"], 4), (found, "gaussian", 2)):
        assert len(quintrig.plot(subject, names).axes) == axes  # each with its scale
    title = quintrig.plot(quintrig.deviation(surface, scan), heading="cap").get_suptitle()
    assert title == "cap"
    with pytest.raises(ValueError, match="axes"):
        quintrig.plot(scan, axes=object())


def test_the_table_of_a_surface_is_read_back_by_the_names_of_its_columns(tmp_path):
    written = tmp_path / "lid.csv"
    done = RUN("table", EXAMPLES / "car_boot.toml", "--grid", "5x7", "-o", written)
    assert done.code == 0, done.err
    assert "elliptic" in written.read_text() or "hyperbolic" in written.read_text()
    points = quintrig.read_scan(written).points
    u, v = quintrig.grid(5, 7)
    there = quintrig.load(EXAMPLES / "car_boot.toml").surface(u, v).reshape(-1, 3)
    np.testing.assert_allclose(points, there, atol=1e-10)
