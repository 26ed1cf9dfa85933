"""The standard streams of the process: one that is closed, or whose reader has left, drops what is written.

So ``| head`` and ``>&-`` change nothing of what a command does, nor its exit code.
"""

import io
import os
import sys
from pathlib import Path
from typing import Any, cast


def prepare() -> None:
    """Give the process all three streams, for as long as it runs."""
    for number in range(3):
        _open(number)
    sys.stdin = sys.stdin or Path(os.devnull).open(encoding="utf-8")  # noqa: SIM115
    sys.stdout, sys.stderr = (_lasting(stream, n) for n, stream in ((1, sys.stdout), (2, sys.stderr)))


class _Outlet(io.FileIO):
    """A stream that outlives its reader; after any other failure, told once, it is silent too."""

    def write(self, data: Any, /) -> int:
        """Write, or drop what nobody reads."""
        try:
            return super().write(data)
        except OSError as error:
            silence = os.open(os.devnull, os.O_WRONLY)
            os.dup2(silence, self.fileno())
            os.close(silence)
            if isinstance(error, BrokenPipeError) or self.fileno() == 2:
                return len(data)
            raise


def _open(number: int) -> None:
    """Open the null device where a stream is closed, lest the next file that is opened be taken for it."""
    try:
        os.fstat(number)
    except OSError:
        opened = os.open(os.devnull, os.O_RDWR)
        if opened != number:
            os.dup2(opened, number)
            os.close(opened)
        os.set_inheritable(number, True)


def _lasting(stream: Any, number: int) -> Any:
    """Return a stream that outlives its reader; one of a terminal or of another program's own is left as it is."""
    if stream is None:
        return Path(os.devnull).open("w", encoding="utf-8")
    own = isinstance(stream, io.TextIOWrapper) and not stream.isatty() and stream.fileno() == number
    if not own:
        return cast(Any, stream)
    stream.flush()
    outlet = _Outlet(number, "w", closefd=False)
    buffer: Any = outlet if stream.write_through else io.BufferedWriter(outlet)  # as python -u wants it
    return io.TextIOWrapper(
        buffer, stream.encoding, stream.errors, line_buffering=stream.line_buffering, write_through=stream.write_through
    )
