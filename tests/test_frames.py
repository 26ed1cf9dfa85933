"""Samples as DataFrames and Datasets say what the arrays say."""

import numpy as np
import pytest

import quintrig
from quintrig.analysis import frames
from quintrig.quantities.classify import HK_TYPES
from quintrig.support.errors import QuintrigError

KEYS = ("point", "gaussian", "hk_type")


@pytest.fixture(scope="module")
def sample():
    surface = quintrig.sphere(2.0)
    return quintrig.analyse(surface, *quintrig.grid(4, 3), KEYS)


@pytest.mark.parametrize("package", ["pandas", "polars"])
def test_a_dataframe_has_a_row_for_each_point_and_the_names_of_classes(sample, package, monkeypatch):
    pytest.importorskip(package)
    find = frames.find_spec
    monkeypatch.setattr(frames, "find_spec", lambda name: find(name) if name == package else None)
    frame = sample.to_dataframe()
    assert type(frame).__module__.startswith(package)
    assert list(frame.columns) == ["u", "v", "x", "y", "z", "gaussian", "hk_type"]
    assert np.array_equal(np.asarray(frame["gaussian"]), sample["gaussian"].ravel(), equal_nan=True)
    assert np.array_equal(np.asarray(frame["z"]), sample.point[..., 2].ravel())
    assert list(frame["hk_type"]) == [HK_TYPES[code] for code in sample["hk_type"].ravel()]


def test_a_dataset_is_over_u_and_v_on_a_grid_and_over_points_otherwise(sample):
    pytest.importorskip("xarray")
    found = sample.to_xarray()
    assert dict(found.sizes) == {"u": 4, "v": 3, "axis": 3}
    assert np.array_equal(found["gaussian"].values, sample["gaussian"], equal_nan=True)
    assert float(found["point"].sel(u=1.0, v=0.5, axis="z")) == sample.point[3, 1, 2]
    assert found["hk_type"].attrs["classes"] == list(HK_TYPES)
    points = quintrig.analyse(sample.surface, [0.1, 0.9], [0.2, 0.3], KEYS).to_xarray()
    assert points["gaussian"].shape == (2,)
    assert points["u"].values.tolist() == [0.1, 0.9]


def test_where_no_package_is_there_one_line_says_which(sample, monkeypatch):
    monkeypatch.setattr(frames, "find_spec", lambda name: None)
    with pytest.raises(QuintrigError, match="needs pandas or polars; install one of them with: pip install pandas"):
        sample.to_dataframe()
    monkeypatch.setattr(
        "quintrig.support.extras.import_module",
        lambda name: (_ for _ in ()).throw(ModuleNotFoundError(name=name)),
    )
    with pytest.raises(QuintrigError, match=r"an xarray Dataset needs xarray; install it with: .*quintrig\[frames\]"):
        sample.to_xarray()
