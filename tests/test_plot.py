"""``quintrig.plot`` and the style of pictures: what is asked for is drawn, and PDFs carry fonts that may be printed."""

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import typer
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text

import quintrig
from cli_runner import quintrig as command
from quintrig.cli.app import build
from quintrig.figure.camera import TOP
from quintrig.figure.palette import CLASS_COLOURS
from quintrig.figure.read_lines import staged
from quintrig.figure.scene import Scene

COMMANDS = typer.main.get_command(build()).commands
BOOT = Path(__file__).parents[1] / "examples" / "car_boot.toml"
PLANE = quintrig.Curve(np.array([[0.0, 0], [1, 2], [2, 3], [4, 3], [5, 1], [6, 0]]))
SPACE = quintrig.Curve(np.array([[0.0, 0, 0], [1, 2, 1], [2, 3, 0], [4, 3, 2], [5, 1, 1], [6, 0, 0]]))


@pytest.fixture(scope="module")
def boot():
    return quintrig.load(BOOT)


def words(figure):
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]


def bar(figure):
    """Return the axes of the colour bar, the one that is narrow."""
    return min(figure.axes, key=lambda axes: axes.get_position().width)


@pytest.mark.parametrize("kind", ["pdf", "eps"])
@pytest.mark.parametrize("style", ["standard", "journal"])
def test_fonts_are_truetype(boot, kind, style, tmp_path):
    file = tmp_path / f"k.{kind}"
    quintrig.plot(boot, "K", view="flat", style=style, save=file)
    data = file.read_bytes()
    assert b"/Type3" not in data
    assert b"/FontType 3" not in data
    assert (b"/FontFile2" if kind == "pdf" else b"/FontType 42") in data


def test_curves_carry_truetype_too(tmp_path):
    quintrig.plot([PLANE], "curvature", save=tmp_path / "c.pdf")
    assert b"/Type3" not in (tmp_path / "c.pdf").read_bytes()


def test_a_journal_has_no_title_no_note_and_a_serif_face(boot):
    usual, journal = (quintrig.plot(boot, "K", view="flat", style=style) for style in ("standard", "journal"))
    assert boot.name in words(usual)
    assert boot.name not in words(journal)
    assert any("Normal along" in text for text in words(usual))
    assert not any("ormal along" in text for text in words(journal))
    assert {text.get_fontfamily()[0] for text in journal.findobj(Text)} == {"STIXGeneral"}


def test_title_and_caption_can_be_chosen_one_by_one(boot):
    found = words(quintrig.plot(boot, "K", view="flat", style="journal", title=True))
    assert boot.name in found


def test_limits_are_the_ends_of_the_scale(boot):
    assert bar(quintrig.plot(boot, "K", view="flat", limits=(-1e-4, 3e-4))).get_ylim() == pytest.approx((-1e-4, 3e-4))


def test_percentiles_are_those_of_the_values(boot):
    t = (np.arange(240) + 0.5) / 240
    values = quintrig.analyse(boot.surface, t[:, None], t[None, :], "K")["K"]
    low, high = bar(quintrig.plot(boot, "K", view="flat", percentiles=(10, 90))).get_ylim()
    assert (low, high) == pytest.approx(tuple(np.percentile(values, (10, 90))), rel=1e-9)


def test_contours_lie_where_the_quantity_has_the_value(boot):
    level = 5e-4
    figure = quintrig.plot(boot, "H", view="flat", levels=[level])
    lines = [line for line in figure.axes[0].lines if line.get_linewidth() == pytest.approx(0.45)]
    assert lines
    for line in lines:
        u, v = line.get_data()
        found = quintrig.analyse(boot.surface, np.clip(u, 0, 1), np.clip(v, 0, 1), "H")["H"]
        np.testing.assert_allclose(found, level, atol=2e-6)


def test_a_width_is_that_of_the_figure(boot):
    for width, inches in (
        ("84 mm", 84 / 25.4),
        ("column", 84 / 25.4),
        ("page", 174 / 25.4),
        (5, 5.0),
        ("12cm", 12 / 2.54),
    ):
        assert quintrig.plot(boot, "K", view="flat", width=width).get_size_inches()[0] == pytest.approx(
            inches, rel=1e-6
        )


@pytest.mark.parametrize("options", [{}, {"view": "flat"}])
def test_in_a_column_the_key_stands_below_so_that_the_picture_has_the_width(boot, options):
    for width, below in (("column", True), ("page", False)):
        first, *_, last = quintrig.plot(boot, "hk_type", width=width, **options).axes
        picture, key = (axes.get_position(original=True) for axes in (first, last))
        assert (key.y1 < picture.y0 + 1e-6) == below
        assert (key.x0 > picture.x1 - 1e-6) != below


def test_names_of_keys_stay_apart_and_ticks_of_a_stretched_shape_index_on_its_bar(boot):
    style = quintrig.Style(width="page", percentiles=(2, 98))
    figure = quintrig.plot(boot, ["K", "kappa1", "S"], style=style)
    renderer = figure.canvas.get_renderer()
    bars = [axes for axes in figure.axes if axes.get_xlabel()]
    spans = sorted((box.x0, box.x1) for box in (axes.xaxis.label.get_window_extent(renderer) for axes in bars))
    assert len(spans) == 3
    assert all(first[1] < second[0] for first, second in pairwise(spans))
    low, high = bars[-1].get_xlim()
    assert (low, high) != (-1.0, 1.0)
    assert all(low <= tick <= high for tick in bars[-1].get_xticks())


def test_curves_take_symbols_and_name_what_is_near():
    curve = quintrig.Curve([[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]])
    assert "curvature" in quintrig.plot(curve, "κ").axes[0].get_ylabel()
    with pytest.raises(ValueError, match="did you mean 'curvature'"):
        quintrig.plot(curve, "curvatur")


def test_larger_letters_leave_the_width_and_grow_in_proportion(boot):
    small, large = (quintrig.plot(boot, "K", view="flat", width=5, size=size) for size in (7.5, 15.0))
    assert small.get_size_inches()[0] == pytest.approx(large.get_size_inches()[0])
    sizes = [max(text.get_fontsize() for text in figure.findobj(Text)) for figure in (small, large)]
    assert sizes[1] == pytest.approx(2.0 * sizes[0])


@pytest.mark.parametrize("view", ["flat", "iso"])
def test_on_given_axes_the_picture_alone_is_drawn(boot, view):
    figure = Figure()
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    assert quintrig.plot(boot, "K", view=view, axes=axes) is figure
    assert figure.axes == [axes]
    assert axes.images if view == "flat" else any(isinstance(one, PolyCollection) for one in axes.collections)


def test_what_can_be_drawn(boot):
    sample = quintrig.analyse(boot.surface, *quintrig.grid(20, 30))
    for subject, quantity in (
        (boot.patches[0], "S"),
        (boot.surface, ["surface", "K"]),
        (sample, "hk_type"),
        (sample, "κ1"),
    ):
        assert quintrig.plot(subject, quantity).axes
    for curve, what in ((PLANE, "comb"), (PLANE, "curvature"), (SPACE, "curve"), ([SPACE, SPACE], "curvature")):
        assert quintrig.plot(curve, what).axes


def test_a_sample_is_drawn_with_its_own_values(boot):
    sample = quintrig.analyse(boot.surface, *quintrig.grid(7, 5), ["gaussian", "curvedness"])
    picture = quintrig.plot(sample, "K").axes[0].images[0].get_array()
    assert picture.shape[:2] == (5, 7)


MISTAKES = {
    "upside down": ({"limits": (2, 1)}, "limits: expected two rising finite numbers"),
    "endless": ({"limits": (-np.inf, 1)}, "limits: expected two rising finite numbers"),
    "endless levels": ({"levels": [0, np.nan]}, "levels: expected rising finite values"),
    "no such colours": ({"colours": "nothing"}, "such as viridis"),
    "both": ({"limits": (0, 1), "percentiles": (1, 99)}, "expected one of them"),
    "percentiles": ({"percentiles": (50, 101)}, "percentiles: expected"),
    "font": ({"font": "No Such Face"}, "is not installed"),
    "colours": ({"colours": "virids"}, "did you mean 'viridis'"),
    "width": ({"width": "3 furlongs"}, "width: expected a length"),
    "too narrow for its letters": ({"width": "40 mm"}, "width: expected at least 51 mm for numbers of 7.5 points"),
    "too large letters": ({"width": "column", "size": 16}, "width: expected at least 109 mm"),
    "narrow": ({"width": 0.2}, "width: expected 1 to 20 inches"),
    "size": ({"size": 99}, "size: expected 4 to 24 points"),
    "levels": ({"levels": [1, 0]}, "levels: expected rising"),
    "style": ({"style": "fancy"}, "style: expected standard or journal"),
    "view": ({"view": "askew"}, "view: expected"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_are_told_in_one_line(boot, name):
    options, said = MISTAKES[name]
    with pytest.raises(ValueError, match=said) as error:
        quintrig.plot(boot, "K", **options)
    assert "\n" not in str(error.value)


def test_the_command_has_the_same_options(tmp_path):
    out = tmp_path / "k.pdf"
    told = command("plot", BOOT, "-q", "K,κ1", "--style", "journal", "--width", "page", "--range=-1e-4,1e-4", "-o", out)
    assert (told.code, out.exists()) == (0, True)
    assert b"/Type3" not in out.read_bytes()
    told = command("plot", BOOT, "-q", "K", "--range", "2,1", "-o", out)
    assert (told.code, told.err.count("\n")) == (2, 1)
    assert "--range: expected two rising finite numbers" in told.err


def test_comparisons_reports_and_reproductions_take_a_style_and_write_files(tmp_path):
    curve = tmp_path / "curve.json"
    quintrig.save(quintrig.Model.of_curves([PLANE]), curve)
    style = ("--style", "journal", "--width", "84mm", "--view", "top", "--net")
    for name, words in (
        ("compared/curvature.pdf", ("compare", curve, tmp_path / "compared", "--figures", "pdf,svg", *style)),
        ("beside/figures/curve.pdf", ("compare", curve, tmp_path / "beside" / "c.html", "--figures", ".PDF", *style)),
        ("told/figures/curve-1-comb.pdf", ("report", curve, tmp_path / "told", "--figures", "pdf", *style)),
        ("thesis/figures/figure-2.1.pdf", ("reproduce", tmp_path / "thesis", "--only", "2.1", *style)),
    ):
        told = command(*words)
        assert (told.code, (tmp_path / name).exists()) == (0, True), told.err
        data = (tmp_path / name).read_bytes()
        assert b"STIXGeneral" in data
        assert b"/Type3" not in data
        width = float(re.search(rb"/MediaBox \[ 0 0 ([0-9.]+)", data)[1])
        assert width == pytest.approx(84.0 / 25.4 * 72.0, abs=0.5)
    assert not list((tmp_path / "compared").glob("*.png"))
    assert list((tmp_path / "beside" / "tables").glob("*.tex"))
    assert list((tmp_path / "told" / "tables").glob("*.csv"))


@pytest.mark.parametrize("name", ["plot", "compare", "report", "reproduce"])
def test_every_command_that_draws_has_every_option_of_pictures(name):
    options = {one for parameter in COMMANDS[name].params for one in (*parameter.opts, *parameter.secondary_opts)}
    texts = ("--style", "--title", "--no-title", "--caption", "--no-caption", "--font", "--font-size")
    scales = ("--range", "--percentiles", "--colours", "--levels", "-q", "--quantities")
    assert {*texts, *scales, "--width", "--dpi", "--view", "--net", "--no-net", "--lines", "--at"} <= options


def test_a_style_says_from_where_and_what_is_drawn_beside(boot):
    style = quintrig.Style(view="top", net=True, lines=3, at=((0.25, 0.5), (0.5, 1.0)), width="84 mm")
    scene = staged(Scene(isolines=7), style, [boot.surface])
    assert (scene.view, scene.net, scene.isolines) == (TOP, True, 3)
    assert [(mark.u, mark.v, mark.label) for mark in scene.marks] == [(0.25, 0.5, "P1"), (0.5, 1.0, "P2")]
    assert staged(Scene(isolines=7), quintrig.Style(), [boot.surface]) == Scene(isolines=7)
    lined = staged(Scene(isolines=7), quintrig.Style(lines="parabolic"), [boot.surface])
    assert lined.isolines == 0
    assert len(lined.traces) == len(quintrig.lines(boot, "parabolic"))
    # What plot is told itself comes first.
    assert quintrig.plot(boot, style=style).get_size_inches()[0] == pytest.approx(84.0 / 25.4)
    assert quintrig.plot(boot, style=style, width=3).get_size_inches()[0] == pytest.approx(3.0)
    for wrong, said in (({"view": "flat"}, "view: expected"), ({"lines": 101}, "lines: "), ({"dpi": 20}, "dpi: ")):
        with pytest.raises(ValueError, match=said):
            quintrig.Style(**wrong)


def test_lines_scans_and_named_curves_are_drawn_by_themselves(boot):
    found = quintrig.lines(boot, "parabolic")
    assert "parabolic lines, K = 0" in words(quintrig.plot(found))
    assert quintrig.plot(found[0], view="top").axes
    with pytest.raises(ValueError, match="expected nothing else for lines"):
        quintrig.plot(found, "K")
    u, v = quintrig.grid(12, 12)
    scan = quintrig.Scan(boot.surface(u, v).reshape(-1, 3), unit="mm", name="hood")
    drawn = quintrig.plot(scan, ["K", "point_type"], colours="viridis", limits=(-1e-4, 1e-4))
    assert {"hood", "Gaussian curvature $K$", "Point type"} <= set(words(drawn))
    assert "hood" not in words(quintrig.plot(scan, style="journal"))
    curves = quintrig.Model.of_curves([PLANE])
    assert quintrig.plot(curves.curves[0], "comb").axes
    with pytest.raises(ValueError, match="'comb' is drawn of curves, and here are surfaces; draw a quantity"):
        quintrig.plot(boot, "comb")


def test_borders_of_classes_are_smooth(boot):
    """Between two classes there are mixed colours, not a staircase of cells."""
    picture = np.asarray(quintrig.plot(boot, "hk_type", view="flat").axes[0].images[0].get_array()).reshape(-1, 3)
    pure = np.array([to_rgb(colour) for colour in CLASS_COLOURS["hk_type"]])
    mixed = np.abs(picture[:, None] - pure[None]).max(axis=-1).min(axis=-1) > 1e-6
    assert 0.0 < mixed.mean() < 0.1


def test_a_model_of_curves_is_drawn_with_its_shape_parameters():
    keys = {"kind": "curve", "points": PLANE.points.tolist()}
    tables = [{**keys, "name": name, "shape": [alpha, 0.5]} for name, alpha in (("a", 0.0), ("b", -2.0))]
    found = words(quintrig.plot(quintrig.Model.from_dict({"name": "two", "patch": tables})))
    assert "a: α = 0, ζ = 0.5" in found
    assert "b: α = -2, ζ = 0.5" in found
    with pytest.raises(ValueError, match="expected, for curves, one of curve, comb, hull, curvature"):
        quintrig.plot(quintrig.Model.from_dict(keys), "mean")


def test_contours_of_a_small_face_are_traced_over_the_face():
    """Its loop spans a fiftieth of the domain: nodes over all of it would leave five of them on the face."""
    turn = np.linspace(0.0, 2.0 * np.pi, 65)[:-1]
    loop = 0.3 + 0.01 * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    points = [[[x, y, x * x + y * y] for y in (-1.0, 0.0, 1.0)] for x in (-1.0, 0.0, 1.0)]
    knots = [[0, 0, 0, 1, 1, 1]] * 2
    keys = {"kind": "nurbs", "points": points, "degrees": [2, 2], "knots": knots, "trim": [loop.tolist()]}
    surface = quintrig.Model.from_dict(keys).surface
    values = quintrig.analyse(surface, *loop.T, "K")["K"]
    level = 0.5 * (values.min() + values.max())
    figure = quintrig.plot(surface, "K", view="flat", levels=[level])
    lines = [line for line in figure.axes[0].lines if line.get_linewidth() == pytest.approx(0.45)]
    assert sum(len(line.get_xdata()) for line in lines) > 100


def test_a_picture_of_thousands_of_patches_is_drawn_with_few_facets_each_or_refused():
    unit = np.stack(np.meshgrid([0.0, 0.5, 1.0], [0.0, 0.5, 1.0], indexing="ij"), axis=-1)
    points = np.concatenate([unit, (unit**2).sum(axis=-1, keepdims=True)], axis=-1)
    patches = tuple(
        quintrig.tensor(points + np.array([2 * (k % 30), 2 * (k // 30), 0]), basis="bernstein") for k in range(900)
    )
    many = quintrig.Model(
        "many", "mm", tuple(quintrig.model.patch.Patch.of(one, f"p{k}") for k, one in enumerate(patches))
    )
    figure = quintrig.plot(many, "K")
    facets = sum(len(one.get_paths()) for one in figure.axes[0].collections)
    assert 900 * 16 <= facets < 1_000_000
    crowd = quintrig.Model("crowd", "mm", many.patches * 6)
    with pytest.raises(ValueError, match=r"5,400 surfaces are more than the 5,000 .*; choose one by its name"):
        quintrig.plot(crowd, "K")
