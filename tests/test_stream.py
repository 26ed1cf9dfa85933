"""Grids of any size, block by block: the same numbers as ``analyse``, in constant memory, whole files or none."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as command
from quintrig.analysis import stream
from quintrig.analysis.integrate import orientation
from quintrig.analysis.stream import analyse_blocks, write_parquet, write_zarr
from quintrig.quantities.table import BY_KEY
from quintrig.support.errors import QuintrigError

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1}
SURFACE = quintrig.Model.from_dict(CASES[2]["model"]).surface
POLE = quintrig.sphere(2.0)  # singular along two edges
KEYS = ("gaussian", "normal", "hk_type")


@pytest.fixture
def small_blocks(monkeypatch):
    monkeypatch.setattr(stream, "_POINTS", 100)


def joined(surface, nu, nv, keys):
    blocks = list(analyse_blocks(surface, nu, nv, keys))
    assert [block.start for block in blocks] == [0, *(block.stop for block in blocks[:-1])]
    assert blocks[-1].stop == nu
    return blocks, {key: np.concatenate([block.sample[key] for block in blocks]) for key in keys}


# ---------------------------------------------------------------------------------------------- the numbers


@pytest.mark.parametrize(("nu", "nv"), [(2, 2), (2, 501), (501, 2), (17, 33), (101, 7), (3, 100), (128, 129)])
def test_blocks_together_are_analyse_of_the_whole(small_blocks, nu, nv):
    whole = quintrig.analyse(SURFACE, *quintrig.grid(nu, nv))
    blocks, parts = joined(SURFACE, nu, nv, tuple(BY_KEY))
    for key, values in parts.items():
        np.testing.assert_array_equal(values, whole[key], err_msg=key)
    np.testing.assert_array_equal(np.concatenate([block.sample.u for block in blocks]), whole.u)
    assert len(blocks) == -(-nu // max(1, 100 // nv))


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_exact_cases_are_met_to_1e_11(small_blocks, case):
    surface = quintrig.Model.from_dict(case["model"]).surface
    _, parts = joined(surface, 21, 21, tuple(POWERS))
    for p in case["points"]:
        i, j = round(20 * p["u"]), round(20 * p["v"])
        for key, power in POWERS.items():
            assert abs(parts[key][i, j] - p[key]) <= 1e-11 * p["curvedness"] ** power, key


@pytest.mark.parametrize(("nu", "nv", "keys"), [(1, 5, "mean"), (5, 1, "mean"), (5, 2**25, "mean"), (5, 5, "maen")])
def test_what_cannot_be_is_refused_before_the_first_block(nu, nv, keys):
    with pytest.raises(ValueError, match=r"nu|nv|did you mean 'mean'"):
        analyse_blocks(SURFACE, nu, nv, keys)


# ---------------------------------------------------------------------------------------------- files


def test_zarr_holds_the_values_with_units(tmp_path, small_blocks):
    zarr = pytest.importorskip("zarr")
    out = write_zarr(POLE, tmp_path / "new" / "a.zarr", 23, 11, (*KEYS, "K"), unit="mm")
    group = zarr.open_group(str(out), mode="r")
    whole = quintrig.analyse(POLE, *quintrig.grid(23, 11))
    for key in KEYS:
        np.testing.assert_array_equal(group[key][:], whole[key])
        assert group[key].dtype == whole[key].dtype
        assert group[key].attrs["unit"] == BY_KEY[key].unit("mm")
        assert group[key].attrs["name"] == BY_KEY[key].name
        assert tuple(group[key].attrs["classes"]) == BY_KEY[key].classes
    np.testing.assert_array_equal(group["u"][:], np.linspace(0, 1, 23))
    np.testing.assert_array_equal(group["v"][:], np.linspace(0, 1, 11))
    assert group.attrs["normal"] == orientation(POLE)
    assert np.isnan(group["gaussian"][:]).sum() == 22  # the row of each pole


def test_parquet_holds_a_row_a_point_with_units(tmp_path, small_blocks):
    pl = pytest.importorskip("polars")
    pytest.importorskip("pyarrow")
    out = write_parquet(POLE, tmp_path / "new" / "a.parquet", 23, 11, (*KEYS, "K"), unit="mm")
    table = pl.read_parquet(out)
    whole = quintrig.analyse(POLE, *quintrig.grid(23, 11))
    assert table.columns == ["u", "v", "gaussian", "normal_x", "normal_y", "normal_z", "hk_type"]
    np.testing.assert_array_equal(table["u"], np.repeat(np.linspace(0, 1, 23), 11))
    np.testing.assert_array_equal(table["v"], np.tile(np.linspace(0, 1, 11), 23))
    np.testing.assert_array_equal(table["gaussian"], whole["gaussian"].ravel())
    np.testing.assert_array_equal(table["normal_z"], whole.normal[..., 2].ravel())
    np.testing.assert_array_equal(table["hk_type"], whole["hk_type"].ravel())
    notes = pl.read_parquet_metadata(out)
    assert notes["unit of gaussian"] == "1/mm²"
    assert notes["unit of hk_type"] == ""
    assert notes["normal"] == orientation(POLE)
    assert notes["unit of length"] == "mm"


def writers():
    return [pytest.param(write_zarr, "zarr", id="zarr"), pytest.param(write_parquet, "pyarrow", id="parquet")]


def content(path):
    files = sorted(path.rglob("*")) if path.is_dir() else [path]
    return {str(file.relative_to(path.parent)): file.read_bytes() for file in files if file.is_file()}


@pytest.mark.parametrize(("write", "package"), writers())
def test_a_stopped_run_leaves_the_old_output_and_nothing_else(tmp_path, small_blocks, write, package):
    pytest.importorskip(package)

    class Stop(BaseException):
        pass

    def stop(done, total):
        if done > 10:
            raise Stop

    out = write(SURFACE, tmp_path / "out", 20, 10)
    before = content(out)
    with pytest.raises(Stop):
        write(POLE, out, 30, 10, progress=stop)
    assert content(out) == before
    with pytest.raises(Stop):
        write(POLE, tmp_path / "other", 30, 10, progress=stop)
    assert [file.name for file in tmp_path.iterdir()] == ["out"]
    write(POLE, out, 30, 10)
    assert content(out) != before


@pytest.mark.parametrize(("write", "package"), writers())
def test_progress_goes_up_to_the_last_row(tmp_path, small_blocks, write, package):
    pytest.importorskip(package)
    seen = []
    write(SURFACE, tmp_path / "out", 25, 10, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(10, 25), (20, 25), (25, 25)]


@pytest.mark.parametrize(("write", "package"), writers())
def test_a_place_that_cannot_be_written_is_told_in_one_line(tmp_path, write, package):
    pytest.importorskip(package)
    (tmp_path / "file").write_text("dear")
    with pytest.raises(QuintrigError, match="cannot be written") as error:
        write(SURFACE, tmp_path / "file" / "out", 5, 5)
    assert "\n" not in str(error.value)
    assert [file.name for file in tmp_path.iterdir()] == ["file"]


def test_what_is_in_the_way_is_kept(tmp_path):
    pytest.importorskip("zarr")
    pytest.importorskip("pyarrow")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "letter").write_text("dear")
    with pytest.raises(QuintrigError, match="is no Zarr group"):
        write_zarr(SURFACE, tmp_path / "folder", 5, 5)
    with pytest.raises(QuintrigError, match="found a folder"):
        write_parquet(SURFACE, tmp_path / "folder", 5, 5)
    assert content(tmp_path / "folder") == {"folder/letter": b"dear"}


PEAK = """
import resource, sys
from pathlib import Path
import quintrig
from quintrig.analysis.stream import write_zarr, write_parquet
surface = quintrig.sphere(2.0)
write = {"zarr": write_zarr, "parquet": write_parquet}[sys.argv[1]]
write(surface, Path(sys.argv[2]), int(sys.argv[3]), 2000, ("k1", "k2"))
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


@pytest.mark.parametrize(("kind", "package"), [("zarr", "zarr"), ("parquet", "pyarrow")])
def test_peak_memory_does_not_grow_with_the_grid(tmp_path, kind, package):
    pytest.importorskip(package)
    pytest.importorskip("resource")
    peaks = []
    for rows in (1_000, 10_000):
        line = [sys.executable, "-c", PEAK, kind, str(tmp_path / str(rows)), str(rows)]
        done = subprocess.run(line, capture_output=True, text=True, check=True)
        peaks.append(int(done.stdout) * 1024)
    added = 9_000 * 2_000 * 2 * 8  # bytes of the points that the larger grid has more
    assert peaks[1] - peaks[0] < 0.1 * added


# ---------------------------------------------------------------------------------------------- the command


@pytest.mark.parametrize(("suffix", "package"), [("zarr", "zarr"), ("parquet", "pyarrow")])
def test_the_command_writes_a_grid(tmp_path, suffix, package):
    pytest.importorskip(package)
    out = tmp_path / f"lid.{suffix}"
    result = command("grid", "examples/car_boot.toml", out, "--size", "12x9", "-q", "gaussian, hk_type")
    assert result.code == 0
    assert str(out) in result.err
    assert result.out == ""
    assert out.exists()


def test_the_log_of_a_large_grid_is_short(tmp_path):
    pytest.importorskip("zarr")
    result = command("grid", "examples/car_boot.toml", tmp_path / "lid.zarr", "--size", "4000x200")
    assert result.code == 0, result.err
    assert result.err.count("\n") <= 13


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("lid.csv",), "ending in .zarr or .parquet"),
        (("lid.zarr", "--size", "1x5"), "expected 2 or more"),
        (("lid.zarr", "--size", "many"), "--size: expected two counts"),
        (("lid.zarr", "-q", "gausian"), "did you mean 'gaussian'"),
        (("lid.zarr", "-q", ""), "unknown quantity"),
    ],
)
def test_the_command_tells_a_mistake_in_one_line(tmp_path, arguments, said):
    pytest.importorskip("zarr")
    result = command("grid", "examples/car_boot.toml", tmp_path / arguments[0], *arguments[1:])
    assert result.code == 2
    assert said in result.err
    assert result.err.count("\n") == 1
    assert not list(tmp_path.iterdir())
