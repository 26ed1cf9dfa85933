"""The tables of a run as data, for the file that is kept of each release."""

import contextlib
import io
import sys
from collections.abc import Iterator


class Both(io.StringIO):
    """Text that is kept and shown."""

    def write(self, text: str) -> int:
        sys.__stdout__.write(text)
        sys.__stdout__.flush()
        return super().write(text)


@contextlib.contextmanager
def told() -> Iterator[io.StringIO]:
    """Keep what is printed, and print it."""
    with contextlib.redirect_stdout(Both()) as text:
        yield text


def tables(text: str) -> list[dict[str, object]]:
    """Return the Markdown tables of a text, each with the paragraph before it: title, head, rows."""
    found: list[dict[str, object]] = []
    title = ""
    for paragraph in text.split("\n\n"):
        lines = [line for line in paragraph.splitlines() if line.startswith("|")]
        if lines:
            head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
            found.append({"title": title, "head": head, "rows": rows})
        else:
            title = " ".join(paragraph.split())
    return found
