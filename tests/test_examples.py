"""The examples: each opens, is what its comments say, and warns of nothing unexpected."""

import math
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as cli
from quintrig.analysis.summary import summarise
from quintrig.developables.regression import regression
from quintrig.model.kinds.registry import CONSTRUCTIONS

EXAMPLES = Path(__file__).parent.parent / "examples"
FILES = sorted(path for path in EXAMPLES.iterdir() if path.suffix in (".toml", ".json"))
FEW = [path for path in FILES if path.name != "body.toml"]
"""All but the body, whose 56 patches, most alike, take a minute: it has tests of its own (test_body_files.py)."""

VERTICAL = "the tangent plane is vertical"
POLES = ("The edges u = 0 and u = 1 are single points",)
WARNINGS = {"sphere.toml": POLES}
NOTES = dict.fromkeys(
    ("sphere.toml", "cylinder.toml", "torus.json", "tensor.toml", "swung.toml", "classical.toml"), (VERTICAL,)
)
GRID = quintrig.grid(41, 41)


def model(name):
    return quintrig.load(EXAMPLES / name)


def test_there_is_one_for_every_construction():
    kinds = {patch.kind for path in FILES for patch in quintrig.load(path).patches}
    assert kinds >= {form.model_fields["kind"].default for form in CONSTRUCTIONS}
    assert {path.suffix for path in FILES} == {".toml", ".json"}


@pytest.mark.parametrize("path", FEW, ids=lambda path: path.name)
def test_check_opens_it(path):
    result = cli("check", path)
    assert result.code == 0, result.err
    assert result.err == ""
    assert quintrig.load(path).name in result.out


@pytest.mark.parametrize("path", FEW, ids=lambda path: path.name)
def test_it_warns_and_notes_nothing_unexpected(path):
    for patch in quintrig.load(path).patches:
        summary = summarise(patch.surface)
        for lines, expected in ((summary.warnings, WARNINGS), (summary.notes, NOTES)):
            phrases = expected.get(path.name, ())
            assert all(any(words in line for words in phrases) for line in lines), lines
            assert all(any(words in line for line in lines) for words in phrases)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_it_says_what_it_is(path):
    loaded = quintrig.load(path)
    assert loaded.name not in {patch.kind for patch in loaded.patches}
    if path.suffix == ".toml":
        assert path.read_text().startswith("# ")


@pytest.mark.parametrize(
    "name", ["car_boot", "tensor", "wavy", "symmetric", "swept", "ruled", "developable", "from_csv", "rear_of_car"]
)
def test_the_normal_of_roofs_and_lids_points_up(name):
    for patch in model(f"{name}.toml").patches:
        assert quintrig.analyse(patch.surface, 0.5, 0.5, ["normal"]).normal[2] > 0.5


@pytest.mark.parametrize("name", ["swung", "classical"])
def test_the_normal_of_the_vases_points_outwards(name):
    sample = quintrig.analyse(model(f"{name}.toml").surface, *GRID, ("point", "normal"))
    outwards = (sample.point[..., :2] * sample.normal[..., :2]).sum(axis=-1)
    assert (outwards > 0).mean() > 0.9


def test_the_boot_lid_has_the_size_of_a_car():
    boot = model("car_boot.toml")
    assert boot.unit == "mm"
    long, wide, high = np.ptp(boot.surface(*GRID), axis=(0, 1))
    assert 1300 < wide < 1500
    assert 600 < long < 800
    assert 400 < high < 600
    middle = boot.surface(np.linspace(0, 1, 201), 0.5)
    deck = middle[middle[:, 2] > -20]
    assert 450 < np.ptp(deck[:, 0]) < 620
    assert 350 < middle[0, 2] - middle[-1, 2] < 450


def test_the_boot_lid_is_its_own_mirror_image():
    surface = model("car_boot.toml").surface
    u, v = GRID
    np.testing.assert_allclose(surface(u, 1 - v) * [1, -1, 1], surface(u, v), atol=1e-9)


def test_the_boot_lid_is_crowned_tight_at_the_lip_and_hollow_behind():
    surface = model("car_boot.toml").surface
    sample = quintrig.analyse(surface, np.linspace(0, 1, 401), 0.5, ("point", "gaussian", "mean", "normal"))
    lip = int(np.argmin(sample["mean"]))
    assert sample["gaussian"][lip] > 0  # the lid turns down there and is bowed across: K > 0, bulging
    assert -0.05 < sample["mean"][lip] < -0.005  # a bend of some centimetres
    assert sample.point[lip, 0] > 500
    rear = sample.point[:, 2] < -150
    assert (sample["gaussian"][rear] < 0).all()  # hollow down, bowed across: a saddle
    assert sample.normal[rear, 0].min() > 0.9  # the rear face looks backwards


def test_window_and_boot_lid_meet_along_their_edge():
    window, lid = (patch.surface for patch in model("rear_of_car.toml").patches)
    v = np.linspace(0, 1, 33)
    np.testing.assert_allclose(window(1.0, v), lid(0.0, v), atol=1e-9)
    boot = model("car_boot.toml").surface
    np.testing.assert_allclose(lid(*GRID), boot(*GRID), atol=1e-9)


def test_the_thesis_net_is_a_cylinder():
    surface = model("tensor.toml").surface
    sample = quintrig.analyse(surface, *GRID, ("gaussian", "curvedness"))
    assert (np.abs(sample["gaussian"]) <= 1e-12 * sample["curvedness"] ** 2).all()


def test_the_symmetric_shell_is_symmetric():
    surface = model("symmetric.toml").surface
    u, v = GRID
    np.testing.assert_allclose(surface(1 - u, v) * [-1, 1, 1] + [10, 0, 0], surface(u, v), atol=1e-12)


def test_the_wavy_surface_has_every_kind_of_point():
    k = quintrig.analyse(model("wavy.toml").surface, *GRID, ["gaussian"])["gaussian"]
    assert 0.05 < (k > 0).mean() < 0.95


def test_the_classical_vase_is_the_swung_one_on_other_functions():
    first, second = model("swung.toml"), model("classical.toml")
    assert first.patch().definition.profile == second.patch().definition.profile
    np.testing.assert_array_equal(first.surface.net, second.surface.net)
    assert np.abs(first.surface(*GRID) - second.surface(*GRID)).max() > 0.1


def test_the_ruled_roof_is_nowhere_a_dome():
    sample = quintrig.analyse(model("ruled.toml").surface, *GRID, ("gaussian", "curvedness"))
    assert (sample["gaussian"] <= 1e-12 * sample["curvedness"] ** 2).all()


@pytest.mark.parametrize("shape", [None, (1, 1), (0, -4), (-2, 0), (-2, -4), (-4, -4), (0, 0)])
def test_the_developable_vault_is_flat_and_regular_for_every_shape(shape):
    vault = model("developable.toml")
    surface = (vault if shape is None else vault.with_shape(shape)).surface
    sample = quintrig.analyse(surface, *GRID, ("gaussian", "curvedness"))
    inner = np.s_[1:-1, :]
    assert not sample.singular[inner].any()
    assert (np.abs(sample["gaussian"][inner]) <= 1e-11 * sample["curvedness"][inner].max() ** 2).all()
    assert regression(surface).intervals == ()


def test_reference_surfaces_have_the_curvatures_their_comments_say():
    ball = quintrig.analyse(model("sphere.toml").surface, 0.3, 0.7, ("gaussian", "mean"))
    assert (ball["gaussian"], ball["mean"]) == (pytest.approx(1 / 400), pytest.approx(-1 / 20))
    tube = quintrig.analyse(model("cylinder.toml").surface, 0.3, 0.7, ("gaussian", "mean"))
    assert tube["mean"] == pytest.approx(-1 / 20)
    assert abs(tube["gaussian"]) < 1e-15
    torus = model("torus.json").surface
    assert summarise(torus).integrals.area.value == pytest.approx(4 * math.pi**2 * 30 * 10)


def test_the_csv_net_is_the_one_its_formula_gives():
    net = model("from_csv.toml").surface.net
    x, y, z = np.moveaxis(net, -1, 0)
    np.testing.assert_array_equal(x[:, 0], [0, 2, 4, 6, 8, 10])
    np.testing.assert_array_equal(y[0], [0, 2, 4, 6, 8, 10])
    np.testing.assert_allclose(z, 3 + 0.12 * (x - 5) ** 2 - 0.12 * (y - 5) ** 2, atol=1e-5)
