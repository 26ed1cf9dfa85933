"""Lines of a field on one patch, compiled: begun, and followed until they leave, close or end, as points near enough.

A line under way is ``LINE`` real numbers: its state, du and dv of where it heads, what is left of its length, the step
to try, the point and direction where it began, those where it is, the mode of the field, how many steps were tried, how
the last run ended, and how many points that gave. The last step before an edge takes the parameter that leaves as its
variable, so that it ends on the edge exactly (Hénon 1982).
"""

import numpy as np

from quintrig.interrogation.dop853 import STAGES
from quintrig.interrogation.field_jit import GEODESIC, PARTIALS, STATE, lifted, lowered, slope, surface_at
from quintrig.support.compiled import loop, part
from quintrig.support.memory import floats_at

AIM, LEFT, STEP, HOME, HEADING, POINT, TOWARDS, MODE, TRIED, ENDED, COUNT, LINE = 5, 7, 8, 9, 12, 15, 18, 21, 22, 23, 24, 25
"""Where a line's numbers stand, the state being first, and how many there are."""

MORE, LEAVES, CLOSED, NO_DIRECTION, LENGTH, STEPS = 0, 1, 2, 3, 4, 5
"""How a run ends: for want of room, at an edge, at its beginning, where the field ends, at its length, after _MOST."""

FINEST = 256
"""Chords of a step."""

MEETS = 1e-6
"""Of the size: nearer than this to its start, a line is closed."""

AWAY = 1e-2
"""Of the size: before this no line comes back."""

_MOST = 4000  # steps of a line in one patch
_LONGEST = 0.1  # of the size: a step
_SHORTEST = 1e-10  # of the size: a step; a line that needs shorter ones ends
_BEYOND = 1e-13  # of the domain: rounding
_OVER = 1e-9  # of the size: what a line may be too long to end on an edge
_PROBES = 9  # points of a step by which its chords are counted

# Scratch: states, slopes of all stages, coefficients of the dense output, probes; then what a surface needs.
_END = STATE
_K = 2 * STATE
_C = _K + STAGES * STATE
_PROBE = _C + 8 * STATE
SCRATCH = _PROBE + 3 * _PROBES + 8
"""Numbers of scratch before those that a surface needs."""


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


@part
def _rate(
    surface: int, kind: int, mode: int, y: int, aim_u: float, aim_v: float, axis: int, reach: float, out: int, work: int
) -> int:
    """Write the slope by arc length, or with an ``axis`` by the share of what is left of its parameter."""
    ended = slope(surface, kind, mode, y, aim_u, aim_v, out, work)
    if axis >= 0:
        k = floats_at(out)
        per = reach / k[axis]
        for j in range(STATE):
            k[j] *= per
    return ended


@part
def _stage(scratch: int, table: int, row: int, h: float, out: int) -> None:
    y, k, a, found = floats_at(scratch), floats_at(scratch + 8 * _K), floats_at(table + 8 * STAGES * row), floats_at(out)
    for j in range(STATE):
        total = 0.0
        for i in range(row):
            total += a[i] * k[i * STATE + j]
        found[j] = y[j] + h * total


@part
def _error(scratch: int, table: int, h: float, relative: float, kind: int) -> float:
    """Return the error of a step in units of what is allowed: ``relative`` of the domain, and of the speeds."""
    y, end, k = floats_at(scratch), floats_at(scratch + 8 * _END), floats_at(scratch + 8 * _K)
    five, three = floats_at(table + 8 * STAGES * 16), floats_at(table + 8 * STAGES * 17)
    number = 4 if kind == GEODESIC else 2
    speed = max(abs(y[2]), abs(y[3]), abs(end[2]), abs(end[3]))
    square5 = square3 = 0.0
    for j in range(number):
        place = 0.1 + max(abs(y[j]), abs(end[j]))
        scale = relative * (place if j < 2 else speed)
        e5 = e3 = 0.0
        for i in range(13):
            e5 += five[i] * k[i * STATE + j]
            e3 += three[i] * k[i * STATE + j]
        square5 += (e5 / scale) * (e5 / scale)
        square3 += (e3 / scale) * (e3 / scale)
    if square5 == 0.0:
        return 0.0
    return abs(h) * square5 / np.sqrt((square5 + 0.01 * square3) * number)


@part
def _dense(scratch: int, table: int, h: float) -> None:
    """Write the coefficients of the dense output of order 7."""
    y, end, k = floats_at(scratch), floats_at(scratch + 8 * _END), floats_at(scratch + 8 * _K)
    c = floats_at(scratch + 8 * _C)
    for j in range(STATE):
        gain = end[j] - y[j]
        c[j] = y[j]
        c[STATE + j] = gain
        c[2 * STATE + j] = h * k[j] - gain
        c[3 * STATE + j] = 2.0 * gain - h * (k[12 * STATE + j] + k[j])
        for row in range(4):
            d = floats_at(table + 8 * STAGES * (18 + row))
            total = 0.0
            for i in range(STAGES):
                total += d[i] * k[i * STATE + j]
            c[(4 + row) * STATE + j] = h * total


@part
def _at(scratch: int, x: float, j: int) -> float:
    """Return number j of the state at share x of a step."""
    c = floats_at(scratch + 8 * _C)
    value = 0.0
    for i in range(7):
        value = (value + c[(7 - i) * STATE + j]) * (x if i % 2 == 0 else 1.0 - x)
    return value + c[j]


@part
def _inside(t: float) -> float:
    return min(max(t, 0.0), 1.0)


@part
def _ahead(surface: int, line: int, scratch: int, x: float) -> float:
    """Return how far the line is past the plane through its beginning at share x of a step (length¹)."""
    work = scratch + 8 * SCRATCH
    w, s = floats_at(line), floats_at(work)
    surface_at(surface, _inside(_at(scratch, x, 0)), _inside(_at(scratch, x, 1)), 0, work)
    past = 0.0
    for i in range(3):
        past += (s[i] - w[HOME + i]) * w[HEADING + i]
    return past


@part
def _home(surface: int, line: int, scratch: int, ds: float, size: float) -> float:
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
def _chords(surface: int, scratch: int, share: float, chord: float, longest: float) -> int:
    """Return into how many chords a step up to a share of it must be cut."""
    work = scratch + 8 * SCRATCH
    s, p = floats_at(work), floats_at(scratch + 8 * _PROBE)
    length = 0.0
    for i in range(_PROBES):
        x = share * i / (_PROBES - 1.0)
        surface_at(surface, _inside(_at(scratch, x, 0)), _inside(_at(scratch, x, 1)), 0, work)
        square = 0.0
        for j in range(3):
            p[3 * i + j] = s[j]
            if i:
                square += (p[3 * i + j] - p[3 * i - 3 + j]) ** 2
        length += np.sqrt(square)
    off = 0.0
    for i in range(1, _PROBES, 2):
        square = 0.0
        for j in range(3):
            gap = p[3 * i + j] - 0.5 * (p[3 * i - 3 + j] + p[3 * i + 3 + j])
            square += gap * gap
        off = max(off, square)
    wanted = max(4.4 * np.sqrt(np.sqrt(off) / chord), length / longest)
    return max(1, min(FINEST, int(np.ceil(wanted)))) if wanted < FINEST else FINEST


@part
def _exit(scratch: int, reach: float) -> int:
    """Return axis + 2 end through which a line leaves that goes straight on within ``reach`` (length¹), else -1."""
    y, k = floats_at(scratch), floats_at(scratch + 8 * _K)
    best, found = reach, -1
    for axis in range(2):
        speed = k[axis]
        if abs(speed) > 0.0:
            s = ((1.0 if speed > 0.0 else 0.0) - y[axis]) / speed
            if s <= best:
                best, found = s, axis + (2 if speed > 0.0 else 0)
    return found


@loop
def follow(
    surface: int, kind: int, line: int, settings: int, table: int, points: int, room: int, scratch: int
) -> None:
    """Follow a line, and write u and v of its points, and of those in the middle between two, to ``points`` (room, 2).

    ``settings`` are the relative error of a step, the size (length¹), the chord error to keep and the longest chord.
    The last point is the line's state.
    """
    w, out, told = floats_at(line), floats_at(points), floats_at(settings)
    relative, size, chord, longest = told[0], told[1], told[2], told[3]
    work = scratch + 8 * SCRATCH
    y, end, k, c = floats_at(scratch), floats_at(scratch + 8 * _END), floats_at(scratch + 8 * _K), floats_at(scratch + 8 * _C)
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
        stop = _rate(surface, kind, mode, scratch, w[AIM], w[AIM + 1], axis, reach, scratch + 8 * _K, work)
        for i in range(1, 13):
            _stage(scratch, table, i, h, scratch + 8 * _END)
            at = scratch + 8 * (_K + i * STATE)
            stop = _rate(surface, kind, mode, scratch + 8 * _END, w[AIM], w[AIM + 1], axis, reach, at, work)
        error = _error(scratch, table, h, relative, kind)
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
        for i in range(13, STAGES):
            _stage(scratch, table, i, h, scratch + 8 * _PROBE)
            at = scratch + 8 * (_K + i * STATE)
            _rate(surface, kind, mode, scratch + 8 * _PROBE, w[AIM], w[AIM + 1], axis, reach, at, work)
        _dense(scratch, table, h)
        finite = True
        for i in range(8 * STATE):
            finite = finite and abs(c[i]) < 1e300
        if not finite:
            if axis < 0:
                step, held = 0.5 * h, True
                ended = NO_DIRECTION if step < _SHORTEST * size else MORE
            else:
                axis, step, held = -1, 0.5 * step, True
                ended = NO_DIRECTION if step < _SHORTEST * size else MORE
            continue
        ds, share = end[4] - y[4], 1.0
        if y[4] > AWAY * size:
            back = _home(surface, line, scratch, ds, size)
            if back <= 1.0:
                share, ended = back, CLOSED
        chords = 2 * _chords(surface, scratch, share, chord, longest)
        for i in range(chords):
            x = share * i / chords
            out[2 * count], out[2 * count + 1] = _inside(_at(scratch, x, 0)), _inside(_at(scratch, x, 1))
            count += 1
        if ended == CLOSED:
            for j in range(STATE):
                end[j] = _at(scratch, share, j)
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
    w[0], w[1] = _inside(y[0]), _inside(y[1])
    surface_at(surface, w[0], w[1], 1, work)
    s = floats_at(work)
    for x in range(3):
        w[POINT + x] = s[x]
    length = lifted(work, w[AIM], w[AIM + 1], line + 8 * TOWARDS)
    for x in range(3):
        w[TOWARDS + x] /= length
    w[STEP], w[ENDED], w[COUNT] = step, float(ended), float(count)
