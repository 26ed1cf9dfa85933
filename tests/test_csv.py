"""Nets and points from CSV and JSON files: what is misspelt is told, nothing is taken for something else."""

import csv
import json

import numpy as np
import pytest

import quintrig
import shapes
from cli_runner import quintrig as cli
from quintrig.analysis.table import tabulate
from quintrig.exchange.nets import model_from_net, to_csv
from quintrig.exchange.tables import to_csv as table_csv
from quintrig.support.csv_rows import guarded, rows_of
from quintrig.support.errors import ModelError
from quintrig.support.numerals import real, whole


@pytest.mark.parametrize(
    "heading",
    [
        "",
        "x,y,z\n",
        "# remark\n\n x , y , z \n",
        '"x (mm)","y","z"\n',
        ",y,\n",
        "α,β′,|n|\n",
        "x1,P0,u_v\r\n",
        "O,l,z\n",
    ],
)
def test_a_heading_is_skipped(heading):
    assert list(rows_of(heading + "1,-2.5,3e-1\n.5,+4.,6\n").values()) == [[1, -2.5, 0.3], [0.5, 4, 6]]


@pytest.mark.parametrize(
    "row",
    [
        "1,2,3x",
        "O.5,1,2",
        "O.5,l.0,O.1",
        "1,2,",
        "0.5;0,5",
        "1.2.3,a,b",
        "-x,y,z",
        "1 2 3",
        "0,5;0,5;1,0",
        "1_0,2,3",
        "x,y,3",
    ],
)
def test_a_slip_in_the_first_row_is_told_and_is_no_heading(row):
    with pytest.raises(ModelError, match="row 1: expected numbers, got "):
        rows_of(f"{row}\n1,2,3\n")


@pytest.mark.parametrize(
    "cell", ["1_0", "1__0", "٣", "1,0", "0x10", "1e", "--1", "1 2", "", "½", "1e1_0", "x" * 200_000]
)
def test_what_is_no_number_in_any_row(cell):
    with pytest.raises(ModelError, match="row 3: expected numbers, got "):
        rows_of(f'x,y\n1,2\n"{cell}",2\n')
    with pytest.raises(ValueError, match="expected a number"):
        real(cell)


def test_numbers_are_read_to_the_last_bit():
    for value in (0.1, -1e-300, 1 / 3, 12345678901234567890.0):
        assert real(f" {value!r} ") == value
    assert np.isnan(real("nan"))
    assert real("-Infinity") == -np.inf
    assert whole(" -12 ") == -12
    for text in ("1.0", "1_0", "1e3", "", "9" * 30, "٣"):
        with pytest.raises(ValueError, match="expected a whole number"):
            whole(text)


def test_lines_are_counted_as_an_editor_does():
    assert rows_of("x\n\n# r\n1\r\n2\r3\n") == {4: [1.0], 5: [2.0], 6: [3.0]}
    with pytest.raises(ModelError, match="row 2: expected numbers, got '2\\\\x0c3'"):
        rows_of("1\n2\x0c3\n")


@pytest.mark.parametrize(
    "arguments",
    [
        ("table", "--at", "1_0,0"),
        ("table", "--at", "٠,0"),
        ("sweep", "--vary", "alpha1=-1_0:1:3", "-o", "out"),
        ("sweep", "--vary", "alpha1=-1:1:1_0", "-o", "out"),
        ("compare", "--shape", "0_1,0,0,0"),
    ],
)
def test_numbers_of_options_are_written_the_same_way(arguments, tmp_path, monkeypatch):
    (tmp_path / "lid.toml").write_text(quintrig_new())
    monkeypatch.chdir(tmp_path)
    done = cli(arguments[0], "lid.toml", *arguments[1:])
    assert done.code == 2
    assert arguments[1] in done.err
    assert not (tmp_path / "out").exists()


def quintrig_new():
    return cli("new", "swept", "-o", "-").out


@pytest.mark.parametrize("name", ["flat.json", "rows.json", "net.csv"])
def test_36_points_in_a_row_are_a_net(name, tmp_path):
    net = shapes.net()
    (tmp_path / "flat.json").write_text(json.dumps(net.reshape(36, 3).tolist()))
    (tmp_path / "rows.json").write_text(json.dumps(net.tolist()))
    (tmp_path / "net.csv").write_text(to_csv(net))
    model = model_from_net(tmp_path / name, {"kind": "tensor"})
    np.testing.assert_array_equal(model.patch().definition.points, net)
    into = tmp_path / "into.toml"
    into.write_text(cli("new", "tensor", "-o", "-").out)
    done = cli("import", tmp_path / name, "--into", into, "--key", "points", "-o", tmp_path / "out.toml")
    assert (done.code, done.err.count("\n")) == (0, 1)
    np.testing.assert_array_equal(quintrig.load(tmp_path / "out.toml").patch().definition.points, net)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ([[1, 2, 3]] * 35, "points: expected a multiple of 6 rows, got 35"),
        ([[1, 2]] * 36, "points[0][0]: expected 3 numbers, got 2"),
        ([], "points: expected 6 rows, got 0"),
        ([1, 2, 3], "points[0]: expected a list, got 1"),
        ({"kind": "sphere", "radius": "x"}, "radius: expected a number"),
        (3, "points: expected a list, got 3"),
    ],
)
def test_other_json_is_told(text, words, tmp_path):
    (tmp_path / "net.json").write_text(json.dumps(text))
    done = cli("import", tmp_path / "net.json", "-o", tmp_path / "out.toml")
    assert (done.code, done.err.count("\n")) == (2, 1)
    assert "net.json: " in done.err
    assert words in done.err


@pytest.mark.parametrize("name", ["ragged.csv", "empty.csv", "ragged.json", "words.json"])
def test_points_that_do_not_fit_into_a_net(name, tmp_path):
    (tmp_path / "ragged.csv").write_text("1,2,3\n1,2\n")
    (tmp_path / "empty.csv").write_text("x,y,z\n")
    (tmp_path / "ragged.json").write_text("[[1, 2, 3], [1, 2]]")
    (tmp_path / "words.json").write_text('[["a", "b"]]')
    (tmp_path / "lid.toml").write_text(quintrig_new())
    arguments = ("--into", tmp_path / "lid.toml", "--key", "section", "-o", tmp_path / "out.toml")
    done = cli("import", tmp_path / name, *arguments)
    assert (done.code, done.err.count("\n")) == (2, 1)
    assert name in done.err


@pytest.mark.parametrize(
    ("cell", "shown"),
    [
        ("=1+1", "'=1+1"),
        ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
        ("-2+3", "'-2+3"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("\t=1", "'\t=1"),
        (" =1", "' =1"),
        ("-", "'-"),
        ("-2.5e-3", "-2.5e-3"),
        ("+4", "+4"),
        ("-inf", "-inf"),
        ("saddle", "saddle"),
        ("a=b", "a=b"),
        ("", ""),
    ],
)
def test_text_is_no_formula_and_numbers_are_numbers(cell, shown):
    assert guarded(cell) == shown


def test_a_name_in_a_table_is_no_formula():
    surface = quintrig.tensor(shapes.net())
    table = tabulate(surface, [0.25, 0.5], 0.5, ["mean", "hk_type"], title='lid,=HYPERLINK("x"), -1;@a')
    lines = table_csv(table).splitlines()
    assert lines[0] == "# lid,'=HYPERLINK(\"x\"), -1;'@a"
    body = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert [float(row["mean"]) for row in body] == list(quintrig.analyse(surface, [0.25, 0.5], 0.5, "mean")["mean"])
