"""Functions that tell what came of their work, as functions that return the model alone."""

import inspect
from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, Protocol

from quintrig.model.model import Model

P = ParamSpec("P")


class Outcome(Protocol):
    """What came of it: the model, and more."""

    @property
    def model(self) -> Model: ...  # noqa: D102


def model_of(work: Callable[P, Outcome], name: str) -> Callable[P, Model]:
    """Return ``work`` under another name and without all that it tells beside the model."""

    @wraps(work)
    def alone(*args: P.args, **words: P.kwargs) -> Model:
        return work(*args, **words).model

    alone.__name__ = alone.__qualname__ = name
    alone.__annotations__ = {**work.__annotations__, "return": Model}
    alone.__signature__ = inspect.signature(work).replace(return_annotation=Model)  # pyright: ignore
    return alone
