"""Draw the pictures of the README and the guide: ``python docs/make_pictures.py``."""

from pathlib import Path

import quintrig
from quintrig.figure import Scene, comparison, panels, save, space_picture

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


if __name__ == "__main__":
    main()
