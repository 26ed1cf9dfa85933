"""Designs meet the optima that are known in closed form, gradients are those of differences, mistakes are one line."""

import json
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.shaping.conditions import InTotal, OnSurface, integral, on_surface, regular
from quintrig.shaping.demands import demands
from quintrig.shaping.places import Passing, TangentPlane, Twist, near
from quintrig.shaping.unknowns import Range, as_it_is, unknowns
from quintrig.support.errors import QuintrigError

EXAMPLES = Path(__file__).parent.parent / "examples"


def example(name):
    return quintrig.load(EXAMPLES / f"{name}.toml")


def cylinder(radius=10.0):
    return quintrig.Model.from_dict({"kind": "cylinder", "unit": "mm", "radius": radius, "height": 40.0})


def flat(height=0.0):
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    return quintrig.Model.from_dict(
        {"kind": "tensor", "unit": "mm", "points": np.stack([x, y, np.full_like(x, height)], -1).tolist()}
    )


TEXTS = [
    "gaussian >= 0.01", "gaussian <= 0.1", "mean >= -0.1", "mean <= 0.2", "k1 <= 0.3", "k1 >= 0.1", "k2 >= -0.3",
    "k2 <= 0.1", "curvedness <= 0.2", "curvedness >= 0.1", "curvature_radius >= 3", "curvature_radius <= 9",
    "slope <= 40", "draft >= 10",
]  # fmt: skip


@pytest.mark.parametrize("name", ["tensor", "swept", "ruled", "swung"])
def test_gradients_are_those_of_differences(name):
    model = example(name)
    patch, rng = model.patches[0], np.random.default_rng(1)
    size = patch.surface.size
    ranges = [Range(key, -3.0, 1.0) for key in patch.definition.ranges]
    space = unknowns(patch, ranges, 0.1 * size, (), ())
    values = space.start + 0.1 * (space.high - space.low) * rng.uniform(-1, 1, len(space.start))
    direction = (space.high - space.low) * rng.normal(size=len(values))
    conditions = [on_surface(demands(text)[0], patch.surface) for text in TEXTS]
    for key in ("area", "volume", "bending", "thin_plate", "variation"):
        conditions.append(InTotal(demands(f"{key} <= 1")[0], integral(key, patch.surface), 1.0))
    u, v = np.array([[0.31], [0.62]])
    above = patch.surface(u, v) + 0.02 * size
    conditions.append(near("near", above, size, patch.surface))
    conditions.append(Passing("through", above[0], None, size))
    conditions.append(Passing("at", above[0], (0.4, 0.7), size))
    conditions.append(TangentPlane("tangent", (0.4, 0.3), np.array([0.6, 0.0, 0.8])))
    found = regular(patch.surface)
    conditions += [found] if found else []
    conditions += [Twist("twist", 3.0)] if name == "ruled" else []
    step = 1e-6
    for one in conditions:
        if isinstance(one, OnSurface):
            one.seen = one.seen[rng.integers(0, len(one.seen), 5)]
        value, rows = one.values(space.at(values))
        ahead, back = (one.values(space.at(values + sign * step * direction))[0] for sign in (1.0, -1.0))
        expected = (ahead - back) / (2.0 * step)
        scale = np.abs(rows).max() * np.abs(direction).max() + np.abs(value).max()
        np.testing.assert_allclose(rows @ direction, expected, rtol=1e-4, atol=1e-5 * scale, err_msg=one.name)


def test_the_smallest_cylinder_that_bends_as_little_as_allowed():
    goals = {"model": cylinder(), "minimise": "area", "vary": {"radius": [1.0, 20.0]},
             "demands": ["curvature_radius >= 3 mm"]}  # fmt: skip
    found = quintrig.design(goals, starts=2)
    assert found.met
    assert not found.contradictions
    radius = found.model.patches[0].definition.parameters["radius"]
    assert radius == pytest.approx(3.0, rel=1e-4)
    assert radius >= 3.0 - 1e-9
    assert found.outcomes[0].binds
    assert found.after == pytest.approx(2 * np.pi * radius * 40.0, rel=1e-6)


def test_a_margin_moves_the_bound_itself_also_where_all_points_are_umbilics():
    (demand,) = demands("curvature_radius >= 3 cm", "mm")
    for radius, kept in ((30.0, False), (30.0 * (1 + 2e-6), True), (29.99, False)):
        patch = quintrig.Model.from_dict({"kind": "sphere", "unit": "mm", "radius": radius}).patch()
        one = on_surface(demand, patch.surface)
        assert (one.values(as_it_is(patch))[0].min() >= 0) == kept
        assert 0 < one.defined.sum() < one.defined.size  # the poles have no tangent plane


def test_the_least_change_through_a_point_is_that_of_the_mass_matrix():
    model, point = flat(), [2.2, 2.9, 0.5]
    goals = {"model": model, "minimise": "none", "vary": {"points": 30.0, "only": ["z"]},
             "through": [{"point": point, "u": 0.44, "v": 0.58}]}  # fmt: skip
    goals["through"][0]["point"] = [*model.surface(0.44, 0.58)[:2].tolist(), 0.5]
    found = quintrig.design(goals, starts=1)
    assert found.met
    x, w = np.polynomial.legendre.leggauss(20)
    f = model.surface.blend.derivatives((x + 1) / 2, 0)[0]
    gram = np.einsum("t,ti,tj->ij", w / 2, f, f)
    a, b = (model.surface.blend.derivatives(np.array(t), 0)[0] for t in (0.44, 0.58))
    pull = np.outer(np.linalg.solve(gram, a), np.linalg.solve(gram, b))
    expected = 0.5 * pull / (a @ pull @ b)
    got = np.array(found.model.patches[0].definition.points)[..., 2]
    np.testing.assert_allclose(got, expected, atol=2e-4)


def test_a_tangent_plane_and_a_hold_are_met_exactly():
    goals = {"model": flat(), "minimise": "thin_plate", "vary": {"points": 4.0, "hold": ["u0:G1", "u1"]},
             "tangent": [{"u": 0.5, "v": 0.5, "normal": [0.6, 0.0, 0.8]}]}  # fmt: skip
    found = quintrig.design(goals, starts=1)
    assert found.met
    p = found.model.surface.partials(0.5, 0.5, 1)
    normal = np.cross(p[1, 0], p[0, 1])
    np.testing.assert_allclose(normal / np.linalg.norm(normal), [0.6, 0.0, 0.8], atol=1e-6)
    v = np.linspace(0, 1, 9)
    for order in (0, 1):
        np.testing.assert_allclose(found.model.surface.partials(0.0, v, 1)[order, 0],
                                   flat().surface.partials(0.0, v, 1)[order, 0], atol=1e-9)  # fmt: skip


def test_demands_hold_between_the_points_that_were_seen():
    model = example("swept")
    size = model.surface.size
    found = quintrig.design(
        {"model": model, "vary": {"points": 0.2 * size, "only": ["z"]}, "demands": ["gaussian >= 0"]}, starts=1
    )
    assert found.met
    assert found.outcomes[0].binds
    t = np.linspace(0, 1, 201)
    before, after = (quintrig.analyse(one.surface, t[:, None], t)["gaussian"].min() for one in (model, found.model))
    assert before * size**2 < -0.1
    assert after * size**2 > -1e-3


def test_what_contradicts_is_named_and_the_rest_is_not():
    goals = {"model": cylinder(), "minimise": "none", "vary": {"radius": [1.0, 20.0]},
             "demands": ["curvature_radius >= 8", "area <= 1000", "gaussian <= 1"]}  # fmt: skip
    found = quintrig.design(goals, starts=1)
    assert not found.met
    assert set(found.contradictions) == {"curvature_radius >= 8", "area <= 1000"}
    radius = found.model.patches[0].definition.parameters["radius"]
    assert 1000 / (80 * np.pi) - 1e-3 <= radius <= 8.0 + 1e-3
    assert [one.met for one in found.outcomes][2]


def test_a_seam_is_made_and_kept():
    x, y = np.meshgrid(np.linspace(0, 1, 6), np.linspace(0, 1, 6), indexing="ij")
    bump = np.random.default_rng(1).normal(size=(6, 6)) * 0.1
    left = {"name": "left", "kind": "tensor", "points": np.stack([x, y, bump], -1).tolist()}
    right = {"name": "right", "kind": "tensor", "points": np.stack([x + 1.0, y, 0.5 * bump], -1).tolist()}
    model = quintrig.Model.from_dict({"name": "two", "unit": "m", "patch": [left, right]})
    goals = {"model": model, "patch": "right", "minimise": "thin_plate", "vary": {"points": 1.0, "shape": True},
             "seam": [{"first": "left:u1", "second": "right:u0", "order": "G2"}],
             "through": [{"point": [1.5, 0.5, 0.4], "u": 0.5, "v": 0.5}]}  # fmt: skip
    found = quintrig.design(goals, starts=1)
    assert found.met
    assert found.model.joins()[0].order in ("G2", "G3")
    assert any("alpha1 stays" in note for note in found.notes)


def test_a_target_is_met():
    model = example("tensor")
    moved = model.surface(*np.random.default_rng(2).uniform(0, 1, (2, 60))) + np.array([0, 0, 0.3])
    goals = {"model": model, "minimise": "deviation", "vary": {"points": 1.0, "only": ["z"]},
             "target": [{"points": moved.tolist()}], "demands": ["deviation <= 0.05"]}  # fmt: skip
    found = quintrig.design(goals, starts=1)
    assert found.met
    assert found.after < 0.01 < found.before


def test_a_stopped_search_keeps_the_best_and_goes_on(tmp_path):
    state = tmp_path / "state.json"
    goals = {"model": cylinder(), "minimise": "area", "vary": {"radius": [1.0, 20.0]},
             "demands": ["curvature_radius >= 3"]}  # fmt: skip
    calls = []

    def stop(what, done, total):
        calls.append(what)
        if len(calls) == 3:
            raise KeyboardInterrupt

    first = quintrig.design(goals, starts=3, state=state, progress=stop)
    assert first.stopped
    assert state.exists()
    second = quintrig.design(goals, starts=3, state=state)
    assert second.met
    assert not second.stopped
    with pytest.raises(ValueError, match="other goals"):
        quintrig.design(goals | {"demands": ["curvature_radius >= 4"]}, state=state)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"minimise": "bendng"}, r"minimise: expected one of .*'bendng'; did you mean 'bending'"),
        ({"demands": ["gausian >= 0"]}, r"no quantity 'gausian'; did you mean 'gaussian'"),
        ({"demands": ["gaussian > big"]}, r"expected a number"),
        ({"demands": ["gaussian = 0"]}, r"expected >= or <="),
        ({"demands": ["area <= 3 mm"]}, r"expected a unit such as mm²"),
        ({"demands": ["curvature_radius >= -3"]}, r"radius greater than 0"),
        ({"vary": {}}, r"vary: expected something that may vary"),
        ({"vary": {"radiu": [1, 2]}}, r"unknown parameter 'radiu'; did you mean 'radius'"),
        ({"vary": {"radius": [3, 1]}}, r"vary: radius: expected a range \[low, high\]"),
        ({"vary": {"shape": True}}, r"no shape parameters"),
        ({"vary": {"points": 3.0}}, r"no control points to vary"),
        ({"demand": ["gaussian >= 0"]}, r"unknown key 'demand'; did you mean 'demands'"),
        ({"through": [{"point": [0, 0]}]}, r"through 1: point: expected at least 3 numbers, got"),
        (
            {"target": [{"points": [[0, 0, 0]], "within": -1.0}]},
            r"target 1: within: expected a number greater than 0, got -1",
        ),
        ({"through": [{"point": [0, 0, 0], "u": 0.5}]}, r"u and v both"),
        ({"tangent": [{"u": 0, "v": 0, "normal": [0, 0, 0]}]}, r"expected a direction"),
        ({"target": [{"file": "none.csv"}], "minimise": "deviation"}, r"none.csv"),
        ({"seam": [{"first": "a:u1", "second": "b:u0"}]}, r"seam 1"),
        ({"developable": 2.0, "model": example("swung"), "vary": {"shape": True}}, r"developable: patch"),
        ({"demands": [], "minimise": "none"}, r"nothing to do"),
        ({"model": None}, r"missing key 'model'"),
    ],
)
def test_a_mistake_in_goals_is_one_line(change, words):
    goals = {"model": cylinder(), "minimise": "area", "vary": {"radius": [1.0, 20.0]},
             "demands": ["gaussian >= 0"]} | change  # fmt: skip
    with pytest.raises((ValueError, QuintrigError), match=words) as told:
        quintrig.design(goals)
    assert "\n" not in str(told.value)


def test_the_command_writes_the_model_and_says_what_came_of_each_demand(tmp_path):
    (tmp_path / "part.toml").write_text('kind = "cylinder"\nunit = "mm"\nradius = 10\nheight = 40\n', encoding="utf-8")
    goals = tmp_path / "goals.toml"
    goals.write_text(
        'model = "part.toml"\nminimise = "area"\ndemands = ["curvature_radius >= 3"]\n[vary]\nradius = [1, 20]\n',
        encoding="utf-8",
    )
    done = run("design", goals, "-o", tmp_path / "out.toml", "--json", "--starts", "1")
    assert done.code == 0, done.err
    said = json.loads(done.out)
    assert said["met"]
    assert said["binding"] == ["curvature_radius >= 3"]
    assert quintrig.load(tmp_path / "out.toml").patches[0].definition.radius == pytest.approx(3.0, rel=1e-4)
    assert "met" in run("design", goals, "--starts", "1").out
    refused = run("design", goals, "-o", tmp_path / "part.toml", "--force")
    assert refused.code == 2
    wrong = run("design", tmp_path / "none.toml")
    assert wrong.code == 2
    assert len(wrong.err.strip().splitlines()) == 1
