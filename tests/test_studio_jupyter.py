"""The studio in a notebook, from the kernel's side."""

import numpy as np
import pytest

import quintrig
from quintrig.studio.describe import as_model

pytest.importorskip("anywidget", reason="the extra 'jupyter' is not installed")

from quintrig.studio.jupyter import show

RANDOM = np.random.default_rng(3)
NET = RANDOM.uniform(-1, 1, (6, 6, 3))
CURVES = RANDOM.uniform(-1, 1, (2, 6, 3))
SURFACES = {
    "tensor": quintrig.tensor(NET, (1, -2, 0.5, -4), flip=True),
    "bernstein": quintrig.tensor(NET[:4, :3], basis="bernstein"),
    "unchecked": quintrig.tensor(NET, (2, 0, 0, 0), unchecked_shape=True),
    "swept": quintrig.swept(CURVES[0], CURVES[1], (1, 1, -3, -3)),
    "ruled": quintrig.ruled(CURVES[0], CURVES[1], (1, 0, -2, -3)),
}


@pytest.mark.parametrize("name", SURFACES)
def test_a_bare_surface_is_shown_as_itself(name):
    again = as_model(SURFACES[name]).surface
    u, v = quintrig.grid(7, 5)
    np.testing.assert_allclose(again(u, v), SURFACES[name](u, v), rtol=0, atol=1e-14)
    assert again.flip == SURFACES[name].flip


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
    assert set(quintrig.sphere()._repr_mimebundle_()) == {"text/plain"}
    with pytest.raises(ValueError, match="Model"):
        as_model(quintrig.sphere())


def test_an_unknown_quantity_is_refused():
    with pytest.raises(ValueError, match="gaussian"):
        show(SURFACES["tensor"], "gausian")
