"""What there is once: readers and writers, rules and lists that have begun to differ before."""

import re
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

import quintrig
from catalogue import CUSPED
from quintrig.developables.regression import regression
from quintrig.developables.rulings import rulings
from quintrig.model.kinds.registry import kinds
from quintrig.model.starter import starter
from quintrig.shaping.shape_effect import SHAPE_SETS
from quintrig.studio.data import table
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import EXTRAS, need
from quintrig.support.tolerance import NOISE, typical_rounding

SOURCE = Path(quintrig.__file__).parent
TEXTS = {path.relative_to(SOURCE).as_posix(): path.read_text(encoding="utf-8") for path in SOURCE.rglob("*.py")}


def using(pattern):
    return {name for name, text in TEXTS.items() if re.search(pattern, text)}


def test_one_module_reads_toml_and_json():
    assert using(r"tomllib|json\.loads?\(|raw_decode") == {
        "support/parsing.py",
        "exchange/cad/isolated.py",  # what its own child process tells
        "model/own_bases.py",  # what it has written itself, by which the bases already read are found again
        "shaping/kept.py",  # the state of a search, which it has written itself
        "support/machine_code.py",  # the head of compiled code, likewise
        "sweep/store.py",  # what it has written in the line before
    }


def test_one_module_writes_toml():
    assert using(r"tomlkit") == {"model/toml.py", "model/save.py"}


def test_one_module_says_what_is_not_installed():
    assert using(r"pip install '") == {"support/extras.py"}


@pytest.mark.parametrize("package", EXTRAS)
def test_it_says_so_in_one_way(package, monkeypatch):
    monkeypatch.setitem(sys.modules, package, None)
    extra, name = EXTRAS[package]
    with pytest.raises(QuintrigError) as error:
        need(package, "this")
    assert str(error.value) == f"this needs {name}; install it with: pip install 'quintrig[{extra}]'"


def test_the_sets_of_shape_parameters_are_those_of_the_thesis():
    inventory = tomllib.loads((SOURCE / "reproduce" / "inventory.toml").read_text(encoding="utf-8"))
    titled = [item for items in inventory.values() if isinstance(items, list) for item in items]
    shown = {tuple(item["shape"]) for item in titled if "shape" in item and "3D plot of the" in item["title"]}
    assert {shape for shape in shown if len(shape) == 4} == set(SHAPE_SETS[4])
    assert {shape for shape in shown if len(shape) == 2} == set(SHAPE_SETS[2])
    assert {int(count): {tuple(one) for one in sets} for count, sets in table()["shapeSets"].items()} == {
        count: set(sets) for count, sets in SHAPE_SETS.items()
    }


@pytest.mark.parametrize("kind", kinds())
def test_shape_parameters_act_but_on_the_classical_surface(kind):
    keys = tomllib.loads(starter(kind))
    definition = quintrig.Model.from_dict(keys).patch().definition
    assert tuple(definition.acting) == definition.shape_names
    assert tuple(definition.acting.values()) == definition.shape_values
    if "basis" in type(definition).model_fields:
        classical = quintrig.Model.from_dict(keys | {"basis": "bernstein"}).patch().definition
        assert classical.classical
        assert classical.acting == {}


def test_what_is_rounding_of_one_value():
    assert typical_rounding(2.0, -2) == NOISE * 4.0
    assert typical_rounding(2.0, 1) == typical_rounding(np.inf, -1) == typical_rounding(np.nan, -1) == 0.0


@pytest.mark.parametrize("height", [3.0, 10.0])
def test_a_flat_pattern_is_refused_where_the_edge_of_regression_is_found(height):
    strip = quintrig.developable(CUSPED, ((0, 1, 0, 0), (0, 1, 0, -height)), (0.0, 0.0))
    found = regression(strip).intervals
    assert found
    with pytest.raises(ValueError, match="the edge of regression lies inside the strip for u = ") as error:
        rulings(strip, lambda upward: np.zeros(len(upward)))
    told = re.findall(r"([0-9.e-]+) to ([0-9.e-]+)", str(error.value))
    np.testing.assert_allclose(np.array(told, dtype=float), found, atol=2e-3)  # the ends of the strip are left out
