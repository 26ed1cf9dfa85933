"""Readers that leave, closed streams, full disks, names that are no UTF-8 and other locales, as from a shell."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"
ASCII = {"PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "LC_ALL": "C", "PYTHONIOENCODING": "ascii"}

pytestmark = pytest.mark.skipif(os.name == "nt", reason="closes streams and names files as only POSIX lets one")


@pytest.fixture
def here(tmp_path):
    shutil.copy(EXAMPLES / "swept.toml", tmp_path / "lid.toml")
    return tmp_path


def shell(command, folder, **environment):
    """Run a line of shell, in which Q is quintrig; return (code of the last command, stdout, stderr)."""
    line = command.replace("Q ", f"'{sys.executable}' -m quintrig ")
    done = subprocess.run(
        ["bash", "-c", f"set -o pipefail; {line}"],
        cwd=folder,
        env=os.environ | environment,
        capture_output=True,
        timeout=120,
        check=False,
    )
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


@pytest.mark.parametrize(
    "command",
    [
        "Q table lid.toml --grid 60x60 -f csv | head -1",
        "Q check lid.toml | true",
        "Q check lid.toml 2>&1 | true",
        "Q --help | true",
        "Q table --list | head -1",
        "Q check lid.toml >&-",
        "Q table lid.toml -f csv >&- 2>&-",
        "Q --version <&- >&- 2>&-",
    ],
)
def test_nobody_reads_to_the_end_and_that_is_no_mistake(command, here):
    code, _, err = shell(command, here)
    assert (code, err) == (0, "")


@pytest.mark.parametrize("streams", ["2>&-", ">&- 2>&-", "2>/dev/full", "2>&1 | true", "<&- >&- 2>&-"])
def test_a_mistake_is_one_though_nobody_is_told(streams, here):
    if "full" not in streams or Path("/dev/full").exists():
        assert shell(f"Q check none.toml {streams}", here)[0] == 2


@pytest.mark.parametrize("streams", ["2>&-", ">&- 2>&-", "2>&1 | true"])
def test_work_is_done_whole_though_nobody_listens(streams, here):
    assert shell(f"Q export lid.toml net.csv {streams}", here)[0] == 0
    assert shell(f"Q table lid.toml -o table.csv {streams}", here)[0] == 0
    assert len((here / "table.csv").read_text().splitlines()) > 25
    for name in ("net-section.csv", "net-trajectory.csv"):
        assert len((here / name).read_text().splitlines()) == 8  # and not a word of what was said


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a disk that is always full")
def test_a_full_disk_is_told_once(here):
    code, _, err = shell("Q table lid.toml -f csv >/dev/full", here)
    assert code == 2
    assert err.count("\n") == 1
    assert "No space left" in err


def spelt(name):
    """Return bytes as a word of bash."""
    return "$'" + "".join(rf"\x{byte:02x}" for byte in name) + "'"


STRANGE = pytest.mark.parametrize(
    ("name", "environment"),
    [(b"l\xff", {}), ("Lö∞".encode(), {}), ("Lö∞".encode(), ASCII), (b"l\xff", {"PYTHONIOENCODING": "latin-1"})],
    ids=["no-utf8", "utf8", "utf8-in-ascii", "no-utf8-in-latin-1"],
)


@pytest.fixture
def strange(here, request):
    """Return the folder, with a model of a strange name in it, or skip where the system has no such names."""

    def make(name):
        try:
            shutil.copy(here / "lid.toml", os.fsencode(here) + b"/" + name + b".toml")
            shutil.copy(EXAMPLES / "from_csv.csv", os.fsencode(here) + b"/" + name + b".csv")
        except (OSError, ValueError):
            pytest.skip("this file system wants names in UTF-8")
        return here

    return make


@STRANGE
def test_files_of_any_name_and_in_any_locale(name, environment, strange):
    folder = strange(name)
    word = spelt(name)
    commands = ["check {}.toml", "table {}.toml -o t{}.json", "import {}.csv -o i{}.toml", "check i{}.toml"]
    if pytest.importorskip("pyarrow"):
        commands += ["grid {}.toml g{}.parquet --size 3x3"]
    for command in commands:
        code, _, err = shell(f"Q {command.replace('{}', word)}", folder, **environment)
        assert code == 0, (command, err)
        assert "Traceback" not in err
    made = {os.fsencode(file.name) for file in folder.iterdir()}
    assert made >= {b"t" + name + b".json", b"i" + name + b".toml"}


@STRANGE
def test_cad_files_of_any_name(name, environment, strange):
    pytest.importorskip("OCP")
    folder = strange(name)
    word = spelt(name)
    assert shell(f"Q export lid.toml {word}.step", folder, **environment)[0] == 0
    code, out, err = shell(f"Q import {word}.step --list", folder, **environment)
    assert (code, err) == (0, "")
    assert "faces 1" in out


def test_a_sweep_into_a_folder_that_no_library_opens_is_refused_before_any_work(strange):
    pytest.importorskip("polars")
    folder = strange(b"l\xff")
    code, out, err = shell(r"Q sweep lid.toml --vary alpha1=-1:1:3 -o $'l\xff'", folder)
    assert (code, out) == (2, "")
    assert "expected a folder whose name is in UTF-8" in err
    assert err.count("\n") == 1
    assert b"l\xff" not in {os.fsencode(file.name) for file in folder.iterdir()}


def test_a_name_that_the_system_cannot_spell_is_refused_in_one_line(here):
    net = f'points = "{EXAMPLES.name}.csv"'
    shutil.copy(EXAMPLES / "from_csv.csv", here / f"{EXAMPLES.name}.csv")
    patches = "".join(f'[[patch]]\nname = "{name}"\nkind = "tensor"\n{net}\n' for name in ("für", "ä"))
    (here / "two.toml").write_text(patches, encoding="utf-8")
    assert shell("Q export two.toml net.csv", here)[0] == 0
    code, _, err = shell("Q export two.toml again.csv", here, **ASCII)
    if code:  # where the system's names are ASCII
        assert (code, err.count("\n")) == (2, 1)
        assert "this system cannot spell the name" in err
        assert not list(here.glob("again*"))


def test_the_studio_lists_the_files_that_it_can_name(strange):
    folder = pytest.importorskip("quintrig.studio.folder")
    place = strange(b"l\xff")
    assert folder.names(place) == ["lid.toml"]
    code, _, err = shell(r"Q view $'l\xff.toml' --no-browser", place)
    assert (code, err.count("\n")) == (2, 1)
    assert "expected a model whose name is in UTF-8" in err
