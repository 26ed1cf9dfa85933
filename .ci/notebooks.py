"""Refuse notebooks that hold outputs or counts of runs: ``notebooks.py FILE ...``, one line for each that does."""

import json
import sys
from pathlib import Path


def kept(path: Path) -> int:
    """Return how many cells of a notebook hold an output or the count of a run."""
    cells = json.loads(path.read_text(encoding="utf-8")).get("cells", [])
    return sum(bool(cell.get("outputs") or cell.get("execution_count")) for cell in cells)


if __name__ == "__main__":
    found = {name: count for name in sys.argv[1:] if (count := kept(Path(name)))}
    for name, count in found.items():
        print(f"{name}: expected no outputs, found {count} cells with some; clear all outputs, then save")
    sys.exit(bool(found))
