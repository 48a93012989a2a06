"""How a host's program in Python ends: with one line that says PASS or FAIL, and with that status."""

import sys
import time


def run(host, main, *arguments):
    """`main` returns whether all is right, and what was found; what it raises is no less a verdict."""
    try:
        good, found = main(*arguments)
    except (RuntimeError, ValueError, OSError) as error:
        good, found = False, error
    print(f"{host}  {'PASS' if good else 'FAIL'}  {found}  {time.process_time():.1f} s")
    sys.exit(not good)
