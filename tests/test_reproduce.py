"""The reproduction of the thesis's figures and tables."""

import csv
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import quintrig
from quintrig.quantities.classify import HK_TYPES
from quintrig.reproduce import chosen, inventory, inventory_text, write_reproduction
from quintrig.reproduce.figures import draw
from quintrig.reproduce.inventory import labelled_points, model, model_text
from quintrig.reproduce.tables import tables
from quintrig.support.errors import QuintrigError

EXAMPLES = Path(__file__).parent.parent / "examples"
FIGURES = [
    *(f"2.{i}" for i in range(1, 8)),
    *(f"3.{i}" for i in range(2, 6)),
    *(f"4.{i}" for i in range(1, 43)),
]
TABLES = [*(f"3.{i}" for i in range(1, 5)), *(f"4.{i}" for i in range(1, 9)), "A1"]
BY_KEY = {item.key: item for item in inventory()}
NAMES = sorted({name for item in inventory() for name in item.models})


def test_the_inventory_has_each_number_of_the_thesis_once():
    assert sorted(item.number for item in inventory() if item.kind == "figure") == sorted(FIGURES)
    assert sorted(item.number for item in inventory() if item.kind == "table") == sorted(TABLES)


def test_the_list_names_every_item():
    text = inventory_text()
    for item in inventory():
        assert re.search(rf"^{re.escape(item.name)} ", text, re.M)
        assert item.title in text


@pytest.mark.parametrize("item", [i for i in inventory() if i.kind == "figure"], ids=lambda item: item.key)
def test_every_figure_is_drawn(item):
    figures = draw(item)
    assert len(figures) in (1, len(item.parts))
    for figure in figures:
        assert any(axes.has_data() or axes.texts or axes.images or axes.collections for axes in figure.axes)


@pytest.mark.parametrize("item", [i for i in inventory() if i.kind == "table"], ids=lambda item: item.key)
def test_every_table_is_made(item):
    for rows in tables(item):
        assert rows.rows
        assert all(len(row) == len(rows.heads) for row in rows.rows)
        assert {suffix for suffix, _ in rows.files} <= {".csv", ".tex"}


def test_titles_that_state_shape_parameters_are_drawn_with_them():
    for item in inventory():
        stated = re.search(r"shape parameters \(([^)]*)\)", item.title)
        if stated:
            assert list(item.shapes[0]) == [float(x) for x in stated.group(1).split(",")]


def test_data_tables_agree_with_a_fresh_analysis():
    rows = tables(BY_KEY["table-4.2"])[3]
    read = list(csv.DictReader(rows.files[0][1].splitlines()))
    surface = model("tensor").patch().with_shape((1, 0, -2, -3)).surface
    u, v = np.array([labelled_points()[row["point"]] for row in read]).T
    sample = quintrig.analyse(surface, u, v)
    gaussian = next(head for head in read[0] if head.startswith("K"))
    np.testing.assert_array_equal([float(row[gaussian]) for row in read], sample["gaussian"])
    assert [row["HK type"] for row in read] == [HK_TYPES[code] for code in sample["hk_type"]]


def test_the_validation_meets_the_closed_forms():
    for row in tables(BY_KEY["table-4.1"])[0].rows:
        scale = max(abs(float(row[3])), 0.1)
        assert float(row[-1]) <= 1e-12 * scale, row


def test_developables_keep_their_edge_of_regression_outside():
    for shape in BY_KEY["table-4.7"].shapes:
        assert quintrig.regression(model("developable").with_shape(shape).surface).intervals == ()


@pytest.mark.parametrize("name", NAMES)
def test_models_are_those_of_the_examples(name):
    example = {"thesis_net": "tensor", "tensor": "wavy"}.get(name, name)
    assert model_text(name) == (EXAMPLES / f"{example}.toml").read_text()


def test_the_page_shows_items_with_captions_and_links_only_what_is_there(tmp_path):
    only = frozenset({"figure-2.3", "figure-4.17", "table-3.2", "table-4.1", "table-A1"})
    told = []
    page = write_reproduction(tmp_path / "out", only=only, progress=lambda *args: told.append(args))
    text = page.read_text()
    assert [done for _, done, _ in told] == [1, 2, 3, 4, 5]
    for key in only:
        assert f'id="{key}"' in text
        assert BY_KEY[key].name in text
    assert "not available to us" in text
    for target in re.findall(r'(?:src|href)="([^"#]+)"', text):
        assert (page.parent / target).exists(), target
    assert all("alt=" in tag for tag in re.findall(r"<img[^>]*>", text))
    names = sorted(file.stem for file in (page.parent / "thumbnails").iterdir())
    assert names
    for form, first in (("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")):
        files = sorted((page.parent / "figures").glob(f"*.{form}"))
        assert [file.stem for file in files] == names
        assert all(file.read_bytes().startswith(first) for file in files)
        assert all(f"figures/{name}.{form}" in text for name in names)
    for name in names:
        with Image.open(page.parent / "thumbnails" / f"{name}.png") as small:
            assert max(small.size[0] / 320, small.size[1] / 240) == pytest.approx(1.0, abs=0.01)
        assert (page.parent / "thumbnails" / f"{name}.png").stat().st_size < 60_000
    again = write_reproduction(tmp_path / "out", only=frozenset({"table-3.1"}))
    assert not (again.parent / "figures").exists()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out"]


def test_other_files_are_kept(tmp_path):
    (tmp_path / "thesis.txt").write_text("mine")
    with pytest.raises(QuintrigError, match="expected a new or empty folder"):
        write_reproduction(tmp_path)
    assert (tmp_path / "thesis.txt").read_text() == "mine"
    with pytest.raises(QuintrigError, match="cannot be written"):
        write_reproduction(tmp_path / "thesis.txt" / "below")


def test_only_takes_numbers_names_and_keys():
    assert chosen(["4.3"]) == {item.key for item in inventory() if item.number == "4.3"}
    assert chosen(["Figure 4.3"]) == chosen(["figure-4.3"]) == chosen(["Fig.4.3"]) == {"figure-4.3"}
    assert chosen(["table A1"]) == {"table-A1"}
    with pytest.raises(ValueError, match=r"only: expected the number of a figure or table.*found '9\.99'.*inventory"):
        chosen(["9.99"])
