"""What mkdocs does beside its own: formulas as MathML, a gallery drawn anew, and pages of the repository's root."""

import ast
import io
import os
import re
import runpy
from contextlib import chdir
from pathlib import Path

import typer
from latex2mathml.converter import convert
from matplotlib.figure import Figure
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from typer.cli import get_docs_for_click

from quintrig.cli.app import build

DOCS = Path(__file__).parent
ROOT = DOCS.parent
TAKEN_IN = {"changelog.md": "CHANGELOG.md", "contributing.md": "CONTRIBUTING.md"}
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", re.DOTALL)
ASKING = re.compile(
    r"<script\b[^>]*>(?:(?!</script>).)*https://(?:unpkg|cdnjs)\.(?:(?!</script>).)*</script>", re.DOTALL
)
LISTED = re.compile(r"^\* `(\w+)`: .*$", re.MULTILINE)
EXAMPLES = re.compile(r"^(Examples|First steps)\n((?:  .*\n)+)", re.MULTILINE)
DISPLAY = re.compile(r"\$\$(.+?)\$\$", re.DOTALL)
INLINE = re.compile(r"(?<![\\$\w])\$([^\s$](?:[^$\n]*[^\s$])?)\$(?!\w)")


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Take in the pages of the repository's root, and the gallery with its pictures."""
    for page, source in TAKEN_IN.items():
        text = (ROOT / source).read_text(encoding="utf-8").replace("](docs/", "](")
        files.append(File.generated(config, page, content=text))
    files.append(File.generated(config, "commands.md", content=_commands()))
    pieces = ["# Gallery\n\nEvery picture was made by the code beneath it when this site was built.\n"]
    for script in sorted((DOCS / "gallery").glob("*.py")):
        title, code = _parts(script)
        name = f"gallery/{script.stem}.png"
        files.append(File.generated(config, name, content=_drawn(script)))
        pieces.append(f"## {title[0]}\n\n{title[1]}\n\n![{title[0]}]({name})\n\n```python\n{code}```\n")
    files.append(File.generated(config, "gallery.md", content="\n".join(pieces)))
    return files


def _commands() -> str:
    """Return the reference of the command line, from the commands themselves."""
    command = typer.main.get_command(build())
    text = get_docs_for_click(obj=command, ctx=typer.Context(command), name="quintrig", title="Commands")
    text = re.sub(r"\[/?(bold|cyan|dim)\]", "", text)  # marks of the terminal
    text = re.sub(r"\{([A-Z]+)[.]*\}", r"\1", text)
    sentences = {name: one.get_short_help_str(limit=1000) for name, one in command.commands.items()}
    text = LISTED.sub(lambda found: f"* [`{found[1]}`](#quintrig-{found[1]}): {sentences[found[1]]}", text)
    return EXAMPLES.sub(_examples, text)


def _examples(found: re.Match[str]) -> str:
    """Return commands and what they do, indented below a heading in the terminal, as a list."""
    items: list[str] = []
    for line in map(str.strip, found[2].splitlines()):
        if line.startswith("quintrig"):
            items.append(f"* `{line}`")
        else:
            items[-1] += f": {line}" if items[-1].endswith("`") else f" {line}"
    return f"**{found[1]}**:\n\n" + "\n".join(items) + "\n"


def _parts(script: Path) -> tuple[tuple[str, str], str]:
    """Return the first line and the rest of a script's docstring, and its code."""
    text = script.read_text(encoding="utf-8")
    title, _, words = (ast.get_docstring(ast.parse(text)) or "").partition("\n\n")
    return (title.rstrip("."), words), text.split('"""', 2)[2].lstrip()


def _drawn(script: Path) -> bytes:
    """Run a script at the repository's root and return the figure that it leaves as ``picture``, as PNG."""
    os.environ["MPLBACKEND"] = "agg"
    with chdir(ROOT):
        picture = runpy.run_path(str(script))["picture"]
    if not isinstance(picture, Figure):
        raise TypeError(f"{script}: expected a figure of matplotlib called picture, found {type(picture).__name__}")
    stream = io.BytesIO()
    picture.savefig(stream, format="png", dpi=120, bbox_inches="tight")
    return stream.getvalue()


def on_page_markdown(markdown: str, **_: object) -> str:
    """Turn LaTeX between dollars into MathML, which browsers draw without a script; code stays as it is."""
    parts = CODE.split(markdown)
    return "".join(part if index % 2 else _formulas(part) for index, part in enumerate(parts))


def on_page_content(html: str, **_: object) -> str:
    """Leave out of notebooks the scripts by which they would ask another server: for widgets, which have no kernel."""
    return ASKING.sub("", html)


def _formulas(text: str) -> str:
    text = DISPLAY.sub(lambda found: f"\n\n{convert(found[1].strip(), display='block')}\n\n", text)
    return INLINE.sub(lambda found: convert(found[1]), text)
