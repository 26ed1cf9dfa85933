"""Every command and every block of Python of the README and of every page of the guide runs as it stands there."""

import os
import re
import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run

ROOT = Path(__file__).parent.parent
GUIDE = sorted((ROOT / "docs" / "guide").glob("*.md"))
PAGES = {page.stem: [page] for page in GUIDE}
PAGES["start"].insert(0, ROOT / "README.md")  # most of its commands are those of the first steps

if not os.environ.get("CI"):
    for needed in ("OCP", "rhino3dm", "meshio", "ezdxf", "pyvista", "build123d", "compas", "trimesh"):
        pytest.importorskip(needed, reason="needs all extras")

SKIPPED = {
    r"quintrig view ": "serves until it is stopped",
    r"--scheduler ": "needs a cluster",
    r"--size 30000 ": "900 million rows",
    r"--frames 10 .*\.mp4": "" if shutil.which("ffmpeg") else "needs ffmpeg",
}
"""What does not run here, by a pattern of the command, and why; an empty reason runs it."""


@dataclass(frozen=True)
class Step:
    """A thing that a page does: a line of the shell, a block of Python, or a file that it shows by its name."""

    kind: str
    text: str
    line: int
    name: str = ""


def steps(page):
    """Return the steps of a page in order; a block of TOML is a file where the line before names one, with a colon."""
    language, block, started, before = None, [], 0, ""
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("```") and language is None:
            language, block, started = line[3:].strip(), [], number
        elif line.startswith("```"):
            text = "\n".join(block) + "\n"
            if language == "python":
                yield Step("python", text, started + 1)
            named = re.findall(r"`([\w./-]+\.toml)`", before)
            if language == "toml" and named and before.rstrip().endswith(":"):
                yield Step("file", text, started, named[-1])
            language = None
        elif language is not None:
            block.append(line)
            if language in ("console", "sh", "text") and re.match(r"(\$ )?quintrig ", line):
                yield Step("command", line.removeprefix("$ "), number)
        elif re.match(r"    (\$ )?quintrig ", line):
            yield Step("command", line.strip().removeprefix("$ "), number)
        if line.strip() and not line.startswith("```"):
            before = line if language is None else before


def reader_s_own_files(folder):
    """Write what a reader brings along and no command of quintrig makes: measured points and curves of CAD."""
    from test_exchange import curves_file

    curves_file(folder / "frame.3dm")
    turn, height = np.meshgrid(np.linspace(0.0, 2.0 * np.pi, 25), np.linspace(0.0, 30.0, 9))
    pin = np.column_stack([(5.0 * np.cos(turn)).ravel(), (5.0 * np.sin(turn)).ravel(), height.ravel()])
    np.savetxt(folder / "pin.xyz", pin)
    x = 0.5 * (1.0 - np.cos(np.linspace(0.0, np.pi, 41)))
    half = 0.6 * (0.2969 * np.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
    camber = np.where(x < 0.4, 0.125 * (0.8 * x - x**2), 0.02 / 0.36 * (0.2 + 0.8 * x - x**2))
    upper, lower = np.column_stack([x, camber + half])[::-1], np.column_stack([x, camber - half])[1:]
    np.savetxt(folder / "naca2412.dat", np.vstack([upper, lower]), header="NACA 2412", comments="")
    np.savetxt(folder / "points.csv", [[0, 0], [10, 20], [30, 10], [40, 30]], delimiter=",")


def joins_reach_their_orders():
    reached = [quintrig.load(f"{name}.toml").joins()[0].order for name in ("joined", "joined3", "both")]
    assert reached == ["G2", "G3", "G1"]


def design_meets_its_demand():
    t = np.linspace(0.0, 1.0, 101)
    found = quintrig.analyse(quintrig.load("better.toml").surface, t[:, None], t)
    assert max(np.abs(found["k1"]).max(), np.abs(found["k2"]).max()) <= 1.001 / 12.0


REACHES = {"joins": joins_reach_their_orders, "design": design_meets_its_demand}
"""What is true after a page, where it promises values."""


ENDS = ("report", "compare", "reproduce")
"""Commands whose pages no other command reads: the same one on the same files need not be run twice."""


def files(text):
    """Return what the files hold that a command names."""
    return tuple(Path(word).read_bytes() for word in shlex.split(text, comments=True) if Path(word).is_file())


def follow(page, folder, monkeypatch, done):
    """Do what a page says, in a folder of its own; ``done`` remembers what need not be done again."""
    for copy in (folder, folder / "examples"):
        shutil.copytree(ROOT / "examples", copy, dirs_exist_ok=True)
    reader_s_own_files(folder)
    monkeypatch.chdir(folder)
    names = {}
    for step in steps(page):
        where = f"{page.name}, line {step.line}: {step.text}"
        if step.kind == "file":
            Path(step.name).write_text(step.text, encoding="utf-8")
        elif step.kind == "python":
            exec(compile("\n" * (step.line - 1) + step.text, str(page), "exec"), names)
        elif not any(reason and re.search(pattern, step.text) for pattern, reason in SKIPPED.items()):
            words = shlex.split(step.text, comments=True)[1:]
            same = (*words, *files(step.text))
            if words[0] in ENDS and same in done:
                continue
            done.add(same)
            ended = run(*words)
            assert ended.code == 0, f"{where}\n{ended.err}"


def test_commands_are_found():
    found = [step for pages in PAGES.values() for page in pages for step in steps(page) if step.kind == "command"]
    assert len(found) > 80
    assert sum(step.kind == "command" for step in steps(ROOT / "README.md")) >= 5
    for pattern in SKIPPED:
        assert any(re.search(pattern, step.text) for step in found), f"nothing to skip: {pattern}"


@pytest.mark.parametrize("name", PAGES)
def test_page(name, tmp_path, monkeypatch):
    import pyvista

    monkeypatch.setattr(pyvista.DataSet, "plot", lambda *_, **__: None)  # a window
    done = set()
    for page in PAGES[name]:
        follow(page, tmp_path / page.stem, monkeypatch, done)
    REACHES.get(name, lambda: None)()
