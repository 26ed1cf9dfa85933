"""The one surface type: partials of any order, shapes, size, and what belongs together."""

import numpy as np
import pytest

import oracle
import quintrig
from catalogue import SURFACES, wave
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.surface import Net, Surface

REFERENCE_POINTS = np.array([[0.11, 0.23], [0.31, 0.64], [0.58, 0.37], [0.83, 0.91]])


def over_catalogue():
    return pytest.mark.parametrize("name", SURFACES)


@over_catalogue()
def test_partials_are_limits_of_differences_to_third_order(name):
    surface = SURFACES[name].surface()
    u, v = REFERENCE_POINTS.T
    exact = surface.partials(u, v, 4)

    def differences(h):
        by_u = (surface.partials(u + h, v, 3) - surface.partials(u - h, v, 3)) / (2 * h)
        by_v = (surface.partials(u, v + h, 3) - surface.partials(u, v - h, 3)) / (2 * h)
        return np.array([np.abs(by_u - exact[1:, :4]), np.abs(by_v - exact[:4, 1:])]).max(axis=(3, 4))

    h = 4e-4
    coarse, fine = differences(h), differences(h / 2)
    # Rounding of the values that are subtracted, then second order: half the step, a quarter of the error.
    size = np.abs(exact).max(axis=(2, 3))
    terms = surface.size * 6.0 ** np.add.outer(range(4), range(4))  # what cancels where a partial is 0
    floor = 1e-13 * (size[:4, :4] + terms) / h
    assert (fine <= coarse / 3.9 + floor).all()
    scale = np.array([size[1:, :4], size[:4, 1:]]) + surface.size
    assert (coarse <= 1e-3 * scale + floor).all()


@over_catalogue()
def test_first_and_second_partials_meet_exact_values(name):
    surface, model = SURFACES[name].surface(), SURFACES[name].model
    for u, v in [*REFERENCE_POINTS, (1.0, 0.4), (0.3, 0.0)]:
        found = surface.partials(u, v, 2)
        exact = oracle.partials(model, u, v)
        reach = max(abs(x) for value in exact.values() for x in value)
        for (i, j), value in exact.items():
            error = max(abs(oracle.number(a) - b) for a, b in zip(found[i, j], value, strict=True))
            assert error <= 1e-12 * reach, f"[{i}, {j}] at {u}, {v}"


@over_catalogue()
def test_shapes_follow_the_parameters(name):
    surface = SURFACES[name].surface()
    for u, v, shape in (
        (0.5, 0.25, ()),
        ([0.1, 0.2, 0.3], 0.5, (3,)),
        (np.full((2, 1), 0.5), np.full((1, 4), 0.5), (2, 4)),
        (np.full((2, 1, 3), 0.5), np.full((5, 1), 0.5), (2, 5, 3)),
        (np.zeros((0, 1)), np.full((1, 4), 0.5), (0, 4)),
        ([], [], (0,)),
        (0, 1, ()),
    ):
        assert surface(u, v).shape == (*shape, 3)
        assert surface.partials(u, v, 1).shape == (2, 2, *shape, 3)
    apart = [[surface(u, v) for v in (0.0, 0.4)] for u in (0.3, 1.0)]
    np.testing.assert_allclose(surface([[0.3], [1.0]], [[0.0, 0.4]]), apart, rtol=0, atol=1e-14 * surface.size)


@pytest.mark.parametrize("name", [name for name in SURFACES if "cusped" not in name])
def test_size_is_the_diagonal_of_the_bounding_box(name):
    surface = SURFACES[name].surface()
    t = np.linspace(0, 1, 65)
    box = np.ptp(surface(t[:, None], t[None, :]), axis=(0, 1))
    assert 0.85 * np.linalg.norm(box) <= surface.size <= (1 + 1e-12) * np.linalg.norm(box)


def test_size_leaves_out_points_at_infinity():
    angle = np.linspace(-1, 1, 6)
    planes = np.stack([np.ones(6), angle, angle**2 + 0.3, 0 * angle], axis=-1)
    # The ruling at u = 1/2 lies in the plane y = 0, parallel to the second bound.
    strip = quintrig.developable(planes, [[0, 0, 1, -1], [0, 1, 0, -1]])
    assert 1.0 < strip.size < 1e3
    sample = quintrig.analyse(strip, *quintrig.grid(9, 3))
    assert np.isfinite(sample["mean"][[0, 2, 6, 8]]).all()
    assert np.abs(sample["gaussian"][[0, 2, 6, 8]]).max() <= 1e-12


def test_rows_and_blend_must_have_the_same_number():
    rows = Net(wave(), Trigonometric())
    with pytest.raises(ValueError, match="blend: expected 6 functions, one for each row, found 4"):
        Surface(rows, Bernstein(3))


@over_catalogue()
def test_control_points_cannot_be_changed_behind_a_surface(name):
    surface = SURFACES[name].surface()
    held = [surface.net, getattr(surface.rows, "points", None), getattr(surface.rows, "planes", None)]
    assert any(array is not None for array in held)
    assert not any(array.flags.writeable for array in held if array is not None)


def test_values_do_not_change_with_the_arrays_they_came_from():
    points = wave()
    surface = quintrig.tensor(points)
    before = surface(0.3, 0.7)
    points[:] = 0.0
    np.testing.assert_array_equal(surface(0.3, 0.7), before)
    with pytest.raises(ValueError, match="read-only"):
        surface.net[0, 0, 0] = 1.0
    with pytest.raises(AttributeError):
        surface.flip = True


def test_a_value_is_one_line_in_a_console():
    surface = quintrig.tensor(np.random.default_rng(1).normal(size=(6, 6, 3)), flip=True)
    assert repr(surface) == "<Surface of 6 rows: Trigonometric by Trigonometric, flipped>"
    assert repr(quintrig.torus()).count("\n") == 0
    sample = quintrig.analyse(surface, *quintrig.grid(20, 30))
    assert repr(sample).startswith("<Sample at 20 x 30 points: point, normal, ")
    assert len(repr(sample)) < 120
    keys = [{"kind": "sphere", "name": f"ball {i}"} for i in range(9)]
    model = quintrig.Model.from_dict({"name": "Balls", "unit": "mm", "patch": keys})
    assert repr(model) == (
        "<Model 'Balls' in mm: 'ball 0' (sphere), 'ball 1' (sphere), 'ball 2' (sphere), 'ball 3' (sphere) and 5 more>"
    )
    assert repr(model.patches[2]) == "<Patch 'ball 2': sphere>"
