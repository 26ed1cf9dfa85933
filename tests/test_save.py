"""Models written to files: anew, and into a TOML file that somebody wrote."""

import json
import tomllib
from pathlib import Path

import pytest

import quintrig
from quintrig import Model, ModelError, load
from quintrig.model.save import merged
from quintrig.model.starter import starter
from quintrig.model.toml import to_toml
from quintrig.support.errors import QuintrigError

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("*.toml"))
TEXT = """# A lid
kind = "swept"   # along x
shape = [1, 1, # in u
  0, 0]
name = "lid # 1"
section = [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 1], [4, 0, 1], [5, 0, 0]]  # six
trajectory = [
    [0, 0, 0], # ]
    [0, 1, 0], [0, 2, 0], [0, 3, 0], [0, 4, 0], [0, 5, 0],
]
# the end
"""


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_unchanged_model_leaves_its_file_as_it_is(path):
    assert merged(path.read_text(), load(path), path.parent) == path.read_text()


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_a_model_written_whole_is_read_back_the_same(path):
    keys = load(path).to_dict()
    assert Model.from_dict(tomllib.loads(to_toml(keys))).to_dict() == keys


def test_only_the_changed_value_is_replaced():
    keys = tomllib.loads(TEXT) | {"shape": [1, 1, -3, -3]}
    result = merged(TEXT, Model.from_dict(keys))
    assert result == TEXT.replace("[1, 1, # in u\n  0, 0]", "[1, 1, -3, -3]")


def test_keys_are_added_and_taken_away():
    keys = tomllib.loads(TEXT) | {"flip": True, "unit": "mm"}
    added = merged(TEXT, Model.from_dict(keys))
    assert added.startswith(TEXT.rstrip())
    assert tomllib.loads(added)["flip"] is True
    back = merged(added, Model.from_dict(tomllib.loads(TEXT)))
    assert tomllib.loads(back) == tomllib.loads(TEXT)
    assert "# the end" in back


def test_another_kind_is_written_anew():
    model = Model.from_dict({"kind": "sphere", "name": 'a "b" #'})
    assert Model.from_dict(tomllib.loads(merged(TEXT, model))).to_dict() == model.to_dict()
    assert Model.from_dict(tomllib.loads(merged("not = = toml", model))).to_dict() == model.to_dict()


TWO = """name = "two" # both
[[patch]]
# the first
name = "ball"
kind = "sphere"
radius = 2 # mm

[[patch]]
name = "cone"  # a tent
kind = "cone"
radius = 1
"""


def two(**changed):
    keys = tomllib.loads(TWO)
    keys["patch"][0] |= changed
    return Model.from_dict(keys)


def test_one_of_several_patches_is_edited_in_place():
    assert merged(TWO, two(radius=3.0)) == TWO.replace("radius = 2 # mm", "radius = 3 # mm")
    assert merged(TWO, two(name="globe")) == TWO.replace('"ball"', '"globe"')


def test_patches_come_and_go():
    keys = tomllib.loads(TWO)
    keys["patch"].append({"name": "ring", "kind": "torus"})
    added = merged(TWO, Model.from_dict(keys))
    assert added.startswith(TWO)
    assert Model.from_dict(tomllib.loads(added)).to_dict() == Model.from_dict(keys).to_dict()
    del keys["patch"][0]
    rest = merged(added, Model.from_dict(keys))
    assert "# a tent" in rest
    assert "ball" not in rest
    assert Model.from_dict(tomllib.loads(rest)).to_dict() == Model.from_dict(keys).to_dict()


def test_a_long_list_of_numbers_stays_as_it_is_spelled():
    rows = ",\n".join("[" + ", ".join(f"[{x}.0, {y}.50, 0]" for y in range(16)) + "]" for x in range(40))
    knots = ", ".join(str(k) for k in [0] * 3 + list(range(1, 38)) + [38] * 3)
    other = ", ".join(str(k) for k in [0] * 3 + list(range(1, 14)) + [14] * 3)
    text = (
        f'kind = "nurbs"\nname = "n" # mine\ndegrees = [2, 2]\nknots = [[{knots}], [{other}]]\npoints = [\n{rows}\n]\n'
    )
    assert len(rows) > 5000
    keys = tomllib.loads(text)
    assert merged(text, Model.from_dict(keys)) == text
    assert merged(text, Model.from_dict(keys | {"flip": True})) == text + "flip = true\n"


def test_the_ends_of_lines_stay():
    text = TEXT.replace("\n", "\r\n")
    assert merged(text, Model.from_dict(tomllib.loads(TEXT) | {"name": "b"})) == text.replace("lid # 1", "b")


@pytest.mark.parametrize("suffix", [".toml", ".json", ".JSON"])
def test_what_is_saved_is_loaded_again(tmp_path, suffix):
    model = load("examples/car_boot.toml")
    target = quintrig.save(model, tmp_path / "new" / f"a{suffix}")
    assert load(target).to_dict() == model.to_dict()
    assert quintrig.save(model, str(target)) == target


def test_saving_keeps_the_comments_and_the_csv_files_that_a_file_names(tmp_path):
    (tmp_path / "net.csv").write_text("\n".join(f"{x},{y},{x * y}" for x in range(6) for y in range(6)))
    text = '# A lid\nkind = "tensor" # flat\npoints = "net.csv"\nshape = [0, 0, 0, 0] # plain\n'
    (tmp_path / "a.toml").write_text(text)
    model = load(tmp_path / "a.toml").with_shape([1, 0.5, 0, 0])
    quintrig.save(model, tmp_path / "a.toml")
    assert (tmp_path / "a.toml").read_text() == text.replace("[0, 0, 0, 0]", "[1, 0.5, 0, 0]")


def test_numbers_are_spelled_in_one_way():
    model = Model.from_dict({"kind": "cone", "name": "c", "radius": 1e-3, "height": 250.0})
    keys = model.to_dict() | {"zero": -0.0, "large": 1e30}
    text = to_toml(keys)
    assert "height = 250\n" in text
    assert "radius = 0.001\n" in text
    assert "zero = -0.0\nlarge = 1e+30\n" in text
    assert tomllib.loads(text) == keys
    assert "trajectory = [\n    [0, 0, 0],\n" in starter("swept")
    assert "trajectory = [\n    [0, 0, 0],\n" in to_toml(Model.from_dict(tomllib.loads(starter("swept"))).to_dict())


def test_json_spells_them_so_too(tmp_path):
    text = quintrig.save(Model.from_dict({"kind": "sphere", "radius": 4.0}), tmp_path / "s.json").read_text()
    assert json.loads(text)["radius"] == 4
    assert "4.0" not in text


def test_what_cannot_be_saved_is_said_in_one_line(tmp_path):
    model = Model.from_dict({"kind": "sphere"})
    with pytest.raises(ModelError, match=r"a\.txt: expected a file ending in \.toml or \.json"):
        quintrig.save(model, tmp_path / "a.txt")
    (tmp_path / "b.toml").mkdir()
    with pytest.raises(QuintrigError, match="expected the name of a file to write, found a folder"):
        quintrig.save(model, tmp_path / "b.toml")
