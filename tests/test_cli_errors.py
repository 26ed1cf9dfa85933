"""Mistakes on the command line: one line that names place and remedy, exit code 2, nothing half written."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from cli_runner import quintrig as cli

EXAMPLES = Path(__file__).parent.parent / "examples"
BOOT = EXAMPLES / "car_boot.toml"
SEVERAL = EXAMPLES / "rear_of_car.toml"
SPHERE = EXAMPLES / "sphere.toml"


def refused(result, *words):
    """Check that a run was refused as it should, and that its message has the words."""
    assert result.code == 2, result.err
    assert result.out == ""
    lines = result.err.splitlines()
    assert len(lines) == 1, result.err
    assert lines[0].startswith("quintrig: ")
    assert lines[0].isprintable()
    for word in words:
        assert word in lines[0]


# --- what is asked for

MISTAKES = [
    # parameters
    (["table", BOOT, "--at", "nan,0.5"], "u[0] = nan is outside the domain [0, 1]"),
    (["table", BOOT, "--at", "0.5,inf"], "v[0] = inf is outside the domain [0, 1]"),
    (["table", BOOT, "--at", "-0.1,0.5"], "u[0] = -0.1 is outside the domain [0, 1]"),
    (["table", BOOT, "--at", "0.5,1.0000001"], "v[0] = 1.0000001 is outside the domain [0, 1]"),
    (["table", BOOT, "--at", "0.5"], "--at: expected 2 numbers separated by commas, got '0.5'"),
    (["table", BOOT, "--at", "0.5,0.5,0.5"], "--at: expected 2 numbers"),
    (["table", BOOT, "--at", "a,b"], "--at: expected 2 numbers separated by commas, got 'a,b'"),
    (["table", BOOT, "--at", ""], "--at: expected 2 numbers"),
    (["table", BOOT, "--grid", "0x5"], "--grid: expected", "0x5"),
    (["table", BOOT, "--grid", "1x5"], "--grid: expected", "1x5"),
    (["table", BOOT, "--grid", "-3x5"], "--grid: expected two counts such as 20x30, got '-3x5'"),
    (["table", BOOT, "--grid", "axb"], "--grid: expected two counts such as 20x30, got 'axb'"),
    (["table", BOOT, "--grid", "2x3x4"], "--grid: expected two counts"),
    (["table", BOOT, "--grid", "2000x2000"], "--grid: expected at most 250,000 points", "quintrig grid"),
    (["table", BOOT, "--grid", "9" * 5000], "--grid: expected at most 250,000 points"),
    (["table", BOOT, "--grid", "51x50"], "--format: expected csv, json, md or latex for 2,550 points"),
    (["table", BOOT, "--grid", "3x3", "--at", "0,0"], "expected one of them"),
    (["plot", BOOT, "-o", "p.png", "--at", "0.5,7"], "v = 7 is outside the domain [0, 1]"),
    # quantities and forms
    (["table", BOOT, "-q", "gausian"], "unknown quantity 'gausian'; did you mean 'gaussian'?"),
    (["table", BOOT, "-q", ""], "unknown quantity ''"),
    (["table", BOOT, "--metric", "flat"], "Invalid value for '--metric'", "see quintrig table --help"),
    (["table", BOOT, "-f", "xml"], "Invalid value for", "see quintrig table --help"),
    (["table", BOOT, "-o", "table.xlsx"], "table.xlsx: expected a name ending in .csv, .json, .md, .tex"),
    (["plot", BOOT, "-o", "p.png", "-q", "normal"], "'normal' is a vector"),
    (["plot", BOOT, "-o", "p.png", "-q", "men"], "unknown quantity 'men'; did you mean 'mean'?"),
    (["plot", BOOT, "-o", "p.gif"], "p.gif: expected a file name ending in .png, .svg, .pdf, .eps"),
    (["plot", BOOT, "-o", "p.png", "--view", "front"], "--view: expected iso, side, back, top, all, flat or AZIMUTH"),
    (["plot", BOOT, "-o", "p.png", "--view", "10,95"], "--view: expected an azimuth within ±360"),
    (["plot", BOOT, "-o", "p.png", "--view", "nan,5"], "--view: expected an azimuth within ±360"),
    (["plot", BOOT, "-o", "p.png", "--view", "flat"], "a flat map needs a quantity"),
    (["plot", BOOT, "-o", "p.png", "--dpi", "100000"], "--dpi: expected 30 to 600 dots per inch"),
    (["plot", BOOT], "Missing option '-o'"),
    # shape parameters
    (["plot", BOOT, "-o", "p.png", "--shape", "1,1,1"], "shape: expected 4 numbers (alpha1, zeta1, alpha2, zeta2), f"),
    (["plot", BOOT, "-o", "p.png", "--shape", "1,1,1,5"], "shape[3] (zeta2) = 5 is outside [-4, 1]"),
    (["plot", BOOT, "-o", "p.png", "--shape", "1,1,1,nan"], "shape[3]: expected a finite number, got nan"),
    (["compare", BOOT, "--shape", "1;1;1;1"], "--shape: expected numbers separated by commas, got '1;1;1;1'"),
    (["compare", BOOT, *["--shape", "1,1,1,1"] * 13], "--shape: expected at most 12 sets, got 13"),
    (["compare", SPHERE], "a sphere has no shape parameters to vary"),
    (["compare", EXAMPLES / "classical.toml"], "in the Bernstein basis has no shape parameters to vary; take another"),
    (["compare", EXAMPLES / "developable.toml", "--shape", "1,1,1,1"], "shape: expected 2 numbers (alpha, zeta), f"),
    # patches
    (["table", SEVERAL, "--patch", "boot lit"], "no patch 'boot lit'; did you mean 'boot lid'?"),
    (["plot", SEVERAL, "-o", "p.png", "-q", "mean", "--view", "flat"], "--patch: a flat map shows one surface"),
    # commands
    (["chek", BOOT], "No such command 'chek'"),
    (["check"], "Missing argument 'MODEL...'", "see quintrig check --help"),
    (["check", BOOT, "--srtict"], "No such option: --srtict"),
    (["new"], "Missing argument 'KIND'"),
    (["new", "swpt"], "kind: expected one of tensor, symmetric", "got 'swpt'; did you mean 'swept'?"),
    (["new", "swept", "-o", "model.json"], "model.json: expected a name ending in .toml"),
    (["reproduce"], "OUT: expected a folder to write to, or --list"),
]


@pytest.mark.parametrize(
    ("arguments", "words"), [(m[0], m[1:]) for m in MISTAKES], ids=[f"{i}-{m[0][0]}" for i, m in enumerate(MISTAKES)]
)
def test_a_mistake_is_told_in_one_line(arguments, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    refused(cli(*arguments), *words)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("u,v\n0.5,2\n", "points.csv: row 2: expected v in the domain [0, 1], got 2"),
        ("0.5,0.5\n0.5,nan\n", "points.csv: row 2: expected v in the domain [0, 1], got nan"),
        ("# of the lid\n\n0.5,0.5\n-1,0\n", "points.csv: row 4: expected u in the domain [0, 1], got -1"),
        ("0.5\n", "row 1: expected 2 numbers, u and v, got 1"),
        ("0,0\n1,2,3\n", "row 2: expected 2 numbers, u and v, got 3"),
        ("0,0\na,b\n", "row 2: expected numbers, got 'a, b'"),
        ("u,v\n", "expected 1 to 250,000 rows of u and v, got 0"),
        ("", "expected 1 to 250,000 rows of u and v, got 0"),
    ],
)
def test_points_of_a_file(text, words, tmp_path):
    file = tmp_path / "points.csv"
    file.write_text(text)
    refused(cli("table", BOOT, "--points", file), words)


def test_points_in_a_file_that_is_no_text(tmp_path):
    file = tmp_path / "bin.csv"
    file.write_bytes(b"0,0\n\xff\xfe")
    words = ("bin.csv: expected text in UTF-8, found the byte 0xff in line 2", "is this a table of numbers?")
    refused(cli("table", BOOT, "--points", file), *words)


def test_a_missing_file_of_points(tmp_path):
    refused(cli("table", BOOT, "--points", tmp_path / "none.csv"), "none.csv: no such file; check the path")


# --- models

MODELS = {
    "unknown.toml": (b'kind = "sphere"\nraduis = 2', "unknown key 'raduis'; did you mean 'radius'?"),
    "count.toml": (b'kind = "swept"\nsection = [[0, 0, 0]]\ntrajectory = []', "section: expected 6 points, got 1"),
    "nan.toml": (b'kind = "sphere"\nradius = nan', "radius: expected a finite number, got nan"),
    "text.toml": (b'kind = "sphere"\nradius = "2"', "radius: expected a number, got '2'"),
    "bool.json": (b'{"kind": "sphere", "radius": true}', "radius: expected a number, got true"),
    "huge.toml": (b'kind = "sphere"\nradius = 1e60', "radius: expected a number of size at most 1e50, got 1e+60"),
    "long.json": (b'{"kind": "sphere", "radius": 1' + b"0" * 400 + b"}", "expected a number of size at most 1e50"),
    "deep.json": (b"[" * 100_000, "nested too deeply"),
    "deep.toml": (b"a = " + b"[" * 100_000, "nested too deeply"),
    "empty.toml": (b"", "the file is empty"),
    "binary.json": (bytes(range(256)) * 100, "expected text in UTF-8"),
    "twice.toml": (b'kind = "sphere"\nkind = "torus"', "a key is given twice"),
    "model.yaml": (b"kind: sphere", "expected a file ending in .toml or .json"),
    "escape.toml": (b'kind = "sphere"\n"\\u001b[2J" = 1', "unknown key '\\x1b[2J'"),
    "two\nlines.toml": (b"", "lines.toml: the file is empty"),
}


@pytest.mark.parametrize("command", ["check", "table", "plot", "report", "compare"])
@pytest.mark.parametrize("name", MODELS)
def test_a_bad_model_is_told_in_one_line_by_every_command(name, command, tmp_path):
    content, words = MODELS[name]
    path = tmp_path / name
    path.write_bytes(content)
    more = {"plot": ["-o", tmp_path / "out.png"], "report": [tmp_path / "out"]}.get(command, [])
    refused(cli(command, path, *more), words, "toml" if name.endswith("toml") else name.split(".")[1])
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("command", ["check", "table"])
def test_missing_files_and_folders(command, tmp_path):
    (tmp_path / "folder.toml").mkdir()
    refused(cli(command, tmp_path / "none.toml"), "none.toml: no such file; check the path")
    refused(cli(command, tmp_path / "folder.toml"), "folder.toml: expected a file, found a folder")
    refused(cli(command, BOOT / "x.toml"), "cannot be read")
    refused(cli(command, tmp_path / ("x" * 400 + ".toml")), "cannot be read")


def test_a_hundred_megabytes_of_junk(tmp_path):
    path = tmp_path / "junk.toml"
    with path.open("wb") as file:
        file.truncate(100 * 2**20)
    refused(cli("check", path), "expected at most 16 MB, found 100 MB; is this a model?")


# --- output that cannot be written

WRITERS = {
    "table": ["table", BOOT, "--at", "0,0", "-o"],
    "schema": ["schema", "-o"],
    "plot": ["plot", BOOT, "--dpi", "30", "-o"],
    "new": ["new", "swept", "--force", "-o"],
}
SUFFIX = {"table": ".csv", "schema": ".json", "plot": ".png", "new": ".toml"}


@pytest.mark.parametrize("command", WRITERS)
def test_a_folder_stands_where_the_file_should_go(command, tmp_path):
    place = tmp_path / f"out{SUFFIX[command]}"
    place.mkdir()
    refused(cli(*WRITERS[command], place), "expected the name of a file to write, found a folder; add a file name")
    assert list(place.iterdir()) == []


@pytest.mark.parametrize("command", WRITERS)
def test_a_file_stands_where_a_folder_should_be(command, tmp_path):
    blocker = tmp_path / "file"
    blocker.write_text("precious")
    refused(cli(*WRITERS[command], blocker / f"out{SUFFIX[command]}"), "cannot be written", "choose another place")
    assert blocker.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [blocker]


@pytest.mark.parametrize("command", WRITERS)
@pytest.mark.parametrize("step", ["mkstemp", "write", "replace"])
def test_a_failure_keeps_the_old_file_and_leaves_nothing(command, step, tmp_path, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device")

    place = tmp_path / f"out{SUFFIX[command]}"
    place.write_text("precious")
    name = {"mkstemp": "tempfile.mkstemp", "write": "os.fdopen", "replace": "pathlib.Path.replace"}[step]
    monkeypatch.setattr(name, full)
    result = cli(*WRITERS[command], place)
    monkeypatch.undo()
    refused(result, f"{place}: cannot be written (No space left on device)")
    assert place.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [place]


def test_the_studio_sends_a_cad_file_to_import(tmp_path):
    place = tmp_path / "lid.step"
    place.write_text("ISO-10303-21;")
    refused(
        cli("view", place, "--no-browser"), "lid.step: the studio opens models", "quintrig import lid.step -o lid.toml"
    )


def test_compare_into_a_file(tmp_path):
    place = tmp_path / "out"
    place.write_text("precious")
    refused(cli("compare", BOOT, place), "expected a folder or an .html page to write, found another file")
    assert place.read_text() == "precious"


@pytest.mark.parametrize("command", [["report", BOOT], ["reproduce"]])
def test_pages_into_a_path_below_a_file(command, tmp_path):
    blocker = tmp_path / "file"
    blocker.write_text("precious")
    result = cli(*command, blocker / "out")
    assert result.code == 2
    assert "cannot be written" in result.err.splitlines()[-1]
    assert blocker.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [blocker]


def test_reproduce_keeps_a_folder_that_holds_other_things(tmp_path):
    (tmp_path / "thesis.tex").write_text("precious")
    refused(cli("reproduce", tmp_path), "expected a new or empty folder")
    assert (tmp_path / "thesis.tex").read_text() == "precious"


def test_a_device_that_is_full():
    result = subprocess.run(
        [sys.executable, "-m", "quintrig", "schema"],
        stdout=Path("/dev/full").open("w"),  # noqa: SIM115
        stderr=subprocess.PIPE,
        text=True,
        timeout=60,
        check=False,
    )
    assert result.returncode == 2
    assert result.stderr.count("\n") == 1
    assert "No space left on device" in result.stderr


# --- as a user starts it


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["check", "none.toml"], "none.toml: no such file"),
        (["table", BOOT, "--at", "nan,0"], "outside the domain [0, 1]"),
        (["check", "deep.json"], "deep.json: nested too deeply"),
    ],
)
def test_from_a_shell(arguments, words, tmp_path):
    (tmp_path / "deep.json").write_text('{"a": ' * 100_000)
    result = subprocess.run(
        [sys.executable, "-m", "quintrig", *map(str, arguments)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith("quintrig: ")
    assert result.stderr.count("\n") == 1
    assert words in result.stderr


def test_debug_shows_where(tmp_path):
    result = cli("--debug", "table", tmp_path / "none.toml")
    assert result.code == 2
    assert "Traceback" in result.err
    assert result.err.splitlines()[-1].endswith("none.toml: no such file; check the path")


def test_deep_models_through_the_dictionary_too():
    from quintrig.model.model import Model
    from quintrig.support.errors import ModelError

    with pytest.raises(ModelError, match=r"radius: expected a number, got \[\[\[\["):
        Model.from_dict(json.loads('{"kind": "sphere", "radius": ' + "[" * 900 + "]" * 900 + "}"))
