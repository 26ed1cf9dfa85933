"""The page reads TOML as Python does: the same texts, with the same values, and refuses the same.

What only TOML 1.1 allows (such as line breaks in inline tables) stands in a list that studio/tests/ reads too.
"""

import json
import math
import tomllib
from pathlib import Path

import pytest

from node import asked

NEWER = json.loads((Path(__file__).parent / "data" / "toml_1_0.json").read_text(encoding="utf-8"))
GOOD = [
    *NEWER["read"],
    "",
    "# only a remark",
    'a = "x"\r\nb = 1\r\n',
    "a.b.c = 1\na.d = 2",
    "[a]\nb = 1\n[a.c]\nd = 2",
    "[[patch]]\nkind = 'cone'\n[[patch]]\nkind = 'torus'",
    "points = [\n  [1, 2, 3], # a remark\n  [4, 5, 6],\n]\n",
    "a = { b = 1, c = [1, 2], 'd e' = { f = true } }",
    "\"quoted key\" = 1\n'literal.key' = 2",
    '"\\u00e9" = "\\U0001F600 \\t \\" \\\\"',
    "a = 'C:\\no\\escape'",
    'a = """\none\n  two \\\n     joined"""',
    "a = '''\nraw \\n ' '' text'''",
    'a = """"quoted""""',
    "a = +1_000\nb = -0\nc = 0xDEAD_beef\nd = 0o755\ne = 0b1101",
    "a = 1e3\nb = -2.5E-7\nc = 6.626e-34\nd = 1_0.0_1\ne = -0.0",
    "a = inf\nb = -inf\nc = +inf\nd = nan",
    "a = 9007199254740993\nb = -9223372036854775808",
    "a = true\nb = false",
    "a = 1979-05-27T07:32:00Z\nb = 1979-05-27\nc = 07:32:00",
    "1 = 2\n-x_ = 3",
    "a = [1, 'two', [3.0], { four = 4 }]",
    "fruit.apple = 1\n[x]\nfruit.apple = 2",
    "a = 'é ∑ 😀'",
    "\ta\t=\t1\t",
]
BAD = [
    *(text for text, _ in NEWER["refused"]),
    "a",
    "a =",
    "= 1",
    "a = 1 b = 2",
    "a = 1\na = 2",
    "a = 1\na.b = 2",
    "[a]\n[a]",
    "[a]\nb = 1\n[a.b]",
    "a = [1]\n[[a]]",
    "[[a]]\n[a]",
    "a = { b = 1 }\na.c = 2",
    "a = { b = 1 }\n[a.c]",
    "a = 01",
    "a = 1__0",
    "a = _1",
    "a = 1_",
    "a = .5",
    "a = 5.",
    "a = 1e",
    "a = 0x",
    "a = -0x1",
    "a = 0b2",
    "a = True",
    "a = yes",
    "a = Infinity",
    "a = 'open",
    'a = "one\ntwo"',
    'a = "\\ud800"',
    'a = "\x01"',
    "# \x00",
    "a = 'x' 'y'",
    "a = [1, 2",
    "a = [1 2]",
    "a = [,]",
    "a = {",
    "a = { b = 1 c = 2 }",
    "a = { b = 1, b = 2 }",
    "[a",
    "[]",
    "[[a]",
    "[a]]",
    "a b = 1",
    "a. = 1",
    "é = 1",
    "a = 1979-13-01",
    "a = 25:00:00",
    "a = 1\rb = 2",
]
READ = """
import { readFileSync } from "node:fs";
const { fromToml } = await import(process.argv[1]);
const shown = (x) => typeof x === "number" ? (Number.isFinite(x) ? { number: x } : { number: String(x) })
  : x instanceof Date ? { date: String(x.toISOString()) } : Array.isArray(x) ? x.map(shown)
  : typeof x === "object" ? Object.fromEntries(Object.entries(x).map(([k, v]) => [k, shown(v)])) : x;
const out = JSON.parse(readFileSync(0, "utf8")).map((text) => {
  try { return { value: shown(fromToml(text)) }; } catch (error) { return { error: error.message }; }
});
console.log(JSON.stringify(out));
"""


def in_python(text):
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return None


@pytest.fixture(scope="module")
def in_page():
    return dict(zip(GOOD + BAD, asked(READ, GOOD + BAD), strict=True))


def same(page, python):
    """Whether a value of the page is the one of Python; dates are only told to be dates."""
    if isinstance(python, bool | str):
        return page == python
    if isinstance(python, int | float):
        found = float(page["number"].replace("Infinity", "inf") if isinstance(page["number"], str) else page["number"])
        return found == float(python) or (math.isnan(found) and math.isnan(python))
    if isinstance(python, list):
        return len(page) == len(python) and all(map(same, page, python))
    if isinstance(python, dict):
        return page.keys() == python.keys() and all(same(page[key], python[key]) for key in python)
    return set(page) == {"date"}


@pytest.mark.parametrize("text", GOOD)
def test_what_python_reads_the_page_reads(in_page, text):
    assert in_python(text) is not None
    assert "error" not in in_page[text]
    assert same(in_page[text]["value"], in_python(text))


@pytest.mark.parametrize("text", BAD)
def test_what_python_refuses_the_page_refuses_in_one_line(in_page, text):
    assert in_python(text) is None
    told = in_page[text].get("error", "")
    assert told.startswith("not valid TOML: ")
    assert "\n" not in told
    assert "(at line " in told
