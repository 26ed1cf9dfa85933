"""Run the command line in this process, as a user would, and catch what it says."""

import contextlib
import io
from dataclasses import dataclass

from quintrig.cli.app import build
from quintrig.cli.ending import run


@dataclass(frozen=True)
class Result:
    code: int
    out: str
    err: str


def quintrig(*arguments) -> Result:
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True) for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = run(build, [str(argument) for argument in arguments])
    return Result(code, *(stream.buffer.getvalue().decode() for stream in (out, err)))
