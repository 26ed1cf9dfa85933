"""Goals files: what of a model may vary, what is minimised, and what is demanded."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal, cast

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from quintrig.model.explain import expected_in_place, spell
from quintrig.model.kinds.definition import Point, Positive
from quintrig.model.model import Model, load
from quintrig.model.reading import read_text
from quintrig.shaping.demands import Demand, demands
from quintrig.shaping.energies import ENERGIES
from quintrig.shaping.holds import Hold, hold
from quintrig.shaping.unknowns import Range
from quintrig.support.errors import ModelError, closest, nearest
from quintrig.support.parsing import parse

OBJECTIVES = (*ENERGIES, "area", "deviation", "none")
"""What may be minimised; ``none`` asks for the least change that meets the demands."""


Text = Annotated[str, Field(strict=True, min_length=1, max_length=400)]
Unit = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1)]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Vary(_Table):
    """``[vary]``: ranges of parameters by name stand beside these keys."""

    model_config = ConfigDict(extra="allow", frozen=True)
    shape: Annotated[bool, Field(strict=True)] = False
    points: Positive | None = None
    only: list[Text] = []
    hold: list[Text] | None = None


class Through(_Table):
    """``[[through]]``: a point that the surface goes through, at (u, v) if given."""

    point: Point
    u: Unit | None = None
    v: Unit | None = None


class Tangent(_Table):
    """``[[tangent]]``: the normal that the tangent plane has at (u, v)."""

    u: Unit
    v: Unit
    normal: Point


class Target(_Table):
    """``[[target]]``: points to be near, within a distance where that is demanded."""

    file: Text | None = None
    points: list[Point] | None = None
    unit: str = ""
    within: Positive | None = None


class Seam(_Table):
    """``[[seam]]``: two sides that meet."""

    first: Text
    second: Text
    order: Literal["G0", "G1", "G2", "G3"] = "G1"
    ratio: Positive | None = None


class Keys(_Table):
    """The keys of a goals file."""

    model: Any = None
    patch: Text | None = None
    minimise: Text = "none"
    vary: Vary = Vary()
    demands: list[Text] = []
    through: list[Through] = []
    tangent: list[Tangent] = []
    target: list[Target] = []
    seam: list[Seam] = []
    developable: Annotated[float, Field(strict=True, gt=0, lt=90)] | None = None


@dataclass(frozen=True, eq=False)
class Goals:
    """What is asked for, read and checked, with the model that it is asked of.

    ``ranges`` are of parameters, ``points`` by how much each coordinate may move (None: not at all), length¹.
    ``developable`` is the angle that normals may turn by along a ruling, degrees.
    """

    model: Model
    patch: str
    minimise: str
    ranges: tuple[Range, ...]
    points: float | None
    only: tuple[str, ...]
    hold: tuple[Hold, ...] | None
    demands: tuple[Demand, ...]
    through: tuple[Through, ...]
    tangent: tuple[Tangent, ...]
    targets: tuple[Target, ...]
    seams: tuple[Seam, ...]
    developable: float | None
    folder: Path


def read_goals(goals: "str | Path | Mapping[str, Any]") -> Goals:
    """Return the goals of a TOML or JSON file, or of its keys; ModelError in one line, naming the place."""
    if isinstance(goals, (str, Path)):
        path = Path(goals)
        if path.suffix.lower() not in (".toml", ".json"):
            raise ModelError(f"{path}: expected goals, a file ending in .toml or .json")
        text = read_text(path, "a file of goals")
        try:
            return _goals(parse(text, path.suffix.lower()), path.parent)
        except ValueError as error:
            raise ModelError(f"{path}: {error}") from None
    return _goals(goals, Path())


def model_file(goals: Path) -> Path | None:
    """Return the model file that a goals file names, if it can be read."""
    try:
        name = parse(read_text(goals, "a file of goals"), goals.suffix.lower()).get("model")
    except (ValueError, AttributeError):
        return None
    return goals.parent / name if isinstance(name, str) else None


def _goals(data: Any, folder: Path) -> Goals:
    if not isinstance(data, Mapping):
        raise ModelError(f"goals: expected keys and values, got {spell(data)}")
    table = cast(Mapping[str, Any], data)
    if "maximise" in table or "minimize" in table:
        key = "maximise" if "maximise" in table else "minimize"
        raise ModelError(f"unknown key {key!r}; did you mean 'minimise'? it takes {', '.join(OBJECTIVES)}")
    try:
        keys = Keys.model_validate(dict(table))
    except ValidationError as error:
        raise ModelError(_explained(error)) from None
    model = _model(keys.model, folder)
    patch = model.patch(keys.patch)
    if patch.surface.trim:
        raise ModelError(f'patch: "{patch.name}" is a trimmed face, which is not designed; take its whole surface')
    minimise = keys.minimise.replace("-", "_")
    if minimise not in OBJECTIVES:
        raise ModelError(
            f"minimise: expected one of {', '.join(OBJECTIVES)}, got {keys.minimise!r}{nearest(minimise, OBJECTIVES)}"
        )
    ranges = _ranges(keys.vary, model, patch.name)
    if not ranges and keys.vary.points is None:
        raise ModelError(
            "vary: expected something that may vary: shape = true, points = 20, or a range such as alpha1 = [-4, 1]"
        )
    if keys.vary.only and keys.vary.points is None:
        raise ModelError("vary: only: names points that may move; say by how much too, as points = 20")
    found = [one for text in keys.demands for one in demands(text, model.unit)]
    for index, one in enumerate(keys.tangent, 1):
        if not np.linalg.norm(one.normal) > 0.0:
            raise ModelError(f"tangent {index}: normal: expected a direction, got {one.normal}")
    for index, one in enumerate(keys.through, 1):
        if (one.u is None) != (one.v is None):
            raise ModelError(f"through {index}: expected u and v both, or neither")
    for index, one in enumerate(keys.target, 1):
        if (one.file is None) == (one.points is None):
            raise ModelError(f"target {index}: expected a file, or points = [[x, y, z], ...]")
    if keys.minimise == "none" and not (found or keys.through or keys.tangent or keys.target or keys.seam
                                        or keys.developable):  # fmt: skip
        raise ModelError("goals: expected minimise = ..., demands or something to pass through; found nothing to do")
    holds = None if keys.vary.hold is None else tuple(hold(text) for text in keys.vary.hold)
    return Goals(
        model,
        patch.name,
        minimise,
        ranges,
        keys.vary.points,
        tuple(keys.vary.only),
        holds,
        tuple(found),
        tuple(keys.through),
        tuple(keys.tangent),
        tuple(keys.target),
        tuple(keys.seam),
        keys.developable,
        folder,
    )


def _model(given: Any, folder: Path) -> Model:
    if isinstance(given, Model):
        return given
    if given is None:
        raise ModelError("missing key 'model': expected the name of a model file, such as model = \"lid.toml\"")
    if isinstance(given, Mapping):
        return Model.from_dict(cast(Mapping[str, Any], given), folder)
    if not isinstance(given, (str, Path)):
        raise ModelError(f"model: expected the name of a model file, got {spell(given)}")
    return load(folder / given)


def _ranges(vary: Vary, model: Model, name: str) -> tuple[Range, ...]:
    """Return the parameters that may vary, with their ranges."""
    patch = model.patch(name)
    known, bounds = patch.definition.parameters, patch.definition.ranges
    asked: dict[str, Any] = dict(vary.model_extra or {})
    if vary.shape:
        if not bounds or not patch.definition.acting:
            raise ModelError(f"vary: shape: a {patch.kind} has no shape parameters that act")
        asked = {key: [one.low, one.high] for key, one in bounds.items()} | asked
    found: list[Range] = []
    for key, value in asked.items():
        if key not in known:
            words = (*known, "shape", "points", "only", "hold")
            raise ModelError(f"vary: unknown parameter {key!r}{nearest(key, words)}; a {patch.kind} has "
                             f"{', '.join(known) or 'none'}, and points")  # fmt: skip
        ends = cast(list[Any], value) if isinstance(value, (list, tuple)) else []
        numbers = [float(end) for end in ends if isinstance(end, (int, float)) and not isinstance(end, bool)]
        if len(numbers) != 2 or len(ends) != 2 or not all(np.isfinite(numbers)) or not numbers[0] < numbers[1]:
            raise ModelError(f"vary: {key}: expected a range [low, high], got {spell(value)}")
        low, high = numbers
        one = bounds.get(key)
        if one is not None and not getattr(patch.definition, "unchecked_shape", False):
            if low < one.low or high > one.high:
                raise ModelError(f"vary: {key}: expected a range inside {one.range}, got {spell(value)}")
            width = one.high - one.low
            low, high = (low + 1e-9 * width * (one.open[0] and low == one.low),
                         high - 1e-9 * width * (one.open[1] and high == one.high))  # fmt: skip
        elif one is None:
            for end in (low, high):
                patch.with_parameters({key: end})
        found.append(Range(key, low, high))
    return tuple(found)


def _explained(error: ValidationError) -> str:
    """Return the first mistake in one line."""
    first = error.errors(include_url=False)[0]
    place = ""
    for part in first["loc"]:
        place += f" {part + 1}" if isinstance(part, int) else f"{': ' if place else ''}{part}"
    if first["type"] == "extra_forbidden":
        key = str(first["loc"][-1])
        table = {"through": Through, "tangent": Tangent, "target": Target, "seam": Seam}.get(str(first["loc"][0]), Keys)
        form = Keys if len(first["loc"]) == 1 else table
        hint = f"; did you mean {closest(key, form.model_fields)!r}?" if closest(key, form.model_fields) else (
            f"; there are {', '.join(form.model_fields)}")  # fmt: skip
        return f"unknown key {place!r}{hint}"
    if first["type"] == "missing":
        return f"missing key {place!r}"
    kind, context = first["type"], first.get("ctx", {})
    if kind in ("too_short", "too_long"):
        few = kind == "too_short"
        words = f"at {'least' if few else 'most'} {context['min_length' if few else 'max_length']} numbers"
    else:
        words = expected_in_place(kind, first["input"], context)
    told = f"expected {words}" if words else f"{first['msg'][0].lower()}{first['msg'][1:]}"
    return f"{place}: {told}, got {spell(first['input'])}"
