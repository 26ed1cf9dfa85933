"""The search for nearest points, compiled: a tree of boxes around triangles, then Newton on polynomial pieces.

Each triangle stands for a piece of a surface that is nowhere farther from it than its ``slack``. So no triangle that is
farther than the nearest one by more than both slacks can hold the nearest point, and Newton starts from all others.
"""

import numpy as np
from numpy.typing import NDArray

from quintrig.support.array_loops import array_loop
from quintrig.support.arrays import FloatArray

DEGREE = 7
"""Of the polynomial pieces, in each parameter."""

MOST = 96
"""Starts of Newton's iteration at one point that are kept; only points as good as equally far from a whole surface, as
the centre of a sphere is, have more."""

_LAST = 1e-6
"""A step of Newton's over parameters as short as this is the last: the next would be of the order of its square."""

Ints = NDArray[np.int64]


@array_loop
def evaluate(pieces: FloatArray, at: int, s: float, t: float, rows: FloatArray, out: FloatArray) -> None:
    """Write S, S_s, S_t, S_ss, S_st, S_tt of a piece (t power, coordinate, s power) to ``out`` (6, 3).

    ``rows`` (3, 3, 8) is room to work in.
    """
    n = 8
    for x in range(3):
        for i in range(n):
            rows[0, x, i] = pieces[at, n - 1, x, i]
            rows[1, x, i] = 0.0
            rows[2, x, i] = 0.0
        for j in range(n - 2, -1, -1):
            for i in range(n):
                rows[2, x, i] = rows[2, x, i] * t + rows[1, x, i]
                rows[1, x, i] = rows[1, x, i] * t + rows[0, x, i]
                rows[0, x, i] = rows[0, x, i] * t + pieces[at, j, x, i]
        value = first = second = by_t = mixed = 0.0
        twice = 0.0
        for i in range(n - 1, -1, -1):
            second = second * s + first
            first = first * s + value
            value = value * s + rows[0, x, i]
            mixed = mixed * s + by_t
            by_t = by_t * s + rows[1, x, i]
            twice = twice * s + rows[2, x, i]
        out[0, x] = value
        out[1, x] = first
        out[2, x] = by_t
        out[3, x] = 2.0 * second
        out[4, x] = mixed
        out[5, x] = 2.0 * twice


@array_loop
def cell(edges: FloatArray, start: int, count: int, t: float) -> int:
    """Return which of ``count`` intervals, whose ends begin at ``start`` of ``edges``, holds a parameter."""
    low, high = 0, count
    while high - low > 1:
        middle = (low + high) // 2
        if t < edges[start + middle]:
            high = middle
        else:
            low = middle
    return low


@array_loop
def place(
    heads: Ints, edges: FloatArray, pieces: FloatArray, one: int, u: float, v: float, rows: FloatArray, out: FloatArray
) -> None:
    """Write S and its derivatives by u and v of surface ``one`` to ``out`` (6, 3)."""
    nu, nv = heads[one, 0], heads[one, 1]
    start_u, start_v = heads[one, 2], heads[one, 3]
    i, j = cell(edges, start_u, nu, u), cell(edges, start_v, nv, v)
    low_u, low_v = float(edges[start_u + i]), float(edges[start_v + j])
    scale_u = 2.0 / (float(edges[start_u + i + 1]) - low_u)
    scale_v = 2.0 / (float(edges[start_v + j + 1]) - low_v)
    evaluate(pieces, heads[one, 4] + i * nv + j, (u - low_u) * scale_u - 1.0, (v - low_v) * scale_v - 1.0, rows, out)
    for x in range(3):
        out[1, x] *= scale_u
        out[2, x] *= scale_v
        out[3, x] *= scale_u * scale_u
        out[4, x] *= scale_u * scale_v
        out[5, x] *= scale_v * scale_v


@array_loop
def descend(
    heads: Ints,
    edges: FloatArray,
    pieces: FloatArray,
    one: int,
    p: FloatArray,
    u: float,
    v: float,
    rows: FloatArray,
    d: FloatArray,
) -> tuple[float, float, float]:
    """Return the squared distance and (u, v) of a local minimum of |S - p| over the square, from a start.

    Newton's step where the second derivatives are those of a minimum, Gauss and Newton's elsewhere, each halved until
    it goes down; parameters at the border stay there while the distance falls towards the outside.
    """
    place(heads, edges, pieces, one, u, v, rows, d)
    here = (d[0, 0] - p[0]) ** 2 + (d[0, 1] - p[1]) ** 2 + (d[0, 2] - p[2]) ** 2
    for _ in range(60):
        gu = gv = e = f = g = huu = huv = hvv = 0.0
        for x in range(3):
            r = d[0, x] - p[x]
            gu += r * d[1, x]
            gv += r * d[2, x]
            e += d[1, x] * d[1, x]
            f += d[1, x] * d[2, x]
            g += d[2, x] * d[2, x]
            huu += r * d[3, x]
            huv += r * d[4, x]
            hvv += r * d[5, x]
        fixed_u = (u <= 0.0 and gu > 0.0) or (u >= 1.0 and gu < 0.0)
        fixed_v = (v <= 0.0 and gv > 0.0) or (v >= 1.0 and gv < 0.0)
        if fixed_u and fixed_v:
            break
        huu += e
        huv += f
        hvv += g
        tiny = 1e-12 * (e + g) + 1e-300
        du = dv = 0.0
        newton = True
        if fixed_u:
            newton = hvv > 0.02 * g
            dv = -gv / (hvv if newton else g + tiny)
        elif fixed_v:
            newton = huu > 0.02 * e
            du = -gu / (huu if newton else e + tiny)
        else:
            newton = huu > 0.0 and hvv > 0.0 and huu * hvv - huv * huv > 0.02 * (e * g - f * f) + tiny * tiny
            a = huu if newton else e + tiny
            b = huv if newton else f
            c = hvv if newton else g + tiny
            over = 1.0 / (a * c - b * b)
            du = (b * gv - c * gu) * over
            dv = (b * gu - a * gv) * over
        share = 1.0
        moved = False
        best_u, best_v = u, v
        step_u = step_v = 0.0
        for _ in range(24):
            new_u = min(1.0, max(0.0, u + share * du))
            new_v = min(1.0, max(0.0, v + share * dv))
            step_u, step_v = abs(new_u - u), abs(new_v - v)
            if step_u + step_v < 1e-15:
                break
            place(heads, edges, pieces, one, new_u, new_v, rows, d)
            there = (d[0, 0] - p[0]) ** 2 + (d[0, 1] - p[1]) ** 2 + (d[0, 2] - p[2]) ** 2
            if there < here:
                here = there
                best_u, best_v = new_u, new_v
                moved = True
                break
            share *= 0.5 if share > 0.1 else 0.1
        u, v = best_u, best_v
        if not moved or (newton and step_u < _LAST and step_v < _LAST):
            break
    return here, u, v


@array_loop
def nearest(
    points: FloatArray,
    boxes: FloatArray,
    corners: FloatArray,
    places: FloatArray,
    slacks: FloatArray,
    owners: Ints,
    leaf: int,
    heads: Ints,
    edges: FloatArray,
    pieces: FloatArray,
    found: FloatArray,
    which: Ints,
) -> None:
    """Write squared distance, u and v to ``found`` (n, 3), and the number of the surface to ``which`` (n,).

    ``boxes`` (2 leaves, 6) are a heap; each leaf has ``leaf`` triangles: ``corners`` (m, 9), ``places`` (m, 6).
    """
    leaves = boxes.shape[0] // 2
    stack = np.empty(128, dtype=np.int64)
    aways = np.empty(128)
    lows = np.empty(MOST)
    starts = np.empty((MOST, 2))
    whose = np.empty(MOST, dtype=np.int64)
    done = np.empty((MOST, 2))
    rows = np.empty((3, 3, 8))
    d = np.empty((6, 3))
    for k in range(points.shape[0]):
        p = points[k]
        upper = np.inf
        count = 0
        stack[0], aways[0] = 1, 0.0
        top = 1
        while top:
            top -= 1
            node = stack[top]
            if aways[top] > upper * upper:
                continue
            if node < leaves:
                top = opened(boxes, node, p, stack, aways, top)
                continue
            first = (node - leaves) * leaf
            for m in range(first, first + leaf):
                if not slacks[m] < np.inf:
                    continue
                away, s, t = to_triangle(corners, m, p)
                low = away - slacks[m]
                if low > upper:
                    continue
                upper = min(upper, away + slacks[m])
                if count == MOST:  # forget those that the new bound rules out, or else the worst
                    kept = 0
                    for i in range(MOST):
                        if lows[i] <= upper:
                            lows[kept], whose[kept] = lows[i], whose[i]
                            starts[kept, 0], starts[kept, 1] = starts[i, 0], starts[i, 1]
                            kept += 1
                    count = kept
                at = count
                if count == MOST:
                    at = int(np.argmax(lows))
                    if lows[at] <= low:
                        continue
                else:
                    count += 1
                lows[at] = low
                whose[at] = owners[m]
                r = 1.0 - s - t
                starts[at, 0] = r * places[m, 0] + s * places[m, 2] + t * places[m, 4]
                starts[at, 1] = r * places[m, 1] + s * places[m, 3] + t * places[m, 5]
        best = np.inf
        best_u = best_v = 0.0
        owner = -1
        tried = 0
        for _ in range(count):
            at = int(np.argmin(lows[:count]))
            low = lows[at]
            if low == np.inf or (low > 0.0 and low * low > best):
                break
            lows[at] = np.inf
            u, v, one = starts[at, 0], starts[at, 1], whose[at]
            again = False
            for i in range(tried):  # triangles meet in sides and corners, and start in the same place
                if whose[at] == int(done[i, 0] // 4.0) and abs(done[i, 0] % 4.0 - u) + abs(done[i, 1] - v) < 1e-6:
                    again = True
            if again:
                continue
            done[tried, 0], done[tried, 1] = 4.0 * one + u, v
            tried += 1
            away, u, v = descend(heads, edges, pieces, one, p, u, v, rows, d)
            if away < best:
                best, best_u, best_v, owner = away, u, v, one
        found[k, 0], found[k, 1], found[k, 2] = best, best_u, best_v
        which[k] = owner


@array_loop
def box_distance(boxes: FloatArray, node: int, p: FloatArray) -> float:
    """Return the squared distance of a point from a box."""
    result = 0.0
    for x in range(3):
        low, high = boxes[node, x] - p[x], p[x] - boxes[node, 3 + x]
        gap = max(low, high, 0.0)
        result += gap * gap
    return result


@array_loop
def opened(boxes: FloatArray, node: int, p: FloatArray, stack: Ints, aways: FloatArray, top: int) -> int:
    """Put both halves of a node on the stack, the nearer one above, and return the new height of the stack."""
    one, other = 2 * node, 2 * node + 1
    first_gap, second_gap = box_distance(boxes, one, p), box_distance(boxes, other, p)
    if first_gap < second_gap:
        one, other = other, one
        first_gap, second_gap = second_gap, first_gap
    stack[top], aways[top] = one, first_gap
    stack[top + 1], aways[top + 1] = other, second_gap
    return top + 2


@array_loop
def to_triangle(corners: FloatArray, m: int, p: FloatArray) -> tuple[float, float, float]:
    """Return the distance of a point from a triangle, and the shares of its second and third corner (Ericson 2005)."""
    d1 = d2 = d3 = d4 = d5 = d6 = 0.0
    for x in range(3):
        ab, ac = corners[m, 3 + x] - corners[m, x], corners[m, 6 + x] - corners[m, x]
        ap, bp, cp = p[x] - corners[m, x], p[x] - corners[m, 3 + x], p[x] - corners[m, 6 + x]
        d1 += ab * ap
        d2 += ac * ap
        d3 += ab * bp
        d4 += ac * bp
        d5 += ab * cp
        d6 += ac * cp
    s = t = 0.0
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    if d1 <= 0.0 and d2 <= 0.0:
        s, t = 0.0, 0.0
    elif d3 >= 0.0 and d4 <= d3:
        s, t = 1.0, 0.0
    elif d6 >= 0.0 and d5 <= d6:
        s, t = 0.0, 1.0
    elif vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0 and d1 - d3 > 0.0:
        s, t = d1 / (d1 - d3), 0.0
    elif vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0 and d2 - d6 > 0.0:
        s, t = 0.0, d2 / (d2 - d6)
    elif va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0 and (d4 - d3) + (d5 - d6) > 0.0:
        t = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        s = 1.0 - t
    elif va + vb + vc > 0.0:
        s, t = vb / (va + vb + vc), vc / (va + vb + vc)
    away = 0.0
    for x in range(3):
        r = 1.0 - s - t
        gap = r * corners[m, x] + s * corners[m, 3 + x] + t * corners[m, 6 + x] - p[x]
        away += gap * gap
    return np.sqrt(away), s, t


@array_loop
def nearest_triangle(
    points: FloatArray, boxes: FloatArray, corners: FloatArray, leaf: int, found: FloatArray, which: Ints
) -> None:
    """Write distance and the two shares to ``found`` (n, 3), and the number of the triangle to ``which`` (n,)."""
    leaves = boxes.shape[0] // 2
    stack = np.empty(128, dtype=np.int64)
    aways = np.empty(128)
    for k in range(points.shape[0]):
        p = points[k]
        best = np.inf
        stack[0], aways[0] = 1, 0.0
        top = 1
        while top:
            top -= 1
            node = stack[top]
            if aways[top] > best * best:
                continue
            if node < leaves:
                top = opened(boxes, node, p, stack, aways, top)
                continue
            for m in range((node - leaves) * leaf, (node - leaves + 1) * leaf):
                away, s, t = to_triangle(corners, m, p)
                if away < best:
                    best = away
                    found[k, 0], found[k, 1], found[k, 2] = away, s, t
                    which[k] = m
