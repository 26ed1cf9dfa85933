"""Meshes: the tolerance holds everywhere, no point twice, no gap; files that other programs read alike."""

import json
import os
import struct

import numpy as np
import pytest

import quintrig
import shapes
from quintrig.exchange.mesh.files import linear
from quintrig.exchange.mesh.write import MESH_SUFFIXES, MeshOptions, export_mesh
from quintrig.geometry.exact import exact_surface
from quintrig.geometry.nurbs import nurbs
from quintrig.mesh.triangulate import mesh
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.errors import QuintrigError

if not os.environ.get("CI"):
    pytest.importorskip("trimesh", reason="needs the extra mesh: pip install 'quintrig[mesh]'")
    pytest.importorskip("meshio", reason="needs the extra mesh: pip install 'quintrig[mesh]'")

SURFACES = shapes.rational() | {"catenoid": quintrig.catenoid(), "helicoid": quintrig.helicoid()}
CLOSED = ("sphere", "ellipsoid", "torus")


def nearest_on_triangle(p, a, b, c):
    """Distance of points (n, 3) from triangles (n, 3 each): inside the plane's projection, or to the three sides."""
    normal = np.cross(b - a, c - a)
    unit = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    height = ((p - a) * unit).sum(1)
    foot = p - height[:, None] * unit
    inside = np.ones(len(p), dtype=bool)
    sides = []
    for x, y in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(y - x, foot - x) * unit).sum(1) >= 0
        share = np.clip(((p - x) * (y - x)).sum(1) / ((y - x) ** 2).sum(1), 0, 1)
        sides.append(np.linalg.norm(p - x - share[:, None] * (y - x), axis=1))
    return np.where(inside, np.abs(height), np.min(sides, axis=0))


def distance_from(result, points):
    """Distance of points (k, 3) from a mesh: the nearest of the triangles around each point's 24 nearest centres."""
    from scipy.spatial import cKDTree

    corners = result.points[result.triangles]
    _, near = cKDTree(corners.mean(axis=1)).query(points, k=min(24, len(corners)))
    all_of = [nearest_on_triangle(points, *np.moveaxis(corners[near[:, k]], 1, 0)) for k in range(near.shape[1])]
    return np.min(all_of, axis=0)


@pytest.mark.parametrize("name", SURFACES)
def test_no_surface_point_is_farther_than_the_tolerance(name):
    surface = SURFACES[name]
    tolerance = 1e-3 * surface.size
    result = mesh([surface], tolerance=tolerance)
    rng = np.random.default_rng(0)
    u, v = rng.uniform(size=(2, 4000))
    u[:400], v[400:800] = np.round(u[:400]), np.round(v[400:800])  # borders too
    # Long thin triangles have far centres, so a strip's mesh is compared with every triangle instead.
    points = surface(u, v)
    found = distance_from(result, points)
    if found.max() > tolerance:
        corners = result.points[result.triangles]
        found = np.array(
            [
                nearest_on_triangle(np.tile(p, (len(corners), 1)), *np.moveaxis(corners, 1, 0)).min()
                for p in points[found > tolerance]
            ]
        )
    assert found.max() <= 1.05 * tolerance
    assert result.chord <= tolerance


@pytest.mark.parametrize("name", SURFACES)
def test_points_are_unique_normals_unit_and_triangles_face_them(name):
    surface = SURFACES[name]
    result = mesh([surface], tolerance=3e-3 * surface.size)
    assert len(np.unique(result.points, axis=0)) == len(result.points) or name == "enneper"
    assert sorted(np.unique(result.triangles)) == list(range(len(result.points)))
    np.testing.assert_allclose(np.linalg.norm(result.normals, axis=1), 1, rtol=1e-12)
    a, b, c = np.moveaxis(result.points[result.triangles], 1, 0)
    facing = np.cross(b - a, c - a)
    assert (np.linalg.norm(facing, axis=1) > 0).all()
    agree = (facing * result.normals[result.triangles].sum(axis=1)).sum(axis=1)
    assert (agree > 0).mean() > 0.999


@pytest.mark.parametrize("name", CLOSED)
def test_closed_surfaces_are_watertight_with_the_right_volume(name):
    import trimesh

    surface = SURFACES[name]
    result = mesh([surface], tolerance=2e-4 * surface.size)
    solid = trimesh.Trimesh(result.points, result.triangles, process=False)
    volume = {"sphere": 4 / 3 * np.pi * 8, "ellipsoid": 4 / 3 * np.pi * 6, "torus": 2 * np.pi**2 * 3}[name]
    assert result.open_edges == 0
    assert solid.is_watertight
    assert solid.is_winding_consistent
    assert solid.volume == pytest.approx(volume, rel=5e-3)
    assert solid.euler_number == (0 if name == "torus" else 2)


def test_collapsed_edge_is_one_point():
    result = mesh([SURFACES["swung to a pole"]], grid=(9, 12))
    assert len(result.points) == 9 * 12 - 11
    assert len(result.triangles) == 2 * 8 * 11 - 11


def quilt():
    """Two by two patches that share edges, one of them with u and v exchanged and one running backwards."""
    net = shapes.net(7, 11, 11)
    net[5] = 0.5 * (net[4] + net[6])
    net[:, 5] = 0.5 * (net[:, 4] + net[:, 6])
    a, b, c, d = net[:6, :6], net[5:, :6], net[:6, 5:], net[5:, 5:]
    return [
        quintrig.tensor(a),
        quintrig.tensor(b.transpose(1, 0, 2), flip=True),
        quintrig.tensor(c[::-1, ::-1]),
        quintrig.tensor(d),
    ]


@pytest.mark.parametrize("tolerance", [0.02, 0.002])
def test_neighbouring_patches_share_their_border_points(tolerance):
    import trimesh

    patches = quilt()
    result = mesh(patches, tolerance=tolerance)
    whole = trimesh.Trimesh(result.points, result.triangles, process=False)
    assert result.notes == ()
    assert whole.is_winding_consistent
    assert len(np.unique(result.points, axis=0)) == len(result.points)
    # A disc: one border, no holes between the patches.
    assert whole.euler_number == 1
    sides = np.sort(
        np.concatenate([result.triangles[:, [0, 1]], result.triangles[:, [1, 2]], result.triangles[:, [2, 0]]]), 1
    )
    pairs, counts = np.unique(sides, axis=0, return_counts=True)
    border = result.points[pairs[counts == 1]]
    low, high = result.points.min(0), result.points.max(0)
    on_rim = (np.abs(border[:, :, :2] - low[:2]) < 1e-9) | (np.abs(border[:, :, :2] - high[:2]) < 1e-9)
    assert on_rim.any(axis=2).all()


def test_normals_to_opposite_sides_are_told():
    patches = quilt()
    patches[3] = quintrig.tensor(patches[3].net, flip=True)
    notes = " ".join(mesh(patches, tolerance=0.05).notes)
    assert "opposite sides" in notes
    assert "2 and 4" in notes
    assert "3 and 4" in notes


def test_values_are_those_of_the_surface():
    surface = SURFACES["tensor"]
    result = mesh([surface], tolerance=0.01, quantities=("gaussian", "hk_type"))
    sample = quintrig.analyse(surface, result.u, result.v, ("point", "gaussian", "hk_type"))
    np.testing.assert_allclose(result.points, sample.point, rtol=0, atol=1e-13)
    np.testing.assert_allclose(result.values["gaussian"], sample["gaussian"], rtol=1e-9, atol=1e-12)
    assert (result.values["hk_type"] == sample["hk_type"]).mean() > 0.99


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tolerance": 0.0}, "greater than 0"),
        ({"tolerance": 1e-13}, "more than 4,000,000 points"),
        ({"grid": (1, 5)}, "found 1 x 5"),
        ({"grid": (5000, 5000)}, "found 5000 x 5000"),
    ],
)
def test_impossible_meshes_are_refused(options, message):
    with pytest.raises(ValueError, match=message):
        mesh([SURFACES["tensor"]], **options)


def model():
    return Model("Lid é", "mm", tuple(Patch(f"p{k}", None, patch) for k, patch in enumerate(quilt())))


@pytest.mark.parametrize("suffix", MESH_SUFFIXES)
def test_every_format_is_read_by_trimesh_or_meshio_with_the_same_mesh(suffix, tmp_path):
    import meshio
    import trimesh

    path = tmp_path / f"lid{suffix}"
    export_mesh(model(), path, MeshOptions(tolerance=0.01))
    expected = mesh([patch.surface for patch in model().patches], tolerance=0.01, quantities=("gaussian",))
    if suffix == ".vtu":
        read = meshio.read(path)
        points, triangles = read.points, read.cells_dict["triangle"]
    else:
        read = trimesh.load(path, process=suffix == ".stl", force="mesh")
        points, triangles = read.vertices, read.faces
    assert len(triangles) == len(expected.triangles)
    assert len(points) == len(expected.points)
    if suffix == ".glb":  # metres, y up
        points = 1000 * np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)
    ours = np.sort(expected.points[expected.triangles].mean(axis=1), axis=0)
    theirs = np.sort(np.asarray(points)[triangles].mean(axis=1), axis=0)
    assert np.abs(ours - theirs).max() <= (1e-5 if suffix in (".stl", ".glb") else 1e-12)


@pytest.mark.parametrize("suffix", [".ply", ".vtu"])
def test_scalars_are_float64_by_quantity_name(suffix, tmp_path):
    import meshio

    path = tmp_path / f"lid{suffix}"
    export_mesh(model(), path, MeshOptions(grid=(7, 9)))
    read = meshio.read(path)
    expected = mesh([patch.surface for patch in model().patches], grid=(7, 9), quantities=("gaussian", "mean", "k1"))
    for key in ("gaussian", "mean", "k1"):
        assert read.point_data[key].dtype == np.float64
        np.testing.assert_array_equal(read.point_data[key], expected.values[key])


def glb_parts(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    tree = json.loads(data[20 : 20 + length])
    assert struct.unpack_from("<I", data, 8)[0] == len(data)
    return tree, data[28 + length :]


def accessor(tree, binary, name):
    number = tree["meshes"][0]["primitives"][0]["attributes"][name]
    entry = tree["accessors"][number]
    view = tree["bufferViews"][entry["bufferView"]]
    kind = {5126: "<f4", 5123: "<u2"}[entry["componentType"]]
    width = {"VEC3": 3, "VEC4": 4, "SCALAR": 1}[entry["type"]]
    part = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    return np.frombuffer(part, kind).reshape(-1, width)


def test_glb_colours_are_linear_and_positions_bounded(tmp_path):
    path, other = tmp_path / "lid.glb", tmp_path / "lid.obj"
    for file in (path, other):
        export_mesh(model(), file, MeshOptions(grid=(7, 9), colour="mean"))
    tree, binary = glb_parts(path)
    words = [line.split() for line in other.read_text().splitlines() if line.startswith("v ")]
    srgb = np.array([[float(word) for word in line[4:7]] for line in words])
    colours = accessor(tree, binary, "COLOR_0")[:, :3] / 65535
    np.testing.assert_allclose(colours, linear(srgb), atol=2e-4)
    positions = accessor(tree, binary, "POSITION")
    entry = tree["accessors"][tree["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
    np.testing.assert_array_equal(positions.min(axis=0), np.float32(entry["min"]))
    assert "unit mm" in tree["asset"]["extras"]["remarks"][0]


def test_srgb_to_linear_at_its_known_values():
    np.testing.assert_allclose(linear(np.array([0, 0.04045, 0.5, 1])), [0, 0.0031308, 0.2140411, 1], atol=1e-6)


def test_gmsh_reads_the_stl(tmp_path):
    gmsh = pytest.importorskip("gmsh", reason="gmsh is not installed", exc_type=ImportError)
    path = tmp_path / "torus.stl"
    export_mesh(Model("t", "", (Patch("t", None, quintrig.torus()),)), path, MeshOptions(grid=(30, 60)))
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.merge(str(path))
        _, tags, _ = gmsh.model.mesh.getElements(2)
        assert sum(len(t) for t in tags) == 2 * 29 * 59
    finally:
        gmsh.finalize()


def test_a_singular_model_is_grey_there_and_says_how_many(tmp_path):
    flat = quintrig.tensor(np.zeros((6, 6, 3)) + np.arange(6)[:, None, None] * [1, 0, 0])
    notes = export_mesh(Model("line", "", (Patch("p", None, flat),)), tmp_path / "a.ply", MeshOptions(grid=(4, 4)))
    assert "singular points grey" in " ".join(notes)


def test_wrong_options_and_targets_are_refused(tmp_path):
    with pytest.raises(ValueError, match="vector"):
        MeshOptions(colour="normal")
    with pytest.raises(ValueError, match="did you mean 'gaussian'"):
        MeshOptions(colour="gausian")
    with pytest.raises(ValueError, match="found both"):
        MeshOptions(tolerance=1.0, grid=(2, 2))
    (tmp_path / "a.stl").mkdir()
    with pytest.raises(QuintrigError, match="found a folder"):
        export_mesh(model(), tmp_path / "a.stl", MeshOptions(grid=(3, 3)))


@pytest.mark.parametrize("flip", [False, True])
def test_the_header_says_which_way_the_triangles_face(flip, tmp_path):
    """The normal of a sphere points outwards, which is against S_u x S_v: the words must follow the surface."""
    model = Model.from_dict({"kind": "sphere", "radius": 2.0, "flip": flip})
    export_mesh(model, tmp_path / "ball.obj", MeshOptions(tolerance=0.1))
    header, faces, points = "", [], []
    for line in (tmp_path / "ball.obj").read_text(encoding="utf-8").splitlines():
        word, *rest = line.split()
        if word == "#":
            header += line
        elif word == "v":
            points.append([float(x) for x in rest[:3]])
        elif word == "f":
            faces.append([int(x.split("/")[0]) - 1 for x in rest])
    corners = np.array(points)[np.array(faces)]
    volume = np.linalg.det(corners).sum() / 6
    assert (volume > 0) == (not flip)
    assert ("against S_u x S_v" in header) == (not flip)


def moved(surface_net, far):
    return quintrig.tensor(np.asarray(surface_net) + far, shapes.SHAPE)


def corners_of(path):
    """Corners of the triangles (m, 3, 3) as trimesh or meshio reads them, in the model's unit mm."""
    import meshio
    import trimesh

    if path.suffix == ".vtu":
        read = meshio.read(path)
        return read.points[read.cells_dict["triangle"]]
    read = trimesh.load(path, process=False, force="mesh")
    points = np.asarray(read.vertices, dtype=np.float64)
    if path.suffix == ".glb":  # metres, y up
        points = 1000 * np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)
    return points[read.faces]


def farthest(corners, points):
    """Largest distance of points (k, 3) from triangles (m, 3, 3)."""
    a, b, c = np.moveaxis(corners, 1, 0)
    return max(nearest_on_triangle(np.broadcast_to(point, a.shape), a, b, c).min() for point in points)


@pytest.mark.parametrize("far", [0.0, 1e4, 1e6, 1e9])
@pytest.mark.parametrize("suffix", MESH_SUFFIXES)
def test_a_file_keeps_its_tolerance_far_from_the_origin_or_is_refused(suffix, far, tmp_path):
    path = tmp_path / f"far{suffix}"
    surface = moved(shapes.net(), far)
    tolerance = 1e-3 * surface.size
    one = Model("far", "mm", (Patch("far", None, surface),))
    if suffix == ".stl" and far >= 1e6:
        with pytest.raises(ValueError, match=r"STL holds float32.*write \.obj, \.ply, \.glb, \.vtu"):
            export_mesh(one, path, MeshOptions(tolerance=tolerance))
        assert not path.exists()
        return
    notes = export_mesh(one, path, MeshOptions(tolerance=tolerance))
    corners = corners_of(path)
    told = float(notes[0].split("chord measured ")[1].split(",")[0])
    assert told <= tolerance
    # The surface at the origin, moved: its points are known to more digits than those of the moved one.
    u, v = np.random.default_rng(1).uniform(size=(2, 300))
    points = surface(u, v)
    assert farthest(corners, points) <= tolerance
    assert len(np.unique(corners.reshape(-1, 3), axis=0)) == int(notes[0].split(" ")[0].replace(",", ""))


def test_a_given_grid_is_not_written_where_float32_would_spoil_it(tmp_path):
    one = Model("far", "mm", (Patch("far", None, moved(shapes.net(), 1e9)),))
    with pytest.raises(ValueError, match=r"STL holds float32, which 1\.73e\+09 mm from the origin"):
        export_mesh(one, tmp_path / "far.stl", MeshOptions(grid=(9, 9)))
    export_mesh(one, tmp_path / "far.glb", MeshOptions(grid=(9, 9)))
    assert len(np.unique(corners_of(tmp_path / "far.glb").reshape(-1, 3), axis=0)) == 81


def test_a_tolerance_below_float32_is_kept_by_finer_triangles_or_refused(tmp_path):
    surface = moved(shapes.net(), 3e3)
    one = Model("far", "mm", (Patch("far", None, surface),))
    step = float(np.spacing(np.float32(3e3)))
    path = tmp_path / "fine.stl"
    with pytest.raises(ValueError, match=r"STL holds float32, which .* from the origin would move points"):
        export_mesh(one, path, MeshOptions(tolerance=2 * step))
    export_mesh(one, path, MeshOptions(tolerance=6 * step))
    corners = corners_of(path)
    u, v = np.random.default_rng(1).uniform(size=(2, 100))
    points = surface(u, v)
    assert farthest(corners, points) <= 6 * step


@pytest.mark.parametrize("far", [1e6, 1e9])
def test_neighbours_and_poles_are_one_far_from_the_origin(far):
    net = shapes.net()
    net[0] = net[0, 0] + 0.1  # rounding makes the collapsed edge's points differ when they are moved
    patches = [*quilt(), quintrig.tensor(net - [0, 50, 0])]
    near = mesh(patches, grid=(9, 9))
    there = mesh([quintrig.tensor(patch.net + far, flip=patch.flip) for patch in patches], grid=(9, 9))
    assert there.open_edges == near.open_edges
    assert len(there.points) == len(near.points)


@pytest.mark.parametrize("far", [1e6, 1e8])
def test_a_pole_takes_no_more_triangles_far_from_the_origin(far):
    form = exact_surface(quintrig.cone(3.0, 4.0))
    knots = (form.u.knots, form.v.knots)
    near, there = (mesh([nurbs(form.points + k, form.weights, form.degrees, knots)]) for k in (0.0, far))
    assert len(there.triangles) <= 1.2 * len(near.triangles)


def test_a_single_point_is_told_as_such(tmp_path):
    surface = quintrig.tensor(np.ones((6, 6, 3)), shapes.SHAPE)
    with pytest.raises(ValueError, match="single point"):
        mesh([surface])
    with pytest.raises(ValueError, match='patch "dot": all of it is a single point'):
        export_mesh(Model("dot", "mm", (Patch("dot", None, surface),)), tmp_path / "dot.stl")
