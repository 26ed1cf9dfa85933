"""Run Python as on a lesser processor: ``processor.py haswell -m pytest ...`` (AVX2, no AVX-512) or ``generic``.

Numba, NumPy and OpenBLAS each have their own switch. NumPy's names of what can be left out differ between its versions,
so they are asked of the one installed.
"""

import os
import sys

KINDS = {"haswell": ("haswell", "+avx2,+fma", "Haswell"), "generic": ("generic", "", "Nehalem")}
"""What Numba compiles for, with which features (else it takes those of the machine), and the core OpenBLAS takes."""


def switches(kind: str) -> dict[str, str]:
    """Return the environment variables that make this processor one of ``kind``."""
    from numpy._core import _multiarray_umath as built

    wide = [name for name in built.__cpu_dispatch__ if name not in built.__cpu_baseline__]
    if kind == "haswell":
        wide = [name for name in wide if "AVX512" in name or name == "X86_V4"]
    name, features, core = KINDS[kind]
    return {
        "NUMBA_CPU_NAME": name,
        "NUMBA_CPU_FEATURES": features,
        "OPENBLAS_CORETYPE": core,
        "NPY_DISABLE_CPU_FEATURES": " ".join(wide),
    }


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in KINDS:
        sys.exit(f"expected {' or '.join(KINDS)}, then what to give to Python")
    os.execve(sys.executable, [sys.executable, *sys.argv[2:]], os.environ | switches(sys.argv[1]))
