"""The studio in a notebook: what is changed in the page is changed in the kernel, and the other way round."""

import base64
from typing import Any, cast

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.recognise import Subject, as_model
from quintrig.quantities.table import quantity
from quintrig.studio import page, still
from quintrig.studio.built import for_page, rebuilt
from quintrig.studio.kinds import installed
from quintrig.support.extras import missing

try:
    import anywidget
    import traitlets
except ModuleNotFoundError as error:
    raise missing("showing surfaces in Jupyter", str(error.name), "jupyter") from None


NO_COLOUR = "none"
"""What ``quantity`` is where the surface is plain."""


class View(anywidget.AnyWidget):
    """An interactive view.

    ``view.model``, ``view.quantity`` and ``view.height`` follow every change in the page; assign to them to change the
    page. What they cannot be is a ``traitlets.TraitError`` or ValueError.
    """

    _esm = page.BUNDLE
    model = cast(Any, traitlets.Dict().tag(sync=True))
    quantity = cast(Any, traitlets.Unicode("gaussian").tag(sync=True))
    height = cast(Any, traitlets.Int(560, min=240, max=4000).tag(sync=True))
    brought = cast(Any, traitlets.Dict().tag(sync=True))
    """What the page cannot know of: kinds of installed packages, and the surfaces of those in the model."""

    def __init__(self, **keywords: Any) -> None:
        """Make the view, and build what its page asks for."""
        super().__init__(**keywords)
        cast(Any, self).on_msg(_answer)

    @traitlets.validate("quantity")
    def _known(self, proposal: Any) -> str:
        key = str(proposal["value"])
        if key != NO_COLOUR and quantity(key).kind == "vector":
            raise ValueError(f"{key} is a vector; choose a quantity with one value at a point, such as gaussian")
        return key

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        """Return the live view, and what stands in for it in an exported notebook: a picture and a line of text."""
        found = cast(Any, super()._repr_mimebundle_(**kwargs))  # pyright: ignore[reportUnknownMemberType]
        data, metadata = cast(tuple[dict[str, Any], dict[str, Any]], found if isinstance(found, tuple) else (found, {}))
        model, key = self.current, str(self.quantity)
        picture = base64.b64encode(still.png(model, key)).decode()
        return {**data, "image/png": picture, "text/plain": still.text(model, key)}, metadata

    @property
    def current(self) -> Model:
        """The model as it is in the page now."""
        return Model.from_dict(self.model)

    @property
    def surface(self) -> Surface:
        """The surface of the only patch as it is in the page now."""
        return self.current.surface


def show(subject: Subject, key: str = "gaussian", height: int = 560) -> View:
    """Return a view of a model, patch or surface, coloured by a quantity or by ``none``.

    ``height`` is in pixels. Raises ValueError for what cannot be shown.
    """
    model = as_model(subject)
    brought = installed()
    told = for_page(model)
    for part in ("built", "library"):
        if part in told:
            brought[part] = [*brought.get(part, ()), *told[part]]
    return View(model=model.to_dict(), quantity=key, height=height, brought=brought)


def _answer(view: View, content: Any, _: Any) -> None:
    """Send a page the surfaces of patches that it asks for."""
    if isinstance(content, dict) and isinstance(patches := cast(dict[str, Any], content).get("build"), list):
        cast(Any, view).send({"built": rebuilt(cast(list[dict[str, Any]], patches))})
