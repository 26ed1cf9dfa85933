"""Compiled code: found again on disk, safe whatever state the folder is in, and true to its definition."""

import ast
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import oracle
import quintrig
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.bspline import normalised
from quintrig.basis.elementary import Circular, Powers
from quintrig.basis.joined import Joined
from quintrig.basis.trigonometric import Trigonometric
from quintrig.kernel.blocks import increment_blocks, pad
from quintrig.support import compiled
from quintrig.support.compiled import BLOCK

SOURCE = Path(quintrig.__file__).parent

WORK = """
import json, sys
import numpy as np
{before}
import quintrig
from quintrig.support import compiled
found, made = compiled._found, compiled._compiled
counts = dict(hits=0, misses=0)
def finding(loop):
    address = found(loop)
    counts["hits"] += address is not None
    return address
def making(loop):
    counts["misses"] += 1
    return made(loop)
compiled._found, compiled._compiled = finding, making
x, y = np.meshgrid(np.linspace(0, 5, 6), np.linspace(0, 5, 6), indexing="ij")
surface = quintrig.tensor(np.stack([x, y, np.sin(x) * np.cos(y)], axis=-1), (0.5, -1, -3, 1))
u, v = quintrig.grid(5, 6)
work = {{
    "grid": lambda: quintrig.analyse(surface, u, v, ("gaussian", "mean")),
    "points": lambda: quintrig.analyse(surface, u.ravel(), v[0, :5], ("gaussian", "mean")),
}}
values = {{key: {{q: work[key]()[q].tolist() for q in ("gaussian", "mean")}} for key in sys.argv[1:]}}
print(json.dumps(dict(
    counts, values=values, folder=str(compiled.cache_folder() or ""), numba="numba" in sys.modules
)))
"""


def start(*work, before="", **environment):
    kept = {k: v for k, v in os.environ.items() if k not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")}
    line = [sys.executable, "-c", WORK.format(before=before), *work]
    return subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=kept | environment)


def outcome(child):
    out, err = child.communicate(timeout=300)
    assert child.returncode == 0, err
    assert err == ""
    return json.loads(out)


def run(*work, **arguments):
    return outcome(start(*work, **arguments))


@pytest.fixture(scope="module")
def filled(tmp_path_factory):
    """A folder filled by one process, and what that process said."""
    folder = tmp_path_factory.mktemp("cache")
    return folder, run("grid", "points", NUMBA_CACHE_DIR=str(folder))


# ---------------------------------------------------------------------------------------------- the folder


def test_a_second_process_compiles_nothing(filled):
    folder, first = filled
    second = run("grid", "points", NUMBA_CACHE_DIR=str(folder))
    assert (first["hits"], first["misses"] > 0) == (0, True)
    assert (second["hits"], second["misses"]) == (4, 0)  # two drivers, K and H, and the basis
    assert second["values"] == first["values"]
    assert (first["numba"], second["numba"]) == (True, False)


def test_processes_that_start_at_once_share_an_empty_folder(filled, tmp_path):
    children = [start("grid", NUMBA_CACHE_DIR=str(tmp_path)) for _ in range(3)]
    for child in children:
        assert outcome(child)["values"]["grid"] == filled[1]["values"]["grid"]
    again = run("grid", "points", NUMBA_CACHE_DIR=str(tmp_path))
    assert again["values"] == filled[1]["values"]


@pytest.mark.parametrize("damage", ["empty", "junk"])
def test_a_damaged_folder_costs_time_and_nothing_else(filled, tmp_path, damage):
    shutil.copytree(filled[0], tmp_path, dirs_exist_ok=True)
    files = [file for file in tmp_path.rglob("*.code") if file.is_file()]
    assert files
    for file in files:
        file.write_bytes(b"" if damage == "empty" else b"\x80junk" * 9)
    assert run("grid", NUMBA_CACHE_DIR=str(tmp_path))["values"]["grid"] == filled[1]["values"]["grid"]


def test_a_full_disk_costs_time_and_nothing_else(filled, tmp_path):
    full = """
import errno
from quintrig.support import machine_code
def full(code):
    raise OSError(errno.ENOSPC, "No space left on device")
machine_code.packed = full
"""
    assert run("grid", before=full, NUMBA_CACHE_DIR=str(tmp_path))["values"]["grid"] == filled[1]["values"]["grid"]


def test_without_any_folder_everything_works(filled, tmp_path):
    (tmp_path / "file").write_text("")
    # A folder below a file cannot be made, not even by root.
    found = run("grid", NUMBA_CACHE_DIR=str(tmp_path / "file" / "below"))
    assert found["folder"] == ""
    assert found["values"]["grid"] == filled[1]["values"]["grid"]


@pytest.mark.parametrize("name", ["NUMBA_CACHE_DIR", "XDG_CACHE_HOME", "HOME"])
def test_the_folder_is_where_the_environment_says_or_none(name, tmp_path, monkeypatch):
    for other in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME"):
        monkeypatch.delenv(other, raising=False)
    monkeypatch.setenv(name, str(tmp_path / "place"))
    folder = compiled.cache_folder()
    assert folder is not None
    assert folder.is_relative_to(tmp_path / "place")
    assert folder.is_dir()
    assert not list(folder.iterdir())
    (tmp_path / "file").write_text("")
    monkeypatch.setenv(name, str(tmp_path / "file" / "below"))
    assert compiled.cache_folder() is None


def test_a_folder_that_cannot_be_written_is_not_used(tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))

    def refuse(*arguments, **keywords):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(compiled.tempfile, "TemporaryFile", refuse)
    assert compiled.cache_folder() is None


def test_a_change_in_any_source_means_another_folder(tmp_path, monkeypatch):
    folders = {compiled.cache_folder()}
    read = Path.read_bytes
    for name in compiled.SOURCES:
        changed = (SOURCE / f"{name}.py").resolve()
        monkeypatch.setattr(
            Path, "read_bytes", lambda self, changed=changed: read(self) + (b"#" if self.resolve() == changed else b"")
        )
        folders.add(compiled.cache_folder())
        monkeypatch.undo()
    assert len(folders) == len(compiled.SOURCES) + 1


# ---------------------------------------------------------------------------------------------- the sources


def imports(path):
    """Return the modules of quintrig that a file names in imports, as paths without the ending."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("quintrig"):
            base = node.module.split(".")[1:]
            found.add("/".join(base))
            found |= {"/".join([*base, alias.name]) for alias in node.names}
    return {name for name in found if name and (SOURCE / f"{name}.py").exists()}


def test_every_module_with_compiled_code_is_among_the_sources():
    modules = {str(file.relative_to(SOURCE).with_suffix("")) for file in SOURCE.rglob("*.py")}
    marks = ("@loop", "@scalar", "@part", "@unrolled")
    using = {name for name in modules if any(f"\n{mark}\n" in (SOURCE / f"{name}.py").read_text() for mark in marks)}
    assert using
    assert using <= set(compiled.SOURCES)
    assert all((SOURCE / f"{name}.py").exists() for name in compiled.SOURCES)


def test_every_module_that_compiled_code_takes_values_from_is_among_the_sources():
    # Modules that only give types, NumPy-level functions or objects handed in at run time stay out.
    harmless = {"support/arrays", "basis/functions", "geometry/surface"}
    for name in set(compiled.SOURCES) - {"quantities/table"}:
        assert imports(SOURCE / f"{name}.py") <= set(compiled.SOURCES) | harmless, name


# ---------------------------------------------------------------------------------------------- the basis

SHAPES = [(0.0, 0.0), (1.0, 1.0), (-4.0, -4.0), (1.0, -4.0), (-4.0 + 1e-9, -4.0 + 1e-13), (-3.999, 0.7), (0.25, -2.5)]
NEAR = np.array([0.0, 1e-300, 1e-150, 1e-12, 1e-7, 1e-3, 0.01, 0.1, 0.3])
PLACES = np.concatenate([NEAR, [0.45, np.nextafter(0.5, 0), 0.5, np.nextafter(0.5, 1), 0.55], 1.0 - NEAR[::-1]])


def unpacked(functions, t):
    """Return the compiled increments as (3, n, terms)."""
    blocks = increment_blocks(functions, t)
    return blocks.transpose(1, 0, 3, 2).reshape(3, -1, functions.terms)[:, : len(t)]


def room(exact, t):
    """Return what a derivative is measured against: itself, the second also the first by the distance to an end."""
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        over = 1.0 / np.maximum(np.minimum(t, 1.0 - t), 1e-305)[:, None]
        second = np.abs(exact[2]) + np.abs(exact[1]) * over
    return np.stack([np.abs(exact[0]), np.abs(exact[1]), second])


@pytest.mark.parametrize("shape", SHAPES)
def test_the_compiled_increments_are_those_of_40_digits(shape):
    functions = Trigonometric(*shape)
    values = [[[sum(f[i:]) for i in range(1, 6)] for f in oracle.trigonometric(t, *shape, order=2)] for t in PLACES]
    exact = np.array(values, dtype=float).transpose(1, 0, 2)
    found = unpacked(functions, PLACES)
    inside = (PLACES > 0.0) & (PLACES < 1.0)
    error, allowed = np.abs(found - exact), 1e-14 * room(exact, PLACES)
    # The oracle works with expanded polynomials: of its 60 digits some are lost.
    assert (error[:, inside] <= allowed[:, inside] + 1e-56).all()
    assert (error[:, ~inside] <= 1e-14 * np.abs(exact[:, ~inside]) + 1e-56).all()


@pytest.mark.parametrize("shape", SHAPES)
def test_the_compiled_increments_are_the_definition(shape):
    t = np.sort(np.concatenate([PLACES, np.random.default_rng(7).random(1000) ** 3]))
    functions = Trigonometric(*shape)
    wanted = functions.increments(t, 2)
    inside = (t > 0.0) & (t < 1.0)
    error, allowed = np.abs(unpacked(functions, t) - wanted), 2e-14 * room(wanted, t)
    assert (error[:, inside] <= allowed[:, inside] + 1e-290).all()


FAMILIES = (
    Trigonometric(0.5, -3.0),
    Bernstein(4),
    normalised([0, 0, 0, 1, 3, 3, 4, 4, 4], 2),
    Powers(-1.0, 2.0, 3),
    Joined((Circular(0.0, 4.0), Trigonometric(1.0, -4.0), Bernstein(2))),
)


@pytest.mark.parametrize("functions", FAMILIES, ids=lambda functions: type(functions).__name__)
def test_origin_and_increments_are_the_sum_over_the_points(functions):
    rng = np.random.default_rng(3)
    points, t = rng.normal(size=(functions.size, 2, 3)), rng.random(50)
    origin, *rest = functions.split(points)
    assert len(rest) == functions.terms
    found = np.tensordot(functions.increments(t, 2), rest, axes=1)
    found[0] += origin
    np.testing.assert_allclose(found, np.tensordot(functions.derivatives(t, 2), points, axes=1), rtol=0, atol=1e-11)


@pytest.mark.parametrize("functions", [f for f in FAMILIES if f.partition], ids=lambda f: type(f).__name__)
def test_increments_do_not_see_where_the_origin_is(functions):
    points = np.random.default_rng(3).integers(-9, 9, (functions.size, 3)).astype(float)
    away = functions.split(points + 2.0**50)
    assert np.array_equal(away[1:], functions.split(points)[1:])


@pytest.mark.parametrize("count", [1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK])
def test_blocks_hold_all_points_and_repeat_the_last(count):
    t = np.linspace(0.1, 0.9, count)
    blocks = pad(t)
    assert blocks.shape == (-(-count // BLOCK), BLOCK)
    assert np.array_equal(blocks.ravel()[:count], t)
    assert (blocks.ravel()[count:] == t[-1]).all()
    for functions in FAMILIES:
        np.testing.assert_allclose(unpacked(functions, t), functions.increments(t, 2), rtol=0, atol=1e-12)
