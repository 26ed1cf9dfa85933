"""Values that travel to other processes, and come back as read-only as they were."""

from types import MappingProxyType
from typing import Any, cast

import numpy as np


class Pickled:
    """Lets a dataclass with read-only arrays and mappings be pickled and copied, which forget that they are."""

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; Python has no pickled form of a read-only mapping."""
        return {key: dict(value) if _is_proxy(value) else value for key, value in vars(self).items()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take the fields back, arrays and mappings read-only."""
        for key, value in state.items():
            vars(self)[key] = MappingProxyType(cast(Any, value)) if isinstance(value, dict) else value
            arrays = cast(tuple[Any, ...], value) if isinstance(value, tuple) else (cast(Any, value),)
            for array in arrays:
                if isinstance(array, np.ndarray):
                    array.setflags(write=False)


def _is_proxy(value: object) -> bool:
    return isinstance(value, MappingProxyType)
