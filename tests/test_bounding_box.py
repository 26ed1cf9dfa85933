"""The box around a surface is that of closed forms, not of the points at which it is first looked at."""

from dataclasses import replace

import numpy as np
import pytest

import quintrig
from quintrig.analysis.summary import summarise

EXPECTED = {
    "cylinder": (quintrig.cylinder(10.0, 30.0), (20.0, 20.0, 30.0)),
    "torus": (quintrig.torus(10.0, 3.0), (26.0, 26.0, 6.0)),
    "sphere": (quintrig.sphere(2.0), (4.0, 4.0, 4.0)),
    "ellipsoid": (quintrig.ellipsoid(1.0, 2.0, 3.0), (2.0, 4.0, 6.0)),
}


@pytest.mark.parametrize("name", EXPECTED)
@pytest.mark.parametrize("samples", [17, 50, 65])
def test_closed_forms_have_their_size(name, samples):
    surface, size = EXPECTED[name]
    np.testing.assert_allclose(np.ptp(summarise(surface, samples=samples).box, axis=0), size, rtol=2e-6)


def test_a_trimmed_face_has_the_size_of_its_loops_and_of_what_they_hold():
    turn = np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    disc = 0.5 + 0.25 * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    x, y = np.meshgrid(np.linspace(-1, 1, 6), np.linspace(-1, 1, 6), indexing="ij")
    dome = quintrig.tensor(np.stack([x, y, 1.0 - x * x - y * y], axis=-1), basis="bernstein")
    face = replace(dome, trim=(disc,))
    box = summarise(face).box
    np.testing.assert_allclose(np.ptp(box, axis=0)[:2], 1.0, rtol=1e-4)
    assert box[1, 2] == pytest.approx(float(dome(0.5, 0.5)[2]), rel=1e-9)
