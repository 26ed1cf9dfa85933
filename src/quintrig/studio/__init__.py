"""The studio: see and shape a surface in the browser, live, in a report page or in Jupyter."""

from pathlib import Path

BUNDLE = Path(__file__).parent / "bundle" / "studio.js"
"""The one script that is the live studio, the viewer of a report page and the Jupyter view."""
