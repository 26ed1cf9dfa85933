"""The guide to seams: its model loads, its commands run one after the other, its Python too."""

import re
import shlex
from pathlib import Path

import pytest

import quintrig
from cli_runner import quintrig as run

PAGE = (Path(__file__).parent.parent / "docs" / "guide" / "joins.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (text,) = blocks("toml")
    (tmp_path / "pair.toml").write_text(text, encoding="utf-8")
    return tmp_path


def test_commands_run_and_reach_what_they_say(here):
    lines = [line for block in blocks("console") for line in block.splitlines()]
    assert len(lines) >= 8
    for line in lines:
        done = run(*shlex.split(line.removeprefix("$ quintrig ")))
        assert done.code == 0, (line, done.err)
    assert quintrig.load("pair.toml").joins()[0].order == "open"
    assert [quintrig.load(f"{name}.toml").joins()[0].order for name in ("joined", "joined3", "both")] == [
        "G2",
        "G3",
        "G1",
    ]


def test_python_runs(here):
    (code,) = blocks("python")
    exec(compile(code, "joins.md", "exec"), {})
