"""The documentation site builds strictly: every link leads somewhere, every notebook and gallery script runs."""

import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import typer

from cli_runner import quintrig
from quintrig.cli.app import build as build_commands

ROOT = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    if importlib.util.find_spec("mkdocs_jupyter") is None:
        assert not os.environ.get("CI"), "mkdocs is missing in CI"
        pytest.skip("needs mkdocs: pip install 'quintrig[docs]'")
    out = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(out)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-4000:]
    return out


def test_every_page_of_the_guide_is_in_the_navigation(site):
    index = (site / "index.html").read_text(encoding="utf-8")
    for page in sorted((ROOT / "docs" / "guide").glob("*.md")):
        assert f'href="guide/{page.stem}.html"' in index, page.name
    for notebook in sorted((ROOT / "docs" / "notebooks").glob("*.ipynb")):
        assert f'href="notebooks/{notebook.stem}.html"' in index, notebook.name


def test_pictures_of_the_gallery_and_the_notebooks_are_there(site):
    assert len(list((site / "gallery").glob("*.png"))) == len(list((ROOT / "docs" / "gallery").glob("*.py"))) >= 6
    for name in ("curves", "paper", "body", "scan"):
        assert "data:image/png;base64" in (site / "notebooks" / f"{name}.html").read_text(encoding="utf-8"), name


def test_formulas_are_mathml_and_none_is_left_over(site):
    page = (site / "mathematics.html").read_text(encoding="utf-8")
    assert page.count("<math") > 40
    assert "$" not in re.sub(r"<(script|style).*?</\1>", "", page, flags=re.DOTALL)


def test_every_command_has_its_reference(site):
    page = (site / "commands.html").read_text(encoding="utf-8")
    names = set(re.findall(r"^│ ([a-z]+) ", quintrig("--help").out, flags=re.MULTILINE))
    assert {"check", "table", "report", "joins"} <= names
    for name in names:
        assert f"quintrig {name}</code>" in page, name
        assert f'href="#quintrig-{name}"' in page, name
    for name, command in typer.main.get_command(build_commands()).commands.items():
        part = page.partition(f'<h2 id="quintrig-{name}"')[2].partition("<h2")[0]
        for option in (word for one in command.params if not getattr(one, "hidden", False) for word in one.opts):
            assert not option.startswith("-") or option in part, (name, option)
    assert "[bold]" not in page
    assert "..." not in re.findall(r'<a href="#quintrig-\w+">.*', page)[0]  # whole sentences


def test_no_page_asks_another_server_for_anything(site):
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        asked = re.findall(
            r'<(?:script|img|iframe)[^>]* src="(https?:[^"]+)"|<link[^>]*stylesheet[^>]*href="(https?:[^"]+)"', text
        )
        assert asked == [], page.name
        assert not re.search(r"https://(?:unpkg|cdnjs|cdn)\.", text), page.name  # what a script would ask


def test_pages_opened_from_disk_can_be_searched(site):
    assert "umbilic" in (site / "search" / "search_index.js").read_text(encoding="utf-8")
    assert '<script src="iframe-worker.js"></script>' in (site / "index.html").read_text(encoding="utf-8")
    assert (site / "iframe-worker.js").is_file()
