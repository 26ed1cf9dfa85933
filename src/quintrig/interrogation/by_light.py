"""Lines that light draws: isophotes, draft angles, silhouettes, reflections and highlights."""

from collections.abc import Sequence

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation import fields
from quintrig.interrogation.ask import Ask, degrees, few, length, vector
from quintrig.interrogation.found import Found, Level, Make, bent, level_lines
from quintrig.interrogation.polyline import Values
from quintrig.interrogation.subject import Subject
from quintrig.support.arrays import FloatArray, frozen, whole

_UP = (0.0, 0.0, 1.0)


def _angle(direction: FloatArray, draft: bool) -> Values:
    """Return the angle of the normal to a direction, or of the tangent plane (draft), degrees."""
    offset = 90.0 if draft else 0.0
    sense = -1.0 if draft else 1.0

    def values(surface: Surface, uv: FloatArray) -> FloatArray:
        cosine = fields.normal_scalar(surface, direction)(*uv.T)[0]
        return offset + sense * np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))

    return values


def _direction(ask: Ask, usual: Sequence[float] | None = _UP) -> FloatArray:
    if ask.direction is None and usual is None:
        raise ValueError("direction: expected a vector X,Y,Z, found none")
    return vector(usual if ask.direction is None else ask.direction, "direction")


def isophotes(on: Subject, ask: Ask) -> Found:
    """Equal angle between the normal and the light: every 10 degrees, or at given angles."""
    direction = _direction(ask)
    if ask.angles is not None:
        angles = degrees(ask.angles, "angles", 0.0, 180.0)
    else:
        count = 17 if ask.count is None else whole(ask.count, "count", 1)
        few(count, "count", "ask for fewer")
        angles = np.linspace(0.0, 180.0, count + 2)[1:-1]
    wanted = [Level(float(np.cos(np.radians(a))), f"{a:g}°", a) for a in angles.tolist()]
    found = Found("angle to the light", "°")
    return level_lines(on, lambda s: fields.normal_scalar(s, direction), wanted, found, _angle(direction, False))


def draft(on: Subject, ask: Ask) -> Found:
    """Equal draft angle, that of the tangent plane with the pull direction, + where the normal points along it."""
    direction = _direction(ask)
    angles = degrees((-5.0, -3.0, 0.0, 3.0, 5.0) if ask.angles is None else ask.angles, "angles", -90.0, 90.0)
    wanted = [Level(float(np.sin(np.radians(a))), f"{a:g}°", a) for a in angles.tolist()]
    found = Found("draft angle", "°")
    return level_lines(on, lambda s: fields.normal_scalar(s, direction), wanted, found, _angle(direction, True))


def silhouette(on: Subject, ask: Ask) -> Found:
    """The outline seen along a direction, or from a point."""
    if ask.eye is not None and ask.direction is not None:
        raise ValueError("eye: expected either an eye (a point) or a direction, found both")
    level = [Level(0.0, "silhouette")]
    if ask.eye is not None:
        eye = frozen(ask.eye, "eye", (3,))
        return level_lines(on, lambda s: fields.facing_scalar(s, eye), level, bent(on), fields.normal_curvature)
    direction = _direction(ask, None)
    return level_lines(on, lambda s: fields.normal_scalar(s, direction), level, bent(on), fields.normal_curvature)


def _lights(on: Subject, ask: Ask) -> tuple[FloatArray, FloatArray, list[Level], FloatArray]:
    """Return a point of the middle light, the lights' direction, their places, and where they are moved."""
    centre = 0.5 * (on.low + on.high)
    light = centre + np.array([0.0, 0.0, 2.0 * on.size]) if ask.light is None else frozen(ask.light, "light", (3,))
    along = vector((0.0, 1.0, 0.0) if ask.along is None else ask.along, "along")
    count = whole(11 if ask.count is None else ask.count, "count", 1)
    few(count, "count", "ask for fewer")
    spacing = length(ask.spacing, "spacing", 0.2 * on.size)
    places = (np.arange(count) - 0.5 * (count - 1)) * spacing
    across = fields.sideways(centre, on.size, light, along)
    return light, along, [Level(x, f"light {k + 1}", x) for k, x in enumerate(places.tolist())], across


def highlight(on: Subject, ask: Ask) -> Found:
    """Where the normal, as a line without end, meets a line of light."""
    light, along, wanted, across = _lights(on, ask)
    make: Make = lambda s: fields.lights_scalar(s, light, along, across, None)  # noqa: E731
    return level_lines(on, make, wanted, bent(on), fields.normal_curvature)


def reflection(on: Subject, ask: Ask) -> Found:
    """Parallel lights as an eye sees them in the surface: from a point, or from afar."""
    light, along, wanted, across = _lights(on, ask)
    if ask.eye is not None and ask.direction is not None:
        raise ValueError("eye: expected either an eye (a point) or a direction towards it, found both")
    afar = vector((1.0, 0.0, 1.0) if ask.direction is None else ask.direction, "direction")
    eye = None if ask.eye is None else frozen(ask.eye, "eye", (3,))

    def view(points: FloatArray) -> FloatArray:
        if eye is None:
            return np.broadcast_to(afar, points.shape)
        ray = eye - points
        return ray / np.linalg.norm(ray, axis=-1)[..., None]

    make: Make = lambda s: fields.lights_scalar(s, light, along, across, view)  # noqa: E731
    return level_lines(on, make, wanted, bent(on), fields.normal_curvature)
