"""The table of quantities, and the classes that it names."""

import pytest

from quintrig import analyse, sphere
from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, POINT_TYPES, SHAPE_CLASSES
from quintrig.quantities.table import BY_KEY, CLASSES, QUANTITIES, SCALARS, mirrored, quantity

every_row = pytest.mark.parametrize("q", QUANTITIES, ids=[q.key for q in QUANTITIES])


def test_keys_and_names_are_told_apart():
    assert len({q.key for q in QUANTITIES}) == len(QUANTITIES)
    assert len({BY_KEY[key].symbol for key in SCALARS}) == len(SCALARS)
    assert len({(q.name, q.meaning) for q in QUANTITIES}) == len(QUANTITIES)
    vectors = {q.key for q in QUANTITIES if q.colour == "vector"}
    assert set(SCALARS) | set(CLASSES) | vectors == set(BY_KEY)


@every_row
def test_row_says_all_that_is_shown(q):
    for text in (q.symbol, q.latex, q.name, q.meaning, q.source):
        assert text.strip()
        assert "\n" not in text
    assert q.components == (3 if q.colour == "vector" else 1)
    assert quantity(q.key) is q


@every_row
def test_parity_and_partner_fit(q):
    if q.parity == "swap":
        assert BY_KEY[q.partner].partner == q.key
        assert BY_KEY[q.partner].power == q.power
    else:
        assert q.partner == ""
    assert bool(q.classes) == (q.colour == "classes")
    if q.colour == "classes":
        assert q.power == 0
        assert q.classes[0] == "undefined"
        assert len(set(q.classes)) == len(q.classes)
        assert q.parity in ("even", "mirror")


@pytest.mark.parametrize(
    ("key", "unit"),
    [
        ("point", "mm"),
        ("normal", ""),
        ("E", "mm²"),
        ("L", "mm"),
        ("gaussian", "1/mm²"),
        ("mean", "1/mm"),
        ("k1", "1/mm"),
        ("direction1", ""),
        ("shape_index", ""),
        ("curvedness", "1/mm"),
        ("beta0", ""),
        ("beta1", "1/mm"),
        ("beta2_surface", "1/mm²"),
        ("gamma2", "1/mm"),
        ("hk_type", ""),
    ],
)
def test_units(key, unit):
    assert quantity(key).unit("mm") == unit
    assert quantity(key).unit("") == ""


@every_row
def test_turning_twice_gives_back_every_class(q):
    for code in range(len(q.classes)):
        turned = mirrored(q.key, code)
        assert 0 <= turned < len(q.classes)
        assert mirrored(q.key, turned) == code
        assert (turned == 0) == (code == 0)


def test_turning_changes_the_sign_of_h_in_hk_types():
    turned = {HK_TYPES[code]: HK_TYPES[mirrored("hk_type", code)] for code in range(10)}
    pairs = {"peak": "pit", "ridge": "valley", "saddle ridge": "saddle valley"}
    same = {name: name for name in ("undefined", "flat", "minimal", "impossible")}
    assert turned == pairs | {b: a for a, b in pairs.items()} | same


def test_turning_changes_the_sign_of_the_shape_index():
    turned = {SHAPE_CLASSES[code]: SHAPE_CLASSES[mirrored("shape_class", code)] for code in range(11)}
    pairs = {"spherical cup": "spherical cap", "trough": "dome", "rut": "ridge", "saddle rut": "saddle ridge"}
    same = {name: name for name in ("undefined", "saddle", "planar")}
    assert turned == pairs | {b: a for a, b in pairs.items()} | same


def test_classes_of_the_height_and_of_points_do_not_turn():
    for key, names in (("point_type", POINT_TYPES), ("invariant_type", INVARIANT_TYPES)):
        assert [mirrored(key, code) for code in range(len(names))] == list(range(len(names)))


@pytest.mark.parametrize(("word", "meant"), [("gausian", "gaussian"), ("curvednes", "curvedness"), ("mena", "mean")])
def test_unknown_quantity_names_the_nearest(word, meant):
    with pytest.raises(ValueError, match=f"unknown quantity '{word}'; did you mean '{meant}'"):
        quantity(word)


@pytest.mark.parametrize(
    ("symbol", "key"),
    [
        *(("K", "gaussian"), ("k", "gaussian"), ("h", "mean"), ("κ1", "k1"), ("κ₂", "k2"), ("kappa_1", "k1")),
        *(
            ("S", "shape_index"),
            ("γ3", "gamma3"),
            ("n", "normal"),
            ("N", "N"),
            (r"\beta_{0}", "beta0"),
            ("C", "curvedness"),
        ),
    ],
)
def test_a_symbol_is_as_good_as_its_key(symbol, key):
    assert quantity(symbol).key == key


def test_every_symbol_leads_to_a_quantity_of_that_symbol():
    for q in QUANTITIES:
        assert quantity(q.symbol).symbol == q.symbol
        assert quantity(q.key) is q


def test_a_sample_knows_symbols_too():
    sample = analyse(sphere(2.0), 0.3, 0.4, ["K", "κ1"])
    assert sample["K"] == sample["gaussian"] == pytest.approx(0.25, rel=1e-12)


def test_unknown_quantity_far_from_all_names_some():
    with pytest.raises(ValueError, match="such as K, H, κ1, κ2") as caught:
        quantity("temperature")
    assert "did you mean" not in str(caught.value)


def test_a_symbol_that_is_no_quantity_names_those_of_its_letter():
    with pytest.raises(ValueError, match="κ1") as caught:
        quantity("κ3")
    assert "H" not in str(caught.value).partition(";")[2].partition(";")[0]


@pytest.mark.parametrize("q", QUANTITIES, ids=lambda q: q.key)
def test_what_is_at_a_point_is_said_apart_from_how_it_is_coloured(q):
    assert (q.kind == "class") == bool(q.classes)
    assert (q.kind == "vector") == (q.components == 3) == (q.key in {"point", "normal", "direction1", "direction2"})
    assert q.kind != "scalar" or q.colour in ("diverging", "sequential")
