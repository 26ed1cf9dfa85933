"""Whether points have others near them, compiled: points are kept by the cells of a grid, in a table of chains.

``heads`` (``mask`` + 1,) holds the last point of each chain, ``links`` the one before each; -1 is none. Cells are
``edge`` wide (length¹), and nothing farther away than that is found.
"""

import numpy as np

from quintrig.support.compiled import loop, part
from quintrig.support.memory import codes_at, floats_at, words_at


@part
def _chain(i: int, j: int, k: int, mask: int) -> int:
    return (i * 73856093 ^ j * 19349663 ^ k * 83492791) & mask


@part
def _cell(x: float, edge: float) -> int:
    return int(np.floor(x / edge))


@part
def _kept(points: int, number: int, edge: float, heads: int, mask: int, links: int) -> None:
    p, head, link = floats_at(points + 24 * number), words_at(heads), words_at(links)
    chain = _chain(_cell(p[0], edge), _cell(p[1], edge), _cell(p[2], edge), mask)
    link[number] = head[chain]
    head[chain] = number


@part
def _is_free(point: int, points: int, edge: float, heads: int, mask: int, links: int, reach: float) -> bool:
    p, c, head, link = floats_at(point), floats_at(points), words_at(heads), words_at(links)
    if not (abs(p[0]) < 1e300 and abs(p[1]) < 1e300 and abs(p[2]) < 1e300):
        return False
    a, b, d = _cell(p[0], edge), _cell(p[1], edge), _cell(p[2], edge)
    for i in range(a - 1, a + 2):
        for j in range(b - 1, b + 2):
            for k in range(d - 1, d + 2):
                at = head[_chain(i, j, k, mask)]
                while at >= 0:
                    x, y, z = c[3 * at] - p[0], c[3 * at + 1] - p[1], c[3 * at + 2] - p[2]
                    if x * x + y * y + z * z < reach * reach:
                        return False
                    at = link[at]
    return True


@loop
def keep(points: int, first: int, last: int, edge: float, heads: int, mask: int, links: int) -> None:
    """Keep points ``first`` to ``last``."""
    for number in range(first, last):
        _kept(points, number, edge, heads, mask, links)


@loop
def free(
    asked: int, count: int, points: int, edge: float, heads: int, mask: int, links: int, reach: float, out: int
) -> None:
    """Write 1 for every finite point asked for that has none of those kept within ``reach`` (length¹)."""
    found = codes_at(out)
    for k in range(count):
        found[k] = 1 if _is_free(asked + 24 * k, points, edge, heads, mask, links, reach) else 0


@loop
def thin(points: int, count: int, edge: float, heads: int, mask: int, links: int, reach: float, out: int) -> None:
    """Keep every point that has none of those kept before it within ``reach`` (length¹), and write 1 for it."""
    found = codes_at(out)
    for k in range(count):
        fits = _is_free(points + 24 * k, points, edge, heads, mask, links, reach)
        found[k] = 1 if fits else 0
        if fits:
            _kept(points, k, edge, heads, mask, links)


@loop
def lay(
    points: int,
    arc: int,
    count: int,
    edge: float,
    heads: int,
    mask: int,
    links: int,
    reach: float,
    lag: float,
    out: int,
) -> None:
    """Write 1 for every point of a line that has none of those for which it is written within ``reach`` (length¹).

    ``arc`` is the arc length; only what lies ``lag`` (length¹) behind is looked at.
    """
    s, found, behind = floats_at(arc), codes_at(out), 0
    for k in range(count):
        while behind < k and s[behind] < s[k] - lag:
            if found[behind] == 1:
                _kept(points, behind, edge, heads, mask, links)
            behind += 1
        found[k] = 1 if _is_free(points + 24 * k, points, edge, heads, mask, links, reach) else 0
