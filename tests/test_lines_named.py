"""Each kind of lines has a function of its own, which finds what ``quintrig.lines`` finds, and knows its options."""

import numpy as np
import pytest

import quintrig

FUNCTIONS = {
    "curvature_lines": ("curvature", {"start": (0.3, 0.4)}),
    "asymptotic_lines": ("asymptotic", {"start": (0.3, 0.4)}),
    "parabolic_lines": ("parabolic", {}),
    "ridges": ("ridges", {"family": 1}),
    "isophotes": ("isophotes", {"angles": [20.0]}),
    "reflection_lines": ("reflection", {"count": 2}),
    "silhouettes": ("silhouette", {"direction": (1, 0, 0)}),
    "section": ("section", {"normal": (1, 0, 0)}),
    "geodesic": ("geodesic", {"start": (0.3, 0.4), "direction": 30.0, "length": 0.2}),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_kind_by_its_own_name(name):
    kind, options = FUNCTIONS[name]
    saddle = quintrig.hyperbolic_paraboloid(1)
    own, all_of_it = getattr(quintrig, name)(saddle, **options), quintrig.lines(saddle, kind, **options)
    assert own.kind == all_of_it.kind == kind
    assert len(own) == len(all_of_it)
    for one, other in zip(own, all_of_it, strict=True):
        np.testing.assert_array_equal(one.points, other.points)
    with pytest.raises(ValueError, match="levels: "):
        getattr(quintrig, name)(saddle, levels=[1.0])
