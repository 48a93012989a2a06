#!/usr/bin/env python3
"""Which changes of the Rust sources no test notices: one operator, one function's answer, one arm of a match at a time.

usage: tests/harden/mutants.py FOLDER [--re EXPRESSION] [--shard K/N] [--groups NAMES] [--seconds S] [--slowest S]

cargo-mutants lists the changes. All stand in one build of a copy of the sources, each behind its number, which a variable of the
environment chooses: `a + b` becomes `(if on(7) { a - b } else { a + b })`. Each unit test and each test of --groups runs once and
tells which changes it reaches; each change is then tried by the tests that reach it, the fastest first, up to --seconds (60) of
the processor. Tests that take longer than --slowest (60) are left out. A run that is ended early has tried a sample. Results are
in FOLDER. It fails if more are missed in a function than tests/harden/survivors.txt explains. Needs tree-sitter and its grammar of
Rust (tests/setup.sh harden).
"""

from __future__ import annotations

import argparse
import collections
import json
import os
import random
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import tree_sitter
import tree_sitter_rust

ROOT = Path(__file__).resolve().parents[2]
GROUPS = "abi,c_api,law,numerics,physics"
# Reads the number without an allocation: the allocator of the library is among what is changed.
SWITCH = """
#[allow(missing_docs, unsafe_code, dead_code)]
pub(crate) mod changed {
    use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};
    const UNREAD: u32 = u32::MAX;
    const RECORD: u32 = u32::MAX - 1;
    static CHOSEN: AtomicU32 = AtomicU32::new(UNREAD);
    static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];
    extern "C" {
        fn getenv(name: *const u8) -> *const u8;
        fn atoi(text: *const u8) -> i32;
        fn open(name: *const u8, flags: i32, mode: u32) -> i32;
        fn write(file: i32, bytes: *const u32, size: usize) -> isize;
        fn close(file: i32) -> i32;
    }
    #[inline]
    pub fn on(number: u32) -> bool {
        match CHOSEN.load(Relaxed) {
            RECORD if REACHED[number as usize].load(Relaxed) => false,
            UNREAD | RECORD => first(number),
            chosen => chosen == number,
        }
    }
    #[cold]
    #[inline(never)]
    fn first(number: u32) -> bool {
        unsafe {
            let file = getenv(c"ASPERITY_CHANGES".as_ptr().cast());
            let chosen = getenv(c"ASPERITY_CHANGE".as_ptr().cast());
            if file.is_null() {
                let chosen = if chosen.is_null() { 0 } else { atoi(chosen) as u32 };
                CHOSEN.store(chosen, Relaxed);
                return chosen == number;
            }
            CHOSEN.store(RECORD, Relaxed);
            if !REACHED[number as usize].swap(true, Relaxed) {
                let file = open(file, 0o2101, 0o644); // to be appended to, made if need be
                write(file, &number, 4);
                close(file);
            }
        }
        false
    }
}
"""


class Change:
    """One of cargo-mutants, its number from 1, and where it stands in the bytes of its file."""

    def __init__(self, number: int, told: dict) -> None:
        self.number, self.file, self.name, self.genre = number, told["file"], told["name"], told["genre"]
        self.text, self.span = told["replacement"], told["span"]
        self.place = (told["function"] or {"function_name": "constants"})["function_name"]


def listed(tree: Path, expression: str, shard: str) -> list[Change]:
    """The changes of the sources. cargo-mutants passes over functions that are `unsafe`, which those of C are: so they are none
    while it looks."""
    kept = {}
    for file in (tree / "src").rglob("*.rs"):
        kept[file] = file.read_text()
        file.write_text(re.sub(r"\bunsafe (?=extern|fn)", "       ", kept[file]))
    command = ["cargo", "mutants", "--list", "--json", "--no-shuffle", "--re", expression, "--shard", shard]
    told = subprocess.run(command, cwd=tree, check=True, capture_output=True)
    for file, text in kept.items():
        file.write_text(text)
    # It lists fields of structs of all files.
    told = [one for one in json.loads(told.stdout) if re.search(expression, one["name"])]
    return [Change(number, one) for number, one in enumerate(told, 1)]


class File:
    """A source file in which changes are written behind their numbers."""

    def __init__(self, text: bytes) -> None:
        self.text = text
        self.lines = [0]
        for line in text.splitlines(keepends=True):
            self.lines.append(self.lines[-1] + len(line))
        self.tree = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language())).parse(text).root_node
        # Start, end and what becomes of the text between: a function of the text with the changes inside.
        self.edits: list[tuple[int, int, list[tuple[int, str]], str]] = []

    def offset(self, place: dict) -> int:
        line = self.lines[place["line"] - 1]
        return line + len(self.text[line:].decode()[: place["column"] - 1].encode())

    def of(self, node: tree_sitter.Node, start: int | None = None, end: int | None = None) -> str:
        return self.text[node.start_byte if start is None else start : node.end_byte if end is None else end].decode()

    def add(self, change: Change) -> bool:
        """Whether there is a place for it: not in constants and patterns."""
        start, end = self.offset(change.span["start"]), self.offset(change.span["end"])
        node = self.tree.descendant_for_byte_range(start, end)
        if any(above.type in ("const_item", "static_item", "const_block") or is_const(above) for above in ancestors(node)):
            return False
        return getattr(self, f"_{change.genre}")(change, node, start, end)

    def _alternative(self, node: tree_sitter.Node, change: Change, text: str) -> bool:
        self.edits.append((node.start_byte, node.end_byte, [(change.number, text)], ""))
        return True

    def _BinaryOperator(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        whole = node.parent
        if whole is None or whole.type not in ("binary_expression", "compound_assignment_expr"):
            return False
        return self._alternative(whole, change, f"{self.of(whole, end=start)}{change.text}{self.of(whole, start=end)}")

    def _UnaryOperator(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        whole = node.parent if node.type != "unary_expression" else node
        if whole is None or whole.type != "unary_expression":
            return False
        return self._alternative(whole, change, self.of(whole, start=end))

    def _MatchArmGuard(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        return self._alternative(node, change, change.text)

    def _StructField(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        whole = next(above for above in ancestors(node) if above.type == "struct_expression")
        rest = re.sub(r"^\s*,", "", self.of(whole, start=end))
        return self._alternative(whole, change, self.of(whole, end=start) + rest)

    def _FnValue(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        whole = next(above for above in ancestors(node) if above.type == "function_item")
        at = whole.child_by_field_name("body").start_byte + 1
        answer = marked(change.number, f"return {change.text};")
        self.edits.append((at, at, [], f" if crate::changed::on({change.number}) {{ {answer} }} "))
        return True

    def _MatchArm(self, change: Change, node: tree_sitter.Node, start: int, end: int) -> bool:
        pattern = next(above for above in ancestors(node) if above.type == "match_arm").child_by_field_name("pattern")
        guard = pattern.child_by_field_name("condition")
        if guard is not None and guard.type.startswith("let"):
            return False
        at = pattern.end_byte if guard is None else guard.start_byte
        before, after = (" if ", "") if guard is None else ("", " && ")
        self.edits.append((at, at, [], f"{before}!crate::changed::on({change.number}){after}"))
        return True

    def written(self) -> str:
        """The text with all changes in it."""
        groups: dict[tuple[int, int], list] = collections.defaultdict(list)
        inserted: dict[int, str] = collections.defaultdict(str)
        for start, end, alternatives, text in self.edits:
            if alternatives:
                groups[start, end] += alternatives
            else:
                inserted[start] += text
        order = sorted(groups, key=lambda span: (span[0], -span[1]))
        places = sorted(inserted)

        def part(start: int, end: int) -> str:
            out, at = [], start

            def plain(to: int) -> None:
                nonlocal at
                while places and places[0] <= to and places[0] >= at:
                    out.append(self.text[at : places[0]].decode() + inserted[places[0]])
                    at = places.pop(0)
                out.append(self.text[at:to].decode())
                at = to

            while order and order[0][0] < end and order[0][1] <= end:
                span = order.pop(0)
                plain(span[0])
                cases = [f"if crate::changed::on({number}) {{ {marked(number, text)} }} else " for number, text in groups[span]]
                out.append(f"({''.join(cases)}{{ {part(*span)} }})")
                at = span[1]
            plain(end)
            return "".join(out)

        return part(0, len(self.text))


def marked(number: int, text: str) -> str:
    return f"/*<{number}*/{text}/*{number}>*/"


def is_const(node: tree_sitter.Node) -> bool:
    return any(child.type == "function_modifiers" and b"const" in child.text.split() for child in node.children)


def ancestors(node: tree_sitter.Node | None):
    while node is not None:
        yield node
        node = node.parent


def build(
    tree: Path, sources: dict[str, bytes], changes: list[Change], groups: str, env: dict[str, str]
) -> tuple[list[Path], set[int]]:
    """The test programs with all changes that compile, and the numbers of the others."""
    library = tree / "src/lib.rs"
    library.write_text(library.read_text() + SWITCH.replace("COUNT", str(len(changes) + 1)))
    left_out: set[int] = set()
    while True:
        for name, text in sources.items():
            file = File(text)
            for change in changes:
                if change.file == name and change.number not in left_out and not file.add(change):
                    left_out.add(change.number)
            (tree / name).write_text(file.written())
        command = ["cargo", "test", "--no-run", "--locked", "--profile", "mutants", "--lib", "--message-format", "json"]
        command += [argument for group in groups.split(",") for argument in ("--test", group)]
        done = subprocess.run(command, cwd=tree, env=env, text=True, stdout=subprocess.PIPE)
        told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode == 0:
            return [Path(one["executable"]) for one in told if one.get("executable")], left_out
        found = set()
        for one in told:
            message = one.get("message", {})
            if one["reason"] == "compiler-message" and message["level"] == "error":
                found |= blamed(tree, message)
        if not found - left_out:
            sys.exit("cargo test: fails for no change; see above")
        print(f"{len(found - left_out)} changes do not compile")
        left_out |= found


def blamed(tree: Path, message: dict) -> set[int]:
    """The changes that an error of the compiler is in; else those on its lines."""
    found: set[int] = set()
    for span in message["spans"]:
        file = tree / span["file_name"]
        if not file.is_file():
            continue
        text = file.read_bytes()
        before = text[: span["byte_end"]]
        opened = re.findall(rb"/\*<(\d+)\*/", before)
        open_now = [int(number) for number in opened[-40:] if b"/*%s>*/" % number not in text[: span["byte_start"]]]
        if open_now:
            found.add(open_now[-1])
            continue
        first = text.rfind(b"\n", 0, span["byte_start"])
        last = text.find(b"\n", span["byte_end"])
        found |= {int(number) for number in re.findall(rb"changed::on\((\d+)\)", text[first:last])}
    return found


class Tests:
    """Each test: its program, its name, seconds of the processor, and the changes that it reaches."""

    def __init__(self, programs: list[Path], tree: Path, folder: Path, env: dict[str, str], slowest: float) -> None:
        self.tree, self.env = tree, env
        jobs = []
        for program in programs:
            told = subprocess.run([program, "--list", "--format", "terse"], capture_output=True, text=True, check=True)
            jobs += [(program, line.removesuffix(": test")) for line in told.stdout.splitlines() if line.endswith(": test")]
        self.all: list[tuple[float, Path, str]] = []
        self.reaching: dict[int, list[int]] = collections.defaultdict(list)
        # By file: what noticed changes there, and how often.
        self.noticing: dict[str, collections.Counter[int]] = collections.defaultdict(collections.Counter)

        def one(job: tuple[int, tuple[Path, str]]) -> tuple[tuple[float, Path, str], set[int]] | None:
            index, (program, name) = job
            reached = folder / f"reached.{index}"
            reached.unlink(missing_ok=True)
            passed, seconds = self.run(program, name, {"ASPERITY_CHANGES": str(reached)}, slowest)
            numbers = set(memoryview(reached.read_bytes()).cast("I")) if reached.exists() else set()
            reached.unlink(missing_ok=True)
            if not passed:
                print(f"left out, takes longer than {slowest:g} s, or fails: {program.name.rsplit('-', 1)[0]} {name}")
                return None
            return (seconds, program, name), numbers

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for found in filter(None, pool.map(one, enumerate(jobs))):
                for number in found[1]:
                    self.reaching[number].append(len(self.all))
                self.all.append(found[0])

    def run(self, program: Path, name: str, env: dict[str, str], seconds: float) -> tuple[bool, float]:
        """Whether a test passes within seconds of the processor, and how many it took."""
        command = ["sh", "-c", 'ulimit -t "$0" && exec "$@"', f"{seconds + 1:.0f}", program, "--exact", name]
        null = subprocess.DEVNULL
        process = subprocess.Popen(command, cwd=self.tree, env=self.env | env, stdout=null, stderr=null)
        asleep = threading.Timer(900, process.kill)  # threads that wait for each other
        asleep.start()
        _, status, used = os.wait4(process.pid, 0)
        asleep.cancel()
        process.returncode = status
        return status == 0, used.ru_utime + used.ru_stime

    def noticed(self, change: Change, most: float) -> str:
        """The test that notices a change, or "": first those that have noticed others in its file, then the fastest ones."""
        reaching, often = set(self.reaching[change.number]), self.noticing[change.file]
        first = [index for index, _ in often.most_common() if index in reaching][:4]
        spent = 0.0
        for index in first + sorted(reaching - set(first), key=lambda index: self.all[index][0]):
            seconds, program, name = self.all[index]
            spent += seconds
            if spent > most and spent > seconds:
                break
            if not self.run(program, name, {"ASPERITY_CHANGE": str(change.number)}, 2 + 10 * seconds)[0]:
                often[index] += 1
                return f"{program.name.rsplit('-', 1)[0]} {name}"
        return ""


def unexplained(missed: list[Change]) -> list[str]:
    known: dict[tuple[str, str], int] = {}
    for line in (ROOT / "tests/harden/survivors.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            count_and_file, place, _ = line.split(" | ", 2)
            count, file = count_and_file.split()
            known[file, place] = int(count)
    found = collections.Counter((change.file, change.place) for change in missed)
    more = {key: count for key, count in sorted(found.items()) if count > known.get(key, 0)}
    return [f"{count} ({known.get(key, 0)} explained) {' | '.join(key)}" for key, count in more.items()]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--re", default=".")
    parser.add_argument("--shard", default="0/1")
    parser.add_argument("--groups", default=GROUPS)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--slowest", type=float, default=60.0)
    given = parser.parse_args()
    folder = given.folder.resolve()
    tree = folder / "tree"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.split("\0")
    for name in files:
        if name and (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, tree / name)
    env = os.environ | {"CARGO_TARGET_DIR": str(folder / "target"), "RUSTFLAGS": "--cap-lints=allow", "CARGO_TERM_COLOR": "never"}
    changes = listed(tree, given.re, given.shard)
    sources = {name: (ROOT / name).read_bytes() for name in sorted({change.file for change in changes})}
    start = time.monotonic()
    programs, left_out = build(tree, sources, changes, given.groups, env)
    print(f"{len(changes)} changes, of which {len(left_out)} do not compile or are of constants", flush=True)
    print(f"built in {time.monotonic() - start:.0f} s", flush=True)
    (folder / "left_out.txt").write_text("".join(f"{change.name}\n" for change in changes if change.number in left_out))
    start = time.monotonic()
    tests = Tests(programs, tree, folder, env, given.slowest)
    print(f"{len(tests.all)} tests in {time.monotonic() - start:.0f} s, one by one", flush=True)
    missed: list[Change] = []
    results = (folder / "results.txt").open("w")

    # In no order, so that a run that is ended early has tried a sample.
    rest = [change for change in changes if change.number not in left_out]
    random.Random(1).shuffle(rest)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        trying = {pool.submit(tests.noticed, change, given.seconds): change for change in rest}
        for done in as_completed(trying):
            change, test = trying[done], done.result()
            found = test or ("missed" if tests.reaching[change.number] else "not reached")
            print(f"{change.name}: {found}", file=results, flush=True)
            if not test:
                missed.append(change)
    (folder / "missed.txt").write_text("".join(f"{change.name}\n" for change in missed))
    print(f"{len(missed)} changes that no test notices, in {folder}/missed.txt")
    if more := unexplained(missed):
        says = "more than tests/harden/survivors.txt explains: write a test that notices them, or a line there"
        sys.exit("\n".join([says, *more]))


if __name__ == "__main__":
    main()
