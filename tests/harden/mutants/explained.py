"""Reads explained.txt: the mutants that no test catches, each with the reason why none need.

    src/root.rs between
      equal: What follows is the same for both.
        if low [[<]] high {  ->  <=  ==

A file and a function; reasons, each with a word for its kind; below a reason the lines of the source that it is about, what
is changed in double brackets, and what it is changed to, with two spaces between one replacement and the next. A function
replaced as a whole is `[[body]]`, what is deleted is changed to `nothing`.
"""

import collections
import pathlib
import re

LIST = pathlib.Path(__file__).with_name("explained.txt")
KINDS = "equal", "start", "panels", "digits", "same", "processor", "elsewhere", "unknown"


def read():
    """The kind of reason for each mutant of the list, by `place`."""
    kinds, function, kind = {}, "", ""
    for number, line in enumerate(LIST.read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        depth, text = len(line) - len(line.lstrip()), line.strip()
        if depth == 0:
            function, kind = text, ""
        elif depth == 2:
            # A reason may go on in further lines.
            word = text.split(":")[0]
            kind = word if word in KINDS else kind
        elif depth == 4 and kind and "  ->  " in text:
            source, replacements = text.split("  ->  ")
            for replacement in re.split(r"  +", replacements):
                kinds[function, source, replacement] = kind
        else:
            raise SystemExit(f"{LIST}:{number}: not understood: {line}")
    return kinds


def place(mutant, lines):
    """What a mutant is called in the list; `lines` are those of its file."""
    function = f"{mutant['file']} {mutant['function']['function_name']}" if mutant["function"] else mutant["file"]
    start, end = mutant["span"]["start"], mutant["span"]["end"]
    if mutant["genre"] == "FnValue":
        source = "[[body]]"
    else:
        line = lines[start["line"] - 1]
        until = end["column"] - 1 if end["line"] == start["line"] else len(line)
        begin = start["column"] - 1
        source = re.sub(r" +", " ", f"{line[:begin]}[[{line[begin:until]}]]{line[until:]}".strip())
    return function, source, re.sub(r"\s+", " ", mutant["replacement"]) or "nothing"


def written(places):
    """Mutants in the form of the list, for reasons to be written between."""
    lines, by_function = [], collections.defaultdict(lambda: collections.defaultdict(list))
    for function, source, replacement in places:
        by_function[function][source].append(replacement)
    for function, sources in by_function.items():
        lines.append(function)
        lines += [f"    {source}  ->  {'  '.join(replacements)}" for source, replacements in sources.items()]
        lines.append("")
    return "\n".join(lines)
