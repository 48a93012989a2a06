"""Habits of a host's users: each input of a run changed once, in one process, which must then give the bits of its first run again."""

import numpy as np

REFUSALS = (ArithmeticError, LookupError, OSError, RuntimeError, SystemExit, ValueError)


def worst(habits, run):
    """The largest of each error that `run` finds, with nothing changed, which it prints by name, and with what each of `habits` changes.
    A habit with `refused` must raise, with these words."""
    found = {}
    for name, change in {"as it is": {}, **habits, "as it is, again": {}}.items():
        change = dict(change)
        words = change.pop("refused", None)
        try:
            errors = np.abs(np.atleast_1d(run(**change)))
        except REFUSALS as error:
            if not words or words not in str(error):
                raise RuntimeError(f"{name}: {'the message lacks ' + repr(words) + ': ' if words else ''}{error}") from error
            continue
        if words:
            raise RuntimeError(f"{name}: not refused with {words!r}")
        print(f"  {name}: {', '.join(f'{np.max(error):.1e}' for error in errors)}", flush=True)
        found[name] = errors
    if not np.array_equal(found["as it is"], found["as it is, again"]):
        raise RuntimeError("after the others the first run does not give the same bits again")
    return [np.max(column) for column in zip(*found.values())]
