"""The pages of users stay few, short and plain, and every link in the repository's pages leads somewhere.

As a script it lists all offenders: python python/tests/test_pages_count.py [CHECKOUT]
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path

PAGES, WORDS, README_LINES = 18, 45_000, 110
# How often a phrase may occur on all user pages together: about a tenth of what it was, and of "where", a fifth.
PHRASES = {
    r"\b(?:that|those) of\b": 13,
    r"\b(?:nobody|no one|none) (?:\w+ )?(?:measured|read|knows?|says?)\b": 1,
    r"\bholds?\b": 9,
    r"\b(?:tells?|told)\b": 4,
    r"\bthe law\b": 7,
    r"\bwhere\b": 28,
    r"\bat (?:the|its) end(?: of this page)?,? (?:you|the|a|every|each)\b": 2,
}
# Of a user page: how a fact was found. tests/setup.sh is a command, which installs packages.
FOUND = re.compile(r"\b(?:was|were) read\b|\btests?/(?!setup\.sh)[\w./-]+\.\w+|\btest_\w+\.py\b|\w+\.test\.\w+", re.IGNORECASE)
FENCE = re.compile(r"^(```+).*?^\1$", re.MULTILINE | re.DOTALL)
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
CODE = re.compile(r"`[^`\n]+`")
LINK = re.compile(r"\]\(([^)\s]+)\)")


def user_pages(root: Path) -> list[Path]:
    return sorted((root / "docs").glob("*.md"))


def blank(found: re.Match[str]) -> str:
    return re.sub(r"\S", " ", found[0])


def shown(page: Path) -> str:
    return COMMENT.sub(blank, page.read_text(encoding="utf-8"))


def prose(page: Path) -> str:
    """Without programs and the targets of links, every line in its place."""
    text = CODE.sub(blank, FENCE.sub(blank, shown(page)))
    return re.sub(r"^ {4,}.*$", "", LINK.sub("]", text), flags=re.MULTILINE)


def occurrences(root: Path, pattern: re.Pattern[str], text_of: Callable[[Path], str] = prose) -> list[str]:
    """Each with page, line and the words around it."""
    found = []
    for page in user_pages(root):
        text = text_of(page)
        for match in pattern.finditer(text):
            around = " ".join(text[max(match.start() - 30, 0) : match.end() + 30].split())
            found.append(f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}: {around}")
    return found


def wordy(root: Path) -> list[str]:
    """Phrases that occur too often: all places of each."""
    # A phrase may go on in the next line.
    patterns = {re.compile(phrase.replace(" ", r"\s+"), re.IGNORECASE): limit for phrase, limit in PHRASES.items()}
    counts = {pattern: occurrences(root, pattern) for pattern in patterns}
    return [
        f"{len(found)} of at most {patterns[pattern]}: {place}"
        for pattern, found in counts.items()
        for place in found
        if len(found) > patterns[pattern]
    ]


def too_long(root: Path) -> list[str]:
    words = {page.name: len(page.read_text(encoding="utf-8").split()) for page in user_pages(root)}
    lines = (root / "README.md").read_text(encoding="utf-8").count("\n")
    return (
        [f"{len(words)} pages of at most {PAGES}"] * (len(words) > PAGES)
        + [f"{sum(words.values())} words of at most {WORDS}: {words}"] * (sum(words.values()) > WORDS)
        + [f"README.md: {lines} lines of at most {README_LINES}"] * (lines > README_LINES)
    )


def how_found(root: Path) -> list[str]:
    return occurrences(root, FOUND, shown)


def places(page: Path) -> set[str]:
    """The anchors of a page, as GitHub makes them of headings."""
    found: dict[str, int] = {}
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    for heading in re.findall(r"^#{1,6} +(.+?)[ #]*$", text, re.MULTILINE):
        slug = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)).lower().replace(" ", "-")
        found[slug] = found.get(slug, -1) + 1
    return {slug if n == 0 else f"{slug}-{n}" for slug, last in found.items() for n in range(last + 1)}


def broken_links(root: Path) -> list[str]:
    pages = [root / "README.md", root / "CONTRIBUTING.md", *(root / "docs").rglob("*.md"), *root.glob("hosts/*/README.md")]
    wrong = []
    for page in sorted(pages):
        # The site's front page is beside the folder guide/ that has the repository's pages.
        front = page == root / "docs" / "site" / "index.md"
        text = CODE.sub(blank, FENCE.sub(blank, page.read_text(encoding="utf-8")))
        for match in LINK.finditer(text):
            path, _, anchor = match[1].partition("#")
            if re.match(r"\w+:", path) or (front and path == "explorer.html"):
                continue
            target = (root / path.removeprefix("guide/") if front else page.parent / path).resolve() if path else page
            where = f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}: {match[1]}"
            if not target.exists():
                wrong.append(f"{where}: no such file")
            elif anchor and target.suffix == ".md" and anchor not in places(target):
                wrong.append(f"{where}: no such heading")
    return wrong


def test_user_pages_are_few_and_short(root: Path) -> None:
    assert not too_long(root), "\n".join(too_long(root))


def test_user_pages_say_it_plainly(root: Path) -> None:
    assert not wordy(root), "\n" + "\n".join(wordy(root))


def test_user_pages_do_not_say_how_a_fact_was_found(root: Path) -> None:
    assert not how_found(root), "\n" + "\n".join(how_found(root))


def test_links_lead_somewhere(root: Path) -> None:
    assert not broken_links(root), "\n" + "\n".join(broken_links(root))


if __name__ == "__main__":
    checkout = Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    lines = [line for check in (too_long, wordy, how_found, broken_links) for line in check(checkout)]
    sys.exit("\n".join(lines) or 0)
