"""What the README says of make; tests/test_guides.py types its commands and runs its Python."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
@pytest.mark.parametrize("target", ["report", "test"])
def test_make_knows_the_two_commands(target):
    assert f"make {target}" in (ROOT / "README.md").read_text()
    done = subprocess.run(["make", "-n", target], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert ("quintrig report" if target == "report" else "pytest") in done.stdout
