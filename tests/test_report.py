"""The report page: complete, self-contained, safe with any name, and written whole or not at all."""

import base64
import hashlib
import io
import json
import math
import re
import tomllib
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image as Picture

import quintrig
from quintrig.analysis import summary
from quintrig.analysis.extremes import find_extremes
from quintrig.analysis.integrate import INTEGRALS, integrals
from quintrig.model.kinds.registry import OWN as KINDS
from quintrig.model.model import Model, load
from quintrig.model.starter import starter
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import QUANTITIES
from quintrig.report import kinds, pictures, write, write_report
from quintrig.report.deviation import Beside
from quintrig.report.facts import Facts, standard
from quintrig.report.findings import findings
from quintrig.report.mathml import mathml
from quintrig.report.pictures import Image
from quintrig.report.wording import aligned, digits_of, percent, prose, span
from quintrig.support.errors import QuintrigError

EXAMPLES = Path(__file__).parent.parent / "examples"
CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
HOSTILE = "</title><script>alert(1)</script><img src=x onerror=\"alert('&{{ 7 * 7 }}')\">{% raw %} $\\frac$"
BLANK = Image("data:image/png;base64,", "a picture", 10, 10)
VOID = ("meta", "img", "br", "link", "input", "hr")


class Page(HTMLParser):
    """A page taken apart: tags with their attributes, and text by the id of the section around it."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.words, self.styles = [], {}, ""
        self.open, self.section = [], ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        self.tags.append((tag, found))
        if tag not in VOID:
            self.open.append(tag)
        if tag == "section":
            self.section = found["id"]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        if tag in ("td", "th"):
            self.handle_data(" ")

    def handle_data(self, data):
        if self.open and self.open[-1] == "style":
            self.styles += data
        elif not self.open or self.open[-1] != "script":
            self.words[self.section] = self.words.get(self.section, "") + data

    @property
    def text(self):
        return squeezed(" ".join(self.words.values()))

    def attributes(self, *names):
        return [value for _, found in self.tags for name, value in found.items() if name in names]


def squeezed(text):
    """Return text with every kind of space as one plain space."""
    return " ".join(text.split())


@pytest.fixture
def undrawn(monkeypatch):
    """Leave out the pictures, and the last digits of integrals that do not converge: both take most of the time."""
    monkeypatch.setattr(write, "drawn", lambda draw, name, formats, style: BLANK)
    monkeypatch.setattr(summary, "integrals", lambda surface, tolerance: integrals(surface, 1e-6, 16))


@pytest.fixture(scope="module")
def pages():
    """Pages that several tests read, by model and grid."""
    return {}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Return one page with everything on it, pictures drawn, of a model with a hostile name."""
    keys = tomllib.loads((EXAMPLES / "car_boot.toml").read_text())
    model = Model.from_dict({**keys, "name": HOSTILE})
    told = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pictures, "_DPI", 60)
        page = write_report(
            model, tmp_path_factory.mktemp("report") / "out", grid=17, progress=lambda *args: told.append(args)
        )
    return page, Page(page.read_text(encoding="utf-8")), told


def page_of(keys, folder, grid=17):
    model = keys if isinstance(keys, Model) else Model.from_dict(keys)
    return Page(write_report(model, folder / "page.html", grid=grid).read_text(encoding="utf-8"))


def kept(pages, keys, folder, grid=17):
    """Return the page of a model, made once, without its effect of shape parameters."""
    key = repr((keys, grid))
    if key not in pages:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(write, "DETAILED", 0)
            pages[key] = page_of(keys, folder, grid)
    return pages[key]


def test_the_page_asks_for_nothing_from_outside(whole):
    path, page, _ = whole
    assert path.name == "index.html"
    assert [file.name for file in path.parent.iterdir()] == ["index.html"]
    assert all(link.startswith("#") for link in page.attributes("href"))
    assert all(source.startswith("data:") for source in page.attributes("src", "srcset", "data", "poster"))
    assert not page.attributes("action", "formaction", "background", "ping")
    assert "@import" not in page.styles
    assert all(target.startswith("data:") for target in re.findall(r"url\(['\"]?([^)]*)", page.styles))
    policy = next(a["content"] for t, a in page.tags if a.get("http-equiv") == "Content-Security-Policy")
    assert "default-src 'none'" in policy
    assert "http" not in policy


def test_the_policy_allows_the_scripts_of_the_page_and_no_others(whole):
    path, page, _ = whole
    policy = next(a["content"] for t, a in page.tags if a.get("http-equiv") == "Content-Security-Policy")
    allowed = re.search(r"script-src ([^;]*)", policy)[1].split()
    scripts = re.findall(r"<script([^>]*)>(.*?)</script>", path.read_text(encoding="utf-8"), re.DOTALL)
    code = [text for kind, text in scripts if "application/json" not in kind]
    assert len(code) == 1
    assert not any("src=" in kind for kind, _ in scripts)
    digest = base64.b64encode(hashlib.sha256(code[0].encode()).digest()).decode()
    assert f"'sha256-{digest}'" in allowed
    assert len([word for word in allowed if word.startswith("'sha256-")]) == 1
    assert not {"'unsafe-inline'", "'unsafe-eval'", "*"} & set(allowed)
    assert not [name for _, found in page.tags for name in found if name.startswith("on")]


def test_links_lead_somewhere_and_ids_are_unique(whole):
    _, page, _ = whole
    ids = page.attributes("id")
    assert len(set(ids)) == len(ids)
    assert {link[1:] for link in page.attributes("href")} <= set(ids)


def test_every_picture_is_drawn_and_described(whole):
    _, page, _ = whole
    images = [found for tag, found in page.tags if tag == "img"]
    assert len(images) >= 20
    for found in images:
        assert len(found["alt"]) > 15
        data = base64.b64decode(found["src"].removeprefix("data:image/png;base64,"))
        picture = Picture.open(io.BytesIO(data))
        assert picture.width / picture.height == pytest.approx(int(found["width"]) / int(found["height"]), rel=0.01)
        assert len(np.unique(np.asarray(picture.convert("L")))) > 10


def test_progress_counts_every_step_to_the_last(whole):
    _, _, told = whole
    assert [done for _, done, _ in told] == list(range(told[0][2]))
    assert len({total for _, _, total in told}) == 1


def test_a_hostile_name_is_shown_and_changes_nothing_else(whole, undrawn, tmp_path):
    _, page, _ = whole
    tame = page_of(load(EXAMPLES / "car_boot.toml"), tmp_path)
    assert [tag for tag, _ in page.tags] == [tag for tag, _ in tame.tags]
    assert [sorted(found) for _, found in page.tags] == [sorted(found) for _, found in tame.tags]
    assert HOSTILE in page.words[""]


def test_every_quantity_has_name_meaning_unit_and_source(whole):
    _, page, _ = whole
    told = squeezed(page.words["read"])
    for q in QUANTITIES:
        if q.key not in ("point", "normal"):
            assert q.name in told
            assert q.source in told
    points = squeezed(page.words["patch-1-points"])
    for symbol in (
        "K",
        "H",
        "κ1",
        "κ2",
        "S",
        "C",
        *(f"β{i}" for i in range(3)),
        *(f"γ{i}" for i in range(1, 4)),
        *"EFGLMN",
    ):
        assert re.search(rf"(?<!\w){symbol}\w*\b", points), symbol
    assert points.count("1/mm²") >= 3
    assert points.count("1/mm ") >= 8


def test_sections_tell_what_they_promise(whole):
    _, page, _ = whole
    words = {key: squeezed(text) for key, text in page.words.items()}
    assert "The normal points along Su × Sv" in words["patch-1-what"]
    assert "α1 = 1, ζ1 = 1, α2 = 0, ζ2 = 0" in words["patch-1-what"]
    for q in INTEGRALS:
        assert q.name in words["patch-1-numbers"]
    for shape in ("(1, 1, 1, 1)", "(1, 1, −3, −3)", "(1, −3, 1, −3)", "(1, 0, −2, −3)"):
        assert shape in words["patch-1-effect"]
    assert "HK type against shape class" in words["patch-1-methods"]
    assert "flat where the curvedness C ≤" in words["made"]


def test_the_model_file_on_the_page_makes_the_same_model(whole):
    _, page, _ = whole
    source = page.words["made"].partition("to make this again")[2]
    again = Model.from_dict(tomllib.loads(source))
    first = load(EXAMPLES / "car_boot.toml")
    assert again.name == HOSTILE
    t = np.linspace(0.0, 1.0, 5)
    np.testing.assert_array_equal(again.surface(t[:, None], t), first.surface(t[:, None], t))


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        ({"kind": "sphere", "radius": 20, "unit": "mm"}, "dome- or bowl-shaped everywhere"),
        ({"kind": "sphere", "radius": 20, "unit": "mm"}, "away from the normal, with a tightest radius of 20 mm"),
        ({"kind": "sphere", "radius": 20, "unit": "mm"}, "5027 mm²; the Gaussian curvature is 0.0025 1/mm² everywhere"),
        ({"kind": "cylinder", "radius": 2, "flip": True}, "bent in one direction only everywhere: K = 0"),
        ({"kind": "cylinder", "radius": 2, "flip": True}, "towards the normal, with a tightest radius of 2."),
        ({"kind": "hyperbolic_paraboloid"}, "The surface is saddle-shaped everywhere"),
        ({"kind": "hyperbolic_paraboloid"}, "Gaussian curvature runs from −1 to −0.111"),
        ({"kind": "helicoid"}, "it bends equally both ways"),
        ({"kind": "torus", "major": 3, "minor": 1}, "The tightest bend has a radius of 1"),
    ],
)
def test_findings_are_those_of_known_surfaces(keys, told, undrawn, pages, tmp_path):
    assert told in squeezed(kept(pages, keys, tmp_path, grid=65).words["patch-1-short"])


def test_a_cylinder_is_compared_where_the_methods_are_defined(undrawn, pages, tmp_path):
    page = kept(pages, {"kind": "cylinder", "radius": 2, "flip": True}, tmp_path, grid=65)
    for section in ("patch-1-short", "patch-1-methods"):
        words = squeezed(page.words[section])
        assert "Everywhere the tangent plane is vertical, where the invariants of a height field are infinite" in words
        assert "only HK types and shape classes can be compared, and they say the same on 100 %" in words
        assert "the same on 0 %" not in words


def test_a_developable_that_folds_back_is_not_said_to_unroll(undrawn, pages, tmp_path):
    folded = next(c["model"] for c in CASES if c["model"]["kind"] == "developable")
    told = squeezed(kept(pages, folded, tmp_path).words["patch-1-short"])
    assert "folds back at its edge of regression and does not unroll whole" in told
    assert "without stretching" not in told
    regular = tomllib.loads(starter("developable"))
    assert "so it unrolls into a plane" in squeezed(kept(pages, regular, tmp_path).words["patch-1-short"])


@pytest.mark.parametrize(("keys", "metric"), [("car_boot", "surface"), ("wavy", "plane")])
def test_invariants_of_a_steep_surface_are_drawn_in_its_own_metric(keys, metric, undrawn, tmp_path):
    page = page_of(load(EXAMPLES / f"{keys}.toml"), tmp_path, grid=9)
    words = squeezed(page.words["patch-1-invariants"])
    assert f"maps are in the metric of the {metric if metric == 'surface' else 'horizontal plane'}" in words


def test_extremes_say_where_they_are_in_space_and_have_one_power_of_ten_each(whole):
    _, page, _ = whole
    model = load(EXAMPLES / "car_boot.toml")
    found = find_extremes(model.surface, ("gaussian",), 17)["gaussian"]
    words = squeezed(page.words["patch-1-numbers"]).replace("−", "-")
    for end in (found.minimum, found.maximum):
        assert f"({', '.join(f'{x:.1f}'.removesuffix('.0') for x in end.point)})" in words.replace(".0,", ",")
        assert f"{1e6 * end.value:.5g}" in words
    assert "10-6 1/mm²" in words


@pytest.mark.parametrize(
    ("keys", "warning"),
    [
        ({"kind": "cone"}, "is a single point"),
        ({"kind": "cone"}, "curvature grows without bound"),
        (next(c["model"] for c in CASES if c["model"]["kind"] == "developable"), "edge of regression lies inside"),
        (
            {**tomllib.loads(starter("swept")), "shape": [3, 1, 1, 1], "unchecked_shape": True},
            "convex-hull property is lost",
        ),
        ({**tomllib.loads(starter("swept")), "shape": [-4, 1, 1, 1]}, "(α1 = -4)"),
        ({"kind": "tensor", "points": [[[1, 2, 3]] * 6] * 6}, "single point"),
        ({"kind": "tensor", "points": [[[1, 2, 3]] * 6] * 6}, "no tangent plane anywhere"),
        (
            {"kind": "ruled", "first": [[i, 0, 0] for i in range(6)], "second": [[i, 0, 0] for i in range(6)]},
            "no tangent plane",
        ),
    ],
)
def test_degenerate_models_are_told_with_a_warning(keys, warning, undrawn, pages, tmp_path):
    words = squeezed(kept(pages, keys, tmp_path).words["patch-1-short"]).replace("−", "-")
    assert warning in words


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_has_a_page(kind, undrawn, tmp_path):
    page = page_of(tomllib.loads(starter(kind)), tmp_path, grid=9)
    assert KINDS[kind].title in page.text
    assert "math" in {tag for tag, _ in page.tags}
    assert not re.search(r"\b(nan|inf|None|Undefined)\b", page.text)


def test_several_patches_are_told_one_by_one_and_many_in_brief(undrawn, tmp_path):
    keys = tomllib.loads(starter("ruled"))
    patch = {key: keys[key] for key in ("kind", "first", "second")}
    few = page_of({"patch": [{**patch, "name": name} for name in ("left", "right")]}, tmp_path, grid=9)
    many = page_of({"patch": [{**patch, "name": f"<b>{i}"} for i in range(write.DETAILED + 1)]}, tmp_path, grid=9)
    assert {"patch-1-effect", "patch-2-effect", "all"} <= set(few.words)
    assert "patch-1-effect" not in many.words
    assert "told in brief" in squeezed(many.words["all"])
    assert "<b>4" in squeezed(many.words["all"])
    assert "left:v1" in squeezed(few.words["all"])  # the table of seams


def test_a_target_is_told_of_beside_the_model(undrawn, tmp_path):
    plane = [[[20 * i, 20 * j, 0] for j in range(6)] for i in range(6)]
    keys = {"name": "x", "unit": "mm", "kind": "tensor", "shape": [0, 0, 0, 0], "points": plane}
    model = Model.from_dict(keys)
    found = quintrig.deviation(model, [[50, 50, 3], [20, 20, -4], [103, 50, 4]], tolerance=3.5)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(write, "DETAILED", 0)
        page = Page(
            write_report(model, tmp_path / "p.html", grid=5, beside=Beside("<i>scan</i>.ply", found)).read_text()
        )
    for told in ("Deviation from <i>scan</i>.ply", "33 % of them are within ±3.5 mm", "1 lie beyond the border", "−4"):
        assert told in squeezed(page.text)


def test_a_page_that_cannot_be_written_says_so_and_leaves_nothing(undrawn, tmp_path):
    model = load(EXAMPLES / "sphere.toml")
    (tmp_path / "file").write_text("mine")
    with pytest.raises(QuintrigError, match="cannot be written"):
        write_report(model, tmp_path / "file" / "below")
    with pytest.raises(QuintrigError, match="cannot be written"):
        write_report(model, tmp_path / "file")
    (tmp_path / "folder.html").mkdir()
    with pytest.raises(QuintrigError, match="found a folder"):
        write_report(model, tmp_path / "folder.html")
    assert (tmp_path / "file").read_text() == "mine"
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["file", "folder.html"]


def test_a_run_that_fails_keeps_the_page_that_was_there(monkeypatch, tmp_path):
    def fail(draw, name, formats, style):
        raise MemoryError

    (tmp_path / "index.html").write_text("before")
    monkeypatch.setattr(write, "drawn", fail)
    with pytest.raises(MemoryError):
        write_report(load(EXAMPLES / "sphere.toml"), tmp_path, grid=5)
    assert [path.name for path in tmp_path.iterdir()] == ["index.html"]
    assert (tmp_path / "index.html").read_text() == "before"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (1381743.6, "1 382 000"),
        (-0.00123456, "−0.001235"),
        (12.0, "12"),
        (9999.6, "10 000"),
        (1.5e-9, "1.5 × 10<sup>−9</sup>"),
        (-2.4896904e7, "−2.49 × 10<sup>7</sup>"),
        (math.nan, "–"),
        (-math.inf, "−∞"),
    ],
)
def test_numbers_are_rounded_and_set(value, text):
    assert squeezed(str(digits_of(value))) == text


@pytest.mark.parametrize(
    ("share", "text"),
    [
        (0.0, "0 %"),
        (1.0, "100 %"),
        (0.716, "72 %"),
        (0.9992, "99.9 %"),
        (0.9999, "more than 99.9 %"),
        (1e-5, "less than 0.1 %"),
    ],
)
def test_shares_are_never_rounded_to_none_or_all(share, text):
    assert squeezed(percent(share)) == text


def test_columns_have_one_power_of_ten_and_aligned_points():
    power, cells = aligned([-7.1393e-6, 158.54e-6, 0.0, math.nan])
    assert power == -6
    assert [cell.strip("\u2007\u2008") for cell in cells] == ["−7.1393", "158.54", "0", "–"]
    after = [len(cell) - cell.index(next(c for c in cell + "." if c in ".\u2008")) for cell in cells]
    assert len(set(after)) == 1
    assert squeezed(str(span(-1.36e-5, 1.73e-4, "1/mm²"))) == (
        "from −13.6 × 10<sup>−6</sup> to 173 × 10<sup>−6</sup> 1/mm²"
    )
    assert squeezed(str(span(0.0, 1.73e-4, "1/mm²"))) == "from 0 to 173 × 10<sup>−6</sup> 1/mm²"


@pytest.mark.parametrize(
    ("text", "html"),
    [
        ("κ1 <= κ2", "<i>κ</i><sub>1</sub> ≤ <i>κ</i><sub>2</sub>"),
        ("S_u x S_uv", "<i>S</i><sub><i>u</i></sub> <i>x</i> <i>S</i><sub><i>uv</i></sub>"),
        ("β0ˢ", "<i>β</i><sub>0</sub><sup>S</sup>"),
        ("6.06e-10 1/mm", "6.06 × 10<sup>−10</sup> 1/mm"),
        ("1e-06", "10<sup>−6</sup>"),
        ("K = -2 & <b>", "<i>K</i> = −2 &amp; &lt;b&gt;"),
        ("a dome- or bowl-shaped car", "a dome- or bowl-shaped car"),
        ("<i>K's</i>", "&lt;i&gt;K&#39;s&lt;/i&gt;"),
    ],
)
def test_prose_sets_our_notation_and_escapes_the_rest(text, html):
    assert squeezed(str(prose(text))) == html


@pytest.mark.parametrize(
    "latex",
    [*(q.latex for q in (*QUANTITIES, *INTEGRALS)), *(kind.formula for kind in KINDS.values()), *kinds.BASIS],
)
def test_formulas_are_well_formed(latex):
    root = ElementTree.fromstring(str(mathml(latex)))
    assert "".join(root.itertext()).strip()


def test_a_formula_has_its_parts_in_place():
    assert str(mathml(r"\kappa_1^2")) == (
        "<math><mrow><msubsup><mi>κ</mi><mn>1</mn><mrow><mn>2</mn></mrow></msubsup></mrow></math>"
    )
    with pytest.raises(ValueError, match="expected a known command"):
        mathml(r"\unknown")


def test_figures_are_files_of_the_formats_asked_for_and_points_are_tables(tmp_path, monkeypatch):
    files = {form: form.encode() for form in ("png", "pdf")}
    monkeypatch.setattr(
        write,
        "drawn",
        lambda draw, name, formats, style: replace(BLANK, files={f: files[f] for f in formats}, name=name),
    )
    monkeypatch.setattr(summary, "integrals", lambda surface, tolerance: integrals(surface, 1e-6, 16))
    write.write_report(
        Model.from_dict(tomllib.loads((EXAMPLES / "ruled.toml").read_text())), tmp_path, figures=[".PDF"], grid=9
    )
    drawn = [path for path in tmp_path.rglob("*") if path.is_file() and path.parent.name == "figures"]
    assert drawn
    assert {path.suffix for path in drawn} == {".pdf"}
    assert {path.name for path in (tmp_path / "tables").iterdir()} >= {"points.csv", "points.tex"}
    with pytest.raises(ValueError, match="figures: expected some of png, svg, pdf, eps, found 'bmp'"):
        write.write_report(
            Model.from_dict(tomllib.loads((EXAMPLES / "ruled.toml").read_text())), tmp_path, figures=["bmp"]
        )


@pytest.mark.parametrize(("shape", "told"), [([1.0, 1.0, 0.0, 0.0], True), ([0.9, 1.0, 1.0, 1.0], False)])
def test_sets_of_the_thesis_are_told_of_only_where_they_bend_the_surface_less(shape, told, undrawn, tmp_path):
    boot = load(EXAMPLES / "car_boot.toml").with_shape(shape)
    facts = Facts(boot.patch(), "mm", Thresholds(), 9, True)
    own = facts.summary.integrals.bending_energy.value
    best = min(one.summary.integrals.bending_energy.value for one in standard(facts))
    assert (own > 1.001 * best) == told
    assert any("thesis" in line for line in findings(facts)) == told


def test_what_matters_less_is_folded_and_prints(whole):
    text = whole[0].read_text(encoding="utf-8")
    folded = "".join(re.findall(r'<details class="fold">.*?</details>', text, re.DOTALL))
    for name in ("Shape index", "Principal directions", "The six maps", "Quantities and their sources"):
        assert name in folded
    for name in ("In short", "Red: dome", "Extremes and means"):
        assert name not in folded
    assert "details::details-content { content-visibility: visible" in text
