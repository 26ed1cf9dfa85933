"""Moving pictures: as many frames as asked for, from one place, on one scale, and the value in each."""

import io
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import quintrig
from cli_runner import quintrig as command

EXAMPLES = Path(__file__).parents[1] / "examples"
POINTS = [[0.0, 0], [1, 2], [2, 3], [4, 3], [5, 1], [6, 0]]
BOOT = quintrig.load(EXAMPLES / "car_boot.toml")
CURVE = quintrig.Model.from_dict({"kind": "curve", "points": POINTS})


def dots(frame):
    return np.asarray(Image.open(io.BytesIO(frame)).convert("RGB"), dtype=int)


def test_a_film_of_a_surface_has_one_view_and_one_scale(tmp_path):
    told = []
    film = quintrig.animate(
        BOOT,
        "alpha1",
        -4,
        1,
        quantity="K",
        frames=3,
        dpi=50,
        progress=lambda *x: told.append(x),
        save=tmp_path / "k.gif",
    )
    assert film.values == (-4.0, -1.5, 1.0)
    assert [text for text, *_ in told] == ["α1 = -4.0", "α1 = -1.5", "α1 =  1.0"]
    first, *others = map(dots, film.frames)
    bar = slice(int(0.83 * first.shape[1]), None)  # the colour bar with its numbers
    middle = slice(int(0.15 * first.shape[0]), int(0.85 * first.shape[0]))
    for other in others:
        assert np.array_equal(first[middle, bar], other[middle, bar])
        assert not np.array_equal(first[middle], other[middle])
        assert not np.array_equal(first[: first.shape[0] // 10], other[: first.shape[0] // 10])  # the value
    with Image.open(tmp_path / "k.gif") as gif:
        assert (gif.n_frames, gif.info["loop"]) == (3, 0)


@pytest.mark.parametrize("quantity", ["curve", "hull", "curvature"])
def test_a_film_of_a_curve_keeps_its_axes(quantity):
    frames = [dots(one) for one in quintrig.animate(CURVE, "alpha", quantity=quantity, frames=2, dpi=50).frames]
    high, wide = frames[0].shape[:2]
    numbers = np.s_[high // 6 : 3 * high // 4, : wide // 10]  # left of the curve, below the value
    assert np.array_equal(frames[0][numbers], frames[1][numbers])
    assert not np.array_equal(*frames)


def test_curves_by_themselves_and_zebra_stripes_move():
    named = CURVE.curves[0]
    for one in (named, named.curve):
        assert len(quintrig.animate(one, "alpha", quantity="κ", frames=2, dpi=30).frames) == 2
    assert len(quintrig.animate(BOOT, "alpha1", quantity="zebra", frames=2, dpi=30).frames) == 2
    with pytest.raises(ValueError, match="subject: expected a model, patch, surface or curve, found int"):
        quintrig.animate(3, "alpha1")


def test_the_last_frame_is_the_picture_of_the_last_value():
    film = quintrig.animate(
        BOOT, "zeta2", -1, 0.5, quantity="H", frames=2, dpi=40, style=quintrig.Style(limits=(-1, 1))
    )
    for value, frame in zip((-1, 0.5), film.frames, strict=True):
        shape = (*BOOT.patch().shape[:3], value)
        other = quintrig.animate(
            BOOT.with_shape(shape),
            "zeta2",
            -1,
            0.5,
            quantity="H",
            frames=2,
            dpi=40,
            style=quintrig.Style(limits=(-1, 1)),
        )
        assert frame in other.frames


@pytest.mark.parametrize("words", [(), ("--lines", "parabolic")])
def test_the_command_writes_a_film(words, tmp_path):
    film = tmp_path / "k.gif"
    told = command(
        "plot", EXAMPLES / "car_boot.toml", "-q", "K", "--animate", "zeta2=0:1", "--frames", "2", *words, "-o", film
    )
    assert told.code == 0, told.err
    assert Image.open(film).n_frames == 2


MISTAKES = {
    "alpha1=1:-4": "--animate alpha1=1:-4: the range does not rise; write alpha1=-4:1",
    "alpha1=1:1": "give two different ends",
    "alpha1=-9:1": "the range leaves [-4, 1]; narrow it",
    "alhpa1": "did you mean 'alpha1'?",
    "alpha1=nan:1": "expected a finite number",
    "alpha1=-4": "expected NAME=LOW:HIGH",
}


@pytest.mark.parametrize("text", MISTAKES)
def test_mistakes_are_told_in_one_line(text, tmp_path):
    told = command("plot", EXAMPLES / "car_boot.toml", "--animate", text, "-o", tmp_path / "k.gif")
    assert (told.code, told.err.count("\n")) == (2, 1)
    assert MISTAKES[text] in told.err


def test_stills_and_films_have_their_own_suffixes_and_frames(tmp_path, monkeypatch):
    boot = EXAMPLES / "car_boot.toml"
    for words, said in (
        (("--animate", "alpha1", "-o", "k.png"), "ending in .gif or .mp4"),
        (("-o", "k.gif"), "or --animate for a film"),
        (("--frames", "3", "-o", "k.png"), "--frames: are those of an animation"),
        (("--animate", "alpha1", "--frames", "1", "-o", "k.gif"), "--frames: expected 2 to 500"),
    ):
        assert said in command("plot", boot, *words).err
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(quintrig.support.errors.QuintrigError, match=r"install it, or write a \.gif"):
        quintrig.animate(CURVE, "alpha", save=tmp_path / "k.mp4")


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_ffmpeg_writes_a_film(tmp_path):
    quintrig.animate(CURVE, "alpha", frames=2, dpi=50, save=tmp_path / "c.mp4")
    assert (tmp_path / "c.mp4").read_bytes()[4:8] == b"ftyp"
