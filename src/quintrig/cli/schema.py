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
    session.add(app, schema, _EPILOG)


def schema(
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Write to this file.")] = None,
) -> None:
    """Print the JSON Schema of model files."""
    import json

    from quintrig.model.schema import json_schema

    session.deliver(json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n", output)
