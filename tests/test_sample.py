"""How ``analyse`` works through parameters: shapes, sizes, threads, outputs, and the classes it decides."""

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import quintrig
from catalogue import SHAPES, SURFACES, wave
from closeness import natural, off, sound
from quintrig import Thresholds
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.bspline import clamped
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.surface import Net
from quintrig.quantities.table import BY_KEY, CLASSES, QUANTITIES, SCALARS
from quintrig.support.arrays import aligned

NAMES = ("tensor (0.5, -1.5, -3.25, 0.9)", "ruled (0.0, 0.0, 0.0, 0.0)", "developable oblique", "nurbs", "torus")
every_name = pytest.mark.parametrize("name", NAMES)


@pytest.fixture
def surface():
    return SURFACES[NAMES[0]].surface()


def scattered(count, seed=0):
    return np.random.default_rng(seed).random((2, count))


def assert_equal(one, two, keys=BY_KEY):
    for key in keys:
        np.testing.assert_array_equal(one[key], two[key], err_msg=key)


# ---------------------------------------------------------------------------------------------- shapes and sizes


def test_grid_is_an_open_mesh_over_the_domain():
    u, v = quintrig.grid(5, 9)
    assert u.shape == (5, 1)
    assert v.shape == (1, 9)
    np.testing.assert_array_equal(u[:, 0], [0, 0.25, 0.5, 0.75, 1])
    assert (v[0, 0], v[0, -1]) == (0.0, 1.0)


@every_name
@pytest.mark.parametrize(
    ("u", "v", "shape"),
    [
        (0.5, 0.25, ()),
        (1, 0, ()),
        ([0.5], 0.25, (1,)),
        ([0.1, 0.2, 0.3], [0.3, 0.2, 0.1], (3,)),
        ([[0.5]], [[0.25]], (1, 1)),
        ([[0.1], [0.2]], [[0.3, 0.4, 0.5]], (2, 3)),
        ([[0.1, 0.2, 0.3]], [[0.4], [0.5]], (2, 3)),
        ([[0.1, 0.2]], [[0.4, 0.5]], (1, 2)),
        (np.full((2, 1, 1), 0.5), np.full((1, 3, 4), 0.5), (2, 3, 4)),
        ([], [], (0,)),
        (np.zeros((0, 1)), np.zeros((1, 4)), (0, 4)),
        (np.zeros((3, 1)), np.zeros((1, 0)), (3, 0)),
        (np.zeros((0, 1)), np.zeros((1, 0)), (0, 0)),
        (np.zeros((2, 0, 3)), 0.5, (2, 0, 3)),
    ],
)
def test_results_have_the_broadcast_shape(name, u, v, shape):
    sample = quintrig.analyse(SURFACES[name].surface(), u, v)
    assert sample.shape == shape
    assert set(sample.values) == set(BY_KEY)
    for q in QUANTITIES:
        assert sample[q.key].shape == (shape if q.components == 1 else (*shape, 3)), q.key
        assert sample[q.key].dtype == (np.int8 if q.colour == "classes" else np.float64)
    assert sample.singular.shape == shape
    assert sample.singular.dtype == bool


@every_name
def test_every_point_gives_what_it_gives_alone(name):
    surface = SURFACES[name].surface()
    u, v = scattered(7)
    together = quintrig.analyse(surface, u, v)
    for k in range(7):
        alone = quintrig.analyse(surface, u[k], v[k])
        for key in BY_KEY:
            np.testing.assert_array_equal(alone[key], together[key][k], err_msg=key)


@every_name
@pytest.mark.parametrize("count", [1, 127, 128, 129, 500, 16383, 16384, 16385])
def test_counts_that_fill_no_block(name, count):
    surface = SURFACES[name].surface()
    u, v = scattered(16385)
    keys = ("gaussian", "normal", "hk_type", "gamma2")
    whole = quintrig.analyse(surface, u, v, keys)
    part = quintrig.analyse(surface, u[:count], v[:count], keys)
    for key in keys:
        np.testing.assert_array_equal(part[key], whole[key][:count])


@every_name
@pytest.mark.parametrize(("nu", "nv"), [(1, 1), (1, 200), (200, 1), (2, 129), (129, 2), (3, 128)])
def test_grids_that_fill_no_block(name, nu, nv):
    surface = SURFACES[name].surface()
    u, v = scattered(200)
    whole = quintrig.analyse(surface, u[:, None], v[None, :])
    part = quintrig.analyse(surface, u[:nu, None], v[None, :nv])
    fair = sound(part)
    for key in ("mean", "point", "normal", "shape_index", "gamma2_surface"):
        assert off(part[key][fair], whole[key][:nu, :nv][fair], natural(part, key)[fair]) <= 1e-13, key
    np.testing.assert_array_equal(part["hk_type"], whole["hk_type"][:nu, :nv])


@every_name
def test_layout_and_kind_of_the_parameters_do_not_matter(name):
    surface = SURFACES[name].surface()
    u, v = scattered(300)
    plain = quintrig.analyse(surface, u, v)
    assert_equal(plain, quintrig.analyse(surface, np.repeat(u, 2)[::2], np.flip(v)[::-1]))
    assert_equal(plain, quintrig.analyse(surface, u.tolist(), tuple(v)))
    square = quintrig.analyse(surface, np.asfortranarray(u.reshape(20, 15)), v.reshape(20, 15))
    for key in BY_KEY:
        np.testing.assert_array_equal(square[key].reshape(plain[key].shape), plain[key])
    halves = np.array([0.0, 0.5, 1.0])
    assert_equal(quintrig.analyse(surface, halves, 0.5), quintrig.analyse(surface, halves.astype(np.float32), 0.5))
    assert_equal(quintrig.analyse(surface, [0.0, 1.0], 0.5), quintrig.analyse(surface, np.array([0, 1], np.uint8), 0.5))


@every_name
def test_order_of_the_points_does_not_matter(name):
    surface = SURFACES[name].surface()
    u, v = scattered(1000)
    there, back = quintrig.analyse(surface, u, v), quintrig.analyse(surface, u[::-1], v[::-1])
    for key in BY_KEY:
        np.testing.assert_array_equal(there[key], back[key][::-1])


def test_parameters_are_left_alone(surface):
    u, v = scattered(50)
    before = u.copy(), v.copy()
    sample = quintrig.analyse(surface, u, v)
    np.testing.assert_array_equal(u, before[0])
    np.testing.assert_array_equal(v, before[1])
    np.testing.assert_array_equal(sample.u, u)


# ---------------------------------------------------------------------------------------------- quantities


@every_name
@pytest.mark.parametrize("key", BY_KEY)
def test_a_quantity_alone_is_what_it_is_among_all(name, key):
    surface = SURFACES[name].surface()
    for u, v in (scattered(60), quintrig.grid(7, 9)):
        among, alone = quintrig.analyse(surface, u, v), quintrig.analyse(surface, u, v, key)
        assert set(alone.values) == {key}
        np.testing.assert_array_equal(alone.singular, among.singular)
        if BY_KEY[key].colour == "classes":
            np.testing.assert_array_equal(alone[key], among[key])
        else:
            fair = sound(among)
            assert off(alone[key][fair], among[key][fair], natural(among, key)[fair]) <= 1e-13


def test_only_what_is_asked_for_is_there(surface):
    sample = quintrig.analyse(surface, 0.5, 0.5, ["mean", "k1"])
    assert list(sample.values) == ["mean", "k1"]
    with pytest.raises(KeyError, match="'gaussian' was not computed; ask analyse for it"):
        sample["gaussian"]
    with pytest.raises(ValueError, match="did you mean 'gaussian'"):
        sample["gausian"]
    with pytest.raises(TypeError):
        sample.values["mean"] = 1.0
    assert list(quintrig.analyse(surface, 0.5, 0.5, ()).values) == []
    assert list(quintrig.analyse(surface, 0.5, 0.5, iter(["mean", "mean"])).values) == ["mean"]


def test_singular_points_are_told_whatever_was_asked_for():
    sphere = quintrig.sphere()
    u = np.array([0.0, 0.3, 1.0])
    for keys in ("mean", "gaussian", "point", "hk_type", ()):
        np.testing.assert_array_equal(quintrig.analyse(sphere, u, 0.1, keys).singular, [True, False, True])


def wide(rows, columns):
    """A B-spline surface of so many rows that no driver unrolls over them, or so few that one does."""
    along, across = (clamped(np.linspace(0, 1, count - 2), 3, 1) for count in (rows, columns))
    x, y = np.meshgrid(np.linspace(0, 3, rows), np.linspace(0, 2, columns), indexing="ij")
    return quintrig.Surface(Net(np.stack([x, y, np.sin(x) * np.cos(2 * y)], axis=-1), along), across)


@pytest.mark.parametrize("size", [(5, 31), (31, 5), (31, 31), (12, 12), (13, 13)])
def test_surfaces_of_any_number_of_rows_take_the_same_values_on_grids_and_points(size):
    surface = wide(*size)
    u, v = quintrig.grid(9, 70)
    grid = quintrig.analyse(surface, u, v, threads=2)
    points = quintrig.analyse(surface, *(array.copy() for array in np.broadcast_arrays(u, v)))
    partials = surface.partials(*np.broadcast_arrays(u, v), 2)
    np.testing.assert_allclose(grid.point, partials[0, 0], rtol=0, atol=1e-14)
    np.testing.assert_allclose(grid["E"], (partials[1, 0] ** 2).sum(axis=-1), rtol=1e-12)
    cross = np.cross(partials[1, 0], partials[0, 1])
    normal = cross / np.linalg.norm(cross, axis=-1, keepdims=True)
    np.testing.assert_allclose(grid.normal, normal, rtol=0, atol=1e-13)
    np.testing.assert_allclose(grid["M"], (partials[1, 1] * normal).sum(axis=-1), rtol=0, atol=1e-11)
    for key in ("gaussian", "mean", "curvedness", "beta1", "gamma2_surface"):
        scale = np.abs(grid[key]).max()
        np.testing.assert_allclose(points[key], grid[key], rtol=0, atol=1e-11 * scale, err_msg=key)


def test_a_single_row_or_column_is_a_curve_and_singular_everywhere():
    points = np.random.default_rng(1).normal(size=(6, 1, 3))
    one_row = quintrig.Surface(Net(points, Trigonometric()), Bernstein(0))
    one_column = quintrig.Surface(Net(points.transpose(1, 0, 2), Bernstein(0)), Trigonometric())
    for surface, (u, v) in ((one_row, (0.2, 0.7)), (one_column, (0.7, 0.2))):
        for sample in (quintrig.analyse(surface, [[u]], [[v]]), quintrig.analyse(surface, [u], [v])):
            assert sample.singular.all()
            np.testing.assert_allclose(sample.point.ravel(), surface(u, v), rtol=0, atol=1e-14)


# ---------------------------------------------------------------------------------------------- threads


class Failing:
    """Rows that cannot be evaluated beyond the first points."""

    size, dimension = 30, 3

    def derivatives(self, u, order):
        u = np.asarray(u)
        if ((u > 0.99) & (u < 0.999)).any():  # none of the few points that the size is taken from
            raise MemoryError("no room")
        return np.zeros((order + 1, *u.shape, self.size, 3))


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_a_failure_in_any_thread_is_told(threads):
    surface = quintrig.Surface(Failing(), Bernstein(29))
    u = np.linspace(0, 1, 100_000)
    with pytest.raises(MemoryError, match="no room"):
        quintrig.analyse(surface, u, u, "mean", threads=threads)


@every_name
def test_threads_change_nothing(name):
    surface = SURFACES[name].surface()
    for u, v in (quintrig.grid(61, 77), scattered(40000)):
        keys = ("gaussian", "mean", "normal", "direction1", "beta1", "hk_type")
        one = quintrig.analyse(surface, u, v, keys, threads=1)
        for threads in (2, 3, 200):
            assert_equal(one, quintrig.analyse(surface, u, v, keys, threads=threads), keys)
        assert_equal(one, quintrig.analyse(surface, u, v, keys), keys)


def test_many_analyses_at_once_do_not_disturb_each_other():
    surfaces = [SURFACES[name].surface() for name in NAMES] * 4
    u, v = quintrig.grid(64, 65)
    alone = [quintrig.analyse(s, u, v, threads=1)["mean"] for s in surfaces]
    with ThreadPoolExecutor(8) as pool:
        together = list(pool.map(lambda s: quintrig.analyse(s, u, v, threads=2)["mean"], surfaces))
    for one, two in zip(alone, together, strict=True):
        np.testing.assert_array_equal(one, two)


# ---------------------------------------------------------------------------------------------- outputs


@every_name
@pytest.mark.parametrize("shape", [(), (150,), (10, 15), (2, 3, 5), "grid"])
def test_results_can_be_written_into_given_arrays(name, shape):
    surface = SURFACES[name].surface()
    if shape == "grid":
        (u, v), shape = quintrig.grid(10, 140), (10, 140)
    else:
        u, v = np.random.default_rng(1).random((2, *shape))
    keys = ("gaussian", "shape_index", "hk_type", "normal")
    out = {"gaussian": np.full(shape, 7.0), "hk_type": np.full(shape, 77, np.int8)}
    sample = quintrig.analyse(surface, u, v, keys, out=out)
    assert_equal(sample, quintrig.analyse(surface, u, v, keys), keys)
    for key, array in out.items():
        assert np.shares_memory(sample[key], array)
        np.testing.assert_array_equal(array, sample[key])


def locked(array):
    array.setflags(write=False)
    return array


UNFIT = {
    "shape": ("mean", np.zeros((3, 3))),
    "kind": ("mean", np.zeros((3, 4), dtype=np.float32)),
    "layout": ("mean", np.zeros((4, 3)).T),
    "read-only": ("mean", locked(np.zeros((3, 4)))),
    "class as float": ("hk_type", np.zeros((3, 4))),
    "vector": ("normal", np.zeros((3, 4, 3))),
}


@pytest.mark.parametrize("what", UNFIT)
def test_unfit_outputs_are_refused(surface, what):
    key, array = UNFIT[what]
    with pytest.raises(ValueError, match=rf"out\['{key}'\]: expected a writable (float64|int8) array of shape"):
        quintrig.analyse(surface, *quintrig.grid(3, 4), [key], out={key: array})


def test_the_arrays_of_a_sample_can_be_used_again(surface):
    other = SURFACES["torus"].surface()
    u, v = quintrig.grid(5, 7)
    first = quintrig.analyse(surface, u, v)
    kept = {key: array.copy() for key, array in first.values.items()}
    again = quintrig.analyse(other, u, v, out=first.values)
    assert_equal(again, quintrig.analyse(other, u, v))
    assert any(not np.array_equal(kept[key], again[key], equal_nan=True) for key in kept)
    assert all(np.shares_memory(again[key], first[key]) for key in BY_KEY)


@pytest.mark.parametrize("columns", [512, 509, 65])
@pytest.mark.parametrize("beside", [0, 1, 5, 7])
def test_large_results_are_those_of_small_ones(surface, columns, beside):
    """They are written past the caches in whole lines, wherever the arrays start, which must change nothing."""
    u, v = quintrig.grid(150_000 // columns, columns)
    arrays = {key: shifted(q, (len(u), columns), beside) for key, q in BY_KEY.items()}
    for array in arrays.values():
        array.fill(-99)
    large = quintrig.analyse(surface, u, v, out=arrays, threads=1 + beside % 3)
    for start in (0, len(u) // 3, len(u) - 3):
        rows = slice(start, start + 3)
        part = quintrig.analyse(surface, u[rows], v)
        for key in BY_KEY:
            np.testing.assert_array_equal(part[key], large[key][rows])
    for key in SCALARS:
        assert not (large[key] == -99).any(), key
    points = quintrig.analyse(surface, *(array.ravel() for array in np.broadcast_arrays(u, v)), threads=2)
    np.testing.assert_allclose(points["curvedness"].reshape(large.shape), large["curvedness"], rtol=1e-9)
    np.testing.assert_array_equal(points["hk_type"].reshape(large.shape), large["hk_type"])


@pytest.mark.parametrize("count", [16384 * 3 + 1, 16384 * 3 + 7, 16384 * 4 + 65])
@pytest.mark.parametrize("beside", [0, 1, 3, 6])
def test_many_points_are_those_of_few(surface, count, beside):
    """Pieces of one point beside pieces of many must not write over each other."""
    u, v = scattered(count)
    arrays = {key: shifted(q, (count,), beside) for key, q in BY_KEY.items()}
    many = quintrig.analyse(surface, u, v, out=arrays, threads=1 + beside % 2)
    for places in (slice(0, 70), slice(16384 * 3 - 40, 16384 * 3 + 40), slice(count - 70, count)):
        few = quintrig.analyse(surface, u[places], v[places])
        for key in BY_KEY:
            np.testing.assert_array_equal(few[key], many[key][places], err_msg=key)


def shifted(q, shape, beside):
    """Return an array for a quantity that starts so many numbers after a cache line."""
    planes = (q.components, *shape)
    memory = aligned((math.prod(planes) + 16,), np.int8 if q.colour == "classes" else np.float64)[beside:]
    result = memory[: math.prod(planes)].reshape(planes)
    return np.moveaxis(result, 0, -1) if q.components == 3 else result[0]


def test_outputs_that_nobody_asked_for_are_refused(surface):
    with pytest.raises(ValueError, match=r"out\['gausian'\]: expected only quantities that are asked for"):
        quintrig.analyse(surface, *quintrig.grid(3, 4), ["mean"], out={"gausian": np.zeros((3, 4))})


# ---------------------------------------------------------------------------------------------- classes


def sign(value, zero):
    return np.where(np.abs(value) <= zero, 0, np.sign(value)).astype(int)


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("relative", [1e-6, 1e-2])
def test_classes_follow_from_the_values_by_their_definitions(name, relative):
    thresholds = Thresholds(relative=relative, flat=relative)
    s = quintrig.analyse(SURFACES[name].surface(), *quintrig.grid(12, 13), thresholds=thresholds)
    defined = ~s.singular
    k, h, c = (s[key][defined] for key in ("gaussian", "mean", "curvedness"))
    flat = c * s.size <= relative
    ks, hs = sign(k, relative * c**2), sign(h, relative * c)

    besl = {(-1, 1): "peak", (-1, 0): "ridge", (-1, -1): "saddle ridge", (0, 1): "impossible", (0, 0): "flat",
            (0, -1): "minimal", (1, 1): "pit", (1, 0): "valley", (1, -1): "saddle valley"}  # fmt: skip
    expected = np.array([*besl.values()])[[[*besl].index(pair) for pair in zip(hs, ks, strict=True)]]
    assert named(s, "hk_type", defined) == np.where(flat, "flat", expected).tolist()

    umbilic = (s["k1"] - s["k2"])[defined] / 2 <= relative * c
    carmo = np.select([flat, ks == 0, ks < 0, umbilic], ["planar", "parabolic", "hyperbolic", "umbilic"], "elliptic")
    assert named(s, "point_type", defined) == carmo.tolist()

    steps = np.clip(np.rint((s["shape_index"][defined] + 1) * 4), 0, 8)
    steep = ["spherical cup", "trough", "rut", "saddle rut", "saddle", "saddle ridge", "ridge", "dome", "spherical cap"]
    shape = ["planar" if low else steep[int(i)] for i, low in zip(steps, flat, strict=True)]
    assert named(s, "shape_class", defined) == shape

    standing = defined & np.isfinite(s["beta1"]) & (np.abs(s["beta1"]) < 1e8)
    half, det = s["beta1"][standing] / 2, s["beta2"][standing]
    root = np.sqrt(np.maximum(2 * half**2 - det, 0.0))
    level = root * s.size <= relative
    pair = zip(sign(half, relative * root), sign(det, relative * root**2), strict=True)
    names = {(-1, 1): "dome", (-1, 0): "roof", (-1, -1): "saddle roof", (0, 1): "impossible",
             (0, 0): "level or tilted plane", (0, -1): "balanced saddle", (1, 1): "bowl", (1, 0): "trough",
             (1, -1): "saddle trough"}  # fmt: skip
    expected = ["level or tilted plane" if low else names[p] for p, low in zip(pair, level, strict=True)]
    assert named(s, "invariant_type", standing) == expected

    for key in CLASSES:
        assert (s[key][~defined] == 0).all()


def named(sample, key, where):
    return [BY_KEY[key].classes[code] for code in sample[key][where]]


def test_a_wider_threshold_makes_more_points_parabolic():
    surface = SURFACES[NAMES[0]].surface()
    counts = []
    for relative in (1e-6, 1e-3, 1e-2, 1e-1):
        sample = quintrig.analyse(surface, *quintrig.grid(80, 80), "point_type", thresholds=Thresholds(relative))
        counts.append((sample["point_type"] == 3).sum())
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


@pytest.mark.parametrize("value", [0.0, -1e-6, 0.2, np.nan, np.inf, "1e-6", True, None])
def test_thresholds_are_small_positive_numbers(value):
    for name in ("relative", "flat"):
        with pytest.raises(ValueError, match=f"^{name}: expected"):
            Thresholds(**{name: value})


def test_thresholds_tell_what_they_mean():
    words = Thresholds(relative=1e-5, flat=1e-4).describe(200.0, "mm")
    for part in ("5e-07 1/mm", "0.0001 / size", "|K| <= 1e-05 C²", "|H| <= 1e-05 C"):
        assert part in words
    assert "1/" not in Thresholds().describe(1.0).replace("/ size", "")


@pytest.mark.parametrize("key", SCALARS)
def test_nothing_is_nan_where_the_surface_is_regular_and_bent(key):
    sample = quintrig.analyse(quintrig.tensor(wave(), SHAPES[1]), *quintrig.grid(40, 40), key)
    assert np.isfinite(sample[key]).all()
