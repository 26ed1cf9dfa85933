"""Print the lowest versions that pyproject.toml lets in, as constraints for pip: ``lowest.py [EXTRA ...]``."""

import re
import sys
import tomllib
from pathlib import Path

PROJECT = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def lowest(*extras: str) -> dict[str, str]:
    """Return the lower bound of each dependency, and of those of extras, by name."""
    lines = [*PROJECT["dependencies"], *(line for extra in extras for line in PROJECT["optional-dependencies"][extra])]
    bounds = (re.fullmatch(r"([\w.-]+)(?:\[\w+\])?>=([\w.]+).*", line) for line in lines)
    return {bound[1]: bound[2] for bound in bounds if bound}


if __name__ == "__main__":
    print(*(f"{name}=={bound}" for name, bound in lowest(*sys.argv[1:]).items()), sep="\n")
