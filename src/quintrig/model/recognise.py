"""A bare surface as a model, so that a notebook can show and change one that no file holds."""

from quintrig.geometry.surface import Surface
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import Model, Patch

Subject = Model | Patch | Surface


def as_model(subject: Subject, unit: str = "") -> Model:
    """Return a model of what is to be shown: a surface becomes a patch of the first kind that recognises it.

    Raises ValueError for one made of other rows by hand: show a model.
    """
    if isinstance(subject, Model):
        return subject
    header = {"unit": unit} if unit else {}
    if isinstance(subject, Patch):
        keys = subject.definition.model_dump(exclude_defaults=True, exclude={"kind", "name"})
        return Model.from_dict({**header, "name": subject.name, "kind": subject.kind, **keys})
    for kind, form in kinds().items():
        keys = form.recognised(subject)
        if keys is not None:
            return Model.from_dict({**header, "name": "surface", "kind": kind, "flip": subject.flip, **keys})
    raise ValueError(
        "this surface is of rows that no kind of model has, so the studio cannot show it; make a Model near it "
        "(quintrig.Model.from_dict) and show that"
    )
