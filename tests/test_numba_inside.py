"""What Numba has inside and does not promise: where a version fails here, support/numba_inside.py needs a look."""

import re
from pathlib import Path

import numba
import numpy as np
import pytest

import quintrig
from quintrig.support import compiled, machine_code, numba_inside
from quintrig.support.compiled import loop, scalar
from quintrig.support.memory import address, call, codes_at, floats_at, stack_at, stream_line, table_at, words_at

SOURCE = Path(quintrig.__file__).parent
VERSION = f"Numba {numba.__version__}: support/numba_inside.py uses what this version has no longer"


@scalar
def _twice(x: float) -> float:
    return 2.0 * x


@loop
def _double(start: int, count: int, more: float) -> None:
    values = floats_at(start)
    for k in range(count):
        values[k] = _twice(values[k]) + more


@loop
def _greedy(start: int) -> None:
    values = floats_at(start)
    values[0] = np.sort(np.empty(int(values[0]))).sum()


def test_a_loop_works_on_the_memory_at_an_address():
    values = np.arange(5.0)
    _double(address(values), 4, 0.5)
    assert values.tolist() == [0.5, 2.5, 4.5, 6.5, 4.0], VERSION


def test_machine_code_is_loaded_without_what_made_it():
    _, code = numba_inside.compiled(_double.function, _double.kinds, _double.name)
    found = machine_code.load(machine_code.packed(code))
    assert found, VERSION
    again = compiled.Loop(_double.function)
    again.__dict__["address"] = found
    values = np.array([1.0, 2.0])
    again(address(values), 2, -1.0)
    assert values.tolist() == [1.0, 3.0], VERSION


def test_broken_machine_code_and_missing_functions_are_as_good_as_none():
    _, code = numba_inside.compiled(_double.function, _double.kinds, _double.name)
    whole = machine_code.packed(code)
    for broken in (b"", b"\x80junk" * 9, whole[:-1], whole[:40] + b"x" + whole[41:]):
        assert machine_code.load(broken) is None
    assert machine_code.load(machine_code.packed(code._replace(needs=("no_such_function",)))) is None


def test_a_loop_that_reserves_memory_is_refused():
    with pytest.raises(RuntimeError, match=r"expected a loop that needs nothing of Numba, found .*NRT_"):
        numba_inside.compiled(_greedy.function, _greedy.kinds, _greedy.name)


def test_a_loop_holds_whole_numbers_only():
    held = np.ones(3)

    def bad(start: int) -> None:
        floats_at(start)[0] = held[0]

    with pytest.raises(TypeError, match="expected only whole numbers in its closure"):
        loop(bad)


@pytest.mark.parametrize(
    "word",
    [
        lambda: floats_at(0),
        lambda: words_at(0),
        lambda: codes_at(0),
        lambda: table_at(0, 1, 1),
        lambda: stack_at(0, 1, 1, 1),
        lambda: stream_line(0, 0),
        lambda: call(0, 0, 0, 0, 0, 0, 0, 0),
    ],
)
def test_memory_is_out_of_reach_of_python(word):
    with pytest.raises(NotImplementedError, match="only compiled loops"):
        word()


def test_an_address_is_of_memory_without_gaps():
    with pytest.raises(ValueError, match="without gaps"):
        address(np.zeros((3, 4))[:, :2])


def test_no_other_module_looks_inside():
    inside = re.compile(r"_final_module|_get_compiled_object|load_overload|fndesc|\.overloads|get_pointer_to_function")
    using = [path.name for path in SOURCE.rglob("*.py") if inside.search(path.read_text(encoding="utf-8"))]
    assert using == ["numba_inside.py"]


def test_no_guard_is_an_assertion():
    """Python drops assertions under -O."""
    for path in SOURCE.rglob("*.py"):
        assert not re.search(r"^\s*assert ", path.read_text(encoding="utf-8"), re.MULTILINE), path
