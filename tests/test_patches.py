"""A patch has a definition, whatever it was made from, and says in one line what it cannot do."""

import numpy as np
import pytest

import quintrig
from catalogue import CALM, LEVEL, SURFACES
from quintrig import Model, ModelError
from quintrig.basis.bspline import BSpline
from quintrig.exchange.export import export
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.recognise import Bare
from quintrig.model.patch import Patch
from quintrig.report.write import write_report
from quintrig.shaping.shape_effect import standard_shapes
from quintrig.support.errors import QuintrigError
from quintrig.sweep.part import Task
from quintrig.sweep.space import Axis, DesignSpace

AXES = DesignSpace((Axis("alpha1", 0.0, 1.0, 2),))


def odd():
    """Return a surface whose rows are trigonometric and whose blend is a B-spline, as no kind has it."""
    one = quintrig.tensor([[[i, j, 0.1 * i * j] for j in range(6)] for i in range(6)])
    return Surface(
        Net(one.rows.points, one.rows.functions), BSpline((0.0, 0.0, 0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0), 2)
    )


@pytest.mark.parametrize("name", SURFACES)
def test_a_bare_surface_has_the_definition_that_builds_it(name):
    surface = SURFACES[name].surface()
    for patch in (Patch("a", None, surface), Patch.of(surface, "a")):
        assert isinstance(patch.definition, Definition)
        again = patch.definition.surface()
        np.testing.assert_allclose(again(0.3, 0.6), surface(0.3, 0.6), rtol=0, atol=1e-12 * surface.size)
        assert again.sign * np.cross(*again.partials(0.3, 0.6, 1)[[1, 0], [0, 1]])[2] == pytest.approx(
            surface.sign * np.cross(*surface.partials(0.3, 0.6, 1)[[1, 0], [0, 1]])[2], rel=1e-9, abs=1e-9
        )
        assert Model("a", "mm", (patch,)).to_dict()["kind"] == patch.kind


def one_line(error):
    text = str(error.value)
    assert "\n" not in text
    assert "AttributeError" not in text
    return text


def test_a_surface_of_no_kind_says_what_it_cannot(tmp_path):
    patch = Patch.of(odd(), "odd")
    model = Model("odd", "mm", (patch,))
    assert isinstance(patch.definition, Bare)
    assert (patch.kind, patch.shape) == ("surface", ())
    assert repr(model) == "<Model 'odd' in mm: 'odd' (surface)>"
    for attempt in (
        model.to_dict,
        lambda: quintrig.save(model, tmp_path / "a.toml"),
        lambda: export(model, tmp_path / "a.json"),
        lambda: write_report(model, tmp_path / "page"),
        lambda: export(model, tmp_path / "a.csv"),
        lambda: standard_shapes(patch),
        lambda: patch.with_parameters({"alpha1": 0.0}),
        lambda: patch.with_shape([0, 0, 0, 0]),
    ):
        with pytest.raises((ModelError, QuintrigError)) as error:
            attempt()
        assert "surface" in one_line(error)
    assert not list(tmp_path.iterdir())
    assert export(model, tmp_path / "a.stl").paths == (tmp_path / "a.stl",)


@pytest.fixture
def face(tmp_path):
    """Return a model of a trimmed face of a CAD file."""
    pytest.importorskip("OCP", reason="needs the extra cad: pip install 'quintrig[cad]'")
    from quintrig.exchange.imports import open_model
    from test_cad import trimmed_step

    trimmed_step(tmp_path / "face.step")
    return open_model(tmp_path / "face.step")


def test_a_face_of_a_cad_file_is_written_with_its_loops(face, tmp_path):
    assert face.patch().definition.trim
    for name in ("a.toml", "a.json"):
        assert quintrig.load(quintrig.save(face, tmp_path / name)).to_dict() == face.to_dict()
        assert quintrig.load(export(face, tmp_path / f"b{name}").paths[0]).to_dict() == face.to_dict()
    assert Patch.of(face.surface).definition.trim == face.patch().definition.trim


def test_a_face_of_a_cad_file_is_reported_and_says_that_it_does_not_vary(face, tmp_path):
    assert "trimmed" in write_report(face, tmp_path / "page", grid=9).read_text(encoding="utf-8")
    with pytest.raises(ModelError) as error:
        standard_shapes(face.patch())
    assert one_line(error).endswith("a nurbs has no shape parameters to vary")
    with pytest.raises(ValueError, match="a nurbs has no parameters to vary") as error:
        Task(face.to_dict(), None, AXES)
    one_line(error)


@pytest.mark.parametrize(
    "made",
    [
        lambda: quintrig.Curve([[0, 0], [1, 1], [2, 1], [3, 1], [4, 1], [5, 0]], 0.5, -1),
        lambda: quintrig.Curve([[0, 0, 1], [1, 1, 2]], basis="bernstein"),
        quintrig.torus,
        lambda: quintrig.torus().rows,
        lambda: quintrig.analyse(quintrig.torus(), *quintrig.grid(9, 9)),
        lambda: quintrig.summarise(quintrig.torus(), "mm", samples=9),
        lambda: quintrig.developable(CALM, LEVEL).rows,
        lambda: quintrig.regression(quintrig.developable(CALM, LEVEL)),
        lambda: quintrig.compare_methods(quintrig.torus(), 9, 9),
        lambda: Patch.of(quintrig.torus()),
        lambda: Model.from_dict({"kind": "torus"}),
    ],
)
def test_it_says_what_it_is_in_one_line(made):
    said = repr(made())
    assert "\n" not in said
    assert said.startswith("<")
    assert 10 < len(said) < 160
