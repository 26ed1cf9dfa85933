"""How long work tells how far it is: to whom asks for it, and in a notebook by itself."""

import sys
from collections.abc import Callable
from functools import wraps
from html import escape
from inspect import signature
from time import monotonic
from typing import Any, ParamSpec, TypeVar, cast

Progress = Callable[[str, int, int], None]
"""Called with what is being done, steps done and steps in all."""

Counted = Callable[[int, int], None]
"""Called with how much is done and how much there is in all: rows of a grid, or designs of a sweep."""

_QUIET = 1.0  # seconds in which a bar is not worth a look
_OFTEN = 0.2  # seconds between two changes of a bar

P = ParamSpec("P")
R = TypeVar("R")


class Bar:
    """A bar below the cell of a notebook that runs: from its second on, and gone when the work is done."""

    watched = False
    """Whether one is shown: work within other work shows none."""

    def __init__(self) -> None:
        """Begin to count the time."""
        self._since = self._last = monotonic()
        self._handle: Any = None

    def __call__(self, *told: Any) -> None:
        """Take what a ``Progress`` or a ``Counted`` is told."""
        what, done, total = told if len(told) == 3 else ("", *told)
        now = monotonic()
        if now - self._since < _QUIET or now - self._last < _OFTEN:
            return
        self._last = now
        words = f"{done:,} of {total:,}, {now - self._since:.0f} s{what and '; '}{what}"
        bar = f'<progress value="{done}" max="{max(total, 1)}" style="width: 16em"></progress> {escape(words)}'
        self._show({"text/html": bar, "text/plain": words})

    def close(self) -> None:
        """Take the bar away."""
        if self._handle is not None:
            self._show({"text/html": "", "text/plain": ""})

    def _show(self, data: dict[str, str]) -> None:
        if self._handle is not None:
            self._handle.update(data, raw=True)
            return
        from IPython import display

        self._handle = cast(Any, display).display(data, raw=True, display_id=True)


def watched(work: Callable[P, R]) -> Callable[P, R]:
    """Return work with an argument ``progress`` that shows a bar where a notebook runs it and gives none itself."""
    form = signature(work)

    @wraps(work)
    def run(*arguments: P.args, **words: P.kwargs) -> R:
        if Bar.watched or not _in_notebook():
            return work(*arguments, **words)
        bound = form.bind(*arguments, **words)
        if bound.arguments.get("progress") is not None:
            return work(*arguments, **words)
        bar = bound.arguments["progress"] = Bar()
        Bar.watched = True
        try:
            return work(*bound.args, **bound.kwargs)
        finally:
            Bar.watched = False
            bar.close()

    return run


def _in_notebook() -> bool:
    """Return whether a kernel of Jupyter runs this, which shows HTML."""
    shell: Any = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return getattr(shell, "kernel", None) is not None


def patient(progress: Progress, seconds: float = 2.0) -> Progress:
    """Return what tells ``progress`` nothing in the first seconds: short work needs no word."""
    since = monotonic()

    def tell(what: str, done: int, total: int) -> None:
        if monotonic() - since > seconds:
            progress(what, done, total)

    return tell
