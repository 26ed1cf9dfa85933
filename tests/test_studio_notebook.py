"""What a notebook keeps of a view when it is exported, and that view and page stay the same in both directions."""

import base64
import io

import numpy as np
import pytest
from PIL import Image

import quintrig

pytest.importorskip("anywidget", reason="the extra 'jupyter' is not installed")

from quintrig.studio.jupyter import show

CONE = {"kind": "cone", "radius": 2.0, "height": 3.0, "unit": "mm", "name": "A tent"}


def shown(subject):
    data, _ = subject._repr_mimebundle_()
    return data


def picture(data):
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(data["image/png"]))).convert("RGB"), dtype=float)


@pytest.mark.parametrize(
    "subject", [quintrig.Model.from_dict(CONE), quintrig.sphere(2.0), show(quintrig.Model.from_dict(CONE), "mean")]
)
def test_what_is_shown_has_a_live_view_a_picture_and_a_line(subject):
    data = shown(subject)
    assert {"application/vnd.jupyter.widget-view+json", "image/png", "text/plain"} <= set(data)
    image = picture(data)
    assert min(image.shape[:2]) > 200
    assert image.std(axis=(0, 1)).max() > 10  # something is drawn
    assert "\n" not in data["text/plain"]


def test_the_line_says_what_the_thing_is():
    view = show(quintrig.Model.from_dict(CONE), "mean")
    assert shown(view)["text/plain"].startswith("A tent: one patch (cone), 4 × 4 × 3 mm, coloured by mean curvature H")
    view.model = {"name": "pair", "patch": [{"kind": "sphere"}, {"name": "b", "kind": "sphere", "radius": 5}]}
    view.quantity = "none"
    assert shown(view)["text/plain"].startswith("pair: 2 patches (2 sphere), 10 × 10 × 10, without colours")


def test_the_picture_follows_what_was_done_in_the_page():
    view = show(quintrig.Model.from_dict(CONE), "mean")
    first = shown(view)["image/png"]
    view.set_state({"quantity": "hk_type"})
    second = shown(view)["image/png"]
    view.set_state({"model": {**CONE, "radius": 5.0}})
    assert len({first, second, shown(view)["image/png"]}) == 3


@pytest.mark.parametrize("points", [0.0, 1e6])
def test_a_surface_that_is_a_point_is_shown_too(points):
    data = shown(quintrig.Model.from_dict({"kind": "tensor", "points": np.full((6, 6, 3), points).tolist()}))
    assert "0 × 0 × 0" in data["text/plain"]
    assert "image/png" in data


@pytest.mark.parametrize(("key", "reason"), [("gausian", "gaussian"), ("normal", "vector")])
def test_a_quantity_that_cannot_be_shown_is_refused_and_the_old_one_stays(key, reason):
    view = show(quintrig.sphere(), "mean")
    with pytest.raises(ValueError, match=reason):
        view.quantity = key
    assert view.quantity == "mean"


def test_quantity_and_height_from_the_page_are_the_kernels():
    view = show(quintrig.sphere(), "mean", height=400)
    told = []
    view.observe(lambda change: told.append((change["name"], change["new"])), ["quantity", "height"])
    view.set_state({"quantity": "none", "height": 700})
    assert sorted(told) == [("height", 700), ("quantity", "none")]
