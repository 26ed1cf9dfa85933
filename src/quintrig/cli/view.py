"""``quintrig view``: the live studio in the browser."""

from collections.abc import Generator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import missing

_EPILOG = session.examples(
    ("quintrig view lid.toml", "opens the model in the browser, to look at and to shape"),
    ("quintrig view", "starts on a preset, with the models of this folder at hand"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, view, _EPILOG)


def view(
    model: Annotated[
        Path | None, typer.Argument(metavar="MODEL", help="Model file, .toml or .json.", show_default=False)
    ] = None,
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="Port; 0 chooses one that stays the same for the model.")
    ] = 0,
    host: Annotated[str, typer.Option(help="Address to listen on; others than this machine's own are not safe.")] = (
        "127.0.0.1"
    ),
    browser: Annotated[bool, typer.Option(help="Open the browser.")] = True,
) -> None:
    """See and shape a surface in the browser, live.

    The studio reads and saves models in the model's folder only, and speaks to this machine only, with a random token
    in the address. Stop it with Ctrl-C; unsaved work is kept in the browser and offered again.
    """
    if model is not None:
        if model.suffix.lower() not in (".toml", ".json") and model.exists():
            raise QuintrigError(
                f"{model}: the studio opens models, .toml or .json; "
                f"make one of a CAD file first: quintrig import {model.name} -o {model.stem}.toml"
            )
        session.load_any(model)  # a bad model is told here, before anything is opened
    try:
        from quintrig.studio import server
    except ModuleNotFoundError as error:
        raise missing("the studio", str(error.name), "studio") from None
    where = server.site(model, host, port)
    session.emit(f"Studio: {where.address}")
    session.emit("Stop it with Ctrl-C.")
    if host not in ("127.0.0.1", "localhost", "::1"):
        session.emit("Anyone who can reach this address and knows the token can read and write models in the folder.")
    try:
        with _opened_by(where.address) if browser else nullcontext():
            server.serving(where).run()
    except KeyboardInterrupt:
        session.emit("Stopped.")


@contextmanager
def _opened_by(address: str) -> Generator[None]:
    """Open the browser on a file that only this user may read: all may see what a browser is started with."""
    import tempfile
    import threading
    import webbrowser

    from quintrig.studio.page import redirect

    with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:  # of mode 700
        door = Path(folder) / "open.html"
        door.touch(0o600)
        door.write_text(redirect(address), encoding="utf-8")
        opening = threading.Timer(0.6, webbrowser.open, [door.as_uri()])
        opening.daemon = True
        opening.start()
        try:
            yield
        finally:
            opening.cancel()
