"""What holds of every surface, over the whole catalogue: motion, scale, side, order of parameters, relations."""

from functools import cache

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

import quintrig
from catalogue import SURFACES, build
from closeness import HEIGHT, STEEP, clear, natural, off, sound
from quintrig.geometry.surface import Net, Surface
from quintrig.quantities.table import CLASSES, QUANTITIES, mirrored

ROUNDING = 1e-11
NETS = [name for name in SURFACES if SURFACES[name].model["kind"] not in ("developable", "nurbs")]

unit = st.floats(0.0, 1.0) | st.sampled_from([0.0, 0.25, 0.5, 1.0])
points = st.lists(st.tuples(unit, unit), min_size=8, max_size=8).map(lambda pairs: np.array(pairs).T)
angles = st.floats(0.0, 6.0)
repeatable = settings(deadline=None, derandomize=True, max_examples=12, phases=[Phase.generate])


@cache
def surface_of(name):
    return SURFACES[name].surface()


def over_catalogue(names=SURFACES):
    return pytest.mark.parametrize("name", list(names))


def sampled(surface, at):
    return quintrig.analyse(surface, at[0], at[1])


def rotation(axis, angle):
    k = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def moved(name, turn, shift, scale=1.0):
    """Return the surface whose points are scale turn S + shift, by moving what the model is made of where it can be."""
    model, kind = dict(SURFACES[name].model), SURFACES[name].model["kind"]

    def place(positions):
        return scale * np.array(positions) @ turn.T + shift

    def tilt(planes):
        planes = np.array(planes, dtype=float)
        normals = planes[..., :3] @ turn.T
        return np.concatenate([normals, scale * planes[..., 3:] - (normals @ shift)[..., None]], axis=-1)

    if kind in ("tensor", "symmetric", "nurbs"):
        model["points"] = place(model["points"])
        if kind == "symmetric":
            model["mirror"] = tilt(model["mirror"])
    elif kind == "swept":
        model |= {"section": place(model["section"]), "trajectory": scale * np.array(model["trajectory"]) @ turn.T}
    elif kind == "ruled":
        model |= {"first": place(model["first"]), "second": place(model["second"])}
    elif kind == "developable":
        model |= {"planes": tilt(model["planes"]), "bounds": tilt(model["bounds"])}
    else:
        return None
    return build(model)


def moved_rows(name, turn, scale=1.0):
    """Return scale turn S for any surface whose rows are a net, which is linear in its points."""
    surface = surface_of(name)
    rows = Net(scale * surface.rows.points @ turn.T, surface.rows.functions)
    return Surface(rows, surface.blend, surface.flip)


# ---------------------------------------------------------------------------------------------- motion and scale


@over_catalogue()
@repeatable
@given(points, angles, st.tuples(*[st.floats(-5, 5)] * 3))
def test_rigid_motion_changes_nothing_but_place_and_direction(name, at, angle, shift):
    turn, shift = rotation([1, -2, 0.7], angle), np.array(shift)
    there = moved(name, turn, shift)
    if there is None:
        there, shift = moved_rows(name, turn), np.zeros(3)
    before, after = sampled(surface_of(name), at), sampled(there, at)
    fair = sound(before)
    # The box of thresholds turns too, so that only its order of magnitude stays.
    assert 0.5 <= after.size / before.size <= 2.0
    for q in QUANTITIES:
        if q.key in HEIGHT or q.colour == "classes":
            continue
        expected = before[q.key]
        if q.colour == "vector":
            expected = expected @ turn.T + (shift if q.key == "point" else 0.0)
        found = signed(q.key, after[q.key], expected)
        scale = natural(before, q.key) * (1.0 + np.abs(shift).max() / before.size)
        assert off(found[fair], expected[fair], scale[fair]) <= ROUNDING, q.key
    for key in CLASSES:
        if key != "invariant_type":
            same = fair & clear(before, key)
            np.testing.assert_array_equal(after[key][same], before[key][same])


def signed(key, found, expected):
    """Principal directions have no sense: turn those of ``found`` to the side of ``expected``."""
    if not key.startswith("direction"):
        return found
    return found * np.where((found * expected).sum(axis=-1) < 0, -1.0, 1.0)[..., None]


@over_catalogue()
@repeatable
@given(points, angles, st.floats(-5, 5))
def test_turning_about_the_vertical_keeps_every_invariant(name, at, angle, rise):
    turn, shift = rotation([0, 0, 1], angle), np.array([1.0, -2.0, rise])
    there = moved(name, turn, shift) or moved_rows(name, turn)
    before, after = sampled(surface_of(name), at), sampled(there, at)
    fair = sound(before)
    for key in HEIGHT:
        assert off(after[key][fair], before[key][fair], natural(before, key)[fair]) <= ROUNDING, key
    same = fair & clear(before, "invariant_type")
    np.testing.assert_array_equal(after["invariant_type"][same], before["invariant_type"][same])


@over_catalogue()
@repeatable
@given(points, st.sampled_from([1e-26, 1e-3, 0.37, 25.4, 1e3, 1e26]))
def test_every_quantity_scales_by_its_power_of_length(name, at, scale):
    there = moved(name, np.eye(3), np.zeros(3), scale) or moved_rows(name, np.eye(3), scale)
    before, after = sampled(surface_of(name), at), sampled(there, at)
    assert after.size == pytest.approx(scale * before.size, rel=1e-12)
    fair = sound(before)
    for q in QUANTITIES:
        if q.colour == "classes":
            same = fair & clear(before, q.key)
            np.testing.assert_array_equal(after[q.key][same], before[q.key][same])
        else:
            found = signed(q.key, after[q.key] * scale**-q.power, before[q.key])
            assert off(found[fair], before[q.key][fair], natural(before, q.key)[fair]) <= ROUNDING, q.key


# ---------------------------------------------------------------------------------------------- sides and parameters


@over_catalogue()
@repeatable
@given(points)
def test_flipping_the_normal_does_to_each_quantity_what_its_row_says(name, at):
    model = SURFACES[name].model
    here, there = surface_of(name), build({**model, "flip": not model.get("flip", False)})
    before, after = sampled(here, at), sampled(there, at)
    for q in QUANTITIES:
        found, expected = after[q.key], before[q.key]
        if q.parity == "odd":
            expected = -expected
        elif q.parity == "swap":
            expected = before[q.partner] if q.colour == "vector" else -before[q.partner]
        elif q.parity == "mirror":
            expected = [mirrored(q.key, int(code)) for code in expected]
        if q.colour == "classes":
            np.testing.assert_array_equal(found, expected, err_msg=q.key)
        else:
            found = signed(q.key, found, expected)
            assert off(found, expected, natural(before, q.key)) <= 1e-14, q.key


@over_catalogue(NETS)
@repeatable
@given(points)
def test_swapping_the_parameters_swaps_the_forms_and_the_side(name, at):
    here = surface_of(name)
    there = Surface(Net(here.rows.points.transpose(1, 0, 2), here.blend), here.rows.functions, not here.flip)
    before, after = sampled(here, at), quintrig.analyse(there, at[1], at[0])
    fair = sound(before)
    partner = {"E": "G", "G": "E", "L": "N", "N": "L"}
    for q in QUANTITIES:
        if q.colour == "classes":
            same = fair & clear(before, q.key)
            np.testing.assert_array_equal(after[q.key][same], before[q.key][same])
        else:
            expected = before[partner.get(q.key, q.key)]
            found = signed(q.key, after[q.key], expected)
            scale = natural(before, partner.get(q.key, q.key))
            assert off(found[fair], expected[fair], scale[fair]) <= ROUNDING, q.key


# ---------------------------------------------------------------------------------------------- relations


@over_catalogue()
@repeatable
@given(points)
def test_curvatures_and_forms_agree_with_each_other(name, at):
    s = sampled(surface_of(name), at)
    k, h, k1, k2, c = (s[key] for key in ("gaussian", "mean", "k1", "k2", "curvedness"))
    ok = ~s.singular
    assert (k1[ok] >= k2[ok]).all()
    assert off(k1 * k2, k, c**2 + 1e-300) <= 1e-14
    assert off((k1 + k2) / 2, h, c + 1e-300) <= 1e-14
    assert off(np.sqrt((k1**2 + k2**2) / 2), c, c + 1e-300) <= 1e-14
    defined = ok & np.isfinite(s["shape_index"])
    plain = -2 / np.pi * np.arctan2(k1 + k2, k1 - k2)
    assert off(s["shape_index"][defined], plain[defined], 1.0 + 0 * c[defined]) <= 1e-14
    away = defined & (k1 > k2)
    textbook = 2 / np.pi * np.arctan((k1 + k2)[away] / (k2 - k1)[away])
    assert off(s["shape_index"][away], textbook, 1.0 + 0 * c[away]) <= 1e-14
    fair = sound(s)
    e, f, g, el, em, en = (s[key][fair] for key in ("E", "F", "G", "L", "M", "N"))
    det = e * g - f * f
    assert off((el * en - em * em) / det, k[fair], natural(s, "gaussian")[fair]) <= ROUNDING
    assert off((e * en - 2 * f * em + g * el) / (2 * det), h[fair], natural(s, "mean")[fair]) <= ROUNDING


@over_catalogue()
@repeatable
@given(points)
def test_normal_and_directions_are_a_frame_in_which_the_shape_operator_is_diagonal(name, at):
    surface = surface_of(name)
    s = sampled(surface, at)
    ok = ~s.singular
    n, d1, d2 = s.normal[ok], s["direction1"][ok], s["direction2"][ok]
    np.testing.assert_allclose(np.linalg.norm(n, axis=-1), 1.0, rtol=0, atol=1e-14)
    there = ~np.isnan(d1).any(axis=-1)
    for a, b, expected in ((d1, d1, 1), (d2, d2, 1), (d1, d2, 0), (d1, n, 0), (d2, n, 0)):
        assert np.abs((a * b).sum(axis=-1)[there] - expected).max(initial=0.0) <= 1e-12
    p = surface.partials(at[0], at[1], 1)
    area = np.cross(p[1, 0], p[0, 1])
    cosine = (area * s.normal).sum(axis=-1) / np.linalg.norm(area, axis=-1)[...].clip(1e-300)
    np.testing.assert_allclose(cosine[sound(s)], surface.sign, rtol=0, atol=1e-12)


@over_catalogue()
@repeatable
@given(points)
def test_invariants_agree_with_each_other_and_with_the_curvatures(name, at):
    s = sampled(surface_of(name), at)
    fair = sound(s) & (np.abs(s.normal[..., 2]) > 0.05)
    if not fair.any():
        return
    c = natural(s, "mean")[fair]
    k, h, nz = s["gaussian"][fair], s["mean"][fair], s.normal[fair][..., 2]
    for suffix in ("", "_surface"):
        b0, b1, b2, g1, g2, g3 = (s[key + suffix][fair] for key in STEEP)
        bend = c / np.abs(nz) ** 3 if not suffix else c
        steep = 1.0 / nz**2 if not suffix else 1.0 + 0 * nz
        assert off(g1 + g3, b0 * b1, bend * steep) <= ROUNDING
        assert off(g1 * g3 - g2**2, b0**2 * b2, (bend * steep) ** 2) <= ROUNDING
        if suffix:
            assert off(b2 / (1 - b0), k, c**2 / nz**2) <= ROUNDING
            assert off(b0, 1 - nz**2, 1.0 + 0 * nz) <= 1e-14
        else:
            assert off(b2 / (1 + b0) ** 2, k, c**2 / nz**2) <= ROUNDING
            upward = np.sign(nz) * h
            assert off((b1 + g3) / (2 * (1 + b0) ** 1.5), upward, c / np.abs(nz) ** 3) <= ROUNDING


@over_catalogue(name for name, entry in SURFACES.items() if entry.ruled)
@repeatable
@given(points)
def test_gaussian_curvature_of_ruled_surfaces(name, at):
    s = sampled(surface_of(name), at)
    ok = ~s.singular
    curved = np.maximum(s["curvedness"], 1e-3 / s.size)[ok]
    relative = s["gaussian"][ok] / curved**2
    assert relative.max(initial=-1.0) <= 1e-14
    if SURFACES[name].developable:
        assert np.abs(relative).max(initial=0.0) <= ROUNDING


# ---------------------------------------------------------------------------------------------- paths


@over_catalogue()
def test_grid_and_scattered_points_agree(name):
    surface = surface_of(name)
    u, v = quintrig.grid(9, 137)
    on_grid = quintrig.analyse(surface, u, v)
    apart = quintrig.analyse(surface, *np.broadcast_arrays(u, v))
    fair = sound(on_grid, 0.01, 0.01)
    np.testing.assert_array_equal(on_grid.singular, apart.singular)
    for q in QUANTITIES:
        if q.colour == "classes":
            same = fair & clear(on_grid, q.key)
            np.testing.assert_array_equal(on_grid[q.key][same], apart[q.key][same])
        else:
            found = signed(q.key, on_grid[q.key], apart[q.key])
            assert off(found[fair], apart[q.key][fair], natural(on_grid, q.key)[fair]) <= 1e-10, q.key
