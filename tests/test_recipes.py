"""CONTRIBUTING's recipes for a basis and a quantity, followed; tests/test_plugins.py follows the one for a kind."""

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.basis.functions import Functions
from quintrig.geometry.surface import Net
from quintrig.support.arrays import parameter

ROOT = Path(__file__).parents[1]


@dataclass(frozen=True)
class Parabolas(Functions):
    """(1 - t)², 2 t (1 - t) and t², with no more than a family needs."""

    size = 3

    def derivatives(self, t, order):
        t = parameter(t, "t")
        zero = np.zeros_like(t)
        rows = [
            [(1 - t) ** 2, 2 * t * (1 - t), t * t],
            [2 * t - 2, 2 - 4 * t, 2 * t],
            [zero + 2, zero - 4, zero + 2],
            *[[zero] * 3] * order,
        ]
        return np.stack([np.stack(row, axis=-1) for row in rows[: order + 1]])


@dataclass(frozen=True)
class Summing(Parabolas):
    """The same, that say what they sum to."""

    partition = True


@pytest.mark.parametrize("family", [Parabolas(), Summing()], ids=["least", "partition"])
def test_a_basis_needs_its_size_and_its_derivatives(family):
    points = np.random.default_rng(3).normal(size=(3, 3, 3)) + [[[i, j, 0] for j in range(3)] for i in range(3)]
    new = quintrig.Surface(Net(points, family), family)
    old = quintrig.tensor(points, basis="bernstein")
    keys = ("gaussian", "mean", "shape_index", "normal")
    found, expected = (quintrig.analyse(surface, *quintrig.grid(9, 8), keys) for surface in (new, old))
    for key in keys:
        np.testing.assert_allclose(found[key], expected[key], rtol=1e-10, atol=1e-11)
    assert quintrig.integrals(new).area.value == pytest.approx(quintrig.integrals(old).area.value, rel=1e-12)


ROW = """    Quantity(
        "bending",
        "κ1² + κ2²",
        r"\\kappa_1^2+\\kappa_2^2",
        "bending",
        "how strongly it bends, squared",
        _CARMO,
        -2,
        "even",
        "sequential",
    ),
"""
FORMULA = '''

@scalar
def bending(curvedness: float) -> float:
    """Return κ1² + κ2² = 2 C², length⁻²."""
    return 2.0 * curvedness * curvedness
'''
STEPS = {
    "quantities/table.py": [('    *_invariants("", "", _PLANE),\n', ROW + '    *_invariants("", "", _PLANE),\n')],
    "kernel/outputs.py": [
        ('_run("shape_index", "curvedness")', '_run("shape_index", "curvedness", "bending")'),
        ("_S, _CURVED, _A, _B, _C, _R, _CODE = range(PARTIALS, PARTIALS + 11)",
         "_S, _CURVED, _BENT, _A, _B, _C, _R, _CODE = range(PARTIALS, PARTIALS + 12)"),
        ('_OF_FORM = {"gaussian",', '_OF_FORM = {"bending", "gaussian",'),
        ("        if full:\n            du, side =",
         "        s[_BENT * BLOCK + k] = curvature.bending(s[_CURVED * BLOCK + k])\n"
         "        if full:\n            du, side ="),
        ("_write(scratch, _S, 2, n,", "_write(scratch, _S, 3, n,"),
    ],
}  # fmt: skip


@pytest.fixture(scope="module")
def changed(tmp_path_factory):
    """A copy of the source in which a quantity was added as CONTRIBUTING says, and a model."""
    folder = tmp_path_factory.mktemp("source")
    shutil.copytree(ROOT / "src" / "quintrig", folder / "quintrig", ignore=shutil.ignore_patterns("__pycache__"))
    with (folder / "quintrig" / "quantities" / "curvature.py").open("a", encoding="utf-8") as file:
        file.write(FORMULA)
    for name, replacements in STEPS.items():
        path = folder / "quintrig" / name
        text = path.read_text(encoding="utf-8")
        for old, new in replacements:
            assert text.count(old) == 1, old
            text = text.replace(old, new)
        path.write_text(text, encoding="utf-8")
    (folder / "ball.toml").write_text('kind = "sphere"\nradius = 2\nunit = "mm"\n', encoding="utf-8")
    return folder


def _run(folder, *arguments):
    done = subprocess.run(
        [sys.executable, "-m", "quintrig", *arguments],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(folder), "NUMBA_CACHE_DIR": str(folder / "kept"), "MPLBACKEND": "agg"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_quantity_is_a_formula_a_row_and_a_plane(changed):
    assert "κ1² + κ2²" in _run(changed, "table", "--list")
    line = _run(changed, "table", "ball.toml", "--at", "0.3,0.5", "-q", "bending", "-f", "csv").strip().splitlines()[-1]
    assert float(line.split(",")[-1]) == pytest.approx(0.5, rel=1e-14)  # 2/r², r = 2


def test_a_new_quantity_is_drawn(changed):
    _run(changed, "plot", "ball.toml", "-q", "bending", "-o", "ball.png")
    assert (changed / "ball.png").stat().st_size > 5000
