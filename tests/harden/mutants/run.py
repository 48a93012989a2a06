"""Runs the tests against each mutant of the physics and the C interface: `make mutants`.

cargo-mutants says what the mutants are (.cargo/mutants.toml), functions marked unsafe included; plant.py puts them all into
one copy of the sources, which is built once. Each test runs alone once, to learn which functions with mutants it reaches
and how long it takes; then each mutant meets the tests that reach it until one fails. What cannot be planted (constants) is
for cargo-mutants itself.

What is found is kept for as long as the function of a mutant stays as it is. Fails if a mutant is left that explained.txt
does not give a reason for, or if this gives one for what is no longer there.

usage: run.py FOLDER [--jobs N] [--shard K/N] [--seconds S] [--again | --resume] [--only PATTERN]
              [--tests PATTERN]
    FOLDER     for the copy, what is built and the outcome; kept from run to run
    --seconds  tests that take longer are left out
    --again    only mutants that the last run did not catch and explained.txt gives no reason for
    --resume   only mutants of which nothing is known
    --only     only mutants in whose names, which begin with the file, this pattern is found
    --tests    only tests in whose names this pattern is found
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import time

import explained
import plant

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Programs in C; and tests that also run on another processor, emulated, so that AVX2 is seen where AVX-512 is at hand.
PROGRAMS = ["contract", "old_caller", "tables", "traps"]
EMULATED = "c_api batch::"
EMULATOR = ["qemu-x86_64", "-cpu", "Haswell"]
TARGETS = ["physics", "numerics", "law", "c_api"]
MEMORY = 8 << 30
OPEN = ("missed", "not reached", "timeout")
# Short forms of the tests that have a length.
LENGTHS = {"ASPERITY_FUZZ_CALLS": "5000", "ASPERITY_DOMAIN_SETS": "40"}


def run(command, **more):
    return subprocess.run(command, check=True, text=True, **more)


def listed(folder):
    """The mutants of cargo-mutants, for the sources without `unsafe` and `new`, whose functions it would pass over."""
    bare = folder / "listed"
    copy(bare)
    for path in (bare / "src").rglob("*.rs"):
        source = re.sub(r"\bunsafe ((?:extern \"C\" )?fn)", r"       \1", path.read_text())
        path.write_text(source.replace("fn new(", "fn NEW("))
    found = run(["cargo", "mutants", "--list", "--json"], cwd=bare, stdout=subprocess.PIPE).stdout
    found = json.loads(found.replace("::NEW", "::new"))
    for number, mutant in enumerate(found, 1):
        mutant["number"] = number
        mutant["key"] = key(mutant)
    return found


def place(mutant):
    """What it is called in explained.txt."""
    return explained.place(mutant, (ROOT / mutant["file"]).read_text().splitlines())


def key(mutant):
    """What a mutant is known by for as long as its function stays as it is, wherever in its file that is."""
    if not mutant["function"]:
        return mutant["name"]
    lines = (ROOT / mutant["file"]).read_text().splitlines()
    start, end = (mutant["function"]["span"][side]["line"] for side in ("start", "end"))
    text = hashlib.sha256("\n".join(lines[start - 1:end]).encode()).hexdigest()[:12]
    place, what = mutant["span"]["start"], mutant["name"].split(": ", 1)[1]
    return f"{mutant['file']}: {what} ({text} {place['line'] - start}:{place['column']})"


def copy(to, changed={}):
    """The files of the repository, some changed; what is there already keeps its time, so that cargo builds no more than it
    must."""
    for name in run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, stdout=subprocess.PIPE).stdout.split():
        if not (ROOT / name).is_file():
            continue
        content, target = changed.get(name, (ROOT / name).read_bytes()), to / name
        if not (target.is_file() and target.read_bytes() == content):
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)


def planted(folder, mutants):
    """Writes the copy with all mutants; those that are left out."""
    left = []
    by_file = collections.defaultdict(list)
    for mutant in mutants:
        by_file[mutant["file"]].append(mutant)
    changed = {}
    for name, here in by_file.items():
        source, not_planted = plant.planted((ROOT / name).read_text(), here)
        left += not_planted
        changed[name] = source.encode()
    library = (ROOT / "src/lib.rs").read_text()
    module = "#[allow(missing_docs)]\npub mod mutant;\npub mod asperity;"
    changed["src/lib.rs"] = library.replace("pub mod asperity;", module, 1).encode()
    copy(folder / "tree", changed)
    switch = folder / "tree/src/mutant.rs"
    count = max(mutant["number"] for mutant in mutants) + 1
    source = plant.SWITCH % (count, count)
    if not switch.exists() or switch.read_text() != source:
        switch.write_text(source)
    return left


def built(folder):
    """Test programs by target, or the numbers of mutants that do not compile."""
    tree = folder / "tree"
    command = ["cargo", "test", "--profile", "mutants", "--locked", "--no-run", "--message-format=json", "--lib"]
    command += [word for target in TARGETS for word in ("--test", target)]
    output = subprocess.run(command, cwd=tree, env=cargo(folder), text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    programs, unviable, other = {}, set(), []
    for line in output.stdout.splitlines():
        message = json.loads(line)
        if message["reason"] == "compiler-artifact" and message["executable"] and message["profile"]["test"]:
            programs[message["target"]["name"]] = message["executable"]
        elif message["reason"] == "compiler-message" and message["message"]["level"] == "error":
            spans = [span for span in message["message"]["spans"] if span["is_primary"]]
            numbers = {around(tree / span["file_name"], span["byte_start"], span["byte_end"]) for span in spans}
            if numbers - {None}:
                unviable |= numbers - {None}
            elif spans:
                other.append(message["message"]["rendered"])
    if other and not unviable:
        sys.exit("the copy does not build:\n" + "\n".join(other[:5]))
    if output.returncode and not unviable:
        sys.exit(output.stderr)
    return programs, unviable


def compiled(folder):
    """The programs in C, with the shared library of the mutants."""
    library = folder / "target/mutants"
    run(["cargo", "build", "--profile", "mutants", "--locked", "--quiet"], cwd=folder / "tree", env=cargo(folder))
    for name in PROGRAMS:
        flags = ["-O1", "-Iinclude", f"-L{library}", f"-Wl,-rpath,{library}"]
        libraries = ["-lasperity", "-lm", "-lpthread"]
        run(["cc", *flags, f"tests/c/{name}.c", "-o", str(folder / name), *libraries], cwd=folder / "tree")


def cargo(folder):
    """The same for every build, so that all is built once."""
    return dict(os.environ, CARGO_TARGET_DIR=str(folder / "target"), RUSTFLAGS="--cap-lints=warn -Awarnings")


def around(path, start, end):
    """The mutant whose text is there."""
    for found in re.finditer(rb"/\*<(\d+)\*/.*?/\*\1>\*/", path.read_bytes(), re.S):
        if found.start() <= start and end <= found.end():
            return int(found[1])
    return None


def limits(seconds):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        # Of processor time, to the fraction of a second; it goes on in the program that takes this process's place.
        signal.setitimer(signal.ITIMER_PROF, seconds)
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    return limit


def call(command, folder, seconds, **environment):
    """How a test ends: passed, failed or timeout; and its processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        end = subprocess.run(
            command, cwd=folder / "tree", stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=20 * seconds + 20, preexec_fn=limits(seconds),
            start_new_session=True, env=dict(os.environ, **LENGTHS, **environment))
    except subprocess.TimeoutExpired:
        return "timeout", seconds
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if end.returncode in (-signal.SIGPROF, -signal.SIGKILL):
        return "timeout", spent
    return ("passed" if end.returncode == 0 else "failed"), spent


def surveyed(folder, programs, asked):
    """Of each test that takes no longer: its time, and the functions with mutants that it reaches.

    What is known of unchanged programs is kept.
    """
    kept, longest = folder / "tests.json", asked.seconds
    known = json.loads(kept.read_text()) if kept.exists() else {}
    commands = {name: [str(folder / name)] for name in PROGRAMS}
    built = {name: os.stat(folder / "target/mutants/libasperity.so").st_mtime for name in PROGRAMS}
    for target, program in programs.items():
        names = run([program, "--list"], cwd=folder / "tree", stdout=subprocess.PIPE).stdout
        for name in re.findall(r"^(.*): test$", names, re.M):
            if name.startswith("programs::"):
                continue  # they are among PROGRAMS, where nothing is compiled for each mutant
            command = [program, "--exact", name, "--test-threads=1"]
            commands[f"{target} {name}"] = command
            if f"{target} {name}".startswith(EMULATED):
                commands[f"{target} {name}, emulated"] = [*EMULATOR, *command]
        built |= {name: os.stat(program).st_mtime for name in commands if name not in built}
    tests = []
    for name, command in commands.items():
        if not re.search(asked.tests, name):
            continue
        build = f"{name}, {built[name]}"
        if known.get(build, {"asked": 0})["asked"] < longest:
            known[build] = survey(folder, command, longest)
            print(f"{name}: {known[build]['end']}, {known[build]['seconds']:.2f} s", flush=True)
        if known[build]["end"] == "passed" and known[build]["seconds"] <= longest:
            sites = set(known[build]["sites"])
            tests.append({"name": name, "command": command, **known[build], "sites": sites, "met": 0, "caught": 0})
    kept.write_text(json.dumps(known))
    return tests


def survey(folder, command, longest):
    reached = folder / "reached"
    reached.unlink(missing_ok=True)
    end, seconds = call(command, folder, longest, ASPERITY_REACHED=str(reached))
    sites = [int(line) for line in reached.read_text().split()] if reached.exists() else []
    return {"asked": longest, "end": end, "seconds": seconds, "sites": sites}


def judged(folder, mutant, tests, killers):
    """What becomes of a mutant, and the test that decides. The test that caught the last one of its function comes first,
    then those that catch most for their time.

    One that makes a test slow may fail another: only the third that does not end decides.
    """
    reaching = [test for test in tests if mutant["site"] in test["sites"]]
    worth = lambda test: (1 + test["caught"]) / (1 + test["met"]) / (0.005 + test["seconds"])
    reaching.sort(key=lambda test: (test is not killers.get(mutant["site"]), -worth(test)))
    slow = []
    for test in reaching:
        test["met"] += 1
        end, _ = call(test["command"], folder, 0.3 + 6 * test["seconds"], ASPERITY_MUTANT=str(mutant["number"]))
        if end == "failed":
            killers[mutant["site"]] = test
            test["caught"] += 1
            return "caught", test["name"]
        if end == "timeout":
            slow.append(test["name"])
            if len(slow) == 3:
                break
    if slow:
        return "timeout", ", ".join(slow)
    return ("missed" if reaching else "not reached"), ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--shard", default="0/1")
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--tests", default="")
    asked = parser.parse_args()
    folder = asked.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)

    mutants = listed(folder)
    print(f"{len(mutants)} mutants", flush=True)
    # Known from run to run: what does not compile.
    kept = folder / "unviable.json"
    known = set(json.loads(kept.read_text())) if kept.exists() else set()
    unviable = {mutant["number"] for mutant in mutants if mutant["name"] + mutant["diff"] in known}
    while True:
        left = planted(folder, [mutant for mutant in mutants if mutant["number"] not in unviable])
        programs, more = built(folder)
        if not more:
            break
        unviable |= more
        print(f"{len(unviable)} do not compile", flush=True)
    kept.write_text(json.dumps([mutant["name"] + mutant["diff"] for mutant in mutants if mutant["number"] in unviable]))
    compiled(folder)
    tests = surveyed(folder, programs, asked)
    print(f"{len(tests)} tests, {sum(test['seconds'] for test in tests):.1f} s", flush=True)

    not_planted = {mutant["number"] for mutant in left}
    part, parts = map(int, asked.shard.split("/"))
    alive = [mutant for mutant in mutants if mutant["number"] not in unviable | not_planted]
    chosen = [mutant for i, mutant in enumerate(alive) if i % parts == part and re.search(asked.only, mutant["name"])]
    outcome = folder / "outcome.json"
    ends = json.loads(outcome.read_text()) if outcome.exists() else {}
    if asked.again:
        reasons = explained.read()
        chosen = [mutant for mutant in chosen if ends.get(mutant["key"], [""])[0] in OPEN and place(mutant) not in reasons]
    elif asked.resume:
        chosen = [mutant for mutant in chosen if mutant["key"] not in ends]
    started, killers = time.time(), {}
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        judge = lambda mutant: (mutant, judged(folder, mutant, tests, killers))
        for done, (mutant, end) in enumerate(pool.map(judge, chosen), 1):
            ends[mutant["key"]] = end
            if done % 20 == 0 or done == len(chosen):
                print(f"{done} of {len(chosen)} after {time.time() - started:.0f} s", flush=True)
                outcome.write_text(json.dumps(ends, indent=0))
    report(folder, mutants, {mutant["number"] for mutant in alive}, unviable, ends)


def report(folder, mutants, alive, unviable, ends):
    """What is known of all mutants, by file; whether all that are left have a reason."""
    reasons = explained.read()
    by_file, by_kind, left = collections.defaultdict(collections.Counter), collections.Counter(), []
    gone = set(reasons)
    for mutant in mutants:
        here = place(mutant)
        gone.discard(here)
        if mutant["number"] in alive:
            end = ends.get(mutant["key"], ["not run"])[0]
        else:
            end = "no build" if mutant["number"] in unviable else "constant"
        if end in ("missed", "not reached"):
            end = "explained" if here in reasons else "left"
            if end == "explained":
                by_kind[reasons[here]] += 1
            else:
                left.append(here)
        by_file[mutant["file"]][end] += 1
    by_file["all"] = sum(by_file.values(), collections.Counter())
    columns = ["caught", "timeout", "explained", "left", "not run", "constant", "no build"]
    print("".join(f"{column:>12}" for column in columns))
    for name, counts in sorted(by_file.items(), key=lambda file: (file[0] == "all", file[0])):
        print("".join(f"{counts[column]:>12}" for column in columns), "", name)
    print("reasons:", ", ".join(f"{kind} {count}" for kind, count in by_kind.most_common()))
    (folder / "left.txt").write_text(explained.written(left))
    if left:
        print(f"no test catches these, and explained.txt does not say why: {folder / 'left.txt'}")
    if gone:
        print("explained.txt has these, which are no longer in the sources:")
        print(explained.written(sorted(gone)))
    if left or gone:
        sys.exit(1)


if __name__ == "__main__":
    main()
