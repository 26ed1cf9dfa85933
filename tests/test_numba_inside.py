"""What Numba has inside and does not promise: where a version fails here, support/numba_inside.py needs a look."""

import ctypes
import re
from pathlib import Path

import numba
import pytest

import quintrig
from quintrig.support.numba_inside import address, share_cache

SOURCE = Path(quintrig.__file__).parent
VERSION = f"Numba {numba.__version__}: support/numba_inside.py uses what this version has no longer"


@pytest.fixture
def kept(tmp_path, monkeypatch):
    """Return a loop that is kept on disk."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))

    @numba.njit(cache=True)
    def double(x):
        return 2.0 * x

    return double


def test_a_loop_is_found_in_memory():
    @numba.njit
    def loop(a, b, c, d, e, f, g):
        if a + b + c + d + e + f + g < 0:
            raise ValueError("below zero")

    found = address(loop)
    assert isinstance(found, int), VERSION
    assert found, VERSION
    # The wrapper that C calls: seven whole numbers in, nothing out.
    ctypes.CFUNCTYPE(None, *[ctypes.c_ssize_t] * 7)(found)(1, 2, 3, 4, 5, 6, 7)


def test_the_files_of_a_process_have_names_of_their_own(kept, tmp_path):
    files = kept._cache._cache_file
    assert "{number:d}" in files._data_name_pattern, VERSION
    share_cache(kept, "word")
    assert kept(3.0) == 6.0
    assert [path for path in tmp_path.rglob("*.nbc") if "-word" in path.name or ".word" in path.name], VERSION


def test_a_broken_file_is_as_good_as_none(kept):
    share_cache(kept, "word")

    class Broken:
        def __getattr__(self, name):
            raise OSError("no such disk")

    kept._cache._cache_file = Broken()
    assert kept(3.0) == 6.0, VERSION


def test_what_has_no_cache_is_left_alone():
    share_cache(object(), "word")


def test_no_other_module_looks_inside():
    inside = re.compile(r"_cache_file|_data_name_pattern|load_overload|fndesc|\.overloads|get_pointer_to_function")
    using = [path.name for path in SOURCE.rglob("*.py") if inside.search(path.read_text(encoding="utf-8"))]
    assert using == ["numba_inside.py"]


def test_no_guard_is_an_assertion():
    """Python drops assertions under -O."""
    for path in SOURCE.rglob("*.py"):
        assert not re.search(r"^\s*assert ", path.read_text(encoding="utf-8"), re.MULTILINE), path
