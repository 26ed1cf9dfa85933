"""Curves in space: with control polygon, convex hull and curvature comb, alone or beside surfaces."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from quintrig.figure.curve import POLYGON, SAMPLES, automatic_labels, combs, different, family_colours, origin_note
from quintrig.figure.scene import Scene, Trace
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.whole import space_picture
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray

_HULL = "#9db2c4"


def space_curves(
    curves: Sequence[Curve],
    labels: Sequence[str] = (),
    scene: Scene | None = None,
    *,
    polygon: bool = True,
    hull: bool = False,
    comb: bool = False,
    title: str = "",
    unit: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
) -> Figure:
    """Return curves in space in one picture, with their control polygons, hulls or combs.

    Raises ValueError for plane curves.
    """
    if any(curve.points.shape[1] != 3 for curve in curves):
        raise ValueError("space_curves: expected curves in space (n x 3 points), found a plane one; use plane_curves")
    scene = scene or Scene()
    traces = curve_traces(curves, labels or automatic_labels(curves), polygon=polygon, hull=hull, comb=comb)
    remark = " ".join(line for curve in curves[:1] for line in origin_note(curve))
    if comb:
        remark = ". ".join(filter(None, ["Teeth of the comb point away from the centre of curvature", remark]))
    drawn = replace(scene, traces=(*scene.traces, *traces))
    return space_picture([], None, drawn, title=title, unit=unit, width=width, style=style, remark=remark)


def curve_traces(
    curves: Sequence[Curve],
    labels: Sequence[str] = (),
    *,
    polygon: bool = False,
    hull: bool = False,
    comb: bool = False,
) -> list[Trace]:
    """Return what a scene draws of curves; those of the plane lie in z = 0."""
    t = np.linspace(0.0, 1.0, SAMPLES)
    names = [*labels, *[""] * len(curves)]
    colours = family_colours(len(curves))
    traces = [
        Trace(_in_space(curve(t)), name, colour) for curve, name, colour in zip(curves, names, colours, strict=False)
    ]
    for curve in different(curves):
        if hull:
            traces += [Trace(edge, "", _HULL, 0.7) for edge in hull_edges(_in_space(curve.points))]
        if polygon:
            traces.append(Trace(_in_space(curve.points), "", POLYGON, 0.8, polygon=True))
    if comb:
        for curve, tips, colour in zip(curves, combs(curves), colours, strict=True):
            feet = curve(np.linspace(0.0, 1.0, len(tips)))
            known = np.isfinite(tips).all(axis=-1)
            pairs = np.stack([feet, tips], axis=1)[known]
            traces += [Trace(_in_space(pair), "", colour, 0.35) for pair in pairs[::4]]
            traces.append(Trace(_in_space(tips[known]), "", colour, 0.7))
    return traces


def hull_edges(points: FloatArray) -> list[FloatArray]:
    """Return the edges (2, 3) of the convex hull of points in space, its triangles' shared flat ones left out."""
    from scipy.spatial import ConvexHull, QhullError  # takes long to import

    middle = points - points.mean(axis=0)
    sizes, axes = np.linalg.svd(middle)[1:]
    if sizes[-1] <= 1e-9 * sizes[0]:  # in one plane, or on one line
        flat = middle @ axes[:2].T
        try:
            rim = ConvexHull(flat).vertices
        except QhullError:
            return []
        return [points[[a, b]] for a, b in zip(rim, np.roll(rim, -1), strict=True)]
    found = ConvexHull(points)
    sides: dict[tuple[int, int], list[int]] = {}
    for face, corners in enumerate(found.simplices.tolist()):
        for a, b in ((0, 1), (1, 2), (0, 2)):
            sides.setdefault((min(corners[a], corners[b]), max(corners[a], corners[b])), []).append(face)
    normals = found.equations[:, :3]
    return [
        points[list(edge)]
        for edge, faces in sides.items()
        if len(faces) != 2 or float(normals[faces[0]] @ normals[faces[1]]) < 1.0 - 1e-9
    ]


def _in_space(points: FloatArray) -> FloatArray:
    return np.pad(points, [(0, 0), (0, 3 - points.shape[-1])])
