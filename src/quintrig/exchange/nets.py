"""Control nets as CSV and JSON, out of models and into them, and curves of CAD files as control polygons."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

import numpy as np

from quintrig.basis.bspline import normalised
from quintrig.basis.rational import RIGHT_ANGLE
from quintrig.basis.trigonometric import Trigonometric
from quintrig.exchange.cad.faces import SpaceCurve
from quintrig.exchange.formats import suffixes
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, Patch
from quintrig.model.reading import in_rows, read_net, read_text
from quintrig.model.save import save
from quintrig.support.arrays import FloatArray, frozen
from quintrig.support.errors import ModelError, QuintrigError, nearest, printable
from quintrig.support.files import write_whole
from quintrig.support.parsing import parse

NET_SUFFIXES = suffixes("net", "model")
"""Endings of the files that hold control nets: numbers alone, or whole models."""


def export_net(model: Model, path: Path) -> tuple[Path, ...]:
    """Write control points as CSV, or the whole model as JSON or TOML; return the files written.

    A CSV has one point a line, row by row, as models read it; a patch with several nets gives one file for each, and
    so do several patches. Raises QuintrigError for a model without control points and an unwritable target.
    """
    if path.suffix.lower() != ".csv":
        return (save(model, path),)
    nets = {(part.name, key): getattr(part.definition, key) for part in _parts(model) for key in _keys(part.definition)}
    names = net_paths(model, path)
    return tuple(write_whole(name, to_csv(net)) for name, net in zip(names, nets.values(), strict=True))


def net_paths(model: Model, path: Path) -> tuple[Path, ...]:
    """Return the files that ``export_net`` writes for a path: it alone, or one for each of several nets of points.

    The latter are called after it with the names of patch and net, such as lid-section.csv and lid-trajectory.csv for
    lid.csv. Raises QuintrigError for a CSV of a model without control points.
    """
    if path.suffix.lower() != ".csv":
        return (path,)
    nets = [(part.name, key) for part in _parts(model) for key in _keys(part.definition)]
    if not nets:
        kinds = ", ".join(sorted({patch.kind for patch in model.patches}))
        raise QuintrigError(f"{path}: a {kinds} has no control points to write; export a mesh or a table instead")
    return tuple(_file_names(path, nets))


def _parts(model: Model) -> tuple[Patch | NamedCurve, ...]:
    return (*model.patches, *model.curves)


def to_csv(net: Any) -> str:
    """Return a net of points, (n, d) or (n, m, d), as CSV with a heading, every digit kept."""
    points = np.asarray(net, dtype=np.float64)
    rows = points.reshape(-1, points.shape[-1])
    heading = {2: "a,b", 3: "x,y,z", 4: "a,b,c,d"}[points.shape[-1]]
    remark = f"# {' x '.join(str(count) for count in points.shape[:-1])} points, row by row"
    return "\n".join([remark, heading, *(",".join(repr(value) for value in row) for row in rows.tolist())]) + "\n"


def model_from_net(path: Path, keys: dict[str, Any]) -> Model:
    """Return a model whose net is the CSV or JSON file; ``keys`` are its other keys, ``kind`` among them.

    A CSV lists the points of the one net of its kind; a JSON file holds that net as nested lists, or a whole model.
    Raises ModelError naming the file for anything else.
    """
    if path.suffix.lower() == ".json":
        data = _from_json(path)
        if isinstance(data, dict):
            return _named(path, cast(dict[str, Any], data) | {k: v for k, v in keys.items() if k != "kind"})
        return _named(path, keys | {"points": _in_rows(path, data, keys["kind"])})
    return _named(path, keys | {"points": path.name})


def read_points(path: Path) -> FloatArray:
    """Return the points of a CSV file (n, d), or of a JSON file (n, d) or (n, m, d); ModelError naming the file."""
    data = _from_json(path) if path.suffix.lower() == ".json" else read_net(path)
    if isinstance(data, dict):
        raise ModelError(f"{path}: expected a net, as nested lists of numbers, found a whole model")
    try:
        return frozen(data, "points", (None, None), (None, None, None))
    except ValueError as error:
        raise ModelError(f"{path}: {error}") from None


def put_into(model: Model, patch: str | None, key: str, points: FloatArray) -> Model:
    """Return the model with another net in one patch; ModelError naming the nets that the patch has."""
    chosen = model.patch(patch)
    known = _keys(chosen.definition)
    if key not in known:
        raise ModelError(
            f'patch "{chosen.name}": a {chosen.kind} has no net {key!r}{nearest(key, known)}; it has '
            f"{', '.join(known) or 'none'}"
        )
    data = model.to_dict()
    index = [one.name for one in model.patches].index(chosen.name)
    table = data["patch"][index] if "patch" in data else data
    old = np.asarray(getattr(chosen.definition, key), dtype=np.float64)
    if points.ndim != old.ndim:
        points = points.reshape(-1, old.shape[1], points.shape[-1]) if points.ndim < old.ndim else points
    table[key] = points[..., : old.shape[-1]].tolist()
    return Model.from_dict(data)


def polygon(curve: SpaceCurve, shape: Sequence[float] = (0.0, 0.0)) -> tuple[FloatArray, float]:
    """Return six control points (6, 3) of the trigonometric curve nearest to a CAD curve, and how near, length¹.

    ``shape`` is (α, ζ). End points are kept; the rest is least squares at equal parameters, the curve's own or, for
    the exact form that quintrig writes, those of the tangent map: then the curve comes back exactly.
    """
    alpha, zeta = frozen(list(shape), "shape", (2,)).tolist()
    basis = Trigonometric(alpha, zeta)
    x: FloatArray = np.linspace(0.0, 1.0, 401)
    target = _curve_points(curve, x)
    tried: list[tuple[float, FloatArray]] = []
    for t in (x, RIGHT_ANGLE.backward(x)):
        matrix = basis.derivatives(t, 0)[0]
        ends = np.outer(matrix[:, 0], target[0]) + np.outer(matrix[:, 5], target[-1])
        inner = cast(FloatArray, np.linalg.lstsq(matrix[:, 1:5], target - ends, rcond=None)[0])
        points: FloatArray = np.concatenate([target[:1], inner, target[-1:]])
        gap = float(np.sqrt(((matrix @ points - target) ** 2).sum(axis=1)).max())
        tried.append((gap, points))
    gap, points = min(tried, key=lambda one: one[0])
    return points, gap


def _from_json(path: Path) -> Any:
    text = read_text(path)
    try:
        return parse(text, ".json")
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def _in_rows(path: Path, data: Any, kind: str) -> Any:
    """Return a net as rows of points; points in one list, as in a CSV, go into rows of as many as the kind has."""
    points = cast(list[Any], data) if isinstance(data, list) else []
    flat = points and isinstance(points[0], list) and not any(isinstance(x, list) for x in cast(list[Any], points[0]))
    counts = kinds()[kind].counts.get("points", ())
    if not flat or len(counts) != 2:
        return cast(Any, data)
    try:
        return in_rows(points, counts[1], "points")
    except ValueError as error:
        raise ModelError(f"{path}: {error}") from None


def _curve_points(curve: SpaceCurve, x: FloatArray) -> FloatArray:
    basis = normalised(curve.knots, curve.degree)
    blend = basis.derivatives(x, 0)[0] * np.asarray(curve.weights)
    return blend @ np.asarray(curve.points) / blend.sum(axis=1, keepdims=True)


def _keys(definition: Any) -> tuple[str, ...]:
    """Return the keys of a patch that hold control points."""
    return ("points",) if definition.kind == "nurbs" else tuple(definition.nets)


def _file_names(path: Path, nets: list[tuple[str, str]]) -> list[Path]:
    patches = {patch for patch, _ in nets}
    several = [[patch for patch, _ in nets].count(patch) > 1 for patch, _ in nets]
    names: list[Path] = []
    for (patch, key), more in zip(nets, several, strict=True):
        words = [path.stem, *([_plain(patch)] if len(patches) > 1 else []), *([key] if more else [])]
        stem, count = "-".join(words), 1
        name = path.with_name(stem + path.suffix)
        while name in names:  # patches whose names differ in letters that file names do without
            count += 1
            name = path.with_name(f"{stem}-{count}{path.suffix}")
        names.append(name)
    return names


def _plain(name: str) -> str:
    return "".join(letter if letter.isalnum() or letter in "-_" else "_" for letter in name)[:60]


def _named(path: Path, keys: dict[str, Any]) -> Model:
    try:
        return Model.from_dict({"name": printable(path.stem)} | keys, path.parent)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None
