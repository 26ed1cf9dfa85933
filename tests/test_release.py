"""What is uploaded: the wheel holds what it must and works alone; recipe and citation say what the package says."""

import email
import importlib.util
import os
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def run(*command, **words):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The wheel and the source distribution."""
    for name in ("build", "hatchling", "twine"):
        if importlib.util.find_spec(name) is None:
            assert not os.environ.get("CI"), f"{name} is missing in CI"
            pytest.skip(f"needs {name}: pip install 'quintrig[dev]'")
    out = tmp_path_factory.mktemp("dist")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", str(out), str(ROOT))
    (wheel,), (source,) = out.glob("*.whl"), out.glob("*.tar.gz")
    return wheel, source


def test_an_index_takes_both(files):
    assert run(sys.executable, "-m", "twine", "check", "--strict", *map(str, files)).count("PASSED") == 2


def test_the_wheel_holds_types_data_and_licences_and_nothing_else(files):
    with zipfile.ZipFile(files[0]) as wheel:
        names = set(wheel.namelist())
        (metadata,) = (name for name in names if name.endswith("/METADATA"))
        said = email.message_from_bytes(wheel.read(metadata))
        bundle = wheel.read("quintrig/studio/bundle/studio.js").decode()
    assert {name.split("/")[0] for name in names} == {"quintrig", metadata.split("/")[0]}
    assert "quintrig/py.typed" in names
    assert any(name.endswith("licenses/LICENSE") for name in names)
    for name in ("smol-toml", "three"):
        assert f"/*! {name} " in bundle, name  # its licence
    tracked = run("git", "-C", str(ROOT), "ls-files", "src/quintrig").split() if (ROOT / ".git").exists() else []
    assert {name.removeprefix("src/") for name in tracked} <= names
    assert said["Version"] == PROJECT["version"]
    assert said.get_content_charset("utf-8") == "utf-8"


def test_the_source_holds_what_tests_and_documentation_are_made_of(files):
    with tarfile.open(files[1]) as source:
        names = {name.partition("/")[2] for name in source.getnames()}
    for name in ("Makefile", "mkdocs.yml", "tests/conftest.py", "docs/hooks.py", "paper/paper.md", "bench/__main__.py"):
        assert name in names
    assert not any("node_modules" in name or name.startswith("out/") for name in names)


def test_the_wheel_works_in_an_empty_environment(files, tmp_path):
    run(sys.executable, "-m", "venv", str(tmp_path / "env"))
    scripts = tmp_path / "env" / ("Scripts" if os.name == "nt" else "bin")
    done = subprocess.run(
        [scripts / "python", "-m", "pip", "install", "--quiet", str(files[0])],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode and not os.environ.get("CI"):
        pytest.skip("needs a package index to fetch what the wheel depends on")
    assert done.returncode == 0, done.stderr
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    for words in (["new", "swept", "-o", "lid.toml"], ["check", "lid.toml"], ["plot", "lid.toml", "-o", "lid.png"]):
        run(str(scripts / "quintrig"), *words, cwd=tmp_path, env=clean)
    assert (tmp_path / "lid.png").read_bytes()[:4] == b"\x89PNG"
    assert run(str(scripts / "quintrig"), "--version", cwd=tmp_path, env=clean).split()[-1] == PROJECT["version"]


def test_version_stands_alike_everywhere():
    version = PROJECT["version"]
    said = {
        "src/quintrig/__init__.py": r'^__version__ = "(.*)"$',
        "studio/package.json": r'^  "version": "(.*)",$',
        "CITATION.cff": r"^version: (.*)$",
        "conda/meta.yaml": r'set version = "(.*)" %}$',
    }
    for path, pattern in said.items():
        assert re.findall(pattern, (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE) == [version], path
    heading = re.search(r"^## (\S+) \((\d{4}-\d\d-\d\d)\)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)
    released = re.search(r"^date-released: (.*)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    assert heading.groups() == (version, released[1])


def test_the_recipe_asks_for_what_the_package_asks_for():
    recipe = (ROOT / "conda" / "meta.yaml").read_text(encoding="utf-8")
    runs = re.search(r"  run:\n((?:    - .*\n)+)", recipe)[1]
    asked = {
        line.removeprefix("    - ").replace("matplotlib-base", "matplotlib").replace(" ", "")
        for line in runs.splitlines()
    }
    assert asked == {f"python{PROJECT['requires-python']}", *PROJECT["dependencies"]}


def test_the_draft_of_the_paper_cites_what_it_lists_and_builds(tmp_path):
    text = (ROOT / "paper" / "paper.md").read_text(encoding="utf-8")
    listed = re.findall(r"^@\w+\{(\w+),", (ROOT / "paper" / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE)
    assert set(re.findall(r"@(\w+)", text)) == set(listed)
    if importlib.util.find_spec("pypandoc") is None:
        assert not os.environ.get("CI"), "pypandoc is missing in CI"
        pytest.skip("needs pypandoc: pip install 'quintrig[dev]'")
    import pypandoc

    more = ["--citeproc", f"--bibliography={ROOT / 'paper' / 'paper.bib'}", "--fail-if-warnings"]
    page = pypandoc.convert_file(str(ROOT / "paper" / "paper.md"), "html", extra_args=more)
    assert "Koenderink" in page.rpartition('id="refs"')[2]
