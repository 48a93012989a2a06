"""Progress of computations that take more than some seconds: a bar of tqdm where that is installed, else lines of text."""

from __future__ import annotations

import sys
import warnings
from typing import Any, Callable, Optional, Union

# What a caller may give: a function of the part that is done, 0 to 1, and of what is being done; or whether to tell.
Progress = Optional[Union[bool, Callable[[float, str], None]]]

# Maps of more points take more than some seconds.
LARGE = 2_000_000


def teller(progress: Progress, large: bool, name: str = "asperity.surface") -> Callable[[float, str], None]:
    """The function to tell progress to: the caller's, one that writes to the error stream, or one that does nothing.

    By default progress is told of a computation that is large.
    """
    if callable(progress):
        return progress
    if not (progress or (progress is None and large)):
        return lambda part, doing: None
    bar = _bar(name)
    return bar or (lambda part, doing: print(f"{name}: {part:4.0%} {doing}", file=sys.stderr, flush=True))


def _bar(name: str) -> Callable[[float, str], None] | None:
    """A bar of tqdm; None if that is missing."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of notebooks without widgets, where tqdm writes text
            from tqdm.auto import tqdm
    except ImportError:
        return None
    shown = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}<{remaining}{postfix}"
    bar: Any = tqdm(total=100, desc=name, unit="%", bar_format=shown)

    def tell(part: float, doing: str) -> None:
        bar.set_postfix_str(doing, refresh=False)
        bar.update(100 * part - bar.n)
        bar.refresh()
        if part >= 1:
            bar.close()

    return tell
