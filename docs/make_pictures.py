"""Draw the pictures of the README and the guide: ``python docs/make_pictures.py``."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

import quintrig
from quintrig.enclosures.prove import Prover
from quintrig.enclosures.regions import regions
from quintrig.figure import Scene, comparison, panels, save, space_picture
from quintrig.figure.deviation import deviation_picture
from quintrig.figure.parallel import parallel_coordinates
from quintrig.sweep import Axis, DesignSpace, Question, Task, open_sweep, run, select

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "examples"
OUT = HERE / "images"
SHAPES = ((1, 1, 1, 1), (1, 1, -3, -3), (1, -3, 1, -3), (1, 0, -2, -3))


def main() -> None:
    """Draw all."""
    boot = quintrig.load(EXAMPLES / "car_boot.toml")
    wavy = quintrig.load(EXAMPLES / "wavy.toml")
    vault = quintrig.load(EXAMPLES / "developable.toml")
    save(space_picture(boot.surface, "mean", Scene(isolines=7), unit="mm", width=7.0), OUT / "boot_mean.png", dpi=110)
    save(
        panels(wavy.surface, ("gaussian", "hk_type", "shape_class"), unit=wavy.unit, width=10.0),
        OUT / "wavy_types.png",
        dpi=110,
    )
    titles = ["(" + ", ".join(map(str, shape)) + ")" for shape in SHAPES]
    surfaces = [boot.with_shape(shape).surface for shape in SHAPES]
    save(
        comparison(surfaces, titles, "mean", Scene(), unit="mm", columns=4, width=12.0),
        OUT / "boot_shapes.png",
        dpi=100,
    )
    save(space_picture(vault.surface, "mean", Scene(isolines=7), unit="m"), OUT / "vault_mean.png", dpi=110)
    save(quintrig.plot(boot, lines="curvature"), OUT / "boot_lines.png", dpi=110)
    lights = quintrig.lines(
        boot, "reflection", direction=(0.4, -0.5, 1), light=(0, 0, 3000), along=(1, 0, 0), spacing=300, count=21
    )
    save(quintrig.plot(boot, lines=lights), OUT / "boot_reflection.png", dpi=110)
    save(lids(boot), OUT / "sweep.png", dpi=110)
    save(measured(boot), OUT / "deviation.png", dpi=100)
    save(maps(wavy), OUT / "proof_maps.png", dpi=110)
    save(separatrices(quintrig.load(EXAMPLES / "symmetric.toml")), OUT / "umbilics.png", dpi=110)


def measured(boot: quintrig.Model) -> Figure:
    """Return the deviation of a made-up scan, with a dent of 0.4 mm, from the surface fitted to it."""
    rng = np.random.default_rng(1)
    surface = boot.surface
    u, v = rng.random((2, 4000))
    sample = quintrig.analyse(surface, u, v, ("point", "normal"))
    dent = 0.4 * np.exp(-((u - 0.6) ** 2 + (v - 0.4) ** 2) / 0.01)
    points = sample.point + (0.05 * rng.normal(size=4000) - dent)[:, None] * sample.normal
    result = quintrig.deviation(boot, quintrig.Scan(points, unit=boot.unit), tolerance=0.1)
    return deviation_picture(result, "A scan of the car boot", 9.0)


def maps(model: quintrig.Model) -> Figure:
    """Return where claims are proved, refuted and open on a patch, over its parameters."""
    colours = {"proved": "#009e73", "refuted": "#d55e00", "open": "#f0e442"}
    claims = ("gaussian > 0", "mean < 0", "curvature_radius >= 2 cm")
    figure = Figure(figsize=(10.5, 4.1), layout="constrained")
    for axes, claim in zip(np.atleast_1d(figure.subplots(1, len(claims))), claims, strict=True):
        found = regions(Prover(model.surface, model.unit), claim)
        for (u0, v0, u1, v1), state in zip(found.rectangles.tolist(), found.states, strict=True):
            axes.add_patch(Rectangle((u0, v0), u1 - u0, v1 - v0, fc=colours[state], ec="white", lw=0.3))
        axes.set(title=f"{claim}\n{len(found.states)} boxes", xlabel="u", ylabel="v", aspect="equal")
    keys = [Rectangle((0, 0), 1, 1, fc=one) for one in colours.values()]
    figure.legend(keys, list(colours), loc="outside lower center", ncols=3)
    return figure


def separatrices(model: quintrig.Model) -> Figure:
    """Return the umbilics of a patch and the lines of curvature that leave them, over its parameters."""
    figure = Figure(figsize=(5.0, 5.4), layout="constrained")
    axes = figure.subplots()
    for line in quintrig.lines(model, "curvature", umbilics=True):
        axes.plot(*line.uv.T, color="#0072b2" if line.label == "κ1" else "#cc79a7", lw=0.9)
    for kind, mark in (("star", "*"), ("lemon", "o"), ("monstar", "D")):
        places = [(one.u, one.v) for one in quintrig.umbilics(model).umbilics if one.type == kind]
        if places:
            axes.plot(*np.array(places).T, mark, color="black", ms=9 if mark == "*" else 6, label=kind, ls="none")
    axes.set(xlim=(0, 1), ylim=(0, 1), xlabel="u", ylabel="v", aspect="equal")
    figure.legend(loc="outside lower center", ncols=3)
    return figure


def lids(boot: quintrig.Model) -> Figure:
    """Return the picture of the sweep that the guide shows."""
    names = ("alpha1", "zeta1", "alpha2", "zeta2")
    space = DesignSpace(tuple(Axis(name, -3.0, 1.0, 9) for name in names))
    best = "bending_energy"
    with TemporaryDirectory() as folder:
        sweep = open_sweep(Path(folder), Task(boot.to_dict(), boot.name, space))
        run(sweep)
        rows = select(sweep, Question("gaussian_min >= -0.00003 AND curvedness_max <= 0.02", best))
    return parallel_coordinates(rows, names, boot.surface, best=best, unit=boot.unit)


if __name__ == "__main__":
    main()
