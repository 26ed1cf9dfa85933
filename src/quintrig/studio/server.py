"""The live studio's server: one page, one script and a small interface over one folder. It keeps no state."""

import base64
import hashlib
import os
import secrets
import socket
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import anyio.to_thread
import uvicorn
from starlette.applications import Starlette
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from quintrig.studio import aims, built, exports, folder, page, proofs
from quintrig.studio.guard import LARGEST_BODY, App, Guard, TooLarge
from quintrig.studio.patient import Patient
from quintrig.support.errors import ModelError, QuintrigError
from quintrig.support.files import require_utf8
from quintrig.support.parsing import parse

LOOPBACK = "127.0.0.1"
_FIRST_PORT, _PORTS = 8700, 250

Answer = Callable[[Request], Awaitable[Response]]


@dataclass(frozen=True)
class Site:
    """What a server serves: a folder, the name of the model in it to open first (empty: a preset), and its address."""

    folder: Path
    name: str
    host: str
    port: int
    token: str

    @property
    def address(self) -> str:
        """The address to open, with the token."""
        shown = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host
        return f"http://{f'[{shown}]' if ':' in shown else shown}:{self.port}/?token={self.token}"


def site(model: Path | None, host: str = LOOPBACK, port: int = 0) -> Site:
    """Return a site for a model file, or for the current folder.

    Without a ``port`` it is chosen from the model's path, so that a browser finds its unsaved work again after a
    restart, or is the next free one. Raises QuintrigError where the address cannot be used.
    """
    place = model.resolve() if model else Path.cwd()
    require_utf8(Path(place.name), "a model")
    base = place.parent if model else place
    if port:
        candidates = [port]
    else:
        start = int(hashlib.sha256(os.fsencode(place)).hexdigest(), 16) % _PORTS
        candidates = [_FIRST_PORT + (start + step) % _PORTS for step in range(20)]
    for candidate in candidates:
        if _free(host, candidate):
            return Site(base, place.name if model else "", host, candidate, secrets.token_urlsafe(24))
    raise QuintrigError(
        f"{host}: port {candidates[0]} cannot be used (taken by another program, or not an address of this machine)",
        remedy="choose another port or host",
        key="address",
    )


def application(where: Site) -> App:
    """Return the guarded ASGI application of a site."""

    async def index(_: Request) -> Response:
        key = hashlib.sha256(os.fsencode(where.folder / where.name)).hexdigest()[:16]
        return Response(page.shell(f"{where.name}:{key}"), media_type="text/html")

    async def model(_: Request) -> Response:
        if not where.name:
            return JSONResponse({"error": "no model was given"}, 404)
        return await _opened(where.folder, where.name)

    async def files(_: Request) -> Response:
        return JSONResponse({"files": await anyio.to_thread.run_sync(folder.names, where.folder)})

    async def load(request: Request) -> Response:
        return await _opened(where.folder, _name(request))

    async def save(request: Request) -> Response:
        body, name = await _body(request, "text", "tag"), _name(request)
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        tag = await anyio.to_thread.run_sync(folder.save, where.folder, name, drawn, body["tag"])
        return JSONResponse({"name": name, "tag": tag})

    async def check(request: Request) -> Response:
        body = await _body(request, "name", "text")
        read = await anyio.to_thread.run_sync(folder.checked, body["name"], body["text"])
        return JSONResponse({"model": built.for_page(read)})

    async def build(request: Request) -> Response:
        patches = parse((await _body(request, "patches"))["patches"], ".json", LARGEST_BODY)
        if not (isinstance(patches, list) and all(isinstance(keys, dict) for keys in cast(list[Any], patches))):
            raise ValueError("patches: expected a list of tables of keys")
        made = await anyio.to_thread.run_sync(built.rebuilt, cast(list[dict[str, Any]], patches))
        return JSONResponse({"built": made})

    async def formats(request: Request) -> Response:
        if request.method == "POST":
            body = await _body(request, "text", "patch")
            drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
            reasons = await anyio.to_thread.run_sync(exports.refusals, drawn, body["patch"] or None)
        else:
            reasons = exports.refusals()
        return JSONResponse({"formats": exports.rows(reasons)})

    async def export(request: Request) -> Response:
        body = await _body(request, "text", "suffix", "patch", "colour")
        order = exports.Order(
            body["suffix"], body["patch"] or None, body["colour"] or None, _ends(body), _number(body, "tolerance")
        )
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        made = await anyio.to_thread.run_sync(exports.export, drawn, order)
        content = base64.b64encode(made.content).decode()
        return JSONResponse({"name": made.name, "notes": made.notes, "content": content})

    async def targets(_: Request) -> Response:
        return JSONResponse({"targets": await anyio.to_thread.run_sync(aims.names, where.folder)})

    async def measure(request: Request) -> Response:
        body = await _body(request, "text", "target", "align")
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        most, tolerance = _number(body, "most"), _number(body, "tolerance")
        found = await anyio.to_thread.run_sync(
            aims.beside, where.folder, drawn, body["target"], int(most or 3000), tolerance, bool(body["align"])
        )
        return JSONResponse(found)

    async def demands(request: Request) -> Response:
        body = await _body(request, "text", "patch", "demands", "target")
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        found = await anyio.to_thread.run_sync(
            aims.lights, where.folder, drawn, body["patch"], body["demands"], body["target"]
        )
        return JSONResponse({"lights": found})

    async def fairer(request: Request) -> Response:
        body = await _body(request, "text", "patch", "only")
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        found = await anyio.to_thread.run_sync(aims.fairer, drawn, body["patch"], body["only"])
        energies = {"before": found.before["thin_plate"], "after": found.after["thin_plate"]}
        return JSONResponse({"model": built.for_page(found.model), "notes": found.notes, **energies})

    async def prove(request: Request) -> Response:
        body = await _body(request, "text", "claim")
        drawn = await anyio.to_thread.run_sync(folder.checked, "model.toml", body["text"])
        return JSONResponse(await anyio.to_thread.run_sync(proofs.proved, drawn, body["claim"]))

    def told(status: int) -> Callable[[Request, Exception], Response]:
        def answer(_: Request, error: Exception) -> Response:
            # The page knows files by their names; where the folder lies is not its business.
            text = str(error).replace(f"{where.folder}{os.sep}", "")
            return JSONResponse({"error": text or "the request is too large"}, status)

        return answer

    routes = [
        Route("/", index),
        Route("/studio.js", _static(page.script(), "text/javascript")),
        Route("/page.css", _static(page.PAGE_STYLE, "text/css")),
        Route("/icon.svg", _static(page.ICON, "image/svg+xml")),
        Route("/api/model", model),
        Route("/api/files", files),
        Route("/api/files/{name:path}", load, methods=["GET"]),
        Route("/api/files/{name:path}", save, methods=["PUT"]),
        Route("/api/check", check, methods=["POST"]),
        Route("/api/build", build, methods=["POST"]),
        Route("/api/formats", formats, methods=["GET", "POST"]),
        Route("/api/export", export, methods=["POST"]),
        Route("/api/targets", targets),
        Route("/api/deviation", measure, methods=["POST"]),
        Route("/api/demands", demands, methods=["POST"]),
        Route("/api/fair", fairer, methods=["POST"]),
        Route("/api/prove", prove, methods=["POST"]),
    ]
    inner = Starlette(
        routes=routes,
        exception_handlers={
            ModelError: told(422),
            ValueError: told(422),
            QuintrigError: told(422),
            OSError: told(422),
            folder.Changed: told(409),
            TooLarge: told(413),
            ClientDisconnect: told(400),  # to nobody
        },
    )
    return Guard(cast(App, inner), where.token, where.host, where.port)


def serving(where: Site) -> uvicorn.Server:
    """Return what serves a site, once it is run."""
    config = uvicorn.Config(
        cast(Any, application(where)),
        host=where.host,
        port=where.port,
        http=Patient,
        log_level="warning",
        access_log=False,
        server_header=False,
        date_header=False,
        lifespan="off",
        timeout_graceful_shutdown=1,
    )
    return uvicorn.Server(config)


async def _opened(where: Path, name: str) -> Response:
    model, tag = await anyio.to_thread.run_sync(folder.read, where, name)
    return JSONResponse({"model": built.for_page(model), "name": name, "tag": tag})


def _static(content: str, kind: str) -> Answer:
    async def answer(_: Request) -> Response:
        return Response(content, media_type=kind)

    return answer


def _name(request: Request) -> str:
    return str(request.path_params["name"])  # decoded by the server already


async def _body(request: Request, *keys: str) -> dict[str, Any]:
    """Return the texts of a JSON body; ValueError where one is missing."""
    try:
        body: Any = parse((await request.body()).decode(), ".json", LARGEST_BODY)
    except ValueError:
        raise ValueError("expected a JSON object") from None
    for key in keys:
        value = body.get(key) if isinstance(body, dict) else None  # pyright: ignore
        if not (isinstance(value, str) or (key == "tag" and value is None)):
            raise ValueError(f"{key}: expected a text")
        if isinstance(value, str) and any("\ud800" <= letter <= "\udfff" for letter in value):
            raise ValueError(f"{key}: expected a text, found half a letter in it (a lone surrogate)")
    return cast(dict[str, Any], body)


def _number(body: dict[str, Any], key: str) -> float | None:
    """Return a number of a JSON body, or None where it is left out."""
    value = body.get(key)
    if value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
        raise ValueError(f"{key}: expected a number")
    try:
        return None if value is None else float(value)
    except OverflowError:
        raise ValueError(f"{key}: expected a number, found one with hundreds of digits") from None


def _ends(body: dict[str, Any]) -> tuple[float, float] | None:
    low, high = _number(body, "low"), _number(body, "high")
    return None if low is None or high is None else (low, high)


def _free(host: str, port: int) -> bool:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except OSError:
            return False
        return True
