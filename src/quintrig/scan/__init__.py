"""Measured points beside surfaces: scans, nearest points, deviation, and the curvature of the points themselves."""
