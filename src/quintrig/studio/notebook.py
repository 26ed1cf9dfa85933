"""What a notebook shows of a surface or a model by itself."""

from typing import Any

from quintrig.model.recognise import Subject
from quintrig.support.errors import QuintrigError


def bundle(subject: Subject) -> Any:
    """Return the MIME bundle of an interactive view; text where there is no anywidget, or nothing to show."""
    try:
        from quintrig.studio.jupyter import show

        return show(subject)._repr_mimebundle_()  # pyright: ignore[reportPrivateUsage, reportUnknownMemberType, reportUnknownVariableType]
    except (QuintrigError, ValueError):
        return {"text/plain": repr(subject)}
