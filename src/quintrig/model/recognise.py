"""A bare surface as a model, so that a notebook can show and change one that no file holds."""

from quintrig.geometry.surface import Surface
from quintrig.model.kinds.recognise import Bare
from quintrig.model.model import Model
from quintrig.model.patch import Patch

Subject = Model | Patch | Surface


def as_model(subject: Subject, unit: str = "") -> Model:
    """Return a model of what is to be shown: a surface becomes a patch of the first kind that recognises it.

    Raises ValueError for one made of other rows by hand: show a model.
    """
    if isinstance(subject, Model):
        return subject
    patch = subject if isinstance(subject, Patch) else Patch.of(subject)
    if isinstance(patch.definition, Bare):
        raise ValueError(  # noqa: TRY004
            "this surface is of rows that no kind of model has, so the studio cannot show it; make a Model near it "
            "(quintrig.Model.from_dict) and show that"
        )
    return Model(patch.name, unit, (patch,))
