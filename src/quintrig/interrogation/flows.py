"""What is followed along lines: fields of directions without a sense, and geodesics."""

from dataclasses import dataclass

from quintrig.interrogation.field_jit import ASYMPTOTIC, GEODESIC, PRINCIPAL


@dataclass(frozen=True)
class Flow:
    """A field to follow: its ``kind`` in compiled loops, and the families there are."""

    kind: int
    modes: tuple[int, ...] = (1, 2)


PRINCIPAL_DIRECTIONS = Flow(PRINCIPAL)
"""Directions of κ1 (mode 1) and κ2 (mode 2)."""

ASYMPTOTIC_DIRECTIONS = Flow(ASYMPTOTIC)
"""Directions in which the surface does not bend, to the one side (mode 1) and to the other (2) of that of κ1."""

GEODESICS = Flow(GEODESIC, (0,))
"""Geodesics: u, v and their speeds by arc length."""
