"""Flat patterns for the workshop: DXF, SVG, PDF."""
