"""The tables of the pages that repeat the header."""

import re

from words import first_sentence, in_words, sentences

# The dimensions of quantities in SI units, as surface files have them.
SI = {"stress": "Pa", "length": "m", "length^2": "m²", "force": "N", "force/length": "N/m"}


def fields(header, struct="asperity_params"):
    """The fields of a struct of C: unit, domain and meaning."""
    yield from ("| Field | Unit | Domain | What it is |", "|---|---|---|---|")
    for one in header.structs[struct].fields[1:]:
        yield f"| `{one.name}` | {one.unit} | {cell(one.domain)} | {cell(meaning(one))} |"


def keys(header):
    """The parameters as keys of a surface file, in SI units and words."""
    yield from ("| Key | Unit | Domain | What it is |", "|---|---|---|---|")
    for one in header.params:
        if one.name != "table_length":
            doc = in_words(meaning(one), header, true="true", false="false")
            yield f"| `{one.name}` | {SI.get(one.unit, one.unit)} | {cell(one.domain)} | {cell(doc)} |"


def functions(header):
    """All functions, under the headings of the header."""
    heading = ""
    for function in header.functions:
        if function.heading != heading:
            heading = function.heading
            yield from (f"**{heading.rstrip('.')}**", "", "| Function | What it does |", "|---|---|")
        yield f"| `{function.name}` | {cell(first_sentence(function.doc))} |"
        if function is last_of(header, heading):
            yield ""


def last_of(header, heading):
    return [one for one in header.functions if one.heading == heading][-1]


def warnings(header):
    yield from ("| `ASPERITY_WARNING_...` | What it says | When it is set |", "|---|---|---|")
    for constant in header.warnings:
        what, *when = sentences(constant.doc.removeprefix("Bit of `warnings`: "))
        yield f"| `{constant.bare.removeprefix('WARNING_')}` | {cell(what)} | {cell(' '.join(when))} |"


def statuses(header):
    yield from ("| Status | | What it means |", "|---|---|---|")
    for constant in header.statuses:
        yield f"| `{constant.name}` | {constant.value} | {cell(constant.doc)} |"


def meaning(one):
    """A comment without its unit and domain, which have columns of their own."""
    doc = re.sub(r" ?\[[^\]]+\]", "", one.doc, count=1)
    return doc.replace(f", {one.domain}", "", 1) if one.domain else doc


def cell(text):
    return re.sub(r"(?<!\\)([|*])", r"\\\1", text)
