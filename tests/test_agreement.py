"""The comparison of the methods: its tables against the scale of S, its map against the formulas."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import quintrig
from quintrig.analysis.agreement import PAIRS, REASONS, compare_methods
from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, SHAPE_CLASSES, Thresholds
from quintrig.quantities.correspondence import (
    AGREE,
    CLASS_VERSUS_HEIGHT,
    CONFLICT,
    HK_VERSUS_CLASS,
    HK_VERSUS_HEIGHT,
    LEVELS,
    NEIGHBOURING,
)

NAMES = [reason.name for reason in REASONS]


def waved(seed, height=1.0):
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    return np.stack([x, y, height * rng.normal(size=(6, 6))], axis=-1)


def hk_of(index, zero=0.0):
    """Besl's type of a shape index by K / C² = -cos πS and H / C = -sin(πS/2)."""
    k, h = -np.cos(np.pi * index), -np.sin(np.pi * index / 2)
    signs = [0 if abs(x) <= zero else int(np.sign(x)) for x in (h, k)]
    return 1 + 3 * (1 + signs[0]) + 1 - signs[1]


def class_of(index):
    """Koenderink's class by the breaks of thesis table 3.3."""
    return 1 + sum(index > edge for edge in (-7 / 8, -5 / 8, -3 / 8, -1 / 8, 1 / 8, 3 / 8, 5 / 8, 7 / 8))


def test_along_the_scale_of_s_types_and_classes_never_conflict_and_every_allowed_cell_occurs():
    met = set()
    for index in np.linspace(-1, 1, 4001):
        for zero in (1e-9, 0.1):
            cell = hk_of(index, zero), class_of(index)
            assert HK_VERSUS_CLASS[cell] in (AGREE, NEIGHBOURING), (index, cell)
            met.add(cell)
    allowed = {tuple(int(i) for i in cell) for cell in np.argwhere((HK_VERSUS_CLASS == 1) | (HK_VERSUS_CLASS == 2))}
    assert met == allowed - {(HK_TYPES.index("flat"), SHAPE_CLASSES.index("planar"))}


@pytest.mark.parametrize(
    ("hk", "shape", "level"),
    [
        ("peak", "dome", AGREE),
        ("peak", "spherical cap", AGREE),
        ("peak", "ridge", NEIGHBOURING),
        ("peak", "saddle", CONFLICT),
        ("ridge", "ridge", AGREE),
        ("saddle ridge", "saddle ridge", AGREE),
        ("saddle ridge", "ridge", NEIGHBOURING),
        ("saddle ridge", "saddle", NEIGHBOURING),
        ("saddle ridge", "saddle rut", CONFLICT),
        ("minimal", "saddle", AGREE),
        ("valley", "rut", AGREE),
        ("saddle valley", "saddle rut", AGREE),
        ("pit", "trough", AGREE),
        ("pit", "spherical cup", AGREE),
        ("flat", "planar", AGREE),
        ("flat", "saddle", CONFLICT),
    ],
)
def test_the_correspondence_in_words(hk, shape, level):
    assert HK_VERSUS_CLASS[HK_TYPES.index(hk), SHAPE_CLASSES.index(shape)] == level


@pytest.mark.parametrize(
    ("shape", "height", "level"),
    [
        ("dome", "dome", AGREE),
        ("spherical cup", "bowl", AGREE),
        ("saddle", "balanced saddle", AGREE),
        ("saddle", "saddle roof", NEIGHBOURING),
        ("ridge", "dome", NEIGHBOURING),
        ("saddle ridge", "balanced saddle", NEIGHBOURING),
        ("saddle ridge", "saddle trough", CONFLICT),
        ("dome", "bowl", CONFLICT),
        ("planar", "level or tilted plane", AGREE),
    ],
)
def test_the_correspondence_of_classes_and_invariants(shape, height, level):
    assert CLASS_VERSUS_HEIGHT[SHAPE_CLASSES.index(shape), INVARIANT_TYPES.index(height)] == level


def test_types_conflict_exactly_where_a_sign_is_reversed():
    for i in range(1, 10):
        for j in range(1, 10):
            signs = [(1 - (code - 1) % 3, (code - 1) // 3 - 1) for code in (i, j)]
            reversed_sign = any(a * b < 0 for a, b in zip(*signs, strict=True))
            expected = AGREE if i == j else CONFLICT if reversed_sign else NEIGHBOURING
            assert HK_VERSUS_HEIGHT[i, j] == expected


@settings(max_examples=20, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    shape=st.tuples(*[st.floats(-4, 1)] * 4),
    height=st.sampled_from([0.1, 1.0, 5.0]),
    relative=st.sampled_from([1e-9, 1e-3, 0.1]),
)
def test_the_map_follows_from_the_formulas(seed, shape, height, relative):
    surface = quintrig.tensor(waved(seed, height), shape)
    result = compare_methods(surface, 17, 19, Thresholds(relative=relative))
    sample = quintrig.analyse(surface, result.u, result.v, thresholds=result.thresholds)
    assert result.reason.shape == (17, 19)
    assert sum(result.counts()) == 17 * 19
    assert sum(result.shares()) == pytest.approx(1, rel=1e-12)
    assert result.counts()[NAMES.index("rounding")] == 0
    assert result.counts()[NAMES.index("singular")] == sample.singular.sum()
    slope = result.reason == NAMES.index("slope")
    up = np.sign(sample.normal[..., 2])
    # Where the slope reverses the sign the surface is a saddle, and γ3 does it.
    assert (sample["gaussian"][slope] < 0).all()
    assert (up * sample["mean"] * sample["beta1"])[slope].max(initial=-1) < 0
    assert (np.abs(sample["gamma3"]) > np.abs(sample["beta1"]))[slope].all()
    # Where all agree the signs of H (from above) and β1 are one, or both count as zero.
    agree = result.reason == NAMES.index("agree")
    clear = agree & (np.abs(sample["mean"]) > 2 * relative * sample["curvedness"])
    assert (up * sample["mean"] * sample["beta1"])[clear].min(initial=1) > 0


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 10**6), scale=st.sampled_from([1e-3, 1e3]))
def test_turning_the_normal_or_scaling_changes_nothing(seed, scale):
    net = waved(seed)
    one = compare_methods(quintrig.tensor(net, (1, 1, -3, -3)), 33, 33)
    other = compare_methods(quintrig.tensor(scale * net, (1, 1, -3, -3), flip=True), 33, 33)
    # Only a sample on the very edge of a class may go either way.
    assert (one.reason != other.reason).mean() < 0.01
    assert one.turned == 0
    assert other.turned == 33 * 33
    assert "against" in other.orientation


def test_tables_count_every_point_and_all_area():
    result = compare_methods(quintrig.torus(3, 1))
    for pair, table in zip(PAIRS, result.tables, strict=True):
        assert (table.rows, table.columns) == pair
        assert table.counts.sum() == 65 * 65
        assert table.shares.sum() == pytest.approx(1, rel=1e-12)
        assert table.counts.shape == (len(table.row_names), len(table.column_names)) == table.levels.shape
        assert sum(table.count(level) for level in range(4)) == 65 * 65
    # No area conflicts, and peak is exactly where K > 0: half the tube angle, of more than half the area.
    own = result.tables[0]
    assert own.share(CONFLICT) == 0
    assert own.shares[HK_TYPES.index("peak")].sum() == pytest.approx(0.5 + 1 / (3 * np.pi), abs=0.02)
    assert own.share(AGREE) + own.share(NEIGHBOURING) == pytest.approx(1)


def test_on_a_sphere_all_agree_but_on_the_equator():
    result = compare_methods(quintrig.sphere(5))
    counts = dict(zip(NAMES, result.counts(), strict=True))
    assert counts == {**dict.fromkeys(NAMES, 0), "agree": 62 * 65, "singular": 2 * 65, "vertical": 65}
    assert result.turned == 31 * 65  # the southern half, outwards is down
    assert result.share("conflict") == 0
    assert result.tables[0].counts[HK_TYPES.index("peak"), SHAPE_CLASSES.index("spherical cap")] == 63 * 65


def test_on_a_vertical_cylinder_the_invariants_are_undefined_and_the_other_two_agree():
    result = compare_methods(quintrig.cylinder())
    assert result.share("undefined") == pytest.approx(1)
    assert result.tables[0].share(AGREE) == 1
    assert np.isnan(result.tables[1].share(AGREE))
    assert any("vertical" in line for line in result.describe())


def test_on_a_helicoid_all_say_saddle():
    # H = 0, and z depends on the angle only, so β1 = 0 too.
    counts = dict(zip(NAMES, compare_methods(quintrig.helicoid()).counts(), strict=True))
    assert counts["agree"] == 64 * 65
    assert counts["vertical"] == 65  # the axis


def test_on_a_catenoid_h_is_zero_and_the_laplacian_is_not():
    result = compare_methods(quintrig.catenoid())
    assert result.reason[0, 0] == NAMES.index("zero of H")
    assert result.share("agree") == 0
    assert result.share("conflict") == 0


def test_a_plane_is_flat_for_all_three():
    result = compare_methods(quintrig.tensor(waved(0, 0.0) + np.array([0, 0, 1])))
    assert result.share("agree") == pytest.approx(1)
    assert (result.reason == NAMES.index("flat")).all()


def test_a_surface_without_area_is_undefined():
    result = compare_methods(quintrig.tensor(np.ones((6, 6, 3))), 5, 5)
    assert (result.level == LEVELS.index("undefined")).all()
    assert "no area" in result.describe()[0]


def test_the_result_in_words_states_shares_and_reasons():
    told = compare_methods(quintrig.tensor(waved(0), (1, 1, -3, -3), flip=True)).describe()
    assert "agree on" in told[0]
    assert "contradict" in told[0]
    assert any(line.startswith("class width") for line in told)
    assert any(line.startswith("slope") for line in told)
    assert "turned over" in told[-1]


def test_bad_grids_are_refused():
    with pytest.raises(ValueError, match="nv: expected 2 or more"):
        compare_methods(quintrig.sphere(), 5, 1)
