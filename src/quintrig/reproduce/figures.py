"""How each kind of figure of the inventory is drawn."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from quintrig.basis.trigonometric import Trigonometric
from quintrig.figure import (
    SIDE,
    Mark,
    Scene,
    Trace,
    basis_functions,
    comparison,
    hk_table,
    overlay,
    panels,
    plane_curves,
    projections,
    shape_scale,
    space_picture,
)
from quintrig.figure.palette import SERIES
from quintrig.figure.style import STANDARD, Style
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.kinds.constructions import Ruled, Swept, Swung
from quintrig.model.patch import Patch
from quintrig.reproduce.inventory import Item, labelled_points, model

# Control points of the thesis's figure 2.3.
_CURVE = ((3.0, 0.0), (2.0, 5.0), (3.0, 10.0), (5.0, 10.0), (6.0, 5.0), (5.0, 0.0))
_SAMPLES = np.linspace(0.0, 1.0, 201)
_PLAIN = Scene(isolines=7)


def draw(item: Item, style: Style = STANDARD) -> tuple[Figure, ...]:
    """Return the figures of an item: one, or one for each of its parts where they do not share a picture."""
    return tuple(_DRAWERS[item.draw](item, style))


def _basis(item: Item, style: Style) -> list[Figure]:
    bases = [Trigonometric(alpha, zeta) for alpha, zeta in item.shapes]
    return [basis_functions(bases, [f"α = {basis.alpha:g}, ζ = {basis.zeta:g}" for basis in bases], style=style)]


def _hull(item: Item, style: Style) -> list[Figure]:
    return [plane_curves(*_family(item.shapes), hull=True, style=style)]


def _families(item: Item, style: Style) -> list[Figure]:
    return [plane_curves(*_family(shapes), style=style) for shapes in item.shapes]


def _family(shapes: Sequence[tuple[float, float]]) -> tuple[list[Curve], list[str]]:
    curves = [Curve(_CURVE, alpha, zeta) for alpha, zeta in shapes]
    return curves, [f"α = {curve.alpha:g}, ζ = {curve.zeta:g}" for curve in curves]


def _overlays(item: Item, style: Style) -> list[Figure]:
    patch = _patch(item)
    return [
        overlay(
            [patch.with_shape(shape).surface for shape in shapes],
            [_spell(shape) for shape in shapes],
            Scene(net=True),
            style=style,
        )
        for shapes in item.shapes
    ]


def _hk_types(_: Item, style: Style) -> list[Figure]:
    return [style.finish(hk_table(style.across(6.4)))]


def _shape_index(_: Item, style: Style) -> list[Figure]:
    return [style.finish(shape_scale(style.across(9.0)))]


def _construction(item: Item, style: Style) -> list[Figure]:
    patch = _patch(item)
    scene = Scene(isolines=9, traces=tuple(_generators(patch)), normal=False)
    return [space_picture(patch.surface, None, scene, unit=model(item.models[0]).unit, style=style)]


def _generators(patch: Patch) -> list[Trace]:
    """Return the curves that a surface is made from, with their control polygons."""
    definition = patch.definition
    a1, z1, a2, z2 = patch.shape
    if isinstance(definition, Swept):
        start = np.array(definition.section[0]), np.array(definition.trajectory[0])
        # Each curve lies on the surface where the other one begins.
        polygons = [np.array(definition.section) + start[1], np.array(definition.trajectory) + start[0]]
        names, shapes = ["section curve C(u)", "trajectory curve T(v)"], [(a1, z1), (a2, z2)]
    elif isinstance(definition, Swung):
        r, z = np.array(definition.profile).T
        x, y = np.array(definition.trajectory).T
        zero = np.zeros(len(r))
        polygons = [np.stack([definition.scale * r, zero, z], axis=1), np.stack([x, y, zero], axis=1)]
        names, shapes = ["profile curve (r, z)(u), times λ", "trajectory curve (x, y)(v)"], [(a1, z1), (a2, z2)]
    elif isinstance(definition, Ruled):
        polygons = [np.array(definition.first), np.array(definition.second)]
        names, shapes = ["first curve A(u)", "second curve B(u)"], [(a1, z1), (a2, z2)]
    else:
        raise TypeError(f"{patch.kind}: has no generating curves")
    traces: list[Trace] = []
    for polygon, name, shape, colour in zip(polygons, names, shapes, SERIES[1:3], strict=True):
        traces.append(Trace(Curve(polygon, *shape)(_SAMPLES), name, colour, width=2.2))
        traces.append(Trace(polygon, "", colour, width=0.8, dashed=True, polygon=True))
    return traces


def _pair(item: Item, style: Style) -> list[Figure]:
    return [
        space_picture(model(name).surface, None, _PLAIN, unit=model(name).unit, width=4.6, style=style)
        for name in item.models
    ]


def _marked(item: Item, style: Style) -> list[Figure]:
    marks = tuple(Mark(u, v, label) for label, (u, v) in labelled_points().items())
    return [
        space_picture(
            _patch(item).surface, None, replace(_PLAIN, marks=marks), unit=model(item.models[0]).unit, style=style
        )
    ]


def _triptych(item: Item, style: Style) -> list[Figure]:
    return [panels(_shaped(item), _keys(style), _PLAIN, unit=model(item.models[0]).unit, style=style)]


def _side_triptych(item: Item, style: Style) -> list[Figure]:
    scene = replace(_PLAIN, view=SIDE)
    return [panels(_shaped(item), _keys(style), scene, unit=model(item.models[0]).unit, style=style)]


def _keys(style: Style) -> Sequence[str | None]:
    """Return what the panels of a triptych show: the thesis's surface, K and H, or what is asked for."""
    return [None if key == "surface" else key for key in style.quantities or ("surface", "gaussian", "mean")]


def _projections(item: Item, style: Style) -> list[Figure]:
    return [projections(_shaped(item), unit=model(item.models[0]).unit, style=style)]


def _scales(item: Item, style: Style) -> list[Figure]:
    surfaces = [_patch(item).with_parameters({"scale": scale}).surface for scale in item.scales]
    return [comparison(surfaces, item.parts, None, _PLAIN, unit=model(item.models[0]).unit, style=style)]


def _gallery(item: Item, style: Style) -> list[Figure]:
    patches = [_patch(item).with_shape(shape) for shape in item.shapes]
    return [comparison([patch.surface for patch in patches], item.parts, None, replace(_PLAIN, net=True), style=style)]


def _shaped(item: Item) -> Surface:
    return _patch(item).with_shape(item.shapes[0]).surface


def _patch(item: Item) -> Patch:
    return model(item.models[0]).patch()


def _spell(shape: Sequence[float]) -> str:
    return "(" + ", ".join(f"{value:g}" for value in shape) + ")"


_DRAWERS: dict[str, Callable[[Item, Style], list[Figure]]] = {
    "basis": _basis,
    "hull": _hull,
    "families": _families,
    "overlays": _overlays,
    "hk_types": _hk_types,
    "shape_index": _shape_index,
    "construction": _construction,
    "pair": _pair,
    "marked": _marked,
    "triptych": _triptych,
    "side_triptych": _side_triptych,
    "projections": _projections,
    "scales": _scales,
    "gallery": _gallery,
}
