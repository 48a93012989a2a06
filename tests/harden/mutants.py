#!/usr/bin/env python3
"""Draws changes of the Rust sources at random and says which of them no test notices.

usage: tests/harden/mutants.py [--check] [--count N] [--seed N] [GLOB ...]

A change is of one line: an operator, a number, min for max, a condition turned round, or a statement left out. All stand in one build
of a copy of the sources, each behind its number, which a variable of the environment chooses; those that do not compile are left out.
Each is tried by the unit tests, and where these pass by the other groups. --check only says whether the globs cover every folder of src.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve() / "mutants-drawn"
GLOBS = ["src/*.rs", "src/*/**/*.rs"]
GROUPS = ["law", "physics", "c_api", "numerics"]
SWITCH = """
pub(crate) mod changed {
    pub fn on(number: u32) -> bool {
        static CHOSEN: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
        let read = || std::env::var("ASPERITY_CHANGE").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
        *CHOSEN.get_or_init(read) == number
    }
}
"""
OTHER = {
    " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " -= ": " += ", " < ": " <= ", " <= ": " < ",
    " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ", "true": "false",
    "false": "true", ".min(": ".max(", ".max(": ".min(", ".any(": ".all(", ".all(": ".any(",
}  # fmt: skip
OPERATOR = re.compile("|".join(rf"\b{word}\b" if word.isalpha() else re.escape(word) for word in OTHER))
NUMBER = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")
# Where an expression stands on one line, between what comes before and after it.
EXPRESSIONS = [
    re.compile(r"(\s*let (?!Some|Ok|Err)[^=]+ = )(.+)(;)"),
    re.compile(r"(\s*(?:\} else )?(?:if|while) )(?!let )(.+)( \{)"),
    re.compile(r"(\s+(?:[^ ]| \| |, )+(?: if [^=]+)? => )([^{]+)(,)"),
    re.compile(r"(\s+[a-z_0-9]+: )([^;]+)(,)"),
]
# The same of a line that is a statement, or the last expression of a block.
WHOLE = re.compile(r"(\s+(?:return )?)([^{};=]+)(;?)")
STATEMENT = re.compile(r"\s+(?!let |return|use |pub |const |static |break|continue|type |unsafe \{)[a-z_*][^{}]*;")


class Change(NamedTuple):
    file: str
    line: int
    before: str
    # What becomes of the line, with NUMBER in place of the number of the change.
    after: str
    told: str


def changes_of(file: str) -> list[Change]:
    """All changes of a file, but for its tests and what the compiler evaluates."""
    found = []
    text = re.split(r"#\[cfg\(.*test.*\)\]\n(?:pub\(crate\) )?mod ", (ROOT / file).read_text())[0]
    lines = [line.split(" //")[0].rstrip() for line in text.splitlines()] + [""]
    for number, code in enumerate(lines[:-1]):
        if re.match(r"\s*(//|#|(pub(\(.*?\))? )?(const|static|use|type|fn|struct|enum|impl|unsafe|extern|mod)\b)", code):
            continue
        begins = lines[number - 1].endswith(("{", "}", ";"))
        ends = code.endswith(";") or lines[number + 1].endswith("}")
        if begins and STATEMENT.fullmatch(code):
            found.append(Change(file, number, code, f"if !crate::changed::on(NUMBER) {{ {code} }}", "left out"))
        forms = [*EXPRESSIONS, WHOLE] if begins and ends else EXPRESSIONS
        whole = next((match for match in (form.fullmatch(code) for form in forms) if match), None)
        if whole is None:
            continue
        before, expression, after = whole.groups()
        for at in [*OPERATOR.finditer(expression), *NUMBER.finditer(expression)]:
            new = OTHER.get(at[0], f"({at[0]} * 1.1 + 0.01)")
            other = expression[: at.start()] + new + expression[at.end() :]
            both = f"(if crate::changed::on(NUMBER) {{ {other} }} else {{ {expression} }})"
            found.append(Change(file, number, code, f"{before}{both}{after}", f"{at[0].strip()} -> {new.strip()}"))
    return found


def files_of(globs: list[str]) -> list[str]:
    files = {path for glob in globs for path in ROOT.glob(glob) if path.name != "tests.rs"}
    return sorted(str(path.relative_to(ROOT)) for path in files)


def check() -> None:
    """Fails where a glob finds nothing, or a folder of src has nothing to be drawn."""
    for glob in GLOBS:
        if not files_of([glob]):
            sys.exit(f"{glob} finds no file")
    drawn = {Path(file).parent for file in files_of(GLOBS) if changes_of(file)}
    folders = {path.parent.relative_to(ROOT) for path in (ROOT / "src").rglob("*.rs") if path.name not in ("tests.rs", "mod.rs")}
    if folders - drawn:
        sys.exit(f"nothing is drawn of {', '.join(sorted(map(str, folders - drawn)))}")
    print(f"changes are drawn of all {len(folders)} folders of src")


def build(tree: Path, drawn: dict[int, Change], env: dict[str, str]) -> list[Path]:
    """The test programs with all changes that compile; the others are taken out of those drawn."""
    while True:
        for file in files_of(["src/**/*.rs"]):
            lines = (ROOT / file).read_text().splitlines()
            for number, change in drawn.items():
                if change.file == file:
                    lines[change.line] = change.after.replace("NUMBER", str(number))
            new = "\n".join(lines) + (SWITCH if file == "src/lib.rs" else "\n")
            if (tree / file).read_text() != new:
                (tree / file).write_text(new)
        command = ["cargo", "test", "--no-run", "--locked", "--profile", "mutants", "--lib", "--message-format", "json"]
        command += [argument for group in GROUPS for argument in ("--test", group)]
        done = subprocess.run(command, cwd=tree, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode == 0:
            programs = {one["target"]["name"]: Path(one["executable"]) for one in told if one.get("executable")}
            return [programs[name] for name in ["asperity", *GROUPS]]
        messages = [one["message"] for one in told if one["reason"] == "compiler-message"]
        places = {
            (span["file_name"], line - 1)
            for message in messages
            if message["level"] == "error"
            for span in message["spans"]
            for line in range(span["line_start"], span["line_end"] + 1)
        }
        blamed = [number for number, change in drawn.items() if (change.file, change.line) in places]
        if not blamed:
            sys.exit(f"{done.stderr}\ncargo test: fails for no change")
        for number in blamed:
            del drawn[number]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=time.time_ns() % 10000)
    parser.add_argument("globs", nargs="*", default=GLOBS)
    given = parser.parse_args()
    if given.check:
        return check()
    tree = TARGET / "tree"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.split("\0")
    shutil.rmtree(tree, ignore_errors=True)
    for name in filter(None, files):
        if (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, tree / name)
    env = os.environ | {"CARGO_TARGET_DIR": str(TARGET / "target"), "RUSTFLAGS": "--cap-lints=allow", "RUST_TEST_THREADS": "1"}
    order = [change for file in files_of(given.globs) for change in changes_of(file)]
    random.Random(given.seed).shuffle(order)
    # One of a line, and more than are asked for, as some do not compile.
    one_of_each = {(change.file, change.line): change for change in order}
    drawn = dict(enumerate(list(one_of_each.values())[: given.count * 3 // 2], 1))
    programs = build(tree, drawn, env)
    drawn = dict(list(drawn.items())[: given.count])
    print(f"seed {given.seed}: {len(drawn)} changes of {len(order)}", flush=True)

    def fails(program: Path, number: int, seconds: float) -> bool:
        """Whether a test fails, or takes for ever; the first that does ends the run."""
        chosen = env | {"ASPERITY_CHANGE": str(number)}
        run = subprocess.Popen([program], cwd=tree, env=chosen, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        late = threading.Timer(seconds, run.kill)
        late.start()
        failed = any(line.endswith("FAILED\n") for line in run.stdout)
        if failed:
            run.kill()
        late.cancel()
        return run.wait() != 0

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for program, failed in zip(programs, pool.map(lambda program: fails(program, 0, 3600), programs)):
            if failed:
                sys.exit(f"{program.name} fails without a change")
        noticed = pool.map(lambda number: any(fails(program, number, 1800) for program in programs), drawn)
        missed = 0
        for change, is_noticed in zip(drawn.values(), noticed):
            if not is_noticed:
                missed += 1
                print(f"no test notices {change.file}:{change.line + 1}: {change.told}: {change.before.strip()}", flush=True)
    print(f"{missed} of {len(drawn)} changes pass unnoticed")


if __name__ == "__main__":
    main()
