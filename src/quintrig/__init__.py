"""quintrig: build quintic trigonometric Bézier surfaces, read their curvature, decide.

Names are loaded on first use, so that ``import quintrig`` costs next to nothing.
"""

from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from quintrig.support import display, late

if TYPE_CHECKING:
    from quintrig.analysis.agreement import compare_methods as compare_methods
    from quintrig.analysis.measured import find_extremes as find_extremes
    from quintrig.analysis.measured import integrals as integrals
    from quintrig.analysis.proofs import bounds as bounds
    from quintrig.analysis.proofs import prove as prove
    from quintrig.analysis.sample import Sample as Sample
    from quintrig.analysis.sample import analyse as analyse
    from quintrig.analysis.stream import analyse_blocks as analyse_blocks
    from quintrig.analysis.summary import summarise as summarise
    from quintrig.builders.cap import cap as cap
    from quintrig.builders.fill import fill as fill
    from quintrig.builders.grid import grid_of_patches as grid_of_patches
    from quintrig.builders.mirror import mirror as mirror
    from quintrig.builders.strips import blend as blend
    from quintrig.builders.strips import extend as extend
    from quintrig.developables.regression import regression as regression
    from quintrig.developables.unroll import Sheet as Sheet
    from quintrig.developables.unroll import unroll as unroll
    from quintrig.enclosures.convex_hull import check_curve_hull as check_curve_hull
    from quintrig.enclosures.convex_hull import check_hull as check_hull
    from quintrig.enclosures.search import Bounds as Bounds
    from quintrig.enclosures.verdicts import Verdict as Verdict
    from quintrig.exchange.export import export as export
    from quintrig.exchange.imports import open_model as open_model
    from quintrig.exchange.lines import write_lines as write_lines
    from quintrig.exchange.scans import read_scan as read_scan
    from quintrig.exchange.tools.from_build123d import from_build123d as from_build123d
    from quintrig.exchange.tools.from_compas import from_compas as from_compas
    from quintrig.exchange.tools.from_pyvista import from_pyvista as from_pyvista
    from quintrig.exchange.tools.from_trimesh import from_trimesh as from_trimesh
    from quintrig.figure.animate import Animation as Animation
    from quintrig.figure.animate import animate as animate
    from quintrig.figure.plot import plot as plot
    from quintrig.figure.style import Style as Style
    from quintrig.geometry.closed_forms import catenoid as catenoid
    from quintrig.geometry.closed_forms import cone as cone
    from quintrig.geometry.closed_forms import cylinder as cylinder
    from quintrig.geometry.closed_forms import ellipsoid as ellipsoid
    from quintrig.geometry.closed_forms import enneper as enneper
    from quintrig.geometry.closed_forms import helicoid as helicoid
    from quintrig.geometry.closed_forms import hyperbolic_paraboloid as hyperbolic_paraboloid
    from quintrig.geometry.closed_forms import monkey_saddle as monkey_saddle
    from quintrig.geometry.closed_forms import sphere as sphere
    from quintrig.geometry.closed_forms import torus as torus
    from quintrig.geometry.constructions import ruled as ruled
    from quintrig.geometry.constructions import swept as swept
    from quintrig.geometry.constructions import swung as swung
    from quintrig.geometry.constructions import symmetric as symmetric
    from quintrig.geometry.constructions import tensor as tensor
    from quintrig.geometry.curve import Curve as Curve
    from quintrig.geometry.curve_joins import interpolate as interpolate
    from quintrig.geometry.curve_joins import join_curves as join_curves
    from quintrig.geometry.curve_pieces import offset_curve as offset_curve
    from quintrig.geometry.curve_pieces import split_curve as split_curve
    from quintrig.geometry.domain import grid as grid
    from quintrig.geometry.envelope import developable as developable
    from quintrig.geometry.exact import exact_surface as exact_surface
    from quintrig.geometry.surface import Surface as Surface
    from quintrig.interrogation.find import lines as lines
    from quintrig.interrogation.line import Line as Line
    from quintrig.interrogation.line import Lines as Lines
    from quintrig.interrogation.named import asymptotic_lines as asymptotic_lines
    from quintrig.interrogation.named import curvature_lines as curvature_lines
    from quintrig.interrogation.named import geodesic as geodesic
    from quintrig.interrogation.named import isophotes as isophotes
    from quintrig.interrogation.named import parabolic_lines as parabolic_lines
    from quintrig.interrogation.named import reflection_lines as reflection_lines
    from quintrig.interrogation.named import ridges as ridges
    from quintrig.interrogation.named import section as section
    from quintrig.interrogation.named import silhouettes as silhouettes
    from quintrig.interrogation.umbilic import Umbilics as Umbilics
    from quintrig.interrogation.umbilics import umbilics as umbilics
    from quintrig.model.model import Model as Model
    from quintrig.model.model import load as load
    from quintrig.model.save import save as save
    from quintrig.multipatch.attach import join as join
    from quintrig.multipatch.find import find_joins as find_joins
    from quintrig.multipatch.joins import Joins as Joins
    from quintrig.quantities.classify import Thresholds as Thresholds
    from quintrig.scan.curvature import ScanCurvature as ScanCurvature
    from quintrig.scan.curvature import scan_curvature as scan_curvature
    from quintrig.scan.deviation import Deviation as Deviation
    from quintrig.scan.deviation import deviation as deviation
    from quintrig.scan.scan import Scan as Scan
    from quintrig.shaping.design import Design as Design
    from quintrig.shaping.design import design as design
    from quintrig.shaping.fair import fair as fair
    from quintrig.shaping.fair_curve import fair_curve as fair_curve
    from quintrig.shaping.fairing import Fairing as Fairing
    from quintrig.shaping.fit import fit as fit
    from quintrig.shaping.fitting.result import Fit as Fit
    from quintrig.shaping.strip import Strip as Strip
    from quintrig.shaping.strip import strip as strip
    from quintrig.shaping.strips import Strips as Strips
    from quintrig.shaping.strips import strips as strips
    from quintrig.support.errors import ModelError as ModelError

__version__ = "0.2.0"

_HOME = {
    "analysis.agreement": ("compare_methods",),
    "analysis.measured": ("find_extremes", "integrals"),
    "enclosures.convex_hull": ("check_curve_hull", "check_hull"),
    "enclosures.search": ("Bounds",),
    "enclosures.verdicts": ("Verdict",),
    "analysis.proofs": ("bounds", "prove"),
    "analysis.summary": ("summarise",),
    "analysis.stream": ("analyse_blocks",),
    "quantities.classify": ("Thresholds",),
    "geometry.constructions": ("ruled", "swept", "swung", "symmetric", "tensor"),
    "geometry.curve": ("Curve",),
    "geometry.curve_joins": ("interpolate", "join_curves"),
    "geometry.curve_pieces": ("offset_curve", "split_curve"),
    "geometry.envelope": ("developable",),
    "geometry.exact": ("exact_surface",),
    "developables.regression": ("regression",),
    "developables.unroll": ("Sheet", "unroll"),
    "exchange.export": ("export",),
    "exchange.imports": ("open_model",),
    "exchange.lines": ("write_lines",),
    "exchange.tools.from_build123d": ("from_build123d",),
    "exchange.tools.from_compas": ("from_compas",),
    "exchange.tools.from_pyvista": ("from_pyvista",),
    "exchange.tools.from_trimesh": ("from_trimesh",),
    "interrogation.find": ("lines",),
    "interrogation.line": ("Line", "Lines"),
    "interrogation.named": (
        "asymptotic_lines",
        "curvature_lines",
        "geodesic",
        "isophotes",
        "parabolic_lines",
        "reflection_lines",
        "ridges",
        "section",
        "silhouettes",
    ),
    "interrogation.umbilic": ("Umbilics",),
    "interrogation.umbilics": ("umbilics",),
    "exchange.scans": ("read_scan",),
    "scan.curvature": ("ScanCurvature", "scan_curvature"),
    "scan.deviation": ("Deviation", "deviation"),
    "scan.scan": ("Scan",),
    "shaping.fit": ("fit",),
    "shaping.fitting.result": ("Fit",),
    "support.errors": ("ModelError",),
    "model.model": ("Model", "load"),
    "model.save": ("save",),
    "builders.cap": ("cap",),
    "builders.fill": ("fill",),
    "builders.grid": ("grid_of_patches",),
    "builders.mirror": ("mirror",),
    "builders.strips": ("blend", "extend"),
    "multipatch.attach": ("join",),
    "multipatch.find": ("find_joins",),
    "multipatch.joins": ("Joins",),
    "geometry.closed_forms": (
        "catenoid",
        "cone",
        "cylinder",
        "ellipsoid",
        "enneper",
        "helicoid",
        "hyperbolic_paraboloid",
        "monkey_saddle",
        "sphere",
        "torus",
    ),
    "analysis.sample": ("Sample", "analyse"),
    "figure.animate": ("Animation", "animate"),
    "figure.plot": ("plot",),
    "figure.style": ("Style",),
    "geometry.domain": ("grid",),
    "shaping.design": ("Design", "design"),
    "shaping.fair": ("fair",),
    "shaping.fair_curve": ("fair_curve",),
    "shaping.fairing": ("Fairing",),
    "shaping.strip": ("Strip", "strip"),
    "shaping.strips": ("Strips", "strips"),
    "geometry.surface": ("Surface",),
}


def _hand(name: str, value: Any, **options: Any) -> Any:
    """Hand a value over to another tool by the function of its own module, imported on first use."""
    return getattr(import_module(f"quintrig.exchange.tools.{name}"), name)(value, **options)


late.register("joins", lambda *args, **words: import_module("quintrig.multipatch.find").joins_of(*args, **words))
late.register("hold", lambda *model: import_module("quintrig.multipatch.hold").hold(*model))
for _to in ("to_build123d", "to_compas", "to_pyvista", "to_rhino3dm", "to_trimesh"):
    late.register(_to, partial(_hand, _to))
late.register("foreign", lambda *given: import_module("quintrig.exchange.tools.foreign").foreign(*given))
late.register("open_model", lambda *given: import_module("quintrig.exchange.imports").open_model(*given))
late.register("open_target", lambda *given: import_module("quintrig.exchange.scans").open_target(*given))
late.register("sampled_target", lambda *given: import_module("quintrig.exchange.scans").sampled(*given))
late.register("scan_suffixes", lambda: import_module("quintrig.exchange.scans").SCAN_SUFFIXES)
display.register(lambda value: import_module("quintrig.studio.notebook").bundle(value))
_WHERE = {name: module for module, names in _HOME.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module 'quintrig' has no attribute {name!r}")
    value = getattr(import_module(f"quintrig.{_WHERE[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*sorted(_WHERE), "__version__"]
