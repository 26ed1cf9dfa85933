"""Integral curves through all patches of a model: each is followed in compiled code from edge to edge."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.cells import Compiled
from quintrig.interrogation.dop853 import coefficients
from quintrig.interrogation.field_jit import GEODESIC, STATE
from quintrig.interrogation.flows import Flow
from quintrig.interrogation.follow_jit import follow
from quintrig.interrogation.line_jit import (
    AIM,
    AWAY,
    CLOSED,
    COUNT,
    ENDED,
    FINEST,
    HEADING,
    HOME,
    LEAVES,
    LEFT,
    LENGTH,
    LINE,
    MEETS,
    MODE,
    MORE,
    NO_DIRECTION,
    POINT,
    STEP,
    STEPS,
    TOWARDS,
    TRIED,
    begin,
)
from quintrig.interrogation.polyline import Path, looked_up
from quintrig.interrogation.seams import Seams
from quintrig.interrogation.step_jit import SCRATCH
from quintrig.support.arrays import FloatArray
from quintrig.support.memory import address

RELATIVE = 1e-11
"""Relative error of a step."""

_MOST_PIECES = 64  # patches and seams that one line crosses
_ROOM = 16 * FINEST  # points for which one run has room
_FIRST = 0.02  # of the size: the first step

_WHY = {
    MORE: "crosses more patches than are followed",
    CLOSED: "",
    NO_DIRECTION: "ends where the field has no direction",
    LENGTH: "has the length asked for",
    STEPS: "takes more steps than are followed",
}
_POINT, _TOWARDS, _HOME, _HEADING = (slice(k, k + 3) for k in (POINT, TOWARDS, HOME, HEADING))


@dataclass(frozen=True, eq=False)
class Seed:
    """Where a line begins, and in which ``mode`` of the flow: towards a vector (3,), or to one side by ``sense``."""

    patch: int
    uv: FloatArray
    towards: FloatArray | None = None
    mode: int = 0
    sense: float = 1.0


@dataclass(eq=False)
class Trail:
    """A line as it was traced: its paths in the patches that it crosses, and why it ended."""

    paths: list[Path] = field(default_factory=list[Path])
    modes: list[int] = field(default_factory=list[int])
    closed: bool = False
    ended: str = ""


class Tracer:
    """Follows a flow over the surfaces of a model, with chords within ``chord`` (length¹)."""

    def __init__(self, surfaces: Sequence[Surface], flow: Flow, chord: float, longest: float = np.inf) -> None:
        """Look at the seams once; no chord is longer than ``longest``."""
        self.surfaces, self.flow, self.chord, self.longest = surfaces, flow, chord, longest
        self.relative = RELATIVE
        self.compiled = Compiled(surfaces, flow.kind == GEODESIC, SCRATCH)
        self.seams = Seams(self.compiled)
        self.size = self.seams.size
        self._table = coefficients()
        self._points: FloatArray = np.empty((_ROOM, 2))

    def trace(self, seeds: Sequence[Seed], length: float | Sequence[float]) -> list[Trail]:
        """Return the lines from the seeds, at most ``length`` long (length¹), in their order."""
        lines = self.begun(seeds)
        lines[:, LEFT], lines[:, STEP] = length, _FIRST * self.size
        lines[:, _HOME], lines[:, _HEADING] = lines[:, _POINT], lines[:, _TOWARDS]
        trails = [Trail() for _ in seeds]
        for line, seed, trail in zip(lines, seeds, trails, strict=True):
            self._follow(line, seed.patch, trail)
        looked_up(self.surfaces, [path for trail in trails for path in trail.paths])
        return trails

    def begun(self, seeds: Sequence[Seed]) -> FloatArray:
        """Return the lines as they begin, (n, LINE): with NO_DIRECTION where the flow has none."""
        lines: FloatArray = np.zeros((len(seeds), LINE))
        for line, seed in zip(lines, seeds, strict=True):
            line[:2], line[MODE], line[AIM : AIM + 2] = seed.uv, seed.mode, seed.sense
            line[_TOWARDS] = np.nan if seed.towards is None else seed.towards
        patches = np.array([seed.patch for seed in seeds])
        for patch in dict.fromkeys(patches.tolist()):
            here = np.flatnonzero(patches == patch)
            some = lines[here]
            self._begin(patch, some)
            lines[here] = some
        return lines

    def _begin(self, patch: int, lines: FloatArray) -> None:
        begin(self.compiled.address(patch), self.flow.kind, address(lines), len(lines), address(self.compiled.scratch))
        lines[:, _POINT] += self.surfaces[patch].origin

    def _follow(self, line: FloatArray, patch: int, trail: Trail) -> None:
        """Follow a line from patch to patch, and write its paths down."""
        for _ in range(_MOST_PIECES):
            if line[ENDED] == NO_DIRECTION:
                break
            points = self._in_patch(line, patch)
            if len(points):
                trail.paths.append(Path(patch, points[::2], points[1::2]))
                trail.modes.append(int(line[MODE]))
            if line[ENDED] != LEAVES:
                break
            if self._is_home(line):
                line[ENDED] = CLOSED
                break
            found = self.seams.enter(patch, line[:2], line[_TOWARDS])
            if found is None:
                trail.ended = "ends at an edge"
                return
            patch, place = found
            self._enter(line, patch, place)
        trail.closed, trail.ended = bool(line[ENDED] == CLOSED), _WHY[int(line[ENDED])]

    def _in_patch(self, line: FloatArray, patch: int) -> FloatArray:
        """Return parameters (2n + 1, 2) of a line up to where it ends or leaves the patch: points and middles."""
        surface, origin = self.compiled.address(patch), self.surfaces[patch].origin
        settings = np.array([self.relative, self.size, self.chord, self.longest])
        line[_HOME] -= origin
        line[TRIED], line[ENDED] = 0.0, MORE
        parts: list[FloatArray] = []
        while line[ENDED] == MORE:
            follow(
                *(surface, self.flow.kind, address(line), address(settings), address(self._table)),
                *(address(self._points), _ROOM, address(self.compiled.scratch)),
            )
            parts.append(self._points[: int(line[COUNT])].copy())
        line[_HOME] += origin
        line[_POINT] += origin
        if not any(len(part) for part in parts):
            return np.empty((0, 2))
        return np.concatenate([*parts, line[None, :2]])

    def _is_home(self, line: FloatArray) -> bool:
        near = np.linalg.norm(line[_POINT] - line[_HOME]) <= MEETS * self.size
        return bool(near and line[STATE - 1] > AWAY * self.size and line[_TOWARDS] @ line[_HEADING] > 0.5)

    def _enter(self, line: FloatArray, patch: int, place: FloatArray) -> None:
        """Move a line into another patch, whose normal may point the other way: to the family that leads on."""
        tries = np.tile(line, (len(self.flow.modes), 1))
        tries[:, :2], tries[:, 2 : STATE - 1], tries[:, MODE] = place, 0.0, self.flow.modes
        self._begin(patch, tries)
        cosines = np.nan_to_num(tries[:, _TOWARDS] @ line[_TOWARDS], nan=-2.0)
        line[:] = tries[int(np.argmax(cosines))]
