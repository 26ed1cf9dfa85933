"""Small things for notebooks: copies with other values, integrals and extremes of curves, samples as tables."""

import base64
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.model.patch import Patch
from quintrig.support import progress

BOOT = quintrig.load(Path(__file__).parents[1] / "examples" / "car_boot.toml")
POINTS = np.array([[0.0, 0], [1, 4], [3, -3], [5, 4], [7, -3], [8, 1]])


def test_a_patch_is_copied_with_other_values():
    patch = BOOT.patch()
    other = patch.replace(section=2.0 * np.array(patch.definition.section), shape=(0, 0, 0, 0), name="twin")
    assert (other.name, other.kind, other.shape) == ("twin", "swept", (0.0, 0.0, 0.0, 0.0))
    assert other.definition.trajectory == patch.definition.trajectory
    assert patch.shape == BOOT.patch().shape != other.shape
    changed = BOOT.replace(patch.replace(shape=(0, 0, 0, 0)))
    assert changed.patch().shape == (0.0, 0.0, 0.0, 0.0)
    with pytest.raises(quintrig.ModelError, match="did you mean 'section'"):
        patch.replace(secton=[])
    with pytest.raises(quintrig.ModelError, match="no patch 'twin'"):
        BOOT.replace(other)


def test_a_curve_is_copied_with_other_values():
    model = quintrig.Model.from_dict({"kind": "curve", "points": POINTS, "shape": [0.5, -1]})
    moved = model.replace(model.curve().replace(points=POINTS + 1.0))
    np.testing.assert_allclose(moved.curve().curve(0.3), model.curve().curve(0.3) + 1.0, rtol=1e-12)
    assert moved.curve().shape == (0.5, -1.0)


def test_integrals_and_extremes_of_a_quarter_of_a_circle():
    """In the cubic basis these points give a circle of radius 1 exactly (Han 2004)."""
    arc = quintrig.Curve(np.array([[1, 0], [1, 0.5], [0.5, 1], [0, 1.0]]), 0, 0, basis="cubic")
    found = quintrig.integrals(arc)
    assert found.length == pytest.approx(np.pi / 2, rel=1e-9)
    assert found.bending_energy == pytest.approx(np.pi / 2, rel=1e-9)
    assert quintrig.find_extremes(arc)["curvature"].maximum.value == pytest.approx(1.0, rel=1e-9)


def test_what_holds_a_curve_or_surface_is_measured_as_it_is():
    model = quintrig.Model.of_curves([quintrig.Curve([[0, 0], [1, 2], [2, 3], [4, 3], [5, 1], [6, 0]])])
    lengths = [quintrig.integrals(one).length for one in (model, model.curves[0], model.curves[0].curve)]
    assert lengths[0] == lengths[1] == lengths[2] > 6.0
    assert quintrig.find_extremes(model).keys() == {"curvature"}
    ball = quintrig.Model("ball", "", (Patch.of(quintrig.sphere(2.0), "ball"),))
    assert quintrig.integrals(ball).area.value == quintrig.integrals(ball.patch()).area.value
    with pytest.raises(ValueError, match="subject: expected a surface or a curve, found str"):
        quintrig.integrals("lid.toml")
    with pytest.raises(quintrig.ModelError, match="expected a model, found Patch"):
        quintrig.save(ball.patch(), "ball.toml")


def test_extremes_of_a_curve_bound_it():
    curve = quintrig.Curve(POINTS)
    found = quintrig.find_extremes(curve, "κ")["curvature"]
    values = curve.signed_curvature(np.linspace(0.0, 1.0, 4001))
    assert found.minimum.value <= values.min() + 1e-9
    assert found.maximum.value >= values.max() - 1e-9
    np.testing.assert_allclose(curve.signed_curvature(found.maximum.t), found.maximum.value)
    with pytest.raises(ValueError, match="this curve has curvature"):
        quintrig.find_extremes(curve, "torsion")


def test_surfaces_are_measured_as_before():
    ball = quintrig.sphere(2.0)
    assert quintrig.integrals(ball).area.value == pytest.approx(16.0 * np.pi, rel=1e-9)
    assert quintrig.find_extremes(ball, "K")["gaussian"].minimum.value == pytest.approx(0.25)


def test_a_notebook_shows_a_sample_as_a_small_table():
    text = quintrig.analyse(BOOT.surface, *quintrig.grid(20, 30), ["point", "K", "hk_type"])._repr_html_()
    assert text.count("<tr>") == 9
    assert text.count("<th>") == 5
    assert "saddle" in text
    assert "20 x 30 points" in text
    assert quintrig.analyse(BOOT.surface, 0.5, 0.5)._repr_html_().count("<tr>") == 2


@pytest.mark.parametrize("what", ["curve", "named curve", "line", "lines"])
def test_a_notebook_shows_a_picture_of_what_has_no_view(what):
    curve = quintrig.Curve(np.array([[0.0, 0], [1, 2], [2, 3], [4, 3], [5, 1], [6, 0]]))
    lines = quintrig.lines(BOOT, "parabolic")
    values = {"curve": curve, "named curve": quintrig.Model.of_curves([curve]).curves[0]}
    shown = ({**values, "line": lines[0], "lines": lines})[what]._repr_mimebundle_()
    assert base64.b64decode(shown["image/png"]).startswith(b"\x89PNG")
    assert shown["text/plain"]


def test_a_notebook_shows_a_bar_while_work_runs_and_takes_it_away(monkeypatch):
    shown = []
    monkeypatch.setattr(progress, "_in_notebook", lambda: True)
    monkeypatch.setattr(progress, "_QUIET", -1.0)
    monkeypatch.setattr(progress, "_OFTEN", -1.0)
    monkeypatch.setattr(progress.Bar, "_show", lambda bar, data: (shown.append(data), setattr(bar, "_handle", 1)))
    quintrig.prove(BOOT, ["regular", "K > -1"])
    assert ['value="0" max="2"' in shown[0]["text/html"], shown[1]["text/plain"], shown[-1]["text/html"]] == [
        True, "1 of 2, 0 s; proving K > -1", ""
    ]  # fmt: skip
    # Who asks for progress is told, and sees no bar.
    shown.clear()
    told = []
    quintrig.prove(BOOT, "regular", progress=lambda *step: told.append(step))
    assert (told, shown) == ([("proving regular", 0, 1)], [])
