"""The studio: see and shape a surface in the browser, live, in a report page or in Jupyter."""

from quintrig.studio.page import BUNDLE, code, embed, policy, viewer

__all__ = ["BUNDLE", "code", "embed", "policy", "viewer"]
