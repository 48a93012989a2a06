"""Does what a page of the documentation says: writes its files, runs its commands, compares their output.

usage: follow_docs.py PAGE.md FOLDER

A fenced block whose first line names a language and a file is that file; `sh` blocks are run one after another by one
shell, in FOLDER; a `text` block is the output of the `sh` block before it, digit by digit; with ASPERITY_WRITE_PAGES it becomes that. Code in a
language that could be tested must name its file: nothing of it goes untested.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

MUST_BE_FILES = {"c", "cpp", "cmake", "makefile"}
BLOCK = re.compile(r"^```(\w+)(?: +(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def follow(page, folder):
    """Returns what the page has: numbers of files, commands and outputs."""
    files, scripts, outputs = [], [], {}
    script = ["set -euo pipefail"]
    for language, file, text in BLOCK.findall(page.read_text(encoding="utf-8")):
        if file:
            path = folder / f".{len(files)}"
            path.write_text(text, encoding="utf-8")
            files.append(path)
            script.append(f'install -D -m 644 "{path}" "{file}"')
        elif language == "sh":
            scripts.append(text)
            script.append(f'{{\n{text}}} >"{folder}/.out{len(scripts)}"')
        elif language == "text":
            outputs[len(scripts)] = text
        elif language in MUST_BE_FILES:
            sys.exit(f"{page}: this {language} block names no file, so it would go untested:\n{text}")
    done = subprocess.run(["bash", "-c", "\n".join(script)], cwd=folder, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{page}: a command fails:\n{done.stderr}")
    for number, expected in outputs.items():
        printed = (folder / f".out{number}").read_text(encoding="utf-8")
        if printed != expected and "ASPERITY_WRITE_PAGES" in os.environ:
            page.write_text(page.read_text(encoding="utf-8").replace(f"```text\n{expected}", f"```text\n{printed}", 1), encoding="utf-8")
        elif printed != expected:
            sys.exit(f"{page}: this prints\n{printed}instead of\n{expected}after\n{scripts[number - 1]}")
    return len(files), len(scripts), len(outputs)


if __name__ == "__main__":
    counts = follow(Path(sys.argv[1]), Path(sys.argv[2]).resolve())
    print("{}: {} files, {} blocks of commands, {} outputs as written".format(sys.argv[1], *counts))
