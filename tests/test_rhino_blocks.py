"""3DM files as Rhino writes them: blocks placed, scaled and nested, and files without a surface."""

import numpy as np
import pytest

import quintrig
from quintrig.exchange.cad import isolated
from quintrig.exchange.cad.faces import to_model
from quintrig.support.errors import QuintrigError

rhino3dm = pytest.importorskip("rhino3dm", reason="the extra 'cad' is not installed")


def ball(radius=10.0):
    return rhino3dm.Sphere(rhino3dm.Point3d(0, 0, 0), radius).ToBrep()


def block(file, name, geometry):
    """Add a block definition and return its identity."""
    attributes = tuple(rhino3dm.ObjectAttributes() for _ in geometry)
    for one in attributes:
        one.Name = name
    index = file.InstanceDefinitions.Add(name, "", "", "", rhino3dm.Point3d(0, 0, 0), tuple(geometry), attributes)
    return file.InstanceDefinitions.FindIndex(index).Id


def place(identity, scale=1.0, shift=(0.0, 0.0, 0.0)):
    move = rhino3dm.Transform(1.0)
    for k in range(3):
        setattr(move, f"M{k}{k}", scale)
        setattr(move, f"M{k}3", shift[k])
    return rhino3dm.InstanceReference(identity, move)


def read(file, path):
    assert file.Write(str(path), 7)
    return isolated.read(path)


def curvatures(contents):
    model = to_model(contents, "blocks.3dm")
    return [float(quintrig.analyse(patch.surface, 0.4, 0.6, "gaussian")["gaussian"]) for patch in model.patches]


def test_a_block_is_read_wherever_it_is_placed(tmp_path):
    file = rhino3dm.File3dm()
    identity = block(file, "ball", [ball()])
    for reference in (place(identity, 1.0, (100, 0, 0)), place(identity, 2.0)):
        file.Objects.AddInstanceObject(reference)
    contents = read(file, tmp_path / "twice.3dm")
    assert curvatures(contents) == pytest.approx([1e-2, 2.5e-3], rel=1e-12)
    centres = [
        np.mean([patch.surface(u, v) for u in (0.0, 1.0) for v in (0.0, 0.5)], axis=0)
        for patch in to_model(contents, "x").patches
    ]
    assert centres[0][0] - centres[1][0] == pytest.approx(100, abs=40)


def test_blocks_inside_blocks_are_scaled_by_both(tmp_path):
    file = rhino3dm.File3dm()
    inner = block(file, "inner", [ball(1.0)])
    outer = block(file, "outer", [place(inner, 3.0, (5, 0, 0))])
    file.Objects.AddInstanceObject(place(outer, 2.0, (0, 7, 0)))
    contents = read(file, tmp_path / "nested.3dm")
    assert curvatures(contents) == pytest.approx([1 / 36], rel=1e-12)  # radius 2 · 3 · 1
    points = to_model(contents, "x").surface(*np.meshgrid(np.linspace(0, 1, 41), np.linspace(0, 1, 41)))
    middle = 0.5 * (points.min(axis=(0, 1)) + points.max(axis=(0, 1)))
    np.testing.assert_allclose(middle, [10, 7, 0], atol=1e-12)  # twice (5, 0, 0), and (0, 7, 0)


def test_a_block_that_is_placed_nowhere_is_not_there(tmp_path):
    file = rhino3dm.File3dm()
    block(file, "ball", [ball()])
    file.Objects.AddBrep(ball(4.0), rhino3dm.ObjectAttributes())
    assert curvatures(read(file, tmp_path / "unplaced.3dm")) == pytest.approx([1 / 16], rel=1e-12)


@pytest.mark.parametrize(
    ("add", "said"),
    [
        (lambda table, mesh: table.AddMesh(mesh, rhino3dm.ObjectAttributes()), "1 meshes"),
        (lambda table, _: table.AddPoint(rhino3dm.Point3d(1, 2, 3)), "1 points"),
    ],
)
def test_a_file_without_surfaces_says_what_it_holds(add, said, tmp_path):
    mesh = rhino3dm.Mesh()
    for x, y in ((0, 0), (1, 0), (0, 1)):
        mesh.Vertices.Add(x, y, 0.0)
    mesh.Faces.AddFace(0, 1, 2)
    file = rhino3dm.File3dm()
    add(file.Objects, mesh)
    with pytest.raises(QuintrigError, match=f"found only {said}; convert them to NURBS"):
        read(file, tmp_path / "only.3dm")
