"""What a notebook shows by itself: of surfaces and models the interactive view, of all else a picture."""

from base64 import b64encode
from contextlib import suppress
from typing import Any

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.errors import QuintrigError


def bundle(subject: Any) -> Any:
    """Return the MIME bundle of an interactive view, or a picture without anywidget; text where there is nothing."""
    for way in (_view, _picture) if isinstance(subject, Surface | Patch | Model) else (_picture,):
        with suppress(QuintrigError, ValueError):
            return way(subject)
    return {"text/plain": repr(subject)}


def _view(subject: Any) -> Any:
    from quintrig.studio.jupyter import show

    return show(subject)._repr_mimebundle_()  # pyright: ignore[reportPrivateUsage, reportUnknownMemberType, reportUnknownVariableType]


def _picture(subject: Any) -> dict[str, str]:
    from quintrig.figure.plot import plot
    from quintrig.figure.save import to_png_bytes

    picture = to_png_bytes(plot(subject), 100)
    return {"image/png": b64encode(picture).decode("ascii"), "text/plain": repr(subject)}
