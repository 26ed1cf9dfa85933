"""The written documentation against the code."""

import ast
import importlib
import importlib.util
import re
import textwrap
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])


def _maker():
    spec = importlib.util.spec_from_file_location("make_reference", ROOT / "docs" / "make_reference.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("page", ["reference", "quantities"])
def test_pages_written_from_the_code_are_current(page):
    text = getattr(_maker(), page)()
    assert (ROOT / "docs" / f"{page}.md").read_text() == text, "run python docs/make_reference.py"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)#\s]+)", page.read_text()):
        if not target.startswith("http"):
            assert (page.parent / target).exists(), target


PUBLIC = ("quintrig", "quintrig.mesh", "quintrig.studio", "quintrig.studio.jupyter", "quintrig.sweep")
"""Where users' code imports from. All else may move; CONTRIBUTING alone names it."""


def _python(page):
    """Return the blocks of Python of a page: fenced, or indented and with an import."""
    text = page.read_text(encoding="utf-8")
    fenced = re.findall(r"```python\n(.*?)```", text, re.S)
    indented = [textwrap.dedent(block) for block in re.findall(r"(?:^ {4}.*\n|^\n)+", text, re.M)]
    return fenced + [block for block in indented if re.search(r"^(?:from|import) ", block, re.M)]


def _imported(tree):
    """Return the (module, name) that a program takes from quintrig; the name is empty for a whole module."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield from ((node.module, alias.name) for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from ((alias.name, "") for alias in node.names)


USED = [
    pytest.param(module, name, id=f"{page.stem}: {module} {name}")
    for page in PAGES
    if page.name not in ("reference.md", "CONTRIBUTING.md")
    for block in _python(page)
    for module, name in _imported(ast.parse(block))
    if module.partition(".")[0] == "quintrig"
]


def test_imports_in_the_documentation_are_seen():
    assert len(USED) >= 12


@pytest.mark.parametrize(("module", "name"), USED)
def test_the_documentation_imports_only_public_names(module, name):
    assert module in PUBLIC
    if name:
        assert hasattr(importlib.import_module(module), name)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_are_named_exist(page):
    text = page.read_text(encoding="utf-8")
    for path in re.findall(r"`((?:src|tests|docs|bench|studio|examples|\.ci)/[\w./-]*)`", text):
        assert (ROOT / path).exists(), path
    names = {
        file.name for folder in ("src", "tests", "docs", "bench", "examples") for file in (ROOT / folder).rglob("*.py")
    }
    for path in re.findall(r"`([\w/]+\.py)`", text):
        assert path in names or (ROOT / path).exists() or (ROOT / "src" / "quintrig" / path).exists(), path
