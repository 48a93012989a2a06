"""Fails unless every function of a source file was called; reads gcov's JSON from standard input.

usage: gcov --json-format --stdout FILE.gcda | called.py SOURCE
"""

import json
import sys

source = sys.argv[1]
functions = [
    function
    for file in json.load(sys.stdin)["files"]
    if file["file"].endswith(source)
    for function in file["functions"]
]
idle = [function["demangled_name"] for function in functions if function["execution_count"] == 0]
if not functions:
    sys.exit(f"{source}: gcov reports no function of it")
if idle:
    sys.exit(f"{source}: these functions are never called:\n  " + "\n  ".join(idle))
print(f"all {len(functions)} functions of {source} are called")
