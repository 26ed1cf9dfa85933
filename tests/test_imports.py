"""The import direction, held: a room imports only from rooms below it, and no module stands in a circle."""

import ast
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parent.parent / "src" / "quintrig"

ROOMS = (
    "support",
    "basis quantities",
    "geometry",
    "kernel developables model enclosures",
    "analysis",
    "interrogation sweep multipatch scan",
    "builders figure shaping mesh",
    "exchange",
    "studio",
    "report",
    "reproduce",
    "cli",
)
"""The rooms, lowest first: each imports only from lines above its own, and rooms of one line not from each other."""

FLOOR = {room: floor for floor, rooms in enumerate(ROOMS) for room in rooms.split()}
LOOSE = {"", "__main__"}
"""What lies in no room: the root, which names the public things, and the way in from ``python -m``."""

HEAVY = ("numba", "scipy", "matplotlib", "pydantic", "typer", "rich", "jinja2", "starlette", "dask", "OCP", "trimesh")


def modules():
    """Return {dotted name below quintrig: path}; a package goes by its own name, the root by the empty one."""
    found = {}
    for path in ROOT.rglob("*.py"):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


MODULES = modules()


def imported(name):
    """Return the modules of quintrig that a module names: by import, for type checkers too, or by string."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    targets = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            assert not node.level, f"{name}: relative import"
            targets |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Import):
            targets |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and " " not in node.value:
            targets.add(node.value)
    inside = {target.removeprefix("quintrig.") for target in targets if target.startswith("quintrig.")}
    return {module(target) for target in inside} - {name, ""}


def module(target):
    """Return the module that a dotted import names: itself, or what holds it."""
    while target and target not in MODULES:
        target = target.rpartition(".")[0]
    return target


def room(name):
    """Return the room that a module lies in."""
    return name.partition(".")[0]


IMPORTS = {name: imported(name) for name in MODULES}


def test_every_module_lies_in_a_room():
    assert {room(name) for name in MODULES} - LOOSE <= set(FLOOR)
    assert {name for name in MODULES if "." not in name} - set(FLOOR) == LOOSE


@pytest.mark.parametrize("name", sorted(set(MODULES) - LOOSE))
def test_a_module_imports_only_from_rooms_below_its_own(name):
    others = {found for found in IMPORTS[name] if room(found) != room(name)}
    assert {found for found in others if FLOOR[room(found)] >= FLOOR[room(name)]} == set()


def test_imports_make_no_circle():
    # A package's __init__ names its parts, and a part belongs to it: that is no circle. The root is lazy.
    waiting = {name: {f for f in found if not f.startswith(f"{name}.")} for name, found in IMPORTS.items() if name}
    waiting = {name: {f for f in found if not name.startswith(f"{f}.")} for name, found in waiting.items()}
    while free := {name for name, found in waiting.items() if not found & set(waiting)}:
        for name in free:
            del waiting[name]
    assert waiting == {}


def test_a_forbidden_import_would_be_seen(tmp_path, monkeypatch):
    path = tmp_path / "low.py"
    for text in ("from quintrig.studio import page", "name = 'quintrig.studio.notebook'", "import quintrig.cli.app"):
        path.write_text(f"if TYPE_CHECKING:\n    {text}\n", encoding="utf-8")
        monkeypatch.setitem(MODULES, "support.low", path)
        assert {room(found) for found in imported("support.low")} & {"studio", "cli"}, text


def loaded_by(code):
    """Return which heavy packages a fresh interpreter holds after running ``code``."""
    probe = f"{code}\nimport sys\nprint(*(name for name in {HEAVY!r} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def test_importing_quintrig_loads_nothing_heavy():
    assert loaded_by("import quintrig") == set()
    assert loaded_by("import quintrig\ndir(quintrig)\nquintrig.__version__\nquintrig.ModelError") == set()


def test_building_a_surface_needs_no_compiler():
    assert loaded_by("import quintrig\nquintrig.sphere()(0.5, 0.5)\nquintrig.Curve([[0, 0]] * 6)(0.5)") == set()


def test_analysis_loads_only_the_compiler():
    code = "import quintrig\nquintrig.analyse(quintrig.torus(), *quintrig.grid(3, 3))"
    assert loaded_by(code) <= {"numba", "scipy"}  # Numba looks for SciPy


def test_a_table_on_the_screen_needs_nothing_that_draws_and_a_report_of_a_model_nothing_of_scans():
    lid = ROOT.parents[1] / "examples" / "car_boot.toml"
    compare = (
        "import io, sys\nfrom quintrig.cli.app import build\nfrom quintrig.cli.ending import run\n"
        f"kept, sys.stdout = sys.stdout, io.StringIO()\nassert run(build, ['compare', {str(lid)!r}]) == 0\n"
        "sys.stdout = kept"
    )
    assert not loaded_by(compare) & {"matplotlib", "jinja2"}
    assert not loaded_by("import quintrig.report") & {"numba", "scipy", "trimesh"}


def test_every_public_name_can_be_had_and_is_no_module():
    import quintrig

    for name in dir(quintrig):
        # Not a module: importing one of the same name would put it in the place of the function.
        assert not isinstance(getattr(quintrig, name), ModuleType), name
        assert name not in MODULES
    with pytest.raises(AttributeError, match="no attribute 'analyze'"):
        quintrig.analyze  # noqa: B018
