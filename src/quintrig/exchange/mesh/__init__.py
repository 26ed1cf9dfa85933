"""Mesh files that carry curvature."""
