"""The recipe of CONTRIBUTING: a package adds a kind and a reference surface, and everything else follows."""

import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

PLUGIN = Path(__file__).parent / "plugin"


def environment(*where):
    """Return the environment of a process that finds packages in these folders."""
    path = os.pathsep.join([*map(str, where), os.environ.get("PYTHONPATH", "")])
    return os.environ | {"PYTHONPATH": path, "MPLBACKEND": "agg"}


def quintrig(*arguments, where=(PLUGIN,), folder=None):
    """Run the command line with packages on the path; return the finished process."""
    return subprocess.run(
        [sys.executable, "-m", "quintrig", *map(str, arguments)],
        env=environment(*where),
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def done(*arguments, folder):
    """Run the command line and return what it printed; it must succeed without a warning."""
    result = quintrig(*arguments, folder=folder)
    assert result.returncode == 0, result.stderr
    assert "Warning" not in result.stderr
    assert "left out" not in result.stderr
    return result.stdout


@pytest.fixture(scope="module", params=["scroll", "bowl"])
def toy(request, tmp_path_factory):
    """A folder with a starter model of a kind that the toy package brings."""
    folder = tmp_path_factory.mktemp(request.param)
    done("new", request.param, "-o", "toy.toml", folder=folder)
    return request.param, folder


def test_the_starter_is_commented_and_valid(toy):
    kind, folder = toy
    text = (folder / "toy.toml").read_text(encoding="utf-8")
    assert tomllib.loads(text)["kind"] == kind
    assert "# " in text
    assert kind in done("check", "toy.toml", folder=folder)


def test_numbers_are_right(toy):
    kind, folder = toy
    out = done("table", "toy.toml", "--at", "0.5,0.5", "-q", "gaussian,mean", "-f", "csv", folder=folder)
    last = [float(x) for x in out.strip().splitlines()[-1].split(",")]
    if kind == "bowl":  # K = 1/r², H = 1/r at the bottom, r = 2
        assert last[-2:] == pytest.approx([0.25, 0.5], rel=1e-14)
    else:  # a cylinder over the section
        assert last[-2] == 0.0
        assert last[-1] != 0.0


def test_pictures_report_and_schema(toy):
    kind, folder = toy
    done("plot", "toy.toml", "-q", "gaussian", "-o", "toy.png", folder=folder)
    done("report", "toy.toml", "page", folder=folder)
    page = (folder / "page" / "index.html").read_text(encoding="utf-8")
    title = {"scroll": "Scroll", "bowl": "Paraboloid z = "}[kind]
    assert title in page
    assert f'"{kind}"' in done("schema", folder=folder)


def test_shape_parameters_are_compared_where_there_are_any(toy):
    kind, folder = toy
    result = quintrig("compare", "toy.toml", "pages", folder=folder)
    if kind == "scroll":
        assert result.returncode == 0, result.stderr
        assert (folder / "pages" / "index.html").exists()
    else:
        assert result.returncode == 2
        assert "a bowl has no shape parameters to vary" in result.stderr


def test_sizes_are_swept(toy):
    kind, folder = toy
    name = {"scroll": "alpha1=-1:1:3", "bowl": "radius=1:4:4"}[kind]
    out = done("sweep", "toy.toml", "-o", f"designs-{kind}", "--vary", name, folder=folder)
    assert name.partition("=")[0] in out


def test_cad_files_are_exact(toy):
    pytest.importorskip("OCP", reason="the extra 'cad' is not installed")
    _, folder = toy
    result = quintrig("export", "toy.toml", "toy.step", folder=folder)
    assert result.returncode == 0
    assert "exact" in result.stdout + result.stderr
    assert (folder / "toy.step").stat().st_size > 1000


def _package(folder, name, points, code="from quintrig_toys import Bowl as Other"):
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(f"[quintrig.kinds]\n{points}\n", encoding="utf-8")
    (folder / f"{name}.py").write_text(code, encoding="utf-8")


def test_two_packages_of_one_name_are_both_named(tmp_path):
    _package(tmp_path, "rival", "bowl = rival:Other")
    result = quintrig("new", "bowl", where=(PLUGIN, tmp_path))
    assert result.returncode == 2
    assert result.stderr.count("\n") == 1
    assert "'bowl'" in result.stderr
    assert "quintrig-toys" in result.stderr
    assert "rival" in result.stderr


def test_a_name_of_our_own_is_not_given_away(tmp_path):
    _package(tmp_path, "rival", "sphere = rival:Other")
    result = quintrig("new", "sphere", where=(PLUGIN, tmp_path))
    assert result.returncode == 2
    assert "'sphere' is brought by quintrig and by rival" in result.stderr


@pytest.mark.parametrize(
    ("points", "code", "said"),
    [
        ("broken = broken:Other", "import no_such_module", "No module named 'no_such_module'"),
        ("broken = broken:Other", "Other = 3", "expected a subclass of Definition"),
        ("broken = broken:Other", "from quintrig_toys import Bowl as Other", "Literal['broken']"),
    ],
)
def test_a_package_that_fails_is_named_and_the_rest_works(points, code, said, tmp_path):
    _package(tmp_path, "broken", points, code)
    result = quintrig("new", "bowl", "-o", tmp_path / "bowl.toml", where=(PLUGIN, tmp_path))
    assert result.returncode == 0
    assert "'broken' of broken is left out" in result.stderr
    assert said in result.stderr
    assert result.stderr.count("quintrig: warning: ") == 1
    assert len(result.stderr.strip().splitlines()) == 2  # and what was written
