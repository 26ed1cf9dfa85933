"""Analysis of a surface at points: ``analyse`` gives a ``Sample``, arrays by the key of the quantity."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.geometry.surface import Surface
from quintrig.kernel import evaluate
from quintrig.kernel.outputs import Settings
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import BY_KEY, quantity
from quintrig.support.arrays import BoolArray, FloatArray, aligned, parameter
from quintrig.support.pickled import Pickled
from quintrig.support.tolerance import NOISE, SINGULAR

_USUAL = Thresholds()


@dataclass(frozen=True, eq=False)
class Sample(Pickled):
    """Quantities of a surface at parameters u and v.

    ``sample["gaussian"]`` has the broadcast shape of u and v, vectors have a last axis of 3, classes are int8 codes.
    ``size`` is the surface's bounding-box diagonal, length¹, to which the thresholds refer.
    """

    surface: Surface
    u: FloatArray
    v: FloatArray
    values: Mapping[str, NDArray[Any]]
    thresholds: Thresholds
    size: float

    def __repr__(self) -> str:
        """Return one line: how many points, and which quantities."""
        points = f"{' x '.join(map(str, self.shape))} points" if self.shape else "one point"
        names = list(self.values)
        more = f" and {len(names) - 6} more" if len(names) > 6 else ""
        return f"<Sample at {points}: {', '.join(names[:6])}{more}>"

    def _repr_html_(self) -> str:
        """Return what a notebook shows: a table of the first points."""
        from quintrig.analysis.frames import html

        return html(self.u, self.v, self.values, repr(self).strip("<>"))

    def __getitem__(self, key: str) -> NDArray[Any]:
        """Return the array of a quantity; KeyError where it was not asked for, ValueError where there is none."""
        if key in self.values:
            return self.values[key]
        key = quantity(key).key
        if key not in self.values:
            raise KeyError(f"{key!r} was not computed; ask analyse for it (computed are {', '.join(self.values)})")
        return self.values[key]

    @property
    def shape(self) -> tuple[int, ...]:
        """Broadcast shape of u and v."""
        return np.broadcast_shapes(self.u.shape, self.v.shape)

    @property
    def point(self) -> FloatArray:
        """Points, shape (*shape, 3), length¹."""
        return self["point"]

    @property
    def normal(self) -> FloatArray:
        """Unit normals, shape (*shape, 3); NaN at singular points."""
        return self["normal"]

    def to_dataframe(self) -> Any:
        """Return a table with a row for each point: u, v and the quantities, a vector as three columns.

        It is pandas' where that is installed, else polars'; classes are their names. QuintrigError where neither is.
        """
        from quintrig.analysis.frames import dataframe

        return dataframe(self.u, self.v, self.values)

    def to_xarray(self) -> Any:
        """Return an xarray Dataset: quantities over u and v on a grid, over points otherwise, vectors over x, y, z.

        Classes are codes, their names in the attributes. QuintrigError where xarray is not installed.
        """
        from quintrig.analysis.frames import dataset

        return dataset(self.u, self.v, self.values, self.size)

    @property
    def singular(self) -> BoolArray:
        """True where the surface has no tangent plane and every curvature is NaN."""
        for key in ("gaussian", "mean"):
            if key in self.values:
                return np.isnan(self.values[key])
        return np.isnan(analyse(self.surface, self.u, self.v, ("mean",))["mean"])


def analyse(
    surface: Surface,
    u: ArrayLike,
    v: ArrayLike,
    quantities: Iterable[str] | str | None = None,
    *,
    thresholds: Thresholds | None = None,
    threads: int | None = None,
    out: Mapping[str, NDArray[Any]] | None = None,
) -> Sample:
    """Compute quantities of the surface at parameters that broadcast as in NumPy.

    u of shape (nu, 1) and v of shape (1, nv) are a grid and take the fast path; the results are the same, to
    rounding. ``quantities`` are keys of the table in ``quantity`` (None: all). ``threads`` defaults to the machine's
    cores for large work. ``out`` gives arrays to write into: C-contiguous, or those of an earlier sample's ``values``.
    Singular points give NaN and code 0. Raises ValueError for what is no Surface, NaN or parameters outside
    [0, 1], unknown keys and unfit arrays.
    """
    if not isinstance(surface, Surface):  # pyright: ignore[reportUnnecessaryIsInstance]
        found = type(surface).__name__  # misuse is a ValueError, whatever the value
        raise ValueError(f"surface: expected a Surface, such as load(path).surface, got {found}")  # noqa: TRY004
    u, v = parameter(u, "u"), parameter(v, "v")
    keys = _keys(quantities)
    thresholds = thresholds or _USUAL
    size = surface.size
    try:
        shape = np.broadcast_shapes(u.shape, v.shape)
    except ValueError:
        raise ValueError(f"u and v: shapes {u.shape} and {v.shape} do not broadcast to one") from None
    on_grid = u.ndim == v.ndim == 2 and u.shape[1] == v.shape[0] == 1
    rows, columns = shape if on_grid else (1, math.prod(shape))
    strange = set(out or ()) - set(keys)
    if strange:
        raise ValueError(f"out[{sorted(strange)[0]!r}]: expected only quantities that are asked for")
    planes = {key: _plane(key, rows, columns, shape, out) for key in keys}
    per_size = 1.0 / size if size > 0.0 else math.inf
    at = Settings(
        surface.sign,
        SINGULAR * size * size if size > 0.0 else math.inf,  # a single point has no tangent plane at all
        thresholds.relative,
        thresholds.flat * per_size,
        NOISE * per_size,
        evaluate.worth_streaming(planes),
    )
    threads = evaluate.workers(threads, rows * columns)
    if on_grid:
        evaluate.on_grid(surface, u[:, 0], v[0], planes, threads, at)
    else:
        flat_u, flat_v = (array.reshape(-1) for array in np.broadcast_arrays(u, v))
        evaluate.scattered(surface, flat_u, flat_v, planes, threads, at)
    values = {key: _shaped(key, plane, shape) for key, plane in planes.items()}
    return Sample(surface, u, v, MappingProxyType(values), thresholds, size)


def _keys(quantities: Iterable[str] | str | None) -> tuple[str, ...]:
    if quantities is None:
        return tuple(BY_KEY)
    return tuple(quantity(key).key for key in ([quantities] if isinstance(quantities, str) else quantities))


def _plane(
    key: str, rows: int, columns: int, shape: tuple[int, ...], out: Mapping[str, NDArray[Any]] | None
) -> NDArray[Any]:
    """Return the output of one quantity as (components, rows, columns)."""
    q = BY_KEY[key]
    kind = np.int8 if q.kind == "class" else np.float64
    if out is None or key not in out:
        return aligned((q.components, rows, columns), kind)
    array = out[key]
    vector = q.components == 3
    wanted = (*shape, 3) if vector else shape
    # A vector's components are planes, as in the arrays of a sample.
    planes = np.moveaxis(array, -1, 0) if vector and array.ndim else array
    if array.shape != wanted or array.dtype != kind or not (planes.flags.c_contiguous and planes.flags.writeable):
        form = "with the last axis outermost, as in a sample" if vector else "C-contiguous"
        raise ValueError(
            f"out[{key!r}]: expected a writable {np.dtype(kind)} array of shape {wanted}, {form}, "
            f"found {array.dtype} of shape {array.shape}"
        )
    return planes.reshape(q.components, rows, columns)


def _shaped(key: str, plane: NDArray[Any], shape: tuple[int, ...]) -> NDArray[Any]:
    if BY_KEY[key].components == 1:
        return plane[0].reshape(shape)
    return np.moveaxis(plane.reshape(len(plane), *shape), 0, -1)
