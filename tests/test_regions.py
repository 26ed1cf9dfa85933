"""Maps of claims: rectangles that cover the domain, each of which says only what is true of all its points."""

import numpy as np
import pytest

import quintrig
from quintrig.enclosures.prove import Prover
from quintrig.enclosures.regions import regions
from studio_server import Running


@pytest.mark.parametrize(
    ("surface", "claim", "key", "bound", "above"),
    [
        (quintrig.load("examples/wavy.toml").surface, "gaussian > 0", "gaussian", 0.0, True),
        (quintrig.load("examples/wavy.toml").surface, "k1 <= 0.1", "k1", 0.1, False),
        (quintrig.torus(3.0, 1.0), "convex", "gaussian", 0.0, True),
    ],
)
def test_rectangles_cover_the_domain_and_say_what_is_true(surface, claim, key, bound, above):
    found = regions(Prover(surface), claim)
    low, high = found.rectangles[:, :2], found.rectangles[:, 2:]
    assert np.prod(high - low, axis=1).sum() == pytest.approx(1.0, rel=1e-9)
    assert {"proved", "refuted"} <= set(found.states)
    assert found.share("open") < 0.1
    u, v = np.random.default_rng(6).random((2, 400))
    value = quintrig.analyse(surface, u, v, (key,))[key]
    states = np.array(found.states)
    for x, y, one in zip(u, v, value, strict=True):
        inside = ((low <= (x, y)) & ((x, y) <= high)).all(axis=1)
        said = set(states[inside]) - {"open"}
        assert said <= {"proved" if bool(one > bound) == above else "refuted"}


def test_a_map_is_of_what_is_inside_the_loops():
    x = np.linspace(-1.0, 1.0, 4)
    net = [[(x[i], x[j], x[i] ** 2 - x[j] ** 2) for j in range(4)] for i in range(4)]
    face = quintrig.geometry.nurbs.nurbs(net, trim=[[(0.25, 0.25), (0.75, 0.25), (0.75, 0.75), (0.25, 0.75)]])
    found = regions(Prover(face), "gaussian < 0")
    assert (found.rectangles[:, 2:] > 0.25).all()
    assert (found.rectangles[:, :2] < 0.75).all()


@pytest.mark.parametrize("claim", ["inside hull", "gaussian"])
def test_what_is_said_of_the_whole_surface_has_no_map(claim):
    with pytest.raises(ValueError, match="only a verdict on the whole"):
        regions(Prover(quintrig.sphere()), claim)


def test_the_studio_is_told_verdict_and_maps(tmp_path):
    (tmp_path / "tent.toml").write_text("")
    served = Running(tmp_path)
    try:
        text = '[[patch]]\nkind = "torus"\n\n[[patch]]\nkind = "catenoid"\n'
        status, told = served.json("POST", "/api/prove", {"text": text, "claim": "gaussian >= 0"})
        assert status == 200
        assert told["verdict"] == "refuted"
        assert [len(one["rectangles"]) > 8 for one in told["maps"]] == [True, False]
        assert any("can only be sampled" in note for note in told["notes"])
        status, told = served.json("POST", "/api/prove", {"text": text, "claim": "regular"})
        assert told["verdict"] == "undecided"  # the torus is, but nobody knows of the catenoid
        status, told = served.json("POST", "/api/prove", {"text": text, "claim": "gausian >= 0"})
        assert status == 422
        assert "did you mean 'gaussian'" in told["error"]
    finally:
        served.stop()
