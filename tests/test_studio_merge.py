"""Saving into a TOML file that somebody wrote."""

import tomllib
from pathlib import Path

import pytest

from quintrig import Model, load
from quintrig.studio.merge import merged, whole

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
    model = load(path)
    if len(model.patches) == 1:
        assert merged(path.read_text(), model, path.parent) == path.read_text()


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_a_model_written_whole_is_read_back_the_same(path):
    keys = load(path).to_dict()
    assert Model.from_dict(tomllib.loads(whole(keys))).to_dict() == keys


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
