"""Tables 3.1 to 3.4 as data, against surfaces that are what the tables say."""

from fractions import Fraction

import numpy as np
import pytest

import quintrig
from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, POINT_TYPES, SHAPE_CLASSES
from quintrig.quantities.signs import CLASSES, HEIGHTS, INVARIANTS, POINTS, SIGN_TABLES, TYPES


def height_field(coefficients):
    """z = Σ c_pq x^p y^q over |x|, |y| <= 1 from {(p, q): c}, as an exact biquadratic patch, seen from above."""
    power = np.zeros((3, 3))
    for (p, q), c in coefficients.items():
        power[p, q] = c
    to_bernstein = np.array([[1, -1, 1], [1, 0, -1], [1, 1, 1.0]])  # of 1, x, x² on [-1, 1]
    z = to_bernstein @ power @ to_bernstein.T
    x, y = np.meshgrid([-1.0, 0, 1], [-1.0, 0, 1], indexing="ij")
    return quintrig.tensor(np.stack([x, y, z], axis=-1), basis="bernstein")


def middle(coefficients, key):
    return float(quintrig.analyse(height_field(coefficients), 0.5, 0.5, (key,))[key])


def test_tables_are_rectangular_and_name_their_source():
    assert [table.number[:3] for table in SIGN_TABLES] == ["3.1", "3.2", "3.3", "3.4", "3.4"]
    for table in SIGN_TABLES:
        assert table.title
        assert table.source
        assert all(len(row) == len(table.columns) for row in table.rows)


def test_every_name_of_the_classifications_is_in_its_table():
    assert {row[0] for row in POINTS.rows} == set(POINT_TYPES[1:])
    assert {row[0] for row in TYPES.rows} == set(HK_TYPES[1:])
    assert {row[0] for row in CLASSES.rows} == set(SHAPE_CLASSES[1:])
    assert {row[0] for row in HEIGHTS.rows} == set(INVARIANT_TYPES[1:])


# z = a x² + b y²: from above κ = 2a, 2b, H = a + b, K = 4ab.
BOWLS = [(1, 1), (1, 2), (1, 0), (2, -1), (1, -1), (0, 0), (-1, 2), (1, -2), (-1, 0), (-1, -2), (-1, -1)]


def sign(x):
    return "-0+"[int(np.sign(x)) + 1]


@pytest.mark.parametrize(("a", "b"), BOWLS)
def test_signs_of_paraboloids_give_the_types_of_the_tables(a, b):
    surface = height_field({(2, 0): a, (0, 2): b})
    sample = quintrig.analyse(surface, 0.5, 0.5)
    types = {(row[1], row[2]): row[0] for row in TYPES.rows}
    assert HK_TYPES[int(sample["hk_type"])] == types[sign(a + b), sign(a * b)]
    heights = {(row[1], row[2]): row[0] for row in HEIGHTS.rows}
    assert INVARIANT_TYPES[int(sample["invariant_type"])] == heights[sign(a + b), sign(a * b)]
    points = {row[0]: row for row in POINTS.rows}[POINT_TYPES[int(sample["point_type"])]]
    assert points[1] == sign(a * b)
    index = float(sample["shape_index"])
    if a == b == 0:
        assert SHAPE_CLASSES[int(sample["shape_class"])] == "planar"
        return
    (low, high) = {row[0]: row[1] for row in CLASSES.rows}[SHAPE_CLASSES[int(sample["shape_class"])]][1:-1].split(", ")
    assert Fraction(low) <= index <= Fraction(high)


def test_ranges_of_the_shape_index_join_without_gap_or_overlap():
    ranges = [row[1] for row in CLASSES.rows[:9]]
    ends = [[Fraction(x) for x in text[1:-1].split(", ")] for text in ranges]
    assert ends[0][0] == -1
    assert ends[-1][1] == 1
    for i in range(8):
        assert ends[i][1] == ends[i + 1][0]
        assert (ranges[i][-1], ranges[i + 1][0]) in ((")", "["), ("]", "("))  # the break belongs to one of them
    assert [high for _, high in ends[:-1]] == [Fraction(k, 8) for k in (-7, -5, -3, -1, 1, 3, 5, 7)]


@pytest.mark.parametrize(
    ("key", "coefficients", "expected"),
    [
        ("beta0", {(0, 1): 1}, "+"),  # sloping
        ("beta0", {(2, 0): 1}, "0"),  # level
        ("beta1", {(2, 0): 1}, "+"),  # rises
        ("beta1", {(2, 0): -1, (0, 2): -1}, "-"),  # falls away
        ("beta1", {(2, 0): 1, (0, 2): -1}, "0"),  # up and down alike
        ("beta2", {(1, 1): 1}, "-"),  # saddle
        ("beta2", {(2, 0): 1, (0, 1): 1}, "0"),  # developable
        ("beta2", {(2, 0): -1, (0, 2): -1}, "+"),  # dome
        ("gamma1", {(0, 1): 1, (0, 2): 1}, "+"),  # z_y = 1 + 2y: the slope eases towards -y, downhill
        ("gamma1", {(0, 1): 1, (0, 2): -1}, "-"),  # it steepens downhill
        ("gamma1", {(0, 1): 1, (2, 0): 1}, "0"),  # straight profile
        ("gamma2", {(0, 1): 1, (1, 1): 1}, "-"),  # ∇z = (y, 1 + x): going up along +y it turns towards +x, right
        ("gamma2", {(0, 1): 1, (1, 1): -1}, "+"),  # left
        ("gamma2", {(0, 1): 1, (2, 0): 1}, "0"),  # the bottom line of a hollow
        ("gamma3", {(0, 1): 1, (2, 0): 1}, "+"),  # hollow: rises to both sides; its contour y = -x² bends downhill
        ("gamma3", {(0, 1): 1, (2, 0): -1}, "-"),  # spur
        ("gamma3", {(0, 1): 1, (0, 2): 1}, "0"),  # straight contour lines
    ],
)
def test_signs_of_the_invariants_mean_what_the_table_says(key, coefficients, expected):
    assert sign(middle(coefficients, key)) == expected


def test_the_six_invariants_are_listed_in_order():
    assert [row[0] for row in INVARIANTS.rows] == ["β0", "β1", "β2", "γ1", "γ2", "γ3"]
