"""What is wrong with a model is told in one line: the place, what was expected, what was found."""

import json

import numpy as np
import pytest

from quintrig.model.model import Model, load
from quintrig.support.errors import ModelError
from quintrig.support.parsing import LARGEST_FILE

SECTION = [[0, 0, 0], [2, 0, 1], [4, 0, 3], [6, 0, 3], [8, 0, 1], [10, 0, 0]]
TRAJECTORY = [[0, 0, 0], [0, 1, 3], [0, 3, 5], [0, 5, 5], [0, 7, 3], [0, 8, 0]]
SWEPT = {"kind": "swept", "section": SECTION, "trajectory": TRAJECTORY}
NET = [[[i, j, 0] for j in range(6)] for i in range(6)]
HUGE = 10**400


def with_coordinate(value):
    return {**SWEPT, "section": [[0, 0, 0], [2, value, 1], *SECTION[2:]]}


def deep(levels):
    value = 1
    for _ in range(levels):
        value = [value]
    return value


WRONG_KEYS = [
    # numbers that are none, or are too large
    (with_coordinate(float("nan")), "section[1][1]: expected a finite number, got nan"),
    (with_coordinate(float("inf")), "section[1][1]: expected a finite number, got inf"),
    (with_coordinate(-float("inf")), "section[1][1]: expected a finite number, got -inf"),
    (with_coordinate("x"), "section[1][1]: expected a number, got 'x'"),
    (with_coordinate("1.5"), "section[1][1]: expected a number, got '1.5'"),
    (with_coordinate(True), "section[1][1]: expected a number, got true"),
    (with_coordinate(None), "section[1][1]: expected a number, got null"),
    (with_coordinate([1]), "section[1][1]: expected a number, got [1]"),
    (with_coordinate(1e60), "section[1][1]: expected a number of size at most 1e50, got 1e+60"),
    (with_coordinate(-1e60), "section[1][1]: expected a number of size at most 1e50, got -1e+60"),
    (with_coordinate(HUGE), "section[1][1]: expected a number of size at most 1e50, got 1000"),
    (with_coordinate(10**5000), "section[1][1]: expected a number of size at most 1e50, got a number with thousands"),
    (with_coordinate(deep(500)), "section[1][1]: expected a number, got [[["),
    ({"kind": "sphere", "radius": 0}, "radius: expected a number greater than 0, got 0"),
    ({"kind": "sphere", "radius": -1}, "radius: expected a number greater than 0, got -1"),
    ({"kind": "sphere", "radius": 1e60}, "radius: expected a number of size at most 1e50"),
    ({"kind": "sphere", "radius": 1e-60}, "radius: expected a number of size at least 1e-50, got 1e-60"),
    ({"kind": "sphere", "radius": True}, "radius: expected a number, got true"),
    # counts
    ({**SWEPT, "section": SECTION[:5]}, "section: expected 6 points, got 5"),
    ({**SWEPT, "section": SECTION * 2}, "section: expected 6 points, got 12"),
    ({**SWEPT, "section": SECTION * 20}, "section: expected 6 points, got 120"),
    ({**SWEPT, "section": []}, "section: expected 6 points, got 0"),
    ({**SWEPT, "section": [[0, 0], *SECTION[1:]]}, "section[0]: expected 3 numbers, got 2"),
    ({**SWEPT, "section": 3}, "section: expected a list, got 3"),
    ({**SWEPT, "section": [*SECTION[:5], {"x": 1}]}, "section[5]: expected a list, got {'x': 1}"),
    ({"kind": "tensor", "points": NET[:5]}, "points: expected 6 rows, got 5"),
    ({"kind": "tensor", "points": [*NET[:5], NET[5][:4]]}, "points[5]: expected 6 points, got 4"),
    ({"kind": "tensor", "points": [*NET[:5], []]}, "points[5]: expected 6 points, got 0"),
    ({"kind": "tensor", "points": NET, "basis": "bernstein", "shape": [0]}, "shape: expected none or 4 numbers"),
    ({"kind": "tensor", "points": NET[:1], "basis": "bernstein"}, "points: expected at least 2 rows, got 1"),
    ({"kind": "symmetric", "points": NET, "mirror": [1, 0, 0, 0]}, "points: expected 3 rows, got 6"),
    ({"kind": "symmetric", "points": NET[:3], "mirror": [1, 0, 0]}, "mirror: expected 4 numbers, got 3"),
    (
        {"kind": "symmetric", "points": NET[:3], "mirror": [0, 0, 0, 1]},
        "mirror: expected [a, b, c, d] with (a, b, c) not",
    ),
    ({"kind": "developable", "planes": [[0, 0, 1, 0]] * 5, "bounds": [[0, 1, 0, 0]] * 2}, "planes: expected 6 planes"),
    ({"kind": "developable", "planes": [[0, 0, 1]] * 6, "bounds": [[0, 1, 0, 0]] * 2}, "planes[0]: expected 4 numbers"),
    (
        {"kind": "developable", "planes": [[0, 0, 0, 1]] * 6, "bounds": [[0, 1, 0, 0]] * 2},
        "planes[0]: expected a plane",
    ),
    ({"kind": "swung", "profile": SECTION, "trajectory": TRAJECTORY}, "profile[0]: expected 2 numbers, got 3"),
    # shape parameters
    ({**SWEPT, "shape": [0, 0, 1.5, 0]}, "shape[2] (alpha2) = 1.5 is outside [-4, 1]"),
    ({**SWEPT, "shape": [0, -4.001, 0, 0]}, "shape[1] (zeta1) = -4.001 is outside [-4, 1]"),
    ({**SWEPT, "shape": [0, 0, 0]}, "shape: expected 4 numbers (alpha1, zeta1, alpha2, zeta2), found 3"),
    ({**SWEPT, "shape": "1"}, "shape: expected a list, got '1'"),
    ({**SWEPT, "shape": [0, 0, float("nan"), 0]}, "shape[2]: expected a finite number, got nan"),
    ({**SWEPT, "shape": [0, 0, 1e60, 0], "unchecked_shape": True}, "shape[2]: expected a number of size at most 1e50"),
    ({**SWEPT, "unchecked_shape": 1}, "unchecked_shape: expected true or false, got 1"),
    # words
    ({**SWEPT, "flip": 1}, "flip: expected true or false, got 1"),
    ({**SWEPT, "flip": "yes"}, "flip: expected true or false, got 'yes'"),
    ({**SWEPT, "basis": "bezier"}, "basis: expected one of trigonometric, "),
    ({**SWEPT, "basis": ["bernstein"]}, "basis: expected one basis, or 2, found 1"),
    # keys
    ({**SWEPT, "secton": 1}, "unknown key 'secton'; did you mean 'section'?"),
    ({"kind": "swept", "sectoin": SECTION, "trajectory": TRAJECTORY}, "unknown key 'sectoin'; did you mean 'section'?"),
    ({**SWEPT, "colour": "red"}, "unknown key 'colour'; the keys of this kind are name, flip, shape, "),
    ({**SWEPT, "unit": "inch"}, "unit: expected one of um, mm, cm, m, km, in, ft, got 'inch'; did you mean 'in'?"),
    ({**SWEPT, "unit": "MM"}, "got 'MM'; did you mean 'mm'?"),
    ({**SWEPT, "unit": "furlong"}, "got 'furlong'; leave it out for plain numbers"),
    ({**SWEPT, "shcema": 1}, "unknown key 'shcema'; did you mean 'schema'?"),
    ({"kind": "swept", "section": SECTION}, "missing key 'trajectory': expected 6 points [x, y, z]"),
    ({"kind": "tensor"}, "missing key 'points': expected 6 x 6 control points"),
    ({"kind": "swpt"}, "kind: expected one of tensor, symmetric"),
    ({"kind": "swpt"}, "got 'swpt'; did you mean 'swept'?"),
    ({"kind": 3}, "got 3"),
    ({"kind": ["swept"]}, "got ['swept']"),
    ({"radius": 3}, "got no kind"),
    ({}, "got no kind"),
    ({**SWEPT, "schema": 2}, "schema: expected 1, got 2; this quintrig reads version 1"),
    ({**SWEPT, "schema": True}, "schema: expected 1, got true"),
    ({**SWEPT, "schema": "1"}, "schema: expected 1, got '1'"),
    ({**SWEPT, "unit": "parsec"}, "unit: expected one of um, mm, cm, m, km, in, ft, got 'parsec'"),
    ({**SWEPT, "unit": 3}, "unit: expected a text"),
    ({**SWEPT, "name": 3}, "name: expected a text"),
    ({**SWEPT, "name": "x" * 300}, "name: expected a text of at most 200 letters"),
    ({**SWEPT, "name": "two\nlines"}, "name: expected a text of at most 200 letters on one line, got 'two\\nlines'"),
    # patches
    ({"patch": 3}, "patch: expected one or more [[patch]] tables, got 3"),
    ({"patch": []}, "patch: expected one or more [[patch]] tables, got []"),
    ({"patch": [3]}, "patch 1: expected a table of keys, got 3"),
    ({"patch": [{"name": "a", **SWEPT}, {"name": "a", **SWEPT}]}, 'patch "a": two patches have this name'),
    ({"patch": [{"name": "lid", **SWEPT, "flip": 1}]}, 'patch "lid": flip: expected true or false'),
    ({"patch": [SWEPT], "radius": 2}, "unknown key 'radius' beside [[patch]] tables; move it into a patch"),
    ({"patch": [{"unit": "mm", **SWEPT}]}, "unknown key 'unit': it belongs at the top of the file"),
    # files of nets
    ({**SWEPT, "section": "none.csv"}, "none.csv: no such file"),
    ({**SWEPT, "section": "../none.csv"}, "section: expected numbers, or the name of a .csv file beside the model"),
    ({**SWEPT, "section": "/etc/passwd"}, "section: expected numbers, or the name of a .csv file beside the model"),
    ({**SWEPT, "section": "folder.csv"}, "folder.csv: expected a file, found a folder"),
    ({**SWEPT, "section": "words.csv"}, "words.csv: row 3: expected numbers, got '3, x'"),
    ({**SWEPT, "section": "remarks.csv"}, "remarks.csv: row 4: expected numbers, got '3, x'"),
    ({**SWEPT, "section": "two.csv"}, "section[0]: expected 3 numbers, got 2"),
    ({**SWEPT, "section": "nan.csv"}, "section[0][2]: expected a finite number, got nan"),
    ({"kind": "tensor", "points": "two.csv"}, "points[0][0]: expected 3 numbers, got 2"),
    ({"kind": "tensor", "points": "seven.csv"}, "seven.csv: expected a multiple of 6 rows, got 7"),
    ({"kind": "tensor", "points": "empty.csv"}, "points: expected 6 rows, got 0"),
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("nets")
    (path / "folder.csv").mkdir()
    (path / "words.csv").write_text("a,b\n1,2\n3,x\n")
    (path / "remarks.csv").write_text("# points\n\n1,2\n3,x\n")
    (path / "two.csv").write_text("1,2\n" * 6)
    (path / "nan.csv").write_text("1,2,nan\n" * 6)
    (path / "seven.csv").write_text("1,2,3\n" * 7)
    (path / "empty.csv").write_text("")
    return path


@pytest.mark.parametrize(("data", "message"), WRONG_KEYS, ids=[message[:50] for _, message in WRONG_KEYS])
def test_wrong_keys(data, message, folder):
    with pytest.raises(ModelError) as caught:
        Model.from_dict(data, folder)
    text = str(caught.value)
    assert message in text
    assert text.isprintable()
    assert len(text) < 400


@pytest.mark.parametrize("data", [None, 3, "x", [1, 2], np.zeros(3)])
def test_a_model_is_a_table_of_keys(data):
    with pytest.raises(ModelError, match="expected keys and values"):
        Model.from_dict(data)


def test_the_place_names_the_patch():
    with pytest.raises(ModelError, match=r'^patch "Lid": shape: expected 4 numbers \(alpha1, .*, zeta2\), found 1$'):
        Model.from_dict({"name": "Lid", **SWEPT, "shape": [1]})


def test_a_misspelt_key_is_one_mistake():
    with pytest.raises(ModelError, match=r"unknown key 'sectoin'; did you mean 'section'\?$"):
        Model.from_dict({"kind": "swept", "sectoin": SECTION, "trajectory": TRAJECTORY})


def test_more_mistakes_are_counted():
    with pytest.raises(ModelError, match=r"section\[0\]\[0\]: expected a number, got 'a' \(and 1 more such\)"):
        Model.from_dict({**SWEPT, "section": [["a", "b", 0], *SECTION[1:]]})


FILES = {
    "empty.toml": (b"", "the file is empty"),
    "blank.json": (b" \n ", "the file is empty"),
    "comment.toml": (b"# nothing\n", "got no kind"),
    "syntax.toml": (b"kind = swept\n", "not valid TOML: "),
    "syntax.json": (b'{"kind": ', "not valid JSON: "),
    "twice.toml": (b'kind = "sphere"\nkind = "torus"\n', "not valid TOML: a key is given twice (at line 2"),
    "twice.json": (b'{"kind": "sphere", "kind": "torus"}', "not valid JSON: the key 'kind' is given twice"),
    "list.json": (b"[1, 2]", "expected keys and values, got [1, 2]"),
    "null.json": (b"null", "expected keys and values, got null"),
    "nan.json": (b'{"kind": "sphere", "radius": NaN}', "radius: expected a finite number, got nan"),
    "large.json": (b'{"kind": "sphere", "radius": 1e999}', "radius: expected a finite number, got inf"),
    "digits.json": (b'{"kind": "sphere", "radius": 1' + b"0" * 5000 + b"}", "a number has thousands of digits"),
    "digits.toml": (b'kind = "sphere"\nradius = 1' + b"0" * 5000, "a number has thousands of digits"),
    "int.json": (b'{"kind": "sphere", "radius": 1' + b"0" * 400 + b"}", "expected a number of size at most 1e50"),
    "deep.json": (b"[" * 100_000, "nested too deeply"),
    "closed.json": (b'{"a": ' * 100_000 + b"1" + b"}" * 100_000, "nested too deeply"),
    "deep.toml": (b"a = " + b"[" * 100_000 + b"]" * 100_000, "nested too deeply"),
    "dotted.toml": (b"a" + b".a" * 5000 + b" = 1", "nested too deeply"),
    "binary.toml": (bytes(range(256)), "expected text in UTF-8, found the byte 0x80 in line 2"),
    "latin.toml": ('# Höhe\nkind = "sphere"'.encode("latin-1"), "found the byte 0xf6 in line 1; is this a model?"),
    "nul.toml": (b'kind = "sphere"\0', "not valid TOML"),
    "utf16.json": ('{"kind": "sphere"}'.encode("utf-16"), "expected text in UTF-8, found the byte 0xff in line 1"),
    "control.toml": (b'kind = "sphere"\n"\\u001b[31m" = 1', "unknown key '\\x1b[31m'"),
    "model.txt": (b'kind = "sphere"', "expected a file ending in .toml or .json"),
    "model": (b'kind = "sphere"', "expected a file ending in .toml or .json"),
}


@pytest.mark.parametrize("name", FILES)
def test_wrong_files(name, tmp_path):
    content, message = FILES[name]
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(ModelError) as caught:
        load(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    assert message in text
    assert text.isprintable()


def test_a_missing_file(tmp_path):
    with pytest.raises(ModelError, match=r"none.toml: no such file; check the path"):
        load(tmp_path / "none.toml")


def test_a_folder_in_place_of_a_file(tmp_path):
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(ModelError, match=r"folder.toml: expected a file, found a folder$"):
        load(tmp_path / "folder.toml")


def test_a_path_through_a_file(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ModelError, match=r"cannot be read"):
        load(tmp_path / "file" / "model.toml")


@pytest.mark.parametrize("name", ["a\0b.toml", "x" * 5000 + ".toml"])
def test_a_name_that_no_file_can_have(name, tmp_path):
    with pytest.raises(ModelError, match="cannot be read"):
        load(tmp_path / name)


@pytest.mark.parametrize("suffix", ["toml", "json"])
def test_a_hundred_megabytes_are_not_read(suffix, tmp_path):
    path = tmp_path / f"junk.{suffix}"
    with path.open("wb") as file:
        file.truncate(100 * 2**20)
    with pytest.raises(ModelError, match=r"expected at most 16 MB, found 100 MB; is this a model\?$"):
        load(path)


def test_a_large_file_of_junk_is_told_shortly(tmp_path):
    path = tmp_path / "junk.json"
    path.write_text("[" + "1," * (LARGEST_FILE // 2 - 2) + "1]")
    with pytest.raises(ModelError, match=r"expected keys and values, got \[1, 1, 1, 1, \.\.\.\]$"):
        load(path)


def test_more_points_than_any_model_has_are_told_shortly():
    with pytest.raises(ModelError, match=r"points: expected 6 rows, got 100000$"):
        Model.from_dict({"kind": "tensor", "points": [json.loads("[]")] * 100_000})
