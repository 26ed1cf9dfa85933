"""The pictures of a patch: what is drawn, and what is said of each to those who do not see it."""

import base64
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from matplotlib.figure import Figure

from quintrig.analysis.agreement import REASONS
from quintrig.analysis.table import INVARIANTS
from quintrig.figure import (
    Scene,
    code_map,
    comparison,
    flat_map,
    map_comparison,
    map_panels,
    projections,
    seam_picture,
    space_picture,
    to_bytes,
    to_png_bytes,
    zebra_picture,
)
from quintrig.figure.field import field as field_of
from quintrig.figure.field import zero_lines
from quintrig.figure.style import STANDARD, Style
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.joins import Joins
from quintrig.quantities.table import BY_KEY
from quintrig.report.facts import Facts, has_effect
from quintrig.report.lines import lines_picture
from quintrig.report.wording import percent
from quintrig.shaping.shape_effect import spelt

_DPI = 144
_FILE_DPI = 300
_WIDE, _SPACE, _HALF, _MAP, _THIRD = 9.0, 5.6, 4.8, 4.2, 3.7  # inches

REASON_COLOURS = (
    "#7d7d7d",
    "#dfece4",
    "#f2f0ea",
    "#f3cf73",
    "#e69f00",
    "#b5760a",
    "#8a5a12",
    "#c2407a",
    "#5b1646",
    "#a8a8a8",
)
"""Colours of ``agreement.REASONS``: quiet where the methods agree, amber for neighbours, magenta for contradictions."""

SHOWN: tuple[tuple[str, str], ...] = (
    ("gaussian", "Red: dome or bowl (K > 0). Blue: saddle (K < 0)."),
    ("mean", "Red: bends towards the normal (hollow). Blue: bends away from it (bulging)."),
    ("shape_index", "Which shape, whatever its strength: from cup (-1) over saddle (0) to cap (+1)."),
    ("curvedness", "How strongly it bends, whatever its shape."),
    ("hk_type", "The signs of K and H together, seen from the side that the normal points to."),
    ("shape_class", "Nine ranges of the shape index."),
)
"""The quantities that are drawn in space and as a map, and how to read each."""

_ZEROS = {"gaussian": " On the line between them K = 0.", "mean": " On the dashed line H = 0."}


@dataclass(frozen=True)
class Picture:
    """A picture to be drawn: ``name`` for the template, what draws it in a style, and what it shows in words.

    The words may be a function, for those that take longer to find than the picture to draw.
    """

    name: str
    alt: str | Callable[[], str]
    draw: Callable[..., Figure]


@dataclass(frozen=True)
class Image:
    """A drawn picture, inlined: data URI, alternative text, size in CSS pixels; ``files`` of a ``name``, by format."""

    source: str
    alt: str
    width: int
    height: int
    files: Mapping[str, bytes] = field(default_factory=dict[str, bytes])
    name: str = ""


def render(picture: Picture, formats: Sequence[str] = (), style: Style = STANDARD) -> Image:
    """Draw a picture into the page, and as files of these formats."""
    return told(picture, drawn(picture.draw, picture.name, formats, style))


def drawn(draw: Callable[..., Figure], name: str, formats: Sequence[str] = (), style: Style = STANDARD) -> Image:
    """Draw a picture that is not told in words yet."""
    figure = draw(style=style)
    width, height = (float(x) for x in figure.get_size_inches())
    data = base64.b64encode(to_png_bytes(figure, _DPI)).decode("ascii")
    files = {form: to_bytes(figure, form, style.dpi or _FILE_DPI) for form in formats}
    return Image(f"data:image/png;base64,{data}", "", round(96 * width), round(96 * height), files, name)


def told(picture: Picture, image: Image) -> Image:
    """Return a drawn picture with its words."""
    return replace(image, alt=picture.alt if isinstance(picture.alt, str) else picture.alt())


def overview(model: Model, joins: Joins) -> Iterator[Picture]:
    """Return the pictures of a model with several patches: all together, plain and by K and H on one scale, seams."""
    surfaces = [patch.surface for patch in model.patches]
    draw = partial(space_picture, unit=model.unit, width=_HALF)
    yield Picture("all", "All patches together.", partial(draw, surfaces, None, Scene(isolines=3)))
    for key in ("gaussian", "mean"):
        yield Picture(f"all-{key}", f"All patches, coloured by {BY_KEY[key].name}.", partial(draw, surfaces, key))
    counts = ", ".join(f"{count} {order}" for order, count in joins.counts.items() if count) or "none"
    yield Picture("all-seams", f"All patches with their seams: {counts}.", partial(seam_picture, surfaces, joins))
    yield Picture("all-zebra", "All patches reflecting stripes.", partial(zebra_picture, surfaces, unit=model.unit))


def pictures(facts: Facts, quantities: Sequence[str] = ()) -> Iterator[Picture]:
    """Return the pictures of a patch, those first that take longest; few of one that is not ``detailed``.

    ``quantities`` are keys to show in the place of ``SHOWN``.
    """
    if facts.detailed:
        yield from _effect(facts)
        yield _lines(facts)
        yield _projections(facts)
    yield _lead(facts)
    yield from _fields(facts, _keys(facts.detailed, quantities))
    yield _agreement(facts)
    if facts.detailed:
        yield from _invariants(facts)


def picture_count(patch: Patch, detailed: bool, quantities: Sequence[str] = ()) -> int:
    """Return how many pictures ``pictures`` will return for a patch."""
    count = 2 + 2 * len(_keys(detailed, quantities))
    return count + (2 + len(INVARIANTS) + (4 if has_effect(patch) else 0) if detailed else 0)


def _keys(detailed: bool, quantities: Sequence[str]) -> list[str]:
    """Return the keys of what is drawn in space and as a map."""
    chosen = [key for key in quantities if key != "surface"]  # which is the first picture anyway
    return chosen or [key for key, _ in (SHOWN if detailed else SHOWN[:2])]


def _lead(facts: Facts) -> Picture:
    surface = facts.patch.surface
    net = surface.net is not None
    marks = facts.marks
    scene = Scene(net=net, isolines=7, marks=marks, normal=True)

    def alt() -> str:
        low, high = facts.summary.box
        spans = " by ".join(f"{b - a:.3g}" for a, b in zip(low, high, strict=True))
        inside = ", inside its control net" if net else ""
        return (
            f"The surface in space with the labelled points A to I and its normal{inside}; "
            f"it measures {spans} {facts.unit} along x, y and z."
        )

    return Picture("lead", alt, partial(space_picture, surface, None, scene, unit=facts.unit, width=5.4))


def readings(facts: Facts, images: Mapping[str, Image], style: Style = STANDARD) -> tuple[tuple[str, str], ...]:
    """Return the quantities that are drawn and how to read each: lines of zeros are spoken of where there are any."""
    t = np.linspace(0.0, 1.0, 121)
    told = {} if style.colours else dict(SHOWN)  # which speaks of the usual colours
    keys = [name.removesuffix("-space") for name in images if name.endswith("-space")]
    drawn = {key for key in _ZEROS if key in keys and zero_lines(field_of(facts.patch.surface, key, t, t))}
    return tuple(
        (key, told.get(key, _sentence(BY_KEY[key].meaning)) + (_ZEROS[key] if key in drawn else "")) for key in keys
    )


def _sentence(words: str) -> str:
    return f"{words[:1].upper()}{words[1:].rstrip('.')}."


def _fields(facts: Facts, keys: Sequence[str]) -> Iterator[Picture]:
    surface, limits = facts.patch.surface, facts.thresholds
    marks = facts.marks
    for key in keys:
        name, numbers = BY_KEY[key].name, partial(_numbers, facts, key)
        space = partial(space_picture, surface, key, unit=facts.unit, thresholds=limits, width=_SPACE)
        plane = partial(flat_map, surface, key, marks=marks, unit=facts.unit, thresholds=limits, width=_MAP)
        yield Picture(f"{key}-space", partial(_with, f"The surface in space, coloured by {name}.", numbers), space)
        yield Picture(f"{key}-map", partial(_with, f"Map of {name} over u and v.", numbers), plane)


def _with(words: str, numbers: Callable[[], str]) -> str:
    return f"{words} {numbers()}".strip()


def _numbers(facts: Facts, key: str) -> str:
    """Say in words what a picture shows: the range of a number, the shares of classes."""
    if key not in (*facts.summary.shares, *facts.summary.extremes):
        return ""
    if key in facts.summary.shares:
        parts = facts.summary.shares[key][:6]
        return ", ".join(f"{part.name} {percent(part.share)}" for part in parts) + "."
    found = facts.summary.extremes[key]
    unit = BY_KEY[key].unit(facts.unit)
    if found.minimum.status != "attained" or found.maximum.status != "attained":
        return ""
    least, most = (f"{end.value:.3g} {unit}".strip() for end in (found.minimum, found.maximum))
    where = f"(u, v) = ({found.maximum.u:.3g}, {found.maximum.v:.3g})"
    return f"From {least} to {most}, which is taken at {where}."


def _projections(facts: Facts) -> Picture:
    alt = "Side, back and top views of the surface at one scale."
    return Picture("projections", alt, partial(projections, facts.patch.surface, unit=facts.unit, width=_WIDE))


def _lines(facts: Facts) -> Picture:
    alt = "The surface with a net of lines of curvature and its umbilics."
    return Picture(
        "lines", alt, partial(lines_picture, facts.patch.surface, facts.umbilics.umbilics, facts.unit, _SPACE)
    )


def invariants_shown(facts: Facts) -> tuple[str, ...]:
    """Return the keys of the invariants that are mapped: in the metric of the surface where it is steep."""
    return tuple(f"{key}_surface" for key in INVARIANTS) if facts.steep else INVARIANTS


def _invariants(facts: Facts) -> Iterator[Picture]:
    surface = facts.patch.surface
    for key in invariants_shown(facts):
        q = BY_KEY[key]
        alt = f"Map over u and v of the invariant {q.symbol}, {q.name}."
        draw = partial(map_panels, surface, [key], unit=facts.unit, thresholds=facts.thresholds, width=_THIRD)
        yield Picture(f"{key}-map", alt, draw)


def _agreement(facts: Facts) -> Picture:
    found = facts.agreement
    agree, conflict = percent(found.share("agree")), percent(found.share("conflict"))
    alt = (
        f"Map over u and v of where the methods agree ({agree} of the area), differ, and contradict each other "
        f"({conflict})."
    )
    names = [reason.name for reason in REASONS]
    return Picture(
        "agreement",
        alt,
        partial(
            code_map, found.reason, names, REASON_COLOURS, face=facts.patch.surface, marks=facts.marks, width=_HALF
        ),
    )


def _effect(facts: Facts) -> Iterator[Picture]:
    if not facts.others:
        return
    surfaces = [patch.surface for patch in (facts.patch, *facts.others)]
    labels = [spelt(facts.patch.shape, own=True), *(spelt(patch.shape) for patch in facts.others)]
    for key in ("gaussian", "mean"):
        name = BY_KEY[key].name
        space = partial(comparison, surfaces, labels, key, unit=facts.unit, columns=2, width=6.4)
        plane = partial(map_comparison, surfaces, labels, key, unit=facts.unit, columns=2, width=4.8)
        sets = ", ".join(labels)
        yield Picture(f"effect-{key}", f"{name} with the shape parameters {sets}, on one scale.", space)
        yield Picture(f"effect-{key}-map", f"Maps of {name} with the shape parameters {sets}, on one scale.", plane)
