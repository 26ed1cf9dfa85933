"""One step of a line, compiled: its stages, its error and its dense output.

Scratch holds the state, the state at the end, the slopes of all stages, the coefficients of the dense output and points
by which chords are counted; then what a surface needs.
"""

import numpy as np

from quintrig.interrogation.dop853 import STAGES
from quintrig.interrogation.field_jit import GEODESIC, STATE, slope
from quintrig.support.compiled import part
from quintrig.support.memory import floats_at

PROBES = 9
"""Points of a step by which its chords are counted."""

END = STATE
SLOPES = 2 * STATE
DENSE = SLOPES + STAGES * STATE
PROBE = DENSE + 8 * STATE
SCRATCH = PROBE + 3 * PROBES + 8
"""Where each stands in scratch, and where that of a surface begins."""


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
    y, k, a, found = (
        floats_at(scratch),
        floats_at(scratch + 8 * SLOPES),
        floats_at(table + 8 * STAGES * row),
        floats_at(out),
    )
    for j in range(STATE):
        total = 0.0
        for i in range(row):
            total += a[i] * k[i * STATE + j]
        found[j] = y[j] + h * total


@part
def attempt(
    surface: int,
    kind: int,
    mode: int,
    aim_u: float,
    aim_v: float,
    axis: int,
    reach: float,
    h: float,
    table: int,
    scratch: int,
) -> int:
    """Take the twelve stages of a step, and the slope at its end; return 1 where the field ends there."""
    work = scratch + 8 * SCRATCH
    stop = _rate(surface, kind, mode, scratch, aim_u, aim_v, axis, reach, scratch + 8 * SLOPES, work)
    for i in range(1, 13):
        _stage(scratch, table, i, h, scratch + 8 * END)
        at = scratch + 8 * (SLOPES + i * STATE)
        stop = _rate(surface, kind, mode, scratch + 8 * END, aim_u, aim_v, axis, reach, at, work)
    return stop


@part
def error_of(scratch: int, table: int, h: float, relative: float, kind: int) -> float:
    """Return the error of a step in units of what is allowed: ``relative`` of the domain, and of the speeds."""
    y, end, k = floats_at(scratch), floats_at(scratch + 8 * END), floats_at(scratch + 8 * SLOPES)
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
    y, end, k = floats_at(scratch), floats_at(scratch + 8 * END), floats_at(scratch + 8 * SLOPES)
    c = floats_at(scratch + 8 * DENSE)
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
def finish(
    surface: int,
    kind: int,
    mode: int,
    aim_u: float,
    aim_v: float,
    axis: int,
    reach: float,
    h: float,
    table: int,
    scratch: int,
) -> bool:
    """Write the dense output of a step whose stages are there; return whether it is finite."""
    work = scratch + 8 * SCRATCH
    for i in range(13, STAGES):
        _stage(scratch, table, i, h, scratch + 8 * PROBE)
        at = scratch + 8 * (SLOPES + i * STATE)
        _rate(surface, kind, mode, scratch + 8 * PROBE, aim_u, aim_v, axis, reach, at, work)
    _dense(scratch, table, h)
    c, finite = floats_at(scratch + 8 * DENSE), True
    for i in range(8 * STATE):
        finite = finite and abs(c[i]) < 1e300
    return finite


@part
def state_at(scratch: int, x: float, j: int) -> float:
    """Return number j of the state at share x of a step."""
    c = floats_at(scratch + 8 * DENSE)
    value = 0.0
    for i in range(7):
        value = (value + c[(7 - i) * STATE + j]) * (x if i % 2 == 0 else 1.0 - x)
    return value + c[j]
