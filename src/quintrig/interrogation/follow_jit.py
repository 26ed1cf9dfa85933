"""A line of a field on one patch, compiled: followed until it leaves, closes or ends, as points near enough.

The last step before an edge takes the parameter that leaves as its variable, so that it ends on the edge exactly (Hénon
1982).
"""

import numpy as np

from quintrig.interrogation.field_jit import STATE, lifted, surface_at
from quintrig.interrogation.line_jit import (
    AIM,
    AWAY,
    CLOSED,
    COUNT,
    ENDED,
    FINEST,
    LEAVES,
    LEFT,
    LENGTH,
    MODE,
    MORE,
    NO_DIRECTION,
    POINT,
    STEP,
    STEPS,
    TOWARDS,
    TRIED,
    chords_of,
    home,
    inside,
)
from quintrig.interrogation.step_jit import END, SCRATCH, SLOPES, attempt, error_of, finish, state_at
from quintrig.support.compiled import loop, part
from quintrig.support.memory import floats_at

_MOST = 4000  # steps of a line in one patch
_LONGEST = 0.1  # of the size: a step
_SHORTEST = 1e-10  # of the size: a step; a line that needs shorter ones ends
_BEYOND = 1e-13  # of the domain: rounding
_OVER = 1e-9  # of the size: what a line may be too long to end on an edge


@part
def _exit(scratch: int, reach: float) -> int:
    """Return axis + 2 end through which a line leaves that goes straight on within ``reach`` (length¹), else -1."""
    y, k = floats_at(scratch), floats_at(scratch + 8 * SLOPES)
    best, found = reach, -1
    for axis in range(2):
        speed = k[axis]
        if abs(speed) > 0.0:
            s = ((1.0 if speed > 0.0 else 0.0) - y[axis]) / speed
            if s <= best:
                best, found = s, axis + (2 if speed > 0.0 else 0)
    return found


@loop
def follow(surface: int, kind: int, line: int, settings: int, table: int, points: int, room: int, scratch: int) -> None:
    """Follow a line, and write u and v of its points, and of those in the middle between two, to ``points`` (room, 2).

    ``settings`` are the relative error of a step, the size (length¹), the chord error to keep and the longest chord.
    The last point is the line's state.
    """
    w, out, told = floats_at(line), floats_at(points), floats_at(settings)
    relative, size, chord, longest = told[0], told[1], told[2], told[3]
    work = scratch + 8 * SCRATCH
    y, end, k = floats_at(scratch), floats_at(scratch + 8 * END), floats_at(scratch + 8 * SLOPES)
    mode, step = int(w[MODE]), w[STEP]
    axis, edge, reach, done, h = -1, 0.0, 0.0, 0.0, 0.0
    count, ended, held = 0, MORE, False
    for j in range(STATE):
        y[j] = w[j]
    while ended == MORE and count + 2 * FINEST <= room:
        if w[TRIED] >= _MOST:
            ended = STEPS
            break
        w[TRIED] += 1.0
        if axis < 0:
            h = step = min(step, w[LEFT], _LONGEST * size)
        stop = attempt(surface, kind, mode, w[AIM], w[AIM + 1], axis, reach, h, table, scratch)
        error = error_of(scratch, table, h, relative, kind)
        good = error < 1.0
        factor = 0.2
        if error == 0.0:
            factor = 10.0
        elif error < np.inf:
            factor = min(max(0.85 / np.sqrt(np.sqrt(np.sqrt(error))), 0.2), 10.0)
        if axis < 0:
            if min(end[0], end[1]) < -_BEYOND or max(end[0], end[1]) > 1.0 + _BEYOND:
                leaves = _exit(scratch, min(1.5 * h, w[LEFT] + _OVER * size))
                if leaves >= 0:
                    axis, edge = leaves & 1, float(leaves >> 1)
                    reach, done, h = edge - y[axis], 0.0, 1.0
                    if reach == 0.0:
                        ended = LEAVES
                    continue
                good, factor = False, min(0.5, factor)
            if not good:
                step, held = h * min(0.9, factor), True
                if step < _SHORTEST * size:
                    ended = NO_DIRECTION
                continue
        else:
            other = end[1 - axis]
            if good and (other < -_BEYOND or other > 1.0 + _BEYOND):  # it leaves through the other side
                good, factor = False, 0.0
            if good and end[4] - y[4] > w[LEFT] + _OVER * size:  # it ends before
                good, factor = False, 0.0
            if not good:
                h *= min(0.9, factor)
                if h < 1e-6:  # it turns before the edge, or leaves through the other one
                    axis, step, held = -1, 0.5 * step, True
                    if step < _SHORTEST * size:
                        ended = NO_DIRECTION
                continue
        if not finish(surface, kind, mode, w[AIM], w[AIM + 1], axis, reach, h, table, scratch):
            axis, step, held = -1, 0.5 * step, True
            if step < _SHORTEST * size:
                ended = NO_DIRECTION
            continue
        ds, share = end[4] - y[4], 1.0
        if y[4] > AWAY * size:
            back = home(surface, line, scratch, ds, size)
            if back <= 1.0:
                share, ended = back, CLOSED
        chords = 2 * chords_of(surface, scratch, share, chord, longest)
        for i in range(chords):
            x = share * i / chords
            out[2 * count], out[2 * count + 1] = inside(state_at(scratch, x, 0)), inside(state_at(scratch, x, 1))
            count += 1
        if ended == CLOSED:
            for j in range(STATE):
                end[j] = state_at(scratch, share, j)
        for j in range(STATE):
            y[j] = end[j]
        w[AIM], w[AIM + 1] = k[12 * STATE], k[12 * STATE + 1]
        w[LEFT] -= ds
        if ended == CLOSED:
            continue
        if axis < 0:
            step = h * (min(factor, 1.0) if held else factor)
            held = False
            ended = NO_DIRECTION if stop else MORE
        else:
            done += h
            h = min(h * factor, 1.0 - done)
            if done >= 1.0 - 1e-12:
                y[axis], ended = edge, LEAVES
        if w[LEFT] <= (_OVER if ended == LEAVES else 1e-12) * size:
            ended = LENGTH
    for j in range(STATE):
        w[j] = y[j]
    w[0], w[1] = inside(y[0]), inside(y[1])
    surface_at(surface, w[0], w[1], 1, work)
    s = floats_at(work)
    for x in range(3):
        w[POINT + x] = s[x]
    length = lifted(work, w[AIM], w[AIM + 1], line + 8 * TOWARDS)
    for x in range(3):
        w[TOWARDS + x] /= length
    w[STEP], w[ENDED], w[COUNT] = step, float(ended), float(count)
