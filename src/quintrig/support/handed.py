"""What surfaces and models hand to other tools: each method asks for the work that a room above registered."""

from collections.abc import Iterable, Sequence
from typing import Any, Literal

from quintrig.support import late


class Handed:
    """Gives a value its ``to_...`` methods; who does the work is registered in the package's root."""

    def to_pyvista(self, *, points: tuple[int, int] = (65, 65), quantities: Iterable[str] | str | None = None) -> Any:
        """Return a pyvista.StructuredGrid with every quantity as array, of a model a MultiBlock of them by name.

        ``points`` (nu, nv) sets the grid, by default 65 x 65; ``quantities`` (keys or symbols) what is computed, by
        default everything. Points of a trimmed face's outside are hidden. Lengths are the model's. Raises
        QuintrigError without PyVista (the extra ``tools``), ValueError for a grid that cannot be.
        """
        return late.call("to_pyvista", self, points=points, quantities=quantities)

    def to_build123d(self) -> Any:
        """Return a build123d.Face of the exact rational form, of several patches a Shell or Compound sewn from them.

        build123d takes lengths for millimetres and no unit is converted. A surface without a rational form is fitted
        as in ``export``. Raises QuintrigError without build123d (the extra ``tools``), ValueError for trimmed faces.
        """
        return late.call("to_build123d", self)

    def to_trimesh(
        self,
        *,
        tolerance: float | None = None,
        grid: tuple[int, int] | None = None,
        quantities: Sequence[str] | str | None = None,
    ) -> Any:
        """Return a trimesh.Trimesh with normals, u, v and quantities at its vertices, welded along shared edges.

        ``tolerance`` (length¹), ``grid`` and ``quantities`` are those of ``quintrig export`` to mesh files. Raises
        QuintrigError without trimesh (the extra ``tools``), ValueError for what cannot be met.
        """
        return late.call("to_trimesh", self, tolerance=tolerance, grid=grid, quantities=quantities)

    def to_compas(
        self,
        *,
        form: Literal["mesh", "nurbs"] = "mesh",
        tolerance: float | None = None,
        grid: tuple[int, int] | None = None,
        quantities: Sequence[str] | str | None = None,
    ) -> Any:
        """Return a compas.datastructures.Mesh with normals, u, v and quantities as attributes of its vertices.

        Takes what ``to_trimesh`` takes. ``form="nurbs"`` returns instead the data of a compas.geometry.NurbsSurface:
        a dict, of a model one for each patch by name, that COMPAS's back ends for NURBS read. Raises QuintrigError
        without COMPAS (the extra ``tools``), ValueError for what cannot be met.
        """
        return late.call("to_compas", self, form=form, tolerance=tolerance, grid=grid, quantities=quantities)

    def to_rhino3dm(self) -> Any:
        """Return a rhino3dm.NurbsSurface, exact where a rational form exists; of a model a dict of them by name.

        A surface without a rational form is fitted as in ``export``; trim loops stay behind. Raises QuintrigError
        without rhino3dm (the extra ``cad``), ValueError for a surface that is a single point.
        """
        return late.call("to_rhino3dm", self)
