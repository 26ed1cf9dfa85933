"""What a user computes can be sent to another process, copied and kept, and comes back the same and as read-only."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.analysis.summary import summarise
from quintrig.geometry.domain import grid
from quintrig.geometry.nurbs import nurbs

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("*.toml"))
WAYS = {"pickle": lambda value: pickle.loads(pickle.dumps(value)), "deepcopy": copy.deepcopy}


@pytest.fixture(params=WAYS)
def again(request):
    return WAYS[request.param]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_models_and_their_surfaces(path, again):
    model = quintrig.load(path)
    back = again(model)
    assert back.to_dict() == model.to_dict()
    for one, other in zip(model.patches, back.patches, strict=True):
        np.testing.assert_array_equal(other.surface(*grid(5, 4)), one.surface(*grid(5, 4)))
        rows = other.surface.rows
        for array in (other.surface.net, *(getattr(rows, name, None) for name in ("points", "planes", "bounds"))):
            assert array is None or not array.flags.writeable


def test_a_sample(again):
    surface = quintrig.load(EXAMPLES[0]).patches[0].surface
    sample = quintrig.analyse(surface, *grid(5, 4))
    back = again(sample)
    assert list(back.values) == list(sample.values)
    for key in sample.values:
        np.testing.assert_array_equal(back[key], sample[key])
    assert (back.size, back.thresholds, back.shape) == (sample.size, sample.thresholds, sample.shape)
    with pytest.raises(TypeError):
        back.values["mean"] = 0


def test_a_curve_a_rational_face_and_a_summary(again):
    curve = quintrig.Curve([[i, i * i, 0] for i in range(6)], 0.5, -1)
    np.testing.assert_array_equal(again(curve)(np.linspace(0, 1, 7)), curve(np.linspace(0, 1, 7)))
    with pytest.raises(ValueError, match="read-only"):
        again(curve).points[0] = 0
    corner = [[0, 0], [1, 0], [1, 1]]
    face = nurbs([[[i, j, i * j] for j in range(3)] for i in range(3)], [[1, 2, 1]] * 3, trim=[corner])
    back = again(face)
    np.testing.assert_array_equal(back(*grid(5, 4)), face(*grid(5, 4)))
    assert not back.trim[0].flags.writeable
    summary = summarise(face)
    assert again(summary).extremes["mean"].maximum.value == summary.extremes["mean"].maximum.value
    assert again(summary).warnings == summary.warnings
