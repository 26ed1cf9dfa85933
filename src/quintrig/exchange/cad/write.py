"""STEP, IGES and BREP files through OpenCASCADE, written with every digit of a float64.

OpenCASCADE's own writers keep 13 digits in STEP and 9 in IGES; here the same models go through its writers of entities
with a format of 17 digits.
"""

import io
import tempfile
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from quintrig.exchange.cad.occ import module, quiet, settings
from quintrig.exchange.cad.shell import Shell
from quintrig.exchange.units import stated

_DIGITS = "%.17E"
SCHEMAS = {"ap242": "AP242DIS", "ap214": "AP214IS"}
"""STEP application protocols that can be written, by the name of the option."""


def step(shell: Shell, name: str, names: Sequence[str], unit: str, schema: str, remark: str) -> bytes:
    """Return a STEP file of the shell, its named faces and edges; ``remark`` goes into its header."""
    with quiet():
        module("STEPCAFControl").STEPCAFControl_Controller.Init_s()
        chosen = {
            "write.step.schema": SCHEMAS[schema],
            "write.step.unit": stated(unit).opencascade,
            "write.stepcaf.subshapes.name": 1,
        }
        with settings(chosen):
            return _step(shell, name, names, unit, remark)


def _step(shell: Shell, name: str, names: Sequence[str], unit: str, remark: str) -> bytes:
    writer = module("STEPCAFControl").STEPCAFControl_Writer()
    writer.SetNameMode(True)
    document = _document(shell, name, names, unit)
    if not writer.Transfer(document):
        raise ValueError("OpenCASCADE cannot turn this shape into STEP")
    model = writer.ChangeWriter().Model()
    _header(model, name, remark)
    data = module("StepData").StepData_StepWriter(model)
    data.FloatWriter().SetFormat(_DIGITS)
    data.SendModel(model.Protocol())
    return _printed(data)


def iges(shell: Shell, name: str, names: Sequence[str], unit: str) -> bytes:
    """Return an IGES file of the shell, its named faces and edges; names in ASCII, all that the format knows."""
    with quiet():
        module("IGESControl").IGESControl_Controller.Init_s()
        with settings({"write.iges.unit": stated(unit).opencascade, "write.iges.brep.mode": 1}):
            return _iges(shell, _ascii(name), [_ascii(word) for word in names], unit)


def _iges(shell: Shell, name: str, names: Sequence[str], unit: str) -> bytes:
    writer = module("IGESCAFControl").IGESCAFControl_Writer()
    writer.SetNameMode(True)
    document = _document(shell, name, names, unit)
    if not writer.Transfer(document):
        raise ValueError("OpenCASCADE cannot turn this shape into IGES")
    writer.ComputeModel()
    data = module("IGESData").IGESData_IGESWriter(writer.Model())
    data.FloatWriter().SetFormat(_DIGITS)
    data.FloatWriter().SetZeroSuppress(False)
    data.SendModel(module("IGESSelect").IGESSelect_WorkLibrary.DefineProtocol_s())
    return _printed(data)


def brep(shell: Shell) -> bytes:
    """Return a BREP file, OpenCASCADE's own format, which holds neither names nor units."""
    with quiet(), tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "shape.brep"
        module("BRepTools").BRepTools.Write_s(shell.whole, str(path))
        return path.read_bytes()


def _printed(writer: Any) -> bytes:
    stream = io.BytesIO()
    if not writer.Print(stream):
        raise ValueError("OpenCASCADE did not finish writing")
    return stream.getvalue()


def _document(shell: Shell, name: str, names: Sequence[str], unit: str) -> Any:
    """Return an XDE document: the shape with its name, its faces with theirs, and each edge by itself."""
    text = module("TCollection").TCollection_ExtendedString
    kind = text("BinXCAF")
    document = module("TDocStd").TDocStd_Document(kind)
    module("XCAFApp").XCAFApp_Application.GetApplication_s().NewDocument(kind, document)
    tools = module("XCAFDoc").XCAFDoc_DocumentTool
    tools.SetLengthUnit_s(document, stated(unit).millimetres * 1e-3)
    shapes = tools.ShapeTool_s(document.Main())
    write = module("TDataStd").TDataStd_Name.Set_s
    if shell.faces:
        label = shapes.AddShape(shell.shape, False)
        write(label, text(name, True))
        for face, word in zip(shell.faces, names, strict=False):
            part = shapes.AddSubShape(label, face)
            if not part.IsNull():
                write(part, text(word, True))
    for edge, word in zip(shell.edges, names[len(shell.faces) :], strict=True):
        write(shapes.AddShape(edge, False), text(word, True))
    return document


def _header(model: Any, name: str, remark: str) -> None:
    from quintrig import __version__

    text = module("TCollection").TCollection_HAsciiString
    header = module("APIHeaderSection").APIHeaderSection_MakeHeader(model)
    header.SetName(text(_ascii(name)))
    header.SetDescriptionValue(1, text(_ascii(remark)))
    header.SetAuthorValue(1, text(""))
    header.SetOriginatingSystem(text(f"quintrig {__version__}"))


def _ascii(text: str) -> str:
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "replace").decode().replace("?", "_")
    return "".join(letter if letter.isprintable() else "_" for letter in plain)
