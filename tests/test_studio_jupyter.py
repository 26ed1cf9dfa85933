"""The studio in a notebook, from the kernel's side."""

import numpy as np
import pytest

import quintrig
from quintrig.geometry.surface import Net, Surface
from quintrig.model.recognise import as_model

pytest.importorskip("anywidget", reason="the extra 'jupyter' is not installed")

from quintrig.studio.jupyter import show

RANDOM = np.random.default_rng(3)
NET = RANDOM.uniform(-1, 1, (6, 6, 3))
CURVES = RANDOM.uniform(-1, 1, (2, 6, 3))
PLANES = (
    (1.0, 0.1, 0.3, -10.0), (1.0, 0.3, 0.32, -10.2), (0.9, 0.6, 0.34, -10.3),
    (0.7, 0.8, 0.33, -10.6), (0.5, 0.9, 0.31, -10.7), (0.3, 1.0, 0.28, -11.0),
)  # fmt: skip
SURFACES = {
    "tensor": quintrig.tensor(NET, (1, -2, 0.5, -4), flip=True),
    "bernstein": quintrig.tensor(NET[:4, :3], basis="bernstein"),
    "unchecked": quintrig.tensor(NET, (2, 0, 0, 0), unchecked_shape=True),
    "swept": quintrig.swept(CURVES[0], CURVES[1], (1, 1, -3, -3)),
    "ruled": quintrig.ruled(CURVES[0], CURVES[1], (1, 0, -2, -3)),
    "developable": quintrig.developable(PLANES, ((0, 0, 1, 0), (0, 0, 1, -5)), (1, -2)),
    "developable flipped": quintrig.developable(PLANES, ((0, 0, 1, 0), (0, 0, 1, -5)), flip=True),
    "sphere": quintrig.sphere(2.5, flip=True),
    "ellipsoid": quintrig.ellipsoid(3, 1.1, 0.7),
    "cylinder": quintrig.cylinder(0.3, 7),
    "cone": quintrig.cone(1.7, 0.4),
    "torus": quintrig.torus(1.1, 2.3, flip=True),
    "catenoid": quintrig.catenoid(0.7, 3.1),
    "helicoid": quintrig.helicoid(1.3, -0.9),
    "hyperbolic paraboloid": quintrig.hyperbolic_paraboloid(1.7),
    "monkey saddle": quintrig.monkey_saddle(0.3, flip=True),
    "enneper": quintrig.enneper(1.2),
}


@pytest.mark.parametrize("name", SURFACES)
def test_a_bare_surface_is_shown_as_itself(name):
    again = as_model(SURFACES[name]).surface
    u, v = quintrig.grid(7, 5)
    np.testing.assert_allclose(again(u, v), SURFACES[name](u, v), rtol=0, atol=1e-14 * max(1, again.size))
    assert again.flip == SURFACES[name].flip


@pytest.mark.parametrize("name", SURFACES)
def test_a_notebook_shows_a_bare_surface_by_itself(name):
    bundle = SURFACES[name]._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in (bundle[0] if isinstance(bundle, tuple) else bundle)


def test_the_view_follows_the_page_and_the_page_the_view():
    view = show(quintrig.Model.from_dict({"kind": "cone", "radius": 2.0, "unit": "mm"}), "mean")
    assert view.current.unit == "mm"
    # What the page sends is the same as assigning to the trait.
    view.set_state({"model": {"kind": "cone", "radius": 3.0}})
    np.testing.assert_allclose(np.abs(view.surface(0.0, 0.0)).max(), 3.0)
    sent = []
    view.observe(lambda change: sent.append(change["new"]), "model")
    view.model = {"kind": "sphere"}
    assert sent == [{"kind": "sphere"}]


def test_a_model_shows_itself_and_what_cannot_be_shown_says_what_it_is():
    bundle = quintrig.Model.from_dict({"kind": "sphere"})._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    assert "application/vnd.jupyter.widget-view+json" in data
    # Rows that no kind of model has: a sphere squashed by hand.
    rows = quintrig.sphere().rows
    odd = Surface(Net(np.asarray(rows.points) + 0.25, rows.functions), quintrig.sphere().blend)
    assert set(odd._repr_mimebundle_()) == {"image/png", "text/plain"}
    with pytest.raises(ValueError, match="Model"):
        as_model(odd)


def test_curves_show_themselves_with_a_picture_and_a_line():
    points = [[0, 0], [3, 0], [3, 4]]  # a polygon of length 7, whose Bernstein curve is shorter
    model = quintrig.Model.from_dict({"kind": "curve", "unit": "mm", "basis": "bernstein", "points": points})
    data = model._repr_mimebundle_()[0]
    assert data["image/png"]
    assert f"one curve, length {model.curve().curve.length():.4g} mm" in data["text/plain"]


def test_bases_that_the_page_does_not_hold_come_with_the_view():
    points = RANDOM.uniform(-1, 1, (20, 2)).tolist()
    view = show(quintrig.Model.from_dict({"kind": "curve", "basis": "lambda_bezier", "points": points}))
    assert [(one["name"], list(one["formulas"])) for one in view.brought["library"]] == [("lambda_bezier", ["20"])]


def test_an_unknown_quantity_is_refused():
    with pytest.raises(ValueError, match="gaussian"):
        show(SURFACES["tensor"], "gausian")
