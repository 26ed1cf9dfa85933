"""Moving pictures: what a parameter does to a model, seen from one place and on one scale of colour."""

import io
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from quintrig.basis.pairs import key_of, symbol
from quintrig.figure.camera import ViewName
from quintrig.figure.field import common_limits, facet_fields
from quintrig.figure.plot import CURVE_PICTURES, curve_picture, plot
from quintrig.figure.save import to_png_bytes
from quintrig.figure.scene import Scene, bounds
from quintrig.figure.space_curves import curve_traces
from quintrig.figure.style import Style, changed, style_named
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, Patch
from quintrig.quantities.drawn import read_quantities
from quintrig.support.errors import ArgumentError, QuintrigError, nearest
from quintrig.support.files import refuse_unwritable, write_whole
from quintrig.support.processes import pool
from quintrig.support.progress import Progress, watched
from quintrig.sweep.space import Axis, DesignSpace, check

KINDS = ("gif", "mp4")
"""Kinds of file, by suffix."""

MOST = 500
"""Frames of an animation."""

_DPI = 100
_CELLS = 60  # facets a side at which the scale of colour is found
_PALETTE = 8  # frames that the colours of a GIF are chosen from


@dataclass(frozen=True, eq=False)
class Animation:
    """Frames as PNG files of one size, shown at ``rate`` frames a second; ``values`` (n,) of the parameter."""

    frames: tuple[bytes, ...]
    values: tuple[float, ...]
    rate: float

    def save(self, path: str | Path) -> Path:
        """Write a .gif, or an .mp4 where ffmpeg is; QuintrigError for another suffix or where it cannot be written."""
        kind = kind_of(path)
        return write_whole(path, _gif(self) if kind == "gif" else _mp4(self))

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        """Return what a notebook shows."""
        return {"image/gif": _gif(self), "text/plain": repr(self)}

    def __repr__(self) -> str:
        """Return one line: how many frames, of which values."""
        return f"<Animation of {len(self.frames)} frames, {self.values[0]:g} to {self.values[-1]:g}>"


@watched
def animate(
    subject: Model | Patch | Surface,
    parameter: str,
    low: float | None = None,
    high: float | None = None,
    *,
    quantity: str | Sequence[str] = "surface",
    frames: int = 40,
    rate: float = 12.0,
    view: ViewName | None = None,
    net: bool | None = None,
    lines: int | str | None = None,
    style: str | Style = "standard",
    width: float | str | None = None,
    dpi: int | None = None,
    processes: int | None = 1,
    progress: Progress | None = None,
    save: str | Path | None = None,
) -> Animation:
    """Return an animation of ``plot`` while a shape parameter runs from ``low`` to ``high``, else over its whole range.

    All frames have one view, one frame around what is drawn and one scale of colour for each ``quantity``; the value
    stands at their head. Every patch or curve of a model that has the ``parameter`` follows it. ``rate`` is in frames a
    second, ``dpi`` in dots per inch, 100 if not said; ``processes`` draw at once. ``save`` writes a .gif, or an .mp4
    where ffmpeg is. Raises ValueError for what cannot be drawn, and for values that the parameter does not take.
    """
    if save is not None:
        kind_of(save)
        refuse_unwritable(Path(save))
    model = subject if isinstance(subject, Model) else _model(subject)
    if not 2 <= frames <= MOST:
        raise ArgumentError(f"expected 2 to {MOST} frames, found {frames}", "frames")
    if not 0.1 <= rate <= 60.0:
        raise ArgumentError(f"expected 0.1 to 60 frames a second, found {rate:g}", "rate")
    parameter = key_of(parameter)
    axis = _axis(model, parameter, low, high, frames)
    designs = [_design(model, parameter, float(value)) for value in axis.values]
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    chosen = changed(style_named(style) if isinstance(style, str) else style)
    shown = _fixed(
        designs, names, Scene(net=bool(chosen.net if net is None else net)), chosen, curves=not model.patches
    )
    # Texts of one length: the picture below them does not move.
    decimals = max(0, 1 - int(np.floor(np.log10((axis.high - axis.low) / (frames - 1)))))
    widest = max(len(f"{value:.{decimals}f}") for value in axis.values)
    options: dict[str, Any] = {"view": view, "net": net, "lines": lines, "style": shown, "width": width}
    drawn: list[bytes] = []
    with pool(processes) as workers:
        texts = [f"{symbol(parameter)} = {value:{widest}.{decimals}f}" for value in axis.values]
        heads = [f"{model.name}: {text}" if chosen.title else text for text in texts]
        waiting = [
            workers.submit(_frame, design, names, dpi or chosen.dpi or _DPI, {**options, "heading": head})
            for design, head in zip(designs, heads, strict=True)
        ]
        try:
            for text, future in zip(texts, waiting, strict=True):
                if progress:
                    progress(text, len(drawn), frames)
                drawn.append(future.result())
        finally:
            workers.shutdown(wait=False, cancel_futures=True)
    found = Animation(_one_size(drawn), tuple(axis.values.tolist()), rate)
    if save is not None:
        found.save(save)
    return found


def kind_of(path: str | Path) -> str:
    """Return gif or mp4; QuintrigError for another suffix, and for mp4 where there is no ffmpeg."""
    kind = Path(path).suffix.lower().removeprefix(".")
    if kind not in KINDS:
        found = f"the suffix '.{kind}'" if kind else "no suffix"
        raise QuintrigError(f"{path}: expected, of an animation, a file name ending in .gif or .mp4, found {found}")
    if kind == "mp4" and shutil.which("ffmpeg") is None:
        raise QuintrigError(f"{path}: ffmpeg, which writes .mp4, is not installed; install it, or write a .gif")
    return kind


def _model(subject: Patch | Surface) -> Model:
    patch = subject if isinstance(subject, Patch) else Patch.of(subject)
    return Model(patch.name, "", (patch,))


def _parts(model: Model) -> tuple[Patch | NamedCurve, ...]:
    return model.patches or model.curves


def _axis(model: Model, name: str, low: float | None, high: float | None, frames: int) -> Axis:
    """Return the values of a parameter, checked against every part that has it."""
    having = [part for part in _parts(model) if name in part.definition.parameters]
    if not having:
        known = list(dict.fromkeys(word for part in _parts(model) for word in part.definition.parameters))
        has = f"expected one of {', '.join(known)}" if known else "the model has no parameters to vary"
        raise ArgumentError(f"unknown parameter{nearest(name, known)}; {has}", "animate", name)
    try:
        one = having[0].definition.ranges.get(name)
        if one is None and (low is None or high is None):
            raise ArgumentError(f"a range is needed; write {name}=LOW:HIGH", "animate", name)
        first, last = one.low if one and low is None else low, one.high if one and high is None else high
        start, end = float(first or 0.0), float(last or 0.0)
        if start >= end:
            better = f"write {name}={end:g}:{start:g}" if end < start else "give two different ends"
            raise ArgumentError(f"the range does not rise; {better}", "animate", f"{name}={start:g}:{end:g}")
        axis = Axis(name, start, end, frames)
        for part in having:
            check(DesignSpace((axis,)), (part,))
    except ArgumentError as error:
        value = error.telling.value.removesuffix(f":{frames}")
        raise ArgumentError(error.telling.message, "animate", value) from None
    return axis


def _design(model: Model, name: str, value: float) -> Model:
    """Return the model with the parameter at a value, in every part that has it."""
    for patch in model.patches:
        if name in patch.definition.parameters:
            model = model.with_patch(model.patch(patch.name).with_parameters({name: value}))
    if model.patches:
        return model
    curves = (one.with_parameters({name: value}) if name in one.definition.acting else one for one in model.curves)
    return replace(model, curves=tuple(curves))


def _fixed(designs: Sequence[Model], names: Sequence[str], scene: Scene, style: Style, *, curves: bool) -> Style:
    """Return a style that holds the scales and the frame of all designs together, with the value at the head."""
    if curves:
        return _fixed_curves(designs, names, replace(style, title=True))
    surfaces = [patch.surface for design in designs for patch in design.patches]
    traces = curve_traces([one.curve for one in designs[0].curves])
    low, high = bounds(surfaces, replace(scene, traces=tuple(traces)))
    scales: dict[str, Any] = {}
    for key in [] if list(names) == ["zebra"] else read_quantities(names):
        found = common_limits(facet_fields(surfaces, key, _CELLS), style)
        if key is not None and found is not None:
            scales[key] = found
    return replace(style, title=True, scales=scales, box=(tuple(low.tolist()), tuple(high.tolist())))


def _fixed_curves(designs: Sequence[Model], names: Sequence[str], style: Style) -> Style:
    what = curve_picture(names, [name for name in CURVE_PICTURES if name != "comb"], "moving curves")
    every = [one.curve for design in designs for one in design.curves]
    t = np.linspace(0.0, 1.0, 201)
    if what in ("curvature", "torsion"):
        plane = every[0].points.shape[1] == 2
        if what == "torsion":
            values = np.array([[0.0]] if plane else [curve.torsion(t) for curve in every])
        else:
            values = np.array([curve.signed_curvature(t) if plane else curve.curvature(t) for curve in every])
        finite = values[np.isfinite(values)]
        low, high = (float(end) for end in (min(finite.min(), 0.0), max(finite.max(), 0.0)))
        rim = 0.05 * (high - low) or 1.0
        return replace(style, limits=style.limits or (low - rim, high + rim))
    cloud = np.concatenate([np.concatenate([curve(t), curve.points]) for curve in every])
    return replace(style, box=(tuple(cloud.min(axis=0).tolist()), tuple(cloud.max(axis=0).tolist())))


def _frame(design: Model, names: Sequence[str], dpi: int, options: dict[str, Any]) -> bytes:
    return to_png_bytes(plot(design, names, **options), dpi)


def _one_size(frames: Sequence[bytes]) -> tuple[bytes, ...]:
    """Return frames with white below where notes have fewer lines: pictures are laid out from the top."""
    pictures = [Image.open(io.BytesIO(frame)).convert("RGB") for frame in frames]
    # Films have an even number of dots each way.
    width, height = (2 * -(-max(sizes) // 2) for sizes in zip(*(one.size for one in pictures), strict=True))
    sized: list[bytes] = []
    for picture in pictures:
        sheet, buffer = Image.new("RGB", (width, height), "white"), io.BytesIO()
        sheet.paste(picture)
        sheet.save(buffer, "PNG")
        sized.append(buffer.getvalue())
    return tuple(sized)


def _gif(found: Animation) -> bytes:
    """Return a GIF that repeats, all of its frames in the same 256 colours."""
    pictures = [Image.open(io.BytesIO(frame)) for frame in found.frames]
    width, height = pictures[0].size
    chosen = sorted({round(part * (len(pictures) - 1) / (_PALETTE - 1)) for part in range(_PALETTE)})
    some = [pictures[i] for i in chosen]
    montage = Image.new("RGB", (width, height * len(some)))
    for index, picture in enumerate(some):
        montage.paste(picture, (0, index * height))
    palette = montage.quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)  # rare strong ones too
    first, *others = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    buffer = io.BytesIO()
    # Equal frames are kept: there are as many as were asked for.
    each = [round(1000.0 / found.rate)] * len(pictures)
    first.save(buffer, "GIF", save_all=True, append_images=others, duration=each, loop=0, optimize=False)
    return buffer.getvalue()


def _mp4(found: Animation) -> bytes:
    """Return a film in H.264 that browsers and slides show."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "film.mp4"
        told = _ffmpeg(found.frames, ["-framerate", f"{found.rate:g}", "-i", "-"], out)
        if told or not out.exists():
            raise QuintrigError(f"ffmpeg could not write the film ({told or 'no reason given'}); write a .gif")
        return out.read_bytes()


def _ffmpeg(frames: Iterable[bytes], how: Sequence[str], out: Path) -> str:
    """Feed frames to ffmpeg and return the last line of what it complains of, empty where it does not."""
    words = ["ffmpeg", "-loglevel", "error", "-f", "image2pipe", "-c:v", "png", *how]
    words += ["-pix_fmt", "yuv420p", "-movflags", "+faststart", str(out)]
    done = subprocess.run(words, input=b"".join(frames), capture_output=True, check=False)
    lines = done.stderr.decode(errors="replace").strip().splitlines()
    return (lines[-1] if lines else "it failed") if done.returncode else ""
