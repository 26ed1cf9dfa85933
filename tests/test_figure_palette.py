"""Colours and limits: what a picture may claim about numbers."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.colors import to_rgb

from quintrig.figure import palette
from quintrig.quantities.table import CLASSES, quantity

# Full protanopia, deuteranopia and tritanopia in linear RGB (Machado, Oliveira and Fernandes 2009).
SIGHT = {
    "normal": np.eye(3),
    "protan": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deutan": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritan": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}


def lab(colours, sight):
    rgb = np.asarray(colours)
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    seen = np.clip(linear @ SIGHT[sight].T, 0.0, 1.0)
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = seen @ to_xyz.T / [0.9505, 1.0, 1.089]
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16.0 / 116.0)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=-1)


@pytest.mark.parametrize("sight", SIGHT)
@pytest.mark.parametrize("key", CLASSES)
def test_classes_are_told_apart_by_every_eye(key, sight):
    colours = palette.CLASS_COLOURS[key]
    assert len(colours) == len(quantity(key).classes)
    seen = lab([to_rgb(colour) for colour in colours], sight)
    least = min(np.linalg.norm(a - b) for a, b in itertools.combinations(seen, 2))
    assert least > 15.0  # 2.3 is just noticeable side by side


@pytest.mark.parametrize(
    "names",
    [
        {"hk_type": "peak", "invariant_type": "dome", "shape_class": "dome", "point_type": "elliptic"},
        {"hk_type": "ridge", "invariant_type": "roof", "shape_class": "ridge", "point_type": "parabolic"},
        {
            "hk_type": "minimal",
            "invariant_type": "balanced saddle",
            "shape_class": "saddle",
            "point_type": "hyperbolic",
        },
        {"hk_type": "saddle ridge", "invariant_type": "saddle roof", "shape_class": "saddle ridge"},
        {"hk_type": "valley", "invariant_type": "trough", "shape_class": "rut"},
        {"hk_type": "saddle valley", "invariant_type": "saddle trough", "shape_class": "saddle rut"},
        {"hk_type": "pit", "invariant_type": "bowl", "shape_class": "trough"},
        {"hk_type": "flat", "invariant_type": "level or tilted plane", "shape_class": "planar", "point_type": "planar"},
        dict.fromkeys(CLASSES, "undefined"),
    ],
)
def test_like_shapes_have_one_colour_in_all_classifications(names):
    colours = {palette.CLASS_COLOURS[key][quantity(key).classes.index(name)] for key, name in names.items()}
    assert len(colours) == 1


@pytest.mark.parametrize("sight", SIGHT)
def test_signs_are_told_apart_by_every_eye(sight):
    k = quantity("gaussian")
    minus, zero, plus = lab(palette.real_colours(np.array([-0.6, 0.0, 0.6]), k, palette.Limits(-1.0, 1.0)), sight)
    assert min(np.linalg.norm(minus - plus), np.linalg.norm(minus - zero), np.linalg.norm(plus - zero)) > 25.0


def test_undefined_values_are_grey_and_nothing_else_is():
    stretch = palette.Limits(-1.0, 1.0)
    for key in ("gaussian", "curvedness"):
        colours = palette.real_colours(np.array([np.nan, np.inf, -np.inf]), quantity(key), stretch)
        np.testing.assert_allclose(colours, [to_rgb(palette.UNDEFINED)] * 3)
        shown = palette.real_colours(np.linspace(-1.0, 1.0, 201), quantity(key), stretch)
        assert np.linalg.norm(shown - to_rgb(palette.UNDEFINED), axis=-1).min() > 0.1


finite = st.lists(st.floats(-1e6, 1e6, allow_subnormal=False), min_size=1, max_size=60).map(np.array)


@settings(deadline=None)
@given(finite, st.floats(0.0, 1e3))
def test_limits_with_a_sign_are_centred_and_count_what_they_clip(values, scale):
    found = palette.limits(values, quantity("gaussian"), scale)
    assert found.low == -found.high < 0.0
    assert found.clipped_share == np.mean(np.abs(values) > found.high)
    assert found.clipped_share <= 0.05 + 1.0 / len(values)


@settings(deadline=None)
@given(finite, st.floats(0.0, 1e3))
def test_limits_without_a_sign_count_what_they_clip(values, scale):
    values = np.abs(values)
    found = palette.limits(values, quantity("curvedness"), scale)
    assert found.low < found.high
    assert found.below == np.mean(values < found.low)
    assert found.above == np.mean(values > found.high)


@settings(deadline=None)
@given(finite, st.integers(-30, 30))
def test_limits_scale_with_the_quantity(values, power):
    for key in ("mean", "curvedness"):
        one = palette.limits(np.abs(values), quantity(key), 1e3)
        other = palette.limits(np.abs(values) * 2.0**power, quantity(key), 1e3 * 2.0**power)
        assert other.high == pytest.approx(one.high * 2.0**power, rel=1e-9)
        assert other.clipped_share == pytest.approx(one.clipped_share)


@settings(deadline=None)
@given(finite, finite)
def test_common_limits_are_those_of_all_values_together(first, second):
    k = quantity("gaussian")
    assert palette.limits([first, second], k) == palette.limits(np.concatenate([first, second]), k)


def test_a_few_extreme_values_do_not_spoil_the_limits():
    values = np.concatenate([np.linspace(-1.0, 1.0, 999), [1e9]])
    found = palette.limits(values, quantity("gaussian"))
    assert found.high < 1.1
    assert found.above > 0.0


@pytest.mark.parametrize("key", ["gaussian", "curvedness"])
@pytest.mark.parametrize("level", [0.0, 1.0, -1.0])
def test_rounding_is_drawn_in_one_colour(key, level):
    q = quantity(key)
    if q.colour == "sequential" and level < 0.0:
        return
    values = level + 1e-11 * np.sin(np.arange(500.0))
    stretch = palette.limits(values, q, 1.0)
    colours = palette.real_colours(values, q, stretch)
    assert np.ptp(colours, axis=0).max() < 0.02
    if level == 0.0 and q.colour == "diverging":
        assert np.ptp(colours[0]) < 0.05  # the neutral middle
    if level != 0.0 and q.colour == "diverging":
        assert (colours[0, 0] > colours[0, 2]) == (level > 0.0)  # red for plus, blue for minus


@pytest.mark.parametrize("key", ["gaussian", "curvedness"])
@pytest.mark.parametrize("values", [np.zeros(0), np.full(5, np.nan), np.array([np.inf, -np.inf])])
def test_limits_of_nothing_are_still_limits(key, values):
    found = palette.limits(values, quantity(key))
    assert found.low < found.high
    assert found.clipped_share == 0.0


def test_the_shape_index_always_has_its_whole_range():
    assert palette.limits(np.array([0.1, 0.2]), quantity("shape_index")) == palette.Limits(-1.0, 1.0)
