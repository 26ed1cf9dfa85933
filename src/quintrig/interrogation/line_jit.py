"""Lines under way, compiled: begun, back at their beginning, cut into chords, and met by the edges of neighbours.

A line is ``LINE`` real numbers: its state, du and dv of where it heads, what is left of its length, the step to try,
the point and direction where it began, those where it is, the mode of the field, how many steps were tried, how the
last run ended, and how many points that gave.
"""

import numpy as np

from quintrig.interrogation.field_jit import GEODESIC, lifted, lowered, slope, surface_at
from quintrig.interrogation.step_jit import PROBE, PROBES, SCRATCH, state_at
from quintrig.kernel.contraction import DU, DV
from quintrig.support.compiled import loop, part
from quintrig.support.memory import floats_at

AIM, LEFT, STEP, HOME, HEADING, POINT, TOWARDS, MODE, TRIED, ENDED, COUNT, LINE = (
    5,
    7,
    8,
    9,
    12,
    15,
    18,
    21,
    22,
    23,
    24,
    25,
)
"""Where a line's numbers stand, the state being first, and how many there are."""

MORE, LEAVES, CLOSED, NO_DIRECTION, LENGTH, STEPS = 0, 1, 2, 3, 4, 5
"""How a run ends: for want of room, at an edge, at its beginning, where the field ends, at its length, after _MOST."""

FINEST = 256
"""Chords of a step."""

MEETS = 1e-6
"""Of the size: nearer than this to its start, a line is closed."""

AWAY = 1e-2
"""Of the size: before this no line comes back."""


@part
def inside(t: float) -> float:
    """Return a parameter in the domain."""
    return min(max(t, 0.0), 1.0)


@loop
def begin(surface: int, kind: int, lines: int, count: int, scratch: int) -> None:
    """Begin ``count`` lines at their states: TOWARDS holds a vector, or NaN and AIM du and dv of the sense to take."""
    work = scratch + 8 * SCRATCH
    for i in range(count):
        line = lines + 8 * LINE * i
        w = floats_at(line)
        surface_at(surface, w[0], w[1], 1, work)
        s, k = floats_at(work), floats_at(scratch)
        if w[TOWARDS] == w[TOWARDS]:
            w[AIM], w[AIM + 1] = lowered(work, w[TOWARDS], w[TOWARDS + 1], w[TOWARDS + 2])
        if kind == GEODESIC:
            size = lifted(work, w[AIM], w[AIM + 1], scratch)
            w[2], w[3] = w[AIM] / size, w[AIM + 1] / size
        ended = slope(surface, kind, int(w[MODE]), line, w[AIM], w[AIM + 1], scratch, work)
        w[AIM], w[AIM + 1] = k[0], k[1]
        size = lifted(work, w[AIM], w[AIM + 1], line + 8 * TOWARDS)
        for x in range(3):
            w[POINT + x] = s[x]
        w[ENDED] = float(NO_DIRECTION if ended or not size > 0.0 else MORE)


@loop
def foot(surface: int, axis: int, asked: int, scratch: int) -> None:
    """Find the foot of a point on the edge along which the parameter ``axis`` is constant, by Newton's iteration.

    ``asked`` holds u and v to begin at, the point and a direction (3,); after them it is told how far the point is, how
    far the direction leads along its tangent part, and that part in du and dv.
    """
    w, s = floats_at(asked), floats_at(scratch)
    other = 1 - axis
    at = DV if axis == 0 else DU
    for _ in range(30):
        surface_at(surface, w[0], w[1], 1, scratch)
        along, square = 0.0, 0.0
        for x in range(3):
            along += (w[2 + x] - s[x]) * s[at + x]
            square += s[at + x] * s[at + x]
        moved = inside(w[other] + along / square) if square > 0.0 else w[other]
        near = abs(moved - w[other]) <= 1e-14
        w[other] = moved
        if near:
            break
    surface_at(surface, w[0], w[1], 1, scratch)
    gap = 0.0
    for x in range(3):
        gap += (w[2 + x] - s[x]) * (w[2 + x] - s[x])
    w[10], w[11] = lowered(scratch, w[5], w[6], w[7])
    w[8], w[9] = np.sqrt(gap), 0.0
    for x in range(3):
        w[9] += (w[10] * s[DU + x] + w[11] * s[DV + x]) * w[5 + x]


@part
def _ahead(surface: int, line: int, scratch: int, x: float) -> float:
    """Return how far the line is past the plane through its beginning at share x of a step (length¹)."""
    work = scratch + 8 * SCRATCH
    w, s = floats_at(line), floats_at(work)
    surface_at(surface, inside(state_at(scratch, x, 0)), inside(state_at(scratch, x, 1)), 0, work)
    past = 0.0
    for i in range(3):
        past += (s[i] - w[HOME + i]) * w[HEADING + i]
    return past


@part
def home(surface: int, line: int, scratch: int, ds: float, size: float) -> float:
    """Return the share of a step at which the line is back at its beginning, 2 where it is not."""
    work = scratch + 8 * SCRATCH
    w, s = floats_at(line), floats_at(work)
    end = _ahead(surface, line, scratch, 1.0)
    near = 0.0
    for i in range(3):
        near += (s[i] - w[HOME + i]) * (s[i] - w[HOME + i])
    if not (np.sqrt(near) < 1.5 * ds and end >= 0.0 and _ahead(surface, line, scratch, 0.0) < 0.0):
        return 2.0
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        if _ahead(surface, line, scratch, middle) < 0.0:
            low = middle
        else:
            high = middle
    _ahead(surface, line, scratch, high)
    near = 0.0
    for i in range(3):
        near += (s[i] - w[HOME + i]) * (s[i] - w[HOME + i])
    return high if np.sqrt(near) <= MEETS * size else 2.0


@part
def chords_of(surface: int, scratch: int, share: float, chord: float, longest: float) -> int:
    """Return into how many chords a step up to a share of it must be cut."""
    work = scratch + 8 * SCRATCH
    s, p = floats_at(work), floats_at(scratch + 8 * PROBE)
    length = 0.0
    for i in range(PROBES):
        x = share * i / (PROBES - 1.0)
        surface_at(surface, inside(state_at(scratch, x, 0)), inside(state_at(scratch, x, 1)), 0, work)
        square = 0.0
        for j in range(3):
            p[3 * i + j] = s[j]
            if i:
                square += (p[3 * i + j] - p[3 * i - 3 + j]) ** 2
        length += np.sqrt(square)
    off = 0.0
    for i in range(1, PROBES, 2):
        square = 0.0
        for j in range(3):
            gap = p[3 * i + j] - 0.5 * (p[3 * i - 3 + j] + p[3 * i + 3 + j])
            square += gap * gap
        off = max(off, square)
    wanted = max(4.4 * np.sqrt(np.sqrt(off) / chord), length / longest)
    return max(1, min(FINEST, int(np.ceil(wanted)))) if wanted < FINEST else FINEST
