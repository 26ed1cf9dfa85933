"""What stands beside the code says what is so: citation, checks before a commit, lowest versions, kept benchmarks."""

import ast
import importlib.util
import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from bench import kept
from packaging.requirements import Requirement

import quintrig

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def _script(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / ".ci" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_one_version_everywhere():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"^version: (\S+)$", citation, re.M) == [quintrig.__version__]
    assert PROJECT["version"] == quintrig.__version__
    assert json.loads((ROOT / "studio" / "package.json").read_text())["version"] == quintrig.__version__


def test_every_dependency_has_a_lowest_version():
    lowest = _script("lowest").lowest(*PROJECT["optional-dependencies"])
    lines = [*PROJECT["dependencies"], *(line for extra in PROJECT["optional-dependencies"].values() for line in extra)]
    asked = [Requirement(line) for line in lines]
    assert {one.name for one in asked} - {"quintrig"} == set(lowest)
    for one in asked:
        if one.name != "quintrig":
            assert one.specifier.contains(lowest[one.name]), one


@pytest.mark.parametrize(
    ("cell", "code"),
    [
        ({"cell_type": "code", "outputs": [], "execution_count": None}, 0),
        ({"cell_type": "markdown"}, 0),
        ({"cell_type": "code", "outputs": [{"output_type": "stream"}], "execution_count": None}, 1),
        ({"cell_type": "code", "outputs": [], "execution_count": 3}, 1),
    ],
)
def test_notebooks_with_outputs_are_refused(cell, code, tmp_path):
    path = tmp_path / "one.ipynb"
    path.write_text(json.dumps({"cells": [cell]}), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, ROOT / ".ci" / "notebooks.py", path], capture_output=True, text=True, check=False
    )
    assert done.returncode == code
    assert done.stdout.count("\n") == code


def test_checks_before_a_commit_are_those_of_make_check():
    hooks = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    assert re.findall(r"repo: (\S+)", hooks) == ["local"]
    recipe = (ROOT / "Makefile").read_text(encoding="utf-8").partition("\ncheck:")[2].partition("\n\n")[0]
    commands = re.findall(r"\$\(BIN\)/(\w+(?: check| format --check)?)", recipe)
    assert commands == ["ruff check", "ruff format --check", "pyright"]
    for command in commands:
        assert f".venv/bin/{command}" in hooks


def test_tables_of_a_benchmark_are_kept_with_their_titles():
    with kept.told() as text:
        print("A title\nof two lines\n\n| way | ns |\n|-----|---:|\n| a   |  1 |\n| b   |  2 |\n")
    found = [{"title": "A title of two lines", "head": ["way", "ns"], "rows": [["a", "1"], ["b", "2"]]}]
    assert kept.tables(text.getvalue()) == found


@pytest.mark.parametrize("file", sorted((ROOT / "bench").glob("*.py")), ids=lambda file: file.stem)
def test_a_benchmark_finds_what_it_imports(file):
    """Nobody runs the benchmarks but for a release, so that a name that moved would go unseen until then."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(("quintrig", "bench")):
            module = importlib.import_module(node.module)
            for name in node.names:
                if not hasattr(module, name.name):
                    importlib.import_module(f"{node.module}.{name.name}")
