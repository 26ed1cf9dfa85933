"""What the README and the first steps tell a newcomer to type, typed."""

import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = ("README.md",)  # tests/test_guides.py types the guide


def _blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", (ROOT / page).read_text(), re.S)


def _commands(page):
    lines = [line for block in _blocks(page, "console") for line in block.splitlines()]
    words = [shlex.split(line[2:], comments=True) for line in lines if line.startswith("$ quintrig")]
    return [tuple(command[1:]) for command in words]


@pytest.mark.parametrize("page", PAGES)
def test_commands_run_one_after_the_other(page, tmp_path):
    commands = _commands(page)
    assert len(commands) >= 5
    for command in commands:
        done = subprocess.run(
            [sys.executable, "-m", "quintrig", *command], cwd=tmp_path, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, (command, done.stderr)


@pytest.mark.parametrize("page", PAGES)
def test_python_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    shutil.copy(ROOT / "examples" / "swept.toml", tmp_path / "lid.toml")
    (block,) = _blocks(page, "python")
    exec(compile(block, page, "exec"), {})


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
@pytest.mark.parametrize("target", ["report", "test"])
def test_make_knows_the_two_commands(target):
    assert f"make {target}" in (ROOT / "README.md").read_text()
    done = subprocess.run(["make", "-n", target], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert ("quintrig report" if target == "report" else "pytest") in done.stdout
