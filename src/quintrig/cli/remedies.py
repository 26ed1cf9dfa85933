"""What the library says of its arguments and functions, in terms of options and commands."""

from quintrig.support.errors import Note, ToldError

OPTIONS = {
    "animate": "--animate",
    "axes": "--vary",
    "axis": "--vary",
    "best": "--best",
    "colours": "--colours",
    "descending": "--greatest",
    "dpi": "--dpi",
    "figures": "--figures",
    "font": "--font",
    "frames": "--frames",
    "levels": "--levels",
    "only": "--only",
    "limits": "--range",
    "lines": "--lines",
    "percentiles": "--percentiles",
    "points": "--points",
    "quantity": "--quantities",
    "samples": "--samples",
    "scheduler": "--scheduler",
    "seed": "--seed",
    "size": "--font-size",
    "style": "--style",
    "subject": "--patch",
    "view": "--view",
    "where": "--where",
    "width": "--width",
}
"""The option of each argument that an error may be about."""

REMEDIES = {
    "address": "choose another with --port or --host",
    "axes": "name one with --vary, such as --vary alpha1=-4:1:21",
    "best": "add --best COLUMN",
    "convert": "--convert makes it a tensor-product patch",
    "curves": "export the faces as NURBS, or copy a curve with --curve N",
    "faces": "quintrig import {file} --list shows them",
    "inventory": "'quintrig reproduce --list' shows all",
    "new": "'quintrig new swept' writes one",
    "patch": "(--patch NAME)",
    "pattern": "quintrig flatten writes flat patterns, quintrig joins writes seams",
    "quantities": "'quintrig table --list' shows all",
    "replace": "choose another name, or --force to replace it",
    "sample": "add --sampling sobol or latin",
    "surfaces": "choose one with --patch, or export a mesh of all",
    "sheet": "split it with --sheet WxH",
    "smaller sheet": "split it with a smaller --sheet WxH",
    "sobol": "take --sampling sobol",
    "space": "take fewer values, or a sample by --sampling sobol --samples N",
}
"""What is to be done, by the key of the library's own remedy."""


def worded(told: object) -> str:
    """Return an error or a note in one line, for who gives commands."""
    if not isinstance(told, ToldError | Note):
        return str(told)
    telling = told.telling
    remedy = REMEDIES[telling.key].format(file=telling.file) if telling.key else telling.remedy
    return telling.line(OPTIONS.get(telling.argument, telling.argument), remedy)
