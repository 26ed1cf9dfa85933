"""Models with extreme numbers: the right numbers or one line, no runtime warning, in bounded time."""

import json
import math
import tomllib
import warnings

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as command
from quintrig.analysis.integrate import integrals
from quintrig.analysis.quadrature import MOST_NODES
from quintrig.analysis.summary import summarise
from quintrig.basis.bspline import CLOSEST, normalised
from quintrig.geometry.nurbs import LARGEST_RATIO
from quintrig.geometry.surface import LARGEST_SIZE, SMALLEST_SIZE
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import Model
from quintrig.model.starter import starter
from quintrig.model.toml import to_toml
from quintrig.support.errors import ModelError

LENGTHS = ("points", "section", "trajectory", "profile", "first", "second")
NOT_LENGTHS = ("name", "flip", "kind")
GRAPHS = ("hyperbolic_paraboloid", "monkey_saddle", "enneper")  # their shape changes with the size


@pytest.fixture(autouse=True)
def no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        yield


def keys(kind):
    return tomllib.loads(starter(kind))


def times(value, factor):
    return [times(x, factor) for x in value] if isinstance(value, list) else float(value) * factor


def scaled(kind, factor):
    """The starter model of a kind with all its lengths multiplied."""
    data = keys(kind)
    if kind == "developable":
        for name in ("planes", "bounds"):
            data[name] = [[a, b, c, d * factor] for a, b, c, d in data[name]]
    elif any(name in data for name in LENGTHS):
        lengths = ("profile",) if kind == "swung" else LENGTHS
        data |= {name: times(data[name], factor) for name in lengths if name in data}
        if kind == "symmetric":
            data["mirror"][3] *= factor
        if kind == "swung":  # of which the trajectory is a pure number
            data["scale"] = 1
    else:
        form = kinds()[kind].model_fields
        data |= {name: times(data.get(name, form[name].default), factor) for name in form if name not in NOT_LENGTHS}
    return data


def nurbs(**changed):
    return keys("nurbs") | changed


def weighted(place, weight):
    weights = [[1.0] * 3 for _ in range(3)]
    weights[place[0]][place[1]] = weight
    return nurbs(weights=weights)


def unchecked(*shape):
    return keys("tensor") | {"shape": list(shape), "unchecked_shape": True}


REFUSED = {
    "a weight near zero": (weighted((2, 0), 1e-50), "weights[2][0]: expected weights within a factor of 1,000,000"),
    "a weight of 1e12": (weighted((2, 1), 1e12), "found 1 beside weights[2][1] = 1e+12"),
    "a weight of 1e16": (weighted((2, 1), 1e16), "weights[0][0]: expected weights within"),
    "knots together": (
        nurbs(degrees=[1, 2], knots=[[0, 0, 1e-320, 1, 1], [0, 0, 0, 1, 1, 1]]),
        "knots[0][2]: expected neighbouring knots that are equal or at least 1e-14 of the domain apart",
    ),
    "shape parameters that overflow": (unchecked(-100, 1e49, 1e49, 1e49), "size: expected a surface from 1e-30 to"),
    "points far apart": (scaled("ruled", 1e47), "size: expected a surface from 1e-30 to 1e+30 across"),
    "a catenoid of waist 0.001": ({"kind": "catenoid", "waist": 0.001, "height": 2}, "points that are not finite"),
    "a catenoid of waist 0.01": ({"kind": "catenoid", "waist": 0.01, "height": 2}, "size: expected a surface"),
    "a bounding plane far away": (
        keys("developable") | {"bounds": [[0, 1, 0, 0], [0, 1e-200, 0, -10]]},
        "size: expected a surface from 1e-30 to 1e+30 across, or a single point, found ",
    ),
    "a tiny net": (scaled("tensor", 1e-300), "size: expected a surface from 1e-30"),
    "a sphere of 1e40": ({"kind": "sphere", "radius": 1e40}, "size: expected a surface"),
}


@pytest.mark.parametrize(("data", "told"), REFUSED.values(), ids=REFUSED)
@pytest.mark.parametrize("name", ["check", "table", "report", "compare", "export", "sweep"])
def test_what_cannot_be_computed_is_refused_in_one_line_by_every_command(tmp_path, data, told, name):
    file = tmp_path / "m.json"
    file.write_text(json.dumps(data))
    rest = {
        "report": [tmp_path / "out"],
        "compare": [tmp_path / "out", "--shape", "0,0,0,0"],
        "export": [tmp_path / "m.stl"],
        "sweep": ["--vary", "alpha1=0:1:2", "-o", tmp_path / "out"],
    }
    found = command(name, file, *rest.get(name, []))
    assert (found.code, found.out, found.err.count("\n")) == (2, "", 1)
    assert told in found.err or name == "compare"
    assert "fault" not in found.err


@pytest.mark.parametrize("kind", [kind for kind in kinds() if kind not in GRAPHS])
@pytest.mark.parametrize("exponent", [-90, -60, 60, 88])
def test_curvature_scales_with_the_size_up_to_the_limits(kind, exponent):
    usual, other = (Model.from_dict(scaled(kind, 2.0**x)).surface for x in (0, exponent))
    t = np.linspace(0.0, 1.0, 9)
    a, b = (quintrig.analyse(s, t[:, None], t, ("gaussian", "mean", "point_type")) for s in (usual, other))
    back = 2.0**exponent
    for key, power in (("gaussian", 2), ("mean", 1)):
        size = np.nanmax(np.abs(a[key])) or 1.0
        np.testing.assert_allclose(b[key] * back**power / size, a[key] / size, atol=1e-9)
    found = integrals(other, 1e-6, 4)
    known = integrals(usual, 1e-6, 4)
    assert found.area.value / back**2 == pytest.approx(known.area.value, rel=1e-9)
    summarise(other)


@pytest.mark.parametrize("kind", kinds())
@pytest.mark.parametrize("factor", [1e-300, 1e-45, 1e-29, 1e-8, 1e8, 1e29, 1e45, 1e300])
def test_a_model_of_any_scale_is_summarised_or_refused(kind, factor):
    try:
        model = Model.from_dict(scaled(kind, factor))
    except ModelError:
        assert not 1e-25 < factor < 1e25
        return
    found = summarise(model.surface)
    assert SMALLEST_SIZE <= found.size <= LARGEST_SIZE
    assert math.isfinite(found.integrals.area.value)
    assert np.isfinite(found.box).all()


@pytest.mark.parametrize("kind", ["tensor", "symmetric", "swept", "swung", "ruled", "nurbs"])
def test_coinciding_points_are_a_single_point_in_every_number(kind):
    data = keys(kind)
    data |= {name: times(data[name], 0.0) for name in LENGTHS if name in data}
    if kind == "symmetric":
        data["mirror"] = [1, 0, 0, 0]
    found = summarise(Model.from_dict(data).surface)
    assert found.size == 0.0
    assert np.ptp(found.box, axis=0).max() == 0.0
    assert found.warnings[0] == "The whole surface is a single point."


@pytest.mark.parametrize("place", [(0, 0), (0, 1), (1, 1), (2, 1)])
@pytest.mark.parametrize("weight", [1e-6, 1e-4, 1e4, 1e6])
def test_size_and_words_agree_at_the_largest_ratio_of_weights(place, weight):
    """The surface is squeezed towards a point, or almost cut off there, but its box keeps its size."""
    found = summarise(Model.from_dict(weighted(place, weight)).surface)
    assert found.size >= 140.0
    np.testing.assert_allclose(np.ptp(found.box, axis=0)[:2], 100.0)
    assert not any("single point" in line for line in found.warnings)
    assert found.integrals.points <= MOST_NODES


def test_a_common_factor_of_the_weights_changes_nothing():
    t = np.linspace(0.0, 1.0, 7)
    net = keys("nurbs")
    surfaces = [Model.from_dict(net | {"weights": times(net["weights"], 2.0**x)}).surface for x in (0, 160, -160)]
    for other in surfaces[1:]:
        assert np.array_equal(surfaces[0](t[:, None], t), other(t[:, None], t))


def test_the_limits_themselves_are_allowed():
    assert Model.from_dict(weighted((1, 1), LARGEST_RATIO)).surface.size > 0.0
    with pytest.raises(ModelError, match="within a factor"):
        Model.from_dict(weighted((1, 1), 1.01 * LARGEST_RATIO))
    assert len(normalised([0, 0, 2 * CLOSEST, 1, 1], 1).breaks) == 3
    with pytest.raises(ValueError, match="apart"):
        normalised([0, 0, 0.5 * CLOSEST, 1, 1], 1)


def test_the_nodes_of_an_integral_are_bounded_however_thin_the_layers():
    """An edge that nearly stands still, at ``-4`` and a hair more: its layer is far thinner than any panel."""
    for shape in ((-3.9999999999, 0.0, 0.0, 0.0), (-3.9999999999,) * 4):
        found = summarise(quintrig.tensor(np.array(keys("tensor")["points"], dtype=float), shape))
        assert 0 < found.integrals.points <= MOST_NODES


def test_what_is_not_resolved_is_said():
    """An edge that nearly stands still, whose layer is far thinner than the nodes that are affordable can follow."""
    points = np.array(keys("tensor")["points"], dtype=float)
    points[1] = points[0] + 1e-9 * (points[1] - points[0])
    found = summarise(quintrig.tensor(points, (-3.9999999, 0.0, 0.0, 0.0)))
    assert found.integrals.points <= MOST_NODES
    energy = found.integrals.bending_energy
    assert energy.converged or any("bending energy" in line for line in found.warnings)


def test_a_cap_to_a_point_is_read_and_a_knot_too_many_told(tmp_path):
    half = [[10, 0], [10, 10], [0, 10], [-10, 10], [-10, 0]]
    net = [[[x, y, 0] for x, y in half], [[0.6 * x, 0.6 * y, 5] for x, y in half], [[0, 0, 8]] * 5]
    data = {"kind": "nurbs", "degrees": [2, 2], "points": net}
    data["knots"] = [[0, 0, 0, 1, 1, 1], [0, 0, 0, 0.5, 0.5, 1, 1, 1]]
    model = Model.from_dict(data)
    (tmp_path / "cap.toml").write_text(to_toml(model.to_dict()))
    found = command("check", tmp_path / "cap.toml")
    assert (found.code, found.err) == (0, "")
    assert "The edge u = 1 is a single point" in " ".join(found.out.split())
    data["knots"][0].insert(0, 0)
    with pytest.raises(ModelError, match=r"knots\[0\]: "):
        Model.from_dict(data)
