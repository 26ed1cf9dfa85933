"""Text that no model has is refused before a parser spends time and memory on it, wherever models are read."""

import json
import random
import subprocess
import sys
import tomllib
from time import perf_counter

import pytest

from quintrig.exchange.nets import model_from_net
from quintrig.model.model import load
from quintrig.model.save import merged
from quintrig.model.toml import to_toml
from quintrig.studio import folder
from quintrig.support.errors import ModelError
from quintrig.support.files import refuse_loss
from quintrig.support.parsing import DEEPEST, parse
from quintrig.sweep.store import load_sweep

DEEP = {
    "dotted.toml": ".".join("a" * 40_000) + " = 1",
    "quoted.toml": " . ".join(["'a'", '"b"', "c"] * 10_000) + " = 1",
    "header.toml": "[" + ".".join("a" * 40_000) + "]",
    "inline.toml": "x = {" + ".".join("a" * 40_000) + " = 1}",
    "tables.toml": "x = " + "{a = " * 50_000 + "1",
    "lists.toml": "x = " + "[" * 1_000_000,
    "numbers.toml": "x = " + "[1, " * 5000 + "1" + "]" * 5000,
    "texts.toml": "x = " + "['[', " * 100 + "1" + "]" * 100,
    "lists.json": "[" * 1_000_000,
    "closed.json": '{"a":' * 100 + "1" + "}" * 100,
}
MANY = {
    "keys.toml": "\n".join(f"k{i} = 1" for i in range(900_000)),
    "tables.toml": "\n".join(f"[k{i}]" for i in range(200_000)),
    "inline.toml": "a = [" + "{}, " * 200_000 + "]",
    "keys.json": json.dumps({f"k{i}": 1 for i in range(900_000)}),
    "objects.json": "[" + "{}, " * 200_000 + "{}]",
}
TWICE = {"twice.toml": "kind = 'sphere'\nkind = 'torus'\n", "twice.json": '{"kind": "sphere", "kind": "torus"}'}
BAD = [
    *((name, text, "nested too deeply to be a model") for name, text in DEEP.items()),
    *((name, text, "expected at most 1") for name, text in MANY.items()),
    *((name, text, "is given twice") for name, text in TWICE.items()),
]


@pytest.fixture(params=BAD, ids=lambda bad: f"{bad[0]}-{bad[2][:6]}")
def bad(request, tmp_path):
    name, text, words = request.param
    file = tmp_path / name
    file.write_text(text)
    return file, text, words


def refused(error, words):
    message = str(error.value)
    assert words in message
    assert "\n" not in message
    assert len(message) < 300


def test_a_model_file(bad):
    file, _, words = bad
    with pytest.raises(ModelError) as error:
        load(file)
    refused(error, f"{file}: ")
    refused(error, words)


def test_a_net(bad):
    file, _, words = bad
    if file.suffix == ".json":
        with pytest.raises(ModelError) as error:
            model_from_net(file, {"kind": "tensor"})
        refused(error, words)


def test_what_the_studio_is_sent_and_finds(bad):
    file, text, words = bad
    with pytest.raises(ModelError) as error:
        folder.checked(file.name, text)
    refused(error, words)
    with pytest.raises(ModelError) as error:
        folder.read(file.parent, file.name)
    refused(error, words)


def test_what_is_overwritten(bad):
    file, text, _ = bad
    if file.suffix == ".toml":
        model = load("examples/sphere.toml")
        assert parse(merged(text, model), ".toml") == model.to_dict()
    else:
        refuse_loss(file, force=False)  # is no model, whatever else it is


def test_a_sweep(bad):
    file, text, words = bad
    if file.suffix == ".json":
        (file.parent / "sweep.json").write_text(text)
        with pytest.raises(Exception, match=r"sweep\.json") as error:
            load_sweep(file.parent)
        refused(error, words)


def test_memory_and_time_stay_small(tmp_path):
    for name, text in (DEEP | MANY).items():
        (tmp_path / name).write_text(text)
    code = (
        "import resource, sys\nfrom pathlib import Path\nfrom quintrig import load\n"
        "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
        "for file in Path(sys.argv[1]).iterdir():\n"
        "    try: load(file)\n"
        "    except ValueError: pass\n"
        "print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, tmp_path], capture_output=True, text=True, timeout=60, check=True
    )
    assert float(done.stdout) < 400  # MB; 6300 and more once


def net(rows, columns=60):
    draw = random.Random(0)
    return [[[draw.uniform(-9, 9) for _ in range(3)] for _ in range(columns)] for _ in range(rows)]


def test_a_large_net_reads_as_fast_in_toml_as_in_json():
    keys = {"name": "= [1, 2] # 'no' \"list\"", "points": net(3600), "shape": [0.0, 0.5, 0.0, -1.0]}
    texts = {".json": json.dumps(keys), ".toml": to_toml(keys)}
    assert len(texts[".json"]) > 12e6
    seconds = {}
    for suffix, text in texts.items():
        began = perf_counter()
        assert parse(text, suffix) == keys
        seconds[suffix] = perf_counter() - began
    assert seconds[".toml"] < 3.0 * seconds[".json"] + 1.0


def test_a_large_net_that_is_slow_in_toml_is_refused_with_the_remedy():
    text = "points = [" + "\n".join(f"[0x{i:x}, +{i}, 0], # {i}" for i in range(150_000)) + "]"
    with pytest.raises(ModelError, match="of TOML beside lists of plain numbers, found") as error:
        parse(text, ".toml")
    refused(error, "keep large nets in .csv files beside the model, or write it as .json")


LONG = ", ".join(["1.5", "-2", "3e5", "[0, -0.25]"] * 1000)


@pytest.mark.parametrize(
    "text",
    [
        f"a = [{LONG}]",
        f"a = [{LONG},]  # a last comma\nb = 2",
        f"a = [\n{LONG},\n\n]\n[e]\nE = 1",
        f"a = [{LONG}]\r\nb = [{LONG}]\r\n",
        f"a = [{LONG}, +1]",
        f"a = [{LONG}, 1_000, 0x10, inf]",
        f"a = [{LONG} # remark ]\n]",
        f"a = [[{LONG}], 'x', [{LONG}]]",
        f"a = 'a = [{LONG}]'  # a = [{LONG}]",
        f'a = """\nb = [{LONG}]\n"""\nc = [{LONG}]',
        f"x = [{{a = [{LONG}]}}, {{a = [{LONG}]}}]\n[[patch]]\na = [{LONG}]\n[[patch]]\na = 1",
        "x = '''it's [1]'''\ny = \"say \\\"=[\"\n'k=[' = 1",
        "a.b.c.'d' = 1\n[e.f]\ng = 2024-05-06",
    ],
)
def test_toml_means_what_the_standard_library_says(text):
    assert parse(text, ".toml") == tomllib.loads(text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (f"a = [{LONG}] b = 1", "Expected newline"),
        (f"a = [{LONG}]]", "Expected newline"),
        (f'a = [{LONG}]"', "Expected newline"),
        (f"a = [{LONG},,]", "line 1"),
        (f"a = [,{LONG}]", "line 1"),
        (f"a = [{' ' * 5000},]", "line 1"),
        (f"a = [{LONG}, 01]", "line 1"),
        (f"a = [{LONG}", "end of document"),
        (f"a = [\n{LONG}\n]\nb = = 1", "line 4"),
        (f"a = [{LONG}]\na = 2", "a key is given twice"),
        (f"{LONG}", "line 1"),
    ],
)
def test_what_is_wrong_in_toml_is_wrong_here(text, words):
    with pytest.raises(tomllib.TOMLDecodeError):
        tomllib.loads(text)
    with pytest.raises(ModelError, match="not valid TOML") as error:
        parse(text, ".toml")
    refused(error, words)


def test_as_deep_as_a_model_may_be():
    assert parse("a = " + "[" * DEEPEST + "]" * DEEPEST, ".toml")["a"]
    assert parse("[" * DEEPEST + "]" * DEEPEST, ".json")
    with pytest.raises(ModelError, match="nested too deeply"):
        parse("[" * (DEEPEST + 1) + "]" * (DEEPEST + 1), ".json")
