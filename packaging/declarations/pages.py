"""The tables of the pages that repeat the header."""

import re

from words import first_sentence, in_words, sentences

# The dimensions of quantities in SI units, as surface files have them.
SI = {"stress": "Pa", "length": "m", "length^2": "m²", "force": "N", "force/length": "N/m"}


def keys(header):
    """The parameters as keys of a surface file, in SI units and words."""
    yield from ("| Key | Unit | Domain | What it is |", "|---|---|---|---|")
    for one in header.params:
        if one.name != "table_length":
            doc = in_words(meaning(one), header, true="true", false="false")
            yield f"| `{one.name}` | {SI.get(one.unit, one.unit)} | {cell(one.domain)} | {cell(doc)} |"


def warnings(header):
    yield from ("| `ASPERITY_WARNING_...` | What it says | Set if |", "|---|---|---|")
    for constant in header.warnings:
        what, *more = sentences(constant.doc.removeprefix("Bit of `warnings`: "))
        when = next((re.sub("^Set (if|while) ", "", one).removesuffix(".") for one in more if one.startswith("Set")), "")
        yield f"| `{constant.bare.removeprefix('WARNING_')}` | {cell(what.removesuffix('.'))} | {cell(when)} |"


def meaning(one):
    """The first sentence of a comment, without unit and domain, which have columns of their own."""
    doc = re.sub(r" ?\[[^\]]+\]", "", first_sentence(one.doc), count=1).removesuffix(".")
    return doc.replace(f", {one.domain}", "", 1) if one.domain else doc


def cell(text):
    return re.sub(r"(?<!\\)([|*])", r"\\\1", text)
