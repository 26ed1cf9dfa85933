"""Fits: known surfaces with known noise, closed forms wherever they lie, joins, constraints; and the command line."""

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cli_runner
import quintrig
from quintrig.basis.formulas import Parameter
from quintrig.model.starter import starter
from quintrig.shaping.fitting.intervals import CHI, accepted, profile, told
from quintrig.support.parsing import parse

RUN = cli_runner.quintrig
TURN = Rotation.from_rotvec([0.4, 0.7, -0.2]).as_matrix()


def wavy(shape=(0.5, -1.0, -2.0, 0.3)):
    rng = np.random.default_rng(7)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    net = np.stack([x, y, 0.8 * np.sin(x) * np.cos(y)], axis=-1) + 0.15 * rng.normal(size=(6, 6, 3))
    return quintrig.tensor(net, shape)


def measured(surface, count, noise, seed=1):
    rng = np.random.default_rng(seed)
    return surface(*rng.random((2, count))) + noise * rng.normal(size=(count, 3))


def from_truth(surface, fit):
    """The rms distance of the true surface, its rim aside, from the fitted one."""
    t = np.linspace(0.03, 0.97, 25)
    return quintrig.deviation(fit.model, surface(t[:, None], t[None, :]).reshape(-1, 3)).rms


@pytest.mark.parametrize(
    ("kind", "limit"), [("tensor", 16), ("symmetric", 12), ("swept", 12), ("swung", 12), ("ruled", 12)]
)
def test_known_surfaces_with_known_noise(kind, limit):
    model = quintrig.Model.from_dict(parse(starter(kind), ".toml"))
    noise, count = 1e-3 * model.surface.size, 1200
    fit = quintrig.fit(measured(model.surface, count, noise), kind)
    assert noise / 1.3 < fit.rms < 1.3 * noise
    assert from_truth(model.surface, fit) < limit * noise / np.sqrt(count)  # √unknowns is 6 to 10
    assert fit.model.patch().kind == kind
    assert fit.points == count


def test_small_noise_is_reached_too():
    model = quintrig.Model.from_dict(parse(starter("swept"), ".toml"))
    noise = 3e-6 * model.surface.size
    fit = quintrig.fit(measured(model.surface, 600, noise), "swept", shape=model.patch().shape)
    assert fit.rms < 1.3 * noise


def test_shape_parameters_are_fitted_with_their_intervals():
    surface = wavy()
    fit = quintrig.fit(measured(surface, 600, 1e-4 * surface.size), shape="free")
    assert fit.rms < 1.3e-4 * surface.size
    assert [one.name for one in fit.shape] == ["alpha1", "zeta1", "alpha2", "zeta2"]
    assert all(-4 <= one.low <= one.value <= one.high <= 1 and one.deviation > 0 for one in fit.shape)
    assert fit.model.patch().shape == tuple(one.value for one in fit.shape)
    # Points of this noise do not tell a parameter from what the net can do; what they leave holds the truth.
    for one, truth in zip(fit.shape, (0.5, -1.0, -2.0, 0.3), strict=True):
        assert any(low <= truth <= high for low, high in one.intervals)
    assert not all(one.determined for one in fit.shape)
    assert fit.to_dict()["shape"][0]["intervals95"] == [list(span) for span in fit.shape[0].intervals]
    assert any("poorly determined" in note for note in fit.notes)
    fixed = quintrig.fit(measured(surface, 300, 1e-3 * surface.size), shape=(0.5, -1.0, -2.0, 0.3))
    assert (fixed.model.patch().shape, fixed.shape) == ((0.5, -1.0, -2.0, 0.3), ())


def test_intervals_of_a_profile_with_two_valleys():
    """The sum of squares (x² - 1)² k grows by 3.84 at four places: two intervals; between far values roots are met."""
    one = Parameter("alpha", -4.0, 1.5)
    values, grown, _ = profile(one, -1.0, 0.05, lambda x, near: (400 * (x * x - 1) ** 2, near), None)
    assert grown[values == -1.0] == 0
    fine = np.linspace(-2, 2, 4001)
    spans = accepted(fine, 400 * (fine**2 - 1) ** 2)
    ends = np.sqrt([1 - np.sqrt(CHI / 400), 1 + np.sqrt(CHI / 400)])
    np.testing.assert_allclose(spans, [[-ends[1], -ends[0]], [ends[0], ends[1]]], atol=1e-5)
    said = told("alpha", one, -1.0, 0.05, fine, 400 * (fine**2 - 1) ** 2, 0.0)
    assert said.determined
    assert said.describe().count(" or from ") == 1
    assert not told("alpha", one, 0.0, 1.0, fine, 0 * fine, 0.0).determined


def test_other_bases():
    surface = wavy()
    for basis, size in (("bernstein", (5, 7)), (["cubic", "quintic"], None)):
        fit = quintrig.fit(measured(surface, 800, 1e-3 * surface.size), basis=basis, size=size)
        assert fit.rms < 3e-2 * surface.size
        assert fit.model.patch().definition.basis == basis


def test_outliers_and_weights():
    surface = wavy()
    points = measured(surface, 1500, 1e-3 * surface.size)
    points[:40] += np.random.default_rng(3).normal(size=(40, 3)) * surface.size / 4
    fit = quintrig.fit(points)
    assert 20 <= fit.outliers <= 45
    assert fit.rms < 1.3e-3 * surface.size
    assert from_truth(surface, fit) < 20e-3 * surface.size / np.sqrt(1500)
    weights = np.r_[np.zeros(40), np.ones(1460)]
    other = quintrig.fit(points, weights=weights, robust=False)
    assert from_truth(surface, other) < 20e-3 * surface.size / np.sqrt(1500)


def test_patches_join_as_asked_and_a_tolerance_takes_as_many_as_it_needs():
    t = np.linspace(0, 1, 20)
    x, y = (10 * a.ravel() for a in np.meshgrid(t, t))
    points = np.stack([x, y, np.sin(1.3 * x) * np.cos(1.1 * y)], axis=-1)
    fits = {join: quintrig.fit(points, patches=(2, 2), join=join) for join in ("G1", "G2")}
    for join, fit in fits.items():
        assert len(fit.model.patches) == 4
        seams = fit.model.joins(preset="class-a")
        assert len(seams) == 4
        assert all(seam.order >= join for seam in seams)
    one = quintrig.fit(points)
    assert fits["G1"].rms < 0.3 * one.rms
    within = quintrig.fit(points, tolerance=0.5 * one.max)
    assert within.within_tolerance
    assert len(within.model.patches) > 1


@pytest.mark.parametrize("moved", [False, True], ids=["in its frame", "anywhere"])
@pytest.mark.parametrize("kind", ["plane", "sphere", "cylinder", "cone", "torus"])
def test_closed_forms_are_recovered(kind, moved):
    sizes = {
        "sphere": {"radius": 20},
        "cylinder": {"radius": 10, "height": 40},
        "cone": {"radius": 12, "height": 60},
        "torus": {"major": 30, "minor": 8},
        "plane": {},
    }[kind]
    rng = np.random.default_rng(4)
    u, v = rng.random((2, 800))
    if kind == "plane":
        points = np.stack([50 * u, 30 * v, 0 * u], axis=-1)
    else:
        points = quintrig.Model.from_dict({"kind": kind, **sizes}).surface(0.7 * u, v)
    points = points + 0.01 * rng.normal(size=points.shape)
    points = points @ TURN.T + [100, -20, 5] if moved else points
    fit = quintrig.fit(points, kind)
    assert 0.009 < fit.rms < 0.011
    form = fit.to_dict()["form"]
    if kind == "plane":
        assert np.abs(form["normal"] @ (TURN if moved else np.eye(3))[:, 2]) == pytest.approx(1, abs=1e-6)
        return
    if not moved:
        assert fit.model.patch().kind == kind
    for name, size in sizes.items():
        if name != "height" and (kind, moved) != ("cone", True):  # of a cone elsewhere, the sizes reach as the points
            assert form[name] == pytest.approx(size, abs=0.02)
    if kind == "cone":
        assert form["half_angle_degrees"] == pytest.approx(np.degrees(np.arctan(0.2)), abs=0.02)
    if moved and kind != "sphere":
        assert np.abs(TURN[:, 2] @ form["axis"]) == pytest.approx(1, abs=1e-5)
    # The model stands for the form where the points are, with its normal outwards.
    assert np.abs(quintrig.deviation(fit.model, points).rms - fit.rms) < 1e-9


def edges_of(surface):
    t = np.linspace(0, 1, 60)
    matrix = quintrig.Curve(np.zeros((12, 3)), basis="bernstein").functions.derivatives(t, 0)[0]
    rims = [surface(0 * t, t), surface(0 * t + 1, t), surface(t, 0 * t), surface(t, 0 * t + 1)]
    return [quintrig.Curve(np.linalg.lstsq(matrix, rim, rcond=None)[0], basis="bernstein") for rim in rims]


@pytest.mark.parametrize(
    ("sides", "patches"), [("curves", None), (4, None), (slice(0, 2), None), (slice(1, 3), None), (4, (2, 2))]
)
def test_edges_follow_the_border_or_are_held_to_curves(sides, patches):
    """A random cloud has no border but its outermost points, and noise; edges do not make the fit worse."""
    surface = wavy((0, 0, 0, 0))
    noise, count = 1e-3 * surface.size, 700
    edges = edges_of(surface)
    given = sides if sides == "curves" else edges[:sides] if isinstance(sides, int) else edges[sides]
    fit = quintrig.fit(measured(surface, count, noise), boundary=given, patches=patches)
    assert fit.rms < 1.1 * noise
    assert fit.outliers <= 1
    assert from_truth(surface, fit) < 20 * noise / np.sqrt(count)
    if sides != "curves":
        rim = np.concatenate([side(np.linspace(0, 1, 30)) for side in given])
        assert quintrig.deviation(fit.model, rim).rms < 0.2 * noise


@pytest.mark.parametrize(
    ("kind", "patches"), [("tensor", (1, 1)), ("tensor", (2, 1)), ("symmetric", (1, 1)), ("swept", (1, 1))]
)
def test_corners_are_passed_through(kind, patches):
    surface = quintrig.Model.from_dict(parse(starter(kind), ".toml")).surface
    noise = 1e-4 * surface.size
    # turned by a quarter, so that no first guess has them by luck
    corners = np.array([surface(*at) for at in ((1, 0), (1, 1), (0, 1), (0, 0))])
    if kind == "symmetric":  # whose u runs across the mirror
        corners = np.roll(corners, -1, axis=0)
    asked = {"patches": patches} if patches != (1, 1) else {}
    fit = quintrig.fit(measured(surface, 400, noise), kind, corners=corners, **asked)
    parts = [one.surface for one in fit.model.patches]
    nu, nv = patches
    ends = [parts[0](0, 0), parts[(nu - 1) * nv](1, 0), parts[-1](1, 1), parts[nv - 1](0, 1)]
    np.testing.assert_allclose(ends, corners, rtol=0, atol=1e-9 * surface.size)
    assert fit.rms < 1.5 * noise


def test_corners_that_a_kind_cannot_have_are_refused(tmp_path):
    points = measured(wavy(), 200, 0.0)
    with pytest.raises(ValueError, match="corners: a swept surface cannot pass through these, which are no paral"):
        quintrig.fit(points, "swept", corners=[[0, 0, 0], [5, 0, 0], [5, 5, 1], [0, 5, 0]])
    with pytest.raises(ValueError, match="corners: belong to tensor, symmetric, swept, ruled, found kind sphere"):
        quintrig.fit(points, "sphere", corners=np.zeros((4, 3)))
    np.savetxt(tmp_path / "p.xyz", points)
    told = RUN("fit", tmp_path / "p.xyz", "--corners", "0,0,0 1,0,0 1,1,0")
    assert (told.code, told.err.count("\n")) == (2, 1)
    assert "--corners: expected four points" in told.err


def test_a_cad_face_becomes_a_patch(tmp_path):
    model = quintrig.Model.from_dict(parse(starter("swept"), ".toml"))
    quintrig.export(model, tmp_path / "part.step")
    done = RUN("fit", tmp_path / "part.step", "--face", 1, "--tolerance", 0.01, "-o", tmp_path / "m.toml", "--json")
    assert done.code == 0, done.err
    told = json.loads(done.out)
    assert told["within_tolerance"]
    assert told["max"] <= 0.01
    assert told["unit"] == "mm"
    # At other points of the face it is as near; what is left is 1e-9 of its size, and no noise that would be even.
    assert quintrig.deviation(quintrig.load(tmp_path / "m.toml"), model).rms < 2 * told["rms"]


@pytest.mark.parametrize("dimension", [2, 3])
def test_curves(dimension):
    points = np.array([[0, 0, 0], [1, 2, 0], [3, 2.5, 0], [4, -1, -1], [6, 0, 0], [7, 2, 1.0]])[:, :dimension]
    curve = quintrig.Curve(points)
    noise = 7e-3
    rng = np.random.default_rng(2)
    t = np.sort(rng.random(400))
    scan = curve(t) + noise * rng.normal(size=(400, dimension))
    fit = quintrig.fit(scan, "curve")
    assert fit.rms < 1.3 * noise * np.sqrt(dimension - 1)
    found = fit.model.curve().curve
    s = np.linspace(0.02, 0.98, 40)
    away = [found.closest(p).distance for p in curve(s)]
    assert np.sqrt(np.mean(np.square(away))) < 8 * noise / np.sqrt(400)


@pytest.mark.parametrize("layout", ["selig", "lednicer"])
def test_aerofoils(layout, tmp_path):
    """NACA 0012 (Abbott and von Doenhoff 1959), whose thickness is a formula."""
    x = 0.5 * (1 - np.cos(np.linspace(0, np.pi, 40)))
    half = 0.6 * (0.2969 * np.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
    upper, lower = np.stack([x, half], axis=1), np.stack([x, -half], axis=1)
    rows = [*upper[::-1], *lower[1:]] if layout == "selig" else [(40, 40), *upper, *lower]
    file = tmp_path / "naca0012.dat"
    file.write_text("NACA 0012\n" + "\n".join(f"{a:.6f} {b:.6f}" for a, b in rows))
    done = RUN("fit", file, "-o", tmp_path / "foil.toml", "--json")
    assert done.code == 0, done.err
    told = json.loads(done.out)
    assert told["max"] < 2e-4
    model = quintrig.load(tmp_path / "foil.toml")
    assert [one.name for one in model.curves] == ["upper", "lower"]
    assert model.curve("upper").curve(0.0) == pytest.approx([0, 0], abs=1e-6)


def test_on_the_command_line(tmp_path):
    surface = wavy()
    file = tmp_path / "scan.csv"
    np.savetxt(file, measured(surface, 400, 1e-3 * surface.size), delimiter=",", header="x,y,z", comments="")
    out = tmp_path / "skin.toml"
    done = RUN("fit", file, "-o", out, "--unit", "mm", "--json", "--deviation", tmp_path / "d.png")
    assert done.code == 0, done.err
    told = json.loads(done.out)
    assert told["rms"] < 1.3e-3 * surface.size
    assert told["points"] == 400
    assert quintrig.load(out).unit == "mm"
    assert json.loads(RUN("deviation", out, file, "--json").out)["rms"] == pytest.approx(told["rms_all"])
    assert RUN("fit", file, "-o", out).code == 2  # a model is not written over in silence
    same, line, few = (tmp_path / name for name in ("same.csv", "line.csv", "few.csv"))
    same.write_text("1,2,3\n" * 6)
    line.write_text("\n".join(f"{k},{2 * k},1" for k in range(9)))
    few.write_text("0,0,0\n1,0,0\n")
    for arguments, words in (
        ([same], "all in one place"),
        ([line], "all on a line"),
        ([few], "at least 4"),
        ([few, "--kind", "cylinder"], "at least"),
        ([file, "--kind", "tensr"], "did you mean 'tensor'"),
        ([file, "--shape", "1,2"], "shape: expected 4 numbers"),
        ([file, "--shape", "9,0,0,0"], "outside"),
        ([file, "--patches", "0x2"], "--patches: expected two numbers"),
        ([file, "--kind", "swept", "--patches", "2x2"], "patches: expected 1x1"),
        ([file, "--kind", "symmetric", "--mirror", "0,0,0,1"], "zero normal"),
        ([file, "--smooth", "-1"], "smooth: expected"),
        ([file, "--tolerance", "0"], "tolerance: expected"),
        ([file, "--basis", "cubix"], "did you mean 'cubic'"),
        ([file, "--boundary", "some"], "--boundary: expected"),
    ):
        done = RUN("fit", *arguments)
        assert (done.code, done.out) == (2, ""), arguments
        assert words in done.err
        assert done.err.strip().count("\n") == 0
