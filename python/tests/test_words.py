"""The pages, the header and the hosts' pages are in the English of engineers: no sentence begins as a rest of the one before, and no word stands in
the place of the field's term."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

# A word that a page may not have, and what engineers write.
INSTEAD = {
    r"over ?rate[sd]?": "overestimate",
    r"under ?rate[sd]?": "underestimate",
    r"is said to be": "who says it",
    r"what .{1,40} is made of": "the parts",
    r"shear strength of (the )?summits": "of asperities",
    r"summits? (that )?(yield|stick|slip|adhere)s?": "asperities",
    r"equivalent modulus": "reduced modulus",
}
BEGINS = re.compile(r"(?:^|[.:?!] )(?:Of|And|So|Nor|But) ", re.MULTILINE)
PAGES = ("README.md", "docs/*.md", "hosts/*/README.md", "include/asperity.h")


def sentences(text: str, is_header: bool) -> str:
    """Prose without programs and tables, each paragraph in a line."""
    if is_header:
        return re.sub(r"\n \* ?", " ", "\n".join(re.findall(r"/\*\*.*?\*/", text, re.DOTALL)))
    text = re.sub(r"^ *```.*?^ *```$|^    [^\n]*$|^\|[^\n]*$|<!--.*?-->", "", text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"(?<!\n)\n(?!\n|- |\* |#)", " ", text)


@pytest.mark.parametrize("pattern", PAGES)
def test_pages_are_in_plain_english(root: Path, pattern: str) -> None:
    found = []
    for page in sorted(root.glob(pattern)):
        prose = sentences(page.read_text(encoding="utf-8"), page.suffix == ".h")
        assert len(prose.split()) > 30, page
        found += [f"{page.name}: {prose[max(0, m.start() - 20) : m.end() + 60]!r}" for m in BEGINS.finditer(prose)]
        for word, term in INSTEAD.items():
            found += [f"{page.name}: {m.group()!r}: write {term}" for m in re.finditer(rf"\b{word}\b", prose, re.IGNORECASE)]
    assert not found, "\n".join(found)


def test_what_is_no_plain_english_is_found() -> None:
    prose = sentences("One thing.\nOf these two\nare right. The model overrates it.\n\n```\nOf a program\n```\n", is_header=False)
    assert BEGINS.search(prose) and re.search(r"\boverrates\b", prose) and "program" not in prose
