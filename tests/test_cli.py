"""The command line: what each command does, what it says where, and how it ends."""

import csv
import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import quintrig
from cli_runner import quintrig as cli
from quintrig import __version__
from quintrig.model.kinds.registry import OWN as KINDS
from quintrig.model.schema import json_schema
from quintrig.quantities.table import QUANTITIES
from quintrig.shaping.shape_effect import standard_shapes

EXAMPLES = Path(__file__).parent.parent / "examples"
BOOT = EXAMPLES / "car_boot.toml"
COMMANDS = ("new", "check", "table", "plot", "report", "compare", "reproduce", "schema")


def python(*arguments, **options):
    return subprocess.run(
        [sys.executable, *arguments], capture_output=True, text=True, timeout=120, check=False, **options
    )


# --- help, version, start


def test_help_lists_every_command():
    result = cli("--help")
    assert result.code == 0
    assert result.err == ""
    for command in COMMANDS:
        assert f" {command} " in result.out


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help_with_examples(command):
    result = cli(command, "--help")
    assert result.code == 0
    assert "Examples" in result.out
    assert f"quintrig {command}" in result.out.split("Examples")[1]
    assert max(map(len, result.out.splitlines())) <= 80


def test_version():
    assert cli("--version").out == f"quintrig {__version__}\n"


def test_no_command_shows_the_help():
    result = cli()
    assert "Usage" in result.out + result.err
    assert result.code == 2


def test_help_loads_nothing_heavy():
    script = (
        "import sys\nfrom quintrig.cli.app import build\nfrom quintrig.cli.ending import run\n"
        "assert run(build, ['--help']) == 0\n"
        "sys.exit(', '.join({'numpy', 'numba', 'scipy', 'matplotlib', 'pydantic', 'jinja2'} & sys.modules.keys()) or 0)"
    )
    result = python("-c", script)
    assert result.stderr.strip() == ""
    assert result.returncode == 0


def test_import_loads_nothing_heavy():
    script = (
        "import sys, quintrig\nsys.exit(', '.join({'numpy', 'numba', 'pydantic', 'rich'} & sys.modules.keys()) or 0)"
    )
    result = python("-c", script)
    assert (result.returncode, result.stderr.strip()) == (0, "")


def test_python_m_runs_it():
    result = python("-m", "quintrig", "--version")
    assert (result.returncode, result.stdout) == (0, f"quintrig {__version__}\n")


# --- check


def test_check_tells_what_a_model_is():
    result = cli("check", BOOT)
    assert result.code == 0
    for words in (
        "Car boot lid",
        "swept",
        "mm",
        "α1 = 1, ζ1 = 1, α2 = 0, ζ2 = 0",
        "along S_u × S_v",
        "1/mm²",
        "no warnings",
    ):
        assert words in result.out


def test_check_tells_of_a_turned_normal():
    assert "against S_u × S_v" in cli("check", EXAMPLES / "swung.toml").out


def test_check_warns_and_strict_makes_it_fail():
    sphere = EXAMPLES / "sphere.toml"
    result = cli("check", sphere)
    assert "warning" in result.out
    assert "singular" in result.out
    assert result.code == 0
    assert cli("check", "--strict", sphere).code == 1
    assert cli("check", "--strict", BOOT).code == 0


def test_a_note_does_not_make_strict_fail():
    result = cli("check", "--strict", EXAMPLES / "cylinder.toml")
    assert result.code == 0
    assert "note" in result.out
    assert "vertical" in result.out
    assert "no warnings" in result.out


def test_check_tells_no_shape_parameters_where_they_do_not_act():
    assert "α1" not in cli("check", EXAMPLES / "classical.toml").out
    assert "α1" in cli("check", BOOT).out


def test_check_goes_on_after_a_bad_model(tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text('kind = "spere"')
    result = cli("check", bad, BOOT)
    assert result.code == 2
    assert "Car boot lid" in result.out
    assert result.err.count("\n") == 1
    assert "did you mean 'sphere'" in result.err


def test_check_names_every_patch():
    result = cli("check", EXAMPLES / "rear_of_car.toml")
    assert "rear window" in result.out
    assert "boot lid" in result.out


def test_names_are_not_taken_for_markup(tmp_path):
    path = tmp_path / "m.toml"
    path.write_text('kind = "sphere"\nname = "[red]ball[/red] [/]"')
    assert "[red]ball[/red] [/]" in cli("check", path).out


DEGENERATE = {
    "all points coincide": f"section = {[[0, 0, 0]] * 6}\ntrajectory = {[[0, 0, 0]] * 6}",
    "a curve only": f"section = {[[0, 0, 0]] * 6}\ntrajectory = {[[0, i, i * i] for i in range(6)]}",
    "coinciding neighbours": f"section = {[[0, 0, 0], [0, 0, 0], [4, 0, 3], [6, 0, 3], [8, 0, 1], [9, 0, 0]]}\n"
    f"trajectory = {[[0, i, i * i] for i in range(6)]}",
    "alpha = -4": f"shape = [-4, 0, 0, -4]\nsection = {[[i, 0, i * i] for i in range(6)]}\n"
    f"trajectory = {[[0, i, 5 * i - i * i] for i in range(6)]}",
    "hull lost": f"unchecked_shape = true\nshape = [3, 0, 0, 0]\nsection = {[[i, 0, i * i] for i in range(6)]}\n"
    f"trajectory = {[[0, i, 5 * i - i * i] for i in range(6)]}",
}


@pytest.mark.parametrize("text", DEGENERATE.values(), ids=DEGENERATE)
def test_degenerate_models_are_computed_and_warned_of(text, tmp_path):
    path = tmp_path / "m.toml"
    path.write_text(f'kind = "swept"\n{text}\n')
    result = cli("check", path)
    assert (result.code, result.err) == (0, "")
    assert "warning" in result.out
    assert cli("check", "--strict", path).code == 1
    table = cli("table", path, "--grid", "3x3", "-f", "json")
    assert table.code == 0
    assert len(json.loads(table.out)["rows"]) == 9


def test_curvature_without_bound_is_told_as_infinite(tmp_path):
    path = tmp_path / "m.toml"  # a swung surface that closes in a point: H grows like 1/r towards it
    path.write_text(
        'kind = "swung"\nprofile = [[0, 0], [1, 1], [2, 2], [2, 3], [1, 4], [0, 5]]\n'
        "trajectory = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1]]\n"
    )
    result = cli("check", path)
    assert result.code == 0
    assert "to ∞" in result.out
    assert "without bound" in result.out


def test_an_edge_of_regression_inside_is_told(tmp_path):
    planes = [[0, 1, 4, -20], [1, 1, 5, -24], [2, 1, 4, -30], [3, 0, 4, -33], [4, 1, 3, -40], [5, 2, 4, -44]]
    path = tmp_path / "m.toml"
    path.write_text(f'kind = "developable"\nplanes = {planes}\nbounds = [[0, 1, 0, 0], [0, 1, 0, -10]]\n')
    result = cli("check", path)
    assert result.code == 0
    assert "edge of regression" in result.out


# --- table


def test_table_on_the_screen_states_unit_and_normal():
    result = cli("table", BOOT, "--at", "0.5,0.5")
    assert result.code == 0
    assert "Lengths in mm." in result.out
    assert "The normal n points along S_u × S_v" in result.out
    assert result.err == ""


def test_table_at_points_matches_the_library():
    result = cli("table", BOOT, "--at", "0.25,0.5", "--at", "1,0", "-f", "json")
    rows = json.loads(result.out)["rows"]
    surface = quintrig.load(BOOT).surface
    sample = quintrig.analyse(surface, [0.25, 1.0], [0.5, 0.0])
    assert [row["gaussian"] for row in rows] == sample["gaussian"].tolist()
    assert [[row["x"], row["y"], row["z"]] for row in rows] == sample.point.tolist()


@pytest.mark.parametrize(("choice", "count"), [((), 25), (("--grid", "3x4"), 12), (("--grid", "6"), 36)])
def test_table_on_grids(choice, count):
    assert len(json.loads(cli("table", BOOT, *choice, "-f", "json").out)["rows"]) == count


def test_table_at_points_of_a_file(tmp_path):
    file = tmp_path / "points.csv"
    file.write_text("u,v\n0.5,0.25\n1,1\n")
    rows = json.loads(cli("table", BOOT, "--points", file, "-f", "json").out)["rows"]
    assert [(row["u"], row["v"]) for row in rows] == [(0.5, 0.25), (1, 1)]


@pytest.mark.parametrize("suffix", [".csv", ".json", ".md", ".tex"])
def test_table_takes_the_format_from_the_file(suffix, tmp_path):
    file = tmp_path / f"t{suffix}"
    result = cli("table", BOOT, "-o", file)
    assert (result.code, result.out) == (0, "")
    assert str(file) in result.err
    start = {".csv": "# Car boot lid", ".json": "{", ".md": "**Car boot lid**", ".tex": "% needs"}[suffix]
    assert file.read_text().startswith(start)


def test_table_on_stdout_is_data_alone():
    result = cli("table", BOOT, "--grid", "2x2", "-f", "csv", "-q", "gaussian,mean")
    rows = list(csv.reader(line for line in result.out.splitlines() if not line.startswith("#")))
    assert rows[0] == ["u", "v", "x", "y", "z", "gaussian", "mean"]
    assert len(rows) == 5
    assert result.err == ""


def test_table_of_one_patch_of_several():
    path = EXAMPLES / "rear_of_car.toml"
    result = cli("table", path)
    assert result.code == 0
    assert "rear window" in result.out
    assert "boot lid" in result.out
    assert "boot lid" in cli("table", path, "--patch", "boot lid").out


def test_list_shows_every_quantity():
    result = cli("table", "--list")
    assert result.code == 0
    words = result.out.split()
    assert all(q.key in words for q in QUANTITIES)


# --- new, schema


@pytest.mark.parametrize("kind", KINDS)
def test_new_writes_a_model_that_check_accepts(kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert cli("new", kind).code == 0
    path = tmp_path / f"{kind}.toml"
    assert path.read_text().startswith("# ")
    result = cli("check", path)
    assert (result.code, result.err) == (0, "")
    assert kind in result.out


def test_new_does_not_overwrite(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("precious")
    result = cli("new", "swept", "-o", path)
    assert result.code == 2
    assert "--force" in result.err
    assert path.read_text() == "precious"
    assert cli("new", "swept", "-o", path, "--force").code == 0
    assert tomllib.loads(path.read_text())["kind"] == "swept"


def test_new_prints_to_the_screen():
    assert tomllib.loads(cli("new", "ruled", "-o", "-").out)["kind"] == "ruled"


def test_schema_prints_and_writes_the_same(tmp_path):
    path = tmp_path / "s.json"
    result = cli("schema")
    assert json.loads(result.out) == json_schema()
    assert cli("schema", "-o", path).code == 0
    assert json.loads(path.read_text()) == json_schema()


# --- plot, compare


MAGIC = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}


@pytest.mark.parametrize(
    ("suffix", "options"),
    [
        (".png", ["--net", "--at", "0.5,0.5"]),
        (".svg", ["-q", "gaussian", "--view", "flat"]),
        (".pdf", ["-q", "mean", "--view", "top", "--lines", "0"]),
        (".png", ["-q", "surface,hk_type", "--view", "30,20"]),
        (".png", ["-q", "gaussian,mean", "--view", "flat"]),
        (".png", ["--view", "all"]),
        (".png", ["--shape", "1,0,-2,-3"]),
    ],
)
def test_plot_writes_a_picture(suffix, options, tmp_path):
    path = tmp_path / f"p{suffix}"
    result = cli("plot", BOOT, "-o", path, "--dpi", 40, *options)
    assert (result.code, result.out) == (0, ""), result.err
    assert path.read_bytes().startswith(MAGIC[suffix])
    assert list(tmp_path.iterdir()) == [path]


def test_plot_shows_all_patches_together(tmp_path):
    path = tmp_path / "p.png"
    assert cli("plot", EXAMPLES / "rear_of_car.toml", "-o", path, "--dpi", 40).code == 0
    assert path.stat().st_size > 1000


def test_compare_prints_the_intensities():
    result = cli("compare", EXAMPLES / "developable.toml")
    assert result.code == 0
    for words in ("(1, 1)", "(0, -4)", "(-2, 0)", "(-2, -4)", "K min", "H max", "bending energy", "Lengths in m."):
        assert words in result.out


def test_compare_writes_pictures_and_tables(tmp_path):
    out = tmp_path / "shapes"
    result = cli("compare", BOOT, out, "--shape", "1,1,1,1", "--shape", "1,1,-3,-3", "-q", "gaussian")
    assert result.code == 0, result.err
    assert result.out == f"{out / 'index.html'}\n"
    names = {path.name for path in out.iterdir()}
    assert {
        "index.html",
        "surface.png",
        "gaussian.png",
        "gaussian_map.png",
        "intensities.csv",
        "intensities.md",
    } <= names
    lines = [line for line in (out / "intensities.csv").read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    model = quintrig.load(BOOT)
    shapes = (model.patch().shape, (1, 1, 1, 1), (1, 1, -3, -3))
    assert [row["shape"] for row in rows] == [str(tuple(int(x) for x in shape)) for shape in shapes]
    for row, shape in zip(rows, shapes, strict=True):
        k = quintrig.analyse(model.with_shape(shape).surface, *quintrig.grid(101, 101), ["gaussian"])["gaussian"]
        assert float(row["gaussian_min"]) <= k.min() * (1 - 1e-9)
        assert float(row["gaussian_max"]) >= k.max() * (1 - 1e-9)


@pytest.mark.parametrize("shape", ["-1,0.5,0,1", "0,0,0,0"])
def test_compare_sets_the_models_own_shape_first(shape, tmp_path):
    model = tmp_path / "m.toml"
    model.write_text((EXAMPLES / "swept.toml").read_text())
    own = quintrig.load(model).patch().shape
    result = cli("compare", model, "--shape", shape)
    assert result.code == 0, result.err
    (heads,) = [line for line in result.out.splitlines() if line.startswith("  shape ")]  # two rows stand as columns
    assert heads.split("shape")[1].strip().startswith(f"({', '.join(f'{x:g}' for x in own)}) as in the file")
    other = tuple(float(x) for x in shape.split(","))
    assert heads.count("(") == (1 if other == own else 2)


def test_compare_writes_one_page_that_stands_alone(tmp_path):
    out = tmp_path / "shapes.html"
    result = cli("compare", EXAMPLES / "developable.toml", out, "--shape", "1,1", "--shape", "0,-4", "-q", "mean")
    assert (result.code, result.out) == (0, f"{out}\n"), result.err
    assert list(tmp_path.iterdir()) == [out]
    text = out.read_text()
    sources = re.findall(r'(?:src|href)="([^"]{0,30})', text)
    assert len(sources) == 3
    assert all(source.startswith("data:image/png;base64,") for source in sources)
    for words in ("(1, 1)", "(0, -4)", "Developable vault", "bending energy", "Lengths in m.", "1/m²"):
        assert words in text


def test_names_are_not_taken_for_html(tmp_path):
    path, out = tmp_path / "m.toml", tmp_path / "out.html"
    path.write_text((EXAMPLES / "swept.toml").read_text().replace("Swept canopy", "<script>alert(1)</script> $x$ & $"))
    assert cli("compare", path, out, "--shape", "0,0,0,0", "-q", "surface").code == 0
    assert "<script" not in out.read_text()


def test_compare_uses_the_sets_of_the_thesis():
    patch = quintrig.load(EXAMPLES / "swept.toml").patch()
    assert standard_shapes(patch) == ((1, 1, 1, 1), (1, 1, -3, -3), (1, -3, 1, -3), (1, 0, -2, -3))
    patch = quintrig.load(EXAMPLES / "developable.toml").patch()
    assert standard_shapes(patch) == ((1, 1), (0, -4), (-2, 0), (-2, -4))


# --- how a run ends


def test_interruption_ends_quietly(monkeypatch):
    def interrupted(_):
        raise KeyboardInterrupt

    monkeypatch.setattr("quintrig.model.model.load", interrupted)
    result = cli("check", BOOT)
    assert (result.code, result.err) == (130, "quintrig: interrupted\n")


def test_a_fault_is_told_in_one_line_and_shown_on_demand(monkeypatch):
    def broken(_):
        raise ZeroDivisionError("deep inside")

    monkeypatch.setattr("quintrig.model.model.load", broken)
    result = cli("check", BOOT)
    assert result.code == 70
    assert result.err.count("\n") == 1
    assert "ZeroDivisionError: deep inside" in result.err
    assert "--debug" in result.err
    shown = cli("--debug", "check", BOOT)
    assert shown.code == 70
    assert "Traceback" in shown.err


def test_an_error_of_numpy_is_a_fault_not_a_mistake(monkeypatch):
    import numpy as np

    monkeypatch.setattr("quintrig.model.model.load", lambda _: np.zeros(2).reshape(3))
    assert cli("check", BOOT).code == 70


def test_memory_runs_out(monkeypatch):
    def large(_):
        raise MemoryError

    monkeypatch.setattr("quintrig.model.model.load", large)
    result = cli("check", BOOT)
    assert (result.code, result.err) == (2, "quintrig: not enough memory; ask for fewer points\n")


def test_a_reader_that_stops_early_is_no_error():
    command = f"{sys.executable} -m quintrig table {BOOT} --grid 100x100 -f csv | head -n 1"
    result = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command], capture_output=True, text=True, timeout=120, check=False
    )
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == "# Car boot lid\n"


def test_ctrl_c_ends_with_130():
    script = "import os, signal\nfrom quintrig.model import model\n"
    script += "model.load = lambda _: os.kill(os.getpid(), signal.SIGINT)\n"
    script += "from quintrig.cli import main\nimport sys\nsys.argv = ['quintrig', 'check', 'x.toml']\nmain()\n"
    result = python("-c", script)
    assert (result.returncode, result.stderr) == (130, "quintrig: interrupted\n")


def test_a_terminal_without_greek_does_not_fail():
    environment = os.environ | {"PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    result = python("-m", "quintrig", "table", str(BOOT), "-f", "csv", env=environment, encoding="utf-8")
    assert result.returncode == 0
    assert "S_u × S_v" in result.stdout


# --- pages


def test_report_says_where_the_page_is(tmp_path, monkeypatch):
    def fake(model, out, *, progress, **_):
        progress("figures", 0, 1)
        assert model.name == "Car boot lid"
        return out / "index.html"

    monkeypatch.setattr("quintrig.report.write_report", fake)
    result = cli("report", BOOT, tmp_path)
    assert (result.code, result.out) == (0, f"{tmp_path / 'index.html'}\n")
    assert "[0/1] figures" in result.err
    assert "open it in a browser" in result.err


def test_reproduce_lists_the_inventory():
    result = cli("reproduce", "--list")
    assert (result.code, result.err) == (0, "")
    for number in ("Figure 2.1", "Figure 4.42", "Table 3.4", "Table 4.8", "Table A1"):
        assert number in result.out
