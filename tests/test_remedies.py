"""The library speaks of arguments and functions, and the command line of its options and commands."""

import ast
import pickle
import re
from pathlib import Path

import pytest
import typer

import quintrig
from quintrig import Model, ModelError
from quintrig.cli.app import build
from quintrig.cli.remedies import OPTIONS, REMEDIES, worded
from quintrig.exchange.cad.faces import Contents, Face, SpaceCurve, to_model
from quintrig.exchange.export import export
from quintrig.support.errors import ArgumentError, Note, QuintrigError
from quintrig.support.files import refuse_loss
from quintrig.sweep.part import Task
from quintrig.sweep.query import Question
from quintrig.sweep.space import Axis, DesignSpace, parse_axis

SOURCE = Path(quintrig.__file__).parent
BELOW = [path for path in SOURCE.rglob("*.py") if path.parent.name != "cli"]
COMMANDS = typer.main.get_command(build()).commands
SPOKEN = re.compile(rf"(?<![\w-])--[a-z]|\bquintrig ({'|'.join(COMMANDS)})\b(?! ?\{{)")


def docstrings(tree):
    """Return the texts that stand alone: they are for who reads the code."""
    return {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}


@pytest.mark.parametrize("path", BELOW, ids=lambda path: path.relative_to(SOURCE).as_posix())
def test_no_text_below_the_command_line_names_an_option_or_a_command(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    left_out = docstrings(tree)
    texts = [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in left_out
    ]
    assert [text for text in texts if SPOKEN.search(text.replace("--force-reinstall", ""))] == []  # pip's own option


@pytest.mark.parametrize("path", sorted(SOURCE.rglob("*.j2")), ids=lambda path: path.name)
def test_no_page_does(path):
    words = re.sub(r"(?s)<style.*?</style>|<[^>]*>|\{#.*?#\}", " ", path.read_text(encoding="utf-8"))
    assert not SPOKEN.search(words)


def test_every_option_and_command_that_the_command_line_names_is_there():
    there = {option for command in COMMANDS.values() for parameter in command.params for option in parameter.opts}
    named = set(re.findall(r"--[a-z-]+", " ".join([*OPTIONS.values(), *REMEDIES.values()])))
    assert named <= there
    assert set(re.findall(r"quintrig (\w+)", " ".join(REMEDIES.values()))) <= set(COMMANDS)


def test_every_key_has_a_remedy():
    keys = set()
    for path in BELOW:
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            named = {one.arg: one.value for one in call.keywords} if isinstance(call, ast.Call) else {}
            if {"remedy", "key"} <= set(named):
                keys |= {one.value for one in ast.walk(named["key"]) if isinstance(one, ast.Constant)} - {""}
    assert {"replace", "patch", "address"} <= keys <= set(REMEDIES)


TWO = Model.from_dict({"patch": [{"name": "a", "kind": "sphere"}, {"name": "b", "kind": "sphere"}]})
CURVE = SpaceCurve(1, "c", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], [1.0, 1.0], 1, [0.0, 0.0, 1.0, 1.0])
SPACE = DesignSpace((Axis("radius", 1.0, 2.0, 3),))
TASK = Task({"kind": "sphere"}, None, SPACE, 4)


def called(function, *arguments, **named):
    with pytest.raises((ValueError, QuintrigError)) as error:
        function(*arguments, **named)
    return error.value


@pytest.mark.parametrize(
    ("error", "library", "command"),
    [
        (
            lambda _: called(TWO.patch),
            "has 2 patches (a, b): choose one by its name (model.patch(name))",
            "has 2 patches (a, b): choose one by its name (--patch NAME)",
        ),
        (lambda _: called(parse_axis, "alpha1"), "axis 'alpha1': expected name=", "--vary 'alpha1': expected name="),
        (lambda _: called(Axis, "a", 1.0, 0.0, 2), "axis a=1:0:2: the range", "--vary a=1:0:2: the range"),
        (lambda _: called(Axis, "a", float("nan"), 0.0, 2), "axis a=nan:0:2: expected", "--vary a=nan:0:2: expected"),
        (lambda _: called(DesignSpace, ()), "axes: expected at least one parameter; give an Axis", "--vary: expected"),
        (
            lambda _: called(DesignSpace, SPACE.axes, "grid", 5),
            "samples: a grid has as many designs as its axes say; take the sampling 'sobol' or 'latin'",
            "--samples: a grid has as many designs as its axes say; add --sampling sobol or latin",
        ),
        (
            lambda _: called(Task, {"kind": "sphere"}, None, SPACE, 2),
            "points: expected 4 to 128 a side, got 2",
            "--points: expected 4 to 128 a side, got 2",
        ),
        (
            lambda _: called(Question(descending=True).check, TASK),
            "descending: says the order of a column; give it as best",
            "--greatest: says the order of a column; add --best COLUMN",
        ),
        (lambda _: called(Question("nothing < 1").check, TASK), "where 'nothing < 1': ", "--where 'nothing < 1': "),
        (lambda _: called(Question(best="x").check, TASK), "best x: unknown column", "--best x: unknown column"),
        (
            lambda _: called(to_model, Contents("n", "mm", (), (CURVE,)), "a.step"),
            "found none, only 1 curves; export the faces as NURBS",
            "or copy a curve with --curve N",
        ),
        (
            lambda _: called(to_model, Contents("n", "mm", (Face(1, "f", "mesh", {}, "none"),)), "a.step", [2]),
            "a.step: expected a face from 1 to 1, found 2; contents(path).faces lists them",
            "a.step: expected a face from 1 to 1, found 2; quintrig import a.step --list shows them",
        ),
        (
            lambda folder: called(export, TWO, folder / "a.dxf"),
            "export_pattern writes flat patterns",
            "quintrig flatten writes flat patterns, quintrig joins writes seams",
        ),
        (
            lambda folder: called(refuse_loss, quintrig.save(TWO, folder / "a.toml"), force=False),
            "is a model; choose another name, or force=True to replace it",
            "is a model; choose another name, or --force to replace it",
        ),
    ],
)
def test_an_error_is_told_in_the_terms_of_its_reader(error, library, command, tmp_path):
    found = error(tmp_path)
    assert library in str(found)
    assert not SPOKEN.search(str(found))
    assert command in worded(found)
    assert "\n" not in worded(found)
    assert worded(pickle.loads(pickle.dumps(found))) == worded(found)


def test_what_has_no_such_remedy_stays_as_it_is():
    assert worded(ValueError("a: b")) == "a: b"
    assert worded(ModelError("a: b")) == str(ModelError("a: b")) == "a: b"
    assert worded(ArgumentError("b", "unit", "x")) == "unit x: b"
    note = Note("it overlaps", remedy="split it", key="sheet")
    assert (note, worded(note)) == ("it overlaps; split it", "it overlaps; split it with --sheet WxH")
