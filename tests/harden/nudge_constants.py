#!/usr/bin/env python3
"""Moves each constant of the numerical core by 4 % (whole numbers by 1) to either side, and runs the unit tests of the core.

usage: tests/harden/nudge_constants.py [REGEX of FILE:NAME] [TESTS ...]

A constant that tunes has a side on which sums take more work and are no less exact: there every test is to pass. On the other side
tests may fail, as they do if the constant leaves nothing to spare. Constants of physics and mathematics fail on both. All stand in one
build of a copy of the sources, each behind its number, which a variable of the environment chooses. Prints the tests that fail for each
constant and side, of those whose names contain one of TESTS (the folders of the core). Constants that are lengths of arrays stay as they
are.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
FOLDERS = ["population", "equilibrium", "law", "distribution", "numerics", "asperity"]
CONSTANT = re.compile(r"^ *(pub(?:\([a-z]+\))? )?const ([A-Z_0-9]+): (f64|u32|usize) = [^;]*;", re.M)
# What is no expression that is evaluated while the program runs.
KEPT = re.compile(r"//[^\n]*|\buse [^;]*;|\bconst [A-Z_0-9]+: [^=]*=[^;]*;|\bconst fn [^{]*\{(?s:.*?)\n\}|\"(?:[^\"\\]|\\.)*\"")
SWITCH = """
pub(crate) mod nudged {
    fn side(number: usize) -> i8 {
        static CHOSEN: std::sync::OnceLock<(usize, i8)> = std::sync::OnceLock::new();
        let read = |name: &str| std::env::var(name).ok()?.parse::<i64>().ok();
        let (chosen, side) =
            CHOSEN.get_or_init(|| (read("NUDGED").unwrap_or(-1) as usize, read("NUDGED_SIDE").unwrap_or(0) as i8));
        if *chosen == number { *side } else { 0 }
    }
    pub fn f64(number: usize, value: f64) -> f64 { value * (1.0 + 0.04 * f64::from(side(number))) }
    pub fn u32(number: usize, value: u32) -> u32 { value.wrapping_add_signed(side(number).into()) }
    pub fn usize(number: usize, value: usize) -> usize { value.wrapping_add_signed(side(number).into()) }
}
"""


def switched(text: str, numbers: dict[str, tuple[int, str]]) -> str:
    """The source with each use of a constant behind its number."""
    if not numbers:
        return text
    use = re.compile(r"(?<![\w:])((?:\w+::)*)(%s)\b(?!::|:)" % "|".join(numbers))

    def behind(match: re.Match) -> str:
        number, kind = numbers[match[2]]
        return f"crate::nudged::{kind}({number}, {match[0]})"

    kept = [(match.start(), match.end()) for match in KEPT.finditer(text)]
    pieces, end = [], 0
    for start, stop in kept:
        pieces += [use.sub(behind, text[end:start]), text[start:stop]]
        end = stop
    return "".join(pieces + [use.sub(behind, text[end:])])


def build(copy: Path) -> list[str]:
    """Writes the switched sources into a copy; returns what each number stands for."""
    ignored = shutil.ignore_patterns(".git", "target", "node_modules", ".venv")
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(ROOT, copy, ignore=ignored)
    paths = sorted(path for folder in FOLDERS for path in (copy / "src" / folder).rglob("*.rs"))
    texts = {path: path.read_text() for path in paths}
    everything = "\n".join(texts.values())
    labels: list[str] = []
    own: dict[Path, dict[str, tuple[int, str]]] = {path: {} for path in paths}
    public: dict[str, tuple[int, str]] = {}
    for path, text in texts.items():
        for match in CONSTANT.finditer(re.split(r"#\[cfg\(test\)\]\s*mod ", text)[0]):
            visible, name, kind = match.groups()
            if path.name == "tests.rs" or re.search(rf"; (\w+::)*{name}\b|<([^<>();]*, )?{name}\b|[A-Z_]+: .* = .*\b{name}\b", everything):
                continue
            own[path][name] = (len(labels), kind)
            if visible:
                public[name] = own[path][name]
            labels.append(f"{path.relative_to(copy / 'src')}:{name}")
    for path, text in texts.items():
        imported = {name: number for name, number in public.items() if name not in own[path] and f"const {name}:" not in text}
        # The type of these no longer follows from the constants beside them.
        text = re.sub(r"\bin \[(-?\d+(?:\.\d+|e-?\d+)), ", r"in [\1_f64, ", text)
        path.write_text(switched(text, {**imported, **own[path]}))
    library = copy / "src" / "lib.rs"
    library.write_text(library.read_text() + SWITCH)
    return labels


def main() -> int:
    wanted = re.compile(sys.argv[1] if len(sys.argv) > 1 else ".")
    tests = sys.argv[2:] or [f"{folder}::" for folder in FOLDERS]
    copy = TARGET / "nudged"
    labels = build(copy)
    environment = {**os.environ, "CARGO_TARGET_DIR": str(TARGET / "nudged-build")}
    command = ["cargo", "test", "--profile", "mutants", "--locked", "--lib", "--no-run"]
    built = subprocess.run(command, cwd=copy, env=environment, text=True, stderr=subprocess.PIPE)
    if built.returncode != 0:
        print(built.stderr, file=sys.stderr)
        return built.returncode
    program = copy / re.findall(r"\(([^)]*/asperity-[0-9a-f]+)\)", built.stderr)[-1]

    def failures(number: int, side: int) -> list[str]:
        chosen = {**environment, "NUDGED": str(number), "NUDGED_SIDE": str(side)}
        try:
            run = subprocess.run([program, *tests], cwd=copy, env=chosen, text=True, capture_output=True, timeout=600)
        except subprocess.TimeoutExpired:
            return ["does not end"]
        failed = re.findall(r"^test (\S+) \.\.\. FAILED", run.stdout, re.M)
        return failed or ([] if run.returncode == 0 else ["ends early"])

    fails = failures(-1, 0)
    print(f"as it is: {', '.join(fails) or 'passes'}")
    for number, label in enumerate(labels):
        if wanted.search(label):
            sides = [failures(number, side) for side in (1, -1)]
            print(f"{label}: +4 % {', '.join(sides[0]) or 'passes'}; -4 % {', '.join(sides[1]) or 'passes'}", flush=True)
    return int(bool(fails))


if __name__ == "__main__":
    sys.exit(main())
