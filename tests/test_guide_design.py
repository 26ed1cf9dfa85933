"""The guide to design: its files are read, its commands run one after the other, its Python too."""

import re
import shlex
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run

PAGE = (Path(__file__).parent.parent / "docs" / "guide" / "design.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in zip(("lid", "goals", "rails"), blocks("toml"), strict=True):
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
    return tmp_path


def test_commands_and_python_run_and_reach_what_they_say(here):
    lines = [line for block in blocks("console") for line in block.splitlines()]
    assert len(lines) == 5
    for line in lines:
        done = run(*shlex.split(line.removeprefix("$ quintrig ")))
        assert done.code == 0, (line, done.err)
    t = np.linspace(0.0, 1.0, 101)
    found = quintrig.analyse(quintrig.load("better.toml").surface, t[:, None], t)
    assert max(np.abs(found["k1"]).max(), np.abs(found["k2"]).max()) <= 1.001 / 12.0
    (code,) = blocks("python")
    exec(compile(code, "design.md", "exec"), {})
