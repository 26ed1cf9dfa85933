"""``design``: the patch that meets demands with the least of an objective, or the best compromise."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.attach import attach
from quintrig.shaping.asked import conditions_of, objective_of
from quintrig.shaping.conditions import Condition, regular
from quintrig.shaping.energies import ENERGIES, measured
from quintrig.shaping.goals import Goals, read_goals
from quintrig.shaping.holds import ORDERS, Hold, usual
from quintrig.shaping.kept import Log
from quintrig.shaping.outcomes import Outcome, outcome
from quintrig.shaping.places import Near
from quintrig.shaping.problem import Problem, search_basis
from quintrig.shaping.search import Found, Search, contradiction, met
from quintrig.shaping.unknowns import Unknowns, unknowns
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError
from quintrig.support.progress import Progress, watched

_FAR = 0.25  # of each range a start is away from the given design, at random


@dataclass(frozen=True, eq=False)
class Design:
    """The model with the patch designed, and what was reached.

    ``before`` and ``after`` are the objective: energies and area in the unit's power, ``deviation`` the root mean
    square distance, of ``none`` the root mean square of what the points moved at their (u, v), length¹.
    ``contradictions`` names demands that cannot be met together within what may vary: the model is then the best
    compromise. ``stopped`` tells that the search was interrupted.
    """

    model: Model
    patch: str
    minimised: str
    before: float
    after: float
    outcomes: tuple[Outcome, ...]
    contradictions: tuple[str, ...]
    starts: int
    stopped: bool
    notes: tuple[str, ...]

    @property
    def met(self) -> bool:
        """Whether every demand is met."""
        return all(one.met for one in self.outcomes)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, without the model."""
        patch = self.model.patch(self.patch)
        ends = [end if np.isfinite(end) else None for end in (self.before, self.after)]
        return {
            "patch": self.patch,
            "unit": self.model.unit,
            "met": self.met,
            "objective": {"name": self.minimised, "before": ends[0], "after": ends[1]},
            "demands": [one.to_dict() for one in self.outcomes],
            "binding": [one.demand for one in self.outcomes if one.binds],
            "contradictions": list(self.contradictions),
            "parameters": patch.definition.parameters,
            "shape": list(patch.shape),
            "starts": self.starts,
            "stopped": self.stopped,
            "notes": list(self.notes),
        }


@watched
def design(
    goals: str | Path | Mapping[str, Any],
    *,
    starts: int = 3,
    seed: int = 0,
    state: str | Path | None = None,
    prove: bool = True,
    progress: Progress | None = None,
) -> Design:
    """Return the design that goals ask for: of a goals file, or of its keys (``model`` may be a ``Model``).

    The search begins at the model as it is and at ``starts`` - 1 places at random; ``state`` names a file that keeps
    what was reached, from which a later call goes on. An interrupt ends it with the best so far. Raises ModelError or
    ValueError in one line for goals that make no sense.
    """
    if isinstance(starts, bool) or not 1 <= starts <= 1000:
        raise ValueError(f"starts: expected 1 to 1000, found {starts}")
    read = read_goals(goals)
    model, holds, notes = _joined(read)
    patch = model.patch(read.patch)
    space = unknowns(patch, read.ranges, read.points, read.only, holds)
    conditions = conditions_of(read, patch)
    whole = regular(patch.surface) if read.points is not None else None
    objective, scale = objective_of(read, patch)
    always = [whole] if whole else []
    basis = search_basis(space, read.minimise in ENERGIES)
    problem = Problem(space, objective, [*conditions, *always], basis, scale)
    log = Log(Path(state) if state is not None else None, _digest(read, space), starts, progress)
    best, done, stopped = _searched(problem, log, starts, seed)
    clash: tuple[Condition, ...] = ()
    if not met(best.missed) and not stopped and len(conditions):
        try:
            log.tell("which demands contradict", starts)
            search = Search(problem)
            eased = search.compromise(best.y, problem.conditions)
            best = eased if eased.better(best) else best
            again = search.run(best.y)
            best = again if again.better(best) else best
            if not met(best.missed):
                clash = contradiction(search, best.y, conditions, always)
        except KeyboardInterrupt:
            stopped = True
    asked = replace(problem, conditions=conditions)
    return _result(read, model, asked, best, clash, done, stopped, (*notes, *space.notes), prove)


def _searched(problem: Problem, log: Log, starts: int, seed: int) -> tuple[Found, int, bool]:
    """Return the best of several starts, how many were done, and whether it was interrupted."""
    count = int(problem.basis.shape[1])
    search = Search(problem)
    given = np.zeros(count, dtype=np.float64)
    best = search.judged(given, problem.conditions)
    kept, first = log.kept(count)
    if kept is not None:
        found = search.judged(kept, problem.conditions)
        best = found if found.better(best) else best
    reached = [best]

    def told(found: Found) -> None:
        if found.better(reached[0]):
            reached[0] = found
        log.tell("searching", log.done)
        log.keep(reached[0])

    search.told = told
    try:
        for index in range(first, starts):
            log.done = index
            log.tell("searching", index)
            y = reached[0].y if index == 0 or (kept is not None and index == first) else _start(problem, seed + index)
            told(search.run(y))
            log.done = index + 1
            log.keep(reached[0])
    except KeyboardInterrupt:
        return reached[0], log.done, True
    log.done = max(starts, first)
    return reached[0], log.done, False


def _start(problem: Problem, seed: int) -> FloatArray:
    """Return a place at random: parameters anywhere in the middle of their ranges, points a part of what they may."""
    rng = np.random.default_rng(seed)
    space = problem.space
    y: FloatArray = np.asarray(rng.normal(size=problem.basis.shape[1]), dtype=np.float64)
    free = problem.basis.shape[1] - len(space.ranges)
    for index in range(space.coordinates, len(space.start)):
        column = free + index - space.coordinates
        wanted = space.low[index] + (0.1 + 0.8 * rng.random()) * (space.high[index] - space.low[index])
        y[column] = (wanted - space.start[index]) / problem.basis[index, column]
    step = problem.basis[: space.coordinates, :free] @ y[:free]
    if step.size:
        width = space.high[: space.coordinates] - space.low[: space.coordinates]
        y[:free] *= _FAR / float(np.abs(step / width).max() or 1.0)
    return y


def _digest(goals: Goals, space: Unknowns) -> str:
    """Return what tells goals apart: what may vary from where, what is minimised and demanded."""
    words = repr(
        (goals.minimise, goals.demands, goals.through, goals.tangent, goals.targets, goals.seams, goals.developable)
    )
    numbers = np.concatenate([space.start, space.low, space.high, space.directions.ravel()]).tobytes()
    return hashlib.sha256(words.encode() + numbers).hexdigest()


# ------------------------------------------------------------------------------------------------- from the goals


def _joined(goals: Goals) -> tuple[Model, list[Hold], list[str]]:
    """Return the model with the seams made, what is held for them and otherwise, and notes."""
    model, notes = goals.model, list[str]()
    held = list(usual(model, goals.patch, edges=False) if goals.hold is None else goals.hold)
    if goals.hold is None:
        held = [one for one in held if isinstance(one.place, str)]  # corners are free
    for index, seam in enumerate(goals.seams, 1):
        sides = [seam.first, seam.second]
        names = [side.rpartition(":")[0] for side in sides]
        if goals.patch not in names:
            raise ModelError(f'seam {index}: expected a side of "{goals.patch}", the patch that is designed')
        if names[0] == goals.patch:
            sides.reverse()
        try:
            done = attach(model, sides[0], sides[1], seam.order, seam.ratio)
        except ValueError as error:
            raise ModelError(f"seam {index}: {error}") from None
        model = done.model
        notes += done.notes
        place, order = sides[1].rpartition(":")[2], ORDERS.index(seam.order)
        order = max([order, *(one.order for one in held if one.place == place)])
        held = [*(one for one in held if one.place != place), Hold(place, order)]
    return model, held, notes


# ---------------------------------------------------------------------------------------------------- what came out


def _result(
    goals: Goals,
    model: Model,
    problem: Problem,
    best: Found,
    clash: Sequence[Condition],
    starts: int,
    stopped: bool,
    notes: Sequence[str],
    prove: bool,
) -> Design:
    patch = problem.space.finished(problem.unknowns(best.y))
    changed = replace(model, patches=tuple(patch if one.name == patch.name else one for one in model.patches))
    if model.held:
        changed = model.with_patch(patch)
    state = problem.space.at(np.clip(problem.unknowns(best.y), problem.space.low, problem.space.high))
    outcomes = tuple(outcome(one, one.worst(state), patch, model.unit, prove) for one in problem.conditions)
    told = list(notes)
    if any(not one.met for one in outcomes) and not clash and not stopped:
        told.append("no design meets every demand from these starts; more of them may find one")
    before, after = (_amount(goals, problem, one) for one in (model.patch(goals.patch), patch))
    return Design(
        changed,
        goals.patch,
        goals.minimise,
        before,
        after,
        outcomes,
        tuple(one.name for one in clash),
        starts,
        stopped,
        tuple(dict.fromkeys(told)),
    )


def _amount(goals: Goals, problem: Problem, patch: Patch) -> float:
    """Return the objective as it is stated."""
    if goals.minimise in ENERGIES:
        return measured(patch.surface, goals.minimise)
    if isinstance(problem.objective, Near):
        found = problem.objective.distances(problem.space.at(problem.space.values_of(patch)))
        return float(np.sqrt((found**2).mean()))
    if problem.objective is None:
        t = np.linspace(0.0, 1.0, 65)
        first, second = (one.surface(t[:, None], t) for one in (problem.space.patch, patch))
        return float(np.sqrt(((first - second) ** 2).sum(axis=-1).mean()))
    return problem.objective.value(problem.space.at(problem.space.values_of(patch)))[0]
