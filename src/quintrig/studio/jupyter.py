"""The studio in a notebook: what is changed in the page is changed in the kernel, and the other way round."""

from typing import Any, cast

from quintrig.errors import QuintrigError
from quintrig.model import Model
from quintrig.quantity import quantity
from quintrig.studio import page
from quintrig.studio.describe import Subject, as_model
from quintrig.surface import Surface

try:
    import anywidget
    import traitlets
except ModuleNotFoundError as error:
    raise QuintrigError(f"showing surfaces in Jupyter needs {error.name}: pip install 'quintrig[jupyter]'") from None


class View(anywidget.AnyWidget):
    """An interactive view. ``view.model`` follows every change in the page; assign to it to change the page."""

    _esm = page.BUNDLE
    model = cast(Any, traitlets.Dict().tag(sync=True))
    quantity = cast(Any, traitlets.Unicode("gaussian").tag(sync=True))
    height = cast(Any, traitlets.Int(560, min=240, max=4000).tag(sync=True))

    @property
    def current(self) -> Model:
        """The model as it is in the page now."""
        return Model.from_dict(self.model)

    @property
    def surface(self) -> Surface:
        """The surface of the only patch as it is in the page now."""
        return self.current.surface


def show(subject: Subject, key: str = "gaussian", height: int = 560) -> View:
    """Return a view of a model, patch or surface, coloured by a quantity; ValueError for what cannot be shown."""
    model = as_model(subject)
    return View(model=model.to_dict(), quantity=quantity(key).key, height=height)
