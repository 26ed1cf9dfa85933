"""Write examples/body.toml, the front left quarter of a car: ``python docs/make_body.py``.

Lengths in mm: x to the back, y to the side, z up; y = 0 is the middle of the car. Front, fender and door are one grid
of patches, G2 throughout, of which those under the cabin are left out; windshield and roof are another, held to the
hood.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

import quintrig
from quintrig import Model

HERE = Path(__file__).parent

# Stations from the bumper's lip over hood and cowl along the door; at each the points from the middle of the car to the
# edge of the hood, the shoulder and the waist. The last point, on the wheel arch or the sill, is worked out below.
STATIONS = [
    [(-60, 0, 235), (-32, 310, 235), (55, 565, 232), (150, 690, 230), (245, 752, 228)],
    [(-92, 0, 430), (-62, 310, 428), (36, 578, 418), (136, 704, 396), (238, 770, 366)],
    [(-24, 0, 640), (4, 310, 632), (96, 580, 612), (190, 712, 576), (275, 786, 528)],
    [(330, 0, 765), (340, 310, 757), (368, 605, 738), (400, 765, 704), (430, 822, 652)],
    [(720, 0, 852), (722, 330, 845), (730, 640, 830), (735, 806, 800), (740, 852, 738)],
    [(930, 0, 888), (930, 340, 880), (930, 656, 863), (930, 816, 828), (930, 858, 762)],
    [(1110, 0, 915), (1110, 350, 905), (1110, 668, 884), (1110, 820, 848), (1110, 862, 772)],
    [(1220, 0, 925), (1220, 350, 918), (1220, 673, 892), (1220, 823, 855), (1215, 865, 776)],
    [(1480, 0, 943), (1480, 350, 937), (1480, 680, 908), (1480, 826, 866), (1480, 868, 783)],
    [(1790, 0, 958), (1790, 350, 953), (1790, 684, 920), (1790, 828, 876), (1790, 870, 788)],
    [(2400, 0, 975), (2400, 350, 970), (2400, 685, 934), (2400, 826, 886), (2400, 868, 792)],
]
ANGLES = (194.0, 176.0, 153.0, 123.0, 90.0, 48.0, 10.0)
FLARE = (775.0, 792.0, 816.0, 842.0, 864.0, 870.0, 866.0)
SILL = [(1150.0, 858.0, 246.0), (1460.0, 852.0, 228.0), (1790.0, 850.0, 232.0), (2400.0, 848.0, 236.0)]
HUB, ARCH, LIP = (740.0, 310.0), 345.0, 45.0
CABIN = [
    [(1110, 0, 915), (1110, 350, 905), (1110, 668, 884)],
    [(1300, 0, 1038), (1301, 345, 1026), (1305, 650, 992)],
    [(1500, 0, 1152), (1502, 338, 1138), (1508, 632, 1094)],
    [(1760, 0, 1274), (1762, 330, 1259), (1768, 610, 1210)],
    [(2400, 0, 1376), (2400, 328, 1361), (2400, 590, 1308)],
]
HEAD = """# The front left quarter of a car in 56 patches, written by docs/make_body.py: hood, fender and door G2, the
# cabin held to the hood by [[join]] tables, windows G0. Seams: quintrig joins body.toml. The other half:
# quintrig mirror body.toml --plane y=0 --order G2 -o half.toml.

"""
COWL = 6  # station at which the cabin begins


def points() -> np.ndarray:
    """Return the grid of the lower body: the stations, each with its point on the arch or the sill."""
    arch = [
        (HUB[0] + ARCH * np.cos(np.radians(a)), y, HUB[1] + ARCH * np.sin(np.radians(a)))
        for a, y in zip(ANGLES, FLARE, strict=True)
    ]
    return np.array([[*station, low] for station, low in zip(STATIONS, [*arch, *SILL], strict=True)])


def grid(name: str, through: object) -> list[quintrig.model.patch.Patch]:
    """Return patches through points, G2, called after the panel: hood-12 is the second of the first row."""
    made = quintrig.grid_of_patches(np.array(through, dtype=float)).patches
    return [replace(one, name=f"{name}-{one.name[1:].replace('_', '')}") for one in made]


def lower() -> list[quintrig.model.patch.Patch]:
    """Return hood, fender and door: what lies under the cabin is left out."""
    result: list[quintrig.model.patch.Patch] = []
    for patch in quintrig.grid_of_patches(points()).patches:
        i, j = map(int, patch.name[1:].split("_"))
        if i > COWL and j > 3:
            result.append(replace(patch, name=f"door-{i - COWL}{j - 3}"))
        elif i <= COWL:
            panel = "nose" if i < 3 and j < 4 else "hood" if j < 3 else "fender"
            result.append(replace(patch, name=f"{panel}-{i}{j}"))
    return result


def body() -> Model:
    """Return the quarter."""
    model = Model("car body, front left quarter", "mm", (*lower(), *grid("roof", CABIN)))
    for k in (1, 2):
        model = quintrig.join(model, f"hood-6{k}:u1", f"roof-1{k}:u0", "G0", hold=True)
    for k in (1, 2, 3, 4):
        model = quintrig.blend(model, f"roof-{k}2:v1", f"door-{k}1:v0", "G0", name=f"window-{k}")
    return lips(quintrig.join(model, "fender-63:u1", "window-1:v0", "G0"))


def lips(model: Model) -> Model:
    """Return the model with the edge of the arch turned inwards."""
    for k in range(1, COWL + 1):
        name = f"fender-{k}5"
        rim = np.asarray(model.patch(name).surface.net)[:, -1]
        strip = quintrig.ruled(rim, rim - [0.0, LIP, 0.0])
        model = replace(model, patches=(*model.patches, quintrig.model.patch.Patch.of(strip, f"lip-{k}")))
    return model


if __name__ == "__main__":
    made = body()
    keys = made.to_dict()
    for table in keys["patch"]:
        for key in ("points", "first", "second"):
            if key in table:
                table[key] = (np.round(table[key], 6) + 0.0).tolist()  # no -0.0
    path = HERE.parent / "examples" / "body.toml"
    path.unlink(missing_ok=True)
    quintrig.save(Model.from_dict(keys), path)
    path.write_text(HEAD + path.read_text(encoding="utf-8"), encoding="utf-8")
