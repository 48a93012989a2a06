"""Puts every mutant of a list of cargo-mutants into one source tree, each behind its number.

A program then has all mutants, and the environment variable ASPERITY_MUTANT says which one is alive: one build instead of
thousands. An expression `a + b` with mutants 7 and 8 becomes

    ({ let (l, r) = (a, b); match crate::mutant::at(7) { 7 => l - r, 8 => l * r, _ => l + r } })

in a second copy of the function's body, which runs where one of its mutants is alive: the others keep their speed.
What stands in a constant cannot be chosen at run time, and is returned as not planted.
"""

import collections
import re

import tree_sitter
import tree_sitter_rust

LANGUAGE = tree_sitter.Language(tree_sitter_rust.language())
COMPARISONS = {"==", "!=", "<", ">", "<=", ">="}
SWITCH = '''//! Which mutant is alive: none, one, or none while what is reached is written down.

use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

const UNKNOWN: u32 = u32::MAX;
const RECORDING: u32 = u32::MAX - 1;
static ALIVE: AtomicU32 = AtomicU32::new(UNKNOWN);
static REACHED: [AtomicBool; %d] = [const { AtomicBool::new(false) }; %d];

#[inline]
pub fn at(site: u32) -> u32 {
    let alive = ALIVE.load(Relaxed);
    if alive < RECORDING { alive } else { at_first(site) }
}

/// Whether a function that has these mutants runs with them.
#[inline]
pub fn within(first: u32, last: u32) -> bool {
    let mut alive = ALIVE.load(Relaxed);
    if alive >= RECORDING {
        alive = at_first(first);
    }
    first <= alive && alive <= last
}

#[cold]
#[inline(never)]
fn at_first(site: u32) -> u32 {
    if ALIVE.load(Relaxed) == UNKNOWN {
        let alive = match std::env::var("ASPERITY_MUTANT") {
            Ok(number) => number.parse().expect("a number"),
            Err(_) if std::env::var_os("ASPERITY_REACHED").is_some() => RECORDING,
            Err(_) => 0,
        };
        if alive != RECORDING && alive != 0 {
            // The first failure of a test is enough. Panics of the library are its own matter.
            let hook = std::panic::take_hook();
            std::panic::set_hook(Box::new(move |panic| {
                hook(panic);
                if panic.location().is_some_and(|location| location.file().starts_with("tests/")) {
                    std::process::exit(101);
                }
            }));
        }
        ALIVE.store(alive, Relaxed);
        return at(site);
    }
    if !REACHED[site as usize].swap(true, Relaxed) {
        let path = std::env::var_os("ASPERITY_REACHED").expect("a file");
        let mut file = std::fs::OpenOptions::new().create(true).append(true).open(path).expect("the file opens");
        file.write_all(format!("{site}\n").as_bytes()).expect("it is written");
    }
    0
}
'''


def offsets(source, span):
    """Byte offsets of a span, whose columns count characters."""
    lines = source.split("\n")
    def at(place):
        line = place["line"] - 1
        before = sum(len(text) + 1 for text in lines[:line])
        return len(source[:before + place["column"] - 1].encode())
    return at(span["start"]), at(span["end"])


def ancestors(node):
    while node:
        yield node
        node = node.parent


def planted(source, mutants):
    """The source with its mutants, each a dictionary of cargo-mutants with a number; and those that are not planted."""
    text = source.encode()
    tree = tree_sitter.Parser(LANGUAGE).parse(text)
    sites = collections.defaultdict(list)
    for mutant in mutants:
        sites[(mutant["genre"] == "FnValue", offsets(source, mutant["span"]))].append(mutant)
    # (offset, order, bytes taken away, bytes put in); outer openings come first, outer closings last.
    edits, left = [], []
    functions = collections.defaultdict(set)

    def put(at, order, what, taken=0):
        edits.append((at, order, taken, what.encode()))

    def part(node):
        return text[node.start_byte:node.end_byte].decode()

    for (is_function, (start, end)), here in sites.items():
        numbers = [mutant["number"] for mutant in here]
        for mutant in here:
            mutant["site"] = mutant["number"] if is_function else numbers[0]
        at = f"crate::mutant::at({numbers[0]})"
        node = tree.root_node.descendant_for_byte_range(start, end)
        constant = any(
            up.type in ("const_item", "static_item") or (up.type == "function_item" and "const fn" in part(up).split("{")[0])
            for up in ancestors(node))
        assigned = any(
            up.parent and up.parent.type == "compound_assignment_expr" and up == up.parent.child_by_field_name("left")
            for up in ancestors(node))
        genre = here[0]["genre"]
        arms = lambda form: " ".join(f"{m['number']} => /*<{m['number']}*/{form(m)}/*{m['number']}>*/," for m in here)
        if not constant and not assigned:
            for up in ancestors(node):
                if up.type == "function_item":
                    functions[up.child_by_field_name("body").byte_range].update(numbers)
        if constant or assigned:
            left += here
        elif is_function:
            for mutant in here:
                if "impl " in (mutant["function"]["return_type"] or ""):
                    left.append(mutant)
                    continue
                n = mutant["number"]
                put(start, (0, 0), f"if crate::mutant::at({n}) == {n} {{ return /*<{n}*/{mutant['replacement']}/*{n}>*/; }} ")
        elif genre == "BinaryOperator":
            whole = node if node.type in ("binary_expression", "compound_assignment_expr") else node.parent
            depth = sum(1 for _ in ancestors(whole))
            opened, closed, middle = (1, depth), (-1, -depth), (0, 0)
            begin, finish = whole.start_byte, whole.end_byte
            operator = text[start:end].decode()
            first, last = whole.child_by_field_name("left"), whole.child_by_field_name("right")
            if whole.type not in ("binary_expression", "compound_assignment_expr") or not last:
                left += here
            elif whole.type == "compound_assignment_expr":
                place = part(first)
                choice = arms(lambda m: f"{place} {m['replacement']} r")
                put(begin, opened, "{ let r = ", last.start_byte - begin)
                put(finish, closed, f"; match {at} {{ {choice} _ => {place} {operator} r }} }}")
            elif operator in ("&&", "||"):
                other = {"&&": "||", "||": "&&"}[operator]
                if any(m["replacement"] != other for m in here):
                    left += here
                    continue
                flip = f"({at} == {numbers[0]})"
                put(begin, opened, f"({flip} ^ (({flip} ^ (")
                put(first.end_byte, middle, f")) {operator} ({flip} ^ (", last.start_byte - first.end_byte)
                put(finish, closed, "))))")
            else:
                by, star = ("&", "*") if operator in COMPARISONS else ("", "")
                choice = arms(lambda m: f"{star}l {m['replacement']} {star}r")
                put(begin, opened, f"({{ let (l, r) = ({by}(")
                put(first.end_byte, middle, f"), {by}(", last.start_byte - first.end_byte)
                put(finish, closed, f")); match {at} {{ {choice} _ => {star}l {operator} {star}r }} }})")
        elif genre == "UnaryOperator":
            whole = node if node.type == "unary_expression" else node.parent
            if whole.type != "unary_expression" or len(here) != 1 or here[0]["replacement"]:
                left += here
                continue
            depth = sum(1 for _ in ancestors(whole))
            operator, choice = text[start:end].decode(), arms(lambda m: "l")
            put(whole.start_byte, (1, depth), "({ let l = ", end - start)
            put(whole.end_byte, (-1, -depth), f"; match {at} {{ {choice} _ => {operator}l }} }})")
        elif genre == "MatchArmGuard":
            # Around whatever mutants the guard itself has.
            depth = sum(1 for _ in ancestors(node)) - 0.5
            choice = " ".join(f"{m['number']} => {m['replacement']}," for m in here)
            put(start, (1, depth), f"(match {at} {{ {choice} _ => ")
            put(end, (-1, -depth), " })")
        elif genre == "MatchArm":
            arm = next((up for up in ancestors(node) if up.type == "match_arm"), None)
            pattern = arm and arm.child_by_field_name("pattern")
            if not arm or arm.start_byte != start or pattern.child_by_field_name("condition"):
                left += here
                continue
            put(pattern.end_byte, (0, 0), f" if {at} != {numbers[0]}")
        else:
            left += here

    for (start, end), numbers in sorted(functions.items()):
        if "impl " in text[:start].decode().rpartition("fn ")[2].rpartition("->")[2]:
            continue
        # Inner functions come later: what a mutant is reached by is its innermost function.
        for mutant in mutants:
            if mutant["number"] in numbers:
                mutant["site"] = min(numbers)
        put(start + 1, (-2, 0), f" if crate::mutant::within({min(numbers)}, {max(numbers)}) {{")
        put(end - 1, (2, 0), f"}} else {{{text[start + 1:end - 1].decode()}}} ")

    result, done = b"", 0
    for at, _, taken, what in sorted(edits, key=lambda edit: edit[:2]):
        result += text[done:at] if at > done else b""
        result += what
        done = max(done, at + taken)
    return (result + text[done:]).decode(), left
