"""Each kind of lines under a name of its own; all take the options of ``quintrig.lines``, and raise what it raises."""

from typing import Any

from quintrig.geometry.surface import Surface
from quintrig.interrogation.find import lines
from quintrig.interrogation.line import Lines
from quintrig.model.model import Model
from quintrig.model.patch import Patch

_Subject = Surface | Patch | Model


def curvature_lines(subject: _Subject, **options: Any) -> Lines:
    """Return lines of curvature: a net of a ``spacing`` (length¹), through a ``start`` (u, v), or from umbilics."""
    return lines(subject, "curvature", **options)


def asymptotic_lines(subject: _Subject, **options: Any) -> Lines:
    """Return lines in whose direction the surface does not bend, where K < 0: a net, or through a ``start``."""
    return lines(subject, "asymptotic", **options)


def parabolic_lines(subject: _Subject, **options: Any) -> Lines:
    """Return the lines on which K = 0."""
    return lines(subject, "parabolic", **options)


def ridges(subject: _Subject, **options: Any) -> Lines:
    """Return crests and troughs of both ``family``s or of one, the strongest first."""
    return lines(subject, "ridges", **options)


def isophotes(subject: _Subject, **options: Any) -> Lines:
    """Return lines of equal angle (degrees) between the normal and the light from ``direction`` (x, y, z)."""
    return lines(subject, "isophotes", **options)


def reflection_lines(subject: _Subject, **options: Any) -> Lines:
    """Return what parallel lights look like in the surface, to an ``eye`` (x, y, z) or from a ``direction``."""
    return lines(subject, "reflection", **options)


def silhouettes(subject: _Subject, **options: Any) -> Lines:
    """Return the outline as seen along a ``direction`` or from an ``eye`` (x, y, z)."""
    return lines(subject, "silhouette", **options)


def section(subject: _Subject, **options: Any) -> Lines:
    """Return where a plane (``normal``, ``through``), a stack of them (``spacing``) or an ``other`` surface cuts."""
    return lines(subject, "section", **options)


def geodesic(subject: _Subject, **options: Any) -> Lines:
    """Return the straightest line from ``start`` (u, v), in a ``direction`` (degrees or x, y, z) or ``to`` (u, v)."""
    return lines(subject, "geodesic", **options)
