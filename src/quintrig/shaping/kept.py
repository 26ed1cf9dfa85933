"""Tells how far a search is, and keeps in a file what it reached, so that it can go on from there."""

import json
from pathlib import Path

import numpy as np

from quintrig.shaping.search import Found
from quintrig.support.arrays import FloatArray
from quintrig.support.files import write_whole
from quintrig.support.progress import Progress


class Log:
    """Progress of a search of so many ``starts``, and the ``file`` of its state, if any; ``digest`` is of the goals."""

    def __init__(self, file: Path | None, digest: str, starts: int, progress: Progress | None) -> None:
        """Keep what it is told."""
        self.file, self.digest, self.starts, self.progress = file, digest, starts, progress
        self.done = 0

    def tell(self, what: str, done: int) -> None:
        """Tell what is being done."""
        if self.progress is not None:
            self.progress(what, done, self.starts)

    def keep(self, best: Found) -> None:
        """Write the best so far."""
        if self.file is not None:
            data = {"goals": self.digest, "done": self.done, "best": best.y.tolist()}
            write_whole(self.file, json.dumps(data))

    def kept(self, count: int) -> tuple[FloatArray | None, int]:
        """Return where an earlier search of the same goals ended, and how many starts it had done."""
        if self.file is None or not self.file.exists():
            return None, 0
        try:
            data = json.loads(self.file.read_text(encoding="utf-8"))
            same = data["goals"] == self.digest
            y = np.array(data["best"], dtype=np.float64)
            done = int(data["done"])
        except (OSError, ValueError, KeyError, TypeError):
            raise ValueError(f"state: {self.file} holds no state of a design; name another file") from None
        if not same or y.shape != (count,) or not np.isfinite(y).all():
            raise ValueError(f"state: {self.file} is of other goals or another model; name another file")
        return y, done
