"""Claims for the page: the verdict on a model, and for each patch the map of what is proved, refuted and open."""

import time
from typing import Any

from quintrig.analysis.proofs import prove
from quintrig.enclosures.claims import read
from quintrig.enclosures.prove import NoProofError, Prover
from quintrig.enclosures.regions import regions
from quintrig.enclosures.verdicts import Verdict, together
from quintrig.model.model import Model

_LONGEST = 30.0  # seconds, after which patches are left without a proof
_BOXES = 512


def proved(model: Model, claim: str) -> dict[str, Any]:
    """Return the verdict on all patches as keys and values, in ``maps`` the rectangles of each, and ``notes``.

    A patch without a proof or a map has no rectangles, and a note; one without a verdict leaves the claim undecided.
    Raises ValueError for a claim that cannot be read.
    """
    model.refuse_curves()
    asked, begun = read(claim, model.unit), time.monotonic()
    verdicts: list[Verdict] = []
    maps: list[dict[str, Any]] = []
    notes: list[str] = []
    for patch in model.patches:
        drawn: dict[str, Any] = {"rectangles": [], "states": []}
        if time.monotonic() - begun > _LONGEST:
            notes.append(f"{patch.name}: not asked, as proofs took {_LONGEST:g} s before; ask of fewer patches")
        else:
            try:
                verdicts.append(prove(patch, asked.text, unit=model.unit, boxes=_BOXES))
                drawn = regions(Prover(patch.surface, model.unit), asked, _BOXES).to_dict()
            except NoProofError as error:
                notes.append(f"{patch.name}: {error}")
            except ValueError as error:
                notes.append(str(error))
        maps.append(drawn)
    result = together(verdicts).to_dict() if verdicts else {"verdict": "undecided", "claim": asked.text}
    if len(verdicts) < len(model.patches) and result["verdict"] == "proved":
        result["verdict"] = "undecided"
    notes = list(dict.fromkeys([*result.get("notes", ()), *notes]))
    return {**result, "notes": notes, "maps": maps}
