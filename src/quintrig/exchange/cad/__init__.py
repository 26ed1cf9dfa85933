"""Exact CAD files: STEP, IGES, BREP, 3DM."""
