"""Starting up loads nothing that is not needed. How long it takes is a matter of ``make bench``."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

MODEL = Path(__file__).parents[1] / "examples" / "car_boot.toml"
HEAVY = (
    *("matplotlib", "numba", "llvmlite", "jinja2", "pydantic", "typer", "rich"),
    *("scipy.linalg", "scipy.stats", "scipy.interpolate", "scipy.optimize"),  # Numba looks into the topmost scipy
    *("polars", "pyarrow", "zarr", "dask", "distributed", "trimesh", "meshio", "OCP", "ezdxf", "rhino3dm"),
    *("starlette", "uvicorn", "IPython", "anywidget"),
)


def loaded(code):
    """Return the heavy packages that a fresh process has loaded after running ``code``."""
    tail = f"\nimport json, sys\nprint(json.dumps([name for name in {HEAVY!r} if name in sys.modules]))"
    done = subprocess.run([sys.executable, "-c", code + tail], capture_output=True, text=True, check=True)
    return set(json.loads(done.stdout.splitlines()[-1]))


def test_the_package_alone_loads_nothing_else():
    assert loaded("import quintrig; dir(quintrig)") == set()


@pytest.mark.parametrize(
    ("code", "allowed"),
    [
        ("import quintrig; quintrig.tensor", set()),
        (
            "import quintrig; quintrig.Curve([[i, i * i, 0] for i in range(6)])(0.5)",
            set(),
        ),
        ("import quintrig; quintrig.Model", {"pydantic"}),
        ("import quintrig; quintrig.analyse", set()),
        ("import quintrig.sweep", {"pydantic"}),
        ("import quintrig.analysis.stream", set()),
        ("import quintrig.cli", {"typer", "rich"}),
        ("from quintrig.cli.app import build; build()", {"typer", "rich"}),
        (
            "import contextlib, io, sys\nfrom quintrig.cli import main\nsys.argv = ['quintrig', '--help']\n"
            "with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit):\n    main()",
            {"typer", "rich"},
        ),
    ],
)
def test_each_part_loads_only_what_it_works_with(code, allowed):
    assert loaded(code) <= allowed


@pytest.mark.parametrize("words", [["check"], ["table", "--at", "0.5,0.5"], ["table", "--grid", "3x3"]])
def test_a_small_command_works_without_numba_scipy_and_matplotlib(words):
    code = (
        "import contextlib, io, sys\nfrom quintrig.cli import main\n"
        f"sys.argv = ['quintrig', {words[0]!r}, {str(MODEL)!r}, *{words[1:]!r}]\n"
        "with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit):\n    main()"
    )
    loaded(code)  # what is not compiled yet is now
    heavy = {"numba", "matplotlib", "jinja2", "scipy.linalg", "scipy.optimize", "scipy.stats", "scipy.interpolate"}
    assert not loaded(code) & heavy


def test_every_public_name_is_found():
    drawing = {"plot", "Style", "animate", "Animation"}
    code = f"import quintrig\nfor name in set(dir(quintrig)) - {drawing}: getattr(quintrig, name)"
    assert "matplotlib" not in loaded(code)


def test_an_unknown_name_is_an_attribute_error():
    import quintrig

    with pytest.raises(AttributeError, match="'quintrig' has no attribute 'nosuch'"):
        _ = quintrig.nosuch
