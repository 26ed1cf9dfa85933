"""Surfaces that Python builds for the browser: the numbers that Node works out from them are Python's own."""

from dataclasses import dataclass

import numpy as np
import pytest

import quintrig
from node import asked
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.elementary import Powers
from quintrig.basis.functions import Functions
from quintrig.basis.library import LIBRARY
from quintrig.basis.registry import family
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.registry import OWN
from quintrig.model.model import Model
from quintrig.studio.built import FAMILIES, functions, surface
from quintrig.studio.data import table

SCRIPT = """
import { readFileSync } from "node:fs";
const studio = await import(process.argv[1]);
const jobs = JSON.parse(readFileSync(0, "utf8"));
const toy = { title: "Toy", construction: false, shapeNames: [], fields: { n: { type: "raw" } } };
studio.install({ kinds: { toy } });
const answers = jobs.map(({ built, u, v }, n) => {
  const model = studio.fromDict({ kind: "toy", n, built: [{ keys: { kind: "toy", n }, surface: built }] });
  const sample = studio.analyse(studio.build(model.patches[0]), u, v);
  const numbers = (a) => Array.from(a, (x) => (Number.isFinite(x) ? x : null));
  return Object.fromEntries(Object.entries(sample).map(([k, a]) => [k, numbers(a)]));
});
const names = [studio.FAMILIES, studio.LIBRARY, studio.BUILDERS].map((table) => Object.keys(table));
process.stdout.write(JSON.stringify({ answers, names }));
"""


@dataclass(frozen=True)
class Waves(Functions):
    """1, e^t and cos 9t: a family that no page knows."""

    size: int = 3

    def derivatives(self, t, order):
        """Return derivatives 0 to ``order``."""
        t = np.asarray(t, dtype=float)
        zero = np.zeros_like(t)
        return np.stack(
            [
                np.stack([zero if k else zero + 1, np.exp(t), 9.0**k * np.cos(9 * t + k * np.pi / 2)], axis=-1)
                for k in range(order + 1)
            ]
        )


@dataclass(frozen=True)
class Kinked(Waves):
    """The same with a corner in the middle, which it does not tell of."""

    def derivatives(self, t, order):
        """Return derivatives 0 to ``order``."""
        return super().derivatives(np.abs(np.asarray(t, dtype=float) - 0.4), order)


class Twisted:
    """Rows that share no functions: a helix and its axis."""

    size, dimension = 2, 3

    def derivatives(self, u, order):
        """Return derivatives 0 to ``order``."""
        u = np.asarray(u, dtype=float)
        turn = [np.cos(5 * u + k * np.pi / 2) * 5.0**k for k in range(order + 1)]
        side = [np.sin(5 * u + k * np.pi / 2) * 5.0**k for k in range(order + 1)]
        rise = [u, np.ones_like(u), *[np.zeros_like(u)] * order][: order + 1]
        zero = np.zeros_like(u)
        return np.stack(
            [
                np.stack([np.stack([turn[k], side[k], rise[k]], -1), np.stack([zero, zero, rise[k]], -1)], -2)
                for k in range(order + 1)
            ]
        )


WAVES = np.array(
    [[[0, 0, 0], [3, 0, 1], [0, 1, 1]], [[0, 2, 0], [1, 3, 1], [2, 2, 2]], [[0, 0, 1], [1, 1, 0], [0, 3, 0]]]
)
NET = np.random.default_rng(3).uniform(-5, 5, (6, 6, 3))


SURFACES = {
    "numbers of NumPy's types": Surface(Net(WAVES.astype(float), Powers(np.float32(0), np.int64(2), 2)), Bernstein(2)),
    "unknown family both ways": Surface(Net(WAVES.astype(float), Waves()), Waves()),
    "unknown family, flipped, far out": Surface(
        Net(WAVES.astype(float), Waves()), Powers(0.0, 2.0, 2), flip=True, origin=np.array([1e6, 0, -1e6])
    ),
    "rows of their own": Surface(Twisted(), Bernstein(1)),
    "standing still": quintrig.tensor(NET, (-4, -4, -4, -4)),
    "formulas": Surface(Net(NET[:4], family("c_bezier", 4)), family("generalised_trigonometric", 6, (0.3, -0.8))),
    "still in rows alone": Surface(Net(NET, Trigonometric(-4, 0)), Bernstein(5)),
}
SURFACES |= {name: Model.from_dict({"kind": name, **form.starter}).surface for name, form in OWN.items()}
PARAMETERS = np.linspace(0.0, 1.0, 7)


@pytest.fixture(scope="module")
def told():
    jobs = [{"built": surface(one), "u": PARAMETERS.tolist(), "v": PARAMETERS.tolist()} for one in SURFACES.values()]
    return asked(SCRIPT, jobs)


@pytest.mark.parametrize("name", SURFACES)
def test_the_page_works_out_pythons_numbers(told, name):
    here = SURFACES[name]
    there = told["answers"][list(SURFACES).index(name)]
    keys = ("point", "normal", "gaussian", "mean", "curvedness", "E", "L")
    ours = quintrig.analyse(here, PARAMETERS[:, None], PARAMETERS[None, :], keys)
    bend = np.nanmax(ours["curvedness"])
    for key in keys:
        own = np.asarray(ours[key], dtype=float).ravel()
        theirs = np.array([np.nan if x is None else x for x in there[key]])
        assert np.array_equal(np.isnan(own), np.isnan(theirs)), key
        scales = {
            "gaussian": bend**2,
            "mean": bend,
            "curvedness": bend,
            "normal": 1.0,
            "L": bend * np.nanmax(ours["E"]),
        }
        assert np.nanmax(np.abs(own - theirs), initial=0.0) <= 1e-9 * scales.get(key, np.nanmax(np.abs(own))), key


def test_both_sides_know_the_same_families_bases_and_kinds(told):
    families, bases, kinds = told["names"]
    assert set(families) == {*FAMILIES.values(), "chebyshev"} == set(table()["families"])
    assert set(bases) == {one.name for one in LIBRARY}
    assert set(kinds) == set(OWN) == set(table()["kinds"]) - {"curve"}


def test_series_are_small():
    """An analytic family takes one piece of degree 24, and little more where it waves."""
    assert len(functions(Waves())["series"]) <= 2


@pytest.mark.parametrize(("rows", "said"), [(Kinked(), "not smooth"), (Powers(0.0, 1e200, 2), None)])
def test_what_a_page_cannot_draw_is_said(rows, said):
    if said is None:
        assert functions(rows)["family"] == "powers"  # known ones go over by name, whatever they hold
    else:
        with pytest.raises(ValueError, match=said):
            functions(rows)
