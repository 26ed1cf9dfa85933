"""Design spaces: what a range may say, and that designs depend on their number alone."""

import tomllib

import numpy as np
import pytest

import quintrig
from quintrig.cli.remedies import worded
from quintrig.model.starter import starter
from quintrig.support.errors import ArgumentError
from quintrig.sweep.part import Task
from quintrig.sweep.space import Axis, DesignSpace, parse_axis

TENSOR = {"kind": "tensor", "points": [[[i, j, i * j * 0.1] for j in range(6)] for i in range(6)]}
PLANES = [[1.0 - 0.1 * i, 0.1 + 0.2 * i, 0.3, -10.0 - 0.2 * i] for i in range(6)]
STRIP = {"kind": "developable", "planes": PLANES, "bounds": ((0, 0, 1, 0), (0, 0, 1, -5))}
SAMPLINGS = ("grid", "latin", "sobol")


def space(sampling, samples=300, seed=0):
    axes = (Axis("alpha1", -4.0, 1.0, 5), Axis("zeta1", 0.0, 0.5, 6), Axis("zeta2", -1.0, 1.0, 10))
    return DesignSpace(axes, sampling, 0 if sampling == "grid" else samples, seed)


# ---------------------------------------------------------------------------------------------- ranges


@pytest.mark.parametrize(
    ("text", "axis"),
    [
        ("alpha1=-4:1:21", Axis("alpha1", -4.0, 1.0, 21)),
        ("alpha1=-4:1", Axis("alpha1", -4.0, 1.0, 11)),
        ("zeta2=0.5", Axis("zeta2", 0.5, 0.5, 1)),
        (" scale = 1e-1:2:3", Axis("scale", 0.1, 2.0, 3)),
        ("alpha1=-4:-4:1", Axis("alpha1", -4.0, -4.0, 1)),
    ],
)
def test_a_range_is_read(text, axis):
    assert parse_axis(text) == axis


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("alpha1", "expected name=low:high:count"),
        ("", "expected name=low:high:count"),
        ("=1:2:3", "expected name=low:high:count"),
        (" =1:2:3", "expected name=low:high:count"),
        ("alpha1=", "expected name=low:high:count"),
        ("alpha1=a:b:c", "expected name=low:high:count"),
        ("alpha1=0:1:2:3", "expected name=low:high:count"),
        ("alpha1=0:1:2.5", "expected name=low:high:count"),
        ("alpha1=1:-4:21", "reversed; write alpha1=-4:1:21"),
        ("alpha1=-4:1:0", "empty; expected a count of 1 or more, got 0"),
        ("alpha1=-4:1:-3", "empty; expected a count of 1 or more, got -3"),
        ("alpha1=-4:1:1", "one value cannot span a range"),
        ("alpha1=0.5:0.5:7", "empty; write alpha1=0.5"),
        ("alpha1=nan:1:3", "expected a finite number"),
        ("alpha1=0:inf:3", "expected a finite number"),
    ],
)
def test_a_range_that_is_none_is_refused_in_one_line(text, said):
    with pytest.raises(ValueError, match="axis") as error:
        parse_axis(text)
    assert said in str(error.value)
    assert worded(error.value).startswith("--vary ")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(("low", "high", "count"), [(1.0, -4.0, 3), (0.0, 1.0, 0), (np.nan, 1.0, 2), (0.0, 0.0, 2)])
def test_an_axis_made_by_hand_is_checked_too(low, high, count):
    with pytest.raises(ValueError, match="axis alpha1="):
        Axis("alpha1", low, high, count)


@pytest.mark.parametrize(
    ("model", "axes", "said"),
    [
        (TENSOR, (("alpha1", -4.1, 1.0, 2),), "leaves [-4, 1]"),
        (TENSOR, (("alpha1", -4.0, 1.5, 2),), "leaves [-4, 1]"),
        (TENSOR, (("alpha1", 2.0, 2.0, 1),), "leaves [-4, 1]"),
        (TENSOR, (("alhpa1", -4.0, 1.0, 2),), "did you mean 'alpha1'?"),
        (TENSOR, (("scale", 1.0, 2.0, 2),), "a tensor has alpha1, zeta1, alpha2, zeta2"),
        (STRIP, (("alpha1", -4.0, 1.0, 2),), "a developable has alpha, zeta"),
        (TENSOR | {"basis": "bernstein"}, (("alpha1", -4.0, 1.0, 2),), "has no parameters to vary"),
        ({"kind": "sphere"}, (("alpha1", -4.0, 1.0, 2),), "a sphere has radius"),
        ({"kind": "sphere"}, (("radius", -1.0, 1.0, 2),), "greater than 0"),
        (tomllib.loads(starter("nurbs")), (("alpha1", -4.0, 1.0, 2),), "a nurbs has no parameters to vary"),
        (TENSOR, (), "expected at least one parameter"),
        (TENSOR, (("zeta1", -4.0, 1.0, 2), ("zeta1", 0.0, 1.0, 2)), "'zeta1' is given twice"),
        (
            TENSOR,
            tuple((name, -4.0, 1.0, 1000) for name in ("alpha1", "zeta1", "alpha2", "zeta2")),
            "more than 1,000,000,000",
        ),
    ],
)
def test_what_does_not_fit_the_model_is_refused_in_one_line(model, axes, said):
    with pytest.raises(ValueError, match=r"axis|axes|patch") as error:
        Task(model, None, DesignSpace(tuple(Axis(*axis) for axis in axes)))
    assert said in str(error.value)
    assert "\n" not in str(error.value)


def test_unchecked_models_may_leave_the_range():
    task = Task(TENSOR | {"unchecked_shape": True}, None, DesignSpace((Axis("alpha1", -6.0, 2.0, 3),)))
    assert task.space.count == 3


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("sobol", 0), "--samples: expected 1 or more"),
        (("latin", -1), "--samples: expected 1 or more"),
        (("grid", 5), "add --sampling sobol"),
        (("latin", 10**7), "take --sampling sobol"),
        (("sobol", 10**10), "more than 1,000,000,000"),
        (("sobol", 8, -1), "--seed: expected 0 or more"),
    ],
)
def test_samples_that_do_not_fit_are_refused(arguments, said):
    with pytest.raises(ArgumentError) as error:
        DesignSpace((Axis("alpha1", -4.0, 1.0, 5),), *arguments)
    assert said in worded(error.value)
    assert "--" not in str(error.value)


@pytest.mark.parametrize("points", [3, 129, 0, -1])
def test_points_a_side_are_bounded(points):
    with pytest.raises(ValueError, match="points: expected 4 to 128"):
        Task(TENSOR, None, DesignSpace((Axis("alpha1", -4.0, 1.0, 5),)), points)


# ---------------------------------------------------------------------------------------------- designs


def test_a_grid_has_all_combinations_and_its_last_axis_varies_fastest():
    grid = space("grid")
    values = [axis.values for axis in grid.axes]
    expected = np.stack(np.meshgrid(*values, indexing="ij"), axis=-1).reshape(-1, 3)
    assert np.array_equal(grid.designs(0, grid.count), expected)
    assert (values[0][0], values[0][-1]) == (-4.0, 1.0)


@pytest.mark.parametrize("sampling", SAMPLINGS)
def test_any_run_of_designs_is_that_of_the_whole(sampling):
    whole = space(sampling).designs(0, 300)
    assert whole.shape == (300, 3)
    for start, stop in ((0, 1), (0, 8), (1, 2), (5, 133), (128, 256), (299, 300)):
        assert np.array_equal(space(sampling).designs(start, stop), whole[start:stop])


@pytest.mark.parametrize("sampling", SAMPLINGS)
def test_designs_stay_in_their_ranges(sampling):
    some = space(sampling)
    designs = some.designs(0, 300)
    for axis, values in zip(some.axes, designs.T, strict=True):
        assert axis.low <= values.min() <= values.max() <= axis.high


@pytest.mark.parametrize("sampling", ["latin", "sobol"])
def test_a_seed_says_which_sample(sampling):
    assert np.array_equal(space(sampling, seed=3).designs(0, 300), space(sampling, seed=3).designs(0, 300))
    assert not np.array_equal(space(sampling, seed=3).designs(0, 300), space(sampling, seed=4).designs(0, 300))


def test_a_latin_hypercube_has_one_design_in_each_slice():
    some = space("latin", 64)
    for axis, values in zip(some.axes, some.designs(0, 64).T, strict=True):
        slices = np.floor((values - axis.low) / (axis.high - axis.low) * 64).astype(int)
        assert sorted(slices) == list(range(64))


def test_a_sobol_sequence_is_balanced():
    some = space("sobol", 64)
    cube = np.stack([(v - a.low) / (a.high - a.low) for a, v in zip(some.axes, some.designs(0, 64).T, strict=True)])
    octants = (cube >= 0.5).T @ (1, 2, 4)
    assert np.array_equal(np.bincount(octants, minlength=8), np.full(8, 8))


@pytest.mark.parametrize("sampling", SAMPLINGS)
def test_a_space_comes_back_from_plain_data(sampling):
    assert DesignSpace.from_dict(space(sampling).to_dict()) == space(sampling)


def test_parameters_are_those_of_the_model():
    swung = {"kind": "swung", "profile": [[1, i] for i in range(6)], "trajectory": [[1, i] for i in range(6)]}
    for model, names in (
        (TENSOR, ["alpha1", "zeta1", "alpha2", "zeta2"]),
        (swung, ["alpha1", "zeta1", "alpha2", "zeta2", "scale"]),
        (swung | {"basis": "bernstein"}, ["scale"]),
        (STRIP, ["alpha", "zeta"]),
        ({"kind": "torus"}, ["major", "minor"]),
        (tomllib.loads(starter("nurbs")), []),
    ):
        assert list(quintrig.Model.from_dict(model).patch().definition.parameters) == names
