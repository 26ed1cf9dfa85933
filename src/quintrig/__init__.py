"""quintrig: build quintic trigonometric Bézier surfaces, read their curvature, decide.

Names are loaded on first use, so that ``import quintrig`` costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from quintrig.agreement import compare_methods as compare_methods
    from quintrig.classify import Thresholds as Thresholds
    from quintrig.construct import ruled as ruled
    from quintrig.construct import swept as swept
    from quintrig.construct import swung as swung
    from quintrig.construct import symmetric as symmetric
    from quintrig.construct import tensor as tensor
    from quintrig.curve import Curve as Curve
    from quintrig.envelope import developable as developable
    from quintrig.envelope import regression as regression
    from quintrig.errors import ModelError as ModelError
    from quintrig.extremes import find_extremes as find_extremes
    from quintrig.hull import check_curve_hull as check_curve_hull
    from quintrig.hull import check_hull as check_hull
    from quintrig.integrate import integrals as integrals
    from quintrig.model import Model as Model
    from quintrig.model import load as load
    from quintrig.reference import catenoid as catenoid
    from quintrig.reference import cone as cone
    from quintrig.reference import cylinder as cylinder
    from quintrig.reference import ellipsoid as ellipsoid
    from quintrig.reference import enneper as enneper
    from quintrig.reference import helicoid as helicoid
    from quintrig.reference import hyperbolic_paraboloid as hyperbolic_paraboloid
    from quintrig.reference import monkey_saddle as monkey_saddle
    from quintrig.reference import sphere as sphere
    from quintrig.reference import torus as torus
    from quintrig.sample import Sample as Sample
    from quintrig.sample import analyse as analyse
    from quintrig.sample import grid as grid
    from quintrig.stream import analyse_blocks as analyse_blocks
    from quintrig.summary import summarise as summarise
    from quintrig.surface import Surface as Surface

__version__ = "0.1.0"

_HOME = {
    "agreement": ("compare_methods",),
    "extremes": ("find_extremes",),
    "hull": ("check_curve_hull", "check_hull"),
    "integrate": ("integrals",),
    "summary": ("summarise",),
    "stream": ("analyse_blocks",),
    "classify": ("Thresholds",),
    "construct": ("ruled", "swept", "swung", "symmetric", "tensor"),
    "curve": ("Curve",),
    "envelope": ("developable", "regression"),
    "errors": ("ModelError",),
    "model": ("Model", "load"),
    "reference": (
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
    "sample": ("Sample", "analyse", "grid"),
    "surface": ("Surface",),
}
_WHERE = {name: module for module, names in _HOME.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module 'quintrig' has no attribute {name!r}")
    value = getattr(import_module(f"quintrig.{_WHERE[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*sorted(_WHERE), "__version__"]
