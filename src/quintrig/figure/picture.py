"""A figure that a notebook shows by itself."""

import io
from typing import Any

from matplotlib.figure import Figure


class Picture(Figure):
    """A figure of matplotlib that is shown as the value of a notebook's cell, without pyplot too."""

    def _repr_png_(self) -> bytes:
        """Return PNG at 100 dots an inch, cut to what is drawn."""
        stream = io.BytesIO()
        figure: Any = self  # matplotlib leaves the types of keyword arguments open
        figure.savefig(stream, format="png", dpi=100, bbox_inches="tight")
        return stream.getvalue()
