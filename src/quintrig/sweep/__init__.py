"""Sweeps: every design of a space of shape parameters, each to a row of summaries, in files that can be queried."""

from quintrig.sweep.part import Task as Task
from quintrig.sweep.proofs import prove_rows as prove_rows
from quintrig.sweep.query import Question as Question
from quintrig.sweep.query import count as count
from quintrig.sweep.query import select as select
from quintrig.sweep.refine import select_refined as select_refined
from quintrig.sweep.run import run as run
from quintrig.sweep.space import Axis as Axis
from quintrig.sweep.space import DesignSpace as DesignSpace
from quintrig.sweep.space import parse_axis as parse_axis
from quintrig.sweep.store import Sweep as Sweep
from quintrig.sweep.store import load_sweep as load_sweep
from quintrig.sweep.store import open_sweep as open_sweep
