"""CAD files that broke the reader: coloured faces, full turns, files that never end, faces that bring it down."""

import shutil
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.exchange.cad import isolated
from quintrig.exchange.cad.faces import to_model
from quintrig.support.errors import QuintrigError

pytest.importorskip("OCP", reason="the extra 'cad' is not installed")

from quintrig.exchange.cad.occ import module, quiet

DATA = Path(__file__).parent / "data"


def axes(turn, shift):
    """A right-handed frame in OpenCASCADE: turned by random angles, moved by ``shift``."""
    rng = np.random.default_rng(turn)
    frame, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    gp = module("gp")
    return gp.gp_Ax2(gp.gp_Pnt(*shift), gp.gp_Dir(*frame[:, 0]), gp.gp_Dir(*frame[:, 1]))


def upright():
    gp = module("gp")
    return gp.gp_Ax2(gp.gp_Pnt(0, 0, 0), gp.gp_Dir(0, 0, 1))


def written(shape, path, coloured=False):
    """Write a shape as STEP, its first face in red where ``coloured``."""
    with quiet():
        text = module("TCollection").TCollection_ExtendedString
        document = module("TDocStd").TDocStd_Document(text("BinXCAF"))
        module("XCAFApp").XCAFApp_Application.GetApplication_s().NewDocument(text("BinXCAF"), document)
        tools = module("XCAFDoc").XCAFDoc_DocumentTool
        shapes, colours = tools.ShapeTool_s(document.Main()), tools.ColorTool_s(document.Main())
        label = shapes.AddShape(shape, False)
        if coloured:
            explorer = module("TopExp").TopExp_Explorer(shape, module("TopAbs").TopAbs_ShapeEnum.TopAbs_FACE)
            quantity = module("Quantity")
            red = quantity.Quantity_Color(1.0, 0.0, 0.0, quantity.Quantity_TypeOfColor.Quantity_TOC_RGB)
            part = shapes.AddSubShape(label, explorer.Current())
            colours.SetColor(part, red, module("XCAFDoc").XCAFDoc_ColorType.XCAFDoc_ColorSurf)
        writer = module("STEPCAFControl").STEPCAFControl_Writer()
        assert writer.Transfer(document, module("STEPControl").STEPControl_StepModelType.STEPControl_AsIs)
        writer.Write(str(path))
    return path


def make(kind, frame):
    return getattr(module("BRepPrimAPI"), f"BRepPrimAPI_Make{kind[0]}")(frame, *kind[1:]).Shape()


KINDS = {
    "cone": ("Cone", 30.0, 10.0, 40.0),
    "cone to its apex": ("Cone", 30.0, 0.0, 40.0),
    "torus": ("Torus", 30.0, 10.0),
    "cylinder": ("Cylinder", 10.0, 20.0),
    "sphere": ("Sphere", 10.0),
    "part of a cone": ("Cone", 30.0, 10.0, 40.0, 2.0),
    "part of a torus": ("Torus", 30.0, 10.0, 4.0),
    "part of a cylinder": ("Cylinder", 10.0, 20.0, 5.5),
}


@pytest.mark.parametrize("frame", ["upright", *range(6)])
@pytest.mark.parametrize("name", KINDS)
def test_surfaces_of_revolution_are_exact_turned_and_moved(name, frame, tmp_path):
    place = upright() if frame == "upright" else axes(frame, np.random.default_rng(frame).normal(size=3) * 100)
    contents = isolated.read_here(written(make(KINDS[name], place), tmp_path / "part.step"))
    assert [face.problem for face in contents.faces] == [""] * len(contents.faces)
    patches = to_model(contents, "part.step").patches
    round_one = max(patches, key=lambda patch: patch.surface.rows.size * patch.surface.rows.functions.size).surface
    u, v = quintrig.grid(9, 9)
    u, v = 0.1 + 0.8 * u, 0.1 + 0.8 * v
    sample = quintrig.analyse(round_one, u, v, ("gaussian", "mean"))
    if "cone" in name or "cylinder" in name:
        np.testing.assert_allclose(sample["gaussian"], 0.0, atol=1e-15)
    if "cylinder" in name:
        np.testing.assert_allclose(np.abs(sample["mean"]), 0.05, rtol=1e-12)
    if "sphere" in name:
        np.testing.assert_allclose(sample["gaussian"], 0.01, rtol=1e-11)
    if "torus" in name:  # 2H = k + 1/r with K = k/r, whatever the parameter
        np.testing.assert_allclose(np.abs(2 * sample["mean"]), np.abs(10 * sample["gaussian"] + 0.1), rtol=1e-10)


def test_a_coloured_face_without_a_name_is_read(tmp_path):
    path = written(make(KINDS["cylinder"], upright()), tmp_path / "red.step", coloured=True)
    contents = isolated.read(path)
    assert len(contents.faces) == 3
    assert not any(face.problem for face in contents.faces)


def test_a_face_that_brings_the_library_down_does_not_lose_the_others(tmp_path):
    path = written(make(KINDS["cylinder"], upright()), tmp_path / "part.step")
    contents = isolated.read_here(path, skip=[2])
    assert [bool(face.problem) for face in contents.faces] == [False, True, False]
    assert "breaks down" in contents.faces[1].problem
    begun = []
    isolated.read_here(path, begin=begun.append)
    assert begun == [1, 2, 3]


def test_a_crash_is_tried_again_without_the_face_and_then_without_names(tmp_path, monkeypatch):
    path = written(make(KINDS["cylinder"], upright()), tmp_path / "part.step")
    asked = []

    def tried(path, size, skip, plain, seconds, patience):
        asked.append((list(skip), plain))
        if not plain:
            return None, 0, "signal 11"  # before the first face
        if 3 not in skip:
            return None, 3, "signal 11"
        return isolated.read_here(path, skip, plain).to_dict(), 0, ""

    monkeypatch.setattr(isolated, "_tried", tried)
    contents = isolated.read(path)
    assert asked == [([], False), ([], True), ([3], True)]
    assert [bool(face.problem) for face in contents.faces] == [False, False, True]
    assert "names could not be read" in contents.notes[0]


def test_the_plain_reader_gives_the_same_faces(tmp_path):
    path = written(make(KINDS["torus"], axes(1, (1, 2, 3))), tmp_path / "part.step")
    named, plain = isolated.read_here(path), isolated.read_here(path, plain=True)
    assert plain.unit == named.unit == "mm"
    np.testing.assert_allclose(plain.faces[0].keys["points"], named.faces[0].keys["points"], atol=1e-12)


@pytest.mark.slow
def test_a_small_file_that_never_ends_is_given_up_soon(tmp_path):
    path = shutil.copy(DATA / "endless.brep", tmp_path)
    with pytest.raises(QuintrigError, match="too long for a file of 920 bytes") as told:
        isolated.read(Path(path), seconds=2.0)
    assert "fewer faces" not in str(told.value)


def test_the_allowance_grows_with_the_file():
    assert isolated.allowance(1000) <= 15
    assert isolated.allowance(1000) < isolated.allowance(5_000_000) < isolated.allowance(50_000_000) <= 300
