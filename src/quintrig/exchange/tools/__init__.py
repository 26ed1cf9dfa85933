"""Surfaces and models as objects of other Python tools: PyVista, build123d, COMPAS, trimesh."""
