"""Figures with matplotlib, never through pyplot: whole figures, and the functions that draw on given axes.

Every function returns a matplotlib ``Figure`` that belongs to no window; ``save`` writes it. Nothing here changes
matplotlib's global settings. Pictures in space are parallel projections with one scale in all directions.
"""

from quintrig.figure.along import curvature_plot as curvature_plot
from quintrig.figure.along import torsion_plot as torsion_plot
from quintrig.figure.camera import BACK as BACK
from quintrig.figure.camera import ISO as ISO
from quintrig.figure.camera import SIDE as SIDE
from quintrig.figure.camera import TOP as TOP
from quintrig.figure.camera import VIEWS as VIEWS
from quintrig.figure.camera import View as View
from quintrig.figure.compared import code_map as code_map
from quintrig.figure.compared import comparison as comparison
from quintrig.figure.compared import map_comparison as map_comparison
from quintrig.figure.compared import overlay as overlay
from quintrig.figure.compared import projections as projections
from quintrig.figure.curve import basis_functions as basis_functions
from quintrig.figure.curve import plane_curves as plane_curves
from quintrig.figure.diagram import hk_table as hk_table
from quintrig.figure.diagram import shape_scale as shape_scale
from quintrig.figure.palette import Limits as Limits
from quintrig.figure.palette import limits as limits
from quintrig.figure.save import KINDS as KINDS
from quintrig.figure.save import save as save
from quintrig.figure.save import to_bytes as to_bytes
from quintrig.figure.save import to_png_bytes as to_png_bytes
from quintrig.figure.save import to_svg_text as to_svg_text
from quintrig.figure.scene import Mark as Mark
from quintrig.figure.scene import Scene as Scene
from quintrig.figure.scene import Trace as Trace
from quintrig.figure.seams import SEAM_COLOURS as SEAM_COLOURS
from quintrig.figure.seams import seam_picture as seam_picture
from quintrig.figure.space_curves import space_curves as space_curves
from quintrig.figure.whole import flat_map as flat_map
from quintrig.figure.whole import map_panels as map_panels
from quintrig.figure.whole import panels as panels
from quintrig.figure.whole import space_picture as space_picture
from quintrig.figure.wording import normal_note as normal_note
from quintrig.figure.zebra import zebra_picture as zebra_picture
