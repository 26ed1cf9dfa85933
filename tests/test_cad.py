"""CAD files: every kind of surface through OpenCASCADE and Rhino's reader and back, and OpenCASCADE's own curvature."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import quintrig
import shapes
from quintrig.exchange.cad import isolated
from quintrig.exchange.cad.faces import to_model
from quintrig.exchange.cad.fit import FitOptions, fit
from quintrig.exchange.cad.forms import written_carriers
from quintrig.exchange.cad.readback import deviations
from quintrig.exchange.cad.save import CadOptions, export_cad
from quintrig.geometry.exact import exact_surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.errors import QuintrigError

if not os.environ.get("CI"):
    pytest.importorskip("OCP", reason="needs the extra cad: pip install 'quintrig[cad]'")
    pytest.importorskip("rhino3dm", reason="needs the extra cad: pip install 'quintrig[cad]'")

SURFACES = shapes.rational()
SUFFIXES = ("step", "igs", "brep", "3dm")


def model_of(surface, name="patch", unit="cm"):
    return Model(name, unit, (Patch(name, None, surface),))


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", SURFACES)
def test_round_trip_keeps_points_name_unit_and_normal(name, suffix, tmp_path):
    surface = SURFACES[name]
    model = model_of(surface, name)
    path = tmp_path / f"part.{suffix}"
    export_cad(model, path)
    contents = isolated.read_here(path)
    (face,) = contents.faces
    (found,) = deviations(written_carriers(model), contents, 100)
    assert found.relative <= 1e-12
    assert bool(face.keys.get("flip", False)) == surface.flip
    assert "trim" not in face.keys
    if suffix != "brep":
        assert face.name == name
        assert contents.unit == "cm"


def occ_curvature(geometry, x, y):
    """K and H as OpenCASCADE computes them, shape (n,), normal along S_u x S_v."""
    from OCP.GeomLProp import GeomLProp_SLProps

    properties = GeomLProp_SLProps(geometry, 2, 1e-9)
    values = []
    for a, b in zip(x, y, strict=True):
        properties.SetParameters(float(a), float(b))
        assert (
            properties.IsCurvatureDefined()
        )  # before any getter: version 8.0.1 returns 0.0 from the first one otherwise
        values.append((properties.GaussianCurvature(), properties.MeanCurvature()))
    return np.array(values).T


@pytest.mark.parametrize("name", SURFACES)
def test_opencascade_computes_the_same_curvature(name):
    from quintrig.exchange.cad.occ import to_occ

    surface = SURFACES[name]
    form = exact_surface(surface)
    t = np.linspace(0.04, 0.97, 12)
    u, v = (a.ravel() for a in np.meshgrid(t, t, indexing="ij"))
    sample = quintrig.analyse(surface, u, v, ("gaussian", "mean", "curvedness"))
    x, y = form.to_exact(u, v)
    gauss, mean = occ_curvature(to_occ(form), x, y)
    scale = sample["curvedness"] + 1e-3 / surface.size
    assert (np.abs(sample["gaussian"] - gauss) / scale**2).max() <= 1e-8
    assert (np.abs(surface.sign * sample["mean"] - mean) / scale).max() <= 1e-8


@pytest.fixture
def lid():
    """Two patches that meet along an edge, the second one's normal looking the other way, and one apart."""
    net = shapes.net()
    mirrored = net * [-1, 1, 1] + [20, 0, 0]
    patches = {"left": net, "right": mirrored, "far": net + np.array([0, 50, 0])}
    return Model("Lid é", "in", tuple(Patch(k, None, quintrig.tensor(p, shapes.SHAPE)) for k, p in patches.items()))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_several_patches_are_sewn_and_told(lid, suffix, tmp_path):
    path = tmp_path / f"lid.{suffix}"
    notes = "\n".join(export_cad(lid, path, CadOptions(sew=1e-4)))
    contents = isolated.read_here(path)
    assert len(contents.faces) == 3
    if suffix == "3dm":
        assert [face.name for face in contents.faces] == ["left", "right", "far"]
        return
    assert "sewn within 0.0001 in: 1 shared edges, 10 free edges" in notes
    assert "normals turned so that the shell has one outside: right" in notes
    if suffix != "brep":
        assert {face.name for face in contents.faces} == {"left", "right", "far"}
        assert contents.unit == "in"


def test_shared_edge_is_one_edge_of_a_shell(lid, tmp_path):
    from quintrig.exchange.cad.occ import explored, module, quiet

    path = tmp_path / "lid.brep"
    export_cad(lid, path)
    with quiet():
        shape = module("TopoDS").TopoDS_Shape()
        module("BRepTools").BRepTools.Read_s(shape, str(path), module("BRep").BRep_Builder())
        (shell,) = explored(shape, "SHELL")
        uses = explored(shell, "EDGE")
    assert len(explored(shell, "FACE")) == 2
    assert sum(a.IsSame(b) for i, a in enumerate(uses) for b in uses[:i]) == 1


@pytest.mark.parametrize(("schema", "text"), [("ap242", "AP242"), ("ap214", "AUTOMOTIVE_DESIGN")])
def test_step_header_names_protocol_unit_program_and_exactness(schema, text, lid, tmp_path):
    path = tmp_path / "lid.stp"
    export_cad(lid, path, CadOptions(schema=schema))
    written = path.read_text(encoding="utf-8")
    header = written[: written.index("DATA;")]
    assert text in header
    assert "quintrig" in header
    assert "exact rational B-spline of degree (10, 10)" in "".join(line.strip() for line in header.splitlines())
    assert "'INCH'" in written


@pytest.mark.parametrize("suffix", ["step", "3dm"])
def test_surfaces_without_a_rational_form_are_fitted_and_say_how_well(suffix, tmp_path):
    surface = quintrig.helicoid()
    path = tmp_path / f"h.{suffix}"
    notes = "\n".join(export_cad(model_of(surface, "screw", "mm"), path))
    assert "fit of degree 5, C4" in notes
    measured = float(notes.partition("largest deviation ")[2].split()[0])
    (face,) = isolated.read_here(path).faces
    again = to_model(isolated.read_here(path), "h").surface
    u, v = quintrig.grid(101, 203)
    gap = np.linalg.norm(again(u, v) - surface(u, v), axis=-1).max()
    assert gap <= 1e-6 * surface.size
    assert gap == pytest.approx(measured, rel=0.05)
    assert face.keys["degrees"] == [5, 5]
    if suffix == "step":
        assert "largest deviation" in path.read_text().partition("DATA;")[0]


@pytest.mark.parametrize(("degree", "continuity"), [(3, None), (3, 1), (5, 2)])
def test_fit_has_the_degree_continuity_and_deviation_it_promises(degree, continuity):
    surface = SURFACES["tensor"]
    result = fit(surface, FitOptions(degree, continuity, 1e-3))
    assert result.form.degrees == (degree, degree)
    inner = np.array(result.form.u.knots)[degree + 1 : -degree - 1]
    _, counts = np.unique(inner, return_counts=True)
    assert (counts == degree - (degree - 1 if continuity is None else continuity)).all()
    u, v = quintrig.grid(157, 133)
    gap = np.linalg.norm(result.form.surface()(u, v) - surface(u, v), axis=-1).max()
    assert gap <= result.deviation * 1.02 <= 1.02e-3
    np.testing.assert_allclose(result.form.surface()([0, 1], [1, 0]), surface([0, 1], [1, 0]), rtol=0, atol=1e-14)


def test_a_fit_that_cannot_be_reached_is_refused():
    with pytest.raises(ValueError, match=r"deviates by .* choose a larger tolerance"):
        fit(SURFACES["ruled"], FitOptions(1, None, 1e-9))


def test_nothing_reaches_stdout_and_nothing_is_lost_of_it(tmp_path):
    code = (
        "import sys; sys.path.insert(0, sys.argv[2])\n"
        "import shapes, quintrig\n"
        "from pathlib import Path\n"
        "from quintrig.exchange.cad.save import export_cad\n"
        "from quintrig.model.model import Model, Patch\n"
        "print('before')\n"
        "model = Model('m', 'mm', (Patch('p', None, quintrig.tensor(shapes.net())),))\n"
        "for suffix in ('step', 'igs', 'brep', '3dm'): export_cad(model, Path(sys.argv[1]) / f'a.{suffix}')\n"
        "print('after')\n"
    )
    here = str(Path(__file__).parent)
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path), here], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout == "before\nafter\n"


def trimmed_step(path, reverse=False):
    """A STEP file of one face: a 10 x 10 wave with a round hole, cut by OpenCASCADE in the surface's own parameters."""
    from quintrig.exchange.cad.occ import module, quiet, to_occ

    with quiet():
        geometry = to_occ(exact_surface(quintrig.tensor(shapes.net(), basis="bernstein")))
        circle = module("Geom2d").Geom2d_Circle(
            module("gp").gp_Ax2d(module("gp").gp_Pnt2d(0.5, 0.4), module("gp").gp_Dir2d(1, 0)), 0.2
        )
        builder = module("BRepBuilderAPI")
        edge = builder.BRepBuilderAPI_MakeEdge(circle, geometry).Edge()
        module("BRepLib").BRepLib.BuildCurves3d_s(edge)
        wire = builder.BRepBuilderAPI_MakeWire(edge).Wire()
        face = builder.BRepBuilderAPI_MakeFace(builder.BRepBuilderAPI_MakeFace(geometry, 1e-7).Face())
        face.Add(module("TopoDS").TopoDS.Wire(wire.Reversed()))
        module("STEPControl").STEPControl_Controller.Init_s()
        writer = module("STEPControl").STEPControl_Writer()
        mode = module("STEPControl").STEPControl_StepModelType.STEPControl_AsIs
        writer.Transfer(face.Face(), mode)
        writer.Write(str(path))


def test_settings_of_opencascade_are_left_as_they_were(tmp_path):
    from OCP.IGESControl import IGESControl_Controller
    from OCP.Interface import Interface_Static
    from OCP.STEPCAFControl import STEPCAFControl_Controller

    STEPCAFControl_Controller.Init_s()
    IGESControl_Controller.Init_s()
    names = ("write.step.unit", "write.step.schema", "write.iges.unit", "xstep.cascade.unit")
    before = {name: Interface_Static.CVal_s(name) for name in names}
    named = Interface_Static.IVal_s("read.stepcaf.subshapes.name")
    inches = quintrig.Model.from_dict({"unit": "in", "kind": "torus"})
    for suffix in (".step", ".iges"):
        quintrig.export(inches, tmp_path / f"ring{suffix}")
        assert isolated.read_here(tmp_path / f"ring{suffix}").unit == "in"
    assert Interface_Static.IVal_s("read.stepcaf.subshapes.name") == named
    assert {name: Interface_Static.CVal_s(name) for name in names} == before


def test_trimmed_face_keeps_its_surface_and_marks_what_is_cut_off(tmp_path):
    path = tmp_path / "hole.step"
    trimmed_step(path)
    model = to_model(isolated.read_here(path), "hole.step")
    surface = model.surface
    assert len(surface.trim) == 2
    u, v = quintrig.grid(41, 41)
    inside = surface.inside(u, v)
    radius = np.hypot(u - 0.5, v - 0.4)
    certain = (np.abs(radius - 0.2) > 0.005) & (u > 0) & (u < 1) & (v > 0) & (v < 1)
    np.testing.assert_array_equal(inside[certain], (radius > 0.2)[certain])
    gap = surface(u, v) - quintrig.tensor(shapes.net(), basis="bernstein")(u, v)
    assert np.abs(gap).max() <= 1e-11


def elementary_step(path):
    """A STEP file with a solid cylinder: a quarter of a tube and planes, none of them a B-spline."""
    from quintrig.exchange.cad.occ import module, quiet

    with quiet():
        solid = module("BRepPrimAPI").BRepPrimAPI_MakeCylinder(2.0, 5.0, np.pi / 2).Shape()
        module("STEPControl").STEPControl_Controller.Init_s()
        writer = module("STEPControl").STEPControl_Writer()
        writer.Transfer(solid, module("STEPControl").STEPControl_StepModelType.STEPControl_AsIs)
        writer.Write(str(path))


def test_planes_and_cylinders_become_exact_nurbs(tmp_path):
    path = tmp_path / "tube.step"
    elementary_step(path)
    contents = isolated.read(path)
    kinds = [face.surface for face in contents.faces]
    assert sorted(kinds) == ["cylinder", "plane", "plane", "plane", "plane"]
    number = kinds.index("cylinder") + 1
    surface = to_model(contents, "tube.step", [number]).surface
    sample = quintrig.analyse(surface, *quintrig.grid(7, 7), ("mean", "gaussian"))
    np.testing.assert_allclose(np.abs(sample["mean"]), 0.25, rtol=1e-12)
    np.testing.assert_allclose(sample["gaussian"], 0, atol=1e-12)
    assert sample["mean"].max() < 0  # a solid's normal points outwards


@pytest.mark.parametrize("unit", ["um", "mm", "cm", "m", "km", "in", "ft"])
@pytest.mark.parametrize("suffix", ["step", "igs", "3dm"])
def test_every_unit_comes_back_with_the_same_numbers(unit, suffix, tmp_path):
    path = tmp_path / f"part.{suffix}"
    surface = SURFACES["classical"]
    export_cad(model_of(surface, "p", unit), path)
    model = to_model(isolated.read_here(path), "part")
    assert model.unit == unit
    assert np.abs(model.surface(0.3, 0.8) - surface(0.3, 0.8)).max() <= 1e-14 * surface.size


def test_a_model_without_unit_says_what_the_file_assumes(tmp_path):
    notes = export_cad(model_of(SURFACES["classical"], "p", ""), tmp_path / "part.step")
    assert "the model states no unit; the file says mm" in notes


JUNK = {
    "empty": b"",
    "text": b"Dear all,\nplease find attached\n" * 20,
    "noise": np.random.default_rng(0).bytes(5000),
    "step head": b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
}


@pytest.mark.parametrize(
    ("junk", "suffix"),
    [*(("noise", suffix) for suffix in SUFFIXES), *((junk, "step") for junk in JUNK if junk != "noise")],
)
def test_files_that_are_no_cad_files_end_in_one_line(junk, suffix, tmp_path):
    path = tmp_path / f"junk.{suffix}"
    path.write_bytes(JUNK[junk])
    with pytest.raises(QuintrigError, match=r"junk") as caught:
        to_model(isolated.read(path), str(path))
    assert "\n" not in str(caught.value)
    assert "Traceback" not in str(caught.value)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_damaged_files_never_break_the_process(suffix, tmp_path):
    good = tmp_path / f"good.{suffix}"
    export_cad(model_of(SURFACES["classical"]), good)
    data = good.read_bytes()
    rng = np.random.default_rng(1)
    for cut in (0.8, 1.0):
        damaged = bytearray(data[: int(cut * len(data))])
        for place in rng.integers(0, len(damaged), 40 if cut == 1.0 else 0):
            damaged[place] = rng.integers(33, 126)
        path = tmp_path / f"bad.{suffix}"
        path.write_bytes(damaged)
        try:
            told = isolated.read(path).unit  # it may still hold a surface that can be read
        except QuintrigError as error:
            told = str(error)
        assert "\n" not in told


def test_missing_files_folders_and_other_kinds_are_told_apart(tmp_path):
    for name, message in (("none.step", "no such file"), ("part.dwg", "expected a file ending in")):
        with pytest.raises(QuintrigError, match=message):
            isolated.read(tmp_path / name)
    (tmp_path / "folder.step").mkdir()
    with pytest.raises(QuintrigError, match="found a folder"):
        isolated.read(tmp_path / "folder.step")


def test_unwritable_targets_leave_nothing_and_keep_what_was_there(tmp_path):
    (tmp_path / "taken.step").mkdir()
    with pytest.raises(QuintrigError, match="found a folder"):
        export_cad(model_of(SURFACES["classical"]), tmp_path / "taken.step")
    old = tmp_path / "old.step"
    old.write_text("old")
    infinite = quintrig.developable(
        [[0, 1, 4, -20], [1, 1, 5, -24], [2, 1, 4, -30], [3, 0, 4, -33], [4, 1, 3, -40], [5, 2, 4, -44]],
        [[0, 1, 0, 0], [0, 1, 0, -10]],
        (1, 1),
    )
    with pytest.raises(ValueError, match='patch "patch": the strip reaches infinity'):
        export_cad(model_of(infinite), old)
    assert old.read_text() == "old"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["old.step", "taken.step"]


def test_a_missing_extra_names_the_pip_command(monkeypatch):
    from quintrig.support import extras

    monkeypatch.setitem(sys.modules, "rhino3dm", None)
    with pytest.raises(QuintrigError, match=r"pip install 'quintrig\[cad\]'"):
        extras.need("rhino3dm", "3DM exchange")


@pytest.mark.parametrize("far", [1e4, 1e6, 1e9])
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_far_from_the_origin_files_are_as_near_as_coordinates_can_be(suffix, far, tmp_path):
    surface = quintrig.tensor(shapes.net() + far, shapes.SHAPE)
    model = model_of(surface, "far", "mm")
    path = tmp_path / f"far.{suffix}"
    notes = "\n".join(export_cad(model, path))
    contents = isolated.read_here(path)
    (found,) = deviations(written_carriers(model), contents, 100)
    assert found.distance <= 32 * np.spacing(far)
    assert ("from the origin" in notes) == (far > 1e4)
    (face,) = contents.faces
    # The control points, not only points computed from them, come back to the last bits.
    form = exact_surface(surface)
    assert np.abs(np.array(face.keys["points"]) - form.points).max() <= 2 * np.spacing(far)
    if suffix != "3dm":
        from quintrig.exchange.cad.occ import explored, module

        (shape,) = (s for s in read_shapes(path))
        assert module("BRepCheck").BRepCheck_Analyzer(shape).IsValid()
        assert len(explored(shape, "FACE")) == 1


def read_shapes(path):
    """The shape of a file through OpenCASCADE's plain readers, not quintrig's."""
    if path.suffix == ".brep":
        from OCP.BRep import BRep_Builder
        from OCP.BRepTools import BRepTools
        from OCP.TopoDS import TopoDS_Shape

        shape = TopoDS_Shape()
        assert BRepTools.Read_s(shape, str(path), BRep_Builder())
        return [shape]
    if path.suffix == ".step":
        from OCP.STEPControl import STEPControl_Reader as Reader
    else:
        from OCP.IGESControl import IGESControl_Reader as Reader
    reader = Reader()
    assert int(reader.ReadFile(str(path)).value) == 1
    reader.TransferRoots()
    return [reader.OneShape()]


def test_far_patches_are_sewn(lid, tmp_path):
    far = Model(
        "far", "mm", tuple(Patch(p.name, None, quintrig.tensor(p.surface.net + 1e8, shapes.SHAPE)) for p in lid.patches)
    )
    notes = "\n".join(export_cad(far, tmp_path / "far.step"))
    assert "1 shared edges, 10 free edges" in notes
    assert len(isolated.read_here(tmp_path / "far.step").faces) == 3


def test_a_single_point_is_refused_as_such(tmp_path):
    model = model_of(quintrig.tensor(np.ones((6, 6, 3)), shapes.SHAPE), "dot")
    with pytest.raises(ValueError, match='patch "dot": all of it is a single point'):
        export_cad(model, tmp_path / "dot.step")
    assert not (tmp_path / "dot.step").exists()
