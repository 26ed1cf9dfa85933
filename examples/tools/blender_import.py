"""Bring a model into Blender with its colours: blender --python blender_import.py -- MODEL.toml [quantity].

Blender's own Python need not have quintrig: the script runs the command, whose path QUINTRIG says where it is not on
the PATH. The mesh keeps a chord of a thousandth of the model's size and comes in metres, as GLB files are.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy

model, quantity = [*sys.argv[sys.argv.index("--") + 1 :], "gaussian"][:2]
glb = Path(tempfile.mkdtemp()) / f"{Path(model).stem}.glb"
subprocess.run([os.environ.get("QUINTRIG", "quintrig"), "export", model, str(glb), "--colour", quantity], check=True)
bpy.ops.import_scene.gltf(filepath=str(glb))
for material in bpy.data.materials:  # show the colours of the points
    nodes = material.node_tree.nodes
    shader = next((node for node in nodes if node.type == "BSDF_PRINCIPLED"), None)
    if shader and not shader.inputs["Base Color"].is_linked:
        colours = nodes.new("ShaderNodeVertexColor")
        material.node_tree.links.new(colours.outputs["Color"], shader.inputs["Base Color"])
