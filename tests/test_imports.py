"""The import direction, held: a core module imports only what stands before it, leaves the core, and nobody the CLI."""

import ast
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parent.parent / "src" / "quintrig"

GROUPS = (
    "errors files arrays compiled taylor functions bspline basis increments blocks curve rational surface",
    "construct reference nurbs envelope exact",
    "curvature classify invariants contraction quantity writing noise planes kernel evaluate sample",
    "quadrature layers beside integrate extremes correspondence agreement signs hull cautions summary",
    "definition explain model",
)
CORE = [name for group in GROUPS for name in group.split()]
"""The core in its order. All other modules are leaves: they may use the core and each other, without circles."""

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
    """Return the modules of quintrig that a module imports anywhere in its text, but for type checkers only."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            node.body = []
    targets = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            assert not node.level, f"{name}: relative import"
            targets |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Import):
            targets |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
            targets |= {arg.value for arg in node.args if isinstance(arg, ast.Constant)}
    inside = {target.removeprefix("quintrig.") for target in targets if target.startswith("quintrig.")}
    found = {module(target) for target in inside} - {name, ""}
    return {target for target in found if (name, target) not in SHOWN}


def module(target):
    """Return the module that a dotted import names: itself, or what holds it."""
    while target not in MODULES:
        target = target.rpartition(".")[0]
    return target


SHOWN = {("surface", "studio.notebook"), ("model", "studio.notebook")}
"""A notebook shows an object by a method of the object: the only looks ahead, taken when it does so."""

IMPORTS = {name: imported(name) for name in MODULES}


def test_the_order_names_modules_that_exist():
    assert set(CORE) <= set(MODULES)
    assert len(CORE) == len(set(CORE))


@pytest.mark.parametrize("name", CORE)
def test_core_module_imports_only_what_stands_before_it(name):
    before = set(CORE[: CORE.index(name)])
    assert IMPORTS[name] <= before, f"{name} imports {IMPORTS[name] - before}"


def test_nobody_imports_the_command_line():
    users = {name for name, found in IMPORTS.items() if any(f.split(".")[0] == "cli" for f in found)}
    assert {name for name in users if name.split(".")[0] not in ("cli", "__main__")} == set()


def test_imports_make_no_circle():
    # A package's __init__ names its parts, and a part belongs to it: that is no circle. The root is lazy.
    waiting = {name: {f for f in found if not f.startswith(f"{name}.")} for name, found in IMPORTS.items() if name}
    waiting = {name: {f for f in found if not name.startswith(f"{f}.")} for name, found in waiting.items()}
    while free := {name for name, found in waiting.items() if not found & set(waiting)}:
        for name in free:
            del waiting[name]
    assert waiting == {}


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


def test_every_public_name_can_be_had_and_is_no_module():
    import quintrig

    for name in dir(quintrig):
        # Not a module: importing one of the same name would put it in the place of the function.
        assert not isinstance(getattr(quintrig, name), ModuleType), name
        assert name not in MODULES
    with pytest.raises(AttributeError, match="no attribute 'analyze'"):
        quintrig.analyze  # noqa: B018
