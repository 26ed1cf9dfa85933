"""Who may speak to the studio's server, and what its pages may do."""

import hmac
import ipaddress
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs, urlsplit

from starlette.responses import JSONResponse, PlainTextResponse, Response

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

LARGEST_BODY = 24 * 2**20
"""Bytes of the largest request: a model file of 16 MB, written as JSON text."""

_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)

_HEADERS = (
    (b"content-security-policy", _POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"cache-control", b"no-store"),
)


class Guard:
    """Lets a request through only when it names this server, comes from its own page and carries the token.

    The token comes once in the address that ``quintrig view`` opens, and is then kept in a cookie that no script reads.
    """

    def __init__(self, app: App, token: str, host: str, port: int) -> None:
        """Guard ``app``, bound to ``host`` and ``port``."""
        self._app = app
        self._token = token
        self._host = host
        self._port = port
        self._cookie = f"quintrig_{port}"

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or refuse it with the reason."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        if scope["type"] != "http":
            return
        headers: dict[bytes, bytes] = dict(scope["headers"])
        brought = self._brings_token(scope)
        answer = self._refusal(scope, headers, brought)
        with_headers = _adding_headers(send, self._keeping() if brought else None)
        if answer is not None:
            await answer(scope, receive, with_headers)
            return
        await self._app(scope, _bounded(receive), with_headers)

    def _refusal(self, scope: Scope, headers: dict[bytes, bytes], brought: bool) -> Response | None:
        """Return why a request is not let through; None when it is."""
        if not self._known_host(headers.get(b"host", b"").decode("latin-1")):
            return PlainTextResponse(
                "This address is not the studio's; use the one that was printed when it began.", 421
            )
        if not _from_own_page(scope, headers):
            return JSONResponse({"error": "requests from other pages are refused"}, 403)
        length = headers.get(b"content-length", b"0")
        if not length.isdigit() or len(length) > 12 or int(length) > LARGEST_BODY:
            return JSONResponse({"error": f"expected at most {LARGEST_BODY >> 20} MB"}, 413)
        if not brought and not self._is_token(self._kept(headers.get(b"cookie", b"").decode("latin-1"))):
            return PlainTextResponse(
                "Open the studio by the address that was printed when it began: it has a token.", 403
            )
        return None

    def _brings_token(self, scope: Scope) -> bool:
        given = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])[0]
        return scope["path"] == "/" and scope["method"] == "GET" and self._is_token(given)

    def _keeping(self) -> bytes:
        """Return the header that keeps the token in a cookie of this server's pages."""
        return f"{self._cookie}={self._token}; HttpOnly; SameSite=Strict; Path=/".encode()

    def _known_host(self, value: str) -> bool:
        try:
            parts = urlsplit(f"//{value}")
            name, port = parts.hostname or "", parts.port
        except ValueError:
            return False
        if (port or 80) != self._port:
            return False
        if name in ("localhost", "127.0.0.1", "::1", self._host):
            return True
        # Bound to every address of the machine: a page elsewhere can make a name point here, but not a number.
        return self._host in ("0.0.0.0", "::") and _is_address(name)

    def _is_token(self, value: str) -> bool:
        return hmac.compare_digest(value.encode(), self._token.encode())

    def _kept(self, cookies: str) -> str:
        try:
            jar = SimpleCookie(cookies)
        except CookieError:
            return ""
        return jar[self._cookie].value if self._cookie in jar else ""


def _from_own_page(scope: Scope, headers: dict[bytes, bytes]) -> bool:
    origin, own = headers.get(b"origin"), b"http://" + headers[b"host"]
    reading = scope["method"] in ("GET", "HEAD")
    if origin != own and not (reading and origin is None):
        return False
    # A link from elsewhere may open the page, which asks for the token, but nothing else.
    return scope["path"] == "/" or headers.get(b"sec-fetch-site", b"none") in (b"none", b"same-origin")


class TooLarge(Exception):
    """A body longer than allowed, whatever its headers said."""


def _bounded(receive: Receive) -> Receive:
    total = 0

    async def bounded() -> Message:
        nonlocal total
        message = await receive()
        total += len(message.get("body", b""))
        if total > LARGEST_BODY:
            raise TooLarge
        return message

    return bounded


def _adding_headers(send: Send, cookie: bytes | None) -> Send:
    more = _HEADERS if cookie is None else (*_HEADERS, (b"set-cookie", cookie))

    async def adding(message: Message) -> None:
        if message["type"] == "http.response.start":
            message = {**message, "headers": [*message.get("headers", []), *more]}
        await send(message)

    return adding


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
