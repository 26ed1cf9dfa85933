"""The published JSON Schema: valid itself, and of one mind with the reader of models."""

import copy
import json
import tomllib
from pathlib import Path

import jsonschema
import pytest

from quintrig.model.kinds.registry import OWN as KINDS
from quintrig.model.model import Model, load
from quintrig.model.schema import json_schema
from quintrig.model.starter import starter
from quintrig.support.errors import ModelError

EXAMPLES = Path(__file__).parent.parent / "examples"
FILES = sorted(path for path in EXAMPLES.iterdir() if path.suffix in (".toml", ".json"))
VALIDATOR = jsonschema.Draft202012Validator(json_schema())
CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())


def read(path):
    return (tomllib if path.suffix == ".toml" else json).loads(path.read_text())


def test_the_schema_is_a_schema():
    jsonschema.Draft202012Validator.check_schema(json_schema())


def test_the_schema_survives_json():
    assert json.loads(json.dumps(json_schema(), allow_nan=False)) == json_schema()


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_examples_fit(path):
    VALIDATOR.validate(read(path))


@pytest.mark.parametrize("kind", KINDS)
def test_starters_fit(kind):
    VALIDATOR.validate(tomllib.loads(starter(kind)))


@pytest.mark.parametrize("case", CASES[::7], ids=lambda case: case["model"]["name"])
def test_reference_cases_fit(case):
    VALIDATOR.validate(case["model"])


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_what_a_model_writes_fits(path):
    VALIDATOR.validate(load(path).to_dict())


@pytest.mark.parametrize("kind", KINDS)
def test_every_key_is_described(kind):
    form = next(
        form for form in json_schema()["oneOf"] if form.get("properties", {}).get("kind", {}).get("const") == kind
    )
    assert form["additionalProperties"] is False
    for key, value in form["properties"].items():
        assert key == "kind" or value.get("description"), key


SPHERE = {"kind": "sphere", "radius": 2}
SWEPT = {
    "kind": "swept",
    "shape": [1, 1, -3, -3],
    "section": [[0, 0, 0], [2, 0, 1], [4, 0, 3], [6, 0, 3], [8, 0, 1], [10, 0, 0]],
    "trajectory": [[0, 0, 0], [0, 1, 3], [0, 3, 5], [0, 5, 5], [0, 7, 3], [0, 8, 0]],
}


def changed(base, *path_and_value):
    *path, last, value = path_and_value
    result = copy.deepcopy(base)
    place = result
    for step in path:
        place = place[step]
    place[last] = value
    return result


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"radius": 2},
        {"kind": "spere"},
        changed(SPHERE, "radius", "2"),
        changed(SPHERE, "radius", True),
        changed(SPHERE, "radius", 0),
        changed(SPHERE, "radius", -1),
        changed(SPHERE, "radius", None),
        changed(SPHERE, "radius", 1e60),
        changed(SPHERE, "radius", 10**400),
        changed(SPHERE, "radius", [2]),
        changed(SPHERE, "raduis", 2),
        changed(SPHERE, "schema", 2),
        changed(SPHERE, "unit", "parsec"),
        changed(SPHERE, "unit", 3),
        changed(SPHERE, "name", "x" * 201),
        changed(SPHERE, "flip", 1),
        changed(SWEPT, "section", []),
        changed(SWEPT, "section", 2, [0, 0]),
        changed(SWEPT, "section", 2, 1, "0"),
        changed(SWEPT, "section", "net.txt"),
        changed(SWEPT, "shape", [1, 1]),
        changed(SWEPT, "basis", "bezier"),
        changed(SWEPT, "unchecked_shape", "no"),
        {"patch": []},
        {"patch": [{"radius": 2}]},
        {"patch": [SPHERE], "radius": 2},
    ],
    ids=lambda data: json.dumps(data)[:60],
)
def test_schema_and_reader_refuse_the_same(data):
    assert not VALIDATOR.is_valid(data)
    with pytest.raises(ModelError):
        Model.from_dict(data)


@pytest.mark.parametrize(
    "data",
    [
        SPHERE,
        SWEPT,
        {"schema": 1, "name": "A ball", "unit": "mm", **SPHERE},
        changed(SWEPT, "flip", True),
        {"patch": [{"name": "one", **SPHERE}, {"name": "two", **SWEPT}]},
    ],
    ids=lambda data: json.dumps(data)[:60],
)
def test_schema_and_reader_accept_the_same(data):
    VALIDATOR.validate(data)
    Model.from_dict(data)
