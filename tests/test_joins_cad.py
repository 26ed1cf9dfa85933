"""Seams between the faces of CAD files, trimmed ones too, against what the solids are."""

import pytest

import quintrig
from quintrig.exchange.imports import open_model

pytest.importorskip("OCP")


def solid(name, tmp_path):
    """Write a box of 60 x 40 x 20 as STEP: as it is, with all edges rounded by 4, or with a hole of radius 8."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
    from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
    from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer

    from quintrig.exchange.cad.occ import down_to, explored

    shape = BRepPrimAPI_MakeBox(60, 40, 20).Shape()
    if name == "rounded":
        maker = BRepFilletAPI_MakeFillet(shape)
        for edge in explored(shape, "EDGE"):
            maker.Add(4.0, down_to("Edge", edge))
        shape = maker.Shape()
    if name == "hole":
        tool = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(30, 20, -5), gp_Dir(0, 0, 1)), 8, 40).Shape()
        shape = BRepAlgoAPI_Cut(shape, tool).Shape()
    path = tmp_path / f"{name}.step"
    writer = STEPControl_Writer()
    writer.Transfer(shape, STEPControl_AsIs)
    writer.Write(str(path))
    return open_model(path)


def test_a_box_has_twelve_right_angles(tmp_path):
    joins = solid("box", tmp_path).joins()
    assert [join.order for join in joins] == ["G0"] * 12
    assert {round(join.angle.most, 9) for join in joins} == {90.0}
    assert not joins.free
    assert not any(join.opposed for join in joins)


def test_rounded_edges_are_tangent_with_a_jump_of_one_over_the_radius(tmp_path):
    joins = solid("rounded", tmp_path).joins()
    assert not joins.free
    assert not joins.warnings
    # 12 roundings between 2 planes and 2 corners each: flat beside round across every one of these edges.
    assert len(joins) == 48
    for join in joins:
        assert join.order == "G1"
        assert join.difference.most == pytest.approx(0.25, rel=1e-9)


def test_a_hole_is_met_along_the_trim_loops(tmp_path):
    joins = solid("hole", tmp_path).joins()
    assert not joins.free
    around = [join for join in joins if "loop2" in join.first.side + join.second.side]
    assert len(around) == 2
    for join in around:
        assert join.order == "G0"
        assert join.angle.least == pytest.approx(90.0, abs=1e-6)
        assert join.gap.most < 1e-6


def test_joins_of_surfaces_without_a_model():
    assert len(quintrig.find_joins([quintrig.torus()])) == 2
