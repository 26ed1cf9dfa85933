"""The normal equations of a fit, compiled: sums over the points of products of two basis functions each.

A matrix library would start threads for matrices of this size, which costs more than the sums on a busy machine.
"""

from quintrig.support.array_loops import array_loop
from quintrig.support.arrays import FloatArray


@array_loop
def gram(
    one: FloatArray,
    other: FloatArray,
    weight: FloatArray,
    pulled: FloatArray,
    turned: FloatArray,
    row: FloatArray,
    sums: FloatArray,
    to_net: FloatArray,
    mixed: FloatArray,
) -> None:
    """Add Σ f fᵀ W to ``sums`` (6, s, s), Σ f (W a) to ``to_net`` (s, 3), Σ f (W d_k) to ``mixed`` (s, 3, k).

    f = ``one`` (n, a) times ``other`` (n, b), s = a b; ``weight`` (n, 3, 3), of which xx, xy, xz, yy, yz, zz are kept,
    ``pulled`` (n, 3), ``turned`` (k, n, 3). Only the upper triangle of the sums is filled; ``row`` (s,) is room.
    """
    n, a = one.shape
    b = other.shape[1]
    size = a * b
    for p in range(n):
        for i in range(a):
            for j in range(b):
                row[i * b + j] = one[p, i] * other[p, j]
        c = 0
        for x in range(3):
            for y in range(x, 3):
                w = weight[p, x, y]
                for r in range(size):
                    t = w * row[r]
                    for q in range(r, size):
                        sums[c, r, q] += t * row[q]
                c += 1
            for r in range(size):
                to_net[r, x] += row[r] * pulled[p, x]
            for k in range(turned.shape[0]):
                for r in range(size):
                    mixed[r, x, k] += row[r] * turned[k, p, x]
