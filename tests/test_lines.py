"""Lines on surfaces against what is known of them in closed form."""

from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import quintrig
from quintrig import lines

EXAMPLES = Path(__file__).parents[1] / "examples"
A2 = np.array([9.0, 4.0, 1.0])
ELLIPSOID = quintrig.ellipsoid(3, 2, 1)
TORUS = quintrig.torus(3, 1)


def confocal(point):
    """Return the roots μ of Σ x²/(A - μ) = 1, in order: one is constant along each line of curvature."""
    product = np.poly1d([1.0])
    for a in A2:
        product *= np.poly1d([-1.0, a])
    total = product
    for i, x in enumerate(point):
        rest = np.poly1d([1.0])
        for j, a in enumerate(A2):
            if j != i:
                rest *= np.poly1d([-1.0, a])
        total = total - x * x * rest
    return np.sort(total.roots.real)


def test_confocal_coordinates_are_constant_along_lines_of_curvature_across_the_seam():
    found = lines(ELLIPSOID, "curvature", start=(0.6, 0.1))
    assert len({line.chain for line in found}) == 2
    for line in found:
        roots = np.array([confocal(point) for point in line.points[::5]])
        assert np.ptp(roots, axis=0)[1:].min() < 1e-8  # the first is 0: the surface itself
        assert np.ptp(roots, axis=0)[1:].max() > 0.1
    chains = [[line for line in found if line.chain == chain] for chain in (0, 1)]
    for parts in chains:  # each comes back to where it began
        for one, other in zip(parts, [*parts[1:], parts[0]], strict=True):
            assert np.linalg.norm(one.points[-1] - other.points[0]) < 1e-5


def test_a_net_keeps_its_spacing_and_fills_the_surface():
    found = lines(quintrig.enneper(1), "curvature", spacing=0.5)
    for line in found:  # parameter lines are lines of curvature
        assert np.ptp(line.uv, axis=0).min() < 1e-9
    for label in ("κ1", "κ2"):
        places = sorted(float(line.points[0, 0]) for line in found if line.label == label)
        assert len(places) >= 5


@pytest.mark.parametrize("name", ["car_boot", "wavy"])
def test_lines_of_a_net_do_not_run_beside_each_other_nor_beside_themselves(name):
    found = lines(quintrig.load(EXAMPLES / f"{name}.toml"), "curvature")  # some turn back around an umbilic
    spacing = np.linalg.norm(np.ptp(np.concatenate([line.points for line in found]), axis=0)) / 12
    for i, one in enumerate(found):
        for other in found.lines[:i]:
            if one.label == other.label:
                apart = np.linalg.norm(one.points[:, None] - other.points[None], axis=2)
                assert (apart.min(axis=1) < 0.4 * spacing).mean() < 0.7  # ends may meet
        back = (np.abs(one.s[:, None] - one.s[None]) > 2 * spacing) & (not one.closed)
        apart = np.linalg.norm(one.points[:, None] - one.points[None], axis=2)
        assert apart[back].min(initial=np.inf) > 0.4 * spacing


def test_parabolic_circles_of_a_torus():
    found = lines(TORUS, "parabolic")
    assert len(found) == 2
    for line in found:
        assert line.closed
        assert np.abs(np.hypot(*line.points[:, :2].T) - 3.0).max() < 1e-12
        assert line.length == pytest.approx(6 * np.pi, rel=1e-8)
        assert 0.0 < line.chord_error < found.tolerance * 1.01
    assert sorted(round(float(line.points[0, 2]), 12) for line in found) == [-1.0, 1.0]


def velocities(line):
    """Return the speed in (u, v) along a line, away from its ends, by a spline through its points."""
    return CubicSpline(line.s, line.uv)(line.s, 1)[3:-3]


def test_lines_that_cross_in_a_node_of_the_grid_are_found():
    # H = -x y / W³ vanishes on both axes, which meet.
    found = lines(quintrig.hyperbolic_paraboloid(), "mean-zero")
    assert len(found)
    for line in found:
        assert np.abs(line.points[:, 0] * line.points[:, 1]).max() < 1e-9
    wavy = quintrig.load(EXAMPLES / "wavy.toml")
    for line in lines(wavy, "mean-zero"):
        assert np.isfinite(line.points).all()


def test_clairaut_on_a_torus():
    found = lines(TORUS, "geodesic", start=(0.1, 0.2), direction=60, length=20, tolerance=1e-5)
    assert found.length == pytest.approx(20, rel=1e-7)
    assert len(found) > 2
    constant = (3 + np.cos(0.2 * np.pi)) * np.sin(np.radians(60))
    for line in (line for line in found if len(line.s) > 20):
        r = 3 + np.cos(2 * np.pi * line.uv[3:-3, 0])
        assert np.abs(r * r * 2 * np.pi * velocities(line)[:, 1] - constant).max() < 1e-5


def test_joachimsthal_along_geodesics_of_an_ellipsoid():
    found = lines(ELLIPSOID, "geodesic", start=(0.5, 0.1), direction=35, length=6, tolerance=1e-5)
    for line in (line for line in found if len(line.s) > 20):
        p = ELLIPSOID.partials(*line.uv[3:-3].T, 1)
        d = p[1, 0] * velocities(line)[:, :1] + p[0, 1] * velocities(line)[:, 1:]
        plane = np.sum(p[0, 0] ** 2 / A2**2, axis=1)  # 1/p², p the distance of the tangent plane
        along = np.sum(d**2 / A2, axis=1)  # 1/D², D the diameter along the line
        product = plane * along
        if line is found[0]:
            constant = product[0]
        assert np.abs(product / constant - 1).max() < 1e-5


def test_asymptotic_lines_of_z_xy_and_of_the_helicoid():
    for surface in (quintrig.hyperbolic_paraboloid(), quintrig.helicoid(1, 2)):
        found = lines(surface, "asymptotic", start=(0.3, 0.45))
        assert {line.label for line in found} == {"family 1", "family 2"}
        for line in found:  # parameter lines both: rulings, and rulings or helices
            assert np.ptp(line.uv, axis=0).min() < 1e-9
            assert np.ptp(line.uv, axis=0).max() > 0.999


@pytest.mark.parametrize("make", [quintrig.catenoid, quintrig.helicoid, quintrig.enneper])
def test_minimal_surfaces_have_no_line_where_h_vanishes_and_say_so(make):
    found = lines(make(), "mean-zero")
    assert len(found) == 0
    assert any("H = 0 on the whole patch" in note for note in found.notes)


def test_geodesics_of_a_developable_are_straight_in_its_flat_pattern():
    # The cone's pattern is a sector: radius along the ruling, angle shrunk by r / slant.
    cone = quintrig.cone(1, 2)
    slant = np.hypot(1, 2)
    (line,) = lines(cone, "geodesic", start=(0.1, 0.3), direction=70, length=1.5, tolerance=1e-6)
    radius, angle = slant * (1 - line.uv[:, 0]), 2 * np.pi * line.uv[:, 1] / slant
    flat = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    chord = flat[-1] - flat[0]
    away = (flat - flat[0]) @ np.array([-chord[1], chord[0]]) / np.linalg.norm(chord)
    assert np.abs(away).max() < 1e-10
    assert np.linalg.norm(chord) == pytest.approx(1.5, rel=1e-9)


def test_a_geodesic_between_two_points_is_the_great_circle():
    (line,) = lines(quintrig.sphere(2), "geodesic", start=(0.4, 0.1), to=(0.7, 0.4))
    a, b = quintrig.sphere(2)(0.4, 0.1), quintrig.sphere(2)(0.7, 0.4)
    assert line.length == pytest.approx(2 * np.arccos(a @ b / 4), rel=1e-6)
    assert np.linalg.norm(line.points[-1] - b) < 1e-8
    normal = np.cross(a, b)
    assert np.abs(line.points @ normal).max() < 1e-8 * np.linalg.norm(normal)


def test_ridges_of_an_ellipsoid_lie_in_its_planes_of_symmetry():
    found = lines(ELLIPSOID, "ridges")
    assert len(found)
    for line in found:
        assert line.label == "crest"  # n outwards: it bends away from it everywhere
        assert np.abs(line.points).max(axis=0).min() < 1e-6
        assert line.strength > 0


def test_silhouette_isophotes_and_draft_of_a_sphere():
    sphere = quintrig.sphere(2)
    away = lines(sphere, "silhouette", direction=(0, 0, 1))
    assert away.length == pytest.approx(4 * np.pi, rel=1e-7)
    for line in lines(sphere, "isophotes", angles=[30, 60]):
        assert np.abs(line.points[:, 2] - 2 * np.cos(np.radians(line.level))).max() < 1e-12
        assert np.allclose(line.values, line.level)
    for line in lines(sphere, "draft", angles=[30]):
        assert np.abs(line.points[:, 2] - 1.0).max() < 1e-12
    near = lines(sphere, "silhouette", eye=(0, 0, 4))
    assert np.abs(np.concatenate([line.points for line in near])[:, 2] - 1.0).max() < 1e-9


def test_chords_and_ends_keep_the_tolerance_where_lines_nearly_cross_or_cease():
    x = np.arange(6.0)
    bent = np.array([0, 2, -1, 3, 1, 0.5])
    section, trajectory = np.stack([x, 0 * x, bent], axis=1), np.stack([0 * x, x, bent[::-1] - 0.5], axis=1)
    swept = quintrig.swept(section, trajectory)  # K = l n = 0 on lines that cross
    for kind in ("parabolic", "ridges"):
        coarse, fine = (lines(swept, kind, tolerance=tolerance) for tolerance in (2e-3, 2e-5))
        assert len(coarse) == len(fine) > 2
        middles = np.array([line.points[[0, -1]].mean(axis=0) for line in fine])  # the order of mirrored ones is chance
        for one in coarse:
            other = list(fine)[np.linalg.norm(middles - one.points[[0, -1]].mean(axis=0), axis=1).argmin()]
            assert one.length == pytest.approx(other.length, abs=2 * coarse.tolerance)
            step = np.diff(one.points, axis=0)
            gap = other.points[:, None] - one.points[None, :-1]
            share = np.einsum("nmk,mk->nm", gap, step) / np.einsum("mk,mk->m", step, step)
            away = np.linalg.norm(gap - np.clip(share, 0, 1)[..., None] * step, axis=2).min(axis=1)
            assert away.max() <= 1.1 * one.chord_error + 1e-6


def test_sections_by_planes_and_by_a_surface():
    stack = lines(TORUS, "section", normal=(0, 0, 1), spacing=0.5, through=(0, 0, 0))
    inner = [line.level for line in stack if abs(line.level) < 0.9]  # the planes at ±1 only touch it
    assert sorted(inner) == [-0.5, -0.5, 0.0, 0.0, 0.5, 0.5]
    for line in stack:
        assert np.abs(line.points[:, 2] - line.level).max() < 1e-12
    (circle,) = lines(quintrig.sphere(2), "section", other=quintrig.cylinder(1, 2))
    assert circle.length == pytest.approx(2 * np.pi, rel=1e-6)
    assert np.abs(circle.points[:, 2] - np.sqrt(3)).max() < 1e-9


def test_contours_of_any_quantity_and_parameter_lines():
    saddle = quintrig.hyperbolic_paraboloid()
    for line in lines(saddle, "contour", quantity="K", levels=[-0.25]):
        x, y, _ = line.points.T
        assert np.abs(1 + x * x + y * y - 2).max() < 1e-9
    found = lines(saddle, "iso", u=[0.5], v=[])
    assert [line.label for line in found] == ["u = 0.5"]
    assert found.length == pytest.approx(2)


def test_highlight_lines_satisfy_their_equation():
    saddle = quintrig.hyperbolic_paraboloid()
    a, b = np.array([0.3, 0.0, 4.0]), np.array([0.0, 1.0, 0.0])
    found = lines(saddle, "highlight", light=a, along=b, count=1)
    assert len(found)
    for line in found:
        normal = quintrig.analyse(saddle, *line.uv.T, ("normal",))["normal"]
        assert np.abs(np.einsum("nk,nk->n", np.cross(b, normal), a - line.points)).max() < 1e-10


def test_lines_respect_trims():
    net = {"degrees": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0.5]]]}
    loop = [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]
    model = quintrig.Model.from_dict({"kind": "nurbs", **net, "trim": [loop]})
    (line,) = lines(model, "iso", u=[0.5])
    assert line.uv[:, 1].min() == pytest.approx(0.2, abs=1e-9)
    assert line.uv[:, 1].max() == pytest.approx(0.8, abs=1e-9)
    found = lines(model, "section", normal=(1, 0, 0), through=(0.5, 0, 0))
    assert found[0].uv[:, 1].min() == pytest.approx(0.2, abs=1e-6)
    with pytest.raises(ValueError, match="outside its trim"):
        lines(model, "geodesic", start=(0.1, 0.1), direction=0)
    bent = quintrig.Model.from_dict({**sheet(1.0, 3), "trim": [[[0.1, 0.2], [0.9, 0.1], [0.5, 0.8]]]})
    normal = np.array([0.4, 0.5, -1.0]) / np.linalg.norm([0.4, 0.5, -1.0])
    cuts = lines(bent, "section", normal=normal, count=5, tolerance=0.05)
    assert len(cuts) >= 3
    for line in cuts:  # the ends on the loop are on the line too
        assert np.abs(line.points @ normal - line.level).max() < 1e-6


def sheet(side, power):
    """Return z = -x²/2 - 0.3 y² + x y/5, with x^power / 4 more where x > 0, for x from 0 to ``side``, as a patch."""
    from scipy.special import comb

    t = np.linspace(0, 1, 4)
    u, v = t[:, None], t[None, :]
    x, y = side * u + 0 * v, 2 * v - 1 + 0 * u
    z = -0.5 * x**2 - 0.3 * y**2 + 0.2 * x * y + (0.25 * x**power if side > 0 else 0)
    bernstein = np.stack([comb(3, k) * t**k * (1 - t) ** (3 - k) for k in range(4)], axis=1)
    inverse = np.linalg.inv(bernstein)
    points = np.einsum("ia,jb,abk->ijk", inverse, inverse, np.stack([x, y, z], axis=-1))
    if side < 0:
        points = points[::-1]  # S_u along +x on both
    knots = [[0] * 4 + [1] * 4] * 2
    return {"kind": "nurbs", "degrees": [3, 3], "knots": knots, "points": points.tolist()}


@pytest.mark.parametrize(("power", "breaks", "kinks"), [(1, True, True), (2, False, True), (3, False, False)])
@pytest.mark.parametrize("kind", ["reflection", "isophotes"])
def test_reflection_lines_break_at_g0_kink_at_g1_and_are_smooth_across_g2_seams(kind, power, breaks, kinks):
    parts = [{"name": "left", **sheet(-1.0, power)}, {"name": "right", **sheet(1.0, power)}]
    model = quintrig.Model.from_dict({"patch": parts})
    assert model.joins()[0].order in {1: ("G0",), 2: ("G1",), 3: ("G2", "G3")}[power]
    lights = {"count": 4, "light": (0, 0, 5), "along": (1, 0.6, 0), "spacing": 2.0, "direction": (0, 0, 1)}
    options = {"reflection": lights, "isophotes": {"angles": [12, 20, 28]}}
    gaps, angles = [], []
    found = lines(model, kind, tolerance=1e-5, **options[kind])
    for left in (line for line in found if line.patch == "left"):
        for right in (line for line in found if line.patch == "right" and line.label == left.label):
            for i, j in ((0, 0), (0, -1), (-1, 0), (-1, -1)):
                if max(abs(left.points[i, 0]), abs(right.points[j, 0])) > 1e-9:
                    continue
                gap = np.linalg.norm(left.points[i] - right.points[j])
                one, two = (direction(line, k) for line, k in ((left, i), (right, j)))
                gaps.append(gap)
                angles.append(np.degrees(np.arccos(np.clip(-(one @ two), -1, 1))))
    assert len(gaps) >= 2
    near = np.array(gaps) < 1e-7
    if breaks:
        assert not near.any()
    else:
        assert near.sum() >= 2
        worst = np.array(angles)[near]
        assert (worst > 0.5).all() if kinks else (worst < 0.05).all()


def direction(line, end):
    """Return the unit vector into a line at one of its ends."""
    step = CubicSpline(line.s, line.points)(line.s[end], 1) * (1 if end == 0 else -1)
    return step / np.linalg.norm(step)


def test_lines_of_curvature_and_geodesics_run_on_across_seams_even_where_normals_turn():
    right = sheet(1.0, 3)
    right["flip"] = True
    model = quintrig.Model.from_dict({"patch": [{"name": "left", **sheet(-1.0, 3)}, {"name": "right", **right}]})
    found = lines(model, "curvature", patch="left", start=(0.6, 0.55))
    crossing = [
        (one, other)
        for one in found
        for other in found
        if one.patch == "left" and other.patch == "right" and one.chain == other.chain
    ]
    assert crossing
    for one, other in crossing:
        assert np.linalg.norm(one.points[:, None] - other.points[None], axis=-1).min() < 1e-9
        assert one.label != other.label  # κ1 is -κ2 on the other side
    (one, other) = lines(model, "geodesic", patch="left", start=(0.5, 0.5), to=(0.5, 0.6), to_patch="right")
    assert np.linalg.norm(other.points[-1] - model.patch("right").surface(0.5, 0.6)) < 1e-8
    assert one.chain == other.chain


@pytest.mark.parametrize(
    ("kind", "options", "words"),
    [
        ("curvatures", {}, "did you mean 'curvature'"),
        ("section", {}, "normal: expected the normal"),
        ("section", {"normal": (0, 0, 0)}, "expected a vector with a length"),
        ("section", {"normal": (0, 0, 1), "spacing": 1e-12}, "of at most 1,000"),
        ("curvature", {"spacing": 1e-9}, "of at most 1,000"),
        ("curvature", {"spacing": -1}, "greater than 0"),
        ("curvature", {"start": (0.5, 2)}, "outside the domain"),
        ("curvature", {"direction": (0, 0, 1)}, "not this"),
        ("curvature", {"length": 1e12, "start": (0.1, 0.1)}, "at most 1000 times the size"),
        ("asymptotic", {"start": (0.1, 0.1), "family": 3}, "expected 1 or 2"),
        ("geodesic", {"direction": 0}, "start: expected parameters"),
        ("geodesic", {"start": (0.5, 0.5)}, "direction: expected degrees"),
        ("geodesic", {"start": (0.5, 0.5), "to": (0.5, 0.5)}, "the same one"),
        ("contour", {}, "quantity: expected"),
        ("contour", {"quantity": "normal"}, "a vector"),
        ("silhouette", {}, "direction: expected a vector"),
        ("isophotes", {"angles": [200]}, "from 0 to 180"),
        ("iso", {"u": [1.5]}, "outside the domain"),
        ("parabolic", {"tolerance": 0}, "greater than 0"),
    ],
)
def test_mistakes_are_told_in_one_line(kind, options, words):
    with pytest.raises(ValueError, match=words) as caught:
        lines(TORUS, kind, **options)
    assert "\n" not in str(caught.value)


def test_nets_end_where_directions_do():
    assert "every point is an umbilic" in lines(quintrig.sphere(), "curvature").notes[0]
    for line in lines(quintrig.cone(), "curvature", spacing=1.0):  # rulings end at the apex
        assert np.ptp(line.uv, axis=0).min() < 1e-9
    for line in lines(TORUS, "asymptotic", spacing=4.0):  # they reach the parabolic circles
        assert np.hypot(*line.points[:, :2].T).max() < 3 + 1e-9


def test_seeds_on_umbilics_poles_and_where_there_is_no_direction_are_refused():
    with pytest.raises(ValueError, match="is an umbilic"):
        lines(quintrig.sphere(), "curvature", start=(0.4, 0.4))
    with pytest.raises(ValueError, match="singular point"):
        lines(quintrig.sphere(), "geodesic", start=(0.0, 0.4), direction=0)
    with pytest.raises(ValueError, match="only where K < 0"):
        lines(TORUS, "asymptotic", start=(0.0, 0.4))
