"""Every basis that quintrig brings, against 40 digits from the papers' formulas, and every way to name one."""

import importlib.metadata
from types import SimpleNamespace

import numpy as np
import pytest
from mpmath import diff, matrix, mp, mpf

import oracle_bases
import quintrig
from quintrig.analysis.summary import summarise
from quintrig.basis import registry
from quintrig.basis.bspline import BSpline
from quintrig.basis.formulas import Basis, Formulas, Parameter
from quintrig.basis.library import LIBRARY
from quintrig.basis.rational import NotRationalError
from quintrig.basis.registry import bases, entry, own_basis
from quintrig.geometry.curve import Curve
from quintrig.geometry.exact import exact_curve, exact_surface
from quintrig.support.errors import ModelError, QuintrigError

ENTRIES = {one.name: one for one in LIBRARY}
RANDOM = np.random.default_rng(11)


def _cases():
    """Every basis with several numbers of points, at values between, and at the ends of its ranges."""
    for one in LIBRARY:
        for points in sorted({one.usual, *list(one.sizes)[:6], *([11] if 11 in one.sizes else [])}):
            ranges = one.basis(points).parameters
            values = [
                tuple(p.low + (p.high - p.low) * x for p, x in zip(ranges, RANDOM.random(len(ranges)), strict=True))
            ]
            if ranges:
                values.append(tuple(p.low if not p.open[0] else p.low + 0.2 for p in ranges))
                values.append(tuple(p.high if not p.open[1] else p.high - 0.2 for p in ranges))
            for own in values:
                yield pytest.param(one.name, points, own, id=f"{one.name}-{points}-{','.join(f'{x:.3g}' for x in own)}")


CASES = list(_cases())


def exact(name, points, values, t, order):
    """Return derivatives of an order in 40 digits."""
    oracle = getattr(oracle_bases, name)
    numbers = [oracle_bases.pi if value == np.pi else mpf(value) for value in values]
    return [diff(lambda x, i=i: oracle(points, x, *numbers)[i], mpf(t), order) for i in range(points)]


@pytest.mark.parametrize(("name", "points", "values"), CASES)
def test_derivatives_to_order_three(name, points, values):
    family = ENTRIES[name].family(points, values)
    for t in (1e-5, 0.31, 0.5, 0.77, 1 - 2.0**-17):
        found = family.derivatives(t, 3)
        for order in range(4):
            expected = np.array([float(x) for x in exact(name, points, values, t, order)])
            # C- and H-Bézier functions are differences that a large or small φ magnifies.
            np.testing.assert_allclose(found[order], expected, rtol=0, atol=2e-12 * max(1.0, np.abs(expected).max()))
        ends = np.array([float(x) for x in exact(name, points, values, t, 0)])
        if not 0.01 < t < 0.99:
            np.testing.assert_allclose(
                found[0], ends, rtol=1e-9, atol=1e-20
            )  # nothing cancels where a function is small


@pytest.mark.parametrize(("name", "points", "values"), CASES)
def test_partition_ends_and_sign(name, points, values):
    family = ENTRIES[name].family(points, values)
    found = family.derivatives(np.linspace(0.0, 1.0, 201), 0)[0]
    assert family.partition
    np.testing.assert_allclose(found.sum(axis=-1), 1.0, rtol=0, atol=2e-13)
    np.testing.assert_allclose(found[[0, -1]], np.eye(points)[[0, -1]], rtol=0, atol=2e-13)
    assert found.min() >= -2e-13


@pytest.mark.parametrize(("name", "points", "values"), CASES)
def test_increments_are_sums_of_the_functions_that_follow(name, points, values):
    family = ENTRIES[name].family(points, values)
    t = np.array([0.0, 0.2, 0.5, 0.9, 1.0])
    derived, found = family.derivatives(t, 2), family.increments(t, 2)
    for i in range(points - 1):
        scale = 1.0 + np.abs(derived).max()
        np.testing.assert_allclose(found[..., i], derived[..., i + 1 :].sum(axis=-1), rtol=0, atol=1e-13 * scale)


@pytest.mark.parametrize(("name", "points", "values"), CASES)
def test_the_compiled_loop_gives_the_same_increments(name, points, values):
    family, t = ENTRIES[name].family(points, values), np.array([*np.linspace(0.0, 1.0, 61), 1e-7, 0.5 - 1e-9, 1 - 1e-7])
    out = np.empty((1, 3, points - 1, 64))
    family.fill(t[None, :], out)
    expected = family.increments(t, 2)
    for order in range(3):
        scale = max(1.0, np.abs(expected[order]).max())
        np.testing.assert_allclose(out[0, order].T, expected[order], rtol=0, atol=1e-12 * scale)


@pytest.mark.parametrize(("name", "points", "values"), CASES)
def test_exact_rational_form(name, points, values):
    family = ENTRIES[name].family(points, values)
    if name in ("c_bezier", "h_bezier") or (name == "generalised_trigonometric" and points > 3):
        with pytest.raises(NotRationalError, match="no exact rational form"):
            family.rational()
        return
    if name == "generalised_trigonometric_squares" and points > 8:
        with pytest.raises(NotRationalError, match="degree"):
            family.rational()
        return
    form, t = family.rational(), np.linspace(0.0, 1.0, 33)
    x = form.map.forward(t)
    blend = BSpline(form.knots, form.degree).derivatives(x, 0)[0]
    found = blend @ form.coefficients / (blend @ form.weights)[:, None]
    np.testing.assert_allclose(found, family.derivatives(t, 0)[0], rtol=0, atol=4e-15)


@pytest.mark.parametrize("name", ENTRIES)
def test_curvature_of_a_patch(name):
    one = ENTRIES[name]
    n = one.usual
    ranges = one.basis(n).parameters
    values = [tuple(p.low + x * (p.high - p.low) for p in ranges) for x in (0.7, 0.55)]
    net = np.stack(np.meshgrid(np.arange(n), np.arange(n), [0.0], indexing="ij"), axis=-1)[:, :, 0]
    net[..., 2] = RANDOM.normal(size=(n, n))
    surface = quintrig.tensor(net, [*values[0], *values[1]], basis=name)
    for u, v in ((0.37, 0.81), (0.05, 0.5)):
        f = [exact(name, n, values[0], u, k) for k in range(3)]
        g = [exact(name, n, values[1], v, k) for k in range(3)]
        p = {
            (a, b): [sum(f[a][i] * g[b][j] * mpf(net[i, j, x]) for i in range(n) for j in range(n)) for x in range(3)]
            for a in range(3)
            for b in range(3 - a)
        }

        def dot(x, y):
            return sum(s * t for s, t in zip(x, y, strict=True))

        su, sv = p[1, 0], p[0, 1]
        normal = [su[1] * sv[2] - su[2] * sv[1], su[2] * sv[0] - su[0] * sv[2], su[0] * sv[1] - su[1] * sv[0]]
        square = dot(normal, normal)
        first = matrix([[dot(su, su), dot(su, sv)], [dot(su, sv), dot(sv, sv)]])
        e, f2, g2 = (dot(p[k], normal) / mp.sqrt(square) for k in ((2, 0), (1, 1), (0, 2)))
        gauss = (e * g2 - f2**2) / square
        mean = (first[0, 0] * g2 - 2 * first[0, 1] * f2 + first[1, 1] * e) / (2 * square)
        sample = quintrig.analyse(surface, u, v, ("gaussian", "mean"))
        bend = float(abs(mean) + mp.sqrt(abs(gauss)))
        assert abs(float(sample["gaussian"]) - float(gauss)) <= 1e-12 * bend**2
        assert abs(float(sample["mean"]) - float(mean)) <= 1e-12 * bend


# ------------------------------------------------------------------------------------------------------ circles

QUADRATIC, CUBIC = [[1, 0], [1, 1], [0, 1]], [[1, 0], [1, 0.5], [0.5, 1], [0, 1]]


@pytest.mark.parametrize(("name", "points"), [("quadratic", QUADRATIC), ("cubic", CUBIC)])
def test_orders_two_and_three_hold_the_quarter_circle(name, points):
    curve, t = Curve(points, basis=name), np.linspace(0.0, 1.0, 101)
    np.testing.assert_allclose(np.hypot(*curve(t).T), 1.0, rtol=0, atol=1e-15)
    np.testing.assert_allclose(curve.curvature(t), 1.0, rtol=0, atol=4e-15)
    assert curve.length() == pytest.approx(0.5 * np.pi, abs=1e-15)
    form = exact_curve(curve)
    assert form.basis.degree == 2 * (len(points) - 2)
    np.testing.assert_allclose(np.hypot(*form(t).T), 1.0, rtol=0, atol=1e-15)


@pytest.mark.parametrize("shape", [(0.0, 0.0), (0.3, 0.3), (1.0, 1.0), (-2.0, -2.0)])
@pytest.mark.parametrize("name", ["quartic", "quintic"])
def test_orders_four_and_five_hold_none(name, shape):
    """The end legs that meet a circle's tangents leave a radius that is off in the middle, whatever their length."""
    n = entry(name).sizes[0]
    t, best = np.linspace(0.0, 1.0, 101), 1.0
    for leg in np.linspace(0.1, 0.9, 81):
        inner = {5: [[1, leg], [leg, 1]], 6: [[1, leg], [leg, 1]]}[n]
        for bulge in np.linspace(0.5, 1.2, 36):
            middle = [[bulge, bulge]] if n == 5 else [[1.0, bulge], [bulge, 1.0]]
            net = [[1, 0], inner[0], *middle, inner[1], [0, 1]]
            best = min(best, np.abs(np.hypot(*Curve(net, *shape, basis=name)(t).T) - 1.0).max())
    assert best > 1e-7


def test_a_swung_surface_on_a_quarter_circle_is_an_exact_sphere():
    profile = [[r, z] for z, r in CUBIC]
    surface = quintrig.swung(profile, CUBIC, basis="cubic")
    t = np.linspace(0.0, 1.0, 33)
    np.testing.assert_allclose(np.linalg.norm(surface(t[:, None], t), axis=-1), 1.0, rtol=0, atol=1e-15)
    sample = quintrig.analyse(surface, t[:-1, None], t[None, :], ("gaussian", "mean"))
    np.testing.assert_allclose(sample["gaussian"][1:-1], 1.0, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.abs(sample["mean"][1:-1]), 1.0, rtol=0, atol=1e-12)
    form = exact_surface(surface).surface()  # a quotient of two sums of its own, each rounded
    np.testing.assert_allclose(np.linalg.norm(form(t[:, None], t), axis=-1), 1.0, rtol=0, atol=3e-15)


def test_a_quintic_profile_turned_about_the_axis_is_a_surface_of_revolution():
    profile = [[20, 0], [60, 10], [80, 40], [50, 70], [30, 100], [40, 120]]
    surface = quintrig.swung(profile, CUBIC, [0.5, -1, 0, 0], basis=["quintic", "cubic"])
    t = np.linspace(0.0, 1.0, 17)
    points, curve = surface(t[:, None], t), Curve(profile, 0.5, -1.0)(t)
    radius, height = np.hypot(points[..., 0], points[..., 1]), points[..., 2]
    np.testing.assert_allclose(radius, np.tile(curve[:, :1], 17), rtol=1e-15)
    np.testing.assert_allclose(height, np.tile(curve[:, 1:], 17), rtol=0, atol=1e-13)
    assert exact_surface(surface).degrees == (10, 4)


def test_a_cylinder():
    surface = quintrig.swung([[2, 0], [2, 5]], CUBIC, basis=["bernstein", "cubic"])
    sample = quintrig.analyse(surface, *np.ix_(np.linspace(0, 1, 9), np.linspace(0, 1, 9)), ("gaussian", "mean"))
    np.testing.assert_allclose(np.abs(sample["mean"]), 0.25, rtol=1e-14)
    np.testing.assert_allclose(sample["gaussian"], 0.0, atol=1e-15)


# ------------------------------------------------------------------------------------------- constructions, models


@pytest.mark.parametrize("name", ENTRIES)
def test_every_construction_takes_every_basis(name):
    n = ENTRIES[name].usual
    line = np.linspace(0.0, 1.0, n)
    section = np.stack([line, 0 * line, np.sin(2.5 * line)], axis=-1)
    trajectory = np.stack([0 * line, line, line**2], axis=-1)
    surfaces = {
        "swept": quintrig.swept(section, trajectory, basis=name),
        "ruled": quintrig.ruled(section, np.add(section, [0.0, 1.0, 0.3]), basis=name),
        "swung": quintrig.swung(np.add(section[:, [2, 0]], 1.0), np.add(trajectory[:, :2], 1.0), basis=name),
        "developable": quintrig.developable(
            np.stack([2 * line - 1, 0.1 + 0 * line, 1 + 0 * line, 4 * line * (1 - line) - 2], axis=-1),
            [[0, 1, 0, 0], [0, 1, 0, -1]],
            basis=name,
        ),
    }
    half = (n + 1) // 2
    net = np.stack(np.meshgrid(line[:half], line, [0.2], indexing="ij"), axis=-1)[:, :, 0]
    surfaces["symmetric"] = quintrig.symmetric(net, [1, 0, 0, -line[half - 1] if n % 2 else -0.5], basis=name)
    functions = ENTRIES[name].family(n).derivatives(0.3, 0)[0]
    for kind, surface in surfaces.items():
        assert np.isfinite(surface(0.3, 0.6)).all(), kind
    np.testing.assert_allclose(surfaces["swept"](0.3, 0.3), functions @ (section + trajectory), atol=1e-14)
    np.testing.assert_allclose(surfaces["ruled"](0.3, 0.0), functions @ section, atol=1e-14)
    strip = quintrig.analyse(surfaces["developable"], 0.4, 0.6, ("gaussian", "curvedness"))
    assert abs(float(strip["gaussian"])) <= 1e-12 * float(strip["curvedness"]) ** 2


MINE = {"functions": ["r^2+lam*t*r^2", "2*t*r-lam*t*r", "t^2+lam*t^2*r"], "parameters": {"lam": [-0.5, 1]}}
NET = [[[i, j, (i - 1) * (j - 1.5)] for j in range(4)] for i in range(3)]


def model(**changed):
    keys = {"kind": "tensor", "points": NET, "basis": ["mine", "cubic"], "bases": {"mine": MINE}} | changed
    return quintrig.Model.from_dict({key: value for key, value in keys.items() if value is not None})


def test_a_basis_of_the_models_own():
    patch = model(shape=[0.25, 0.5, -1]).patch()
    assert patch.definition.parameters == {"lam1": 0.25, "alpha2": 0.5, "zeta2": -1.0}
    u = 0.3
    f = [0.49 * 1.075, 0.42 - 0.25 * 0.21, 0.09 * 1.175]
    g = ENTRIES["cubic"].family(4, (0.5, -1.0)).derivatives(0.6, 0)[0]
    np.testing.assert_allclose(patch.surface(u, 0.6), np.einsum("i,j,ijx", f, g, np.array(NET)), atol=1e-15)
    again = quintrig.Model.from_dict(model(shape=[0.25, 0.5, -1]).to_dict()).patch()
    np.testing.assert_array_equal(again.surface(0.2, 0.9), patch.surface(0.2, 0.9))
    varied = patch.with_parameters({"lam1": 1.0})
    assert varied.shape == (1.0, 0.5, -1.0)


def test_a_file_of_bases_beside_the_model(tmp_path):
    (tmp_path / "mine.toml").write_text(
        "[basis.mine]\nparameters = { lam = [-0.5, 1] }\n"
        'functions = ["r^2+lam*t*r^2", "2*t*r-lam*t*r", "t^2+lam*t^2*r"]\n'
    )
    points = ", ".join(str(row) for row in NET)
    file = tmp_path / "model.toml"
    file.write_text(
        f'schema = 1\nkind = "tensor"\nbasis = ["mine", "cubic"]\nbases = "mine.toml"\npoints = [{points}]\n'
    )
    np.testing.assert_array_equal(quintrig.load(file).surface(0.3, 0.4), model().surface(0.3, 0.4))


def test_patches_share_the_bases_of_their_file():
    patch = {"kind": "tensor", "points": NET, "basis": ["mine", "cubic"]}
    found = quintrig.Model.from_dict({"bases": {"mine": MINE}, "patch": [patch | {"name": "a"}, patch | {"name": "b"}]})
    again = quintrig.Model.from_dict(found.to_dict())
    assert list(found.to_dict()["bases"]) == ["mine"]
    np.testing.assert_array_equal(again.patch("b").surface(0.3, 0.4), model().surface(0.3, 0.4))


def test_a_family_is_a_basis_too():
    mine = Basis("mine", tuple(MINE["functions"]), (Parameter("lam", -0.5, 1.0),))
    found = quintrig.tensor(NET, [0.5, -1], basis=[Formulas(mine, (0.25,)), "cubic"])
    np.testing.assert_array_equal(found(0.3, 0.6), model(shape=[0.25, 0.5, -1]).surface(0.3, 0.6))


OFF = {"functions": ["r^2", "2.1*t*r", "t^2"]}


def test_what_does_not_sum_to_one_is_refused_unless_wanted():
    with pytest.raises(
        ModelError, match=r"'mine' do not sum to 1 \(their sum is 1.025 at t = 0.5\).*unchecked_basis = true"
    ):
        model(bases={"mine": OFF})
    patch = model(bases={"mine": OFF}, unchecked_basis=True).patch()
    assert any("moves with the origin" in line for line in summarise(patch.surface, "").warnings)
    there = np.add(NET, [100.0, 0.0, 0.0])
    moved = model(bases={"mine": OFF}, unchecked_basis=True, points=there.tolist()).surface
    assert abs((moved(0.5, 0.5) - patch.surface(0.5, 0.5))[0] - 100.0) > 1.0


BAD = {
    "unknown name": (["1-x", "t"], "functions[0]: character 3: expected a name", "'x'"),
    "unknown function": (["tan(t)", "t"], "functions[0]: character 1: expected a function, one of sin"),
    "attribute": (["t.real", "t"], "character 2: expected an operator", "'.'"),
    "call of a number": (["t(1)", "t"], "character 2", "write t*(...)"),
    "import": (["__import__('os')", "t"], "character 1: expected a function"),
    "huge power": (["r", "t^99999999"], "functions[1]: character 3: expected a power of at most 64"),
    "tower of powers": (["r", "t^9^9"], "expected one power only"),
    "deep nesting": (["r", "(" * 500 + "t" + ")" * 500], "expected at most 40 levels of nesting"),
    "long row": (["r", "+".join(["t"] * 1500)], "expected at most 200 terms or factors in a row"),
    "long text": (["r", "t" + " " * 5000], "expected at most 4000 characters"),
    "division by zero": (["1/(t-0.3)", "t"], "functions[0]: divides by zero near t = 0.29"),
    "division by a double zero": (["1/(t-0.3)^2", "t"], "divides by zero near t = 0.3"),
    "division by zero at a parameter": (["t/(lam+0.5)", "t"], "divides by zero at t = 0, lam = -0.5"),
    "complex": (["sqrt(t-0.5)", "t"], "takes the root of a number that is not positive"),
    "overflow": (["exp(exp(exp(t+3)))", "t"], "expected values of size at most"),
    "thousands": (["t"] * 3000, "functions: expected 2 to 64 formulas, found 3000"),
    "empty": (["", "t"], "character 1: expected a number, a name or '('"),
    "python power": (["t**2", "t"], "write ^ for a power"),
    "implied product": (["2t", "t"], "character 2", "write 2*t"),
    "number": ([1, "t"], "functions[0]: expected a formula in quotation marks"),
    "no list": ("r t", "functions: expected a list of formulas"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_formulas_are_told_in_one_line(name):
    functions, *parts = BAD[name]
    with pytest.raises(ModelError) as caught:
        model(bases={"mine": {"functions": functions, "parameters": {"lam": [-0.5, 1]}}})
    message = str(caught.value)
    assert "bases.mine: " in message
    assert "\n" not in message
    assert len(message) < 500
    for part in parts:
        assert part in message


TABLES = {
    "built-in name": ({"cubic": OFF}, "bases.cubic: 'cubic' is the name of a basis that quintrig brings"),
    "no range": ({"mine": MINE | {"parameters": {"lam": 1}}}, "parameters.lam: expected its range [low, high]"),
    "list of names": ({"mine": MINE | {"parameters": ["lam"]}}, "parameters: expected a table such as"),
    "reversed": ({"mine": MINE | {"parameters": {"lam": [1, -1]}}}, "expected a range [low, high] with low < high"),
    "not a number": ({"mine": MINE | {"parameters": {"lam": ["a", 1]}}}, "parameters.lam: expected"),
    "reserved": ({"mine": MINE | {"parameters": {"lam": [0, 1], "s": [0, 1]}}}, "'s' is taken by the grammar"),
    "no functions": ({"mine": {}}, "functions: expected a list of formulas"),
    "unknown key": ({"mine": MINE | {"function": []}}, "unknown key 'function'; did you mean 'functions'?"),
    "not a table": ({"mine": 3}, "expected a table with functions"),
    "name": ({"my basis": MINE}, "expected a name of letters, digits and _"),
}


@pytest.mark.parametrize("name", TABLES)
def test_bad_tables_are_told_in_one_line(name):
    tables, part = TABLES[name]
    with pytest.raises(ModelError) as caught:
        model(bases=tables, basis=None)
    assert part in str(caught.value)
    assert "\n" not in str(caught.value)


MODELS = {
    "rows": ({"points": NET[:2]}, "points: expected 3 control points for the mine basis, found 2"),
    "columns": ({"points": [row[:3] for row in NET]}, "points[0]: expected 4 control points for the cubic basis"),
    "shape": ({"shape": [0, 0]}, "shape: expected 3 numbers (lam1, alpha2, zeta2), found 2"),
    "range": ({"shape": [2, 0, 0]}, "shape[0] (lam1) = 2 is outside [-0.5, 1]"),
    "unknown": ({"basis": "mien"}, "did you mean 'mine'?"),
    "three": ({"basis": ["mine"] * 3}, "basis: expected one basis, or 2, found 3"),
    "number": ({"basis": 3}, "basis: expected the name of a basis"),
    "no shape": ({"bases": {"mine": {"functions": ["r^2", "2*t*r", "t^2"]}}, "shape": [1, 0, 0]}, "expected 2 numbers"),
}


@pytest.mark.parametrize("name", MODELS)
def test_counts_and_values_that_do_not_fit(name):
    changed, part = MODELS[name]
    with pytest.raises(ModelError) as caught:
        model(**changed)
    assert part in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_misprinted_family_of_ammad_and_misro_is_caught():
    """A sine printed for a cosine in f4 (Ammad and Misro 2020)."""
    good = ENTRIES["quintic"].basis()
    assert good.partition
    text = good.functions[4].replace("c*", "s*", 1)
    misprinted = Basis("misprinted", (*good.functions[:4], text, good.functions[5]), good.parameters)
    assert not misprinted.partition
    assert misprinted.off_sum[0] > 0.1


# ------------------------------------------------------------------------------------------------------- plug-ins


def point(name, thing, package):
    return SimpleNamespace(name=name, value=f"{package}:thing", dist=SimpleNamespace(name=package), load=lambda: thing)


@pytest.fixture
def installed(monkeypatch):
    def put(*points):
        monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: points if group == registry.GROUP else ())
        bases.cache_clear()

    yield put
    bases.cache_clear()


def test_an_installed_package_adds_a_basis(installed):
    installed(point("linear", {"functions": ["r", "t"]}, "other"))
    assert quintrig.tensor([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]], basis="linear")(0.5, 0.5)[2] == 0.25


def test_two_packages_with_one_name(installed):
    installed(point("linear", {"functions": ["r", "t"]}, "one"), point("linear", {"functions": ["r", "t"]}, "two"))
    with pytest.raises(QuintrigError, match="'linear' is brought by one and by two"):
        bases()


def test_a_package_cannot_redefine_a_built_in_basis(installed):
    installed(point("cubic", {"functions": ["r", "t"]}, "other"))
    with pytest.raises(QuintrigError, match="'cubic' is brought by quintrig and by other"):
        bases()


def test_a_failing_package_is_left_out_with_a_warning(installed):
    installed(point("linear", {"functions": ["r", "x"]}, "other"))
    with pytest.warns(UserWarning, match=r"'linear' of other is left out: functions\[1\]"):
        assert "linear" not in bases()


def test_a_table_is_data_and_never_code():
    with pytest.raises(ValueError, match="character"):
        own_basis("mine", {"functions": ["().__class__", "t"]})


def test_a_mistake_in_bases_for_several_patches_names_the_file(tmp_path):
    patch = '[[patch]]\nname = "a"\nkind = "tensor"\nbasis = "mine"\npoints = [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]\n'
    for head, said in (
        ('[bases.mine]\nfunctions = ["1-t", "t*q"]\n', "found 'q'"),
        ('bases = "no.toml"\n', "no such file"),
    ):
        file = tmp_path / "several.toml"
        file.write_text(head + patch)
        with pytest.raises(ModelError, match=said) as error:
            quintrig.load(file)
        assert str(error.value).startswith(str(file))
