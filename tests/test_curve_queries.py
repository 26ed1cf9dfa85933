"""What a curve tells about itself, against exact values, brute force and invariance."""

import math

import numpy as np
import pytest

from quintrig.geometry.curve import Curve
from quintrig.geometry.curve_joins import interpolate, join_curves
from quintrig.geometry.curve_pieces import offset_curve, split_curve
from quintrig.geometry.roots import roots

PLANE = Curve([[0, 0], [1, 4], [3, -3], [5, 4], [7, -3], [8, 1]], 0.3, -0.7)
SPACE = Curve([[0, 0, 0], [1, 4, 1], [3, -3, 3], [5, 4, -2], [7, -3, 4], [8, 1, 0]], 0.3, -0.7)
PARABOLA = Curve([[-1, 1], [0, -1], [1, 1]], basis="bernstein")  # (2t - 1, (2t - 1)²)
CUBIC = Curve([[-1, -1], [-1 / 3, 1], [1 / 3, -1], [1, 1]], basis="bernstein")  # (x, x³), x = 2t - 1
T = np.linspace(0.0, 1.0, 41)


def test_all_roots_are_found() -> None:
    """Close pairs, double roots and roots at the ends are all there."""
    for wanted in ([0.0, 0.3, 1.0], [0.4, 0.4001], [0.12345, 0.5, 0.50003, 0.9]):
        found = roots(lambda t, wanted=wanted: np.prod([t - x for x in wanted], axis=0))
        assert found == pytest.approx(wanted, abs=1e-10)
    assert roots(lambda t: (t - 0.3) ** 2 * (t - 0.8)) == pytest.approx([0.3, 0.8], abs=1e-6)
    assert roots(lambda t: (t - 0.3) ** 2 + 1e-6).size == 0
    assert roots(np.zeros_like).size == 0


@pytest.mark.parametrize("curve", [PLANE, SPACE])
def test_frame_is_orthonormal_and_obeys_frenet(curve: Curve) -> None:
    """The frame's rows are orthonormal and right-handed, and T' = |z'| κ N."""
    frame = curve.frame(T[1:-1])
    size = frame.shape[-1]
    assert frame @ np.swapaxes(frame, -1, -2) == pytest.approx(np.broadcast_to(np.eye(size), frame.shape), abs=1e-13)
    assert np.linalg.det(frame) == pytest.approx(np.ones(len(frame)))
    step = 1e-5
    slope = (curve.tangent(T[1:-1] + step) - curve.tangent(T[1:-1] - step)) / (2 * step)
    speed = np.linalg.norm(curve.derivatives(T[1:-1], 1)[1], axis=-1)
    bend = curve.signed_curvature(T[1:-1]) if size == 2 else curve.curvature(T[1:-1])
    assert slope == pytest.approx((speed * bend)[:, None] * frame[:, 1], rel=1e-5, abs=1e-5)


def test_tangent_at_an_end_that_stands_still() -> None:
    """With α = -4 the tangent at 0 is the limit, as just beside it."""
    still = Curve(PLANE.points, -4.0, 0.0)
    assert still.tangent(0.0) == pytest.approx(still.tangent(1e-7), abs=1e-5)


@pytest.mark.parametrize("curve", [PLANE, SPACE, Curve(PLANE.points, -4.0, 0.5)])
def test_parameter_at_inverts_length(curve: Curve) -> None:
    """The arc length to the parameter found is the length asked for."""
    total = curve.length()
    wanted = total * np.array([0.0, 1e-6, 0.1, 0.37, 0.5, 0.99, 1.0])
    found = curve.parameter_at(wanted)
    assert [curve.length(0.0, t) for t in found] == pytest.approx(wanted, abs=1e-11 * total)
    with pytest.raises(ValueError, match="length: expected 0 to"):
        curve.parameter_at(1.01 * total)


def test_bending_energy_with_a_still_end_takes_few_points(monkeypatch) -> None:
    """∫ κ² ds of a curve that stands still is found infinite soon, in bases from formulas too, and not by chance."""
    asked: list[int] = []
    curvature = Curve.curvature
    monkeypatch.setattr(Curve, "curvature", lambda self, t: asked.append(np.size(t)) or curvature(self, t))
    for shape in ([-2, -2], [1, -2], [-2, 1]):
        points = [[0, 33.659], [33.333, 28.936], [66.667, -19.995], [100, -38.357]]
        assert Curve(points, basis="cubic", shape=shape).bending_energy() == np.inf
    assert Curve([[0, 0], [0, 0], [1, 0], [1, 1]], basis="bernstein").bending_energy() == np.inf  # u²(3, u): κ ~ 1/u
    assert sum(asked) < 4 * 16 * 2 * 400
    assert Curve([[0, 0], [1, 1], [2, 2]], basis="bernstein").bending_energy() == 0.0


def test_parabola_in_closed_form() -> None:
    """(x, x²): curvature extreme 2 at the vertex, ∫ κ² ds, area under, closest point."""
    assert PARABOLA.curvature_extremes() == pytest.approx([0.5], abs=1e-9)
    assert PARABOLA.inflections().size == 0
    a = 2.0 * 1.0  # p = 2x runs to 2; ∫ 2 dp / (1 + p²)^(5/2) from -2 to 2
    exact = 2.0 * 2.0 * (a / (3.0 * (1 + a * a) ** 1.5) + 2.0 * a / (3.0 * math.sqrt(1 + a * a)))
    assert PARABOLA.bending_energy() == pytest.approx(exact, rel=1e-12)
    assert PARABOLA.area_under() == pytest.approx(2.0 / 3.0, rel=1e-14)
    near = PARABOLA.closest([0.0, 2.0])  # x² = 3/2 lies outside, so an end is closest
    assert near.distance == pytest.approx(math.sqrt(2.0))
    assert PARABOLA.closest([0.0, 1.0]).distance == pytest.approx(math.sqrt(0.75), rel=1e-12)


def test_cubic_in_closed_form() -> None:
    """(x, x³): one inflection, at 0; |κ| extreme at x⁴ = 1/45."""
    assert CUBIC.inflections() == pytest.approx([0.5], abs=1e-12)
    x = (1.0 / 45.0) ** 0.25
    assert CUBIC.curvature_extremes() == pytest.approx([0.5 - x / 2, 0.5 + x / 2], abs=1e-10)
    assert CUBIC.meets_line([0, 0], [1, 0.25]) == pytest.approx([0.25, 0.5, 0.75], abs=1e-12)
    assert CUBIC.meets_plane([3, -1, -2]) == pytest.approx([1.0], abs=1e-6)  # touches at x = 1: t = 1


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("dimension", [2, 3])
def test_queries_against_brute_force(seed: int, dimension: int) -> None:
    """No sample is closer than the closest point; signs of height and bend change exactly at what was found."""
    random = np.random.default_rng(seed)
    curve = Curve(random.normal(size=(6, dimension)), *random.uniform(-3.9, 1.0, 2))
    t = np.linspace(0.0, 1.0, 20001)
    points = curve(t)
    for target in random.normal(size=(5, dimension)):
        near = curve.closest(target)
        assert near.distance <= np.linalg.norm(points - target, axis=-1).min() + 1e-14
        assert curve(near.t) == pytest.approx(near.point)
    plane = np.append(random.normal(size=dimension), 0.1)
    heights = points @ plane[:-1] + plane[-1]
    assert len(curve.meets_plane(plane)) == np.count_nonzero(heights[:-1] * heights[1:] < 0.0)
    value = curve.signed_curvature(t) if dimension == 2 else curve.curvature(t)
    slopes = np.diff(value)
    turning = np.count_nonzero(slopes[:-1] * slopes[1:] < 0.0)
    assert len(curve.curvature_extremes()) == turning
    if dimension == 2:
        assert len(curve.inflections()) == np.count_nonzero(value[:-1] * value[1:] < 0.0)


def test_line_in_space() -> None:
    """A line through two points of a curve meets it in both; one beside it, nowhere."""
    a, b = SPACE(0.2), SPACE(0.7)
    assert SPACE.meets_line(a, b - a) == pytest.approx([0.2, 0.7], abs=1e-8)
    assert SPACE.meets_line(a + np.array([0, 0, 50]), [1, 0, 0]).size == 0


def test_moments_of_a_closed_curve() -> None:
    """Area and moments of four quarter circles' worth of curve: against the polygon of many points; and they move."""
    closed = Curve([[0, 0], [4, -1], [5, 3], [2, 6], [-2, 3], [0, 0]], 0.5, -1.0)
    found = closed.moments()
    x, y = closed(np.linspace(0.0, 1.0, 200001)).T
    turn = x[:-1] * y[1:] - x[1:] * y[:-1]
    area = 0.5 * turn.sum()
    assert found.area == pytest.approx(area, rel=1e-9)
    assert found.centroid[0] == pytest.approx(((x[:-1] + x[1:]) * turn).sum() / (6 * area), rel=1e-8)
    xx = ((x[:-1] ** 2 + x[:-1] * x[1:] + x[1:] ** 2) * turn).sum() / 12 - area * found.centroid[0] ** 2
    assert found.xx == pytest.approx(xx, rel=1e-7)
    far = Curve(closed.points + 1e6, 0.5, -1.0).moments()
    assert (far.area, far.xx, far.xy) == pytest.approx((found.area, found.xx, found.xy), rel=1e-8)
    with pytest.raises(ValueError, match="closed"):
        PLANE.moments()


def test_split() -> None:
    """Bernstein curves split exactly; trigonometric ones within the error that is told."""
    exact = split_curve(CUBIC, 0.3)
    assert exact.error == 0.0
    assert exact.curves[0](T) == pytest.approx(CUBIC(0.3 * T), abs=1e-15)
    assert exact.curves[1](T) == pytest.approx(CUBIC(0.3 + 0.7 * T), abs=1e-15)
    fitted = split_curve(PLANE, 0.4)
    assert 0.0 < fitted.error < 0.05
    for piece in fitted.curves:
        assert max(PLANE.closest(p).distance for p in piece(T)) <= 1.1 * fitted.error
    with pytest.raises(ValueError, match="t: expected"):
        split_curve(PLANE, 1.0)


def test_offset_keeps_its_distance() -> None:
    """Every point of the offset is at the distance from the curve, within the error; too far is refused."""
    arch = Curve([[0, 0], [2, 3], [4, 5], [6, 5], [8, 3], [10, 0]])
    result = offset_curve(arch, -1.0, 1e-4)
    assert result.error <= 1e-4
    for piece in result.curves:
        for point in piece(T[1:-1:4]):
            assert arch.closest(point).distance == pytest.approx(1.0, abs=2e-4)
    with pytest.raises(ValueError, match="radius of curvature"):
        offset_curve(arch, -1e3)


def _slope(curve: Curve, t: float) -> float:
    """Return |dκ/ds|, from derivatives to order 3."""
    _, a, b, c = curve.derivatives(t, 3)
    cross = np.cross(a, b)
    size = np.linalg.norm(cross)
    v = np.linalg.norm(a)
    return float(((cross @ np.cross(a, c)) / size / v**3 - 3 * size * (a @ b) / v**5) / v)


@pytest.mark.parametrize("ratio", [0.6, 1.0, 2.3])
def test_joins(ratio: float) -> None:
    """G1 shares the tangent, G2 the curvature vector whatever μ, G3 alone the slope of the curvature."""
    second = Curve(SPACE.points[::-1] * 0.7, -0.4, 0.2)
    for order, free in (("G1", 0.0), ("G2", 0.0), ("G2", 1.7), ("G3", 0.0)):
        joined = join_curves(SPACE, second, order, ratio, free)  # pyright: ignore[reportArgumentType]
        assert joined(0.0) == pytest.approx(SPACE(1.0))
        assert joined.tangent(0.0) == pytest.approx(SPACE.tangent(1.0), abs=1e-12)
        speeds = [np.linalg.norm(c.derivatives(t, 1)[1]) for c, t in ((joined, 0.0), (SPACE, 1.0))]
        assert speeds[0] / speeds[1] == pytest.approx(ratio)
        if order != "G1":
            assert joined.curvature(0.0) == pytest.approx(SPACE.curvature(1.0), rel=1e-11)
            assert joined.binormal(0.0) == pytest.approx(SPACE.binormal(1.0), abs=1e-11)
        agree = math.isclose(_slope(joined, 0.0), _slope(SPACE, 1.0), rel_tol=1e-10)
        assert agree == (order == "G3")


@pytest.mark.parametrize(
    ("basis", "count", "shape"),
    [("bernstein", 5, None), ("cubic", 5, None), ("alpha_bernstein", 5, [0.5]), ("c_bezier", 4, [1.0])],
)
def test_joins_in_any_basis(basis: str, count: int, shape: list[float] | None) -> None:
    """Bases answer for their ends: tangent, curvature vector and the slope of the curvature go on."""
    basis = "quartic" if basis == "cubic" else basis
    second = Curve(np.random.default_rng(0).normal(size=(count, 3)), basis=basis, shape=shape)
    for first in (SPACE, Curve(SPACE.points[:count], basis=basis, shape=shape)):
        for order in ("G1", "G2", "G3"):
            if order == "G3" and (count == 4 or (basis == "quartic" and first is not SPACE)):
                continue
            joined = join_curves(first, second, order, 0.7, 0.3)  # pyright: ignore[reportArgumentType]
            assert joined(0.0) == pytest.approx(first(1.0))
            assert joined.tangent(0.0) == pytest.approx(first.tangent(1.0), abs=1e-12)
            if order != "G1":
                assert joined.curvature(0.0) == pytest.approx(first.curvature(1.0), rel=1e-10)
                assert joined.binormal(0.0) == pytest.approx(first.binormal(1.0), abs=1e-10)
            if order == "G3":
                assert _slope(joined, 0.0) == pytest.approx(_slope(first, 1.0), rel=1e-8)


def test_a_split_is_exact_wherever_the_space_is_one_of_polynomials() -> None:
    """Ali's cubic and q-Bernstein hold the parts of their own curves, as Bernstein does; λ-Bézier does not."""
    points = SPACE.points[:4]
    for basis, shape in (("ali_cubic", [1.5, 2.5]), ("q_bernstein", [0.6]), ("alpha_bernstein", [0.3])):
        curve = Curve(points, basis=basis, shape=shape)
        pieces = split_curve(curve, 0.3)
        assert pieces.error == 0.0
        assert pieces.curves[0](0.5) == pytest.approx(curve(0.15), abs=1e-12)
        assert pieces.curves[1](0.5) == pytest.approx(curve(0.65), abs=1e-12)
    assert split_curve(Curve(points, basis="lambda_bezier", shape=[0.5]), 0.3).error > 0.0


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("closed", [False, True])
def test_interpolation_is_g2(dimension: int, closed: bool) -> None:
    """Curves meet every point, and neighbours share tangent and curvature vector."""
    points = np.random.default_rng(3).normal(size=(7, dimension))
    curves = interpolate(points, closed, alpha=0.4, zeta=-1.1)
    assert len(curves) == (7 if closed else 6)
    assert np.array([c.points[0] for c in curves]) == pytest.approx(points[: len(curves)])
    pairs = list(zip(curves, curves[1:] + (curves[:1] if closed else ()), strict=False))
    assert len(pairs) == (7 if closed else 5)
    for one, other in pairs:
        assert one(1.0) == pytest.approx(other(0.0))
        assert one.tangent(1.0) == pytest.approx(other.tangent(0.0), abs=1e-12)
        kind = Curve.signed_curvature if dimension == 2 else Curve.curvature
        assert kind(one, 1.0) == pytest.approx(kind(other, 0.0), rel=1e-10, abs=1e-12)
    again = interpolate(np.vstack([points, points[:1]]), closed=True)
    assert len(again) == 7
    with pytest.raises(ValueError, match=r"points\[1\]"):
        interpolate([[0, 0], [0, 0], [1, 1]])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: join_curves(PLANE, PLANE, "G5"), "order"),
        (lambda: join_curves(PLANE, SPACE), "dimensions"),
        (lambda: join_curves(PLANE, PLANE, ratio=-1.0), "ratio"),
        (lambda: join_curves(PLANE, Curve(PLANE.points, -4.0)), "-4"),
        (lambda: join_curves(PLANE, Curve([[0, 0], [1, 1]], basis="bernstein")), "more than 2 control points"),
        (lambda: PLANE.closest([0, 0, 0]), "point"),
        (lambda: PLANE.meets_plane([0, 0, 1]), "normal"),
        (lambda: PLANE.binormal(0.5), "space"),
        (SPACE.area_under, "plane"),
        (lambda: interpolate([[0, 0]]), "points"),
    ],
)
def test_mistakes_are_named(call, message) -> None:  # pyright: ignore
    """One line with place and remedy."""
    with pytest.raises(ValueError, match=message) as error:
        call()
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("basis", "points"),
    [("cubic", [[1, 0], [1, 0.5], [0.5, 1], [0, 1]]), ("quadratic", [[1, 0], [1, 1], [0, 1]])],
)
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_an_exact_circle_has_neither_inflections_nor_extremes_of_curvature(basis, points, turn):
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    plane = Curve(np.array(points) @ rotation.T, basis=basis, shape=(0, 0))
    space = Curve(np.column_stack([plane.points, plane.points @ [0.3, 0.4]]), basis=basis, shape=(0, 0))
    assert plane.inflections().size == plane.curvature_extremes().size == 0
    assert space.inflections().size == 0
    asked = []
    roots(lambda t: asked.append(t.size) or 1.0 + 1e-16 * np.sin(1e5 * t))
    assert len(asked) == 1  # rounding of a constant is not searched
