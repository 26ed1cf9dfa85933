"""A joined model in the files of other programs: one shell, read back the same; meshes without holes; seams in DXF."""

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run


def body():
    x, y = np.meshgrid([0, 30, 70.0], [0, 40, 90.0], indexing="ij")
    points = np.stack([x, y, 12 * np.sin(x / 40) * np.cos(y / 30)], axis=-1)
    return quintrig.grid_of_patches(points, unit="mm")


@pytest.mark.parametrize("suffix", [".step", ".igs", ".3dm"])
def test_what_is_joined_is_so_when_read_back(suffix, tmp_path):
    pytest.importorskip("OCP" if suffix != ".3dm" else "rhino3dm")
    before = body()
    written = quintrig.export(before, tmp_path / f"body{suffix}")
    if suffix != ".3dm":
        assert any("4 shared edges, 8 free edges" in note and "sewn within" in note for note in written.notes)
        assert "read back as one shell" in written.notes
    after = quintrig.open_model(tmp_path / f"body{suffix}")
    assert len(after.patches) == 4
    assert after.joins().counts == before.joins().counts
    assert max(one.gap.most for one in after.joins()) < 1e-6
    for one, other in zip(before.patches, after.patches, strict=True):
        ends = other.surface([0, 1], [0, 1])
        np.testing.assert_allclose(ends, one.surface([0, 1], [0, 1]), atol=1e-6)


@pytest.mark.parametrize("tolerance", [0.5, 0.02])
def test_a_capped_tube_has_no_hole(tolerance):
    trimesh = pytest.importorskip("trimesh")
    from quintrig.mesh import mesh

    tube = quintrig.Model.from_dict({"unit": "mm", "name": "t", "kind": "cylinder", "radius": 20, "height": 30})
    closed = quintrig.cap(quintrig.cap(tube, "t:u1", order="G2"), "t:u0", order="G0")
    result = mesh([one.surface for one in closed.patches], tolerance=tolerance)
    whole = trimesh.Trimesh(result.points, result.triangles, process=False)
    assert whole.is_watertight
    assert whole.is_winding_consistent


def test_borders_of_a_mesh_are_those_of_the_body():
    trimesh = pytest.importorskip("trimesh")
    from quintrig.mesh import mesh

    result = mesh([one.surface for one in body().patches], tolerance=0.1)
    assert trimesh.Trimesh(result.points, result.triangles, process=False).euler_number == 1


def test_seams_are_polylines_on_layers_of_their_orders(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    model = body()
    quintrig.save(model, tmp_path / "body.toml")
    assert run("joins", tmp_path / "body.toml", "-o", tmp_path / "seams.dxf").code == 0
    document = ezdxf.readfile(tmp_path / "seams.dxf")
    lines = list(document.modelspace())
    assert [line.dxf.layer for line in lines] == ["SEAM_G2"] * 4
    assert document.header["$INSUNITS"] == 4
    for line, seam in zip(lines, model.joins(), strict=True):
        np.testing.assert_allclose([tuple(p) for p in line.points()], seam.points, atol=1e-9)


def test_zebra_stripes_run_through_a_smooth_seam_and_break_at_a_crease():
    from quintrig.figure.camera import ISO
    from quintrig.figure.zebra import stripes

    model = body()
    first, second = (stripes(model.patch(name).surface, ISO, 400) for name in ("p1_1", "p2_1"))
    assert np.abs(first[-1] - second[0]).max() < 0.25
    bent = model.patch("p2_1").surface.net.copy()
    bent[..., 2] += 0.6 * (bent[..., 0] - 30)
    creased = stripes(quintrig.tensor(bent), ISO, 400)
    assert np.abs(first[-1] - creased[0]).max() > 0.5


def test_a_picture_of_stripes_is_written_and_other_views_are_refused(tmp_path):
    quintrig.save(body(), tmp_path / "body.toml")
    assert run("plot", tmp_path / "body.toml", "-q", "zebra", "-o", tmp_path / "z.png").code == 0
    done = run("plot", tmp_path / "body.toml", "-q", "zebra,mean", "-o", tmp_path / "y.png")
    assert (done.code, "drawn alone" in done.err) == (2, True)
