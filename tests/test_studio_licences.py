"""What is in the bundle comes with its licences, wherever the bundle goes."""

import json
import re
from pathlib import Path

import pytest

import quintrig
from quintrig.report import write_report
from quintrig.studio import BUNDLE, embed

STUDIO = Path(__file__).parents[1] / "studio"


def packages():
    """The packages that the sources import from, by the names in their import statements."""
    found = set()
    for path in (STUDIO / "src").rglob("*.ts"):
        imports = re.findall(r'^(?:import|export|\}).*?from "([^."][^"]*)";', path.read_text("utf-8"), re.MULTILINE)
        found |= {re.match(r"(?:@[^/]+/)?[^/]+", name)[0] for name in imports}
    return sorted(found)


def notices(text):
    """The notices in a bundle, by package."""
    return {one[1]: one[0] for one in re.finditer(r"/\*! (\S+) \d.*?\*/", text, re.DOTALL)}


def test_every_package_in_the_bundle_has_its_notice():
    assert "three" in packages()
    told = notices(BUNDLE.read_text(encoding="utf-8"))
    assert set(told) >= set(packages())
    assert "Copyright © 2010-2026 three.js authors" in told["three"]
    for text in told.values():
        assert "copyright" in text.lower()
        assert re.search(r'THE SOFTWARE IS PROVIDED\s+"AS IS"|THIS SOFTWARE IS PROVIDED', text)


@pytest.mark.parametrize("name", packages())
def test_a_notice_is_the_licence_file_of_the_package(name):
    folder = STUDIO / "node_modules" / name
    if not folder.exists():
        pytest.skip("studio/node_modules is not there: make studio/node_modules")
    file = next(path for path in folder.iterdir() if re.match(r"licen[cs]e", path.name, re.IGNORECASE))
    told = notices(BUNDLE.read_text(encoding="utf-8"))[name]
    assert file.read_text("utf-8").strip() in told
    assert json.loads((folder / "package.json").read_text("utf-8"))["version"] in told


def test_a_report_and_an_embedded_view_carry_the_notices(tmp_path):
    model = quintrig.Model.from_dict({"kind": "sphere"})
    expected = notices(BUNDLE.read_text(encoding="utf-8"))
    assert expected
    for text in (embed(model), write_report(model, tmp_path / "r.html", grid=9).read_text("utf-8")):
        assert notices(text) == expected
