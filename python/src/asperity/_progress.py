"""Progress of computations on large maps."""

from __future__ import annotations

import sys
from typing import Callable, Optional, Union

# What a caller may give: a function of the part that is done, 0 to 1, and of what is being done; or whether to tell.
Progress = Optional[Union[bool, Callable[[float, str], None]]]

# Maps of more points take more than some seconds.
LARGE = 2_000_000


def teller(progress: Progress, points: int) -> Callable[[float, str], None]:
    """The function to tell progress to: the caller's, one that writes to the error stream, or one that does nothing."""
    if callable(progress):
        return progress
    if progress or (progress is None and points > LARGE):
        return _write
    return lambda part, doing: None


def _write(part: float, doing: str) -> None:
    print(f"asperity.surface: {part:4.0%} {doing}", file=sys.stderr, flush=True)
