"""Curves and surfaces: constructions, closed forms, exact rational forms."""
