"""A sweep's summaries are those of the same points by ``analyse`` and of the same surfaces by ``integrals``."""

import json
from pathlib import Path

import numpy as np
import pytest

import oracle
import quintrig
from quintrig.analysis.edge_layers import layers_at_edges
from quintrig.analysis.integrate import integrals
from quintrig.quantities.classify import HK_TYPES
from quintrig.support.tolerance import SINGULAR
from quintrig.sweep.affine import amounts_above, is_affine, single_part
from quintrig.sweep.nodes import WIDEST, drawn_nodes, layer_classes
from quintrig.sweep.part import Task, columns, summaries
from quintrig.sweep.space import Axis, DesignSpace
from quintrig.sweep.summarise import COLUMNS, clenshaw_curtis, summariser

HERE = Path(__file__).parent
CASES = {
    f"{case['model']['name']}-{case['model']['shape']}-{case['model'].get('scale', '')}": case["model"]
    for case in json.loads((HERE / "data" / "cases.json").read_text())
    if case["model"].get("basis", "trigonometric") == "trigonometric"
}
EXAMPLES = {
    f"{file.stem}, {patch.name}": {**patch.definition.model_dump(exclude_defaults=True), "kind": patch.kind}
    for file in sorted((HERE.parent / "examples").glob("*.*ml"))
    if file.stem != "body"  # 56 tensor-product patches, most alike
    for patch in quintrig.load(file).patches
    if patch.shape and getattr(patch.definition, "basis", "trigonometric") == "trigonometric"
}
MODELS = CASES | EXAMPLES
CURVATURES = {"gaussian": 2, "mean": 1, "curvedness": 1}


def corners(kind):
    """All designs at the ends of the range."""
    names = ("alpha", "zeta") if kind == "developable" else ("alpha1", "zeta1", "alpha2", "zeta2")
    return DesignSpace(tuple(Axis(name, -4.0, 1.0, 2) for name in names))


def inner(kind, samples=3):
    """A few designs from all over the space."""
    return DesignSpace(corners(kind).axes, "sobol", samples, seed=2)


def rows(task):
    """Return each design with its summary as a dictionary."""
    result = summaries(task, 0, task.space.count)
    designs = [dict(zip(task.space.names, row, strict=False)) for row in result]
    return [
        (design, dict(zip(columns(task.space), row, strict=True))) for design, row in zip(designs, result, strict=True)
    ]


def nodes_of(task, values, count):
    """Return the nodes and weights in u and in v that a sweep takes for a design."""
    patch = task.varied()[0].with_parameters(values)
    if is_affine(patch, task.space):
        widths = WIDEST * amounts_above(np.array([patch.shape]) + 4.0, patch.kind == "ruled")[0]
    else:
        widths = np.array(layers_at_edges(patch.surface))
    a, b, c, d = layer_classes(widths).tolist()
    return drawn_nodes(count, a, b), drawn_nodes(count, c, d)


def expected(surface, nodes):
    """Work out a summary from ``analyse`` and ``partials`` at the nodes of a quadrature."""
    (u, a), (v, b) = nodes
    sample = quintrig.analyse(surface, u[:, None], v[None, :], (*CURVATURES, "hk_type"))
    p = surface.partials(u[:, None], v[None, :], 2)
    regular = ~sample.singular
    weight = a[:, None] * b[None, :]
    area = np.where(regular, weight * np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1), 0.0)
    plate = (p[2, 0] ** 2 + 2 * p[1, 1] ** 2 + p[0, 2] ** 2).sum(axis=-1)
    result = {"area": area.sum(), "thin_plate_energy": (weight * plate).sum(), "singular": (~regular).sum()}
    for key in CURVATURES:
        values = np.where(regular, sample[key], 0.0)
        result |= {f"{key}_min": sample[key][regular].min(), f"{key}_max": sample[key][regular].max()}
        result[f"{key}_mean"] = (values * area).sum() / area.sum()
    result["bending_energy"] = (2 * np.where(regular, sample["curvedness"], 0.0) ** 2 * area).sum()
    for code, name in enumerate(HK_TYPES[1:], 1):
        result[f"share_{name.replace(' ', '_')}"] = area[sample["hk_type"] == code].sum() / area.sum()
    return result


def is_endless(found, name):
    """Tell whether a value is infinite with the right sign beside a singular point or edge of regression."""
    assert not np.isinf(found[name]) or (name not in ("area", "thin_plate_energy") and "_mean" not in name)
    return found[name] == (-np.inf if name.endswith("_min") else np.inf) and found["curvedness_max"] == np.inf


def compare(found, wanted):
    """Compare a summary with one from the same points; infinity is the business of ``test_sweep_unbounded``."""
    curved = wanted["curvedness_max"]
    for key, power in CURVATURES.items():
        for what in ("min", "max", "mean"):
            name = f"{key}_{what}"
            assert abs(found[name] - wanted[name]) <= 1e-11 * curved**power or is_endless(found, name), name
    for name in ("area", "thin_plate_energy", "bending_energy"):
        assert found[name] == pytest.approx(wanted[name], rel=1e-11) or is_endless(found, name), name
    assert found["singular"] == wanted["singular"]
    for name in COLUMNS:
        if name.startswith("share_"):
            assert abs(found[name] - wanted[name]) <= 1e-9, name
    assert sum(found[name] for name in COLUMNS if name.startswith("share_")) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("space", [corners, inner])
@pytest.mark.parametrize("name", MODELS)
def test_summary_is_that_of_analyse_at_the_same_points(name, space):
    model = MODELS[name]
    task = Task(model, None, space(model["kind"]), 12)
    patch = task.varied()[0]
    for values, found in rows(task):
        surface = patch.with_parameters(values).surface
        compare(found, expected(surface, nodes_of(task, values, 12)))


@pytest.mark.parametrize("name", MODELS)
def test_affine_path_is_the_plain_path(name):
    model = MODELS[name]
    if model["kind"] == "developable":
        pytest.skip("a developable is not affine in its shape parameters")
    task = Task(model, None, inner(model["kind"], 5), 16)
    patch = task.varied()[0]
    assert is_affine(patch, task.space)
    for values, found in rows(task):
        (u, a), (v, b) = nodes_of(task, values, 16)
        run = summariser(patch.surface.blend.terms, len(v))
        part = single_part(patch.with_parameters(values).surface, u, v, len(v))
        plain = np.empty((1, len(COLUMNS)))
        run(part.rows, part.blend, np.empty((1, 0)), a, b, patch.surface.sign, SINGULAR, 1e-6, 1e-6, plain)
        compare(found, dict(zip(COLUMNS, plain[0], strict=True)))


def test_flipping_changes_the_sign_of_mean_curvature_alone():
    model = next(model for key, model in EXAMPLES.items() if key.startswith("tensor"))
    sides = [rows(Task({**model, "flip": flip}, None, inner("tensor"))) for flip in (False, True)]
    for (_, a), (_, b) in zip(*sides, strict=True):
        assert b["mean_min"] == -a["mean_max"]
        assert b["mean_mean"] == pytest.approx(-a["mean_mean"], rel=1e-13)
        assert (b["share_pit"], b["share_saddle_valley"]) == (a["share_peak"], a["share_saddle_ridge"])
        assert (b["gaussian_min"], b["area"]) == (a["gaussian_min"], a["area"])


@pytest.mark.parametrize("name", ["ruled", "swung", "developable", "car_boot"])
def test_integrals_are_met_within_the_error_of_the_quadrature(name):
    model = next(model for key, model in EXAMPLES.items() if key.startswith(name))
    axes = tuple(Axis(axis.name, -2.0, 1.0, 2) for axis in corners(model["kind"]).axes[:2])
    coarse, fine = (rows(Task(model, None, DesignSpace(axes), points)) for points in (64, 128))
    patch = Task(model, None, DesignSpace(axes)).varied()[0]
    for (values, rough), (_, found) in zip(coarse, fine, strict=True):
        exact = integrals(patch.with_parameters(values).surface)
        wanted = {
            "area": exact.area,
            "bending_energy": exact.bending_energy,
            "thin_plate_energy": exact.thin_plate_energy,
        }
        for key, integral in wanted.items():
            assert integral.converged
            # The step from 64 to 128 points is the error of the coarser rule, so the finer one is nearer than that.
            allowed = abs(found[key] - rough[key]) + integral.error + 1e-10 * abs(integral.value)
            assert abs(found[key] - integral.value) <= allowed, key
        for key, integral in (("mean", exact.total_mean), ("gaussian", exact.total_gaussian)):
            total, before = (row[f"{key}_mean"] * row["area"] for row in (found, rough))
            scale = found["curvedness_mean"] ** CURVATURES[key] * found["area"]
            assert abs(total - integral.value) <= abs(total - before) + integral.error + 1e-10 * scale, key


@pytest.mark.parametrize("name", ["thesis figure 2.4 net-[1, 0, -2, -3]-", "ruled"])
def test_extremes_are_those_of_40_digits(name):
    model = next(model for key, model in MODELS.items() if key.startswith(name))
    shape = dict(zip(("alpha1", "zeta1", "alpha2", "zeta2"), (0.3, -3.7, -1.1, 0.9), strict=True))
    space = DesignSpace(tuple(Axis(name, value, value, 1) for name, value in shape.items()))
    task = Task(model, None, space, 5)
    ((values, found),) = rows(task)
    (us, _), (vs, _) = nodes_of(task, values, 5)
    exact = [oracle.values({**model, "shape": list(values.values())}, u, v) for u in us for v in vs]
    curved = max(float(p["curvedness"]) for p in exact)
    for key, power in CURVATURES.items():
        least, most = (float(choose(p[key] for p in exact)) for choose in (min, max))
        assert abs(found[f"{key}_min"] - least) <= 1e-11 * curved**power, key
        assert abs(found[f"{key}_max"] - most) <= 1e-11 * curved**power, key


def test_scale_of_a_swung_surface_is_varied():
    model = next(model for key, model in EXAMPLES.items() if key.startswith("swung"))
    space = DesignSpace((Axis("scale", 0.5, 2.0, 4), Axis("zeta1", -3.0, 1.0, 2)))
    task = Task(model, None, space, 12)
    for values, found in rows(task):
        surface = quintrig.Model.from_dict(
            {**model, "scale": values["scale"], "shape": [model["shape"][0], values["zeta1"], *model["shape"][2:]]}
        ).surface
        compare(found, expected(surface, nodes_of(task, values, 12)))


def test_scale_of_a_classical_swung_surface_is_varied():
    model = next(model for key, model in EXAMPLES.items() if key.startswith("swung"))
    classical = {key: value for key, value in model.items() if key != "shape"} | {"basis": "bernstein"}
    task = Task(classical, None, DesignSpace((Axis("scale", 0.5, 2.0, 2),)), 12)
    for values, found in rows(task):
        surface = quintrig.Model.from_dict({**classical, "scale": values["scale"]}).surface
        compare(found, expected(surface, nodes_of(task, values, 12)))


def test_an_edge_that_stands_still_is_counted_as_singular():
    model = next(iter(CASES.values()))
    task = Task(model, None, DesignSpace((Axis("alpha1", -4.0, 1.0, 6),)), 16)
    counts = [found["singular"] for _, found in rows(task)]
    assert counts == [16, 0, 0, 0, 0, 0]


def test_a_design_that_is_no_surface_has_no_values_and_only_singular_points():
    model = next(model for key, model in EXAMPLES.items() if key.startswith("swung"))
    task = Task(model, None, DesignSpace((Axis("scale", 0.0, 1.0, 2),)), 8)
    (_, flat), (_, whole) = rows(task)
    assert flat["singular"] == 64
    assert flat["area"] == 0.0
    assert all(np.isnan(flat[f"{key}_{what}"]) for key in CURVATURES for what in ("min", "max", "mean"))
    assert whole["singular"] == 0


def test_parts_do_not_depend_on_how_the_space_is_cut():
    model = next(iter(CASES.values()))
    task = Task(model, None, corners("tensor"), 9)
    whole = summaries(task, 0, 16)
    pieces = np.concatenate([summaries(task, a, b) for a, b in ((0, 5), (5, 6), (6, 16))])
    assert np.array_equal(whole, pieces)


@pytest.mark.parametrize("count", [4, 5, 12, 33, 128])
def test_clenshaw_curtis_integrates_polynomials_below_its_count(count):
    t, w = clenshaw_curtis(count)
    assert (t[0], t[-1], len(t)) == (0.0, 1.0, count)
    assert np.array_equal(t, np.sort(t))
    assert (w > 0).all()
    for degree in range(count):
        assert w @ t**degree == pytest.approx(1.0 / (degree + 1), rel=1e-13)


NEAR = [(0, 0, 0, -3.99), (-3.999, 0, 0, -3.9), (-3.7, -3.99, -3.95, 1), (1, -3.01, 0.5, -3.26), (-3.9999, 1, 1, 1)]


@pytest.mark.parametrize("shape", NEAR)
@pytest.mark.parametrize("name", ["swept", "ruled", "symmetric", "wavy"])
def test_designs_just_above_minus_four_are_as_good_as_any(name, shape):
    model = next(model for key, model in EXAMPLES.items() if key.startswith(name))
    names = ("alpha1", "zeta1", "alpha2", "zeta2")
    space = DesignSpace(tuple(Axis(name, value, value, 1) for name, value in zip(names, shape, strict=True)))
    task = Task(model, None, space)
    ((values, found),) = rows(task)
    exact = integrals(task.varied()[0].with_parameters(values).surface)
    for key in ("area", "bending_energy", "thin_plate_energy"):
        assert exact[key].converged
        assert found[key] == pytest.approx(exact[key].value, rel=1e-3), key
    for key, power in (("gaussian", 2), ("mean", 1)):
        scale = found["curvedness_mean"] ** power
        total = exact[f"total_{key}"].value / exact.area.value
        assert abs(found[f"{key}_mean"] - total) <= 1e-3 * scale, key


def test_order_does_not_jump_where_nodes_change():
    model = next(model for key, model in EXAMPLES.items() if key.startswith("swept"))
    for edge in (-3.0, -3.75, -4 + 1 / 16, -4 + 1 / 64):
        space = DesignSpace((Axis("zeta2", edge - 1e-7, edge + 1e-7, 2),))
        (_, below), (_, above) = rows(Task(model, None, space))
        for key in ("bending_energy", "area", "gaussian_mean", "mean_mean"):
            assert below[key] == pytest.approx(above[key], rel=2e-4), key


@pytest.mark.parametrize("classes", [(0, 0), (1, 0), (0, 3), (2, 2), (9, 1)])
def test_drawn_nodes_integrate_what_lies_beside_the_edge(classes):
    t, w = drawn_nodes(32, *classes)
    assert (t[0], t[-1]) == (0.0, 1.0)
    assert (np.diff(t) > 0).all()
    assert (w >= 0).all()
    assert w @ t**3 == pytest.approx(0.25, rel=1e-5)
    for number, x in zip(classes, (t, 1 - t), strict=True):
        for width in WIDEST * 4.0**-number * np.array([1.01, 2.0, 3.99]) if number else ():
            assert w @ (1 / (x + width)) == pytest.approx(np.log1p(1 / width), rel=1e-5)
            assert w @ (x + width) ** -3 == pytest.approx(0.5 * (width**-2 - (1 + width) ** -2), rel=1e-5)
