"""``quintrig fit``: a surface or a curve through measured points."""

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from quintrig.cli import session
from quintrig.cli.deviation import PICTURES, TargetFace, Unit, read_target
from quintrig.cli.deviation import write as write_deviation
from quintrig.cli.options import Force

if TYPE_CHECKING:
    from quintrig.shaping.fitting.result import Fit

_EPILOG = session.examples(
    ("quintrig fit scan.ply -o skin.toml", "the tensor-product surface nearest to the points"),
    ("quintrig fit scan.csv -o skin.toml --shape free --json", "its shape parameters too, with their intervals"),
    ("quintrig fit scan.csv -o lid.toml --kind swept --basis cubic", "another kind, on another basis"),
    ("quintrig fit scan.csv -o body.toml --patches 2x3 --join G2", "six patches that join with equal curvature"),
    ("quintrig fit part.step --face 3 -o face.toml --tolerance 0.01", "a CAD face, in as many patches as it takes"),
    ("quintrig fit pin.xyz -o pin.toml --kind cylinder", "radius, axis and place of a cylinder"),
    ("quintrig fit naca2412.dat -o foil.toml --kind curve", "an aerofoil, as an upper and a lower curve"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, fit, _EPILOG)


def fit(
    target: Annotated[
        Path,
        typer.Argument(
            metavar="TARGET",
            help="Points or mesh: .csv .xyz .txt .asc .pts .dat .ply .obj .stl; or a CAD file, or a model.",
            show_default=False,
        ),
    ],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="MODEL", help="Model to write, .toml or .json.")
    ] = None,
    kind: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="tensor, symmetric, swept, swung, ruled, plane, sphere, cylinder, cone, torus or curve; "
            "by itself tensor, of points in the plane curve.",
        ),
    ] = None,
    basis: Annotated[
        str, typer.Option(metavar="NAME", help="Basis, or two for u and v: cubic,quintic.")
    ] = "trigonometric",
    shape: Annotated[
        str, typer.Option(metavar="fixed|free|NUMBERS", help="Shape parameters: where the basis starts, fitted, given.")
    ] = "fixed",
    size: Annotated[
        str | None, typer.Option(metavar="NxM", help="Control points each way, where the basis takes several numbers.")
    ] = None,
    patches: Annotated[str | None, typer.Option(metavar="NxM", help="A grid of patches that join.")] = None,
    join: Annotated[Literal["G1", "G2"], typer.Option(help="How smoothly they join.")] = "G2",
    boundary: Annotated[
        str,
        typer.Option(
            metavar="free|curves|FILE", help="Edges: free, drawn to the points' border, or held to a model of curves."
        ),
    ] = "free",
    smooth: Annotated[
        float, typer.Option(metavar="WEIGHT", help="Thin-plate energy beside the distances, such as 1e-6.")
    ] = 0.0,
    tolerance: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="Largest distance: takes as many patches, up to 8x8.")
    ] = None,
    mirror: Annotated[
        str | None, typer.Option(metavar="A,B,C,D", help="Plane of a symmetric surface; found by itself otherwise.")
    ] = None,
    corners: Annotated[
        str | None,
        typer.Option(
            metavar="POINTS",
            help='Four points to pass through, in turn: "0,0,0 9,0,0 9,5,1 0,5,1" at (u, v) = 0,0 1,0 1,1 0,1.',
        ),
    ] = None,
    robust: Annotated[
        bool | None, typer.Option("--robust/--no-robust", help="Leave outliers out; by itself for scans.")
    ] = None,
    unit: Unit = "",
    face: TargetFace = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON: rms, max, points, shape, ...")] = False,
    picture: Annotated[
        list[Path] | None,
        typer.Option("--deviation", metavar="FILE", help="The deviation as picture, .csv, .ply or .json. Repeatable."),
    ] = None,
    force: Force = False,
) -> None:
    """Lay a surface or a curve through measured points, by least orthogonal distances.

    It tells what it reached: rms and largest distance, outliers left out, and of free shape parameters the intervals in
    which they lie with 95 %. Points decide the surface much better than its shape parameters.
    """
    from quintrig.shaping.fit import fit as lay
    from quintrig.support.files import refuse_loss
    from quintrig.support.progress import patient

    for file in picture or []:
        if file.suffix.lower() not in (*PICTURES, ".csv", ".ply", ".json"):
            raise ValueError(f"{file}: expected a name ending in {', '.join(PICTURES)}, .csv, .ply or .json")
    if output is not None:
        if output.suffix.lower() not in (".toml", ".json"):
            raise ValueError(f"{output}: expected a name ending in .toml or .json")
        refuse_loss(output, target, force=force)
    scan = read_target(target, unit, face)
    chosen = kind or ("curve" if scan.points.shape[1] == 2 else "tensor")
    words = [word.strip() for word in basis.split(",")]
    asked: dict[str, Any] = {
        "basis": words[0] if len(words) == 1 else words,
        "shape": shape if shape in ("fixed", "free") else session.numbers(shape, None, "--shape"),
        "size": None if size is None else _pair(size, "--size", 2, 64),
        "patches": None if patches is None else _pair(patches, "--patches", 1, 16),
        "join": join,
        "boundary": _boundary(boundary),
        "smooth": smooth,
        "tolerance": tolerance,
        "robust": robust,
        "corners": None if corners is None else _points(corners, "--corners"),
        "mirror": None if mirror is None else session.numbers(mirror, 4, "--mirror"),
    }
    try:
        with session.progress() as progress:
            told = patient(progress) if sys.stderr.isatty() else None  # a fit is too short for a log
            result = lay(scan, chosen, name=output.stem if output else target.stem, progress=told, **asked)
    except ValueError as error:
        if str(error).startswith("points:"):
            raise ValueError(f"{target}: {str(error).removeprefix('points: ')}") from None
        raise
    _tell(result, as_json, output)
    if output is not None:
        from quintrig.model.save import save

        replaced = output.is_file()
        session.wrote(save(result.model, output), replaced)
    for file in picture or []:
        if result.kind == "curve" and file.suffix.lower() in PICTURES:
            raise ValueError(f"{file}: a curve's deviation is written as .csv, .ply or .json")
        write_deviation(result.deviation, file, result.model.name, target)


def _pair(text: str, name: str, least: int, most: int) -> tuple[int, int]:
    words = text.lower().replace("×", "x").split("x")
    words = words * 2 if len(words) == 1 else words
    fine = len(words) == 2 and all(word.strip().isascii() and word.strip().isdigit() for word in words)
    found = tuple(int(word) for word in words) if fine and all(len(word) < 6 for word in words) else (0, 0)
    if not all(least <= one <= most for one in found):
        raise ValueError(f"{name}: expected two numbers from {least} to {most} such as 2x3, got {text[:40]!r}")
    return found[0], found[1]


def _points(text: str, name: str) -> list[tuple[float, ...]]:
    """Read four points, separated by spaces or semicolons."""
    words = text.replace(";", " ").split()
    if len(words) != 4:
        raise ValueError(f"{name}: expected four points X,Y,Z separated by spaces, found {len(words)}")
    return [session.numbers(word, 3, name) for word in words]


def _boundary(text: str) -> Any:
    if text in ("free", "curves"):
        return text
    path = Path(text)
    if path.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"--boundary: expected free, curves or a model of curves, got {text[:60]!r}")
    model = session.load_any(path)
    if not model.curves:
        raise ValueError(f"--boundary: {text}: expected a model of curves, found surfaces")
    return [one.curve for one in model.curves]


def _tell(result: "Fit", as_json: bool, output: Path | None) -> None:
    if as_json:
        told = result.to_dict() | ({"model": str(output)} if output else {})
        session.emit(json.dumps(told, ensure_ascii=False, indent=1))
        return
    import numpy as np

    from quintrig.exchange.tables import shown

    unit = f" {result.model.unit}" if result.model.unit else ""
    console = session.output()

    def row(name: str, text: str) -> None:
        console.print(f"  [cyan]{name:<20}[/cyan]{text}", soft_wrap=True)

    grid = result.facts.get("grid", [1, 1])
    many = f", {grid[0]} x {grid[1]} patches joined {result.facts['join']}" if grid != [1, 1] else ""
    row("kind", f"{result.kind}{many}")
    row("points", f"{result.points:,}" + (f", {result.outliers:,} outliers left out" if result.outliers else ""))
    row("rms", f"{shown(result.rms)}{unit}")
    row("largest", f"{shown(result.max)}{unit}")
    if result.tolerance is not None:
        row("tolerance", f"{result.tolerance:g}{unit}: {'reached' if result.within_tolerance else 'not reached'}")
    form: dict[str, Any] = result.facts.get("form", {})
    for name, value in form.items():
        if name != "kind":
            row(name.replace("_", " "), ", ".join(shown(float(part)) for part in np.ravel(value).tolist()))
    for one in result.shape:
        row(one.name, one.describe())
    for note in result.notes:
        session.remark(note)
