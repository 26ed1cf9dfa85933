"""A FreeCAD macro: choose a model file, and its faces come into the open document, exact and sewn.

Copy it into FreeCAD's macro folder (Macro > Macros... > User macros location). FreeCAD's own Python need not have
quintrig: the macro runs the command, whose path QUINTRIG says where it is not on the PATH.
"""

import os
import subprocess
import tempfile
from pathlib import Path

import FreeCAD
import Import
from PySide import QtGui

model, _ = QtGui.QFileDialog.getOpenFileName(None, "A quintrig model", "", "Models (*.toml *.json)")
if model:
    step = Path(tempfile.mkdtemp()) / f"{Path(model).stem}.step"
    command = [os.environ.get("QUINTRIG", "quintrig"), "export", model, str(step)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    for line in (done.stdout + done.stderr).splitlines():
        FreeCAD.Console.PrintMessage(f"{line}\n")
    if done.returncode == 0:
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument(Path(model).stem)
        Import.insert(str(step), document.Name)
