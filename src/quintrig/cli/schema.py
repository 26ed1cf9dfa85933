"""``quintrig schema``: the JSON Schema of model files."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session

_EPILOG = session.examples(
    ("quintrig schema -o quintrig.schema.json", "for an editor, which then completes and checks models"),
    ("quintrig schema | less", "to read it"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command(epilog=_EPILOG)(schema)


def schema(
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Write to this file.")] = None,
) -> None:
    """Print the JSON Schema of model files."""
    import json

    from quintrig.files import write_whole
    from quintrig.schema import json_schema

    text = json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"
    if output is None:
        session.emit(text)
    else:
        session.wrote(write_whole(output, text))
