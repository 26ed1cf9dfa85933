"""How numbers get from scratch to their place in memory: through the caches, or past them.

Through the caches the processor first reads every line that it is about to overwrite. Past them it does not, but only
whole lines may go that way: a line written partly past the caches and partly through them costs more than either.
"""

from quintrig.support.compiled import scalar
from quintrig.support.memory import floats_at, stream_line

LINE = 8
"""Numbers in a cache line."""

FIRST, LAST = 1, 2
"""Marks of the first and the last block of a piece of work."""


@scalar
def write(source: int, target: int, n: int) -> None:
    """Copy ``n`` numbers from one address to another."""
    s, out = floats_at(source), floats_at(target)
    for k in range(n):
        out[k] = s[k]


@scalar
def write_past_caches(source: int, target: int, n: int, end: int, line: int) -> None:
    """Copy ``n`` numbers in whole lines; what fills none is kept at ``line`` until the next block goes on from it.

    The blocks of a piece of work follow each other in memory; only the first and the last, by the marks in ``end``,
    write parts of lines, through the caches. Wherever a line was begun, it is finished, so ``target`` may be anywhere.
    """
    s, kept = floats_at(source), floats_at(line)
    before, done, pending = (target >> 3) & (LINE - 1), 0, 0
    if before:
        done = min(LINE - before, n)
        if end & FIRST:
            write(source, target, done)
        else:
            for k in range(done):
                kept[before + k] = s[k]
            if before + done == LINE:
                stream_line(target - 8 * before, line)
            else:
                pending = before + done
    for _ in range((n - done) // LINE):
        stream_line(target + 8 * done, source + 8 * done)
        done += LINE
    for k in range(n - done):
        kept[k] = s[done + k]
    if end & LAST:
        pending += n - done
        write(line, target + 8 * (n - pending), pending)
