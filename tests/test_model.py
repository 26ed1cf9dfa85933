"""Models: what is read is what was written, by every way of writing it."""

import json

import numpy as np
import pytest

import quintrig
from quintrig.model.kinds.registry import OWN as KINDS
from quintrig.model.model import UNITS, Model, load
from quintrig.model.starter import starter
from quintrig.support.errors import ModelError

SECTION = [[0, 0, 0], [2, 0, 1], [4, 0, 3], [6, 0, 3], [8, 0, 1], [10, 0, 0]]
TRAJECTORY = [[0, 0, 0], [0, 1, 3], [0, 3, 5], [0, 5, 5], [0, 7, 3], [0, 8, 0]]
SWEPT = {"kind": "swept", "shape": [1, 1, -3, -3], "section": SECTION, "trajectory": TRAJECTORY}
NET = [[[i, j, i * j - 2] for j in range(6)] for i in range(6)]
U, V = quintrig.grid(5, 4)


def same(first, second):
    np.testing.assert_array_equal(first(U, V), second(U, V))
    assert first.flip == second.flip


def test_toml_json_and_a_dict_give_the_same_model(tmp_path):
    (tmp_path / "a.toml").write_text(
        f'schema = 1\nname = "Canopy"\nunit = "m"\nkind = "swept"\nshape = [1, 1, -3, -3]\n'
        f"section = {SECTION}\ntrajectory = {TRAJECTORY}\n"
    )
    (tmp_path / "a.json").write_text(json.dumps({"schema": 1, "name": "Canopy", "unit": "m", **SWEPT}))
    models = [load(tmp_path / "a.toml"), load(str(tmp_path / "a.json")), Model.from_dict({"unit": "m", **SWEPT})]
    for model in models:
        assert model.unit == "m"
        same(model.surface, quintrig.swept(SECTION, TRAJECTORY, (1, 1, -3, -3)))
    assert [model.name for model in models] == ["Canopy", "Canopy", "swept"]


def test_suffix_and_byte_order_mark_do_not_matter(tmp_path):
    path = tmp_path / "A.TOML"
    path.write_bytes(b"\xef\xbb\xbf" + b'kind = "sphere"\r\nradius = 2\r\n')
    same(load(path).surface, quintrig.sphere(2))


@pytest.mark.parametrize("kind", KINDS)
def test_every_model_comes_back_from_what_it_writes(kind, tmp_path):
    path = tmp_path / "model.toml"
    path.write_text(starter(kind))
    model = load(path)
    again = Model.from_dict(json.loads(json.dumps(model.to_dict())))
    assert (again.name, again.unit, again.patch().kind) == (model.name, model.unit, kind)
    same(again.surface, model.surface)


def test_numpy_arrays_are_taken_as_lists():
    model = Model.from_dict({**SWEPT, "section": np.array(SECTION, dtype=np.float32), "shape": np.zeros(4)})
    same(model.surface, quintrig.swept(SECTION, TRAJECTORY))


def test_reading_does_not_change_what_was_given():
    data = {"unit": "mm", "patch": [{"name": "a", **SWEPT}]}
    before = json.dumps(data)
    Model.from_dict(data)
    assert json.dumps(data) == before


@pytest.mark.parametrize("unit", UNITS)
def test_units(unit):
    assert Model.from_dict({"kind": "sphere", "unit": unit}).unit == unit


def test_flip_turns_the_normal_only():
    plain, turned = (Model.from_dict({**SWEPT, "flip": flip}).surface for flip in (False, True))
    np.testing.assert_array_equal(plain(U, V), turned(U, V))
    first, second = (quintrig.analyse(surface, U, V, ("normal", "mean", "gaussian")) for surface in (plain, turned))
    np.testing.assert_array_equal(first.normal, -second.normal)
    np.testing.assert_array_equal(first["mean"], -second["mean"])
    np.testing.assert_array_equal(first["gaussian"], second["gaussian"])


def test_patches_are_found_by_name():
    model = Model.from_dict({"patch": [{"name": "lid", **SWEPT}, {"kind": "sphere", "radius": 3}]})
    assert [patch.name for patch in model.patches] == ["lid", "patch 2"]
    same(model.patch("patch 2").surface, quintrig.sphere(3))
    with pytest.raises(ModelError, match="has 2 patches \\(lid, patch 2\\): choose one"):
        model.patch()
    with pytest.raises(ModelError, match="no patch 'lud'; did you mean 'lid'\\?"):
        model.patch("lud")
    again = Model.from_dict(model.to_dict())
    assert [patch.name for patch in again.patches] == ["lid", "patch 2"]


def test_other_shape_parameters_change_nothing_else():
    model = Model.from_dict({"name": "Canopy", "unit": "m", **SWEPT, "flip": True})
    changed = model.with_shape((1, 0, -2, -3))
    same(changed.surface, quintrig.swept(SECTION, TRAJECTORY, (1, 0, -2, -3), flip=True))
    assert (changed.name, changed.unit, changed.patch().name) == ("Canopy", "m", "Canopy")
    assert changed.patch().shape == (1, 0, -2, -3)
    assert model.patch().shape == (1, 1, -3, -3)


def test_shape_parameters_outside_their_range_need_a_word():
    with pytest.raises(ModelError, match=r"shape\[1\] \(zeta1\) = 2 is outside \[-4, 1\].*unchecked_shape = true"):
        Model.from_dict({**SWEPT, "shape": [1, 2, 0, 0]})
    model = Model.from_dict({**SWEPT, "shape": [1, 2, 0, 0], "unchecked_shape": True})
    same(model.surface, quintrig.swept(SECTION, TRAJECTORY, (1, 2, 0, 0), unchecked_shape=True))


def test_the_classical_basis_takes_any_number_of_points():
    model = Model.from_dict({"kind": "tensor", "basis": "bernstein", "points": [row[:4] for row in NET[:3]]})
    same(model.surface, quintrig.tensor([row[:4] for row in NET[:3]], basis="bernstein"))


@pytest.mark.parametrize("text", ["x,y,z\n{}", "# net\n{}\n\n", "{}"])
@pytest.mark.parametrize("delimiter", [",", ";", ", "])
def test_a_net_from_csv(tmp_path, text, delimiter):
    rows = "\n".join(delimiter.join(map(str, point)) for row in NET for point in row)
    (tmp_path / "net.csv").write_text(text.format(rows).replace("x,y,z", delimiter.join("xyz")))
    (tmp_path / "model.toml").write_text('kind = "tensor"\npoints = "net.csv"\n')
    same(load(tmp_path / "model.toml").surface, quintrig.tensor(NET))


def test_curves_from_csv(tmp_path):
    (tmp_path / "section.csv").write_text("\n".join(",".join(map(str, point)) for point in SECTION))
    model = Model.from_dict({**SWEPT, "section": "section.csv"}, tmp_path)
    same(model.surface, quintrig.swept(SECTION, TRAJECTORY, (1, 1, -3, -3)))


@pytest.mark.parametrize("kind", KINDS)
def test_starters_are_valid_and_regular_enough_to_look_at(kind, tmp_path):
    path = tmp_path / "model.toml"
    path.write_text(starter(kind))
    surface = load(path).surface
    sample = quintrig.analyse(surface, *quintrig.grid(21, 21), ("mean", "normal"))
    # Spheres and cones have poles; nothing is singular elsewhere.
    assert not sample.singular[1:-1, 1:-1].any()
    assert sample.size > 1.0


def test_starters_explain_every_key():
    for kind, form in KINDS.items():
        text = starter(kind)
        for key in form.model_fields:
            if key not in ("kind", "name"):
                assert any(line.startswith((f"{key} =", f"# {key} =")) for line in text.splitlines()), (kind, key)
        assert max(map(len, text.splitlines())) <= 120


def test_an_unknown_kind_has_no_starter():
    with pytest.raises(ValueError, match="got 'swpt'; did you mean 'swept'"):
        starter("swpt")
