"""What other tools get is the same surface: points, curvature and sides, held against values of their own."""

import importlib.util
import json
import os
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import quintrig
from quintrig.support.errors import QuintrigError

ROOT = Path(__file__).parent.parent


def optional(name):
    """Import a package that CI has; elsewhere skip without it."""
    if importlib.util.find_spec(name) is None:
        assert not os.environ.get("CI"), f"{name} is missing in CI"
        pytest.skip(f"needs {name}: pip install 'quintrig[tools]'")
    return importlib.import_module(name)


@pytest.fixture(scope="module")
def boot():
    return quintrig.load(ROOT / "examples/car_boot.toml")


@pytest.fixture(scope="module")
def halves():
    """Two rectangles 2 x 3 and 1 x 3 that share an edge of length 3."""

    def flat(x0, x1):
        x, y = np.meshgrid(np.linspace(x0, x1, 6), np.linspace(0.0, 3.0, 6), indexing="ij")
        return {"kind": "tensor", "points": np.stack([x, y, 0.0 * x], -1).tolist()}

    patches = [{"name": "left", **flat(0.0, 2.0)}, {"name": "right", **flat(2.0, 3.0)}]
    return quintrig.Model.from_dict({"name": "floor", "unit": "m", "patch": patches})


def test_a_structured_grid_has_the_points_and_every_quantity_where_they_belong():
    pyvista = optional("pyvista")
    radius, ring = 1.0, 3.0
    grid = quintrig.torus(ring, radius).to_pyvista(points=(7, 9))
    assert isinstance(grid, pyvista.StructuredGrid)
    assert grid.dimensions == (7, 9, 1)
    # K = cos ψ / (r (R + r cos ψ)) of the torus, from the points alone.
    out = np.hypot(grid.points[:, 0], grid.points[:, 1])
    np.testing.assert_allclose(grid["gaussian"], (out - ring) / radius**2 / out, atol=1e-6)  # points are float32
    np.testing.assert_allclose(np.linalg.norm(grid["normal"], axis=1), 1.0, atol=1e-12)
    sample = quintrig.analyse(quintrig.torus(ring, radius), grid["u"], grid["v"], ["point", "mean"])
    np.testing.assert_allclose(sample["point"], grid.points, atol=1e-5)
    np.testing.assert_allclose(sample["mean"], grid["mean"], atol=1e-12)
    from quintrig.quantities.table import BY_KEY

    assert set(BY_KEY) - {"point"} <= set(grid.point_data.keys())


def test_several_patches_make_blocks_by_name_and_a_trimmed_face_hides_its_outside(halves):
    pyvista = optional("pyvista")
    blocks = halves.to_pyvista(points=(3, 3), quantities="K")
    assert isinstance(blocks, pyvista.MultiBlock)
    assert blocks.keys() == ["left", "right"]
    assert blocks["left"].field_data["unit"][0] == "m"
    square = np.array([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75], [0.25, 0.25]])
    face = replace(halves.patches[0].surface, trim=(square,))
    grid = face.to_pyvista(points=(5, 5), quantities="K")
    assert (grid["vtkGhostType"] != 0).sum() == 25 - 9


def test_a_face_of_build123d_is_the_exact_surface(boot):
    optional("build123d")
    surface = boot.surface
    face = boot.to_build123d()
    assert face.is_valid
    for point in quintrig.analyse(surface, [0.2, 0.7], [0.4, 0.9], ["point"]).point:
        assert face.distance_to(tuple(point)) < 1e-9 * surface.size
    u, v = 0.3, 0.6
    at = quintrig.analyse(surface, u, v, ["point", "normal"])
    normal = np.array(tuple(face.normal_at(tuple(at.point))))
    np.testing.assert_allclose(normal, at.normal, atol=1e-6)


def test_patches_that_hang_together_are_one_shell_of_build123d(halves):
    build123d = optional("build123d")
    shell = halves.to_build123d()
    assert isinstance(shell, build123d.Shell)
    assert len(shell.faces()) == 2
    assert shell.area == pytest.approx(9.0, rel=1e-12)
    assert halves.patches[0].to_build123d().area == pytest.approx(6.0)  # a patch as its surface
    apart = quintrig.Model("apart", "m", (halves.patches[0], quintrig.load(ROOT / "examples/car_boot.toml").patches[0]))
    compound = apart.to_build123d()
    assert isinstance(compound, build123d.Compound)
    assert len(compound.faces()) == 2


def test_trimesh_and_compas_get_welded_meshes_with_attributes(halves):
    optional("trimesh")
    mesh = halves.to_trimesh(grid=(4, 4), quantities=["H"])
    assert len(mesh.vertices) == 4 * 4 * 2 - 4
    assert mesh.area == pytest.approx(9.0, rel=1e-12)
    assert set(mesh.vertex_attributes) == {"u", "v", "patch", "mean"}
    assert mesh.metadata["unit"] == "m"
    ball = quintrig.sphere(2.0).to_trimesh(tolerance=1e-3)
    assert ball.is_watertight
    assert ball.volume == pytest.approx(32.0 / 3.0 * np.pi, rel=2e-3)
    compas = optional("compas")
    same = halves.to_compas(grid=(4, 4), quantities=["H"])
    assert isinstance(same, importlib.import_module("compas.datastructures").Mesh)
    assert same.number_of_vertices() == 28
    assert same.area() == pytest.approx(9.0, rel=1e-12)
    assert same.vertex_attribute(0, "patch") == "left"
    again = compas.json_loads(compas.json_dumps(same))
    assert again.vertex_attribute(3, "mean") == same.vertex_attribute(3, "mean")


def test_the_nurbs_data_of_compas_are_what_it_takes_and_the_same_surface(boot):
    optional("compas")
    import inspect

    from compas.geometry import NurbsSurface

    from quintrig.geometry.nurbs import nurbs

    data = boot.to_compas(form="nurbs")
    assert set(data) == set(inspect.signature(NurbsSurface.from_parameters).parameters)
    knots = [np.repeat(data[f"knots_{a}"], data[f"mults_{a}"]) for a in "uv"]
    degrees = data["degree_u"], data["degree_v"]
    again = nurbs(np.array(data["points"]), np.array(data["weights"]), degrees, tuple(knots))
    form = quintrig.exact_surface(boot.surface)
    x, y = form.to_exact(0.3, 0.8)
    expected = quintrig.analyse(boot.surface, 0.3, 0.8, ["point"]).point
    np.testing.assert_allclose(quintrig.analyse(again, x, y, ["point"]).point, expected, rtol=1e-11)


def test_rhino_gets_the_exact_surface(boot):
    optional("rhino3dm")
    surface = boot.surface.to_rhino3dm()
    x, y = (float(value) for value in quintrig.exact_surface(boot.surface).to_exact(0.3, 0.8))
    point = surface.PointAt(x, y)
    expected = quintrig.analyse(boot.surface, 0.3, 0.8, ["point"]).point
    np.testing.assert_allclose([point.X, point.Y, point.Z], expected, rtol=1e-11)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s: s.to_pyvista(points=(1, 5)), r"points: expected a grid of 2 x 2 .*, found 1 x 5"),
        (lambda s: s.to_pyvista(points=5), r"points: expected two numbers of points, .* found 5"),
        (lambda s: s.to_pyvista(points=(10**5, 10**5)), r"points: expected a grid of 2 x 2 to 4,000,000"),
        (lambda s: s.to_pyvista(quantities=["gausian"]), r"gausian.*gaussian"),
        (lambda s: s.to_trimesh(quantities="normal"), r"normal is a vector"),
        (lambda s: s.to_compas(form="brep"), r'form: expected "mesh" or "nurbs"'),
        (lambda s: s.to_compas(form="nurbs", grid=(3, 3)), r"grid: goes with form"),
        (lambda s: s.to_trimesh(grid=5), r"grid: expected two numbers of points, .* found 5"),
        (lambda s: s.to_pyvista(quantities=5), r"quantities: expected keys or symbols .* found 5"),
    ],
)
def test_what_cannot_be_is_said_in_one_line(call, words):
    for name in ("pyvista", "trimesh", "compas"):
        optional(name)
    with pytest.raises(ValueError, match=words):
        call(quintrig.sphere(1.0))


def test_a_trimmed_face_is_not_handed_over_as_something_else(halves):
    optional("build123d")
    square = np.array([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75], [0.25, 0.25]])
    face = replace(halves.patches[0].surface, trim=(square,))
    with pytest.raises(ValueError, match=r"trimmed face.*surface\.carrier"):
        face.to_build123d()
    assert face.carrier.to_build123d().area == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("name", "extra"), [("pyvista", "tools"), ("build123d", "tools"), ("trimesh", "mesh"), ("compas", "tools")]
)
def test_a_missing_package_is_one_line_with_its_command(monkeypatch, name, extra):
    monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.setitem(sys.modules, f"{name}.datastructures", None)
    with pytest.raises(QuintrigError, match=rf"pip install 'quintrig\[{extra}\]'"):
        getattr(quintrig.sphere(1.0), f"to_{name}")()


@pytest.mark.parametrize("name", ["pyvista", "build123d", "trimesh", "compas", "rhino3dm"])
def test_a_package_that_is_too_old_is_one_line_with_its_command(monkeypatch, name):
    old = ModuleType(name)
    old.__version__ = "0.9.1"
    monkeypatch.setitem(sys.modules, name, old)
    with pytest.raises(QuintrigError, match=r"or newer, found 0\.9\.1; try: pip install -U 'quintrig\["):
        getattr(quintrig.sphere(1.0), f"to_{name}")()


def test_meshes_of_other_tools_are_targets(boot):
    pyvista, trimesh = optional("pyvista"), optional("trimesh")
    optional("compas")
    meshes = boot.to_trimesh(grid=(9, 9)), boot.to_compas(grid=(9, 9)), boot.to_pyvista(points=(9, 9), quantities="K")
    for mesh in meshes:
        found = quintrig.deviation(boot, mesh)
        assert found.unit == "mm"
        assert (len(found.points), found.rms < 1e-8) == (81, True)
    scan = quintrig.from_pyvista(meshes[2])
    assert len(scan.triangles) == 128
    np.testing.assert_allclose(scan.parameters[[1, 9, 80]], [[0.125, 0.0], [0.0, 0.125], [1.0, 1.0]])
    ball = quintrig.fit(pyvista.Sphere(radius=2.0), "sphere")
    assert ball.to_dict()["form"]["radius"] == pytest.approx(2.0, abs=1e-6)
    inches = trimesh.creation.box()
    inches.units = "inches"
    assert quintrig.from_trimesh(trimesh.Scene([inches, inches])).unit == quintrig.from_trimesh(inches).unit == "in"


def test_a_structured_grid_is_a_net_of_nodes_whichever_way_it_lies():
    pyvista = optional("pyvista")
    x, y = np.meshgrid(np.linspace(0.0, 1.0, 4), np.linspace(0.0, 2.0, 3), indexing="ij")
    for at in (np.s_[:, :, None], np.s_[None, :, :], np.s_[:, None, :]):
        grid = pyvista.StructuredGrid(x[at], y[at], (x * y)[at])
        scan = quintrig.from_pyvista(grid)
        np.testing.assert_allclose(scan.parameters * [1.0, 2.0], scan.points[:, :2], atol=1e-7)
        grid.hide_points([0])
        assert len(quintrig.from_pyvista(grid).points) == 11
    square = np.array([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75], [0.25, 0.25]])
    face = replace(quintrig.sphere(1.0), trim=(square,)).to_pyvista(points=(5, 5), quantities="K")
    assert len(quintrig.from_pyvista(face).points) == 9


def test_shapes_of_build123d_are_models_with_their_holes():
    build123d = optional("build123d")
    part = build123d.Box(10.0, 8.0, 2.0) - build123d.Cylinder(2.0, 2.0)
    model = quintrig.from_build123d(part)
    assert (len(model.patches), model.unit) == (7, "mm")
    top = part.faces().sort_by(build123d.Axis.Z)[-1]
    assert quintrig.integrals(quintrig.from_build123d(top).surface).area.value == pytest.approx(top.area, rel=1e-6)
    found = quintrig.deviation(quintrig.from_build123d(top).surface.carrier, top)
    assert found.rms < 1e-12
    assert np.hypot(*found.points[:, :2].T).min() > 2.0 - 0.01  # none in the hole


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda pv, tm, cd, b: pv.StructuredGrid(), "from_pyvista: expected points, found an empty StructuredGrid"),
        (lambda pv, tm, cd, b: pv.MultiBlock(), "from_pyvista: expected points, found an empty MultiBlock"),
        (lambda pv, tm, cd, b: tm.Trimesh(), "from_trimesh: expected points, found an empty Trimesh"),
        (lambda pv, tm, cd, b: tm.Scene(), "from_trimesh: expected points, found an empty Scene"),
        (lambda pv, tm, cd, b: cd.Mesh(), "from_compas: expected points, found an empty Mesh"),
        (lambda pv, tm, cd, b: cd.Graph(), "from_compas: expected a mesh or a point cloud, found Graph"),
        (lambda pv, tm, cd, b: b.Edge.make_line((0, 0), (1, 1)), "from_build123d: expected a shape with faces"),
        (lambda pv, tm, cd, b: b.Part(), "from_build123d: expected a shape with faces"),
    ],
)
def test_an_object_without_points_is_no_target(call, words):
    tools = [optional(name) for name in ("pyvista", "trimesh", "compas.datastructures", "build123d")]
    for take in (quintrig.fit, lambda target: quintrig.deviation(quintrig.sphere(1.0), target)):
        with pytest.raises((ValueError, QuintrigError), match=words):
            take(call(*tools))


def run(script, **modules):
    """Run an example with other programs' modules stood in for, and return what it left."""
    sys.modules.update(modules)
    try:
        return exec(compile(script.read_text(), str(script), "exec"), {"__name__": "__main__"})
    finally:
        for name in modules:
            del sys.modules[name]


def test_the_macro_for_freecad_brings_a_step_file_in(monkeypatch):
    optional("OCP")
    told, got = [], []
    console = SimpleNamespace(PrintMessage=told.append)
    freecad = SimpleNamespace(Console=console, ActiveDocument=None, newDocument=lambda name: SimpleNamespace(Name=name))
    chosen = SimpleNamespace(getOpenFileName=lambda *_: (str(ROOT / "examples/car_boot.toml"), ""))
    monkeypatch.setenv("QUINTRIG", str(Path(sys.executable).with_name("quintrig")))
    taken = SimpleNamespace(insert=lambda path, name: got.append((Path(path).read_bytes()[:12], name)))
    qt = SimpleNamespace(QtGui=SimpleNamespace(QFileDialog=chosen))
    run(ROOT / "examples/tools/freecad_macro.py", FreeCAD=freecad, Import=taken, PySide=qt)
    assert got == [(b"ISO-10303-21", "car_boot")]
    assert any("deviation" in line for line in told)


def test_the_script_for_blender_brings_a_coloured_mesh_in(monkeypatch):
    got = []
    gltf = SimpleNamespace(import_scene=SimpleNamespace(gltf=lambda filepath: got.append(Path(filepath).read_bytes())))
    blender = SimpleNamespace(ops=gltf, data=SimpleNamespace(materials=[]))
    monkeypatch.setenv("QUINTRIG", str(Path(sys.executable).with_name("quintrig")))
    monkeypatch.setattr(sys, "argv", ["blender", "--", str(ROOT / "examples/car_boot.toml"), "mean"])
    run(ROOT / "examples/tools/blender_import.py", bpy=blender)
    assert got[0][:4] == b"glTF"
    assert b"COLOR_0" in got[0]


def test_the_endpoint_for_grasshopper_answers(tmp_path):
    for name in ("ghhops_server", "rhino3dm"):
        optional(name)
    specification = importlib.util.spec_from_file_location("hops_endpoint", ROOT / "examples/tools/hops_endpoint.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    points = [SimpleNamespace(X=a, Y=b, Z=0.1 * a * a) for a, b in zip(x.ravel(), y.ravel(), strict=True)]
    client = module.app.test_client()
    sent = [
        {"type": "Rhino.Geometry.Point3d", "data": json.dumps({axis: getattr(p, axis) for axis in "XYZ"})}
        for p in points
    ]
    half = [{"type": "System.Double", "data": "0.5"}] * 4
    values = [{"ParamName": n, "InnerTree": {"{0}": v}} for n, v in (("Points", sent), ("Shape", half))]
    answer = client.post("/solve", json={"pointer": "/tensor", "values": values})  # as Grasshopper asks
    assert answer.status_code == 200
    surface, radius = module.tensor(points, [0.5, 0.5, 0.5, 0.5])
    told = json.loads(answer.data)["values"][1]["InnerTree"]["0"][0]["data"]
    assert float(told) == pytest.approx(radius)
    form = surface.PointAt(0.0, 0.0)
    assert pytest.approx([0.0, 0.0, 0.0]) == [form.X, form.Y, form.Z]
    own = quintrig.tensor([[[p.X, p.Y, p.Z] for p in points[k : k + 6]] for k in range(0, 36, 6)], (0.5,) * 4)
    bent = quintrig.analyse(own, *quintrig.grid(65, 65), ["k1", "k2"])
    assert radius == pytest.approx(1.0 / np.maximum(abs(bent["k1"]), abs(bent["k2"])).max())
