"""The bundle that ships: built from these sources, from these tables, small, and silent on the network."""

import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import quintrig
from quintrig.studio import BUNDLE, code, embed, policy, viewer
from quintrig.studio.data import table
from quintrig.studio.page import as_json

ROOT = Path(__file__).parents[1]
STUDIO = ROOT / "studio"


def test_the_bundle_is_built_from_the_sources():
    files = [path for path in (STUDIO / "src").rglob("*") if path.is_file()]
    files += [STUDIO / name for name in ("build.mjs", "package.json", "package-lock.json", "tsconfig.json")]
    digest = hashlib.sha256()
    for path in sorted(files, key=lambda path: path.relative_to(STUDIO).as_posix()):
        digest.update(path.relative_to(STUDIO).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    first = BUNDLE.read_text(encoding="utf-8").split("*/", 1)[0]
    assert digest.hexdigest() in first, "studio/src has changed: run `make bundle`"


def test_the_bundle_is_the_one_that_its_sources_make(tmp_path):
    """Whoever builds it with the locked packages gets this very file."""
    if shutil.which("node") is None or not (STUDIO / "node_modules").exists():
        pytest.skip("needs Node and the packages: make studio/node_modules")
    made = tmp_path / "studio.js"
    subprocess.run(["node", "build.mjs", str(made)], cwd=STUDIO, check=True, capture_output=True, timeout=120)
    assert made.read_bytes() == BUNDLE.read_bytes(), "the bundle is another one: run `make bundle`"


def test_the_lock_file_names_no_registry_and_every_package_by_its_hash():
    lock = json.loads((STUDIO / "package-lock.json").read_text(encoding="utf-8"))
    wanted = json.loads((STUDIO / "package.json").read_text(encoding="utf-8"))["devDependencies"]
    packages = {name: one for name, one in lock["packages"].items() if name}
    assert lock["packages"][""]["devDependencies"] == wanted, "run `npm install --package-lock-only` in studio/"
    assert packages
    assert not [name for name, one in packages.items() if "resolved" in one]
    assert not [name for name, one in packages.items() if not one.get("integrity", "").startswith("sha512-")]


def test_the_tables_in_the_bundle_are_those_of_python():
    told = json.loads((STUDIO / "src" / "data.json").read_text(encoding="utf-8"))
    assert told == json.loads(as_json(table())), "a table has changed: run `make bundle`"


def test_the_bundle_is_small():
    assert BUNDLE.stat().st_size < 2**20


def test_nothing_is_fetched_from_elsewhere():
    text = BUNDLE.read_text(encoding="utf-8")
    # three.js names the SVG and XHTML namespaces and puts addresses into messages; nothing else may look like one.
    hosts = set(re.findall(r"https?://([a-z0-9.-]+)", text)) - {"www.w3.org", "threejs.org", "github.com"}
    assert not hosts
    assert "eval(" not in text
    assert "new Function(" not in text


def test_a_name_cannot_break_out_of_the_page():
    keys = {"kind": "sphere", "name": "</script><script>alert(1)</script>& <!--"}
    part = viewer(quintrig.Model.from_dict(keys), identity='a"><b')
    assert "<script>alert" not in part
    assert '"><b' not in part
    data = re.search(r'json" id="[^"]*">(.*)</script>$', part, re.DOTALL)
    assert data
    assert json.loads(data[1])["model"]["name"] == keys["name"]


def test_the_policy_allows_this_script_and_no_network():
    script = re.fullmatch(r'<script type="module">(.*)</script>', code(), re.DOTALL)
    assert script
    assert "</script" not in script[1]
    assert "default-src 'none'" in policy()
    assert "connect-src" not in policy()
    assert "http" not in policy()


def test_an_unknown_quantity_is_refused():
    with pytest.raises(ValueError, match="gaussian"):
        embed(quintrig.Model.from_dict({"kind": "sphere"}), "gausian")
