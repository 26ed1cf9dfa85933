"""The bundle as text: in a page of its own, inside a report, or for Jupyter."""

import base64
import hashlib
import html
import json
from pathlib import Path
from typing import Any

from quintrig.model.model import Model
from quintrig.quantities.table import quantity
from quintrig.studio.built import for_page
from quintrig.studio.kinds import installed
from quintrig.support.errors import QuintrigError

BUNDLE = Path(__file__).parent / "bundle" / "studio.js"
"""The one script that is the live studio, the viewer of a report page and the Jupyter view."""

_STYLE = "height: 100%; margin: 0; overflow: hidden"


def script() -> str:
    """Return the bundle; QuintrigError where the installation lacks it."""
    try:
        return BUNDLE.read_text(encoding="utf-8")
    except OSError as error:
        raise QuintrigError(f"{BUNDLE}: cannot be read ({error.strerror}); install quintrig again") from None


def as_json(value: Any) -> str:
    """Return JSON that may stand inside a script element: no ``<``, no line separators."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


def viewer(model: Model, key: str = "gaussian", identity: str = "quintrig-viewer") -> str:
    """Return the element and data of an interactive view of a model, to put where it is to stand in a page.

    ``key`` is the quantity it is coloured by at first, ``identity`` the element's id, unique in the page. Give the
    element a height by its class ``quintrig-viewer``. Once a page, at its end, follows ``code()``. Raises ValueError
    for an unknown quantity.
    """
    brought = installed({patch.kind for patch in model.patches})
    place = {"quantity": quantity(key).key, "place": f"report:{model.name}"}
    data = as_json({"model": for_page(model), **place, **({"installed": brought} if brought else {})})
    name = html.escape(identity, quote=True)
    return (
        f'<div class="quintrig-viewer" id="{name}" data-quintrig="embedded" data-model="{name}-data"></div>\n'
        f'<script type="application/json" id="{name}-data">{data}</script>'
    )


def code() -> str:
    """Return the script element that brings every viewer of a page to life; works from ``file://``."""
    return f'<script type="module">{_inline(script())}</script>'


def embed(model: Model, key: str = "gaussian") -> str:
    """Return a viewer and its code together, for a page with one viewer."""
    return f"{viewer(model, key)}\n{code()}"


def policy() -> str:
    """Return the Content-Security-Policy of a page that holds ``code()``: this script, and nothing from anywhere else.

    The page's own styles and pictures stay allowed inline; add hashes for its other scripts.
    """
    digest = base64.b64encode(hashlib.sha256(_inline(script()).encode()).digest()).decode()
    return (
        f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data: blob:; "
        "font-src data:; base-uri 'none'; form-action 'none'"
    )


def shell(place: str) -> str:
    """Return the page of the live studio; ``place`` is the key under which its unsaved work is kept.

    Kinds that installed packages bring are told to the page in an element of their own.
    """
    brought = as_json(installed())
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>quintrig</title>\n'
        '<link rel="icon" href="icon.svg" type="image/svg+xml">\n<link rel="stylesheet" href="page.css">\n'
        '<script type="module" src="studio.js"></script>\n</head>\n<body>\n'
        f'<div class="quintrig-page" data-quintrig="live" data-place="{html.escape(place, quote=True)}">'
        "<noscript>The studio needs JavaScript.</noscript></div>\n"
        f'<script type="application/json" id="quintrig-installed">{brought}</script>\n</body>\n</html>\n'
    )


def redirect(address: str) -> str:
    """Return a page that leads on to an address: a browser's command line, which all may read, then has no token."""
    whole = html.escape(address, quote=True)
    return (
        '<!doctype html>\n<meta charset="utf-8">\n<title>quintrig</title>\n'
        f'<meta http-equiv="refresh" content="0; url={whole}">\n<a href="{whole}">Open the studio</a>\n'
    )


PAGE_STYLE = f"html, body, .quintrig-page {{ {_STYLE}; }}\n"
"""Style sheet of the live page: the studio fills the window."""

ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><rect width="16" height="16" rx="3.5" fill="#0f6e84"/>'
    '<path d="M3 11c2.5-5.2 7.5-1 10-6M3 11c1.7 2.5 4.2 2.5 5.5 1.8M13 5c.2 2.6-1.2 6-4.5 7.8" '
    'fill="none" stroke="#fff" stroke-width="1.3" stroke-linecap="round"/></svg>'
)
"""The icon of the page."""


def _inline(text: str) -> str:
    """Return a script that may stand inside a script element."""
    return text.replace("</script", "<\\/script").replace("<!--", "<\\!--")
